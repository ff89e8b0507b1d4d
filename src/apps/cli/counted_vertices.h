// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>

#include <cstdint>
#include <string>

namespace annulus::inline v1::cli {

/// "1 vertex", "2 vertices": the plural that `counted` does not make.
[[nodiscard]] inline std::string counted_vertices(std::uint64_t count) {
    return count == 1 ? counted(count, "vertex") : std::to_string(count) + " vertices";
}

}  // namespace annulus::inline v1::cli
