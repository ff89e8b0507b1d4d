// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that concern some vertices of Moving_mesh, beside CGAL: moves of a few, insertions one by one, moves by index
// of points in convex position. One JSON object per line.
#include "cgal_rebuild.h"
#include "families.h"
#include "result_line.h"
#include "stopwatch.h"

#include <annulus/moving_mesh.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace annulus;
using nlohmann::ordered_json;

struct Choice {
    std::string what = "few";
    int dimension = 3;
    std::size_t points = 20000;
    std::size_t movers = 200;
    double pace = 1.0;
    int repeat = 31;
    std::string json;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <int d>
struct Cgal;
template <>
struct Cgal<2> {
    using Point = Kernel::Point_2;
    using Triangulation = CGAL::Delaunay_triangulation_2<
        Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>>>;
    static Point point(const Coordinates<2>& p) { return {p[0], p[1]}; }
};
template <>
struct Cgal<3> {
    using Point = Kernel::Point_3;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
    using Triangulation = CGAL::Delaunay_triangulation_3<
        Kernel, CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
    static Point point(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
};

/// CGAL's triangulation, and its vertices by index.
template <int d>
class Reference {
  public:
    explicit Reference(const bench::Points<d>& x) : vertex_(x.size()) {
        std::vector<std::pair<typename Cgal<d>::Point, Index>> points;
        for (const auto& p : x) points.emplace_back(Cgal<d>::point(p), static_cast<Index>(points.size()));
        tr_.insert(points.begin(), points.end());
        for (auto v = tr_.finite_vertices_begin(); v != tr_.finite_vertices_end(); ++v)
            vertex_[static_cast<std::size_t>(v->info())] = v;
    }
    void move(Index i, const Coordinates<d>& p) {
        (void)tr_.move_if_no_collision(vertex_[static_cast<std::size_t>(i)], Cgal<d>::point(p));
    }
    void insert(const Coordinates<d>& p) { (void)tr_.insert(Cgal<d>::point(p)); }

