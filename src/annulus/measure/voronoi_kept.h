// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/dirty_cells.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/voronoi_terms.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The Voronoi volumes of one mesh, updated on request: only volumes that a moved vertex or a changed cell affects are
/// recomputed, and the result is bit for bit that of voronoi_volumes of the mesh's cells.
///
/// Reason: a volume is a sum over the cells around its vertex in the order of their indices in the table. A cell keeps
/// its index while it exists, and a table that is rebuilt reports that everything changed. So a vertex whose cells and
/// their corners have not changed has the same terms in the same order. For all other vertices the loop of
/// voronoi_volumes adds up the terms of all cells around them. A change of the unit, too, recomputes everything.
template <int d>
class Kept_voronoi_volumes {
  public:
    /// The mesh must outlive it and must have no other set of dirty cells. O(1).
    explicit Kept_voronoi_volumes(Delaunay_mesh<d>& mesh);
    ~Kept_voronoi_volumes();
    Kept_voronoi_volumes(const Kept_voronoi_volumes&) = delete;
    Kept_voronoi_volumes& operator=(const Kept_voronoi_volumes&) = delete;

    /// Volumes by vertex index for the positions x, at which the cells of the mesh are positive; valid until the next
    /// call. Infinity for the only vertex of a mesh. O(k log k) for k cells around the affected vertices, plus one
    /// comparison per vertex. Throws as voronoi_volumes does, and bad_alloc where there are no cells because there was
    /// no memory for them; the next call then recomputes all volumes.
    std::span<const double> update(std::span<const Coordinates<d>> x);
    /// The number of volumes that the last update computed.
    [[nodiscard]] std::size_t computed() const { return computed_; }
    [[nodiscard]] const Corner_table<d>& table() const { return mesh_.table(); }
    /// By cell, in the unit 2^exponent, at the positions of the last update; those of infinite cells have no meaning.
    /// None if doubles are of no use, or cells do not have d + 1 corners.
    [[nodiscard]] std::span<const Circumcentre<d>> centres() const {
        return x_.empty() || !std::isnormal(scale()) ? std::span<const Circumcentre<d>>() : centre_;
    }
    [[nodiscard]] int exponent() const { return exponent_; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bool is_present(std::size_t v) const {
        return v < mesh_.vertex_bound() && mesh_.has(static_cast<Index>(v));
    }
    [[nodiscard]] double scale() const;
    [[nodiscard]] bool is_most(std::size_t moved) const { return moved > x_.size() / 8; }
    [[nodiscard]] std::vector<Index> note_moves(std::span<const Coordinates<d>> x);
    [[nodiscard]] std::vector<Index> all_vertices() const;
    [[nodiscard]] std::vector<Cell_index> all_cells() const;
    [[nodiscard]] std::vector<Cell_index> cells_around(std::span<const Index> vertices) const;
    [[nodiscard]] std::vector<Index> corners_of(std::span<const Cell_index> cells) const;
    void note_flat(std::size_t bound);
    void find_circumcentres(std::span<const Cell_index> cells);
    void compute_all();
    void compute_around(std::span<const Index> moved);
    void clear_sums(std::span<const Index> vertices);
    void add_terms(std::span<const Cell_index> cells);
    void find_volumes(std::span<const Index> vertices, std::span<const Cell_index> around);
    [[nodiscard]] double exact_volume(Index v) const;

    Delaunay_mesh<d>& mesh_;
    Dirty_cells dirty_cells_;              // since the last update
    std::vector<Coordinates<d>> x_;        // of the last update; empty: nothing is valid
    std::vector<Circumcentre<d>> centre_;  // by cell
    std::vector<Voronoi_sum> sum_;         // by vertex; work space, unused between two updates
    std::vector<double> volume_;
    int exponent_ = 0;  // of the unit: every coordinate is below 2^exponent
    std::size_t computed_ = 0;
};

extern template class Kept_voronoi_volumes<2>;
extern template class Kept_voronoi_volumes<3>;

}  // namespace annulus::inline v1
