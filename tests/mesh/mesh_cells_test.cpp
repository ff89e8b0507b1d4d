// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours of cells that are listed are those of the table.
#include <annulus/mesh/list_cells.h>
#include <annulus/moving_mesh.h>
#include <support/catch.h>
#include <support/repeats.h>

#include <random>

using namespace annulus;

TEMPLATE_TEST_CASE_SIG("Neighbours are found by the facets, dimension", "[mesh]", ((int d), d), 2, 3) {
    for (int run = 0; run < repeats(20); ++run) {
        std::mt19937 random(static_cast<unsigned>(run));
        INFO("seed " << run);
        std::vector<Coordinates<d>> x(static_cast<std::size_t>(d) + 1 + random() % 60);
        for (auto& p : x)
            for (double& c : p) c = static_cast<double>(random() % 9);  // cospherical, coplanar
        const Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), {.merge_duplicates = true});
        const Mesh_cells<d> cells = mesh.cells();
        std::vector<Index> corners;
        for (const auto& cell : cells.vertices) corners.insert(corners.end(), cell.begin(), cell.end());
        const Mesh_cells<d> listed = mesh_cells<d>(corners, mesh.index_bound());
        CHECK(listed.vertices == cells.vertices);
        CHECK(listed.neighbours == cells.neighbours);
    }
    CHECK(mesh_cells<d>({}, 0).vertices.empty());
}
