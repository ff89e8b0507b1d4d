// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/cavity_edges.h>
#include <annulus/kernel/growing_cells.h>
#include <annulus/kernel/thread_partition.h>

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace annulus::inline v1 {

/// Inserts vertices into Growing_cells: locates the vertex by a walk from a cell of the last one inserted, finds the
/// cells whose sphere holds it (the cavity), and replaces them by cells between the cavity's border and the vertex.
/// Each thread has its own Inserter, in its own cache lines.
template <int d>
class alignas(128) Inserter {
  public:
    using Cells = Growing_cells<d>;
    using Rank = typename Cells::Rank;
    using Cell = typename Cells::Cell;
    using Half_facet = typename Cells::Half_facet;
    enum class Outcome {
        inserted,
        taken,      ///< a vertex is at this position
        lost,       ///< the walk left the thread partition
        postponed,  ///< the cavity is not entirely in the thread partition
    };

    /// To be called before the first vertex of a triangulation.
    void begin(Cells& cells) {
        cells_ = &cells;
        free_.clear();
        last_ = 0;
        ridges_.begin(static_cast<std::size_t>(cells.infinity) + 1);
    }
    /// Inserts v. Returns false where a vertex is there, which blocker() returns. Throws Error(too_large), bad_alloc.
    [[nodiscard]] bool insert(Rank v);
    [[nodiscard]] Rank blocker() const { return blocker_; }
    [[nodiscard]] Cells& cells() const { return *cells_; }

    /// Continues another inserter's triangulation, within a thread partition.
    void start_in(const Thread_partition& partition, const Inserter& from);
    /// To be called after that, while no thread changes a cell: a finite cell of the partition near v, or no_cell.
    /// Each search starts where the previous one ended.
    [[nodiscard]] Cell start_near(Rank v);
    /// Sets the start of the next walk to a cell that start_near() returned. A cell of the partition still is one, or
    /// is free; then nothing is done.
    void start_at(Cell c) {
        if (cells_->is_cell(c)) last_ = c;
    }
    /// Inserts v. On failure nothing has changed except where the next walk begins.
    [[nodiscard]] Outcome insert_in_partition(Rank v);
    /// Takes over from another started inserter: its free cells, and where it was last.
    void go_on_from(Inserter& other) {
        free_.insert(free_.end(), other.free_.begin(), other.free_.end());
        other.free_.clear();
        last_ = other.last_;
    }

  private:
    static constexpr std::size_t corners = d + 1;
    /// A facet of the border, ordered so that with the new vertex before it the cell is positive.
    struct Facet {
        std::array<Rank, static_cast<std::size_t>(d)> vertex;
        Half_facet beyond;
        std::array<std::uint32_t, static_cast<std::size_t>(d)> number;  // numbers of its vertices (ridges_)
    };
    /// Buffers of one insertion.
    struct Cavity {
        std::vector<Half_facet> entered;  ///< a half-facet of each of its cells; in 2D those still to cross
        std::vector<Half_facet> border;   ///< half-facets of its cells that lead out; in 2D counter-clockwise
        std::vector<Cell> cells;          ///< its cells; then those that replace them, facet by facet
        std::vector<Facet> facets;
        std::size_t size = 0, border_size = 0;
    };

    template <bool shared>
    [[nodiscard]] Outcome insert_in(Rank v);
    /// A cell whose sphere holds q, found from `start`. Returns no_cell where a vertex is at q, with that vertex in
    /// blocker_, or where the walk would leave the partition, with infinity in blocker_.
    template <bool shared>
    [[nodiscard]] Cell locate(const Coordinates<d>& q, Cell start);
    /// Whether the sphere of c holds vertex v, by the exact stage and the perturbation.
    [[nodiscard]] bool holds_exactly(Cell c, Rank v) const;
    /// Returns false where the cavity leaves the partition; then nothing has changed.
    template <bool shared>
    [[nodiscard]] bool find_cavity(Rank v, Cell first);
    /// Removes the marks of the cells of the cavity.
    void unmark();
    template <bool shared>
    [[nodiscard]] bool take_cells();
    [[nodiscard]] bool claim_block();
    [[nodiscard]] bool read_border();
    void glue(Rank v, std::span<const Facet> facets);
    void fill(Rank v);
    void leave_infinity();
    [[nodiscard]] Cell nearest_new_cell(Rank v, Rank next) const;

    Cells* cells_ = nullptr;
    std::vector<Cell> free_;
    Cell last_ = 0;
    Cavity cavity_;
    std::conditional_t<d == 2, Cavity_vertices, Cavity_edges> ridges_;
    Thread_partition partition_;
    Rank blocker_ = 0;
};

#define ANNULUS_INSERTER(d)                                           \
    extern template bool Inserter<d>::find_cavity<false>(Rank, Cell); \
    extern template bool Inserter<d>::find_cavity<true>(Rank, Cell);  \
    extern template void Inserter<d>::unmark();                       \
    template <>                                                       \
    void Inserter<d>::glue(Rank v, std::span<const Facet> facets);    \
    extern template void Inserter<d>::fill(Rank);                     \
    extern template class Inserter<d>;
ANNULUS_INSERTER(2)
ANNULUS_INSERTER(3)
#undef ANNULUS_INSERTER

}  // namespace annulus::inline v1
