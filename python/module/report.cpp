// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/report.h>

#include <module/parts.h>

#include <annulus/measure/t1_transitions.h>

#include <algorithm>

namespace annulus::python {

namespace {

/// A count: its name, an attribute, a key of as_dict, and pickled.
template <class Counts>
struct Field {
    const char* name;
    const char* doc;
    std::uint64_t& (*of)(Counts&);
};

/// In the order of types.h.
constexpr Field<Move_counts> counts[] = {
    {"asked", "int: vertices that the call was to move; the next five add up to it.",
     [](Move_counts& c) -> std::uint64_t& { return c.asked; }},
    {"within_tolerance", "int: vertices proved by their tolerance alone, or at rest: nothing was evaluated.",
     [](Move_counts& c) -> std::uint64_t& { return c.within_tolerance; }},
    {"kept_in_place", "int: vertices whose certificates were evaluated and hold.",
     [](Move_counts& c) -> std::uint64_t& { return c.kept_in_place; }},
    {"flipped", "int: vertices with a violated certificate that flips repaired.",
     [](Move_counts& c) -> std::uint64_t& { return c.flipped; }},
    {"reinserted", "int: vertices that were removed and inserted again.",
     [](Move_counts& c) -> std::uint64_t& { return c.reinserted; }},
    {"rebuilt", "int: vertices of a triangulation that was rebuilt.",
     [](Move_counts& c) -> std::uint64_t& { return c.rebuilt; }},
};

constexpr Field<Move_statistics> statistics[] = {
    {"filter", "int: certificates decided by the filter, in doubles with a proved error bound.",
     [](Move_statistics& s) -> std::uint64_t& { return s.arithmetic.filter; }},
    {"interval", "int: certificates decided in interval arithmetic.",
     [](Move_statistics& s) -> std::uint64_t& { return s.arithmetic.interval; }},
    {"exact", "int: certificates decided in integers.",
     [](Move_statistics& s) -> std::uint64_t& { return s.arithmetic.exact; }},
    {"evaluated", "int: certificates evaluated.", [](Move_statistics& s) -> std::uint64_t& { return s.evaluated; }},
    {"star_walks", "int: vertices all of whose certificates had to be checked.",
     [](Move_statistics& s) -> std::uint64_t& { return s.star_walks; }},
    {"requeued", "int: vertices queued because another vertex lowered their tolerance (paper).",
     [](Move_statistics& s) -> std::uint64_t& { return s.requeued; }},
    {"flips", "int: flips that were kept.", [](Move_statistics& s) -> std::uint64_t& { return s.flips; }},
    {"undone_flips", "int: flips undone because they led nowhere.",
     [](Move_statistics& s) -> std::uint64_t& { return s.undone_flips; }},
    {"tolerance_steps", "int: time steps that began with the tolerances.",
     [](Move_statistics& s) -> std::uint64_t& { return s.tolerance_steps; }},
    {"sign_steps", "int: time steps that began with the signs of all certificates.",
     [](Move_statistics& s) -> std::uint64_t& { return s.sign_steps; }},
    {"rebuild_steps", "int: time steps that were rebuilt at once (auto).",
     [](Move_statistics& s) -> std::uint64_t& { return s.rebuild_steps; }},
    {"tolerance_recomputations", "int: times that all tolerances were computed.",
     [](Move_statistics& s) -> std::uint64_t& { return s.tolerance_recomputations; }},
};

template <class Counts>
std::uint64_t value(const Field<Counts>& field, const Counts& from) {
    return field.of(const_cast<Counts&>(from));
}

template <class Counts, std::size_t n>
py::dict dict_of(const Field<Counts> (&fields)[n], const Counts& from) {
    py::dict out;
    for (const auto& f : fields) out[f.name] = value(f, from);
    return out;
}

template <class Counts, std::size_t n>
void read(const Field<Counts> (&fields)[n], const py::dict& numbers, Counts& to) {
    for (const auto& f : fields) f.of(to) = numbers[f.name].template cast<std::uint64_t>();
}

/// Those that are not 0.
template <class Counts, std::size_t n>
py::str repr_of(const std::string& name, const Field<Counts> (&fields)[n], const Counts& from) {
    std::string text = "<" + name + ":";
    const char* comma = " ";
    for (const auto& f : fields)
        if (const std::uint64_t k = value(f, from); k > 0) {
            text += comma + std::string(f.name) + " " + std::to_string(k);
            comma = ", ";
        }
    return text + ">";
}

template <class Class, class Counts, std::size_t n, class Of>
void add_fields(Class& c, const Field<Counts> (&fields)[n], Of of) {
    for (const auto& f : fields)
        c.def_property_readonly(
            f.name, [&f, of](const typename Class::type& r) { return value(f, of(r)); }, f.doc);
}

py::dict statistics_dict(const Move_statistics& s) {
    py::dict out = dict_of(statistics, s);
    out["cost"] = s.cost;
    return out;
}

Move_statistics statistics_of(const py::dict& numbers) {
    Move_statistics s;
    read(statistics, numbers, s);
    s.cost = numbers["cost"].cast<double>();
    return s;
}

/// A function written in Python, because pickle finds functions by name.
py::object unpickler(const char* name) { return py::module_::import("annulus._queries").attr(name); }

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
        throw Error(Error_code::bad_input, "this is not the state of a result");
    return {cells.data(), cells.data() + cells.size()};
}

}  // namespace

