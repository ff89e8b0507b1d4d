// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The columns that a reader took: "x" is in "column 2 (xs)". In the order frame, id, x, y, z, as far as they are read.
using Taken_columns = std::vector<std::pair<std::string, std::string>>;

/// "column 2", or "column 2 (xs)" where it has a name; `index` counts from 0.
[[nodiscard]] inline std::string column_words(std::size_t index, const std::string& name = {}) {
    return "column " + std::to_string(index + 1) + (name.empty() ? "" : " (" + name + ")");
}

/// The id of a point without an id in the file.
inline constexpr const char* place_as_id = "its place in the frame";

}  // namespace annulus::inline v1
