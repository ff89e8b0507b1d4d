// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/types.h>
#include <apps/experiment/hard_inputs.h>
#include <apps/experiment/tally.h>

#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// The results for one set of points.
struct Study {
    std::uint64_t vertices = 0;
    int affine_dimension = -1;
    double spacing = 0;     ///< mean spacing (measure/spacing.h), 0 where the points do not span the space
    double resolution = 0;  ///< the distance of doubles at the largest coordinate; in a box the grid's largest spacing
    Tally tally{};          ///< only "flat": 1 where the points do not span the space
};

/// Triangulates points and examines every certificate. `x` are distinct and in the domain, without -0; the hardest
/// inputs go to `hard`, with the seed. `threads`: how many examine certificates; results do not depend on it.
template <int d>
[[nodiscard]] Study study(std::vector<Coordinates<d>> x, std::uint64_t seed, Hard_inputs& hard, int threads);

/// The same in a periodic box, without hull ridges and the paper's tolerances. Points that are images of one another
/// are merged. `flat` is 1 without points only. Throws out_of_domain for a point more than 2^29 boxes away.
template <int d>
[[nodiscard]] Study study_in_box(std::vector<Coordinates<d>> x, const Box<d>& box, std::uint64_t seed,
                                 Hard_inputs& hard, int threads);

extern template Study study<2>(std::vector<Coordinates<2>>, std::uint64_t, Hard_inputs&, int);
extern template Study study<3>(std::vector<Coordinates<3>>, std::uint64_t, Hard_inputs&, int);
extern template Study study_in_box<2>(std::vector<Coordinates<2>>, const Box<2>&, std::uint64_t, Hard_inputs&, int);
extern template Study study_in_box<3>(std::vector<Coordinates<3>>, const Box<3>&, std::uint64_t, Hard_inputs&, int);

}  // namespace annulus::inline v1
