// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

enum class Vertex_location : char {
    nowhere,  ///< no cell names it
    hull,     ///< its Voronoi cell is unbounded
    inside
};

/// Throws wrong_size unless there is a weight for each point.
void require_weights(std::size_t weights, std::size_t points);

/// Points and cells that have been checked, as the functions of voronoi.h take them: where each vertex is, and the unit
/// of circumcentres.
template <int d>
struct Voronoi_input {
    /// Refers to both. O(n). Throws as voronoi_volumes does.
    Voronoi_input(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells);

    /// By cell, in the unit 1/scale: a power of two, no coordinate times which is above 1. Precondition: spans.
    /// Those of cells that have a number `before`, which is not `none`, are known[before].
    [[nodiscard]] std::vector<Circumcentre<d>> circumcentres(double scale, std::span<const Index> before = {},
                                                             std::span<const Circumcentre<d>> known = {}) const;

    std::span<const Coordinates<d>> points;
    const Mesh_cells<d>& cells;
    std::vector<Vertex_location> where;
    bool spans = true;  ///< whether cells have d + 1 corners
    int exponent = 0;   ///< of the unit: every coordinate is below 2^exponent

  private:
    void note_cell(std::size_t c);
};

extern template struct Voronoi_input<2>;
extern template struct Voronoi_input<3>;

}  // namespace annulus::inline v1
