// SPDX-License-Identifier: GPL-3.0-or-later
// Costs that do not depend on a motion: construction and rebuilds, also by several threads, memory, a step in which all
// vertices pass, the move of one vertex; Voronoi volumes. One JSON object per line.
#include "families.h"
#include "stopwatch.h"

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

namespace {

using namespace annulus;
using nlohmann::ordered_json;

/// Processor time; with several threads, by the clock.
template <class F>
double nanoseconds(F f, int threads = 1) {
    const bench::Stopwatch watch(threads);
    const double begin = watch.seconds();
    f();
    return 1e9 * (watch.seconds() - begin);
}

/// Bytes that are allocated, by malloc's own count.
double allocated() {
    const auto m = mallinfo2();
    return static_cast<double>(m.uordblks) + static_cast<double>(m.hblkhd);
}

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

/// CGAL's triangulation with an index at each vertex.
template <int d>
auto cgal(const bench::Points<d>& x) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Point = std::conditional_t<d == 2, typename Kernel::Point_2, typename Kernel::Point_3>;
    std::vector<std::pair<Point, Index>> points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if constexpr (d == 2) points.emplace_back(Point(x[i][0], x[i][1]), static_cast<Index>(i));
        else points.emplace_back(Point(x[i][0], x[i][1], x[i][2]), static_cast<Index>(i));
    }
    if constexpr (d == 2) {
        using Vb = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
        return std::make_unique<CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb>>>(
            points.begin(), points.end());
    } else {
        using Vb = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
        using Tds = CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
        return std::make_unique<CGAL::Delaunay_triangulation_3<Kernel, Tds>>(points.begin(), points.end());
    }
}

void say(const ordered_json& out, const std::string& file) {
    std::printf("%s\n", out.dump().c_str());
    std::fflush(stdout);
    if (!file.empty()) std::ofstream(file, std::ios::app) << out.dump() << '\n';
}

/// The memory of an object in the state after steps of `spacings`.
template <class Moving, int d>
void costs(const char* name, std::size_t n, double spacings, const std::string& file) {
    bench::Scene<d> scene("uniform", "walk", n, spacings, 1);
    scene.step();  // allocates the arrays of the scene before memory is counted
    bench::Points<d> x = scene.points();
    const auto per_vertex = [n](double sum) { return sum / static_cast<double>(n); };
    ordered_json out{{"what", name}, {"dimension", d}, {"points", n}, {"spacings", spacings}};

    std::vector<double> build;
    std::vector<double> rebuild;
    double cgal_bytes = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double before = allocated();
        decltype(cgal<d>(x)) tr;
        rebuild.push_back(nanoseconds([&] { tr = cgal<d>(x); }));
        cgal_bytes = allocated() - before;
        tr.reset();
        build.push_back(nanoseconds([&] { Moving dt{std::span<const Coordinates<d>>(x)}; }));
    }
    out["cgal_construction_ns"] = per_vertex(median(rebuild));
    out["construction_ns"] = per_vertex(median(build));
    out["cgal_bytes"] = per_vertex(cgal_bytes);

    const double before = allocated();
    auto dt = std::make_unique<Moving>(std::span<const Coordinates<d>>(x));
    out["bytes_new"] = per_vertex(allocated() - before);
    for (int step = 0; step < 12; ++step) {
        scene.step();
        (void)dt->move_all(std::span<const Coordinates<d>>(scene.points()));
    }
    x = scene.points();
    out["bytes"] = per_vertex(allocated() - before);

    std::vector<double> pass;
    std::vector<double> read;
    double sum = 0.0;
    for (int k = 0; k < 31; ++k) {
        pass.push_back(nanoseconds([&] { (void)dt->move_all(std::span<const Coordinates<d>>(x)); }));
        // The minimum work of a step: read the positions and targets of the vertices, and write the positions.
        static bench::Points<d> here;
        here.resize(n);
        read.push_back(nanoseconds([&] {
            for (std::size_t i = 0; i < n; ++i) {
                sum += here[i][0] - x[i][0];
                here[i] = x[i];
            }
        }));
    }
    out["pass_ns"] = per_vertex(median(pass));
    out["arrays_ns"] = per_vertex(median(read));

    std::vector<double> one;
    const double reach = 0.01 * std::pow(static_cast<double>(n), -1.0 / d);
    for (std::size_t k = 0; k < 1000; ++k) {
        const auto v = static_cast<Index>(7919 * k % n);
        auto p = x[static_cast<std::size_t>(v)];
        p[0] += reach;
        one.push_back(nanoseconds([&] { (void)dt->move(v, p); }));
        x[static_cast<std::size_t>(v)] = p;
    }
    out["one_move_ns"] = median(one);
    out["audit"] = dt->audit().delaunay() && sum == sum;
    say(out, file);
}

/// By one thread and by several, in turn, by the clock: the medians, also of the ratios of pairs.
void in_turn(ordered_json out, int repeat, const std::function<double(int)>& build, const std::string& file) {
    std::vector<double> one;
    std::vector<double> some;
    std::vector<double> ratio;
    const int threads = out["threads"].get<int>();
    for (int k = 0; k < repeat; ++k) {
        one.push_back(build(1));
        some.push_back(build(threads));
        ratio.push_back(one.back() / some.back());
    }
    out["one_ns"] = median(one);
    out["ns"] = median(some);
    out["ratio"] = median(ratio);
    say(out, file);
}

