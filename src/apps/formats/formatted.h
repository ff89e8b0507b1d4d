// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace annulus::inline v1 {

/// What std::printf would write: numbers with a fixed number of digits, in messages and pages. The compiler compares
/// the format with the arguments. (The shortest decimal of a double is in decimal.h.)
[[nodiscard]] [[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace annulus::inline v1
