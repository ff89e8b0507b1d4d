// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace annulus::inline v1 {

/// JSON as a file: keys in their order, indented by 2, a line end at the end. Doubles read back bit for bit; NaN and
/// infinities become null; bytes that are not UTF-8 become U+FFFD instead of an exception.
[[nodiscard]] std::string write_json(const nlohmann::ordered_json& value);

}  // namespace annulus::inline v1