Report::Report(Move_result report, int d, bool lists_changes) : d_(d), lists_changes_(lists_changes) {
    others_came_ = keep_simplices(report.changed, d);
    others_gone_ = keep_simplices(report.gone, d);
    report_ = std::make_shared<const Move_result>(std::move(report));
}

py::object Report::simplices(const std::vector<Index>& vertices) const {
    if (!lists_changes_) return py::none();
    const auto m = static_cast<py::ssize_t>(vertices.size()) / (d_ + 1);
    return view<Index>(vertices.data(), {m, d_ + 1}, report_);
}

void Report::require_lists() const {
    if (!lists_changes_)
        throw Error(
            Error_code::usage,
            "simplices and edges that changed are listed with report_changes=True only, with a periodic box by the "
            "object and not by the result");
}

py::object Report::listed(const std::vector<Index>& vertices) const {
    require_lists();
    return simplices(vertices);
}

Edge_changes Report::edges() const {
    require_lists();
    std::vector<Index> came = report_->changed;
    std::vector<Index> gone = report_->gone;
    came.insert(came.end(), others_came_.begin(), others_came_.end());
    gone.insert(gone.end(), others_gone_.begin(), others_gone_.end());
    return d_ == 2 ? edge_changes<2>(came, gone) : edge_changes<3>(came, gone);
}

py::dict Report::as_dict() const { return dict_of(counts, report_->moves); }

py::object Report::edges_made() const { return give_pairs(edges().made); }
py::object Report::edges_broken() const { return give_pairs(edges().broken); }
py::object Report::t1() const {
    require_lists();
    return give_rows(t1_transitions(report_->changed, report_->gone));
}

py::str Report::repr() const { return repr_of("MoveResult", counts, report_->moves); }

py::tuple Report::state() const {
    const auto rows = [this](const std::vector<Index>& cells) {
        return give(cells, {static_cast<py::ssize_t>(cells.size()) / (d_ + 1), d_ + 1});
    };
    return py::make_tuple(as_dict(), statistics_dict(report_->statistics), d_, simplices(report_->changed),
                          simplices(report_->gone), rows(others_came_), rows(others_gone_));
}

