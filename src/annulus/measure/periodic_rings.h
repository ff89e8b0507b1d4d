// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/edge_rings.h>
#include <annulus/mesh/periodic_table.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The cells around one edge of a periodic triangulation, moved so that its first end is at offset 0. The places of
/// all their corners are then exact (Lattice).
template <int d>
struct Periodic_ring {
    struct Cell {
        std::size_t number;
        Offset<d> shift;  ///< what is added to its offsets
    };
    Image<d> from, to;
    std::span<const Cell> cells;  ///< as those of Edge_ring; the first has the least number
    /// Whether the Voronoi facet is exactly empty: whether at most two (2D: one) of the circumcentres of the cells
    /// differ (docs/theory.md 8.6).
    bool empty;

    /// The same edge from its other end, which is at offset 0 then; the cells, in `memory`, are in the order in which
    /// they are seen from there.
    [[nodiscard]] Periodic_ring reversed(std::vector<Cell>& memory) const {
        const Offset<d> back = Offset<d>() - to.label;
        memory.assign(cells.rbegin(), cells.rend());
        for (Cell& c : memory) c.shift = c.shift + back;
        return {Image<d>(to.vertex), Image<d>(from.vertex, back), memory, empty};
    }
};

/// Visits every edge of a periodic triangulation once. O(n).
template <int d>
class Periodic_rings {
  public:
    explicit Periodic_rings(const Periodic_table<d>& table) : table_(table) {}

    /// Calls visit(Periodic_ring<d>), in an order that depends on the table alone.
    template <class Visit>
    void for_each(Visit visit) {
        for (std::size_t c = 0; c < table_.size(); ++c)
            for (std::size_t e = 0; e < (d == 2 ? 3 : 6); ++e) {
                const std::size_t a = d == 2 ? (e + 1) % 3 : edge_corners[e][0];
                const std::size_t b = d == 2 ? (e + 2) % 3 : edge_corners[e][1];
                bool empty = false;
                if (!go_round(c, e, Offset<d>() - table_.offset[c][a], empty)) continue;
                visit(Periodic_ring<d>{table_.image(c, a, ring_[0].shift), table_.image(c, b, ring_[0].shift), ring_,
                                       empty});
            }
    }

  private:
    using Table = Periodic_table<d>;

    /// Notes the cells around edge e of c, which is moved by `shift`; false where one has a smaller number than c. They
    /// are different ones (docs/theory.md 8.1), so that the first to come again is c.
    bool go_round(std::size_t c, std::size_t e, Offset<d> shift, bool& empty) {
        ring_.clear();
        if constexpr (d == 2) {
            const std::size_t m = Table::cell_of(table_.twin[c][e]);
            if (m < c) return false;
            ring_.push_back({c, shift});
            ring_.push_back({m, shift + table_.translation(c, e)});
            empty = table_.cospherical[c][e] != 0;
        } else {
            // Leaves through the facet opposite to `leave`; the other one of these two stays.
            std::size_t cell = c, leave = edge_corners[e][2], stays = edge_corners[e][3];
            int different = 0;
            do {
                ring_.push_back({cell, shift});
                const Corner_index t = table_.twin[cell][leave];
                const std::size_t m = Table::cell_of(t);
                if (m < c) return false;
                if (table_.cospherical[cell][leave] == 0) ++different;
                const Image<d> kept = table_.image(cell, stays, shift);
                shift = shift + table_.translation(cell, leave);
                cell = m;
                leave = table_.slot(m, kept, shift);
                stays = Table::slot_of(t);
            } while (cell != c);
            empty = different <= 2;
        }
        return true;
    }

    const Table& table_;
    std::vector<typename Periodic_ring<d>::Cell> ring_;
};

}  // namespace annulus::inline v1
