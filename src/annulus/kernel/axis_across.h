// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/sure_orientation.h>
#include <annulus/space/places.h>

#include <cstddef>
#include <optional>

namespace annulus::inline v1 {

/// An axis along which three points do not appear collinear; nothing if they are collinear. Exact.
[[nodiscard]] inline std::optional<std::size_t> axis_across(const Coordinates<3>& p, const Coordinates<3>& a,
                                                            const Coordinates<3>& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto y = seen_along<3>(i, {&p, &a, &b});
        if (sure_orientation<2>({&y[0], &y[1], &y[2]}) != 0) return i;
    }
    return std::nullopt;
}

}  // namespace annulus::inline v1
