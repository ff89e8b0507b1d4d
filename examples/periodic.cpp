// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ example of docs/periodic.md: a crystal in a box that is sheared.
#include <annulus/periodic_mesh.h>

#include <cmath>
#include <iostream>
#include <vector>

int main() {
    // [docs]
    const std::vector<annulus::Coordinates<3>> copper{{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
    annulus::Periodic_mesh<3> mesh(copper, annulus::Box<3>::orthorhombic({1, 1, 1}));
    std::cout << mesh.neighbour_counts()[0] << '\n';  // 12

    std::vector<annulus::Coordinates<3>> points = copper;
    for (auto& p : points) p[0] += 0.125 * p[1];
    mesh.move_all(points, annulus::Box<3>({{{1, 0, 0}, {0.125, 1, 0}, {0, 0, 1}}}));
    double sum = 0;
    for (const double volume : mesh.voronoi_volumes()) sum += volume;
    std::cout << sum << ' ' << mesh.audit().delaunay() << '\n';  // 1 1
    // [docs]
    return std::fabs(sum - 1) < 1e-9 && mesh.audit().delaunay() ? 0 : 1;
}