  private:
    typename Cgal<d>::Triangulation tr_;
    std::vector<typename Cgal<d>::Triangulation::Vertex_handle> vertex_;
};

template <class F>
double seconds(F f) {
    const bench::Stopwatch watch;
    const double begin = watch.seconds();
    f();
    return watch.seconds() - begin;
}

void say(const ordered_json& out, const std::string& file) {
    std::printf("%s\n", out.dump().c_str());
    std::fflush(stdout);
    bench::append(file, out);
}

template <int d>
Coordinates<d> in_cube(bench::Random& random) {
    Coordinates<d> p;
    for (double& c : p) c = random.unit();
    return p;
}

/// Each of the movers, others in each repetition, moves by so many spacings, in one call of ours, and one by one.
template <int d>
void few(const Choice& c) {
    bench::Random random(5);
    bench::Points<d> x = bench::Scene<d>("uniform", "walk", c.points, 0.0, 1).points();
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    Reference<d> cgal(x);
    const double reach = c.pace * std::pow(static_cast<double>(c.points), -1.0 / d);
    std::vector<double> ours, theirs, ratio;
    for (int k = 0; k <= c.repeat; ++k) {
        std::vector<Index> movers;
        bench::Points<d> to;
        while (movers.size() < c.movers) {
            const auto v = static_cast<Index>(random.bits() % c.points);
            if (std::find(movers.begin(), movers.end(), v) != movers.end()) continue;
            Coordinates<d> way;
            double square = 0.0;
            for (double& w : way) {
                w = random.normal();
                square += w * w;
            }
            Coordinates<d>& p = x[static_cast<std::size_t>(v)];
            for (std::size_t i = 0; i < d; ++i) p[i] += way[i] * reach / std::sqrt(square);
            movers.push_back(v);
            to.push_back(p);
        }
        double a = 0.0, b = 0.0;
        const auto move_ours = [&] {
            a = seconds([&] { (void)mesh.move(std::span<const Index>(movers), std::span<const Coordinates<d>>(to)); });
        };
        if (k % 2 == 0) move_ours();
        b = seconds([&] {
            for (std::size_t i = 0; i < movers.size(); ++i) cgal.move(movers[i], to[i]);
        });
        if (k % 2 == 1) move_ours();
        if (k == 0) continue;
        ours.push_back(1e9 * a / static_cast<double>(c.movers));
        theirs.push_back(1e9 * b / static_cast<double>(c.movers));
        ratio.push_back(b / a);
    }
    say({{"what", "few"},
         {"dimension", d},
         {"points", c.points},
         {"movers", c.movers},
         {"pace", c.pace},
         {"ns", bench::quantile(ours, 0.5)},
         {"cgal_ns", bench::quantile(theirs, 0.5)},
         {"ratio", bench::quantile(ratio, 0.5)},
         {"audit", mesh.audit().delaunay()}},
        c.json);
}

/// Insertions at random places, medians of batches of 20. The first ones, for which the mesh copies arrays, do not
/// count.
template <int d>
void insertions(const Choice& c) {
    bench::Random random(5);
    const bench::Points<d> x = bench::Scene<d>("uniform", "walk", c.points, 0.0, 1).points();
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    Reference<d> cgal(x);
    std::vector<double> ours, theirs;
    for (int k = -1; k < c.repeat; ++k) {
        bench::Points<d> batch(20);
        for (auto& p : batch) p = in_cube<d>(random);
        const double a = seconds([&] {
            for (const auto& p : batch) (void)mesh.insert(p);
        });
        const double b = seconds([&] {
            for (const auto& p : batch) cgal.insert(p);
        });
        if (k < 0) continue;
        ours.push_back(1e9 * a / 20.0);
        theirs.push_back(1e9 * b / 20.0);
    }
    say({{"what", "insertion"},
         {"dimension", d},
         {"points", c.points},
         {"ns", bench::quantile(ours, 0.5)},
         {"cgal_ns", bench::quantile(theirs, 0.5)},
         {"audit", c.points > 200000 || mesh.audit().delaunay()}},
        c.json);
}

/// Points on the unit sphere, some of which move on it by the pace in one call: its cost over that of CGAL's insertion
/// of all points.
template <int d>
void convex(const Choice& c) {
    bench::Random random(5);
    bench::Points<d> x = bench::Scene<d>("sphere", "walk", c.points, 0.0, 1).points();
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    std::vector<double> ours, theirs, ratio;
    for (int k = 0; k <= c.repeat; ++k) {
        std::vector<Index> movers;
        bench::Points<d> to;
        for (std::size_t i = 0; i < c.movers; ++i) {
            const auto v = static_cast<std::size_t>(random.bits() % c.points);
            double square = 0.0;
            for (double& w : x[v]) {
                w += c.pace * random.normal();
                square += w * w;
            }
            for (double& w : x[v]) w /= std::sqrt(square);
            movers.push_back(static_cast<Index>(v));
            to.push_back(x[v]);
        }
        const double a =
            seconds([&] { (void)mesh.move(std::span<const Index>(movers), std::span<const Coordinates<d>>(to)); });
        const double b = bench::cgal_rebuild<d>(x, bench::Stopwatch());
        if (k == 0) continue;
        ours.push_back(1e9 * a / static_cast<double>(c.points));
        theirs.push_back(1e9 * b / static_cast<double>(c.points));
        ratio.push_back(a / b);
    }
    say({{"what", "convex"},
         {"dimension", d},
         {"points", c.points},
         {"movers", c.movers},
         {"pace", c.pace},
         {"ns", bench::quantile(ours, 0.5)},
         {"cgal_ns", bench::quantile(theirs, 0.5)},
         {"ratio", bench::quantile(ratio, 0.5)},
         {"most expensive", bench::quantile(ratio, 1.0)},
         {"audit", mesh.audit().delaunay()}},
        c.json);
}

template <int d>
void run(const Choice& c) {
    if (c.what == "few") few<d>(c);
    else if (c.what == "insertion") insertions<d>(c);
    else convex<d>(c);
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    CLI::App app{"Calls that concern some vertices, beside CGAL, by processor time."};
    app.add_option("--what", choice.what, "few: moves of some vertices; insertion; convex: moves of points on a sphere")
        ->check(CLI::IsMember({"few", "insertion", "convex"}));
    app.add_option("-d,--dimension", choice.dimension)->check(CLI::Range(2, 3));
    app.add_option("-n,--points", choice.points)->check(CLI::Range(100, 100000000));
    app.add_option("--movers", choice.movers)->check(CLI::Range(1, 1000000));
    app.add_option("--pace", choice.pace, "few: in spacings; convex: in radii, along each axis")
        ->check(CLI::PositiveNumber);
    app.add_option("--repeat", choice.repeat)->check(CLI::Range(1, 100000));
    app.add_option("--json", choice.json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);
    if (choice.movers > choice.points) choice.movers = choice.points;
    try {
        if (choice.dimension == 2) run<2>(choice);
        else run<3>(choice);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-edits: %s\n", e.what());
        return 3;
    }
}
