// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/places.h>
#include <annulus/types.h>

#include <cstdint>

namespace annulus::inline v1 {

/// How precise a tolerance has to be.
enum class Tolerance_precision : std::uint8_t {
    approximate,        ///< exact sign, tolerance in plain double where the filter decides the sign
    lower_bound,        ///< certified lower bound of the first stage that answers within its slack (bounds.h)
    correctly_rounded,  ///< the largest double not above the truth: the exact stage for every certificate that holds
};

/// What is known of one certificate at given positions.
struct Certificate_value {
    double tolerance = 0.0;       ///< lower bound of half the width (unit of length); 0 unless sign > 0
    std::int8_t sign = 0;         ///< exact sign of the determinant
    Stage stage = Stage::filter;  ///< the stage that decided
    std::uint8_t wrong_side = 0;  ///< empty spheres in 3D: bit k if partition k may be on the wrong side (filtered_3.h)
};

}  // namespace annulus::inline v1
