// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/mesh/cell_lists.h>
#include <annulus/mesh/corner_table.h>
#include <annulus/voronoi.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// What was found on the way to a diagram, and makes the next one cheaper.
template <int d>
struct Diagram_parts {
    std::vector<Circumcentre<d>> centre;  ///< by cell, in the unit 2^exponent
    int exponent = 0;
    bool spans = false;  ///< whether the cells have d + 1 corners
    /// Cells with a facet in common that have exactly the same circumcentre, the smaller number first.
    std::vector<std::array<Index, 2>> cospherical;
};

/// voronoi_diagram, and its parts unless `parts` is null.
template <int d>
[[nodiscard]] Voronoi_diagram<d> fresh_diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                               const Voronoi_clip<d>* clip, Diagram_parts<d>* parts);

/// Of n cells the least one that each is connected to by these pairs.
[[nodiscard]] std::vector<Index> least_connected(std::size_t n, std::span<const std::array<Index, 2>> pairs);

/// The Voronoi diagram of one mesh, updated on request: only facets around vertices that a moved vertex or a changed
/// cell affects are computed, and the result is bit for bit that of voronoi_diagram.
///
/// Reason: a facet is computed from the cells around its edge, beginning at the one with the least number, and the sums
/// of a cell are those of its facets in the order of these numbers. A cell keeps its place in the table while it
/// exists, and numbers are in the order of places. So where no cell around an edge has changed, nor a corner of one
/// moved, the facet is what it was, under other numbers. A vertex is affected if a cell that changed has, or had, it as
/// a corner; all facets of affected vertices are computed again, so that their sums are complete, and all other facets
/// copied.
template <int d>
class Kept_voronoi_diagram {
  public:
    /// The diagram of these cells of the table at the positions x; valid until the next call. O(n), mostly copying,
    /// and the cost of a fresh one for facets of affected vertices; for all of them where half of the vertices are
    /// affected. Throws as voronoi_diagram does; then nothing is kept.
    const Voronoi_diagram<d>& update(const Corner_table<d>& table, std::span<const Coordinates<d>> x,
                                     const std::shared_ptr<const Cell_lists<d>>& cells);
    /// The number of facets that the last update computed.
    [[nodiscard]] std::size_t computed() const { return computed_; }

  private:
    class Update;

    void compute_all(std::span<const Coordinates<d>> x, const Mesh_cells<d>& cells);

    std::shared_ptr<const Cell_lists<d>> cells_;  // of the last update; null: nothing is kept
    std::vector<Index> place_;                    // by cell, in the table
    std::vector<Coordinates<d>> x_;
    Diagram_parts<d> parts_;
    Voronoi_diagram<d> diagram_;
    std::size_t computed_ = 0;
};

extern template Voronoi_diagram<2> fresh_diagram(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                 const Voronoi_clip<2>*, Diagram_parts<2>*);
extern template Voronoi_diagram<3> fresh_diagram(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                 const Voronoi_clip<3>*, Diagram_parts<3>*);
extern template class Kept_voronoi_diagram<2>;
extern template class Kept_voronoi_diagram<3>;

}  // namespace annulus::inline v1
