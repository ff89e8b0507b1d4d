// SPDX-License-Identifier: GPL-3.0-or-later
// What is computed from the cells after each step of a walk, beside the step itself: areas and volumes with a gradient,
// facets, pairs of neighbours, pairs that came and went. One JSON object per line.
#include "families.h"
#include "result_line.h"
#include "stopwatch.h"

#include <annulus/measure/neighbour_changes.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace annulus;

template <int d>
using Mesh = Moving_mesh<d>;

/// A mesh of its own, which makes every step, and what is computed after the step.
template <int d>
struct Work {
    std::string_view name;
    Mesh<d> mesh;
    std::function<double(const Mesh<d>&, const Move_result&)> compute;  // returns a number that depends on all of it
    std::vector<double> move_ns{}, work_ns{}, ratio{};
};

Options reporting(bool changes) {
    Options options;
    options.report_changes = changes;
    return options;
}

/// The gradient of the sum of squares of all bounded volumes, so that it needs the volumes.
template <int d>
double volumes_and_gradient(const Mesh<d>& mesh) {
    std::vector<double> volume = mesh.voronoi_volumes();
    for (double& v : volume) v = std::isfinite(v) ? 2 * v : 0;
    return mesh.voronoi_gradient(volume).front()[0];
}

/// Medians over the steps, also of the ratios of a work to the move of the first mesh in the same step, whose mesh
/// reports no changes. Of the last work, which needs a report, what move and work cost above that move.
template <int d>
void measure(std::size_t n, double spacings, const std::string& file) {
    bench::Scene<d> scene("uniform", "walk", n, spacings, 1);
    const auto start = std::span<const Coordinates<d>>(scene.points());
    std::vector<Work<d>> works;
    works.push_back({d == 2 ? "areas with gradient" : "volumes with gradient", Mesh<d>(start, reporting(false)),
                     [](const Mesh<d>& mesh, const Move_result&) { return volumes_and_gradient<d>(mesh); }});
    works.push_back({"facets: voronoi(mesh)", Mesh<d>(start, reporting(false)),
                     [](const Mesh<d>& mesh, const Move_result&) { return voronoi(mesh).measure.front(); }});
    works.push_back(
        {"pairs: vertex_neighbors()", Mesh<d>(start, reporting(false)), [](const Mesh<d>& mesh, const Move_result&) {
             return static_cast<double>(mesh.vertex_neighbors()->index.size());
         }});
    works.push_back({"events: report_changes, edge_changes", Mesh<d>(start, reporting(true)),
                     [](const Mesh<d>&, const Move_result& report) {
                         return static_cast<double>(edge_changes<d>(report.changed, report.gone).made.size());
                     }});
    double sum = 0;
    constexpr int warm = 3;
    for (int step = 0; step < warm + 9; ++step) {
        scene.step();
        double plain = 0;
        for (std::size_t k = 0; k < works.size(); ++k) {
            Work<d>& work = works[k];
            const bench::Stopwatch watch;
            const double begin = watch.seconds();
            const Move_result report = work.mesh.move_all(std::span<const Coordinates<d>>(scene.points()));
            const double between = watch.seconds();
            sum += work.compute(work.mesh, report);
            const double end = watch.seconds();
            if (k == 0) plain = between - begin;
            if (step < warm) continue;
            const double cost = work.mesh.options().report_changes ? end - begin - plain : end - between;
            work.move_ns.push_back(1e9 * plain / static_cast<double>(n));
            work.work_ns.push_back(1e9 * cost / static_cast<double>(n));
            work.ratio.push_back(cost / plain);
        }
    }
    for (const Work<d>& work : works) {
        const nlohmann::ordered_json line{{"what", work.name},
                                          {"dimension", d},
                                          {"points", n},
                                          {"spacings", spacings},
                                          {"move_ns", bench::quantile(work.move_ns, 0.5)},
                                          {"work_ns", bench::quantile(work.work_ns, 0.5)},
                                          {"ratio", bench::quantile(work.ratio, 0.5)},
                                          {"audit", work.mesh.audit().delaunay() && !std::isnan(sum)}};
        std::printf("%s\n", line.dump().c_str());
        std::fflush(stdout);
        bench::append(file, line);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 50000;
    double spacings = 0.01;
    std::string json;
    CLI::App app{"What is computed from the cells after each step of a walk, beside the step itself."};
    app.add_option("POINTS", n)->check(CLI::Range(1000, 100000000));
    app.add_option("--spacings", spacings, "length of a step")->check(CLI::PositiveNumber);
    app.add_option("--json", json, "file that a line is appended to for each");
    CLI11_PARSE(app, argc, argv);
    measure<2>(n, spacings, json);
    measure<3>(n, spacings, json);
}
