// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/domain_2.h>

#include <vector>

/// A disc (0), a square (1) or a pentagon (2), about 20 across.
inline annulus::Domain_2 some_domain(int which) {
    switch (which) {
        case 0: return annulus::Domain_2::disc(10);
        case 1: return annulus::Domain_2::square(9);
        default:
            return annulus::Domain_2::polygon(
                std::vector<annulus::Coordinates<2>>{{1, -9}, {11, -2}, {9, 8}, {-3, 10}, {-8, 1}});
    }
}
