// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/bounding_box.h>
#include <annulus/kernel/cell_order.h>
#include <annulus/kernel/growing_cells.h>
#include <annulus/kernel/inserter.h>
#include <annulus/kernel/parallel_inserter.h>
#include <annulus/kernel/spatial_order.h>
#include <annulus/mesh/certificates.h>
#include <annulus/mesh/corner_table.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/*
       b-----c                      b-----c
      /|    /|\                    / \   / \
     / |   / | \                  /   \ /   \
    a  |  /  |  d       ->       a-----v-----d
     \ | / v | /                  \   / \   /
      \|/    |/                    \ /   \ /
       f-----e                      f-----e
*/
/// Builds Delaunay triangulations from nothing, by incremental insertion (Bowyer, Watson) along a space-filling curve
/// (Spatial_order, Inserter). The cells whose sphere holds the new vertex v are its cavity. They are replaced by a
/// cell for each facet of the cavity's border, with v.
///
/// Threads divide the vertices of a round among them by position (Parallel_inserter).
///
/// All decisions are exact: a filter on spheres that are stored with the cells (Cached_sphere), then the exact stage,
/// then the symbolic perturbation where points are cospherical (perturbed_sign). So the cells are those of insertion
/// one by one and of repair, and Cell_order puts them in one order for any number of threads. Buffers are kept from
/// one build to the next: a rebuild touches no new memory.
///
/// One call at a time.
template <int d>
class Builder {
  public:
    /// Triangulates these vertices (distinct indices of x) at x, by at most this many threads. Returns false where
    /// they lie in a hyperplane; then there are no cells to read. Throws Error(duplicate_point), naming two vertices
    /// at one position, and Error(too_large). Expected O(n), for points that are not all on few spheres or curves.
    [[nodiscard]] bool build(std::span<const Coordinates<d>> x, std::span<const Index> vertices, int threads = 1);
    /// The vertices in the order of insertion.
    [[nodiscard]] std::span<const Index> order() const { return order_; }
    /// Calls visit(number, sites in positive order, neighbours as 4 * number + slot) for each cell that build() made,
    /// infinite cells included. Numbers are below cell_bound(). The order is the same in each run with one thread.
    template <class Visit>
    void for_each_cell(Visit visit) const;
    [[nodiscard]] std::size_t cell_bound() const { return cells_.used; }
    /// Copies the cells to the table, whose vertices are below `bound`, in an order that depends only on the
    /// triangulation and on the order of insertion (Cell_order). When it throws (bad_alloc, Error(too_large)), the
    /// table is unchanged.
    void copy_to(Corner_table<d>& table, std::size_t bound, int threads = 1);
    /// Frees the buffers.
    void release() noexcept { *this = Builder(); }

  private:
    using Rank = typename Growing_cells<d>::Rank;
    using Cell = typename Growing_cells<d>::Cell;
    static constexpr std::size_t corners = d + 1;
    using Simplex = std::array<Rank, corners>;

    [[nodiscard]] Cell_vertices<d> named(const Simplex& ranks) const {
        Cell_vertices<d> vertices;
        for (std::size_t i = 0; i <= d; ++i)
            vertices[i] = ranks[i] == cells_.infinity ? infinite : order_[static_cast<std::size_t>(ranks[i])];
        return vertices;
    }
    /// Returns the factor by which positions are multiplied.
    double take_positions(std::span<const Coordinates<d>> x, double extent, int threads);
    [[nodiscard]] bool copy_scaled(std::span<const Coordinates<d>> x, double scale, double back, int threads);
    [[nodiscard]] bool find_simplex();
    void first_cells();
    void insert_sequentially(std::size_t first, std::size_t last);
    [[noreturn]] void throw_duplicate(Rank taken, Rank v) const;
    /// Divides the vertices of large rounds among threads; inserts those of other rounds by one thread.
    [[nodiscard]] bool insert_in_parallel(const Bounding_box<d>& around, int threads);
    template <class Place>
    void find_parts(std::span<const Rank> pending, std::size_t last, std::size_t parts, Place place);
    [[nodiscard]] bool is_corner(Rank v) const {  // of the first cell
        return std::find(simplex_.begin(), simplex_.end(), v) != simplex_.end();
    }

    std::vector<Index> order_;  // by rank
    Spatial_order<d> spatial_order_;
    Growing_cells<d> cells_;
    Simplex simplex_{};
    Inserter<d> inserter_;  // inserts what threads do not
    Parallel_inserter<d> shared_;
    std::vector<std::uint8_t> part_;  // by rank: the thread it belongs to (Parallel_inserter)
    Cell_order<d> cell_order_;
};

template <int d>
template <class Visit>
void Builder<d>::for_each_cell(Visit visit) const {
    for (Cell c = 0; c < cells_.used; ++c)
        if (cells_.is_cell(c)) visit(c, sites_of<d>(named(cells_.cells[c].vertex)), cells_.cells[c].across);
}

extern template class Builder<2>;
extern template class Builder<3>;

}  // namespace annulus::inline v1
