// SPDX-License-Identifier: GPL-3.0-or-later
// Five points of space at which the paper's tolerance is too large (docs/theory.md 3).
#include <annulus/arithmetic/error.h>
#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/result_files.h>
#include <annulus/formats/write_json.h>
#include <annulus/engine/displacement.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace annulus::cli {

namespace {

using Point = Coordinates<3>;
/// a and b on the axis, p, q, r around them.
struct Five_points {
    Point a, b, p, q, r;
};

/// a, b = (0, 0, +-height), and p, q, r at 120 degrees on a circle of z = 0.
Five_points five_points(double height, double radius) {
    const double x = -0.5 * radius;
    const double y = 0.5 * std::sqrt(3.0) * radius;
    return {{0, 0, height}, {0, 0, -height}, {radius, 0, 0}, {x, y, 0}, {x, -y, 0}};
}

/// The three facets at a b with their opposite vertices, and the three cells around a b: the triangulation before the move.
std::array<Tuple<3, 5>, 3> facets_at_ab(const Five_points& x) {
    return {{{&x.a, &x.b, &x.p, &x.q, &x.r}, {&x.a, &x.b, &x.q, &x.r, &x.p}, {&x.a, &x.b, &x.r, &x.p, &x.q}}};
}
std::array<Tuple<3, 4>, 3> cells_at_ab(const Five_points& x) {
    return {{{&x.a, &x.b, &x.q, &x.p}, {&x.a, &x.b, &x.r, &x.q}, {&x.a, &x.b, &x.p, &x.r}}};
}
/// The facet p q r between a and b: the other triangulation, of two cells.
Tuple<3, 5> facet_pqr(const Five_points& x) { return {&x.p, &x.q, &x.r, &x.b, &x.a}; }

/// The hull of the five points is the same in both, and convex by far.
bool three_cells_are_delaunay(const Five_points& x) {
    const auto holds = [](const auto& facet) { return empty_sphere_exact(facet).sign >= 0; };
    const auto positive = [](const auto& cell) { return orientation_exact(cell).sign > 0; };
    const auto facets = facets_at_ab(x);
    const auto cells = cells_at_ab(x);
    return std::all_of(facets.begin(), facets.end(), holds) && std::all_of(cells.begin(), cells.end(), positive);
}
bool two_cells_are_delaunay(const Five_points& x) {
    return empty_sphere_exact(facet_pqr(x)).sign >= 0 && orientation_exact({&x.p, &x.q, &x.r, &x.a}).sign > 0 &&
           orientation_exact({&x.q, &x.p, &x.r, &x.b}).sign > 0;
}

struct Result {
    double delta;
    double move;       ///< 0.7 delta, as asked for
    double displaced;  ///< an upper bound of the largest displacement, rounding of the moved points included
    double paper;      ///< least half width of the standard annuli, plain double
    double theta;      ///< least theta of the facets
    Verdict certified;
    double exact;
    bool three_before, three_after, two_after;
};

Result study(double delta) {
    Result r{};
    r.delta = delta;
    r.move = 0.7 * delta;
    const Five_points fixed = five_points(1.0 - delta, 1.0);
    const Five_points moved = five_points(1.0 - delta + r.move, 1.0 - r.move);
    const auto displacement = [&](const Point Five_points::*v) { return distance_upper<3>(fixed.*v, moved.*v); };
    r.displaced = std::max({displacement(&Five_points::a), displacement(&Five_points::b), displacement(&Five_points::p),
                            displacement(&Five_points::q), displacement(&Five_points::r)});
    r.paper = HUGE_VAL;
    r.exact = HUGE_VAL;
    r.theta = HUGE_VAL;
    r.certified.tolerance = HUGE_VAL;
    for (const auto& facet : facets_at_ab(fixed)) {
        r.paper = std::min(r.paper, paper_annulus(facet));
        r.theta = std::min(r.theta, theta(*facet[0], *facet[1], *facet[2], *facet[3], *facet[4]));
        r.exact = std::min(r.exact, empty_sphere_exact(facet, Cell_widths::always).tolerance);
        const Verdict v = empty_sphere_verdict(facet, true, Cell_widths::always);
        if (v.tolerance < r.certified.tolerance) r.certified = v;
    }
    r.three_before = three_cells_are_delaunay(fixed);
    r.three_after = three_cells_are_delaunay(moved);
    r.two_after = two_cells_are_delaunay(moved);
    return r;
}

nlohmann::ordered_json json(const Result& r, const std::string& command) {
    return {{"command", command},
            {"version", ANNULUS_VERSION},
            {"delta", r.delta},
            {"tolerance", {{"paper", r.paper}, {"certified", r.certified.tolerance}, {"exact", r.exact}}},
            {"stage", name_of(r.certified.stage)},
            {"theta_min", r.theta},
            {"move", r.move},
            {"largest_displacement_upper", r.displaced},
            {"accepted", {{"paper", r.displaced < r.paper}, {"certified", r.displaced < r.certified.tolerance}}},
            {"delaunay",
             {{"three_cells_before", r.three_before},
              {"three_cells_after", r.three_after},
              {"two_cells_after", r.two_after}}}};
}

void print(const Result& r) {
    const auto word = [](bool yes) { return yes ? "Delaunay" : "NOT Delaunay"; };
    const auto accepts = [](bool yes) { return yes ? "accepts" : "asks for an evaluation"; };
    std::printf("five points    a, b = (0, 0, +-%.17g), p, q, r at 120 degrees on the unit circle of z = 0\n",
                1.0 - r.delta);
    std::printf("triangulation  three cells around ab: %s\n", word(r.three_before));
    std::printf("tolerance      paper %.17g (standard annulus)\n", r.paper);
    std::printf("               certified %.17g (%s stage)\n", r.certified.tolerance,
                std::string(name_of(r.certified.stage)).c_str());
    std::printf("               exact %.17g, the largest double not above it\n", r.exact);
    std::printf("theta          %.17g, the least of the three facets at ab\n", r.theta);
    std::printf("move           a, b outward and p, q, r inward by %.17g\n", r.move);
    std::printf("               paper %s, certified %s\n", accepts(r.displaced < r.paper),
                accepts(r.displaced < r.certified.tolerance));
    std::printf("triangulation  three cells around ab: %s; two cells at pqr: %s\n", word(r.three_after),
                word(r.two_after));
}

}  // namespace

Run add_counterexample_command(CLI::App& app, const Invocation& invocation) {
    struct Arguments {
        Common_arguments common;
        double delta = 0.01;
        bool json = false;
    };
    auto* sub = app.add_subcommand(
        "counterexample",
        "Five points of space where the paper's tolerance accepts a triangulation that is no longer Delaunay");
    const auto a = std::make_shared<Arguments>();
    sub->add_option("--delta", a->delta, "How far a and b are inside the unit sphere, 2^-40 to 0.1")
        ->check(CLI::Range(0x1p-40, 0.1))
        ->capture_default_str();
    sub->add_flag("--json", a->json, "Print JSON instead of text");
    add_common(*sub, a->common, "counterexample.json", false);
    return [a, command = command_line(invocation.words)] {
        if (std::isnan(a->delta)) throw Error(Error_code::usage, "--delta: not a number");
        const Result r = study(a->delta);
        const std::string text = write_json(json(r, command));
        if (!a->common.output.empty()) {
            Result_files out(a->common, [](std::string_view name) { return name == "counterexample.json"; });
            out.write("counterexample.json", text);
            out.commit();
        }
        if (a->common.quiet) return done;
        if (a->json) std::printf("%s", text.c_str());
        else print(r);
        return done;
    };
}

}  // namespace annulus::cli
