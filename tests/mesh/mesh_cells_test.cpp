// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours that a table lists are the cells with the same facet.
#include <annulus/moving_mesh.h>
#include <support/catch.h>
#include <support/repeats.h>

#include <map>
#include <random>
#include <set>

using namespace annulus;

TEMPLATE_TEST_CASE_SIG("Neighbours have the facet, dimension", "[mesh]", ((int d), d), 2, 3) {
    for (int run = 0; run < repeats(20); ++run) {
        std::mt19937 random(static_cast<unsigned>(run));
        INFO("seed " << run);
        std::vector<Coordinates<d>> x(static_cast<std::size_t>(d) + 1 + random() % 60);
        for (auto& p : x)
            for (double& c : p) c = static_cast<double>(random() % 9);  // cospherical, coplanar
        const Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), {.merge_duplicates = true});
        const Mesh_cells<d> cells = mesh.cells();
        if (cells.vertices.empty() || cells.vertices[0][d] == none) continue;  // in a plane or on a line
        const auto facet = [&](std::size_t c, std::size_t i) {
            std::set<Index> corners(cells.vertices[c].begin(), cells.vertices[c].end());
            corners.erase(cells.vertices[c][i]);
            return corners;
        };
        std::map<std::set<Index>, std::vector<Index>> cells_at;
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) cells_at[facet(c, i)].push_back(static_cast<Index>(c));
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                Index beyond = cells.outside;
                for (const Index other : cells_at[facet(c, i)])
                    if (other != static_cast<Index>(c)) beyond = other;
                REQUIRE(cells.neighbours[c][i] == beyond);
            }
    }
}
