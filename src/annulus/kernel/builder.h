// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>
#include <annulus/kernel/integer_signs.h>
#include <annulus/kernel/kept_sphere.h>
#include <annulus/kernel/ridges.h>
#include <annulus/mesh/cell_table.h>
#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Builds Delaunay triangulations from nothing, by incremental insertion (Bowyer, Watson) along a space-filling curve:
/// locate by a walk, find the cells whose sphere holds the point, replace them by cells between their border and the
/// point.
///
/// All decisions are exact: a filter on spheres that are kept with the cells (Kept_sphere), then the exact stage, then
/// CGAL's symbolic perturbation where points are cospherical. So the cells are those that insertion one by one, CGAL
/// and repair give. Buffers are kept from one build to the next: a rebuild touches no memory that is new.
///
/// Inside, vertices are ranks in the order of insertion (spatial_order), and a cell is one line of 64 bytes with its
/// sphere. Not for several threads at once.
template <int d>
class Builder {
  public:
    /// Triangulates these vertices (distinct indices of x) at x. False where they lie in a hyperplane; then there is
    /// nothing to read. Throws Error(collision) naming two at one place, Error(too_large). Expected O(n), for points that
    /// are not all on few spheres or curves.
    [[nodiscard]] bool build(std::span<const Coordinates<d>> x, std::vector<Index> vertices);
    /// The vertices in the order in which they were inserted.
    [[nodiscard]] std::span<const Index> order() const { return order_; }
    /// What build() made: the number of cells, those at infinity too, numbered from 0 in an order that depends on the
    /// positions alone.
    [[nodiscard]] std::size_t number_of_cells() const { return count_; }
    /// Calls visit(cell, its vertices in positive order, its twins: of each corner the one across the facet opposite to
    /// it, as in Cell_table) for each cell, by its number.
    template <class Visit>
    void for_each_cell(Visit visit) const;
    /// Makes it the table's, whose vertices are below `bound`. When it throws (bad_alloc), the table is as it was.
    void copy_to(Cell_table<d>& table, std::size_t bound) const;
    /// Gives buffers back.
    void release() noexcept { *this = Builder(); }

  private:
    using Rank = std::int32_t;
    using Cell = std::uint32_t;        ///< its place in cells_
    using Half_facet = std::uint32_t;  ///< 4 * cell + slot
    static constexpr Cell no_cell = ~Cell{0};
    static constexpr std::size_t corners = d + 1;

    struct alignas(64) Cell_data {
        std::array<Rank, corners> vertex;
        std::array<Half_facet, corners> across;
        Kept_sphere<d> sphere;
    };
    /// A position, in 3D filled up to half a line.
    struct alignas(d == 3 ? 32 : 16) Site {
        Coordinates<d> x;
    };
    /// A facet of the border, turned so that with the new vertex before it the cell is positive.
    struct Facet {
        std::array<Rank, static_cast<std::size_t>(d)> vertex;
        Half_facet beyond;
    };
    /// Buffers of one insertion.
    struct Cavity {
        std::vector<Half_facet> entered;  ///< a half-facet of each of its cells
        std::vector<Half_facet> border;   ///< half-facets of its cells that lead out
        std::vector<Cell> cells;          ///< its cells; then those that take its place, facet by facet
        std::vector<Facet> facets;
        std::size_t size = 0, facets_size = 0;
    };

    [[noreturn]] static void throw_too_large();
    /// bound_ last, whose size tells how many there is room for, also after bad_alloc.
    void grow_cells(std::size_t room) {
        cells_.resize(std::max(room, cells_.size()));
        bound_.resize(room);
    }
    void take_positions(std::span<const Coordinates<d>> x);
    void scale_positions(double extent);
    [[nodiscard]] bool find_simplex(std::array<Rank, corners>& simplex) const;
    void first_cells(const std::array<Rank, corners>& simplex);
    void insert(Rank v, Cell first);
    /// A cell whose sphere holds q, found from `start`; no_cell where a vertex is at q, which `taken` receives.
    [[nodiscard]] Cell locate(const Coordinates<d>& q, Cell start, Rank& taken) const;
    /// Whether the sphere of c holds vertex v, by the exact stage and the perturbation.
    [[nodiscard]] bool holds_exactly(Cell c, Rank v) const;
    void find_cavity(Rank v, Cell first);
    void take_cells();
    void read_border();
    void fill(Rank v);
    void number_cells();

    [[nodiscard]] const Coordinates<d>& at(Rank v) const { return sites_[static_cast<std::size_t>(v)].x; }
    [[nodiscard]] Scaled_point<d> on_grid(Rank v) const { return {&at(v), grid_[static_cast<std::size_t>(v)]}; }
    [[nodiscard]] Lifted<d> lifted(Rank v, const Coordinates<d>& p) const {
        return v == infinity_ ? Lifted<d>() : Lifted<d>(at(v), p);
    }
    [[nodiscard]] int slot_of_infinity(const Cell_data& c) const {
        for (int i = 0; i <= d; ++i)
            if (c.vertex[static_cast<std::size_t>(i)] == infinity_) return i;
        return -1;
    }

    std::vector<Index> order_;          // by rank
    Default_init_vector<Site> sites_;   // by rank
    Default_init_vector<double> grid_;  // their scales (grid_scale)
    Default_init_vector<Cell_data> cells_;
    Default_init_vector<float> bound_;  // of the sphere of a cell; negative: in the cavity, or gone
    std::vector<Cell> free_;
    Cavity cavity_;
    Ridges<d> ridges_;
    std::size_t used_ = 0;  // cells that are in use or free
    Rank infinity_ = 0;
    Default_init_vector<Cell> number_;  // of a cell, once all of them are made
    Cell count_ = 0;
};

template <int d>
template <class Visit>
void Builder<d>::for_each_cell(Visit visit) const {
    for (std::size_t c = 0; c < used_; ++c) {
        if (!(bound_[c] > 0)) continue;
        Cell_points<d> vertices;
        std::array<Corner_index, corners> twins;
        for (std::size_t i = 0; i <= d; ++i) {
            const Rank v = cells_[c].vertex[i];
            const Half_facet t = cells_[c].across[i];
            vertices[i] = v == infinity_ ? infinite : order_[static_cast<std::size_t>(v)];
            twins[i] = Cell_table<d>::corner(Cell_index(static_cast<Index>(number_[t >> 2])), static_cast<int>(t & 3U));
        }
        visit(Cell_index(static_cast<Index>(number_[c])), vertices, twins);
    }
}

extern template class Builder<2>;
extern template class Builder<3>;

}  // namespace annulus
