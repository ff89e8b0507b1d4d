// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/stage.h>
#include <annulus/certificate/ladder_3.h>
#include <annulus/certificate/verdict.h>

#include <span>

namespace annulus {

/// The ladder for many certificates: out[i] is what the single call (`orientation_verdict`, `empty_sphere_verdict`)
/// gives for x[i], bit for bit; faster, because the filter stage evaluates several side by side (lanes.h), the
/// interval stage is asked for all that is left inside one Rounding_guard, and the exact stage for what is left then.
/// Nothing is allocated before the exact stage.
///
/// Preconditions: x.size() == out.size(), rounding to nearest. Returns how many answers each stage gave.
Stage_counts evaluate(std::span<const Tuple<2, 3>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<2, 4>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<3, 4>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<3, 5>> x, Mode mode, std::span<Verdict> out,
                      Cell_widths cells = Cell_widths::where_needed);

}  // namespace annulus
