// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// As stages.h, in space.

#include <support/generators_3.h>
#include <support/stages.h>

#include <annulus/certificate/ladder_3.h>

namespace annulus::testing {

[[nodiscard]] inline Answers ask(const Tetrahedron& t) {
    Answers a;
    Verdict v;
    if (orientation_filter(t.tuple(), true, v)) a.filter = v;
    v = {};
    if (orientation_filter(t.tuple(), false, v)) a.floating = v;
    {
        v = {};
        const Rounding_guard guard(FE_UPWARD);
        if (orientation_interval(t.tuple(), v)) a.interval = v;
    }
    a.exact = orientation_exact(t.tuple());
    return a;
}

[[nodiscard]] inline Answers ask(const Bicell_3& c, Cells cells) {
    Answers a;
    Verdict v;
    if (empty_sphere_filter(c.tuple(), true, v, cells)) a.filter = v;
    v = {};
    if (empty_sphere_filter(c.tuple(), false, v, cells)) a.floating = v;
    {
        v = {};
        const Rounding_guard guard(FE_UPWARD);
        if (empty_sphere_interval(c.tuple(), v, cells)) a.interval = v;
    }
    a.exact = empty_sphere_exact(c.tuple(), cells);
    return a;
}

inline constexpr std::array all_cells{Cells::never, Cells::where_needed, Cells::always};

/// check(c) for `each` bi-cells of every family, with both signs.
template <class Check>
void for_each_bicell_3(Random random, int each, Check check) {
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < each; ++i) check(bicell(family, random));
}

/// check(c) for `each` bi-cells of every family, none with a point inside its sphere.
template <class Check>
void for_each_delaunay_bicell_3(Random random, int each, Check check) {
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < each; ++i) check(delaunay_bicell(family, random));
}

/// check(t) for `each` tetrahedra of every family, of both orientations.
template <class Check>
void for_each_tetrahedron(Random random, int each, Check check) {
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < each; ++i) check(tetrahedron(family, random));
}

}  // namespace annulus::testing
