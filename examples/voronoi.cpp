// SPDX-License-Identifier: GPL-3.0-or-later
// [docs]
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <cmath>
#include <iostream>
#include <numeric>
#include <vector>

int main() {
    std::vector<annulus::Coordinates<2>> points;
    for (int i = 0; i < 100; ++i) points.push_back({i % 10 + 0.5, i / 10 + 0.5});  // a lattice
    annulus::Moving_mesh_2 mesh(points);
    const auto diagram = annulus::voronoi(mesh, {{0, 0}, {10, 10}, {}});
    std::cout << diagram.pair.size() << " edges, of which "
              << std::accumulate(diagram.exactly_empty.begin(), diagram.exactly_empty.end(), 0)
              << " are diagonals of squares; the cell of the corner has the area " << diagram.volume[0] << "\n";

    // The energy is half the sum of the squares of (area - 1) over bounded cells: how it changes with each point.
    points[55][0] += 0.25;
    mesh.move_all(points);
    std::vector<double> excess = mesh.voronoi_volumes();
    for (double& area : excess) area = std::isfinite(area) ? area - 1 : 0;
    const std::vector<annulus::Coordinates<2>> gradient = mesh.voronoi_gradient(excess);
    std::cout << "the energy grows by " << gradient[55][0] << " for each unit that vertex 55 goes on\n";
    return gradient[55][0] > 0 ? 0 : 1;
}
// [docs]
