// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes of Voronoi cells after each step of a walk in 3D: the step and those that a mesh keeps, volumes computed
// afresh, and, where this program was compiled with it, Voro++ of the same points. A JSON object.
#include "families.h"
#include "result_line.h"
#include "stopwatch.h"

#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#ifdef ANNULUS_BENCH_VORO
#include <voro++/voro++.hh>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace annulus;

#ifdef ANNULUS_BENCH_VORO
/// Volumes in a box that contains all points, with five points a block, as the documentation of Voro++ advises.
std::vector<double> voro_volumes(const bench::Points<3>& x) {
    Coordinates<3> lower = x.front(), upper = x.front();
    for (const auto& p : x)
        for (std::size_t k = 0; k < 3; ++k) {
            lower[k] = std::min(lower[k], p[k]);
            upper[k] = std::max(upper[k], p[k]);
        }
    const int blocks = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(x.size()) / 5.0)));
    voro::container box(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2], blocks, blocks, blocks, false,
                        false, false, 8);
    for (std::size_t i = 0; i < x.size(); ++i) box.put(static_cast<int>(i), x[i][0], x[i][1], x[i][2]);
    std::vector<double> volume(x.size(), 0.0);
    voro::c_loop_all loop(box);
    voro::voronoicell cell;
    if (loop.start()) do
            if (box.compute_cell(cell, loop)) volume[static_cast<std::size_t>(loop.pid())] = cell.volume();
        while (loop.inc());
    return volume;
}

/// The median relative difference where the first is finite.
double difference(const std::vector<double>& ours, const std::vector<double>& theirs) {
    std::vector<double> all;
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (std::isfinite(ours[i])) all.push_back(std::fabs(ours[i] - theirs[i]) / ours[i]);
    return bench::quantile(all, 0.5);
}
#endif

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 10000;
    double spacings = 0.001;
    int repeat = 9;
    std::string json;
    CLI::App app{"Volumes of Voronoi cells after each step of a walk in 3D, by processor time."};
    app.add_option("POINTS", n)->check(CLI::Range(1000, 100000000));
    app.add_option("-s,--spacings", spacings, "length of a step")->check(CLI::PositiveNumber);
    app.add_option("--repeat", repeat, "steps that count, after three")->check(CLI::Range(1, 1000));
    app.add_option("--json", json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);

    bench::Scene<3> scene("uniform", "walk", n, spacings, 1);
    Moving_mesh<3> mesh(std::span<const Coordinates<3>>(scene.points()));
    (void)mesh.voronoi_volumes();
    std::vector<double> move, kept, fresh, fresh_ratio, voro, voro_ratio, off;
    bool same = true;
    const bench::Stopwatch watch;
    for (int step = 0; step < 3 + repeat; ++step) {
        scene.step();
        const double begin = watch.seconds();
        (void)mesh.move_all(std::span<const Coordinates<3>>(scene.points()));
        const double moved = watch.seconds();
        const std::vector<double> a = mesh.voronoi_volumes();
        const double computed = watch.seconds();
        const auto b = voronoi_volumes<3>(mesh.points(), mesh.cells());
        const double again = watch.seconds();
        same = same && a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
        if (step < 3) continue;
        const auto ns = [n](double s) { return 1e9 * s / static_cast<double>(n); };
        move.push_back(ns(moved - begin));
        kept.push_back(ns(computed - moved));
        fresh.push_back(ns(again - computed));
        fresh_ratio.push_back((again - computed) / (computed - moved));
#ifdef ANNULUS_BENCH_VORO
        const double start = watch.seconds();
        const std::vector<double> theirs = voro_volumes(scene.points());
        const double end = watch.seconds();
        voro.push_back(ns(end - start));
        voro_ratio.push_back((end - start) / (computed - begin));
        off.push_back(difference(a, theirs));
#endif
    }
    nlohmann::ordered_json out{{"points", n},
                               {"spacings", spacings},
                               {"move_ns", bench::quantile(move, 0.5)},
                               {"kept_ns", bench::quantile(kept, 0.5)},
                               {"fresh_ns", bench::quantile(fresh, 0.5)},
                               {"fresh_ratio", bench::quantile(fresh_ratio, 0.5)},
                               {"right", same && mesh.audit().delaunay()}};
    if (!voro.empty()) {
        out["voro_ns"] = bench::quantile(voro, 0.5);
        out["voro_ratio"] = bench::quantile(voro_ratio, 0.5);
        out["difference"] = bench::quantile(off, 1.0);
    }
    std::printf("%s\n", out.dump().c_str());
    bench::append(json, out);
}
