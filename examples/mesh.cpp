// SPDX-License-Identifier: GPL-3.0-or-later
// [docs]
#include <annulus/moving_mesh.h>

#include <cmath>
#include <iostream>
#include <vector>

int main() {
    std::vector<double> x;  // three numbers a point
    for (int i = 0; i < 3000; ++i) x.push_back(std::fmod(0.618034 * i * (1 + i % 3), 1.0));
    annulus::Moving_mesh_3 mesh{std::span<const double>(x)};

    std::vector<annulus::Coordinates<3>> points(mesh.points().begin(), mesh.points().end());
    for (int step = 0; step < 5; ++step) {
        for (auto& p : points) p[0] += 0.002 * std::sin(9 * p[1]);
        const annulus::Move_result report = mesh.move_all(points);
        std::cout << report.statistics.flips << " flips, " << report.moves.within_tolerance << " within tolerance\n";
    }
    const annulus::Mesh_cells<3> cells = mesh.cells();  // four vertices a cell, and the cell opposite to each of them
    std::cout << cells.vertices.size() << " tetrahedra, the first one has vertices " << cells.vertices[0][0] << ", "
              << cells.vertices[0][1] << ", " << cells.vertices[0][2] << ", " << cells.vertices[0][3] << "\n";
    return mesh.audit().delaunay() ? 0 : 1;
}
// [docs]
