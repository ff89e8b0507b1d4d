// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// A finite number of an option. Throws Error(usage), also where it is beyond what a double can hold.
[[nodiscard]] double parse_number(const std::string& option, std::string_view word);
/// The numbers of an option, separated by commas. Throws Error(usage).
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, std::string_view words);

}  // namespace annulus::inline v1
