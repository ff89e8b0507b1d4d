// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The worst moves of a certificate. A determinant vanishes when its points are on one hyperplane, or on one sphere; the
// smallest such move squeezes them onto the median of two parallel hyperplanes, or of two concentric spheres, that pass
// through the parts A and B of a partition (docs/theory.md 2). Here every such pair is computed from its definition, in
// 2D and in 3D, in rational numbers or, where only a direction is needed, in doubles. Nothing is shared with the
// library.

#include <annulus/types.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::testing {

/// T is mpq_class or double.
template <class T, int d>
using Vector_of = std::array<T, static_cast<std::size_t>(d)>;

template <int d, std::size_t n>
using Points_of_certificate = std::array<Coordinates<d>, n>;

template <class T>
using Root_of = std::conditional_t<std::is_same_v<T, double>, double, mpf_class>;

/// Two parallel hyperplanes or concentric spheres, one through A and one through B.
template <class T, int d, std::size_t n>
struct Squeeze {
    unsigned part;          ///< A: the points whose bits are set
    bool inner;             ///< for spheres: whether A is on the inner one
    Root_of<T> half_width;  ///< half the distance between the two
    /// Unit vectors from each point to the median, as doubles: off by a few units in their last place.
    Points_of_certificate<d, n> direction;
};

namespace squeezing {

inline constexpr mp_bitcnt_t precision = 320;

template <class T, std::size_t d>
T dot(const std::array<T, d>& u, const std::array<T, d>& v) {
    T sum = u[0] * v[0];
    for (std::size_t k = 1; k < d; ++k) sum += u[k] * v[k];
    return sum;
}
template <class T, std::size_t d>
std::array<T, d> difference(const std::array<T, d>& to, const std::array<T, d>& from) {
    std::array<T, d> v;
    for (std::size_t k = 0; k < d; ++k) v[k] = to[k] - from[k];
    return v;
}
/// The vector perpendicular to d - 1 others whose product with u is the determinant with u in front.
template <class T>
std::array<T, 2> normal(const std::array<std::array<T, 2>, 1>& v) {
    return {v[0][1], T(-v[0][0])};
}
template <class T>
std::array<T, 3> normal(const std::array<std::array<T, 3>, 2>& v) {
    std::array<T, 3> n;
    for (std::size_t k = 0; k < 3; ++k)
        n[k] = v[0][(k + 1) % 3] * v[1][(k + 2) % 3] - v[0][(k + 2) % 3] * v[1][(k + 1) % 3];
    return n;
}
/// The normal of all rows but row i, with the sign of its place in the determinant.
template <class T, std::size_t d>
std::array<T, d> cofactors(const std::array<std::array<T, d>, d>& rows, std::size_t i) {
    std::array<std::array<T, d>, d - 1> others;
    for (std::size_t k = 1; k < d; ++k) others[k - 1] = rows[(i + k) % d];
    std::array<T, d> n = normal(others);
    if (d == 2 && i == 1)
        for (T& x : n) x = -x;
    return n;
}

inline Root_of<mpq_class> root(const mpq_class& x) {
    const mpf_class r(x, precision);
    return sqrt(r);
}
inline double root(double x) { return std::sqrt(x); }
inline mpf_class real(const mpq_class& x) { return {x, precision}; }
inline double real(double x) { return x; }

/// v / |v| times `sense`.
template <class T, std::size_t d>
std::array<double, d> unit_vector(const std::array<T, d>& v, int sense) {
    T largest(0);
    for (const T& x : v) largest = std::max(largest, T(x < 0 ? T(-x) : x));
    std::array<double, d> u{};
    if (largest == 0) return u;
    double square = 0;
    for (std::size_t k = 0; k < d; ++k) {
        const T share = v[k] / largest;
        if constexpr (std::is_same_v<T, double>) u[k] = share;
        else u[k] = share.get_d();
        square += u[k] * u[k];
    }
    for (double& x : u) x *= sense / std::sqrt(square);
    return u;
}

/// Points relative to the first. As doubles they are scaled by a power of two, so that nothing overflows: the scale
/// is returned.
template <class T, int d, std::size_t n>
std::array<Vector_of<T, d>, n> relative(const Points_of_certificate<d, n>& x, int& exponent) {
    std::array<Vector_of<T, d>, n> y;
    exponent = 0;
    if constexpr (std::is_same_v<T, double>) {
        double largest = 0;
        for (const auto& p : x)
            for (std::size_t k = 0; k < p.size(); ++k) largest = std::max(largest, std::fabs(p[k] - x[0][k]));
        if (largest > 0) exponent = std::ilogb(largest);
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < y[i].size(); ++k) {
            if constexpr (std::is_same_v<T, double>) y[i][k] = std::ldexp(x[i][k] - x[0][k], -exponent);
            else y[i][k] = mpq_class(x[i][k]) - mpq_class(x[0][k]);
        }
    return y;
}
inline void scale(double& x, int exponent) { x = std::ldexp(x, exponent); }
inline void scale(mpf_class&, int) {}

/// Differences inside the two parts, and the first point of each: all that is needed of the partition.
template <class T, int d, std::size_t n>
struct Parts {
    std::array<Vector_of<T, d>, n - 2> rows;
    std::size_t first = n, other = n;  ///< in A, in B

