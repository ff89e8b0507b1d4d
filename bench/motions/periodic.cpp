// SPDX-License-Identifier: GPL-3.0-or-later
// What periodic boxes cost, beside open meshes of the same points: moves, builds, insertions and removals, and what is
// computed from the cells. One JSON object per line; microseconds of processor time a point.
#include "motion.h"
#include "random.h"
#include "result_line.h"
#include "stopwatch.h"

#include <annulus/kernel/periodic_builder.h>
#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>
#include <annulus/space/lattice.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace annulus;
using bench::Points;
using nlohmann::ordered_json;

/// Microseconds of processor time.
template <class F>
double microseconds(F f) {
    const bench::Stopwatch watch;
    const double begin = watch.seconds();
    f();
    return 1e6 * (watch.seconds() - begin);
}

double median(const std::vector<double>& v) { return bench::quantile(v, 0.5); }

template <int d>
std::span<const Coordinates<d>> span_of(const Points<d>& x) {
    return x;
}

template <int d>
Box<d> unit_box() {
    Coordinates<d> lengths;
    lengths.fill(1.0);
    return Box<d>::orthorhombic(lengths);
}

template <int d>
Coordinates<d> uniform_point(bench::Random& random) {
    Coordinates<d> p;
    for (double& c : p) c = random.unit();
    return p;
}

template <int d>
Points<d> uniform_points(std::size_t n, bench::Random& random) {
    Points<d> x(n);
    for (auto& p : x) p = uniform_point<d>(random);
    return x;
}

void say(const ordered_json& line, const std::string& file) {
    std::printf("%s\n", line.dump().c_str());
    std::fflush(stdout);
    bench::append(file, line);
}

/// Steps in which all points move by up to so many mean spacings along each axis: a periodic and an open mesh, both
/// `auto`, and a periodic build of the same points. Medians, of the ratio over the steps.
template <int d>
void moves(std::size_t n, double spacings, int steps, const std::string& file) {
    bench::Random random(1);
    Points<d> x = uniform_points<d>(n, random);
    const Box<d> box = unit_box<d>();
    Periodic_mesh<d> periodic(x, box);
    Moving_mesh<d> open(span_of<d>(x));
    const double reach = spacings * std::pow(static_cast<double>(n), -1.0 / d);
    std::vector<double> of_periodic, of_open, of_build, ratio;
    double rebuilt = 0;
    constexpr int warm = 3;
    for (int step = 0; step < warm + steps; ++step) {
        for (auto& p : x)
            for (double& c : p) c += reach * (2 * random.unit() - 1);
        Move_result result;
        const double one = microseconds([&] { result = periodic.move_all(x); });
        const double other = microseconds([&] { (void)open.move_all(span_of<d>(x)); });
        std::unique_ptr<Periodic_mesh<d>> built;
        const double build = microseconds([&] { built = std::make_unique<Periodic_mesh<d>>(x, box); });
        if (step < warm) continue;
        const auto each = static_cast<double>(n);
        of_periodic.push_back(one / each);
        of_open.push_back(other / each);
        of_build.push_back(build / each);
        ratio.push_back(one / other);
        rebuilt += static_cast<double>(result.moves.rebuilt) / each / steps;
    }
    say({{"what", "move"},
         {"dimension", d},
         {"points", n},
         {"spacings", spacings},
         {"periodic_us", median(of_periodic)},
         {"open_us", median(of_open)},
         {"ratio", median(ratio)},
         {"build_us", median(of_build)},
         {"rebuilt", rebuilt},
         {"audit", periodic.audit().delaunay() && open.audit().delaunay()}},
        file);
}

