// SPDX-License-Identifier: GPL-3.0-or-later
// A shared library that contains annulus.
#include <annulus/moving_mesh.h>

int vertices_of_a_triangle() {
    const std::vector<annulus::Coordinates<2>> points{{0, 0}, {1, 0}, {0, 1}};
    return static_cast<int>(annulus::Moving_mesh<2>(points).size());
}