    Parts(const std::array<Vector_of<T, d>, n>& y, unsigned part) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t& front = (part >> i & 1U) != 0 ? first : other;
            if (front == n) front = i;
            else rows[count++] = difference(y[i], y[front]);
        }
    }
};

/// The squeeze between parallel hyperplanes with normal v.
template <class T, int d, std::size_t n>
std::optional<Squeeze<T, d, n>> between_planes(const std::array<Vector_of<T, d>, n>& y, unsigned part,
                                               const Parts<T, d, n>& parts, const Vector_of<T, d>& v) {
    const T norm = dot(v, v);
    if (norm == 0) return std::nullopt;
    const T height = dot(v, difference(y[parts.other], y[parts.first]));
    using std::abs;
    Squeeze<T, d, n> s{part, false, Root_of<T>(abs(real(height)) / (2 * root(norm))), {}};
    const auto u = unit_vector(v, height < 0 ? -1 : 1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < u.size(); ++k) s.direction[i][k] = (part >> i & 1U) != 0 ? u[k] : -u[k];
    return s;
}

/// The squeeze between concentric spheres; between planes where their centre is at infinity.
template <class T, int d, std::size_t n>
std::optional<Squeeze<T, d, n>> between_spheres(const std::array<Vector_of<T, d>, n>& y, unsigned part) {
    const Parts<T, d, n> parts(y, part);
    // Each row: equally far from the first point of the part and from another.
    std::array<T, d> side;
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (i != parts.first && i != parts.other) {
            const std::size_t front = (part >> i & 1U) != 0 ? parts.first : parts.other;
            side[count++] = (dot(y[i], y[i]) - dot(y[front], y[front])) / 2;
        }
    const T determinant = dot(parts.rows[0], cofactors(parts.rows, 0));
    if (determinant == 0) {
        for (std::size_t i = 0; i < d; ++i)
            if (auto s = between_planes<T, d, n>(y, part, parts, cofactors(parts.rows, i))) return s;
        return std::nullopt;
    }
    Vector_of<T, d> centre{};
    for (std::size_t i = 0; i < d; ++i) {
        const auto c = cofactors(parts.rows, i);
        for (std::size_t k = 0; k < d; ++k) centre[k] += side[i] * c[k] / determinant;
    }
    const auto a = difference(y[parts.first], centre), b = difference(y[parts.other], centre);
    const T inner = dot(a, a), outer = dot(b, b);
    const T gap = outer - inner;
    using std::abs;
    Squeeze<T, d, n> s{part, gap > 0, Root_of<T>(abs(real(gap)) / (2 * (root(inner) + root(outer)))), {}};
    for (std::size_t i = 0; i < n; ++i) {
        const bool in_part = (part >> i & 1U) != 0;
        s.direction[i] = unit_vector(difference(y[i], centre), in_part == (gap > 0) ? 1 : -1);
    }
    return s;
}

}  // namespace squeezing

