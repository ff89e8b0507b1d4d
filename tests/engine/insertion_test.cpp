// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices inserted and removed one by one at hard positions: after each call the cells are those of a construction, in
// both classes.
#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Moving_d = testing::Viewed_mesh<d>;

/// Sorted cells, by the positions of their corners.
template <int d>
using Cells_at = std::set<std::set<Coordinates<d>>>;
template <int d>
Cells_at<d> cells_at(const Mesh_cells<d>& cells, std::span<const Coordinates<d>> x) {
    Cells_at<d> out;
    for (const auto& cell : cells.vertices) {
        std::set<Coordinates<d>> corners;
        for (const Index v : cell)
            if (v != none) corners.insert(x[static_cast<std::size_t>(v)]);
        out.insert(std::move(corners));
    }
    return out;
}

template <int d, class Object>
std::string fault_of(const Object& object) {
    const auto x = object.points();
    Points_d<d> living;
    for (std::size_t i = 0; i < object.index_bound(); ++i)
        if (object.is_vertex(static_cast<Index>(i))) living.push_back(x[i]);
    if (const auto fault = object.audit().first_fault; !fault.empty()) return fault;
    Options options;
    options.strategy = Strategy::rebuild;
    const Moving_mesh<d> anew(std::span<const Coordinates<d>>(living), options);
    return cells_at<d>(object.cells(), x) == cells_at<d>(anew.cells(), anew.points())
               ? ""
               : "the cells are not those of a construction";
}

/// Hard positions around a set: on a vertex, in the middle of two vertices, beyond one of two on their line, the fourth
/// corner of a parallelogram, far away on the line of an edge, and whole numbers.
template <int d>
Coordinates<d> hard_place(Random& random, const Points_d<d>& x, int span) {
    Coordinates<d> p{};
    const auto vertex = [&] { return x[random() % x.size()]; };
    const auto kind = x.size() < 3 ? 6U : random() % 8;
    const Coordinates<d> a = kind < 6 ? vertex() : p, b = kind < 6 ? vertex() : p, c = kind == 3 ? vertex() : p;
    for (std::size_t k = 0; k < d; ++k) {
        if (kind == 0) p[k] = a[k];
        else if (kind == 1) p[k] = 0.5 * (a[k] + b[k]);
        else if (kind == 2) p[k] = 2.0 * a[k] - b[k];
        else if (kind == 3) p[k] = a[k] + b[k] - c[k];
        else if (kind == 4) p[k] = a[k] + 0x1p40 * (b[k] - a[k]);
        else if (kind == 5) p[k] = a[k] + 0x1p-30 * (b[k] - a[k]);
        else p[k] = integer(random, 0, span);
    }
    // Positions far away are limited to where whole numbers are exact.
    for (double& k : p)
        if (std::fabs(k) > 0x1p44) k = 0.5;
    return p;
}

enum class Setting { lattice, cospherical, flat, line, column };

template <int d>
Points_d<d> begin_with(Setting setting, Random& random) {
    Points_d<d> x;
    const auto add = [&](Coordinates<d> p) {
        if (std::find(x.begin(), x.end(), p) == x.end()) x.push_back(p);
    };
    const int count = 4 + static_cast<int>(random() % 20);
    for (int i = 0; i < count; ++i) {
        Coordinates<d> p{};
        for (double& c : p) c = integer(random, 0, 3);
        if (setting == Setting::cospherical) {  // whole points at distance 5, or 3 in 3D
            const std::array<double, 3> way = d == 2 ? std::array{3.0, 4.0, 0.0} : std::array{1.0, 2.0, 2.0};
            const std::size_t turn = random();
            for (std::size_t k = 0; k < d; ++k) p[k] = way[(k + turn) % d] * ((random() & 1) != 0 ? 1.0 : -1.0);
        }
        if (setting == Setting::flat) p[d - 1] = 0.0;
        if (setting == Setting::line) p.fill(p[0]);
        if (setting == Setting::column) p[0] = i % 8 == 0 ? 1.0 : 0.0;
        add(p);
    }
    return x;
}

