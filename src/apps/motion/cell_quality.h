// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Shape of a tetrahedron in plain doubles, of either orientation. Angles are in degrees. Flat ones have ratio 0, an
/// infinite aspect, and dihedral angles of 0 and 180 where a facet has no area.
struct Cell_quality {
    double volume = 0;
    double radius_ratio = 0;  ///< 3 r / R of the inscribed and the circumscribed sphere: 1 if regular, 0 if flat
    double aspect = 0;        ///< longest edge / (2 sqrt(6) r): 1 if regular
    double dihedral_min = 0;
    double dihedral_max = 0;
    double plane_min = 0;  ///< of the angles of its four facets
};
[[nodiscard]] Cell_quality cell_quality(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                        const Coordinates<3>& d);

/// Shape of a triangle in 3D.
struct Triangle_quality {
    double radius_ratio = 0;  ///< 2 r / R: 1 if equilateral, 0 if flat
    double aspect = 0;        ///< longest edge / (2 sqrt(3) r): 1 if equilateral
    double angle_min = 0;     ///< degrees
};
[[nodiscard]] Triangle_quality triangle_quality(const Coordinates<3>& a, const Coordinates<3>& b,
                                                const Coordinates<3>& c);

/// The numbers of the `count` cells with the least dihedral angles (of all, if there are fewer), the worst first; of
/// equal ones the lower number first. O(n log count).
[[nodiscard]] std::vector<std::size_t> worst_cells(std::span<const Cell_quality> cells, std::size_t count);

}  // namespace annulus::inline v1
