// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <vector>

namespace annulus::inline v1 {

/// What the certificates of a triangulation measure at given positions, in the caller's unit of length.
struct Measures {
    std::vector<double> tolerance;      ///< by vertex index: least certified tolerance of its certificates; infinite at
                                        ///< free indices and where the points are flat
    std::vector<double> annulus_width;  ///< certified width of the annulus of every finite bi-cell: the standard one
                                        ///< in 2D, the least of four in 3D
    double theta_min = 1.5707963267948966;  ///< least theta of a finite bi-cell in radians
};

}  // namespace annulus::inline v1