/// All slabs of a simplex: 3 in 2D, 7 in 3D.
template <class T, int d>
[[nodiscard]] std::vector<Squeeze<T, d, d + 1>> slabs(const Points_of_certificate<d, d + 1>& x) {
    int exponent = 0;
    const auto y = squeezing::relative<T, d, d + 1>(x, exponent);
    std::vector<Squeeze<T, d, d + 1>> all;
    for (unsigned part = 1; part < (1U << d); ++part) {
        const squeezing::Parts<T, d, d + 1> parts(y, part);
        auto s = squeezing::between_planes<T, d, d + 1>(y, part, parts, squeezing::normal(parts.rows));
        if (!s) continue;
        squeezing::scale(s->half_width, exponent);
        all.push_back(*s);
    }
    return all;
}

/// The annuli of a bi-cell {facet.., p, q}, A of two points of the facet at least: 1 in 2D, 4 in 3D. That
/// of the whole facet comes last.
template <class T, int d>
[[nodiscard]] std::vector<Squeeze<T, d, d + 2>> annuli(const Points_of_certificate<d, d + 2>& x) {
    int exponent = 0;
    const auto y = squeezing::relative<T, d, d + 2>(x, exponent);
    std::vector<Squeeze<T, d, d + 2>> all;
    for (unsigned part = 1; part < (1U << d); ++part) {
        if ((part & (part - 1)) == 0) continue;
        auto s = squeezing::between_spheres<T, d, d + 2>(y, part);
        if (!s) continue;
        squeezing::scale(s->half_width, exponent);
        all.push_back(*s);
    }
    return all;
}

/// The slabs of one cell of a bi-cell, whose other opposite vertex rests: `at` says where the points of the cell are
/// in x.
template <class T, int d>
[[nodiscard]] std::vector<Squeeze<T, d, d + 2>> slabs_of_cell(const Points_of_certificate<d, d + 2>& x, bool with_q) {
    Points_of_certificate<d, d + 1> cell;
    std::copy_n(x.begin(), d, cell.begin());
    cell[d] = x[with_q ? d + 1 : d];
    std::vector<Squeeze<T, d, d + 2>> all;
    for (const Squeeze<T, d, d + 1>& s : slabs<T, d>(cell)) {
        Squeeze<T, d, d + 2> wide{s.part, false, s.half_width, {}};
        std::copy_n(s.direction.begin(), d, wide.direction.begin());
        wide.direction[with_q ? d + 1 : d] = s.direction[d];
        all.push_back(wide);
    }
    return all;
}

// Compiled once, in squeezes.cpp: rational numbers take a second.
extern template std::vector<Squeeze<mpq_class, 2, 3>> slabs<mpq_class, 2>(const Points_of_certificate<2, 3>& x);
extern template std::vector<Squeeze<mpq_class, 3, 4>> slabs<mpq_class, 3>(const Points_of_certificate<3, 4>& x);
extern template std::vector<Squeeze<mpq_class, 2, 4>> annuli<mpq_class, 2>(const Points_of_certificate<2, 4>& x);
extern template std::vector<Squeeze<mpq_class, 3, 5>> annuli<mpq_class, 3>(const Points_of_certificate<3, 5>& x);
extern template std::vector<Squeeze<double, 2, 3>> slabs<double, 2>(const Points_of_certificate<2, 3>& x);
extern template std::vector<Squeeze<double, 3, 4>> slabs<double, 3>(const Points_of_certificate<3, 4>& x);
extern template std::vector<Squeeze<double, 2, 4>> annuli<double, 2>(const Points_of_certificate<2, 4>& x);
extern template std::vector<Squeeze<double, 3, 5>> annuli<double, 3>(const Points_of_certificate<3, 5>& x);

template <class Squeezes>
[[nodiscard]] const auto& least_of(const Squeezes& all) {
    return *std::min_element(all.begin(), all.end(),
                             [](const auto& l, const auto& r) { return l.half_width < r.half_width; });
}

}  // namespace annulus::testing
