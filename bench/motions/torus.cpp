// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh in a cube or square beside Moving_mesh of the same points, whose boundaries are open: rebuilds, also
// beside CGAL's periodic triangulation, and steps in which both test all signs. And Periodic_mesh in a box that is
// strained or sheared, by tolerances and by signs. One JSON object per line.
#include "families.h"
#include "result_line.h"
#include "stopwatch.h"

#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace annulus;
using nlohmann::ordered_json;

struct Choice {
    int dimension = 3;
    std::size_t points = 10000;
    double spacings = 0.0;  // of a step; 0: rebuilds
    int repeat = 9;
    bool cgal = false;
    std::string box;       // how it moves; empty: not
    double strain = 1e-5;  // of a step
    std::string json;
};

template <class F>
double seconds(F f) {
    const bench::Stopwatch watch;
    const double begin = watch.seconds();
    f();
    return watch.seconds() - begin;
}

template <int d>
Box<d> unit_box() {
    Coordinates<d> lengths;
    lengths.fill(1.0);
    return Box<d>::orthorhombic(lengths);
}

/// CGAL's insertion of a range of points, for many of them. They are in the half-open unit cube.
double cgal_seconds(const bench::Points<3>& x) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
    using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
    std::vector<Triangulation::Point> points;
    points.reserve(x.size());
    for (const auto& p : x) points.emplace_back(p[0], p[1], p[2]);
    Triangulation tr(Triangulation::Iso_cuboid(0, 0, 0, 1, 1, 1));
    return seconds([&] { tr.insert(points.begin(), points.end(), true); });
}

/// Medians of the seconds a point in nanoseconds, and of the ratios to the first of the same repetition.
class Columns {
  public:
    explicit Columns(std::vector<std::string> names) : names_(std::move(names)), seconds_(names_.size()) {}
    void add(std::size_t column, double s) { seconds_[column].push_back(s); }
    void write(std::size_t n, ordered_json& out) const {
        for (std::size_t k = 0; k < names_.size(); ++k) {
            std::vector<double> ns, ratio;
            for (std::size_t i = 0; i < seconds_[k].size(); ++i) {
                ns.push_back(1e9 * seconds_[k][i] / static_cast<double>(n));
                ratio.push_back(seconds_[k][i] / seconds_[0][i]);
            }
            out[names_[k]] = {{"ns", bench::quantile(ns, 0.5)},
                              {"ratio", bench::quantile(ratio, 0.5)},
                              {"ratio_low", bench::quantile(ratio, 0.1)},
                              {"ratio_high", bench::quantile(ratio, 0.9)}};
        }
        out["repeat"] = seconds_[0].size();
    }

  private:
    std::vector<std::string> names_;
    std::vector<std::vector<double>> seconds_;
};

void say(const ordered_json& out, const std::string& file) {
    std::printf("%s\n", out.dump().c_str());
    std::fflush(stdout);
    bench::append(file, out);
}

/// All points are elsewhere in each repetition, so that both rebuild. The first repetition does not count.
template <int d>
void rebuilds(const Choice& c) {
    std::vector<std::string> names{"open", "periodic", "open constructor", "periodic constructor"};
    if (d == 3 && c.cgal) names.emplace_back("cgal");
    Columns columns(names);
    const auto scene = [&](int k) {
        return bench::Scene<d>("uniform", "walk", c.points, 0.0, static_cast<std::uint64_t>(k)).points();
    };
    const Box<d> box = unit_box<d>();
    Options options;
    options.strategy = Strategy::rebuild;
    bench::Points<d> x = scene(1);
    Moving_mesh<d> open(std::span<const Coordinates<d>>(x), options);
    Periodic_mesh<d> periodic(std::span<const Coordinates<d>>(x), box);
    bool rebuilt = true;
    for (int k = 0; k <= c.repeat; ++k) {
        x = scene(k + 2);
        const std::span<const Coordinates<d>> points(x);
        std::vector<double> s(names.size());
        for (std::size_t j = 0; j < names.size(); ++j) {
            const std::size_t turn = (j + static_cast<std::size_t>(k)) % names.size();
            if (turn == 0) s[turn] = seconds([&] { (void)open.move_all(points); });
            else if (turn == 1)
                s[turn] = seconds([&] { rebuilt = periodic.move_all(points).moves.rebuilt == x.size() && rebuilt; });
            else if (turn == 2) s[turn] = seconds([&] { const Moving_mesh<d> mesh(points, options); });
            else if (turn == 3) s[turn] = seconds([&] { const Periodic_mesh<d> mesh(points, box); });
            else if constexpr (d == 3) s[turn] = cgal_seconds(x);
        }
        if (k == 0) continue;
        for (std::size_t j = 0; j < names.size(); ++j) columns.add(j, s[j]);
    }
    ordered_json out{{"what", "rebuild"}, {"dimension", d}, {"points", c.points}};
    columns.write(c.points, out);
    out["right"] = rebuilt && open.audit().delaunay() && periodic.audit().delaunay();
    say(out, c.json);
}

