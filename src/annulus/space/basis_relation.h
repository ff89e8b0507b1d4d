// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace annulus::inline v1 {

template <int d>
using Integer_matrix = std::array<std::array<std::int64_t, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)>;

/// m with row k replaced.
template <class Rows, class Row>
[[nodiscard]] Rows with_row(Rows m, std::size_t k, const Row& row) {
    m[k] = row;
    return m;
}

/// Coordinates in these vectors, by Cramer's rule.
template <int d>
[[nodiscard]] Coordinates<d> in_vectors(const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& vectors,
                                        const Coordinates<d>& p) {
    const double whole = determinant_of_rows(vectors);
    Coordinates<d> f;
    for (std::size_t k = 0; k < d; ++k) f[k] = determinant_of_rows(with_row(vectors, k, p)) / whole;
    return f;
}

/// The inverse of a matrix of determinant 1 or -1.
template <int d>
[[nodiscard]] Integer_matrix<d> unimodular_inverse(const Integer_matrix<d>& m, std::int64_t determinant) {
    Integer_matrix<d> w{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) {
            std::array<std::int64_t, static_cast<std::size_t>(d)> unit{};
            unit[j] = 1;
            w[j][i] = determinant * determinant_of_rows(with_row(m, i, unit));
        }
    return w;
}

/// How vectors of a lattice are written in others, which a lattice that is nearly the same has.
template <int d>
struct Basis_relation {
    Integer_matrix<d> to_new;  ///< row j: old vector j as a combination of the new ones
    std::int64_t determinant;  ///< 1 or -1
};

/// By the new vectors in the old ones, rounded to the nearest integers: `in_old` has the coordinates of a vector in
/// these. Nothing where one is greater than `most` in magnitude, or the matrix of them is not unimodular.
template <int d, class In_old>
[[nodiscard]] std::optional<Basis_relation<d>> basis_relation(
    const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& new_vectors, double most, In_old in_old) {
    Integer_matrix<d> new_in_old{};
    for (std::size_t j = 0; j < d; ++j) {
        const Coordinates<d> f = in_old(new_vectors[j]);
        for (std::size_t i = 0; i < d; ++i) {
            const double k = std::nearbyint(f[i]);
            if (!(std::fabs(k) <= most)) return {};
            new_in_old[j][i] = static_cast<std::int64_t>(k);
        }
    }
    const std::int64_t determinant = determinant_of_rows(new_in_old);
    if (determinant != 1 && determinant != -1) return {};
    return Basis_relation<d>{unimodular_inverse<d>(new_in_old, determinant), determinant};
}

}  // namespace annulus::inline v1
