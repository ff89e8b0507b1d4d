// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families.h"

#include <annulus/predicate/filtered_3.h>

#include <vector>

namespace annulus::link {

/// As in certificates_2.h.
struct Orientation_3 {
    static constexpr int d = 3;
    static constexpr std::size_t points = 4;
    static std::array<Coordinates<3>, 4> family(std::size_t i) {
        const auto x = bicell_3(i);
        return {x[0], x[1], x[2], x[4]};
    }
    static std::vector<double> terms(const Tuple<3, 4>& x) {
        const auto u = detail::difference(*x[1], *x[0]);
        const auto v = detail::difference(*x[2], *x[0]);
        const auto w = detail::difference(*x[3], *x[0]);
        const auto t = orientation_terms(u, v, w);
        const double m = std::max(std::max(detail::magnitude(u), detail::magnitude(v)), detail::magnitude(w));
        const double m2 = m * m;
        return {t.determinant,
                t.inner,
                t.outer,
                m,
                bounds::orientation_3 * bounds::u * (m2 * m),
                bounds::orientation_3_norms * bounds::u * m2,
                2.0 * std::sqrt(t.inner)};
    }
    static bool filter(const Tuple<3, 4>& x, bool certified, Certificate_value& out) {
        return orientation_filter(x, certified, out);
    }
    static bool interval(const Tuple<3, 4>& x, Certificate_value& out) { return orientation_interval(x, out); }
    static Certificate_value exact(const Tuple<3, 4>& x) { return orientation_exact(x); }
};

struct Empty_sphere_3 {
    static constexpr int d = 3;
    static constexpr std::size_t points = 5;
    static std::array<Coordinates<3>, 5> family(std::size_t i) { return bicell_3(i); }
    static std::vector<double> terms(const Tuple<3, 5>& x) {
        const auto b = detail::difference(*x[1], *x[0]);
        const auto c = detail::difference(*x[2], *x[0]);
        const auto p = detail::difference(*x[3], *x[0]);
        const auto q = detail::difference(*x[4], *x[0]);
        const auto t = annulus_terms(b, c, p, q);
        const double m = std::max(std::max(detail::magnitude(b), detail::magnitude(c)),
                                  std::max(detail::magnitude(p), detail::magnitude(q)));
        const double m2 = m * m;
        std::vector<double> out{t.determinant,
                                t.cell_p,
                                t.cell_q,
                                m,
                                bounds::annulus_3_insphere * bounds::u * (m2 * m2 * m),
                                bounds::annulus_3_norms * bounds::u * (m2 * m2),
                                bounds::annulus_3_side * bounds::u * (m2 * m)};
        for (std::size_t k = 0; k < partitions_3; ++k) out.insert(out.end(), {t.inner[k], t.outer[k], t.side[k]});
        return out;
    }
    static bool filter(const Tuple<3, 5>& x, bool certified, Certificate_value& out) {
        return empty_sphere_filter(x, certified, out);
    }
    static bool interval(const Tuple<3, 5>& x, Certificate_value& out) { return empty_sphere_interval(x, out); }
    static Certificate_value exact(const Tuple<3, 5>& x) { return empty_sphere_exact(x); }
};

}  // namespace annulus::link
