// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/certificate_value.h>

namespace annulus::inline v1 {

/// A sign, and the stage that decided it.
struct Staged_sign {
    std::int8_t sign;
    Stage stage;
    bool of_any_size = false;  ///< decided by integers of any size, on the heap: many times the cost of other stages
};

// Exact signs of certificates where no tolerance is needed and the filter stage could not decide: integers of fixed
// width (integer_signs.h), which cost less than intervals; where the points span too many bits for these, intervals,
// then integers of any size. A fraction of the cost of a value, which needs the widths too. Points are in the order of
// the filtered predicate.

[[nodiscard]] Staged_sign exact_orientation_sign(const Tuple<2, 3>& x);
[[nodiscard]] Staged_sign exact_orientation_sign(const Tuple<3, 4>& x);
/// Positive when the sphere is empty. Precondition: both cells are positive.
[[nodiscard]] Staged_sign exact_empty_sphere_sign(const Tuple<2, 4>& x);
[[nodiscard]] Staged_sign exact_empty_sphere_sign(const Tuple<3, 5>& x);

}  // namespace annulus::inline v1
