// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The error "points 3 and 15 have the same position" or "vertices 3, 8 and 15 would have the same position", with all
/// indices. Precondition: two or more.
[[nodiscard]] inline Error duplicate_point_error(const char* what, const char* have,
                                                 std::vector<std::int64_t> vertices) {
    constexpr std::size_t most = 8;
    std::sort(vertices.begin(), vertices.end());
    std::string text = what;
    for (std::size_t k = 0; k < vertices.size() && k < most; ++k)
        text += (k == 0 ? " " : k + 1 == vertices.size() ? " and " : ", ") + std::to_string(vertices[k]);
    if (vertices.size() > most) text += " and " + std::to_string(vertices.size() - most) + " more";
    return {Error_code::duplicate_point, text + " " + have + " the same position", std::move(vertices)};
}

}  // namespace annulus::inline v1
