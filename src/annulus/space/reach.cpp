// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/reach.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/space/lattice.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

namespace {

template <int d>
using Rows = std::array<std::array<mpz_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)>;

/// -v . w for all pairs of the superbase, which is the conductance between two of d + 1 nodes.
template <int d>
using Conductances =
    std::array<std::array<mpz_class, static_cast<std::size_t>(d + 1)>, static_cast<std::size_t>(d + 1)>;

mpz_class integer(std::int64_t x) {
    static_assert(sizeof(long) == sizeof(std::int64_t));
    return {static_cast<long>(x)};
}

/// In the square of a unit.
template <int d>
Conductances<d> conductances(const Superbase<d>& superbase, const typename Box<d>::Vectors& basis) {
    std::vector<double> numbers;
    for (const auto& v : basis) numbers.insert(numbers.end(), v.begin(), v.end());
    const Scaled_integers exactly(numbers);
    std::array<std::array<mpz_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d + 1)> v;
    for (std::size_t k = 0; k <= d; ++k)
        for (std::size_t j = 0; j < d; ++j)
            if (superbase[k][j] != 0)
                for (std::size_t i = 0; i < d; ++i) v[k][i] += integer(superbase[k][j]) * exactly.integer[d * j + i];
    Conductances<d> p;
    for (std::size_t k = 0; k <= d; ++k)
        for (std::size_t l = 0; l < k; ++l) {
            for (std::size_t i = 0; i < d; ++i) p[k][l] -= v[k][i] * v[l][i];
            p[l][k] = p[k][l];
        }
    return p;
}

/// The potentials of all nodes but the first, which has 0, are a solution of these equations.
template <int d>
Rows<d> laplacian(const Conductances<d>& p) {
    Rows<d> rows;
    for (std::size_t k = 1; k <= d; ++k)
        for (std::size_t l = 0; l <= d; ++l) {
            if (l == k) continue;
            rows[k - 1][k - 1] += p[k][l];
            if (l > 0) rows[k - 1][l - 1] = -p[k][l];
        }
    return rows;
}

/// numerator / denominator, both positive, rounded upward, with a relative error of 2^-50 at most.
double quotient_upper(const mpz_class& numerator, const mpz_class& denominator) {
    constexpr int bits = 64;
    const mpz_class quotient = (numerator << bits) / denominator;
    return std::ldexp(quotient.get_d(), -bits) * (1 + 0x1p-50);
}

}  // namespace

template <int d>
Coordinates<d> reach_of(const Superbase<d>& superbase, const typename Box<d>::Vectors& basis) {
    const Conductances<d> p = conductances<d>(superbase, basis);
    const Rows<d> rows = laplacian<d>(p);
    const mpz_class whole = determinant_of_rows(rows);
    Coordinates<d> reach;
    for (std::size_t j = 0; j < d; ++j) {
        // Times `whole`, by Cramer's rule, where node k is a source of its coordinate j.
        std::array<mpz_class, static_cast<std::size_t>(d + 1)> potential;
        for (std::size_t k = 1; k <= d; ++k) {
            Rows<d> replaced = rows;
            for (std::size_t l = 1; l <= d; ++l) replaced[l - 1][k - 1] = integer(superbase[l][j]);
            potential[k] = determinant_of_rows(replaced);
        }
        mpz_class currents = 0;
        for (std::size_t k = 0; k <= d; ++k)
            for (std::size_t l = 0; l < k; ++l) currents += p[k][l] * abs(potential[k] - potential[l]);
        reach[j] = quotient_upper(currents, whole);
    }
    return reach;
}

template Coordinates<2> reach_of<2>(const Superbase<2>&, const Box<2>::Vectors&);
template Coordinates<3> reach_of<3>(const Superbase<3>&, const Box<3>::Vectors&);

}  // namespace annulus::inline v1
