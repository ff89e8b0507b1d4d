// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/stage.h>
#include <annulus/space/places.h>

#include <cstdint>
#include <string_view>

namespace annulus::inline v1 {

/// Which number is used as the tolerance of a certificate.
enum class Tolerance_kind : std::uint8_t {
    certified,  ///< a proved lower bound
    paper,      ///< the standard annulus and parallel hyperplanes in plain double, no certificates of cells
    floating,   ///< the same certificates and formulas as `certified`, in plain double without error bounds
};

[[nodiscard]] constexpr std::string_view name_of(Tolerance_kind kind) {
    return kind == Tolerance_kind::certified ? "certified" : kind == Tolerance_kind::paper ? "paper" : "floating";
}

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
