// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/evaluate.h>

#include <annulus/mesh/degenerate.h>
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/theta.h>

#include <limits>

namespace annulus::inline v1 {

namespace {

template <int d, std::size_t n>
Tuple<d, static_cast<int>(n)> pointers(const std::array<Coordinates<d>, n>& x) {
    Tuple<d, static_cast<int>(n)> t{};
    for (std::size_t k = 0; k < n; ++k) t[k] = &x[k];
    return t;
}

template <int d>
Certificate_value of_facet(Facet_kind kind, const std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)>& x) {
    if (kind == Facet_kind::nothing) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    if (kind == Facet_kind::empty_sphere) {
        const auto points = pointers<d>(x);
        Certificate_value out = evaluate_empty_sphere(points);
        if (out.sign == 0) out.sign = static_cast<std::int8_t>(perturbed_sign(points));
        return out;
    }
    Tuple<d, d + 1> points{};
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = &x[k];
    Certificate_value out = evaluate_orientation(points);
    if (out.sign == 0) out.sign = flat_ridge_holds(points) ? 1 : -1;
    return out;
}

}  // namespace

Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<2>, 4>& x) {
    return of_facet<2>(kind, x);
}
Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<3>, 5>& x) {
    return of_facet<3>(kind, x);
}

Certificate_value evaluate_cell(const std::array<Coordinates<2>, 3>& x) { return evaluate_orientation(pointers<2>(x)); }
Certificate_value evaluate_cell(const std::array<Coordinates<3>, 4>& x) { return evaluate_orientation(pointers<3>(x)); }

double annulus_width_lower(const std::array<Coordinates<2>, 4>& x) {
    return 2.0 * evaluate_empty_sphere(pointers<2>(x)).tolerance;
}
double annulus_width_lower(const std::array<Coordinates<3>, 5>& x) {
    return 2.0 * evaluate_empty_sphere(pointers<3>(x), true, Cell_widths::never).tolerance;
}

double bicell_theta(const std::array<Coordinates<2>, 4>& x) { return theta(x[0], x[1], x[2], x[3]); }
double bicell_theta(const std::array<Coordinates<3>, 5>& x) { return theta(x[0], x[1], x[2], x[3], x[4]); }

}  // namespace annulus::inline v1
