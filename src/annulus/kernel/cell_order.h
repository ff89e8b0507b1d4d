// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/growing_cells.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// Puts the cells of a finished triangulation in an order that depends only on the triangulation and on ranks, not on
/// which thread made them when: by the largest rank of a vertex, then by the others. Slot 0 has the vertex of the
/// largest rank (infinity does not count), slot 1, in 3D, the least of the others, and the rest follow from the
/// orientation.
///
/// In the last round of insertion, which most cells come from, ranks follow a space-filling curve. So cells that are
/// near one another in the order are near in space, too.
template <int d>
class Cell_order {
  public:
    using Cells = Growing_cells<d>;
    using Cell = typename Cells::Cell;
    using Rank = typename Cells::Rank;

    /// Counts the cells, and groups them by their largest rank. O(n). Throws bad_alloc.
    [[nodiscard]] std::size_t group(const Cells& cells, int threads);
    /// To be called after group(). Calls write(number, vertices as ranks, half-facets across) for each cell and its
    /// new number. O(n), plus O(k log k) for k cells that share a rank.
    template <class Write>
    void number(const Cells& cells, int threads, Write write);
    /// A half-facet as 4 * number + slot. Precondition: all cells have their numbers.
    [[nodiscard]] std::uint32_t renamed(std::uint32_t h) const {
        static constexpr Slots fresh = new_slots();
        return 4 * number_[h >> 2] + fresh[turn_[h >> 2]][h & 3U];
    }

  private:
    static constexpr std::size_t corners = d + 1;
    static constexpr std::size_t run = 1U << 14;           ///< cells, or vertices, that a thread takes at once
    static constexpr std::size_t turns = d == 2 ? 3 : 12;  ///< even permutations of the corners
    using Slots = std::array<std::array<std::uint8_t, 4>, turns>;
    /// For each turn the old slots by new slot, and the new slots by old slot.
    static constexpr Slots old_slots();
    static constexpr Slots new_slots();

    [[nodiscard]] static std::uint8_t turn_of(const std::array<Rank, corners>& vertices, Rank infinity);
    /// The vertices of a cell and the half-facets across, by new slots.
    struct Turned {
        std::array<Rank, corners> vertices;
        std::array<std::uint32_t, corners> across;
        Cell cell;
        /// The sorting key of cells with the same largest rank; together with the orientation it distinguishes them.
        [[nodiscard]] std::uint64_t rest() const {
            return std::uint64_t{static_cast<std::uint32_t>(vertices[1])} << 32 |
                   static_cast<std::uint32_t>(vertices[2]);
        }
    };
    [[nodiscard]] Turned turned(const Cells& cells, Cell c) const {
        static constexpr Slots old = old_slots();
        const auto& cell = cells.cells[c];
        const auto& slots = old[turn_[c]];
        Turned t;
        for (std::size_t i = 0; i < corners; ++i) {
            t.vertices[i] = cell.vertex[slots[i]];
            t.across[i] = cell.across[slots[i]];
        }
        t.cell = c;
        return t;
    }
    template <bool shared>
    void count(const Cells& cells, std::size_t first, std::size_t last);
    template <bool shared>
    void place(std::size_t first, std::size_t last);
    /// Where the cells begin whose largest rank is v.
    [[nodiscard]] std::size_t begin_of(std::size_t v) const { return v == 0 ? 0 : end_[v - 1]; }
    template <class Write>
    void number_block(const Cells& cells, std::size_t first, std::size_t last, std::size_t end, Write& write);
    template <class Write>
    void number_many(const Cells& cells, std::size_t first, std::size_t last, Write& write);

    Default_init_vector<std::uint32_t> end_;     // by rank: where the cells end of which it is the largest
    Default_init_vector<Cell> cell_;             // by number, except for the order within a group
    Default_init_vector<std::uint32_t> number_;  // by cell; before that, its largest rank
    Default_init_vector<std::uint8_t> turn_;     // by cell
};

template <int d>
constexpr auto Cell_order<d>::old_slots() -> Slots {
    Slots old{};
    constexpr auto others = facing<d>();
    for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t k = 0; k < turns / corners; ++k) {
            auto& o = old[i * (turns / corners) + k];
            o[0] = static_cast<std::uint8_t>(i);
            for (std::size_t j = 0; j < d; ++j) o[j + 1] = others[i][(j + k) % d];
        }
    return old;
}

template <int d>
constexpr auto Cell_order<d>::new_slots() -> Slots {
    Slots fresh{};
    const Slots old = old_slots();
    for (std::size_t t = 0; t < turns; ++t)
        for (std::size_t i = 0; i < corners; ++i) fresh[t][old[t][i]] = static_cast<std::uint8_t>(i);
    return fresh;
}

template <int d>
template <class Write>
void Cell_order<d>::number(const Cells& cells, int threads, Write write) {
    constexpr std::size_t block = 32;  // ranks whose cells stay in the cache from reading to numbering
    for_each_run(end_.size(), run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; v += block)
            number_block(cells, v, std::min(v + block, last), begin_of(last), write);
    });
}

/// How many cells of its group are less than a cell is its place there. A group has some seven cells (in 2D two), in an
/// order that no processor predicts, nor their number: so there are no loops over a group, but over batches, of which
/// few groups have more than one. Nothing is allocated: the table has been reset. Other threads may change the order of
/// cells from `end` on.
template <int d>
template <class Write>
void Cell_order<d>::number_block(const Cells& cells, std::size_t first, std::size_t last, std::size_t end,
                                 Write& write) {
    constexpr std::size_t ahead = 16, batch = d == 2 ? 4 : 8, room = 512;
    const std::size_t begin = begin_of(first), size = end_[last - 1] - begin;
    if (size > room) {
        for (std::size_t v = first; v < last; ++v) number_many(cells, begin_of(v), end_[v], write);
        return;
    }
    std::array<Turned, room> group;
    std::array<std::uint64_t, room + batch> rests;
    for (std::size_t k = 0; k < size; ++k) {
        __builtin_prefetch(&cells.cells[cell_[std::min(begin + k + ahead, end - 1)]]);
        group[k] = turned(cells, cell_[begin + k]);
        rests[k] = group[k].rest();
    }
    std::fill_n(&rests[size], batch, ~std::uint64_t{0});
    for (std::size_t k = 0; k < size; ++k) {
        const auto top = static_cast<std::size_t>(group[k].vertices[0]);
        const std::size_t from = begin_of(top), members = end_[top] - from;
        const std::uint64_t* const rest = &rests[from - begin];
        std::size_t less = 0;
        for (std::size_t b = 0; b < members; b += batch)
            for (std::size_t i = b; i < b + batch; ++i) less += rest[i] < rests[k] && i < members ? 1U : 0U;
        number_[group[k].cell] = static_cast<std::uint32_t>(from + less);
        write(from + less, group[k].vertices, group[k].across);
    }
}

template <int d>
template <class Write>
void Cell_order<d>::number_many(const Cells& cells, std::size_t first, std::size_t last, Write& write) {
    std::sort(cell_.begin() + static_cast<std::ptrdiff_t>(first), cell_.begin() + static_cast<std::ptrdiff_t>(last),
              [&](Cell l, Cell r) { return turned(cells, l).rest() < turned(cells, r).rest(); });
    for (std::size_t k = first; k < last; ++k) {
        const Turned t = turned(cells, cell_[k]);
        number_[t.cell] = static_cast<std::uint32_t>(k);
        write(k, t.vertices, t.across);
    }
}

extern template class Cell_order<2>;
extern template class Cell_order<3>;

}  // namespace annulus::inline v1