/// Builds of different points, beside open rebuilds of them; copies a point.
template <int d>
void builds(std::size_t n, int times, const std::string& file) {
    bench::Random random(1);
    Options options;
    options.strategy = Strategy::rebuild;
    Points<d> x = uniform_points<d>(n, random);
    const Box<d> box = unit_box<d>();
    Moving_mesh<d> open(span_of<d>(x), options);
    std::vector<double> of_periodic, of_open, ratio;
    std::unique_ptr<Periodic_mesh<d>> built;
    for (int k = 0; k < times; ++k) {
        x = uniform_points<d>(n, random);
        const auto each = static_cast<double>(n);
        of_open.push_back(microseconds([&] { (void)open.move_all(span_of<d>(x)); }) / each);
        built.reset();
        of_periodic.push_back(microseconds([&] { built = std::make_unique<Periodic_mesh<d>>(x, box); }) / each);
        ratio.push_back(of_periodic.back() / of_open.back());
    }
    Periodic_builder<d> builder;
    Periodic_table<d> table;
    builder.build(Lattice<d>(box.vectors()), built->places(), 1, table);
    say({{"what", "build"},
         {"dimension", d},
         {"points", n},
         {"periodic_us", median(of_periodic)},
         {"open_us", median(of_open)},
         {"ratio", median(ratio)},
         {"copies", static_cast<double>(builder.copies()) / static_cast<double>(n)}},
        file);
}

/// Insertions of one point and removals of one vertex, microseconds each.
template <int d>
void edits(std::size_t n, int times, const std::string& file) {
    bench::Random random(1);
    const Points<d> x = uniform_points<d>(n, random);
    Periodic_mesh<d> mesh(x, unit_box<d>());
    std::vector<double> insertions, removals;
    std::vector<Index> inserted;
    for (int k = 0; k < times; ++k) {
        const auto p = uniform_point<d>(random);
        insertions.push_back(microseconds([&] { inserted.push_back(mesh.insert(p)); }));
    }
    for (const Index i : inserted) removals.push_back(microseconds([&] { mesh.remove(i); }));
    say({{"what", "edit"},
         {"dimension", d},
         {"points", n},
         {"insert_us", median(insertions)},
         {"remove_us", median(removals)}},
        file);
}

/// What is computed from the cells.
template <int d>
void measures(std::size_t n, int times, const std::string& file) {
    bench::Random random(1);
    const Points<d> x = uniform_points<d>(n, random);
    const Periodic_mesh<d> mesh(x, unit_box<d>());
    const std::vector<double> weights(n, 1.0);
    std::vector<double> neighbours, volumes, gradient, audit;
    double sum = 0;
    bool right = true;
    for (int k = 0; k < times; ++k) {
        const auto each = static_cast<double>(n);
        neighbours.push_back(microseconds([&] { sum += static_cast<double>(mesh.neighbours().first.size()); }) / each);
        volumes.push_back(microseconds([&] { sum += mesh.voronoi_volumes().front(); }) / each);
        gradient.push_back(microseconds([&] { sum += mesh.voronoi_gradient(weights).front()[0]; }) / each);
        audit.push_back(microseconds([&] { right = mesh.audit().delaunay() && right; }) / each);
    }
    say({{"what", "measures"},
         {"dimension", d},
         {"points", n},
         {"neighbours_us", median(neighbours)},
         {"volumes_us", median(volumes)},
         {"gradient_us", median(gradient)},
         {"audit_us", median(audit)},
         {"audit", right && std::isfinite(sum)}},
        file);
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t n = 10000;
    int times = 21;
    std::string json;
    CLI::App app{"What periodic boxes cost, beside open meshes of the same points."};
    app.add_option("POINTS", n, "of moves and measures; builds and edits also of other numbers")
        ->check(CLI::Range(1000, 100000000));
    app.add_option("--times", times, "steps, builds, ..; the median counts")->check(CLI::Range(1, 1000));
    app.add_option("--json", json, "file that a line is appended to for each");
    CLI11_PARSE(app, argc, argv);
    for (const double spacings : {0.0, 0.001, 0.01, 0.03, 0.1, 0.3}) {
        moves<2>(n, spacings, times, json);
        moves<3>(n, spacings, times, json);
    }
    for (const std::size_t points : {n, 10 * n}) {
        builds<2>(points, times, json);
        builds<3>(points, times, json);
    }
    for (const std::size_t points : {std::size_t{100}, n, 10 * n}) {
        edits<2>(points, 2 * times, json);
        edits<3>(points, 2 * times, json);
    }
    measures<2>(n, times, json);
    measures<3>(n, times, json);
}
