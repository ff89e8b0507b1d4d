// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The kinds of motions that motions.h makes.

#include <array>
#include <cstddef>
#include <string_view>

namespace annulus::testing {

enum class Motion_kind {
    shear,         ///< x += rate * y, back where the shear has become large
    rotation,      ///< as a whole, about an axis
    drift,         ///< all points move straight, reflected by the walls of the box
    common_drift,  ///< all points move away together, a few at their own pace
    breathing,     ///< every axis swells and shrinks at its own pace
    orbits,        ///< every point on its own circle
    flow,          ///< a steady divergence-free flow
    reversal,      ///< a drift that turns round every 4,094 to 4,098 steps
    acceleration,  ///< a drift from 1e-9 to 1e-1 spacings a step, and again
    settling,      ///< steps that shrink until nothing changes any more, then a new start
    growth,        ///< from 2^-60 to 2^60 and back
    jitter,        ///< again around the same places
    bursts,        ///< rest, and now and then a few steps that are large, or a vertex far away
    teleports,     ///< one vertex a step to any place
    few_movers,    ///< one to three vertices walk, then others
    rest_and_go,   ///< a drift that stops for a while and goes on
    oscillation,   ///< a grid that is perturbed and becomes exactly a grid again
    cocircular,    ///< the same of points that are exactly on one circle or sphere
    sliding,       ///< rows of a grid slide along each other, by exact fractions of the spacing
    clusters,      ///< a walk in clusters of very different sizes
    walk_tiny,     ///< random walks: steps of 1e-6 spacings
    walk_small,    ///< 1e-3
    walk_middle,   ///< 0.03
    walk_large,    ///< 1
};
inline constexpr std::array all_motions{
    Motion_kind::shear,        Motion_kind::rotation,   Motion_kind::drift,       Motion_kind::common_drift,
    Motion_kind::breathing,    Motion_kind::orbits,     Motion_kind::flow,        Motion_kind::reversal,
    Motion_kind::acceleration, Motion_kind::settling,   Motion_kind::growth,      Motion_kind::jitter,
    Motion_kind::bursts,       Motion_kind::teleports,  Motion_kind::few_movers,  Motion_kind::rest_and_go,
    Motion_kind::oscillation,  Motion_kind::cocircular, Motion_kind::sliding,     Motion_kind::clusters,
    Motion_kind::walk_tiny,    Motion_kind::walk_small, Motion_kind::walk_middle, Motion_kind::walk_large};

[[nodiscard]] constexpr std::string_view name_of(Motion_kind kind) {
    constexpr std::array<std::string_view, all_motions.size()> names{
        "shear",   "rotation",  "drift",        "common-drift", "breathing",   "orbits",
        "flow",    "reversal",  "acceleration", "settling",     "growth",      "jitter",
        "bursts",  "teleports", "few-movers",   "rest-and-go",  "oscillation", "cocircular",
        "sliding", "clusters",  "walk-tiny",    "walk-small",   "walk-middle", "walk-large"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace annulus::testing
