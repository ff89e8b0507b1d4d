// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled twice, with the headers of either version: a triangulation that moves, and an error.
#include <annulus/moving_mesh.h>

#include <string>
#include <typeinfo>
#include <vector>

// NOLINTNEXTLINE: USE is the name of this function.
std::string USE(bool fails) {
    std::vector<annulus::Coordinates<2>> x{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {3, 2}};
    annulus::Moving_mesh<2> mesh(x);
    if (fails) x.pop_back();  // an Error of this version
    for (int step = 0; step < 8; ++step) {
        for (std::size_t v = 4; v < x.size(); ++v) x[v][1] += 0.125;
        (void)mesh.move_all(x);
    }
    return mesh.audit().delaunay() && mesh.points()[4][1] == 3 ? typeid(mesh).name() : "not Delaunay";
}
