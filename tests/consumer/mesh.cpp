// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/audit.h>
#include <annulus/moving_mesh.h>
#include <annulus/predicates.h>

#ifdef CGAL_VERSION
#error "these headers are to be without CGAL"
#endif

#include <cmath>
#include <iostream>
#include <vector>

int main() {
    std::vector<double> x;  // three numbers a point
    for (int i = 0; i < 600; ++i) x.push_back(std::fmod(0.6180339887 * i * (1 + i % 3), 1.0));
    annulus::Moving_mesh_3 mesh{std::span<const double>(x)};

    std::vector<annulus::Coordinates<3>> moved(mesh.points().begin(), mesh.points().end());
    for (auto& p : moved) p[0] += 0.01 * p[1];
    const auto report = mesh.move_all(moved);
    const auto cells = mesh.cells();
    if (report.moves.asked != 200 || cells.vertices.empty() || cells.vertices.size() != cells.neighbours.size())
        return 1;
    if (!mesh.audit().delaunay()) return 1;
    if (!annulus::audit(mesh.points(), std::span(cells.vertices)).delaunay()) return 1;
    const auto& corner = cells.vertices[0];
    const auto at = [&](std::size_t i) { return mesh.points()[static_cast<std::size_t>(corner[i])]; };
    if (annulus::orient_3d(at(0), at(1), at(2), at(3)).sign != 1) return 1;
    if (mesh.find_cell(mesh.points()[7]) < 0 || mesh.neighbors(7).size() < 3 || mesh.convex_hull().size() < 4) return 1;

    annulus::Moving_mesh_3 other = std::move(mesh);
    const annulus::Index v = other.insert({0.5, 0.5, 2.0});
    other.remove(v);
    std::cout << "consumer: " << cells.vertices.size() << " tetrahedra, Delaunay\n";
    return other.audit().delaunay() ? 0 : 1;
}
