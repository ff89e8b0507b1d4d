// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every stage of the ladder asked on its own, and loops over the families of generators.h.

#include <support/generators.h>

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/certificate/ladder_2.h>

#include <rapidcheck.h>

#include <optional>
#include <string>

/// RC_ASSERT that prints the case as code.
#define HOLDS(condition, x)                                                                       \
    do {                                                                                          \
        if (!(condition)) RC_FAIL(std::string(#condition) + "\n" + annulus::testing::as_code(x)); \
    } while (false)

namespace annulus::testing {

/// What each stage says of one certificate; nothing when it leaves the answer to the next.
struct Answers {
    std::optional<Verdict> filter;
    std::optional<Verdict> floating;  ///< the filter with certified = false
    std::optional<Verdict> interval;
    Verdict exact;
};

[[nodiscard]] inline Answers ask(const Bicell& c) {
    Answers a;
    Verdict v;
    if (empty_sphere_filter(c.tuple(), true, v)) a.filter = v;
    v = {};
    if (empty_sphere_filter(c.tuple(), false, v)) a.floating = v;
    {
        v = {};
        const Rounding_guard guard(FE_UPWARD);
        if (empty_sphere_interval(c.tuple(), v)) a.interval = v;
    }
    a.exact = empty_sphere_exact(c.tuple());
    return a;
}

[[nodiscard]] inline Answers ask(const Triangle& t) {
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

[[nodiscard]] inline Verdict ladder(const Bicell& c, bool certified = true) {
    return empty_sphere_verdict(c.tuple(), certified);
}
[[nodiscard]] inline Verdict ladder(const Triangle& t, bool certified = true) {
    return orientation_verdict(t.tuple(), certified);
}

/// check(c) for `each` bi-cells of every family, with both signs.
template <class Check>
void for_each_bicell(Random random, int each, Check check) {
    for (const Bicell_family family : all_bicell_families)
        for (int i = 0; i < each; ++i) check(bicell(family, random));
}

/// check(c) for `each` bi-cells of every family, none with a point inside its circle.
template <class Check>
void for_each_delaunay_bicell(Random random, int each, Check check) {
    for (const Bicell_family family : all_bicell_families)
        for (int i = 0; i < each; ++i) check(delaunay_bicell(family, random));
}

/// check(t) for `each` triangles of every family, of both orientations.
template <class Check>
void for_each_triangle(Random random, int each, Check check) {
    for (const Triangle_family family : all_triangle_families)
        for (int i = 0; i < each; ++i) check(triangle(family, random));
}

}  // namespace annulus::testing
