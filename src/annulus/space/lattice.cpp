// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/lattice.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/exact.h>
#include <annulus/arithmetic/wide_integer.h>
#include <annulus/error.h>
#include <annulus/space/dot.h>
#include <annulus/space/selling.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr int bits = 49;                // of the grid: 2^bits units are the power of two above the extent
constexpr double most_skew = 8;         // a coordinate of the box's vectors, in that power of two
constexpr double nearly_reduced = 2.5;  // a reach that reduced bases do not exceed
constexpr double most_images = 0x1p29;
constexpr int most_exponent = 150;
constexpr std::int64_t most_combined = 64;  // a factor of a vector of the box in one of the basis

template <int d>
using Vectors_of = typename Box<d>::Vectors;

/// The rows that give coordinates in this basis: row j times p is the j-th.
template <int d>
Vectors_of<d> dual_of(const Vectors_of<d>& basis) {
    const double whole = determinant_of_rows(basis);
    Vectors_of<d> dual;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) {
            Vectors_of<d> replaced = basis;
            replaced[j] = {};
            replaced[j][i] = 1;
            dual[j][i] = determinant_of_rows(replaced) / whole;
        }
    return dual;
}

template <int d>
Coordinates<d> combined(const std::array<std::int64_t, static_cast<std::size_t>(d)>& factors,
                        const Vectors_of<d>& vectors) {
    Coordinates<d> sum{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) sum[i] += static_cast<double>(factors[j]) * vectors[j][i];
    return sum;
}

/// Twice the largest coordinates in the basis, without sign, of the Voronoi cell of the lattice. Its vertices are the
/// circumcentres of the simplices 0, v, v + w, .. for the orders v, w, .. of an obtuse superbase.
template <int d>
Coordinates<d> reach_of(const Vectors_of<d>& dual, const Superbase<d>& superbase, const Vectors_of<d>& box) {
    std::array<std::size_t, static_cast<std::size_t>(d + 1)> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    Coordinates<d> reach{};
    do {
        // A centre c has c . y = |y|^2 / 2 for the other corners y.
        Vectors_of<d> corner;
        Coordinates<d> y{};
        for (std::size_t k = 0; k < d; ++k) {
            const Coordinates<d> v = combined<d>(superbase[order[k]], box);
            for (std::size_t i = 0; i < d; ++i) y[i] += v[i];
            corner[k] = y;
        }
        const Vectors_of<d> rows = dual_of<d>(corner);
        Coordinates<d> centre{};
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t i = 0; i < d; ++i) centre[i] += rows[k][i] * (dot<d>(corner[k], corner[k]) / 2);
        for (std::size_t j = 0; j < d; ++j) reach[j] = std::max(reach[j], 2 * std::fabs(dot<d>(dual[j], centre)));
    } while (std::next_permutation(order.begin(), order.end()));
    for (double& r : reach) r += 1e-6 * (1 + r);
    return reach;
}

[[noreturn]] void throw_skewed() {
    throw Error(Error_code::usage,
                "the box is too skewed: a vector is more than eight times as long along an axis as "
                "the extent of a reduced box of its lattice; reduce it first");
}

[[noreturn]] void throw_thin() {
    throw Error(Error_code::usage, "the box is too thin: coordinates in it have no digits left in doubles");
}

template <int d>
void require_finite(const Vectors_of<d>& box) {
    for (const auto& v : box)
        for (const double c : v) {
            if (!is_finite_number(c))
                throw Error(Error_code::not_finite, "a coordinate of a vector of the box is not a finite number");
            if (std::fabs(c) > std::ldexp(1.0, most_exponent))
                throw Error(Error_code::out_of_domain, "a coordinate of a vector of the box is larger than 2^150");
        }
}

/// The multiple of 1 nearest to the sum of terms, halves upward: exactly while fractions of the terms are multiples of
/// 2^-47, otherwise up to 2^-47 of a unit.
struct Rounded_sum {
    Int128 whole = 0;
    double fraction = 0;