/// Construction by one thread and by several.
template <class Moving, int d>
void construction(const char* name, std::size_t n, int threads, const std::string& file) {
    const bench::Scene<d> scene("uniform", "walk", n, 0.0, 1);
    Options options;
    const auto build = [&](int with) {
        options.threads = with;
        std::unique_ptr<Moving> dt;
        return nanoseconds(
                   [&] { dt = std::make_unique<Moving>(std::span<const Coordinates<d>>(scene.points()), options); },
                   threads) /
               static_cast<double>(n);
    };
    in_turn({{"what", name}, {"dimension", d}, {"points", n}, {"threads", threads}}, 3, build, file);
}

/// The same of rebuilds of a mesh, whose points are elsewhere each time.
void rebuilds(std::size_t n, int threads, const std::string& file) {
    Options options;
    options.strategy = Strategy::rebuild;
    bench::Points<3> x = bench::Scene<3>("uniform", "walk", n, 0.0, 1).points();
    Moving_mesh<3> one(std::span<const Coordinates<3>>(x), options);
    options.threads = threads;
    Moving_mesh<3> some(std::span<const Coordinates<3>>(x), options);
    std::uint64_t seed = 1;
    const auto build = [&](int with) {
        if (with == 1) x = bench::Scene<3>("uniform", "walk", n, 0.0, ++seed).points();
        Moving_mesh<3>& mesh = with == 1 ? one : some;
        return nanoseconds([&] { (void)mesh.move_all(std::span<const Coordinates<3>>(x)); }, threads) /
               static_cast<double>(n);
    };
    in_turn({{"what", "rebuild, Moving_mesh<3>"}, {"dimension", 3}, {"points", n}, {"threads", threads}}, 7, build,
            file);
}

/// Voronoi volumes after steps in which `movers` vertices move by a hundredth of a spacing: those that a mesh keeps,
/// and voronoi_volumes of its cells, which are listed beforehand. Medians, also of the ratios of pairs; and whether all
/// results had the same bits.
template <int d>
void volumes(std::size_t n, std::size_t movers, const std::string& file) {
    const bench::Scene<d> scene("uniform", "walk", n, 0.0, 1);
    Moving_mesh<d> mesh{std::span<const Coordinates<d>>(scene.points())};
    (void)mesh.voronoi_volumes();
    const double reach = 0.01 * std::pow(static_cast<double>(n), -1.0 / d);
    std::vector<double> kept;
    std::vector<double> fresh;
    std::vector<double> ratio;
    bool same = true;
    for (std::size_t step = 0, next = 0; step < 9; ++step) {
        bench::Points<d> x(mesh.points().begin(), mesh.points().end());
        for (std::size_t k = 0; k < movers; ++k, ++next) x[7919 * next % n][step % d] += step % 2 == 0 ? reach : -reach;
        (void)mesh.move_all(std::span<const Coordinates<d>>(x));
        const auto cells = mesh.cells();
        std::vector<double> a;
        std::vector<double> b;
        const bench::Stopwatch watch;
        const double begin = watch.seconds();
        a = mesh.voronoi_volumes();
        const double between = watch.seconds();
        b = voronoi_volumes<d>(mesh.points(), cells);
        kept.push_back(1e9 * (between - begin) / static_cast<double>(n));
        fresh.push_back(1e9 * (watch.seconds() - between) / static_cast<double>(n));
        ratio.push_back(fresh.back() / kept.back());
        same = same && a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
    }
    say({{"dimension", d},
         {"points", n},
         {"movers", movers},
         {"kept_ns", median(kept)},
         {"fresh_ns", median(fresh)},
         {"ratio", median(ratio)},
         {"same", same}},
        file);
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 100000;
    int threads = 1;
    bool of_volumes = false;
    bool of_rebuilds = false;
    std::string json;
    CLI::App app{"What does not depend on a motion, of both classes in both dimensions."};
    app.add_option("POINTS", n)->check(CLI::Range(1000, 100000000));
    app.add_option("--json", json, "file that a line is appended to for each");
    app.add_option("--threads", threads, "more than one: construction by so many, and nothing else")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--volumes", of_volumes, "Voronoi volumes after small steps, and nothing else");
    app.add_flag("--rebuilds", of_rebuilds, "with --threads: rebuilds of Moving_mesh<3>, and nothing else");
    CLI11_PARSE(app, argc, argv);
    if (of_rebuilds) {
        rebuilds(n, threads, json);
        return 0;
    }
    if (of_volumes) {
        for (const std::size_t movers : {std::size_t{1}, n / 1000, n / 100, n}) {
            volumes<3>(n, movers, json);
            volumes<2>(n, movers, json);
        }
        return 0;
    }
    if (threads > 1) {
        construction<Moving_mesh_3, 3>("Moving_mesh<3>", n, threads, json);
        construction<Moving_delaunay_3, 3>("Moving_delaunay_3", n, threads, json);
        construction<Moving_mesh_2, 2>("Moving_mesh<2>", n, threads, json);
        construction<Moving_delaunay_2, 2>("Moving_delaunay_2", n, threads, json);
        return 0;
    }
    for (const double spacings : {1e-5, 1e-3}) {  // with tolerances, and without
        costs<Moving_delaunay_3, 3>("Moving_delaunay_3", n, spacings, json);
        costs<Moving_mesh_3, 3>("Moving_mesh<3>", n, spacings, json);
        costs<Moving_delaunay_2, 2>("Moving_delaunay_2", n, spacings, json);
        costs<Moving_mesh_2, 2>("Moving_mesh<2>", n, spacings, json);
    }
}
