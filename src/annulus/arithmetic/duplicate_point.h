// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace annulus::inline v1 {

/// The error "points 3 and 15 have the same position" or "vertices 3 and 15 would have the same position", with both
/// indices.
[[nodiscard]] inline Error duplicate_point_error(const char* what, const char* have, std::int64_t a, std::int64_t b) {
    const auto [first, second] = std::minmax(a, b);
    return {Error_code::duplicate_point,
            std::string(what) + " " + std::to_string(first) + " and " + std::to_string(second) + " " + have +
                " the same position",
            {first, second}};
}

}  // namespace annulus::inline v1
