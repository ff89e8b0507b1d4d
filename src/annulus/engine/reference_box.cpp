// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/reference_box.h>

#include <annulus/engine/displacement.h>
#include <annulus/space/rounded_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double roundoff = 0x1p-53;
constexpr double rounded_up = 1 + 64 * roundoff;  // more than what a few operations round
constexpr double most_offset = 16;                // of a site of a bi-cell, at any time
constexpr double most_coordinate = 2.5;           // of a place and of a goal, in the basis (docs/theory.md 8.7)
constexpr double most_deviation = 4;              // of a sum: later readings would round tolerances away
constexpr double error_of_extent = 0x1p-41;       // a hundred times what is usual
constexpr double least_singular = 31.0 / 32;

template <int d>
using Matrix_of = std::array<Coordinates<d>, static_cast<std::size_t>(d)>;

/// All eigenvalues of X^T X are within `spread` of `mean`.
struct Squares {
    double mean, spread;
};
/// The lesser of two bounds of the norm of a symmetric matrix: by rows, and by the sum of squares. Each entry is
/// off by 3.01 u times the sum of the squares of all entries of X, which is `size`.
template <int d>
Squares squares_of(const Matrix_of<d>& x) {
    Matrix_of<d> g{};
    double size = 0;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) g[i][j] += x[k][i] * x[k][j];
    for (std::size_t i = 0; i < d; ++i) size += g[i][i];
    const double mean = size / d;
    double most = 0, sum = 0;
    for (std::size_t i = 0; i < d; ++i) {
        double row = 0;
        for (std::size_t j = 0; j < d; ++j) {
            const double off = i == j ? g[i][j] - mean : g[i][j];
            row += std::fabs(off);
            sum += off * off;
        }
        most = std::max(most, row);
    }
    return {mean, std::min(most, std::sqrt(sum)) * rounded_up + 16 * roundoff * size};
}

template <int d>
double norm_upper(const Matrix_of<d>& x) {
    double sum = 0;
    for (const auto& row : x)
        for (const double c : row) sum += c * c;
    return std::sqrt(sum) * rounded_up;
}

/// The inverse, in doubles.
Matrix_of<2> inverse(const Matrix_of<2>& m) {
    const double whole = determinant_of_rows(m);
    return {{{m[1][1] / whole, -m[0][1] / whole}, {-m[1][0] / whole, m[0][0] / whole}}};
}
Matrix_of<3> inverse(const Matrix_of<3>& m) {
    const double whole = determinant_of_rows(m);
    Matrix_of<3> w;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            w[j][i] = (m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                       m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3]) /
                      whole;
    return w;
}

template <int d>
Matrix_of<d> product(const Matrix_of<d>& a, const Matrix_of<d>& b) {
    Matrix_of<d> c{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}

/// Upper bounds of the entries of C - A B: what is computed, and what that may be off by.
template <int d>
Matrix_of<d> remainder_upper(const Matrix_of<d>& c, const Matrix_of<d>& a, const Matrix_of<d>& b) {
    Matrix_of<d> r{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) {
            double left = c[i][j], size = std::fabs(c[i][j]);
            for (std::size_t k = 0; k < d; ++k) {
                left -= a[i][k] * b[k][j];
                size += std::fabs(a[i][k] * b[k][j]);
            }
            r[i][j] = (std::fabs(left) + 8 * roundoff * size) * rounded_up;
        }
    return r;
}

template <int d>
Matrix_of<d> transposed(const Matrix_of<d>& a) {
    Matrix_of<d> t;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) t[i][j] = a[j][i];
    return t;
}

}  // namespace

/// With squares of singular values from m - s to m + s, e = (greatest - least) / (greatest + least) is at most
/// 2 s / (sum of roots)^2, the sum's square at least 4 m - 2 s. X may be off, which moves each singular value by as
/// much. ½ ln of the ratio is artanh e, below e + e^3 up to a half.
template <int d>
double deviation_upper(const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& x, double off) {
    const Squares q = squares_of<d>(x);
    if (!(q.spread < 0.25 * q.mean)) return std::numeric_limits<double>::infinity();
    const double least = std::sqrt(q.mean - q.spread) * (1 - 8 * roundoff);
    const double e = (q.spread / (2 * q.mean - q.spread) + off / (least - off)) * rounded_up;
    if (!(off < 0.25 * least && e < 0.5)) return std::numeric_limits<double>::infinity();
    return (e + e * e * e) * rounded_up;
}

