// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families.h"

#include <annulus/predicate/filtered_2.h>

#include <vector>

namespace annulus::link {

/// One certificate, as vectors.cpp needs it: points, what the filter computes on the way (the bounds as it forms them
/// from m; constants are folded exactly, so their order cannot be distinguished), and the answers of all stages.
struct Orientation_2 {
    static constexpr int d = 2;
    static constexpr std::size_t points = 3;
    static std::array<Coordinates<2>, 3> family(std::size_t i) {
        const auto x = bicell_2(i);
        return {x[0], x[1], x[3]};
    }
    static std::vector<double> terms(const Tuple<2, 3>& x) {
        const auto u = detail::difference(*x[1], *x[0]);
        const auto v = detail::difference(*x[2], *x[0]);
        const auto t = orientation_terms(u, v, detail::difference(*x[2], *x[1]));
        const double m = std::max(detail::magnitude(u), detail::magnitude(v));
        return {t.determinant,           t.inner, t.outer, m, bounds::orientation_2 * bounds::u * (m * m), 0.0,
                2.0 * std::sqrt(t.inner)};
    }
    static bool filter(const Tuple<2, 3>& x, bool certified, Certificate_value& out) {
        return orientation_filter(x, certified, out);
    }
    static bool interval(const Tuple<2, 3>& x, Certificate_value& out) { return orientation_interval(x, out); }
    static Certificate_value exact(const Tuple<2, 3>& x) { return orientation_exact(x); }
};

struct Empty_sphere_2 {
    static constexpr int d = 2;
    static constexpr std::size_t points = 4;
    static std::array<Coordinates<2>, 4> family(std::size_t i) { return bicell_2(i); }
    static std::vector<double> terms(const Tuple<2, 4>& x) {
        const auto b = detail::difference(*x[1], *x[0]);
        const auto p = detail::difference(*x[2], *x[0]);
        const auto q = detail::difference(*x[3], *x[0]);
        const auto e = detail::difference(*x[3], *x[2]);
        const auto t = annulus_terms(b, p, q, e);
        const double m = std::max(std::max(detail::magnitude(b), detail::magnitude(p)),
                                  std::max(detail::magnitude(q), detail::magnitude(e)));
        const double m2 = m * m;
        return {t.determinant,
                t.inner,
                t.outer,
                m,
                bounds::annulus_2_incircle * bounds::u * (m2 * m2),
                bounds::annulus_2_norms * bounds::u * (m2 * m),
                std::sqrt(t.inner) + std::sqrt(t.outer)};
    }
    static bool filter(const Tuple<2, 4>& x, bool certified, Certificate_value& out) {
        return empty_sphere_filter(x, certified, out);
    }
    static bool interval(const Tuple<2, 4>& x, Certificate_value& out) { return empty_sphere_interval(x, out); }
    static Certificate_value exact(const Tuple<2, 4>& x) { return empty_sphere_exact(x); }
};

}  // namespace annulus::link
