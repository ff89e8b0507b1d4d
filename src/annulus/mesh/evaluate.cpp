// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/evaluate.h>

#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/mesh/degenerate.h>

#include <limits>

namespace annulus {

namespace {

template <int d, std::size_t n>
Tuple<d, static_cast<int>(n)> pointers(const std::array<Coordinates<d>, n>& x) {
    Tuple<d, static_cast<int>(n)> t{};
    for (std::size_t k = 0; k < n; ++k) t[k] = &x[k];
    return t;
}

template <int d>
Verdict of_facet(Facet_kind kind, const std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)>& x) {
    if (kind == Facet_kind::nothing) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    if (kind == Facet_kind::empty_sphere) {
        const auto points = pointers<d>(x);
        Verdict out = empty_sphere_verdict(points);
        if (out.sign == 0) out.sign = static_cast<std::int8_t>(perturbed_sign(points));
        return out;
    }
    Tuple<d, d + 1> points{};
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = &x[k];
    Verdict out = orientation_verdict(points);
    if (out.sign == 0) out.sign = flat_ridge_holds(points) ? 1 : -1;
    return out;
}

}  // namespace

Verdict facet_verdict(Facet_kind kind, const std::array<Coordinates<2>, 4>& x) { return of_facet<2>(kind, x); }
Verdict facet_verdict(Facet_kind kind, const std::array<Coordinates<3>, 5>& x) { return of_facet<3>(kind, x); }

Verdict cell_verdict(const std::array<Coordinates<2>, 3>& x) { return orientation_verdict(pointers<2>(x)); }
Verdict cell_verdict(const std::array<Coordinates<3>, 4>& x) { return orientation_verdict(pointers<3>(x)); }

double annulus_width_lower(const std::array<Coordinates<2>, 4>& x) {
    return 2.0 * empty_sphere_verdict(pointers<2>(x)).tolerance;
}
double annulus_width_lower(const std::array<Coordinates<3>, 5>& x) {
    return 2.0 * empty_sphere_verdict(pointers<3>(x), true, Cell_widths::never).tolerance;
}

double bicell_theta(const std::array<Coordinates<2>, 4>& x) { return theta(x[0], x[1], x[2], x[3]); }
double bicell_theta(const std::array<Coordinates<3>, 5>& x) { return theta(x[0], x[1], x[2], x[3], x[4]); }

}  // namespace annulus
