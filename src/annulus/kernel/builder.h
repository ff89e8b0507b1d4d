// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>
#include <annulus/kernel/integer_signs.h>
#include <annulus/kernel/kept_sphere.h>
#include <annulus/kernel/ridges.h>
#include <annulus/mesh/cell_table.h>

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
/// Inside, vertices are ranks in the order of insertion, and a cell is one line of 64 bytes with its sphere. Not for
/// several threads at once.
template <int d>
class Builder {
  public:
    /// Makes `table` the triangulation of the vertices in `order` (distinct indices below x.size()), inserted in this
    /// order, at x. False, with `table` as it was, where they lie in a hyperplane. Throws Error(collision) naming two
    /// at one place, Error(too_large). Expected O(n) after sorting, for points that are not all on few spheres or
    /// curves.
    [[nodiscard]] bool build(std::span<const Coordinates<d>> x, std::span<const Index> order, Cell_table<d>& table);
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
    void take_positions(std::span<const Coordinates<d>> x, std::span<const Index> order);
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
    void hand_over(std::span<const Index> order, std::size_t bound, Cell_table<d>& table);

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

    Default_init_vector<Site> sites_;   // by rank
    Default_init_vector<double> grid_;  // their scales (grid_scale)
    Default_init_vector<Cell_data> cells_;
    Default_init_vector<float> bound_;  // of the sphere of a cell; negative: in the cavity, or gone
    std::vector<Cell> free_;
    Cavity cavity_;
    Ridges<d> ridges_;
    std::size_t used_ = 0;  // cells that are in use or free
    Rank infinity_ = 0;
};

extern template class Builder<2>;
extern template class Builder<3>;

}  // namespace annulus