    void add(double term) {
        const double below = std::floor(term);
        whole += static_cast<Int128>(below);
        fraction += term - below;
    }
    [[nodiscard]] Int128 nearest() const { return whole + static_cast<Int128>(std::floor(fraction + 0.5)); }
};

double rounded(double x, double grid) {
    Rounded_sum sum;
    sum.add(x / grid);
    return static_cast<double>(sum.nearest()) * grid;
}

template <int d>
int sign_of_determinant(const Vectors_of<d>& box) {
    std::vector<double> numbers;
    for (const auto& v : box) numbers.insert(numbers.end(), v.begin(), v.end());
    const Scaled_integers exactly(numbers);
    std::array<std::array<mpz_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> rows;
    for (std::size_t k = 0; k < numbers.size(); ++k) rows[k / d][k % d] = exactly.integer[k];
    return sgn(determinant_of_rows(rows));
}

}  // namespace

template <int d>
Lattice<d>::Lattice(const Vectors& box) : given_(box) {
    require_finite<d>(box);
    const Superbase<d> superbase = obtuse_superbase<d>(box);
    for (std::size_t j = 0; j < d; ++j) {
        to_box_[j] = {};
        to_box_[j][j] = 1;
    }
    reach_ = reach_of<d>(dual_of<d>(box), superbase, box);
    if (!std::all_of(reach_.begin(), reach_.end(), [](double r) { return r <= nearly_reduced; })) {
        std::copy_n(superbase.begin() + 1, d, to_box_.begin());
    }
    for (std::size_t j = 0; j < d; ++j) {
        for (const std::int64_t factor : to_box_[j])
            if (std::abs(factor) > most_combined) throw_skewed();
        basis_[j] = combined<d>(to_box_[j], box);
    }
    reach_ = reach_of<d>(dual_of<d>(basis_), superbase, box);
    choose_grid();
    for (const double r : reach_)
        if (!(r <= nearly_reduced + 0.1)) throw_thin();
    const int handed = sign_of_determinant<d>(box_);
    if (handed == 0 || handed != sign_of_determinant<d>(given_))
        throw Error(Error_code::usage, "the vectors of the box, rounded to 2^-49 of its extents, span no volume");
    // Exactly, in units of the grid.
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) {
            Int128 sum = 0;
            for (std::size_t k = 0; k < d; ++k)
                sum += Int128{to_box_[j][k]} * static_cast<std::int64_t>(box_[k][i] / grid_[i]);
            basis_[j][i] = static_cast<double>(sum) * grid_[i];
        }
    if (sign_of_determinant<d>(basis_) < 0)
        for (std::size_t i = 0; i < d; ++i) {
            basis_[d - 1][i] = -basis_[d - 1][i];
            to_box_[d - 1][i] = -to_box_[d - 1][i];
        }
    dual_ = dual_of<d>(basis_);
}

/// Of the unrounded basis; rounded it may need the next power of two, so that box() given again has the same grid or a
/// finer one.
template <int d>
void Lattice<d>::choose_grid() {
    for (std::size_t i = 0; i < d; ++i) {
        double extent = 0;
        for (std::size_t j = 0; j < d; ++j) extent += std::fabs(basis_[j][i]);
        if (!(extent >= std::ldexp(1.0, -most_exponent) && extent <= std::ldexp(1.0, most_exponent)))
            throw Error(Error_code::out_of_domain,
                        "the box extends along an axis by less than 2^-150 or more than 2^150");
        int exponent = std::ilogb(extent) + 1;
        if (extent > std::ldexp(1 - 0x1p-45, exponent)) ++exponent;
        grid_[i] = std::ldexp(1.0, exponent - bits);
        for (std::size_t j = 0; j < d; ++j) {
            if (std::fabs(given_[j][i]) > std::ldexp(most_skew, exponent)) throw_skewed();
            box_[j][i] = rounded(given_[j][i], grid_[i]);
        }
    }
}

template <int d>
double Lattice<d>::volume() const {
    return determinant_of_rows(basis_);
}

