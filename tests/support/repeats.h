// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace annulus {

/// How often a test repeats what it would repeat n times, at least once: ANNULUS_TEST_MULTIPLIER times n. Properties of
/// RapidCheck follow the same variable (main.cpp); a loop that draws its own cases asks here.
inline int repeats(int n) {
    static const double multiplier = [] {
        const char* given = std::getenv("ANNULUS_TEST_MULTIPLIER");
        return given == nullptr ? 1.0 : std::atof(given);
    }();
    return std::max(1, static_cast<int>(std::lround(n * multiplier)));
}

}  // namespace annulus
