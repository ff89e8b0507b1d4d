// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/border_facets.h>
#include <annulus/mesh/replace_cells.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Builder;

/// Rebuilds a small part of a triangulation where flips are stuck.
///
/// A cavity starts as some cells. The Delaunay triangulation of its vertices is computed. If a facet of the cavity's
/// border is not in it, the cell beyond that facet joins the cavity. When all border facets are in it, the Delaunay
/// cells behind the border replace the cavity. If every cell outside is right this ends with the cells of the whole
/// Delaunay triangulation there, since then the border consists of facets of it (docs/theory.md 6.5). Nothing is
/// assumed: the caller has to check the new cells.
template <int d>
class Cavity_retriangulator {
  public:
    explicit Cavity_retriangulator(Corner_table<d>& table);
    ~Cavity_retriangulator();
    Cavity_retriangulator(const Cavity_retriangulator&) = delete;
    Cavity_retriangulator& operator=(const Cavity_retriangulator&) = delete;

    /// Rebuilds around these cells, at positions x; cells that touch make one cavity. `touched` receives the removed
    /// and the new cells. Returns false when that is not possible or takes more than `most` points to triangulate;
    /// where a cavity grows, its points count again.
    [[nodiscard]] bool rebuild(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, std::size_t most,
                               std::vector<Cell_index>& touched);
    /// The same without v, whose star these cells are.
    [[nodiscard]] bool remove(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, Index v,
                              std::size_t most, std::vector<Cell_index>& touched);
    /// The number of points that the last of these calls triangulated.
    [[nodiscard]] std::size_t points() const { return points_; }

  private:
    using Sites = Cell_sites<d>;
    struct Marks {
        By_cell<char> of;               // 1 to be rebuilt, 2 in the cavity
        std::vector<Cell_index> cells;  // where it may not be 0
    };
    /// The points to triangulate.
    struct Region {
        std::vector<Index> vertices;
        bool at_infinity = false;  // whether infinity is one of them
        Index without = none;      // a vertex to leave out
    };
    /// A cell of the Delaunay triangulation of these points.
    struct Small_cell {
        Sites sites;
        std::array<std::uint32_t, static_cast<std::size_t>(d + 1)> across;  // 4 * cell + slot
        // By slot: the border facet that its facet is, counted from 1, or 0; in `inside` where the cell is on the
        // cavity's side.
        std::array<std::uint32_t, static_cast<std::size_t>(d + 1)> inside, outside;
        std::uint32_t place;  // in new_cells_, counted from 1; 0: not in it
    };
    /// The cells that replace the cavity.
    struct Filled {
        std::vector<std::uint32_t> cells;  // numbers of small cells
        std::vector<Sites> sites;
        std::vector<Fresh_neighbours<d>> neighbours;
    };

    [[nodiscard]] bool rebuild_cavity(std::span<const Coordinates<d>> x, std::vector<Cell_index>& cavity,
                                      std::size_t most, std::vector<Cell_index>& touched);
    [[nodiscard]] bool triangulate(std::span<const Coordinates<d>> x);
    /// Collects the Delaunay cells behind the border in new_cells_. Returns false when the border is not in the
    /// triangulation; then `beyond` receives the cells that join.
    [[nodiscard]] bool fill(std::span<const Cell_index> cavity, std::vector<Cell_index>& beyond);
    /// Records in the small cells which of their facets belong to the border. Returns, by border facet, the small cell
    /// inside, or `nothing`.
    [[nodiscard]] std::vector<std::uint32_t> match_border();
    void enter(std::uint32_t small);
    void link_filled();
    [[nodiscard]] bool has_every_vertex() const;
    void mark(Cell_index c, char m) {
        marks_.cells.push_back(c);
        marks_.of[c] = m;
    }

    Corner_table<d>& table_;
    std::unique_ptr<Builder<d>> builder_;
    std::size_t points_ = 0;
    Marks marks_;
    Region region_;
    std::vector<Small_cell> small_;  // by number; some have no cell
    Border_facets<d> border_;        // seen from inside
    Filled new_cells_;
};

extern template class Cavity_retriangulator<2>;
extern template class Cavity_retriangulator<3>;

}  // namespace annulus::inline v1
