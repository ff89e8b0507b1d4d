// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/report.h>

#include <module/parts.h>

#include <algorithm>

namespace annulus::python {

namespace {

struct Field {
    const char* name;
    std::uint64_t& (*of)(Move_report&);
};

/// In the order of engine/move_report.h. What has a name here is an attribute, a key, and pickled.
constexpr Field fields[] = {
    {"asked", [](Move_report& r) -> std::uint64_t& { return r.moves.asked; }},
    {"within_tolerance", [](Move_report& r) -> std::uint64_t& { return r.moves.within_tolerance; }},
    {"kept_in_place", [](Move_report& r) -> std::uint64_t& { return r.moves.kept_in_place; }},
    {"flipped", [](Move_report& r) -> std::uint64_t& { return r.moves.flipped; }},
    {"reinserted", [](Move_report& r) -> std::uint64_t& { return r.moves.reinserted; }},
    {"rebuilt", [](Move_report& r) -> std::uint64_t& { return r.moves.rebuilt; }},
    {"filter", [](Move_report& r) -> std::uint64_t& { return r.arithmetic.filter; }},
    {"interval", [](Move_report& r) -> std::uint64_t& { return r.arithmetic.interval; }},
    {"exact", [](Move_report& r) -> std::uint64_t& { return r.arithmetic.exact; }},
    {"evaluated", [](Move_report& r) -> std::uint64_t& { return r.evaluated; }},
    {"renewed", [](Move_report& r) -> std::uint64_t& { return r.renewed; }},
    {"tours", [](Move_report& r) -> std::uint64_t& { return r.tours; }},
    {"requeued", [](Move_report& r) -> std::uint64_t& { return r.requeued; }},
    {"flips", [](Move_report& r) -> std::uint64_t& { return r.flips; }},
    {"undone_flips", [](Move_report& r) -> std::uint64_t& { return r.undone_flips; }},
    {"tolerance_steps", [](Move_report& r) -> std::uint64_t& { return r.tolerance_steps; }},
    {"sign_steps", [](Move_report& r) -> std::uint64_t& { return r.sign_steps; }},
    {"rebuild_steps", [](Move_report& r) -> std::uint64_t& { return r.rebuild_steps; }},
    {"settlings", [](Move_report& r) -> std::uint64_t& { return r.settlings; }},
};

std::uint64_t value(const Field& field, const Move_report& report) { return field.of(const_cast<Move_report&>(report)); }

}  // namespace

Report::Report(Move_report report, int d, bool lists_changes) : d_(d), lists_changes_(lists_changes) {
    // Cells at infinity, and those of flat sets, are no simplices.
    const auto width = static_cast<std::ptrdiff_t>(d + 1);
    auto kept = report.changed.begin();
    for (auto cell = report.changed.begin(); cell != report.changed.end(); cell += width)
        if (std::all_of(cell, cell + width, [](Index v) { return v >= 0; })) kept = std::copy(cell, cell + width, kept);
    report.changed.erase(kept, report.changed.end());
    report_ = std::make_shared<const Move_report>(std::move(report));
}

py::object Report::changed_simplices() const {
    if (!lists_changes_) return py::none();
    const auto m = static_cast<py::ssize_t>(report_->changed.size()) / (d_ + 1);
    return view<Index>(report_->changed.data(), {m, d_ + 1}, report_);
}

py::dict Report::as_dict() const {
    py::dict out;
    for (const Field& f : fields) out[f.name] = value(f, *report_);
    out["price"] = report_->price;
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

py::tuple Report::state() const { return py::make_tuple(as_dict(), d_, changed_simplices()); }

Report Report::of_state(const py::tuple& state) {
    Move_report r;
    const auto numbers = state[0].cast<py::dict>();
    for (const Field& f : fields) f.of(r) = numbers[f.name].cast<std::uint64_t>();
    r.price = numbers["price"].cast<double>();
    const int d = state[1].cast<int>();
    if (d != 2 && d != 3) throw Error(Error_code::bad_input, "this is not the state of a report");
    const bool lists_changes = !state[2].is_none();
    if (lists_changes) {
        const py::array_t<Index, c_array> changed(state[2].cast<py::object>());
        if (changed.ndim() != 2 || changed.shape(1) != d + 1) throw Error(Error_code::bad_input, "this is not the state of a report");
        r.changed.assign(changed.data(), changed.data() + changed.size());
    }
    return {std::move(r), d, lists_changes};
}

void add_report(py::module_& m) {
    py::class_<Report> report(m, "MoveReport");
    for (const Field& f : fields)
        report.def_property_readonly(f.name, [&f](const Report& r) { return value(f, r.numbers()); });
    report.def_property_readonly("price", [](const Report& r) { return r.numbers().price; })
        .def_property_readonly("changed_simplices", &Report::changed_simplices)
        .def("as_dict", &Report::as_dict)
        .def("__repr__", &Report::repr)
        .def(py::pickle([](const Report& r) { return r.state(); }, &Report::of_state));
}

}  // namespace annulus::python
