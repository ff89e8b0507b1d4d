// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes that change, and their Voronoi volumes recomputed.
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <support/catch.h>
#include <support/meshes.h>
#include <support/point_sets_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace annulus::testing {

template <int d>
using Points_of = std::vector<Coordinates<d>>;

inline bool same_bits(std::span<const double> a, std::span<const double> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

template <int d>
void require_fresh(const Moving_mesh<d>& mesh) {
    auto fresh = voronoi_volumes<d>(mesh.points(), mesh.cells());
    if (mesh.number_of_vertices() == 1)
        for (std::size_t i = 0; i < fresh.size(); ++i)
            if (mesh.is_vertex(static_cast<Index>(i))) fresh[i] = std::numeric_limits<double>::infinity();
    REQUIRE(same_bits(mesh.voronoi_volumes(), fresh));
}

template <int d>
Coordinates<d> near(const Coordinates<d>& p, double by, Random& random) {
    Coordinates<d> out = p;
    for (double& c : out) c += between(random, -by, by);
    return out;
}

template <int d>
Index any_vertex(const Moving_mesh<d>& mesh, Random& random) {
    Index i = 0;
    do i = static_cast<Index>(random() % mesh.index_bound());
    while (!mesh.is_vertex(i));
    return i;
}

/// A random change of a mesh. A refused change leaves it as it was, perhaps with other cells.
template <int d>
void change(Moving_mesh<d>& mesh, Random& random) {
    const double by = std::ldexp(1.0, -static_cast<int>(random() % 12));
    try {
        switch (random() % 9) {
            case 0:
            case 1: {  // all move
                Points_of<d> x(mesh.points().begin(), mesh.points().end());
                for (auto& p : x) p = near<d>(p, by * 0.1, random);
                mesh.move_all(x);
                break;
            }
            case 2: {  // all are named, few move
                Points_of<d> x(mesh.points().begin(), mesh.points().end());
                for (int k = 0; k < 2; ++k) {
                    auto& p = x[static_cast<std::size_t>(any_vertex(mesh, random))];
                    p = near<d>(p, by, random);
                }
                mesh.move_all(x);
                break;
            }
            case 3:
            case 4: {
                std::vector<Index> movers;
                Points_of<d> targets;
                for (std::uint64_t k = 0; k <= random() % 4; ++k) {
                    movers.push_back(any_vertex(mesh, random));
                    targets.push_back(near<d>(mesh.points()[static_cast<std::size_t>(movers.back())], by, random));
                }
                mesh.move(movers, targets);
                break;
            }
            case 5: {  // at another vertex, half of the time
                const Index i = any_vertex(mesh, random);
                const auto& other = mesh.points()[static_cast<std::size_t>(any_vertex(mesh, random))];
                mesh.move(i, random() % 2 == 0 ? other : near<d>(other, by, random));
                break;
            }
            case 6:
                (void)mesh.insert(
                    near<d>(mesh.points()[static_cast<std::size_t>(any_vertex(mesh, random))], by, random));
                break;
            case 7:
                if (mesh.number_of_vertices() > 1) mesh.remove(any_vertex(mesh, random));
                break;
            default: mesh.recompute_tolerances(); break;
        }
    } catch (const Error& e) {
        REQUIRE(e.code() == Error_code::duplicate_point);
    }
}

/// Points on a sphere, and its centre.
template <int d>
Points_of<d> cospherical() {
    Points_of<d> x{Coordinates<d>{}};
    for (const double a : {-4.0, -3.0, 0.0, 3.0, 4.0, 5.0, -5.0})
        for (const double b : {-4.0, -3.0, 0.0, 3.0, 4.0, 5.0, -5.0})
            if (a * a + b * b == 25)
                for (std::size_t k = 0; k < d; ++k) {
                    Coordinates<d> p{};
                    p[k] = a;
                    p[(k + 1) % d] = b;
                    if (std::find(x.begin(), x.end(), p) == x.end()) x.push_back(p);
                }
    return x;
}

template <int d>
std::vector<Points_of<d>> inputs(Random& random) {
    Points_of<d> uniform(d == 2 ? 120 : 150);
    for (auto& p : uniform)
        for (double& c : p) c = between(random, -1, 1);
    Points_of<d> few(d + 2);
    for (auto& p : few)
        for (double& c : p) c = between(random, -1, 1);
    return {uniform, few, grid<d>(), cospherical<d>()};
}

inline constexpr std::array strategies{Strategy::rebuild,   Strategy::relocate,   Strategy::relocate_flips,
                                       Strategy::in_place,  Strategy::tolerances, Strategy::tolerances_each,
                                       Strategy::automatic, Strategy::paper,      Strategy::paper_hybrid};

}  // namespace annulus::testing
