// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>

namespace annulus::inline v1 {

/// Appends the shortest decimal that reads back as the same double ("nan", "inf", "-inf" for those).
void append_decimal(std::string& out, double value);

/// Appends an integer.
template <std::integral T>
void append_decimal(std::string& out, T value) {
    out += std::to_string(value);
}

/// The shortest decimal that reads back as the same double.
[[nodiscard]] std::string decimal(double value);

}  // namespace annulus::inline v1
