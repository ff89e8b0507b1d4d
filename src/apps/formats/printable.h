// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// Bytes of the well formed UTF-8 character that a text of at least one byte begins with; 0 when there is none
/// (surrogates, overlong forms).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Text as it may be shown on a terminal: control characters and bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace annulus::inline v1
