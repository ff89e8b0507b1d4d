// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/basis_relation.h>
#include <annulus/space/for_each_shift.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// The vector of the lattice that is nearest to v; of several, one. The nearest one to 0 of the vectors that remain of
/// v has coordinates of 1.25 at most in the basis (Lattice::reach). It is computed without rounding where v has
/// coordinates of 6 at most there.
template <int d>
[[nodiscard]] Coordinates<d> nearest_vector(const Lattice<d>& lattice, const Coordinates<d>& v) {
    constexpr double clear = 1.0 / 32;  // no vector of a reduced basis is as near as 0 then
    const Coordinates<d> f = lattice.in_basis(v);
    if (std::all_of(f.begin(), f.end(), [](double c) { return std::fabs(c) < clear; })) return {};
    Coordinates<d> nearest{};
    double least = std::numeric_limits<double>::infinity();
    for_each_shift<d>(1, [&](const Shift<d>& o) {
        Coordinates<d> vector{};
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) vector[k] += (std::nearbyint(f[j]) + o[j]) * lattice.basis()[j][k];
        double squared = 0;
        for (std::size_t k = 0; k < d; ++k) squared += (v[k] - vector[k]) * (v[k] - vector[k]);
        if (squared < least) least = squared, nearest = vector;
    });
    return nearest;
}

/// The same in the vectors of the box.
template <int d>
[[nodiscard]] Shift<d> nearest_shift(const Lattice<d>& lattice, const Coordinates<d>& v) {
    const Coordinates<d> nearest = nearest_vector<d>(lattice, v);
    if (nearest == Coordinates<d>{}) return {};
    const Coordinates<d> turns = in_vectors<d>(lattice.box(), nearest);
    Shift<d> s;
    for (std::size_t i = 0; i < d; ++i) s[i] = static_cast<std::int32_t>(std::nearbyint(turns[i]));
    return s;
}

}  // namespace annulus::inline v1