Report Report::of_state(const py::object& object) {
    if (!py::isinstance<py::tuple>(object))
        throw Error(Error_code::bad_input, "state must be that of a pickled result");
    const auto state = py::reinterpret_borrow<py::tuple>(object);
    if (state.size() != 7) throw Error(Error_code::bad_input, "state must be that of a pickled result");
    Move_result r;
    read(counts, state[0].cast<py::dict>(), r.moves);
    r.statistics = statistics_of(state[1].cast<py::dict>());
    const int d = state[2].cast<int>();
    if (d != 2 && d != 3) throw Error(Error_code::bad_input, "this is not the state of a result");
    const bool lists_changes = !state[3].is_none();
    if (lists_changes) {
        r.changed = simplices_of_state(state[3], d);
        r.gone = simplices_of_state(state[4], d);
    }
    Report out(std::move(r), d, lists_changes);
    out.others_came_ = simplices_of_state(state[5], d);
    out.others_gone_ = simplices_of_state(state[6], d);
    return out;
}

void add_report(py::module_& m) {
    py::class_<Move_statistics> costs(m, "MoveStatistics", not_by_new(),
                                      R"(What a call cost: `MoveResult.statistics`.

Not a stable interface: attributes may go, come, and count otherwise in the next version. `repr` shows the counts that
are not 0, `as_dict` has all.)");
    add_fields(costs, statistics, [](const Move_statistics& s) -> const Move_statistics& { return s; });
    costs
        .def_property_readonly(
            "cost", [](const Move_statistics& s) { return s.cost; },
            "float: cost of the call, in simplices tested, from measured costs of the operations.")
        .def("as_dict", &statistics_dict, "dict: all counts by name.")
        .def("__repr__", [](const Move_statistics& s) { return repr_of("MoveStatistics", statistics, s); })
        .def("__reduce__", [](const Move_statistics& s) {
            return py::make_tuple(unpickler("statistics_of"), py::make_tuple(statistics_dict(s)));
        });
    m.def("statistics_of", &statistics_of);

    py::class_<Report> result(m, "MoveResult", not_by_new(),
                              R"(What a call of `MovingDelaunay.move` or `recompute_tolerances` changed.

What became of the vertices, as counts, and the simplices that were created and removed. What the call cost is in
`statistics`. `repr` shows the counts that are not 0, `as_dict` has all.)");
    add_fields(result, counts, [](const Report& r) -> const Move_counts& { return r.numbers().moves; });
    result
        .def_property_readonly(
            "statistics", [](const Report& r) { return r.numbers().statistics; },
            "MoveStatistics: what the call cost, in certificates, flips and steps. Not a stable interface.")
        .def_property_readonly(
            "changed_simplices", &Report::changed_simplices,
            R"(ndarray of int32, shape (m, d + 1): simplices that did not exist before the call, as rows of vertex )"
            R"(indices, positively oriented; read-only.

Raises an `Error` with the code ``usage`` unless the triangulation has ``report_changes=True``. Points that do not span
d dimensions have no simplices.)")
        .def_property_readonly(
            "removed_simplices", &Report::removed_simplices,
            "ndarray of int32, shape (m, d + 1): simplices that no longer exist, in the same form. No simplex is also "
            "in "
            "`changed_simplices`, except one that was turned over: its vertices are in both, in another order.")
        .def_property_readonly("edges_made", &Report::edges_made,
                               R"(ndarray of int32, shape (m, 2): pairs of vertices that became neighbours, ascending.

In 2D, a flip breaks one pair and makes one, a T1 transition (`annulus.t1`). Computed on access, O(k log k) for k )"
                               R"(simplices that changed. Raises an `Error` as `changed_simplices` does.)")
        .def_property_readonly("edges_broken", &Report::edges_broken,
                               "ndarray of int32, shape (m, 2): pairs of vertices that are neighbours no longer.")
        .def("as_dict", &Report::as_dict, "dict: all counts by name, without those of `statistics`.")
        .def("__repr__", &Report::repr)
        .def("__reduce__",
             [](const Report& r) { return py::make_tuple(unpickler("result_of"), py::make_tuple(r.state())); });
    m.def("result_of", &Report::of_state);
    m.def("t1", &Report::t1);
}

}  // namespace annulus::python
