// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi vertices that cells have in common, rings of cells around edges, and cells whose neighbours are wrong.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether both functions refuse these cells as bad input.
template <int d>
bool are_refused(const Points_d<d>& x, const Mesh_cells<d>& cells) {
    int refused = 0;
    try {
        (void)voronoi_diagram<d>(x, cells);
    } catch (const Error& e) {
        refused += e.code() == Error_code::bad_input ? 1 : 0;
    }
    try {
        (void)voronoi_jacobian<d>(x, cells);
    } catch (const Error& e) {
        refused += e.code() == Error_code::bad_input ? 1 : 0;
    }
    return refused == 2;
}

}  // namespace

TEST_CASE("A Voronoi vertex that cells have in common is one", "[measure][voronoi]") {
    const Points_d<3> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const Moving_mesh<3> mesh{std::span<const Coordinates<3>>(cube)};
    const auto diagram = voronoi(mesh);
    for (std::size_t c = 0; c < diagram.vertex.size(); ++c) {
        CHECK(diagram.vertex_of_cell[c] == 0);
        CHECK(diagram.vertex[c] == Coordinates<3>{0.5, 0.5, 0.5});
    }
    for (std::size_t k = 0; k < diagram.pair.size(); ++k) {
        // The diagonals of faces and of the cube are in facets that are empty; the edges are in the hull, not flat.
        CHECK((diagram.exactly_empty[k] != 0) == (diagram.distance[k] > 1.1));
        CHECK(diagram.measure[k] == (diagram.exactly_empty[k] != 0 ? 0 : infinity));
        CHECK(diagram.ring[at(diagram.ring_begin[k])] ==
              (diagram.distance[k] < 1.5 ? -1 : diagram.ring[at(diagram.ring_begin[k])]));
    }
}

TEMPLATE_TEST_CASE_SIG("Rings go round the edge, dimension", "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(11);
    const Points_d<d> x = uniform<d>(60, random);
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const auto diagram = voronoi(mesh);
    for (std::size_t k = 0; k < diagram.pair.size(); ++k) {
        const auto begin = diagram.ring.begin() + diagram.ring_begin[k];
        const auto end = diagram.ring.begin() + diagram.ring_begin[k + 1];
        CHECK(std::count(begin, end, -1) == (std::isinf(diagram.measure[k]) ? 1 : 0));
        CHECK((d == 3 || end - begin == 2));
        const auto& [i, j] = diagram.pair[k];
        for (std::size_t a = 0; a < d; ++a) CHECK(diagram.vector[k][a] == x[at(j)][a] - x[at(i)][a]);
        for (auto r = begin; r != end; ++r) {
            if (*r < 0) continue;
            const auto& cell = mesh.cell_lists()->cells.vertices[at(*r)];
            CHECK((std::count(cell.begin(), cell.end(), i) == 1 && std::count(cell.begin(), cell.end(), j) == 1));
        }
        if constexpr (d == 3) {
            if (std::isinf(diagram.measure[k])) continue;
            double area = 0;  // positive for rings that are counter-clockwise seen from j
            const auto& o = diagram.centroid[k];
            for (auto r = begin; r != end; ++r) {
                const auto& p = diagram.vertex[at(*r)];
                const auto& q = diagram.vertex[at(r + 1 == end ? *begin : *(r + 1))];
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::size_t b = (a + 1) % 3;
                    const std::size_t c = (a + 2) % 3;
                    area += diagram.vector[k][a] / diagram.distance[k] / 2 *
                            ((p[b] - o[b]) * (q[c] - o[c]) - (p[c] - o[c]) * (q[b] - o[b]));
                }
            }
            CHECK(area == Approx(diagram.measure[k]));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Neighbours that are cells, and wrong, are refused, dimension", "[measure][voronoi]",
                       ((int d), d), 2, 3) {
    Random random(23);
    const Points_d<d> x = uniform<d>(12, random);
    const Mesh_cells<d> cells = Moving_mesh<d>{std::span<const Coordinates<d>>(x)}.cells();
    const auto n = static_cast<Index>(cells.vertices.size());
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (std::size_t k = 0; k <= d; ++k) {
            for (Index wrong = cells.outside; wrong < n; ++wrong) {
                Mesh_cells<d> changed = cells;
                changed.neighbours[c][k] = wrong;
                CAPTURE(c, k, wrong, cells.neighbours[c][k]);
                CHECK(are_refused<d>(x, changed) == (wrong != cells.neighbours[c][k]));
            }
            Mesh_cells<d> changed = cells;
            const std::size_t other = random() % cells.vertices.size();
            std::swap(changed.neighbours[c][k], changed.neighbours[other][random() % (d + 1)]);
            CHECK(are_refused<d>(x, changed) == (changed.neighbours != cells.neighbours));
        }
    for (int i = 0; i < repeats(20); ++i) {  // all of them
        Mesh_cells<d> changed = cells;
        for (auto& row : changed.neighbours)
            for (Index& beyond : row) beyond = static_cast<Index>(random() % at(n));
        CHECK(are_refused<d>(x, changed));
    }
}