/// A walk, which an open mesh and a periodic one follow.
template <int d>
class Walk {
  public:
    explicit Walk(std::size_t n)
        : random_(17),
          x_(bench::Scene<d>("uniform", "walk", n, 0.0, 1).points()),
          spacing_(std::pow(static_cast<double>(n), -1.0 / d)),
          open_(std::span<const Coordinates<d>>(x_)),
          periodic_(std::span<const Coordinates<d>>(x_), unit_box<d>(), {.strategy = Periodic_strategy::signs}) {}

    struct Times {
        double open, periodic;
        bool of_signs;  // in both, and neither rebuilt nor computed tolerances
        bool by_tolerances;
    };
    Times step(double spacings, bool periodic_first) {
        for (auto& p : x_)
            for (double& c : p) c += spacings * spacing_ * random_.normal() / std::sqrt(static_cast<double>(d));
        const std::span<const Coordinates<d>> points(x_);
        Move_result a, b;
        Times t{};
        const auto periodic = [&] { t.periodic = seconds([&] { b = periodic_.move_all(points); }); };
        if (periodic_first) periodic();
        t.open = seconds([&] { a = open_.move_all(points); });
        if (!periodic_first) periodic();
        t.by_tolerances = a.statistics.tolerance_steps != 0 || a.statistics.tolerance_recomputations != 0;
        t.of_signs = a.statistics.sign_steps == 1 && !t.by_tolerances && a.moves.rebuilt == 0 && b.moves.rebuilt == 0;
        return t;
    }
    [[nodiscard]] bool is_delaunay() const { return open_.audit().delaunay() && periodic_.audit().delaunay(); }

  private:
    bench::Random random_;
    bench::Points<d> x_;
    double spacing_;
    Moving_mesh<d> open_;
    Periodic_mesh<d> periodic_;
};

/// Steps of signs. Where the open mesh has tolerances, larger steps, which do not count, make it give them up.
template <int d>
void signs(const Choice& c) {
    constexpr double large = 0.03;
    Columns columns({"open", "periodic"});
    Walk<d> walk(c.points);
    bool has_tolerances = true;
    int counted = 0;
    for (int k = 0; counted < c.repeat && k < 50 * c.repeat; ++k) {
        const bool counts = !has_tolerances;
        const auto t = walk.step(counts ? c.spacings : large, k % 2 == 1);
        has_tolerances = t.by_tolerances;
        if (!counts || !t.of_signs) continue;
        columns.add(0, t.open);
        columns.add(1, t.periodic);
        ++counted;
    }
    ordered_json out{{"what", "signs"}, {"dimension", d}, {"points", c.points}, {"spacings", c.spacings}};
    columns.write(c.points, out);
    out["right"] = walk.is_delaunay();
    say(out, c.json);
}

