// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/report.h>

#include <module/parts.h>

#include <algorithm>

namespace annulus::python {

namespace {

struct Field {
    const char* name;
    const char* doc;
    std::uint64_t& (*of)(Move_report&);
};

/// In the order of move_report.h. Every name here is an attribute, a key of as_dict, and pickled.
constexpr Field fields[] = {
    {"asked", "int: vertices that the call was to move; the next five add up to it.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.asked; }},
    {"within_tolerance", "int: vertices proved by their tolerance alone, or at rest: nothing was evaluated.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.within_tolerance; }},
    {"kept_in_place", "int: vertices whose certificates were evaluated and hold.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.kept_in_place; }},
    {"flipped", "int: vertices with a violated certificate that flips repaired.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.flipped; }},
    {"reinserted", "int: vertices that were removed and inserted again.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.reinserted; }},
    {"rebuilt", "int: vertices of a triangulation that was rebuilt.",
     [](Move_report& r) -> std::uint64_t& { return r.moves.rebuilt; }},
    {"filter", "int: certificates decided by the filter, in doubles with a proved error bound.",
     [](Move_report& r) -> std::uint64_t& { return r.arithmetic.filter; }},
    {"interval", "int: certificates decided in interval arithmetic.",
     [](Move_report& r) -> std::uint64_t& { return r.arithmetic.interval; }},
    {"exact", "int: certificates decided in integers.",
     [](Move_report& r) -> std::uint64_t& { return r.arithmetic.exact; }},
    {"evaluated", "int: certificates evaluated.", [](Move_report& r) -> std::uint64_t& { return r.evaluated; }},
    {"star_walks", "int: vertices all of whose certificates had to be checked.",
     [](Move_report& r) -> std::uint64_t& { return r.star_walks; }},
    {"requeued", "int: vertices queued because another vertex lowered their tolerance (paper).",
     [](Move_report& r) -> std::uint64_t& { return r.requeued; }},
    {"flips", "int: flips that were kept.", [](Move_report& r) -> std::uint64_t& { return r.flips; }},
    {"undone_flips", "int: flips undone because they led nowhere.",
     [](Move_report& r) -> std::uint64_t& { return r.undone_flips; }},
    {"tolerance_steps", "int: time steps that began with the tolerances.",
     [](Move_report& r) -> std::uint64_t& { return r.tolerance_steps; }},
    {"sign_steps", "int: time steps that began with the signs of all certificates.",
     [](Move_report& r) -> std::uint64_t& { return r.sign_steps; }},
    {"rebuild_steps", "int: time steps that were rebuilt at once (auto).",
     [](Move_report& r) -> std::uint64_t& { return r.rebuild_steps; }},
    {"tolerance_recomputations", "int: times that all tolerances were computed.",
     [](Move_report& r) -> std::uint64_t& { return r.tolerance_recomputations; }},
};

std::uint64_t value(const Field& field, const Move_report& report) {
    return field.of(const_cast<Move_report&>(report));
}

/// Keeps the simplices only, and returns the others: infinite cells and the cells of flat sets.
std::vector<Index> keep_simplices(std::vector<Index>& cells, int d) {
    std::vector<Index> others;
    const auto width = static_cast<std::ptrdiff_t>(d + 1);
    auto kept = cells.begin();
    for (auto cell = cells.begin(); cell != cells.end(); cell += width)
        if (std::all_of(cell, cell + width, [](Index v) { return v >= 0; })) {
            if (kept != cell) std::copy(cell, cell + width, kept);
            kept += width;
        } else others.insert(others.end(), cell, cell + width);
    cells.erase(kept, cells.end());
    return others;
}

py::object give_pairs(const Vertex_pairs& pairs) {
    std::vector<std::array<Index, 2>> rows;
    rows.reserve(pairs.size());
    for (const auto& [a, b] : pairs) rows.push_back({a, b});
    return give_rows(std::move(rows));
}

std::vector<Index> simplices_of_state(const py::handle& state, int d) {
    const py::array_t<Index, c_array> cells(py::reinterpret_borrow<py::object>(state));
    if (cells.ndim() != 2 || cells.shape(1) != d + 1)
        throw Error(Error_code::bad_input, "this is not the state of a report");
    return {cells.data(), cells.data() + cells.size()};
}

}  // namespace

Report::Report(Move_report report, int d, bool lists_changes) : d_(d), lists_changes_(lists_changes) {
    others_came_ = keep_simplices(report.changed, d);
    others_gone_ = keep_simplices(report.gone, d);
    report_ = std::make_shared<const Move_report>(std::move(report));
}

py::object Report::simplices(const std::vector<Index>& vertices) const {
    if (!lists_changes_) return py::none();
    const auto m = static_cast<py::ssize_t>(vertices.size()) / (d_ + 1);
    return view<Index>(vertices.data(), {m, d_ + 1}, report_);
}

Edge_changes Report::edges() const {
    std::vector<Index> came = report_->changed;
    std::vector<Index> gone = report_->gone;
    came.insert(came.end(), others_came_.begin(), others_came_.end());
    gone.insert(gone.end(), others_gone_.begin(), others_gone_.end());
    return d_ == 2 ? edge_changes<2>(came, gone) : edge_changes<3>(came, gone);
}

py::object Report::edges_made() const { return lists_changes_ ? give_pairs(edges().made) : py::none(); }
py::object Report::edges_broken() const { return lists_changes_ ? give_pairs(edges().broken) : py::none(); }

py::dict Report::as_dict() const {
    py::dict out;
    for (const Field& f : fields) out[f.name] = value(f, *report_);
    out["cost"] = report_->cost;
    return out;
}

py::str Report::repr() const {
    std::string text = "<MoveReport:";
    const char* comma = " ";
    for (const Field& f : fields)
        if (const std::uint64_t n = value(f, *report_); n > 0) {
            text += comma + std::string(f.name) + " " + std::to_string(n);
            comma = ", ";
        }
    return text + ">";
}

py::tuple Report::state() const {
    const auto rows = [this](const std::vector<Index>& cells) {
        return give(cells, {static_cast<py::ssize_t>(cells.size()) / (d_ + 1), d_ + 1});
    };
    return py::make_tuple(as_dict(), d_, changed_simplices(), removed_simplices(), rows(others_came_),
                          rows(others_gone_));
}

Report Report::of_state(const py::object& object) {
    if (!py::isinstance<py::tuple>(object))
        throw Error(Error_code::bad_input, "state must be that of a pickled report");
    const auto state = py::reinterpret_borrow<py::tuple>(object);
    if (state.size() != 6) throw Error(Error_code::bad_input, "state must be that of a pickled report");
    Move_report r;
    const auto numbers = state[0].cast<py::dict>();
    for (const Field& f : fields) f.of(r) = numbers[f.name].cast<std::uint64_t>();
    r.cost = numbers["cost"].cast<double>();
    const int d = state[1].cast<int>();
    if (d != 2 && d != 3) throw Error(Error_code::bad_input, "this is not the state of a report");
    const bool lists_changes = !state[2].is_none();
    if (lists_changes) {
        r.changed = simplices_of_state(state[2], d);
        r.gone = simplices_of_state(state[3], d);
    }
    Report out(std::move(r), d, lists_changes);
    out.others_came_ = simplices_of_state(state[4], d);
    out.others_gone_ = simplices_of_state(state[5], d);
    return out;
}

void add_report(py::module_& m) {
    py::class_<Report> report(m, "MoveReport", not_by_new(),
                              R"(What a call of `MovingDelaunay.move` or `recompute_tolerances` did.

Counts, and the simplices that were created and removed. `repr` shows the counts that are not 0, `as_dict` has all.)");
    for (const Field& f : fields)
        report.def_property_readonly(
            f.name, [&f](const Report& r) { return value(f, r.numbers()); }, f.doc);
    report
        .def_property_readonly(
            "cost", [](const Report& r) { return r.numbers().cost; },
            "float: cost of the call, in simplices tested, from measured costs of the operations.")
        .def_property_readonly(
            "changed_simplices", &Report::changed_simplices,
            R"(ndarray of int32, shape (m, d + 1): simplices that did not exist before the call, as rows of vertex )"
            R"(indices, positively oriented; read-only.

None with ``report_changes=False``. Points that do not span d dimensions have no simplices.)")
        .def_property_readonly(
            "removed_simplices", &Report::removed_simplices,
            "ndarray of int32, shape (m, d + 1): simplices that no longer exist, in the same form. None is also in "
            "`changed_simplices`, except one that was turned over: its vertices are in both, in another order.")
        .def_property_readonly("edges_made", &Report::edges_made,
                               R"(ndarray of int32, shape (m, 2): pairs of vertices that became neighbours, ascending.

In 2D, a flip breaks one pair and makes one, a T1 transition (`annulus.t1`). Computed on access, O(k log k) for k )"
                               R"(simplices that changed. None with ``report_changes=False``.)")
        .def_property_readonly("edges_broken", &Report::edges_broken,
                               "ndarray of int32, shape (m, 2): pairs of vertices that are neighbours no longer.")
        .def("as_dict", &Report::as_dict, "dict: all counts by name.")
        .def("__repr__", &Report::repr)
        .def("__reduce__", [](const Report& r) {
            // A function written in Python, because pickle finds functions by name.
            return py::make_tuple(py::module_::import("annulus._queries").attr("report_of"), py::make_tuple(r.state()));
        });
    m.def("report_of", &Report::of_state);
}

}  // namespace annulus::python
