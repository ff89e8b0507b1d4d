// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// As stages.h, in 3D.

#include <support/generators_3.h>
#include <support/stages.h>

namespace annulus::testing {

[[nodiscard]] inline Answers answers_of(const Tetrahedron& t) { return orientation_answers(t.tuple()); }
[[nodiscard]] inline Answers answers_of(const Bicell_3& c, Cell_widths cells) {
    return empty_sphere_answers(c.tuple(), cells);
}

inline constexpr std::array all_cells{Cell_widths::never, Cell_widths::where_needed, Cell_widths::always};

/// check(c) for `each` bi-cells of every family, with both signs.
template <class Check>
void for_each_bicell_3(const Random& random, int each, Check check) {
    for_each_case(
        all_families_3, random, each, [](auto family, Random& r) { return bicell(family, r); }, check);
}

/// check(c) for `each` bi-cells of every family, none with a point inside its sphere.
template <class Check>
void for_each_delaunay_bicell_3(const Random& random, int each, Check check) {
    for_each_case(
        all_families_3, random, each, [](auto family, Random& r) { return delaunay_bicell(family, r); }, check);
}

/// check(t) for `each` tetrahedra of every family, of both orientations.
template <class Check>
void for_each_tetrahedron(const Random& random, int each, Check check) {
    for_each_case(
        all_families_3, random, each, [](auto family, Random& r) { return tetrahedron(family, r); }, check);
}

}  // namespace annulus::testing
