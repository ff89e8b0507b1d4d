// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's parallel insertion in 3D, for comparison with a strategy with threads. A separate program, since code that
// includes CGAL with and without TBB cannot be mixed.
#include "families.h"
#include "result_line.h"
#include "stopwatch.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <string>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vb = CGAL::Triangulation_vertex_base_with_info_3<annulus::Index, Kernel>;
using Tds =
    CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Kernel>, CGAL::Parallel_tag>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Tds>;

double rebuild(const std::vector<std::pair<Kernel::Point_3, annulus::Index>>& points) {
    const bench::Stopwatch watch(2);  // the clock, whatever the number of threads
    const double begin = watch.seconds();
    Triangulation::Lock_data_structure locks(CGAL::Bbox_3(-1, -1, -1, 2, 2, 2), 50);  // as in CGAL's manual
    const Triangulation tr(points.begin(), points.end(), &locks);
    const double taken = watch.seconds() - begin;
    if (tr.number_of_vertices() != points.size()) std::fprintf(stderr, "annulus-parallel-cgal: points are missing\n");
    return taken;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 1000000;
    std::size_t threads = 2;
    int repeat = 3;
    std::string json;
    CLI::App app{"CGAL's parallel insertion of uniform points of space: the least of some times."};
    app.add_option("-n,--points", n)->check(CLI::Range(100, 100000000));
    app.add_option("-t,--threads", threads)->check(CLI::Range(1, 1024));
    app.add_option("--repeat", repeat)->check(CLI::Range(1, 1000));
    app.add_option("--json", json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);
    const bench::Scene<3> scene("uniform", "walk", n, 0.0, 1);
    std::vector<std::pair<Kernel::Point_3, annulus::Index>> points;
    for (std::size_t i = 0; i < n; ++i) {
        const auto& p = scene.points()[i];
        points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), static_cast<annulus::Index>(i));
    }
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    double least = rebuild(points);
    for (int k = 1; k < repeat; ++k) least = std::min(least, rebuild(points));
    const double ns = 1e9 * least / static_cast<double>(n);
    std::printf("%zu points, %zu threads: %.0f ns a point\n", n, threads, ns);
    bench::append(json, {{"points", n}, {"threads", threads}, {"ns", ns}});
}
