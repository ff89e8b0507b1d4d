// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/stage.h>
#include <annulus/certificate/ladder_3.h>
#include <annulus/certificate/verdict.h>

#include <span>

namespace annulus {

/// Which answer is wanted of a batch.
enum class Mode : std::uint8_t {
    floating,  ///< exact sign, tolerance in plain double where the filter knows the sign
    fast,      ///< certified lower bound of the first stage that answers within bounds::filter_slack
    tight,     ///< the largest double that is not above the truth: the exact stage for every certificate that holds
};

/// The ladder for many certificates: out[i] is what the single call (`orientation_verdict`, `empty_sphere_verdict`) gives for x[i],
/// bit for bit; faster, because the filter stage evaluates several side by side (lanes.h), the interval stage is asked for all that is left
/// inside one Rounding_guard, and the exact stage for what is left then. Nothing is allocated before the exact stage.
///
/// Preconditions: x.size() == out.size(), rounding to nearest. Returns how many answers each stage gave.
Stage_counts evaluate(std::span<const Tuple<2, 3>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<2, 4>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<3, 4>> x, Mode mode, std::span<Verdict> out);
Stage_counts evaluate(std::span<const Tuple<3, 5>> x, Mode mode, std::span<Verdict> out,
                      Cells cells = Cells::where_needed);

}  // namespace annulus
