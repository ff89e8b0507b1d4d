// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// Escapes text for HTML, SVG or XML, between tags or in a quoted attribute. Control characters that XML forbids and
/// bytes that are not UTF-8 become U+FFFD, so the result is always well formed.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace annulus::inline v1
