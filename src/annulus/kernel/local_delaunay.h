// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <memory>
#include <span>
#include <vector>

namespace annulus {

template <int d>
class Builder;

/// Builds a small part of a triangulation anew where flips are stuck.
///
/// A region starts as some cells. The Delaunay triangulation of its vertices is computed; where a facet of the
/// region's border is not in it, the cell beyond joins the region. When all are, the Delaunay cells behind the border
/// take the region's place. If every cell outside is right this ends with the cells of the whole Delaunay
/// triangulation there, since then the border consists of facets of it (docs/theory.md 6.5). Nothing is trusted: the
/// caller looks at what came.
template <int d>
class Local_delaunay {
  public:
    explicit Local_delaunay(Cell_table<d>& table);
    ~Local_delaunay();
    Local_delaunay(const Local_delaunay&) = delete;
    Local_delaunay& operator=(const Local_delaunay&) = delete;

    /// Builds anew around these cells, at positions x; cells that touch are one region. `touched` receives what went
    /// and what came. False when that takes more than `most` points to triangulate, the same ones again where a
    /// region grows, or is not possible.
    [[nodiscard]] bool rebuild(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, std::size_t most,
                               std::vector<Cell_index>& touched);
    /// The same without v, whose star these cells are.
    [[nodiscard]] bool remove(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, Index v,
                              std::size_t most, std::vector<Cell_index>& touched);
    /// Points that the last of these calls has triangulated.
    [[nodiscard]] std::size_t points() const { return points_; }

  private:
    using Sites = Cell_sites<d>;
    /// A cell of the Delaunay triangulation of the region's vertices.
    using Small_index = Typed_index<struct Small_tag>;
    /// A facet of a cell, its corners in a standard order, with the side that the cell is on.
    template <class Cell>
    struct Side {
        std::array<Site<d>, static_cast<std::size_t>(d)> sites;
        bool left;
        Cell cell;
        int slot;
        template <class Other>
        [[nodiscard]] bool precedes(const Side<Other>& o) const {
            return sites != o.sites ? sites < o.sites : left < o.left;
        }
        [[nodiscard]] bool same_facet(const Side& o) const { return sites == o.sites; }
    };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    template <class Cell>
    [[nodiscard]] static Side<Cell> side(const Sites& x, int slot, Cell cell);
    [[nodiscard]] bool rebuild_region(std::span<const Coordinates<d>> x, std::vector<Cell_index>& region,
                                      std::size_t most, std::vector<Cell_index>& touched);
    [[nodiscard]] bool triangulate(std::span<const Coordinates<d>> x);
    /// The Delaunay cells behind the border, in filled_. False when the border is not in them; `beyond` receives the
    /// cells that join.
    [[nodiscard]] bool fill(std::span<const Cell_index> region, std::vector<Cell_index>& beyond);
    [[nodiscard]] bool has_every_vertex() const;
    void mark(Cell_index c, char m) {
        marks_.cells.push_back(c);
        marks_.of[c] = m;
    }

    struct Marks {
        By_cell<char> of;               // 1 to be built anew, 2 in the region
        std::vector<Cell_index> cells;  // where it may not be 0
    };
    /// What is to be triangulated.
    struct Region {
        std::vector<Index> vertices;
        bool at_infinity = false;  // and infinity
        Index without = none;      // one that is not to be in it any more
    };
    /// The Delaunay triangulation of its vertices.
    struct Triangulated {
        Indexed<Small_index, Sites> cells;
        std::vector<Side<Small_index>> sides;  // sorted
    };

    Cell_table<d>& table_;
    std::unique_ptr<Builder<d>> builder_;
    std::size_t points_ = 0;
    Marks marks_;
    Region region_;
    Triangulated made_;
    std::vector<Side<Cell_index>> border_;  // of the region, seen from inside, sorted; the cell is the one outside
    std::vector<Sites> filled_;
};

extern template class Local_delaunay<2>;
extern template class Local_delaunay<3>;

}  // namespace annulus
