// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/lattice.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/exact.h>
#include <annulus/arithmetic/wide_integer.h>
#include <annulus/error.h>
#include <annulus/space/reach.h>
#include <annulus/space/rounded_sum.h>
#include <annulus/space/selling.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr int bits = 49;                // of the grid: 2^bits units are the power of two above the extent
constexpr double most_skew = 8;         // a coordinate of the box's vectors, in that power of two
constexpr double nearly_reduced = 2.5;  // a reach that reduced bases do not exceed
constexpr double still_reduced = 2.6;   // the same after rounding
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

[[noreturn]] void throw_skewed() {
    throw Error(Error_code::usage,
                "the box is too skewed: a vector is more than eight times as long along an axis as "
                "the extent of a reduced box of its lattice; reduce it first");
}

template <int d>
bool is_reduced(const Coordinates<d>& reach, double limit) {
    return std::all_of(reach.begin(), reach.end(), [limit](double r) { return r <= limit; });
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

/// Where rounding a thin box to the grid makes another lattice of it.
template <int d>
void Lattice<d>::throw_thin() {
    throw Error(Error_code::usage,
                "the box is too thin in a direction that is not along an axis: its vectors, rounded to 2^-49 of its "
                "extents, are another lattice's. Down to a millionth of its length any direction is possible");
}

template <int d>
Lattice<d>::Lattice(const Vectors& box) : given_(box) {
    require_finite<d>(box);
    const Superbase<d> superbase = obtuse_superbase<d>(box);
    for (std::size_t j = 0; j < d; ++j) {
        to_box_[j] = {};
        to_box_[j][j] = 1;
    }
    if (!is_reduced<d>(reach_of<d>(superbase, box), nearly_reduced))
        std::copy_n(superbase.begin() + 1, d, to_box_.begin());
    for (std::size_t j = 0; j < d; ++j) basis_[j] = combined<d>(to_box_[j], box);
    choose_grid();
    round_box();
    require_combinations();
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
    choose_reach();
}

/// A factor is large where the box is skewed, and where rounding it to doubles already has made another lattice of it.
template <int d>
void Lattice<d>::require_combinations() const {
    const auto is_large = [](std::int64_t factor) { return factor > most_combined || factor < -most_combined; };
    if (std::none_of(to_box_.begin(), to_box_.end(),
                     [&](const auto& row) { return std::any_of(row.begin(), row.end(), is_large); }))
        return;
    Vectors coarse = basis_;
    for (auto& v : coarse)
        for (std::size_t i = 0; i < d; ++i) v[i] = rounded(v[i], grid_[i]);
    if (sign_of_determinant<d>(coarse) == 0 ||
        !is_reduced<d>(reach_of<d>(obtuse_superbase<d>(coarse), coarse), still_reduced))
        throw_thin();
    throw Error(Error_code::usage,
                "the box is too skewed: a reduced box of its lattice takes one of its vectors more than " +
                    std::to_string(most_combined) + " times; reduce it first");
}

/// Of the rounded lattice. In a box that is thin in a direction that is no axis the rounded basis may be far from
/// reduced, and the dual basis is off by what its determinant rounds: as much as a vector's own coordinates are, which
/// are to be those of a row of the unit matrix.
template <int d>
void Lattice<d>::choose_reach() {
    reach_ = reach_of<d>(obtuse_superbase<d>(basis_), basis_);
    rounding_ = {};
    for (std::size_t k = 0; k < d; ++k) {
        const Coordinates<d> f = in_basis(basis_[k]);
        for (std::size_t j = 0; j < d; ++j) rounding_[j] += 8 * std::fabs(f[j] - (j == k ? 1 : 0));
    }
    for (std::size_t j = 0; j < d; ++j) {
        double terms = 0;  // a place's coordinates are below 2^50.6 units of the grid
        for (std::size_t i = 0; i < d; ++i) terms += std::fabs(dual_[j][i]) * std::ldexp(grid_[i], 51);
        rounding_[j] += 0x1p-45 * (1 + terms);
        reach_[j] += rounding_[j];
        if (!(reach_[j] <= still_reduced)) throw_thin();
    }
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
    }
}

template <int d>
void Lattice<d>::round_box() {
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) {
            if (std::fabs(given_[j][i]) > std::ldexp(most_skew * grid_[i], bits)) throw_skewed();
            box_[j][i] = rounded(given_[j][i], grid_[i]);
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

template class Lattice<2>;
template class Lattice<3>;

}  // namespace annulus::inline v1
