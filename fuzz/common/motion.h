// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The motions of operation.h: the next positions of all vertices. Plain doubles; nothing here needs to be exact.

#include "operation.h"

#include <functional>

namespace annulus::oracle {

template <int d>
using Sites_of = std::vector<std::optional<Coordinates<d>>>;  ///< by vertex index; empty for a free one

/// Fixed positions and tolerances.
template <int d>
struct Leeway {
    Coordinates<d> fixed{};
    double tolerance = 0.0;
};

/// Positions after step k = 0, 1 .. of the motion, which began at `source`; all different, in the domain, and for
/// free indices anything.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> next_positions(const Operation_of<d>& o, int k, const Sites_of<d>& source,
                                                         const Sites_of<d>& now,
                                                         const std::function<Leeway<d>(std::size_t)>& leeway);

/// Makes x the positions of a legal time step: vertices that would leave the domain or become duplicate points stay.
/// Positions at free indices are arbitrary, but follow from the seed.
template <int d>
void make_fit(std::vector<Coordinates<d>>& x, const Sites_of<d>& now, std::uint64_t seed);

/// p, or a position near it if p is outside the domain or the position of a vertex other than `self`.
template <int d>
[[nodiscard]] Coordinates<d> free_place(Coordinates<d> p, const Sites_of<d>& now, Index self);

/// The coordinates are finite and at most 2^500.
template <int d>
[[nodiscard]] std::optional<Error_code> domain_verdict(const Coordinates<d>& p);

/// A number that is a function of a seed and others.
[[nodiscard]] std::uint64_t hashed(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0);

}  // namespace annulus::oracle
