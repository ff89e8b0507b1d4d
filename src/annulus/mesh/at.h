// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>

namespace annulus::inline v1 {

/// The place of vertex i in an array with an entry for each index. Precondition: i is none of the negative ones, which
/// name no vertex. For source files: public headers do not include this.
[[nodiscard]] constexpr std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace annulus::inline v1
