// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/types.h>

#include <cstddef>

namespace annulus::inline v1 {

/// The stages after the filter, for certificates 0, ..., n - 1. Calls interval(i) for each i that is open(i), inside
/// one Rounding_guard. It returns whether it answered; then i must no longer be open. Calls exact(i) for each i that
/// is still open. Returns how many each stage answered.
///
/// interval() must compute from memory, in functions that are not inlined (rounding_guard.h).
template <class Open, class Interval, class Exact>
Stage_counts later_stages(std::size_t n, Open open, Interval interval, Exact exact) {
    Stage_counts counts;
    std::size_t left = 0;
    {
        const Rounding_guard guard(FE_UPWARD);
        for (std::size_t i = 0; i < n; ++i)
            if (open(i)) ++(interval(i) ? counts.interval : left);
    }
    counts.exact = left;
    for (std::size_t i = 0; left > 0 && i < n; ++i) {
        if (!open(i)) continue;
        exact(i);
        --left;
    }
    return counts;
}

}  // namespace annulus::inline v1