template <int d>
bool is_nearly_rigid(const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& x) {
    constexpr double low = 0.9385, high = 1.0634;  // (31/32)^2 = 0.93847.., (33/32)^2 = 1.06347..
    const Squares q = squares_of<d>(x);
    return q.mean - q.spread > low && q.mean + q.spread < high;
}

template <int d>
void Reference_box<d>::begin(const Lattice<d>& lattice) {
    reference_ = lattice.basis();
    grid_ = lattice.grid();
    map_ = map_of(lattice);
    deviation_ = 0;
    double squares = 0;
    for (std::size_t i = 0; i < d; ++i) {
        double extent = 0;
        for (const auto& v : reference_) extent += std::fabs(v[i]);
        squares += extent * extent;
    }
    error_ = 2 * error_of_extent * std::sqrt(squares) * rounded_up;
}

/// Any matrix would do that takes the present basis to the reference nearly: is_accurate() says how nearly.
template <int d>
auto Reference_box<d>::map_of(const Lattice<d>& lattice) const -> Matrix {
    Matrix map{};
    if (lattice.basis() == reference_) {
        for (std::size_t i = 0; i < d; ++i) map[i][i] = 1;
        return map;
    }
    for (std::size_t k = 0; k < d; ++k) {
        Coordinates<d> unit{};
        unit[k] = 1;
        const Coordinates<d> f = lattice.in_basis(unit);
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < d; ++j) map[i][k] += f[j] * reference_[j][i];
    }
    return map;
}

/// Whether the co-moving places of sites are right up to half of error_: what comoving() and anchor() round, and what
/// the map makes wrong of the basis, times offsets.
template <int d>
bool Reference_box<d>::is_accurate(const Matrix& map, const Lattice<d>& lattice) const {
    const Matrix basis = transposed<d>(lattice.basis()), reference = transposed<d>(reference_);  // vectors as columns
    const Matrix wrong = remainder_upper<d>(reference, map, basis);
    double squares = 0;
    for (std::size_t i = 0; i < d; ++i) {
        double off = grid_[i];
        for (std::size_t k = 0; k < d; ++k) {
            double extent = 0;
            for (std::size_t j = 0; j < d; ++j) extent += std::fabs(basis[k][j]);
            off += 8 * roundoff * std::fabs(map[i][k]) * most_coordinate * extent + most_offset * wrong[i][k];
        }
        squares += off * off;
    }
    return std::sqrt(squares) * rounded_up < error_ / 2;
}

template <int d>
bool Reference_box<d>::follow(const Lattice<d>& lattice) {
    const Matrix map = map_of(lattice);
    if (map != map_) {
        if (!is_nearly_rigid<d>(map)) return false;
        // What takes this box to the one before. The other product, as long as a step, is of no map between boxes.
        const Matrix step = product<d>(inverse(map_), map);
        const double off = norm_upper<d>(remainder_upper<d>(map, map_, step)) / least_singular * rounded_up;
        deviation_ = sum_upper(deviation_, annulus::deviation_upper<d>(step, off));
        map_ = map;
    }
    return deviation_ < most_deviation && is_accurate(map, lattice);
}

template <int d>
Coordinates<d> Reference_box<d>::anchor(const Coordinates<d>& place) const {
    Coordinates<d> z = comoving(place);
    for (std::size_t i = 0; i < d; ++i) z[i] = rounded(z[i], grid_[i]);
    return z;
}

/// The site stays where it is, so its vertex goes back by what its offsets have grown.
template <int d>
Coordinates<d> Reference_box<d>::relabelled(const Coordinates<d>& anchor, Offset<d> more) const {
    const Shift<d> o = more.unpacked();
    Coordinates<d> z = anchor;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) z[i] -= o[j] * reference_[j][i];
    return z;
}

template class Reference_box<2>;
template class Reference_box<3>;
template double deviation_upper<2>(const std::array<Coordinates<2>, 2>&, double);
template double deviation_upper<3>(const std::array<Coordinates<3>, 3>&, double);
template bool is_nearly_rigid<2>(const std::array<Coordinates<2>, 2>&);
template bool is_nearly_rigid<3>(const std::array<Coordinates<3>, 3>&);

}  // namespace annulus::inline v1
