// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// 3D point sets that are hard to triangulate, and harder to keep triangulated while they move.

#include <support/generators.h>

namespace annulus::testing {

enum class Set_3 {
    uniform,
    lattice,        ///< small integers: cospherical, coplanar, collinear
    cube,           ///< corners of boxes and prisms
    sphere,         ///< integer points of one norm, most of them on the hull
    near_sphere,    ///< a sphere, off by 2^-20 to 2^-60: hull-heavy, near-cospherical
    rough_sphere,   ///< a sphere or a small cap of it, off by 2^-10 to 2^-40
    noisy_lattice,  ///< small integers, off by a few ulps
    plane,          ///< all in one plane
    near_plane,     ///< off a plane by 2^-50 to 2^-10
    line,           ///< all on one line
    clustered,      ///< clusters of very different sizes
    slivers,        ///< four and more nearly cocircular points at a time
    subnormal,      ///< every coordinate a multiple of 2^-1074 below 2^-1022
    huge,           ///< magnitude up to 2^500
    far_offset,     ///< integer spacing, far (2^40) from the origin
    mixed_scales,   ///< every coordinate of another magnitude, anywhere in the domain
    scaled,         ///< one of the others, scaled by a power of two between 2^-400 and 2^400
};
inline constexpr std::array all_sets_3{
    Set_3::uniform,      Set_3::lattice,       Set_3::cube,      Set_3::sphere,     Set_3::near_sphere,
    Set_3::rough_sphere, Set_3::noisy_lattice, Set_3::plane,     Set_3::near_plane, Set_3::line,
    Set_3::clustered,    Set_3::slivers,       Set_3::subnormal, Set_3::huge,       Set_3::far_offset,
    Set_3::mixed_scales, Set_3::scaled};
[[nodiscard]] std::string_view name_of(Set_3 set);

using Points_3 = std::vector<Coordinates<3>>;

/// n distinct points of the family in random order.
[[nodiscard]] Points_3 point_set(Set_3 set, std::size_t n, Random& random);

/// A definition of the points ready to paste.
[[nodiscard]] std::string as_code(const Points_3& points);

}  // namespace annulus::testing
