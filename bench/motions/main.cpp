// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies and CGAL's rebuild on one motion, timed step by step in turn: nanoseconds a vertex and step, ratios of the same step.
#include "families.h"

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

namespace {

using namespace annulus;
using bench::Points;
using nlohmann::ordered_json;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double quantile(std::vector<double> v, double q) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

struct Choice {
    int dimension = 3;
    std::string family = "uniform";
    std::string motion = "walk";
    std::size_t points = 8000;
    double spacings = 0.01;
    int steps = 24;
    int warm = 3;
    int threads = 1;
    std::uint64_t seed = 1;
    bool audit = true;
    std::vector<std::string> strategies{"auto", "filter"};
};

/// CGAL's own rebuild: its insertion of a range, with nothing but the input order at its vertices.
template <int d>
double rebuild(const Points<d>& x) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Point = std::conditional_t<d == 2, typename Kernel::Point_2, typename Kernel::Point_3>;
    std::vector<std::pair<Point, Index>> points;
    points.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if constexpr (d == 2) points.emplace_back(Point(x[i][0], x[i][1]), static_cast<Index>(i));
        else points.emplace_back(Point(x[i][0], x[i][1], x[i][2]), static_cast<Index>(i));
    }
    if constexpr (d == 2) {
        using Vb = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
        const double begin = seconds();
        CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb>> tr(points.begin(), points.end());
        return seconds() - begin;
    } else {
        using Vb = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
        using Tds = CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
        const double begin = seconds();
        CGAL::Delaunay_triangulation_3<Kernel, Tds> tr(points.begin(), points.end());
        return seconds() - begin;
    }
}

template <class Dt, int d>
int run(const Choice& choice, const std::string& file) {
    bench::Scene<d> scene(choice.family, choice.motion, choice.points, choice.spacings, choice.seed);
    struct Runner {
        std::string name;
        std::unique_ptr<Dt> dt;
        std::vector<double> seconds;
        Move_report report;
        double construction = 0.0;
        int failed_audits = 0;
    };
    std::vector<Runner> runners;
    for (const std::string& name : choice.strategies) {
        Options options;
        options.strategy = strategy_named(name).value();
        options.threads = choice.threads;
        Runner r{name, nullptr, {}, {}, 0.0, 0};
        const double begin = seconds();
        r.dt = std::make_unique<Dt>(std::span<const Coordinates<d>>(scene.points()), options);
        r.construction = seconds() - begin;
        runners.push_back(std::move(r));
    }
    std::vector<double> cgal;
    const std::size_t turns = runners.size() + 1;
    for (int step = 0; step < choice.warm + choice.steps; ++step) {
        scene.step();
        const bool counts = step >= choice.warm;
        for (std::size_t k = 0; k < turns; ++k) {
            const std::size_t who = (k + static_cast<std::size_t>(step)) % turns;
            if (who == runners.size()) {
                const double s = rebuild<d>(scene.points());
                if (counts) cgal.push_back(s);
                continue;
            }
            Runner& r = runners[who];
            const double begin = seconds();
            const Move_report report = r.dt->move_all(std::span<const Coordinates<d>>(scene.points()));
            const double s = seconds() - begin;
            if (!counts) continue;
            r.seconds.push_back(s);
            r.report += report;
        }
    }
    const double vertex = 1e9 / static_cast<double>(choice.points);
    ordered_json out{{"dimension", d}, {"family", choice.family}, {"motion", choice.motion}, {"points", choice.points},
                     {"spacings", choice.spacings}, {"steps", choice.steps}, {"threads", choice.threads},
                     {"cgal_ns", vertex * quantile(cgal, 0.5)}};
    std::printf("%dD %-8s %-6s n=%zu s=%g  cgal %.0f ns", d, choice.family.c_str(), choice.motion.c_str(), choice.points,
                choice.spacings, vertex * quantile(cgal, 0.5));
    int failed = 0;
    for (Runner& r : runners) {
        std::vector<double> ratio;
        std::vector<double> dearest;
        for (std::size_t i = 0; i < cgal.size(); ++i) {
            ratio.push_back(cgal[i] / r.seconds[i]);
            dearest.push_back(r.seconds[i] / cgal[i]);
        }
        if (choice.audit && !r.dt->audit().delaunay()) ++r.failed_audits;
        failed += r.failed_audits;
        const double asked = static_cast<double>(std::max<std::uint64_t>(r.report.moves.asked, 1));
        const auto share = [&](std::uint64_t k) { return static_cast<double>(k) / asked; };
        std::printf(" | %s %.0f ns, ratio %.2f, dearest %.2f%s", r.name.c_str(), vertex * quantile(r.seconds, 0.5), quantile(ratio, 0.5),
                    quantile(dearest, 1.0), r.failed_audits != 0 ? " AUDIT FAILED" : "");
        if (share(r.report.moves.rebuilt) > 0.0) std::printf(", rebuilt %.2f", share(r.report.moves.rebuilt));
        std::printf(", flips %.3f, again %.4f", share(r.report.flips), share(r.report.moves.reinserted));
        out[r.name] = {{"ns", vertex * quantile(r.seconds, 0.5)}, {"ratio", quantile(ratio, 0.5)},
                       {"ratio_low", quantile(ratio, 0.1)}, {"ratio_high", quantile(ratio, 0.9)},
                       {"dearest", quantile(dearest, 1.0)}, {"construction_ns", vertex * r.construction},
                       {"rebuilt", share(r.report.moves.rebuilt)}, {"within_tolerance", share(r.report.moves.within_tolerance)},
                       {"flips", share(r.report.flips)}, {"evaluated", share(r.report.evaluated)},
                       {"exact", share(r.report.arithmetic.exact)}, {"reinserted", share(r.report.moves.reinserted)},
                       {"audit", r.failed_audits == 0}};
    }
    std::printf("\n");
    std::fflush(stdout);
    if (!file.empty()) std::ofstream(file, std::ios::app) << out.dump() << '\n';
    return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    std::string json;
    CLI::App app{"Strategies and CGAL's rebuild on one motion of one family of points, step by step in turn."};
    app.add_option("-d,--dimension", choice.dimension)->check(CLI::Range(2, 3));
    app.add_option("-f,--family", choice.family, "uniform, sphere, slab, clusters, faces, lattice, ball");
    app.add_option("-m,--motion", choice.motion, "walk, drift, shear, few, burst");
    app.add_option("-n,--points", choice.points);
    app.add_option("-s,--spacings", choice.spacings, "root mean square displacement a step, in spacings");
    app.add_option("-k,--steps", choice.steps);
    app.add_option("-w,--warm", choice.warm, "steps before those that count");
    app.add_option("-t,--threads", choice.threads);
    app.add_option("--seed", choice.seed);
    app.add_option("--strategies", choice.strategies)->delimiter(',');
    app.add_flag("!--no-audit", choice.audit);
    app.add_option("--json", json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);
    try {
        return choice.dimension == 2 ? run<Moving_delaunay_2, 2>(choice, json) : run<Moving_delaunay_3, 3>(choice, json);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-motions: %s\n", e.what());
        return 3;
    }
}
