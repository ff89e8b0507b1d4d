// SPDX-License-Identifier: GPL-3.0-or-later
#include "operation.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace annulus::oracle {

namespace {

std::string identifier(std::string_view name) {
    std::string s(name);
    std::replace(s.begin(), s.end(), '-', '_');
    return s;
}

constexpr std::array<std::string_view, refusals> refusal_names{
    "move_to_nan",     "move_to_infinity",       "move_out_of_domain", "insert_nan",        "insert_out_of_domain",
    "move_all_to_nan", "move_all_out_of_domain", "one_point_too_many", "one_point_too_few", "move_meets",
    "insert_meets",    "move_all_meets",         "move_free",          "remove_free",       "move_beyond"};

template <int d>
std::string operation_as_code(const Operation_of<d>& o) {
    const auto call = [](std::string_view name, const std::string& arguments) {
        return "Calls<" + std::to_string(d) + ">::" + std::string(name) + "(" + arguments + ")";
    };
    const auto point = [&o] { return points_as_code(o.points); };
    const std::string vertex = std::to_string(o.vertex);
    switch (o.kind) {
        case Operation_kind::move: return call(o.fits ? "move_some" : "move", vertex + ", " + point());
        case Operation_kind::move_all: return call(o.fits ? "move_most" : "move_all", "{" + point() + "}");
        case Operation_kind::insert: return call(o.fits ? "insert_near" : "insert", point());
        case Operation_kind::remove: return call(o.fits ? "remove_some" : "remove", vertex);
        case Operation_kind::recompute_tolerances: return call("recompute_tolerances", "");
        case Operation_kind::stay: return call("stay", "");
        case Operation_kind::steady:
            return call("steady", "Motion::" + identifier(name_of(o.motion)) + ", " + std::to_string(o.times) + ", " +
                                      number_as_code(o.pace) + ", " + std::to_string(o.seed) + "U");
        case Operation_kind::refused: break;
    }
    return call("refused", "Refusal::" + std::string(refusal_names[o.seed % refusals]) + ", " + vertex);
}

}  // namespace

std::string name_of(const Setting& s) {
    std::string name(annulus::name_of(s.strategy));
    if (s.tolerance != Tolerance_kind::certified) name += "-" + std::string(annulus::name_of(s.tolerance));
    return name;
}

std::string_view name_of(Motion m) {
    constexpr std::array<std::string_view, all_motions.size()> names{
        "drift",      "own_ways", "orbits", "shear",    "rotation",       "breathing",   "jitter",
        "tolerances", "ulps",     "few",    "exchange", "there_and_back", "rest_and_go", "bursts"};
    return names[static_cast<std::size_t>(m)];
}

std::string number_as_code(double x) {
    if (std::isnan(x)) return "NAN";
    if (std::isinf(x)) return x > 0 ? "INFINITY" : "-INFINITY";
    std::array<char, 40> text{};
    if (x == std::nearbyint(x) && std::fabs(x) < 1e6) {
        std::snprintf(text.data(), text.size(), std::signbit(x) && x == 0.0 ? "-0.0" : "%.0f", x);
    } else {
        std::snprintf(text.data(), text.size(), "%a", x);
    }
    return text.data();
}

template <int d>
std::string as_code(const Program_of<d>& program) {
    std::ostringstream out;
    out << (d == 2 ? "const Program" : "const Program_3")
        << " program{{Strategy::" << identifier(annulus::name_of(program.setting.strategy))
        << ", Tolerance_kind::" << annulus::name_of(program.setting.tolerance) << "},\n    {"
        << points_as_code(program.points) << "},\n    {";
    for (std::size_t i = 0; i < program.operations.size(); ++i)
        out << (i > 0 ? ",\n     " : "") << operation_as_code(program.operations[i]);
    out << "}};\n";
    return out.str();
}
template std::string as_code(const Program_of<2>& program);
template std::string as_code(const Program_of<3>& program);

Coverage& Coverage::operator+=(const Coverage& o) {
    operations += o.operations;
    legal_operations += o.legal_operations;
    calls += o.calls;
    for (std::size_t i = 0; i < refused.size(); ++i) refused[i] += o.refused[i];
    report += o.report;
    switches += o.switches;
    return *this;
}

double Coverage::legal_share() const {
    return operations > 0 ? static_cast<double>(legal_operations) / static_cast<double>(operations) : 1.0;
}

std::string Coverage::words(std::string_view prefix) const {
    std::ostringstream out;
    const auto line = [&](std::string_view name, auto value) { out << prefix << name << ": " << value << "\n"; };
    line("operations", operations);
    line("legal_percent", std::lround(100.0 * legal_share()));
    line("calls", calls);
    line("duplicate_points_refused", duplicate_points());
    line("within_tolerance", report.moves.within_tolerance);
    line("kept_in_place", report.moves.kept_in_place);
    line("flipped", report.moves.flipped);
    line("reinserted", report.moves.reinserted);
    line("rebuilt", report.moves.rebuilt);
    line("flips", report.statistics.flips);
    line("undone_flips", report.statistics.undone_flips);
    line("star_walks", report.statistics.star_walks);
    line("requeued", report.statistics.requeued);
    line("decided_by_filter", report.statistics.arithmetic.filter);
    line("decided_by_interval", report.statistics.arithmetic.interval);
    line("decided_by_exact", report.statistics.arithmetic.exact);
    line("switches_of_paper_hybrid", switches);
    return out.str();
}

}  // namespace annulus::oracle
