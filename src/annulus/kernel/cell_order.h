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
    /// new number; in the order of numbers if there is one thread. O(n), plus O(n log n) for those that share a rank.
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
        /// The sorting key of cells with the same largest rank; together with the orientation it tells them apart.
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
    template <class Write>
    void number_group(const Cells& cells, std::size_t first, std::size_t last, std::size_t end, Write& write);

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
    for_each_run(end_.size(), run, threads, [&](std::size_t first, std::size_t last) {
        std::size_t k = first == 0 ? 0 : end_[first - 1];
        for (std::size_t v = first; v < last; ++v) {
            number_group(cells, k, end_[v], end_[last - 1], write);
            k = end_[v];
        }
    });
}

template <int d>
template <class Write>
void Cell_order<d>::number_group(const Cells& cells, std::size_t first, std::size_t last, std::size_t end,
                                 Write& write) {
    constexpr std::size_t few = 32, ahead = 16;
    const auto name = [&](std::size_t k, const Turned& t) {
        number_[t.cell] = static_cast<std::uint32_t>(k);
        write(k, t.vertices, t.across);
    };
    if (last - first > few) {
        std::sort(cell_.begin() + static_cast<std::ptrdiff_t>(first), cell_.begin() + static_cast<std::ptrdiff_t>(last),
                  [&](Cell l, Cell r) { return turned(cells, l).rest() < turned(cells, r).rest(); });
        for (std::size_t k = first; k < last; ++k) name(k, turned(cells, cell_[k]));
        return;
    }
    // Sorted by counting: a group has some seven cells, in an order that no processor predicts.
    const std::size_t size = last - first;
    std::array<Turned, few> group;
    std::array<std::uint64_t, few> rest;
    std::array<std::uint8_t, few> order;
    for (std::size_t k = 0; k < size; ++k) {
        if (first + k + ahead < end) __builtin_prefetch(&cells.cells[cell_[first + k + ahead]]);
        group[k] = turned(cells, cell_[first + k]);
        rest[k] = group[k].rest();
    }
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t less = 0;
        for (std::size_t i = 0; i < size; ++i) less += rest[i] < rest[k] ? 1U : 0U;
        order[less] = static_cast<std::uint8_t>(k);
    }
    for (std::size_t k = 0; k < size; ++k) name(first + k, group[order[k]]);
}

extern template class Cell_order<2>;
extern template class Cell_order<3>;

}  // namespace annulus::inline v1