/// Points that follow a box, which is strained in all directions alike, or sheared, or stays, and jitter.
template <int d>
void in_moving_box(const Choice& c) {
    struct Way {
        const char* name;
        Periodic_strategy strategy;
        std::uint64_t evaluated = 0, recomputed = 0, by_tolerances = 0, within = 0;
    };
    std::array ways{Way{"tolerances", Periodic_strategy::tolerances}, Way{"signs", Periodic_strategy::signs},
                    Way{"auto", Periodic_strategy::automatic}};
    bench::Random random(17);
    bench::Points<d> x = bench::Scene<d>("uniform", "walk", c.points, 0.0, 1).points();
    auto box = unit_box<d>().vectors();
    std::vector<Periodic_mesh<d>> meshes;
    for (const Way& way : ways)
        meshes.emplace_back(std::span<const Coordinates<d>>(x), Box<d>(box),
                            Periodic_options{.strategy = way.strategy});
    const double spacing = std::pow(static_cast<double>(c.points), -1.0 / d);
    Columns columns({"signs", "tolerances", "auto"});
    constexpr int first = 2;  // of the steps before, one computes all tolerances
    for (int k = -first; k < c.repeat; ++k) {
        const auto deform = [&](Coordinates<d>& p) {
            if (c.box == "shear") p[0] += c.strain * p[1];
            else
                for (double& y : p) y *= c.box == "npt" ? 1 + c.strain : 1;
        };
        for (auto& v : box) deform(v);
        for (auto& p : x) {
            deform(p);
            for (double& y : p) y += c.spacings * spacing * random.normal() / std::sqrt(static_cast<double>(d));
        }
        std::array<double, 3> time{};
        for (std::size_t j = 0; j < ways.size(); ++j) {
            const std::size_t turn = (j + static_cast<std::size_t>(k + first)) % ways.size();
            Move_result r;
            time[turn] = seconds([&] { r = meshes[turn].move_all(std::span<const Coordinates<d>>(x), Box<d>(box)); });
            if (k < 0) continue;
            Way& way = ways[turn];
            way.evaluated += r.statistics.evaluated;
            way.recomputed += r.statistics.tolerance_recomputations;
            way.by_tolerances += r.statistics.tolerance_steps;
            way.within += r.moves.within_tolerance;
        }
        if (k < 0) continue;
        columns.add(0, time[1]);
        columns.add(1, time[0]);
        columns.add(2, time[2]);
    }
    ordered_json out{{"what", "box"},      {"box", c.box},       {"dimension", d},
                     {"points", c.points}, {"strain", c.strain}, {"spacings", c.spacings}};
    columns.write(c.points, out);
    // Cells, and their facets, each between two of them.
    const double certificates = static_cast<double>(meshes[0].number_of_cells()) * (1 + (d + 1) / 2.0);
    const double steps = c.repeat;
    bool right = true;
    for (std::size_t j = 0; j < ways.size(); ++j) {
        const Way& way = ways[j];
        // What was computed again because the box had changed too much counts, too.
        out[way.name]["expired"] = static_cast<double>(way.evaluated) / certificates / steps;
        out[way.name]["recomputed"] = way.recomputed;
        out[way.name]["by_tolerances"] = static_cast<double>(way.by_tolerances) / steps;
        out[way.name]["within"] = static_cast<double>(way.within) / static_cast<double>(c.points) / steps;
        right = right && meshes[j].audit().delaunay();
    }
    out["right"] = right;
    say(out, c.json);
}

template <int d>
void run(const Choice& c) {
    if (!c.box.empty()) in_moving_box<d>(c);
    else if (c.spacings > 0.0) signs<d>(c);
    else rebuilds<d>(c);
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    CLI::App app{"Periodic_mesh beside Moving_mesh of the same uniform points, by processor time."};
    app.add_option("-d,--dimension", choice.dimension)->check(CLI::Range(2, 3));
    app.add_option("-n,--points", choice.points)->check(CLI::Range(100, 100000000));
    app.add_option("-s,--spacings", choice.spacings, "steps of this length in which both test all signs; 0: rebuilds")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--repeat", choice.repeat)->check(CLI::Range(1, 1000));
    app.add_option("--box", choice.box, "strained by --strain in each step, with --spacings of jitter, or still")
        ->check(CLI::IsMember({"npt", "shear", "still"}));
    app.add_option("--strain", choice.strain)->check(CLI::NonNegativeNumber);
    app.add_flag("--cgal", choice.cgal, "rebuilds in 3D: CGAL's periodic triangulation, too");
    app.add_option("--json", choice.json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);
    try {
        if (choice.dimension == 2) run<2>(choice);
        else run<3>(choice);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-torus: %s\n", e.what());
        return 3;
    }
}
