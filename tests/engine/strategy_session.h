// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A strategy on a triangulation of a few points, whose private state is accessible: tests write numbers there that
// moves would seldom produce.

#include <support/arbitrary.h>

#include <annulus/engine/tolerance_strategy.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/published/paper_strategy.h>

#include <gmpxx.h>

#include <cmath>
#include <utility>
#include <vector>

namespace annulus::testing {

/// Private members, by name: access is not checked where a template is instantiated explicitly.
#define REVEAL(Name, ...)                                      \
    struct Name {};                                            \
    constexpr auto member(Name);                               \
    template <auto pointer>                                    \
    struct Name##_revealed {                                   \
        friend constexpr auto member(Name) { return pointer; } \
    };                                                         \
    template struct Name##_revealed<__VA_ARGS__>

using Rational = mpq_class;
inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

inline Rational exact_squared_distance(const Point& a, const Point& b) {
    const Rational x = Rational(a[0]) - Rational(b[0]), y = Rational(a[1]) - Rational(b[1]);
    return x * x + y * y;
}

/// The largest double not above x > 0.
inline double rounded_down(const Rational& x) {
    double r = std::nextafter(x.get_d(), HUGE_VAL);
    while (Rational(r) > x) r = std::nextafter(r, 0.0);
    return r;
}

/// A triangulation of a few points with a strategy on it. Point 0 is the origin.
template <class Kept>
struct Session {
    std::vector<Point> points;
    Delaunay_mesh<2> mesh;
    Kept strategy;
    Move_result report;

    template <class... Arguments>
    explicit Session(Random& random, Arguments... arguments)
        : points(point_set(Family::uniform, 7, random)), strategy(mesh, arguments...) {
        points[0] = {0.0, 0.0};
        mesh.build(points);
        strategy.recompute_tolerances(points, report);
    }
    template <class Name>
    auto& operator[](Name) {
        return strategy.*member(Name{});
    }
    template <class Name, class... Arguments>
    auto call(Name, Arguments&&... arguments) {
        return (strategy.*member(Name{}))(std::forward<Arguments>(arguments)...);
    }
    [[nodiscard]] std::vector<Cell_index> finite_cells() {
        std::vector<Cell_index> cells;
        for (const Cell_index c : mesh.table().finite_cells()) cells.push_back(c);
        return cells;
    }
};

}  // namespace annulus::testing
