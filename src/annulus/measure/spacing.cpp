// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/spacing.h>

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

double determinant(const std::array<double, 2>& u, const std::array<double, 2>& v) { return u[0] * v[1] - u[1] * v[0]; }
double determinant(const std::array<double, 3>& u, const std::array<double, 3>& v, const std::array<double, 3>& w) {
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Computed from the content of all cells in a unit that is a power of two near the extent of the points.
template <int d>
double spacing_of(const Corner_table<d>& t, std::span<const Coordinates<d>> x) {
    double extent = 0;
    for (const auto& p : x)
        for (std::size_t c = 0; c < d; ++c) extent = std::max(extent, std::fabs(p[c] - x[0][c]));
    const int exponent = std::ilogb(extent);
    double content = 0;
    for (const Cell_index c : t.finite_cells()) {
        const Cell_vertices<d> v = cell_vertices(t, c);
        const auto at = [&](Index i) -> const Coordinates<d>& { return x[static_cast<std::size_t>(i)]; };
        const auto scaled_minus = [exponent](double a, double b) { return std::scalbn(a - b, -exponent); };
        const auto edge = [&](std::size_t i) { return Euclidean<d>::difference(at(v[i]), at(v[0]), scaled_minus); };
        if constexpr (d == 2) content += determinant(edge(1), edge(2)) / 2;
        else content += determinant(edge(1), edge(2), edge(3)) / 6;
    }
    const double each = content / static_cast<double>(x.size());
    return std::scalbn(d == 2 ? std::sqrt(each) : std::cbrt(each), exponent);
}

template <int d>
double resolution_of(std::span<const Coordinates<d>> x) {
    double largest = 0;
    for (const auto& p : x)
        for (const double c : p) largest = std::max(largest, std::fabs(c));
    return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

}  // namespace

double mean_spacing(const Corner_table<2>& t, std::span<const Coordinates<2>> x) { return spacing_of<2>(t, x); }
double mean_spacing(const Corner_table<3>& t, std::span<const Coordinates<3>> x) { return spacing_of<3>(t, x); }
double resolution(std::span<const Coordinates<2>> x) { return resolution_of<2>(x); }
double resolution(std::span<const Coordinates<3>> x) { return resolution_of<3>(x); }

}  // namespace annulus::inline v1
