// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace annulus {

/// The number of repetitions of a loop that has n by default: ANNULUS_TEST_MULTIPLIER times n, at least 1. Properties
/// of RapidCheck follow the same variable (main.cpp); loops that draw their own cases call this function.
inline int repeats(int n) {
    static const double multiplier = [] {
        const char* given = std::getenv("ANNULUS_TEST_MULTIPLIER");
        return given == nullptr ? 1.0 : std::atof(given);
    }();
    return std::max(1, static_cast<int>(std::lround(n * multiplier)));
}

}  // namespace annulus
