// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families.h"

#include <annulus/certificate/ladder_2.h>

namespace annulus::link {

/// The bounds as a filter forms them from m; constants are folded exactly, so their order cannot be told apart.
struct Errors {
    double determinant;
    double norms;
};

/// One certificate, as vectors.cpp wants it: its points and everything the library computes of them.
struct Orientation_2 {
    static constexpr int d = 2;
    static constexpr std::size_t points = 3;
    static std::array<Coordinates<2>, 3> family(std::size_t i) {
        const auto x = bicell_2(i);
        return {x[0], x[1], x[3]};
    }
    static Width_terms<double> terms(const Tuple<2, 3>& x) {
        return orientation_terms(detail::difference(*x[1], *x[0]), detail::difference(*x[2], *x[0]),
                                 detail::difference(*x[2], *x[1]));
    }
    static double magnitude(const Tuple<2, 3>& x) {
        return std::max(detail::magnitude(detail::difference(*x[1], *x[0])),
                        detail::magnitude(detail::difference(*x[2], *x[0])));
    }
    static Errors errors(double m) { return {bounds::orientation_2 * bounds::u * (m * m), 0.0}; }
    static bool filter(const Tuple<2, 3>& x, bool certified, Verdict& out) { return orientation_filter(x, certified, out); }
    static bool interval(const Tuple<2, 3>& x, Verdict& out) { return orientation_interval(x, out); }
    static Verdict exact(const Tuple<2, 3>& x) { return orientation_exact(x); }
};

struct Empty_sphere_2 {
    static constexpr int d = 2;
    static constexpr std::size_t points = 4;
    static std::array<Coordinates<2>, 4> family(std::size_t i) { return bicell_2(i); }
    static Width_terms<double> terms(const Tuple<2, 4>& x) {
        return annulus_terms(detail::difference(*x[1], *x[0]), detail::difference(*x[2], *x[0]),
                             detail::difference(*x[3], *x[0]), detail::difference(*x[3], *x[2]));
    }
    static double magnitude(const Tuple<2, 4>& x) {
        const auto of = [&](std::size_t i, std::size_t j) { return detail::magnitude(detail::difference(*x[i], *x[j])); };
        return std::max(std::max(of(1, 0), of(2, 0)), std::max(of(3, 0), of(3, 2)));
    }
    static Errors errors(double m) {
        const double m2 = m * m;
        const double m3 = m2 * m;
        return {bounds::annulus_2_incircle * bounds::u * (m2 * m2), bounds::annulus_2_norms * bounds::u * m3};
    }
    static bool filter(const Tuple<2, 4>& x, bool certified, Verdict& out) { return empty_sphere_filter(x, certified, out); }
    static bool interval(const Tuple<2, 4>& x, Verdict& out) { return empty_sphere_interval(x, out); }
    static Verdict exact(const Tuple<2, 4>& x) { return empty_sphere_exact(x); }
};

}  // namespace annulus::link
