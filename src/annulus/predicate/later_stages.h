// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/arithmetic/stage.h>

#include <cstddef>

namespace annulus {

/// The stages after the first, for certificates 0, ..., n - 1: what is open(i) is asked of intervals, inside one
/// Rounding_guard, and what is open still of integers. interval(i) says whether it answered, and then i is open no
/// more. Returns how many each answered.
///
/// What interval() computes it computes from memory, in functions that are not inlined (rounding_guard.h).
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

}  // namespace annulus