template <int d>
Coordinates<d> Lattice<d>::heights() const {
    Coordinates<d> h;
    for (std::size_t j = 0; j < d; ++j) {
        double largest = 0;
        for (const double c : dual_[j]) largest = std::max(largest, std::fabs(c));
        double sum = 0;
        for (const double c : dual_[j]) sum += (c / largest) * (c / largest);
        h[j] = 1 / (largest * std::sqrt(sum));
    }
    return h;
}

template <int d>
Coordinates<d> Lattice<d>::in_basis(const Coordinates<d>& p) const {
    Coordinates<d> f;
    for (std::size_t j = 0; j < d; ++j) f[j] = dot<d>(dual_[j], p);
    return f;
}

template <int d>
Coordinates<d> Lattice<d>::place(const Coordinates<d>& place, Offset<d> offset) const {
    if (offset.is_zero()) return place;
    const Shift<d> o = offset.unpacked();
    Coordinates<d> p = place;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) p[i] += o[j] * basis_[j][i];
    return p;
}

template <int d>
Shift<d> Lattice<d>::in_box(Offset<d> offset) const {
    const Shift<d> o = offset.unpacked();
    Shift<d> shift{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) shift[i] += o[j] * static_cast<std::int32_t>(to_box_[j][i]);
    return shift;
}

template <int d>
Representative<d> Lattice<d>::representative(const Coordinates<d>& p, std::int64_t i) const {
    for (const double c : p)
        if (!is_finite_number(c))
            throw Error(Error_code::not_finite,
                        "a coordinate of point " + std::to_string(i) + " is not a finite number", {i});
    Representative<d> r;
    std::array<std::int64_t, static_cast<std::size_t>(d)> image{};  // by vectors of the box
    Coordinates<d> left = p;
    for (int turn = 0; turn < 8; ++turn) {
        const Coordinates<d> f = in_basis(left);
        if (turn > 0 && std::all_of(f.begin(), f.end(), [](double c) { return c >= -0.5 && c < 1.5; })) return r;
        for (std::size_t j = 0; j < d; ++j) {
            const double k = std::floor(f[j]);
            if (!(std::fabs(k) <= most_images)) break;
            for (std::size_t c = 0; c < d; ++c) image[c] += static_cast<std::int64_t>(k) * to_box_[j][c];
        }
        for (std::size_t c = 0; c < d; ++c) {
            if (!(std::fabs(f[c]) <= most_images) || !(std::fabs(p[c] / grid_[c]) < 0x1p100) ||
                std::fabs(static_cast<double>(image[c])) > most_images)
                throw Error(Error_code::out_of_domain,
                            "point " + std::to_string(i) + " is more than 2^29 boxes away from the origin", {i});
            r.image[c] = static_cast<std::int32_t>(image[c]);
        }
        for (std::size_t c = 0; c < d; ++c) {
            Rounded_sum sum;
            sum.add(p[c] / grid_[c]);
            for (std::size_t j = 0; j < d; ++j) {
                if (image[j] == 0) continue;
                const double times = -static_cast<double>(image[j]);
                const double length = given_[j][c] / grid_[c];
                const double product = times * length;
                sum.add(product);
                sum.add(std::fma(times, length, -product));
            }
            r.place[c] = static_cast<double>(sum.nearest()) * grid_[c];
        }
        left = r.place;
    }
    throw_thin();
}

template <int d>
Coordinates<d> Lattice<d>::imaged(const Representative<d>& r) const {
    Coordinates<d> p;
    for (std::size_t i = 0; i < d; ++i) {
        Int128 sum = static_cast<std::int64_t>(r.place[i] / grid_[i]);
        for (std::size_t j = 0; j < d; ++j)
            sum += Int128{r.image[j]} * static_cast<std::int64_t>(box_[j][i] / grid_[i]);
        p[i] = static_cast<double>(sum) * grid_[i];
    }
    return p;
}

template class Lattice<2>;
template class Lattice<3>;

template <int d>
Box<d>::Box(const Vectors& vectors) : vectors_(vectors) {
    (void)Lattice<d>(vectors);
}

template <int d>
double Box<d>::volume() const noexcept {
    return std::fabs(determinant_of_rows(vectors_));
}

template class Box<2>;
template class Box<3>;

}  // namespace annulus::inline v1
