// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>

namespace annulus::link {

/// A bi-cell a, b, p (right of ab), q (left of it) with the name it has in docs/tolerances.md.
struct Named_2 {
    const char* name;
    std::array<Coordinates<2>, 4> x;
};

inline constexpr std::array<Named_2, 9> named_2{{
    {"equilateral", {{{0.0, 0.0}, {1.0, 0.0}, {0.5, -0x1.bb67ae8584caap-1}, {0.5, 0x1.bb67ae8584caap-1}}}},
    {"kite", {{{0.0, 0.0}, {1.0, 0.0}, {0.5, -0.75}, {0.375, 0.9375}}}},
    {"square", {{{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}}},
    {"square_2m20", {{{0.0, 0.0}, {1.0, 1.0}, {1.0 + 0x1p-20, 0.0}, {0.0, 1.0}}}},
    {"square_ulp", {{{0.0, 0.0}, {1.0, 1.0}, {1.0 + 0x1p-52, 0.0}, {0.0, 1.0}}}},
    {"square_far",
     {{{0x1p40, -0x1p40}, {0x1p40 + 1.0, -0x1p40 + 1.0}, {0x1p40 + 1.0 + 0x1p-12, -0x1p40}, {0x1p40, -0x1p40 + 1.0}}}},
    {"theta_2m30", {{{0.0, 0.0}, {1.0, 0.0}, {-1.0, -0x1p-30}, {2.0, 0x1p-30}}}},
    {"tiny", {{{0.0, 0.0}, {0x1p-1000, 0.0}, {0x1p-1001, -0x1.8p-1001}, {0x1.8p-1002, 0x1.ep-1001}}}},
    {"huge", {{{0.0, 0.0}, {0x1p499, 0.0}, {0x1p498, -0x1.8p498}, {0x1.8p497, 0x1.ep498}}}},
}};

/// A bi-cell a, b, c, p, q in space.
struct Named_3 {
    const char* name;
    std::array<Coordinates<3>, 5> x;
};

/// The first is the five points of docs/theory.md 3 with delta = 0.01, as the bi-cell of a facet at the edge of the
/// poles.
inline constexpr double pole = 0x1.fae147ae147aep-1;
inline constexpr double half_root_3 = 0x1.bb67ae8584caap-1;
inline constexpr std::array<Named_3, 3> named_3{{
    {"five_points",
     {{{0.0, 0.0, pole}, {0.0, 0.0, -pole}, {1.0, 0.0, 0.0}, {-0.5, half_root_3, 0.0}, {-0.5, -half_root_3, 0.0}}}},
    {"two_cells_apart",
     {{{1.0, 0.0, 0.0}, {-0.5, half_root_3, 0.0}, {-0.5, -half_root_3, 0.0}, {0.0, 0.0, -1.25}, {0.0, 0.0, 1.25}}}},
    {"octahedron_half", {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, -0x1.8p-1}, {1.0, 1.0, 1.0}}}},
}};

}  // namespace annulus::link
