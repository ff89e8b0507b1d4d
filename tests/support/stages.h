// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Every stage of the filtered predicate evaluated separately, and loops over the families of generators.h.

#include <support/generators.h>

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/predicate/filtered.h>

#include <rapidcheck.h>

#include <optional>
#include <string>

/// RC_ASSERT that prints the case as code.
#define HOLDS(condition, x)                                                                       \
    do {                                                                                          \
        if (!(condition)) RC_FAIL(std::string(#condition) + "\n" + annulus::testing::as_code(x)); \
    } while (false)

namespace annulus::testing {

/// The result of each stage for one certificate; none when the stage does not decide.
struct Answers {
    std::optional<Certificate_value> filter;
    std::optional<Certificate_value> floating;  ///< the filter with certified = false
    std::optional<Certificate_value> interval;
    Certificate_value exact;
};

/// filter(certified, verdict), interval(verdict), exact(): the stages for one certificate.
template <class Filter, class Interval, class Exact>
[[nodiscard]] Answers evaluate_stages(Filter filter, Interval interval, Exact exact) {
    Answers a;
    Certificate_value v;
    if (filter(true, v)) a.filter = v;
    v = {};
    if (filter(false, v)) a.floating = v;
    {
        v = {};
        const Rounding_guard guard(FE_UPWARD);
        if (interval(v)) a.interval = v;
    }
    a.exact = exact();
    return a;
}

/// The stages of an orientation, in 2D or in 3D.
template <class Points>
[[nodiscard]] Answers orientation_answers(const Points& x) {
    return evaluate_stages([&](bool certified, Certificate_value& v) { return orientation_filter(x, certified, v); },
                           [&](Certificate_value& v) { return orientation_interval(x, v); },
                           [&] { return orientation_exact(x); });
}
/// The stages of an empty sphere; in 3D `cells` selects the cells whose widths count.
template <class Points, class... Cells>
[[nodiscard]] Answers empty_sphere_answers(const Points& x, Cells... cells) {
    return evaluate_stages(
        [&](bool certified, Certificate_value& v) { return empty_sphere_filter(x, certified, v, cells...); },
        [&](Certificate_value& v) { return empty_sphere_interval(x, v, cells...); },
        [&] { return empty_sphere_exact(x, cells...); });
}

[[nodiscard]] inline Answers answers_of(const Bicell& c) { return empty_sphere_answers(c.tuple()); }
[[nodiscard]] inline Answers answers_of(const Triangle& t) { return orientation_answers(t.tuple()); }

[[nodiscard]] inline Certificate_value all_stages(const Bicell& c, bool certified = true) {
    return evaluate_empty_sphere(c.tuple(), certified);
}
[[nodiscard]] inline Certificate_value all_stages(const Triangle& t, bool certified = true) {
    return evaluate_orientation(t.tuple(), certified);
}

/// check(generate(family, random)), `each` times for every family.
template <class Families, class Generate, class Check>
void for_each_case(const Families& families, Random random, int each, Generate generate, Check check) {
    for (const auto family : families)
        for (int i = 0; i < each; ++i) check(generate(family, random));
}

/// check(c) for `each` bi-cells of every family, with both signs.
template <class Check>
void for_each_bicell(const Random& random, int each, Check check) {
    for_each_case(
        all_bicell_families, random, each, [](auto family, Random& r) { return bicell(family, r); }, check);
}

/// check(c) for `each` bi-cells of every family, none with a point inside its circle.
template <class Check>
void for_each_delaunay_bicell(const Random& random, int each, Check check) {
    for_each_case(
        all_bicell_families, random, each, [](auto family, Random& r) { return delaunay_bicell(family, r); }, check);
}

/// check(t) for `each` triangles of every family, of both orientations.
template <class Check>
void for_each_triangle(const Random& random, int each, Check check) {
    for_each_case(
        all_triangle_families, random, each, [](auto family, Random& r) { return triangle(family, r); }, check);
}

}  // namespace annulus::testing
