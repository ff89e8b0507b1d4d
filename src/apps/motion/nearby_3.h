// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// State that a caller of a domain's nearest-point query keeps from one query to the next: the distances from the
/// centre of a ball of all parts of the surface that reach into the ball. Filled and read by the domain, for queries of
/// this domain only; empty at first. At most 48 parts.
struct Nearby_3 {
    struct Part {
        double least;  ///< it is this far from the centre at least, up to rounding
        std::int32_t number;
    };
    Coordinates<3> centre{};
    double reach = 0;         ///< parts that are not listed are this far from the centre; 0 when nothing is known
    double depth = 0;         ///< how far the surface is from the centre
    std::int32_t last = -1;   ///< the part with the last answer, if there was one
    std::vector<Part> parts;  ///< by `least`
};

}  // namespace annulus::inline v1
