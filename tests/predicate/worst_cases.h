// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The greatest errors that any climb has found.

#include "filter_errors.h"

#include <string_view>

namespace annulus::testing {

struct Worst_case {
    std::string_view climb;  ///< its name in climbs()
    double reached;          ///< bit for bit, on every machine and with every compiler
    Numbers x;
};

[[nodiscard]] const std::vector<Worst_case>& worst_cases();

/// The greatest stored value of a climb.
[[nodiscard]] double greatest_kept(std::string_view climb);

/// Prints a line for worst_cases.cpp and returns true if x is worse than the stored case.
bool report_if_worse(std::string_view climb, double reached, const Numbers& x);

/// Climbs `name` twice from random starts and returns the greatest value found, NaN if that is above the bound. Prints
/// cases that are worse than the stored one.
[[nodiscard]] double climb_from_anywhere(std::string_view name, std::size_t dimension, int steps, Random& random);

}  // namespace annulus::testing