template <int d, class Object>
void come_and_go(std::uint64_t seed, Strategy strategy) {
    Random random(seed);
    const auto setting = static_cast<Setting>(seed % 5);
    Points_d<d> x = begin_with<d>(setting, random);
    Options options;
    options.strategy = strategy;
    Object object(std::span<const Coordinates<d>>(x), options);
    std::vector<Index> living;
    for (std::size_t i = 0; i < x.size(); ++i) living.push_back(static_cast<Index>(i));
    for (int step = 0; step < 24; ++step) {
        CAPTURE(seed, step, name_of(strategy));
        if (living.size() > 2 && random() % 3 == 0) {
            const std::size_t k = random() % living.size();
            object.remove(living[k]);
            living.erase(living.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
            Points_d<d> here;
            for (const Index v : living) here.push_back(object.points()[static_cast<std::size_t>(v)]);
            const Coordinates<d> p = hard_place<d>(random, here, 3);
            const bool taken = std::find(here.begin(), here.end(), p) != here.end();
            try {
                living.push_back(object.insert(p));
                REQUIRE(!taken);
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
                REQUIRE(taken);
            }
        }
        REQUIRE(fault_of<d>(object) == "");
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Vertices that come to degenerate places, and go, leave the cells of a construction, dimension",
                       "[insertion]", ((int d), d), 2, 3) {
    for (std::uint64_t seed = 1; seed <= (Limits::tiny ? 60 : 200); ++seed) {
        const std::array strategies{Strategy::automatic, Strategy::tolerances, Strategy::rebuild, Strategy::in_place,
                                    Strategy::relocate};
        const Strategy strategy = strategies[seed / 5 % strategies.size()];
        come_and_go<d, Moving_mesh<d>>(seed, strategy);
        come_and_go<d, Moving_d<d>>(seed, strategy);
    }
}

/// Many points with whole coordinates: landmarks are made, become stale and are made again; positions are duplicates,
/// on the hull, on edges and at centres of cells.
TEMPLATE_TEST_CASE_SIG("A lattice that is filled and thinned at random has the cells of a construction, dimension",
                       "[insertion]", ((int d), d), 2, 3) {
    const auto fill = [&]<class Object>(Object& object, std::uint64_t seed) {
        Random random(seed);
        const int side = d == 2 ? 40 : 9;
        std::size_t refused = 0;
        for (int step = 0; step < 2400; ++step) {
            const std::size_t bound = object.index_bound();
            const auto i = static_cast<Index>(bound == 0 ? 0 : random() % bound);
            if (step % 800 > 600 && object.is_vertex(i)) {
                object.remove(i);
                continue;
            }
            Coordinates<d> p{};
            for (double& c : p) c = integer(random, 0, side);
            if (step % 800 > 400) p[0] = 0.0;  // a wall
            try {
                (void)object.insert(p);
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
                ++refused;
            }
            if (step % 200 == 199) REQUIRE(fault_of<d>(object) == "");
        }
        CHECK(refused > 100);
    };
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances}) {
        Options options;
        options.strategy = strategy;
        Moving_mesh<d> mesh(options);
        fill(mesh, 5);
        Moving_d<d> dt(options);
        fill(dt, 6);
    }
}

TEMPLATE_TEST_CASE_SIG("Vertices go far, where others are or not, and the triangulation is right, dimension",
                       "[insertion]", ((int d), d), 2, 3) {
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::tolerances, Strategy::relocate, Strategy::relocate_flips}) {
        Options options;
        options.strategy = strategy;
        Random random(11);
        Points_d<d> x = grid<d>();
        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
        Moving_d<d> dt(std::span<const Coordinates<d>>(x), options);
        for (int step = 0; step < 120; ++step) {
            const auto i = static_cast<Index>(random() % x.size());
            const Points_d<d> here(mesh.points().begin(), mesh.points().end());
            const Coordinates<d> p = hard_place<d>(random, here, 5);
            const auto at = std::find(here.begin(), here.end(), p);
            const bool taken = at != here.end() && at - here.begin() != i;
            const auto go = [&](auto& object) {
                try {
                    (void)object.move(i, p);
                    REQUIRE(!taken);
                } catch (const Error& e) {
                    REQUIRE(e.code() == Error_code::duplicate_point);
                    REQUIRE(taken);
                }
                REQUIRE(fault_of<d>(object) == "");
            };
            CAPTURE(step, name_of(strategy));
            go(mesh);
            go(dt);
        }
    }
}
