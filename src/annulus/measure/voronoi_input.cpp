// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_input.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/error.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace annulus::inline v1 {

void require_weights(std::size_t weights, std::size_t points) {
    if (weights != points)
        throw Error(Error_code::wrong_size, "there are weights of " + std::to_string(weights) + " cells for " +
                                                std::to_string(points) + " points");
}

template <int d>
Voronoi_input<d>::Voronoi_input(std::span<const Coordinates<d>> x, const Mesh_cells<d>& of) : points(x), cells(of) {
    if (cells.neighbours.size() != cells.vertices.size())
        throw Error(Error_code::wrong_size, "there are neighbours of " + std::to_string(cells.neighbours.size()) +
                                                " cells for " + std::to_string(cells.vertices.size()) + " cells");
    where.assign(points.size(), Vertex_location::nowhere);
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) note_cell(c);
    double largest = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
        if (where[v] != Vertex_location::nowhere)
            for (const double k : points[v]) largest = std::max(largest, std::fabs(k));
    if (!spans) std::replace(where.begin(), where.end(), Vertex_location::inside, Vertex_location::hull);
    exponent = largest == 0 ? 0 : std::ilogb(largest) + 1;
}

template <int d>
void Voronoi_input<d>::note_cell(std::size_t c) {
    const auto& cell = cells.vertices[c];
    for (const Index n : cells.neighbours[c])
        if (n != cells.outside && (n < 0 || at(n) >= cells.vertices.size()))
            throw Error(Error_code::bad_input, "there is no cell " + std::to_string(n) + " that could be a neighbour");
    const bool padded = cell[d] == none;
    spans = spans && !padded;
    for (const Index v : cell) {
        if (padded && v == none) continue;
        if (v < 0 || at(v) >= points.size())
            throw Error(Error_code::unknown_vertex,
                        "a cell names vertex " + std::to_string(v) + " of " + std::to_string(points.size()), {v});
        if (where[at(v)] != Vertex_location::nowhere) continue;
        require_in_domain(points[at(v)], "vertex", v);
        where[at(v)] = Vertex_location::inside;
    }
    for (std::size_t i = 0; i <= d; ++i) {
        if (!padded && cells.neighbours[c][i] != cells.outside) continue;
        for (std::size_t k = 0; k <= d; ++k)
            if (cell[k] != none && (padded || k != i)) where[at(cell[k])] = Vertex_location::hull;
    }
}

template <int d>
std::vector<Circumcentre<d>> Voronoi_input<d>::circumcentres(double scale, std::span<const Index> before,
                                                             std::span<const Circumcentre<d>> known) const {
    std::vector<Circumcentre<d>> centre(cells.vertices.size());
    for (std::size_t c = 0; c < centre.size(); ++c) {
        if (!before.empty() && before[c] != none) {
            centre[c] = known[at(before[c])];
            continue;
        }
        Corners<d> corners;
        for (std::size_t i = 0; i <= d; ++i) corners[i] = points[at(cells.vertices[c][i])];
        centre[c] = circumcentre_of<d>(cells.vertices[c], corners, scale);
    }
    return centre;
}

template struct Voronoi_input<2>;
template struct Voronoi_input<3>;

}  // namespace annulus::inline v1
