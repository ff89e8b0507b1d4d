// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/certificate_value.h>
#include <annulus/predicate/filtered_3.h>
#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

/// The filtered predicate for many certificates. out[i] is what the single call (`evaluate_orientation`,
/// `evaluate_empty_sphere`) gives for x[i], bit for bit. It is faster: the filter stage evaluates several side by side
/// (lanes.h), the interval stage handles all that is left inside one Rounding_guard, and the exact stage handles what
/// is still left. Nothing is allocated before the exact stage.
///
/// Preconditions: x.size() == out.size(), rounding to nearest. Returns how many answers each stage gave.
Stage_counts evaluate(std::span<const Tuple<2, 3>> x, Tolerance_precision mode, std::span<Certificate_value> out);
Stage_counts evaluate(std::span<const Tuple<2, 4>> x, Tolerance_precision mode, std::span<Certificate_value> out);
Stage_counts evaluate(std::span<const Tuple<3, 4>> x, Tolerance_precision mode, std::span<Certificate_value> out);
Stage_counts evaluate(std::span<const Tuple<3, 5>> x, Tolerance_precision mode, std::span<Certificate_value> out,
                      Cell_widths cells = Cell_widths::where_needed);

}  // namespace annulus::inline v1
