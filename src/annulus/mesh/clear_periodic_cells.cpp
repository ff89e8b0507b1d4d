// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/clear_periodic_cells.h>

#include <annulus/mesh/four_cells.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>

namespace annulus::inline v1 {

namespace {

/// L o for the offsets o from -1 to 2 along each basis vector, which are those of nearly all sites.
template <int d>
class Near_shifts {
  public:
    explicit Near_shifts(const Lattice<d>& lattice) {
        for (std::size_t k = 0; k < shift_.size(); ++k) {
            Shift<d> o{};
            for (std::size_t j = 0; j < d; ++j) o[j] = static_cast<std::int32_t>((k >> (2 * j)) & 3U) - 1;
            shift_[k] = lattice.place({}, Offset<d>(o));
        }
    }
    [[nodiscard]] const Coordinates<d>* data() const { return shift_.data(); }
    /// The numbers of packed offsets, of one or of several side by side. Bits of `far` are set where one is none of
    /// these.
    template <class T>
    [[nodiscard, gnu::always_inline]] static inline T number(T packed, T& far) {
        constexpr std::uint32_t ones = d == 2 ? 0x401U : 0x100401U;
        const T from_least = packed + ones;
        far |= from_least & ~(3 * ones);
        return (from_least & 3U) | (from_least >> 8U & 12U) | (from_least >> 16U & 48U);
    }

  private:
    std::array<Coordinates<d>, std::size_t{1} << (2 * d)> shift_;
};

/// Where the cells of a table are in memory, in registers while they are tested.
template <int d>
struct Cells_in_memory {
    explicit Cells_in_memory(const Periodic_table<d>& t) : vertex(t.vertex.data()), twin(t.twin.data()) {}
    [[nodiscard]] Index opposite(std::size_t c, std::size_t k) const {
        const Corner_index h = twin[c][k];
        return vertex[Periodic_table<d>::cell_of(h)][Periodic_table<d>::slot_of(h)];
    }
    const std::array<Index, static_cast<std::size_t>(d + 1)>* vertex;
    const std::array<Corner_index, static_cast<std::size_t>(d + 1)>* twin;
};

/// Four cells without offsets, whose neighbours have none either.
template <int d>
struct Plain_cells {
    void set(const Cells_in_memory<d>& t, std::size_t i, std::size_t c) {
        cell[i] = c;
        for (std::size_t k = 0; k <= d; ++k) {
            vertex[k][i] = t.vertex[c][k];
            opposite[k][i] = t.opposite(c, k);
        }
    }
    ANNULUS_INLINE four_cells::Vector<d> corner(std::size_t k) const { return four_cells::read<d>(x, vertex[k]); }
    ANNULUS_INLINE four_cells::Vector<d> beyond(std::size_t k) const { return four_cells::read<d>(x, opposite[k]); }

    const Coordinates<d>* x;
    std::array<std::size_t, 4> cell{};
    std::array<std::array<Index, 4>, static_cast<std::size_t>(d + 1)> vertex{}, opposite{};
};

using Integers = std::uint32_t __attribute__((vector_size(16)));

/// Four cells with any offsets for which there are near shifts. Sums of places and shifts are not rounded (Lattice).
template <int d>
struct Lifted_cells {
    /// False where an offset is none of the near ones.
    ANNULUS_INLINE bool set(const Periodic_table<d>& t, std::size_t i, std::size_t c) {
        plain.set(Cells_in_memory<d>(t), i, c);
        if constexpr (d == 3) return set_shifts(t, i, c);
        std::uint32_t far = 0;
        for (std::size_t k = 0; k <= d; ++k) {
            const Corner_index h = t.twin[c][k];
            const Offset<d> opposite = t.offset[t.cell_of(h)][t.slot_of(h)] + t.translation(c, k);
            shift[k][i] = number(t.offset[c][k], far);
            opposite_shift[k][i] = number(opposite, far);
        }
        return far == 0;
    }
    [[nodiscard]] static Index number(Offset<d> o, std::uint32_t& far) {
        return static_cast<Index>(Near_shifts<d>::number(static_cast<std::uint32_t>(o.packed()), far));
    }
    /// The same for all corners and facets side by side: Periodic_table::translation modulo 2^32, where a third is the
    /// product with 1/3.
    ANNULUS_INLINE bool set_shifts(const Periodic_table<3>& t, std::size_t i, std::size_t c) {
        constexpr std::uint32_t third = 0xAAAAAAABU;
        const auto read = [&t](std::size_t cell, Integers& x) { std::memcpy(&x, &t.offset[cell], sizeof x); };
        Integers own, a, b, e, f, opposite;
        const auto& twin = t.twin[c];
        read(c, own);
        read(t.cell_of(twin[0]), a);
        read(t.cell_of(twin[1]), b);
        read(t.cell_of(twin[2]), e);
        read(t.cell_of(twin[3]), f);
        for (std::size_t k = 0; k < 4; ++k)
            opposite[k] = static_cast<std::uint32_t>(t.offset[t.cell_of(twin[k])][t.slot_of(twin[k])].packed());
        const Integers ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Integers ef = __builtin_shufflevector(e, f, 0, 4, 1, 5) + __builtin_shufflevector(e, f, 2, 6, 3, 7);
        const Integers sums = __builtin_shufflevector(ab, ef, 0, 1, 4, 5) + __builtin_shufflevector(ab, ef, 2, 3, 6, 7);
        const Integers facet = own[0] + own[1] + own[2] + own[3] - own;
        Integers far{};
        const Integers here = Near_shifts<3>::number(own, far);
        const Integers there = Near_shifts<3>::number(opposite + (facet - (sums - opposite)) * third, far);
        for (std::size_t k = 0; k < 4; ++k) {
            shift[k][i] = static_cast<Index>(here[k]);
            opposite_shift[k][i] = static_cast<Index>(there[k]);
        }
        return (far[0] | far[1] | far[2] | far[3]) == 0;
    }
    ANNULUS_INLINE four_cells::Vector<d> corner(std::size_t k) const {
        return four_cells::sum(plain.corner(k), four_cells::read<d>(shifts, shift[k]));
    }
    ANNULUS_INLINE four_cells::Vector<d> beyond(std::size_t k) const {
        return four_cells::sum(plain.beyond(k), four_cells::read<d>(shifts, opposite_shift[k]));
    }

    Plain_cells<d> plain;
    const Coordinates<d>* shifts;
    std::array<std::array<Index, 4>, static_cast<std::size_t>(d + 1)> shift{}, opposite_shift{};
};

/// Marks the cells in [first, last) that have an offset other than 0, and their neighbours, which other threads may
/// mark, too. In the normal form all images of the bi-cells of the others are representatives.
template <int d>
void mark_lifted(const Periodic_table<d>& table, std::size_t first, std::size_t last, std::uint8_t* lifted) {
    const auto mark = [lifted](std::size_t c) { std::atomic_ref(lifted[c]).store(1, std::memory_order_relaxed); };
    const auto* const offset = table.offset.data();
    for (std::size_t c = first; c < last; ++c) {
        std::int32_t any = 0;
        for (std::size_t k = 0; k <= d; ++k) any |= offset[c][k].packed();
        if (any == 0) continue;
        mark(c);
        for (const Corner_index h : table.twin[c]) mark(table.cell_of(h));
    }
}

template <int d, class Cells>
ANNULUS_INLINE void test_four(const Cells& cells, const std::array<std::size_t, 4>& cell,
                              std::vector<std::size_t>& rest) {
    const auto clear = four_cells::are_clear<d>(cells);
    for (std::size_t i = 0; i < 4; ++i)
        if (clear[i] == 0) rest.push_back(cell[i]);
}

/// Of cells in [first, last) that are not lifted; adds the others to `left`.
template <int d>
ANNULUS_AVX2 void find_unclear_plain(const Periodic_table<d>& table, std::size_t first, std::size_t last,
                                     const std::uint8_t* lifted, const Coordinates<d>* x,
                                     std::vector<std::size_t>& left, std::vector<std::size_t>& rest) {
    constexpr std::size_t ahead = 16;
    const Cells_in_memory<d> t(table);
    Plain_cells<d> four{x};
    std::size_t size = 0;
    for (std::size_t c = first, end = table.size(); c < last; ++c) {
        // The positions of a cell's neighbours are three dependent loads away.
        if (d == 3 && c + 2 * ahead < end)
            for (const Corner_index h : t.twin[c + 2 * ahead]) __builtin_prefetch(&t.vertex[table.cell_of(h)]);
        if (c + ahead < end)
            for (std::size_t k = 0; k <= d; ++k)
                __builtin_prefetch(&x[static_cast<std::size_t>(t.opposite(c + ahead, k))]);
        if (lifted[c] != 0) {
            left.push_back(c);
            continue;
        }
        four.set(t, size, c);
        if (++size < 4) continue;
        size = 0;
        test_four<d>(four, four.cell, rest);
    }
    rest.insert(rest.end(), four.cell.begin(), four.cell.begin() + static_cast<std::ptrdiff_t>(size));
}

/// Of these cells.
template <int d>
ANNULUS_AVX2 void find_unclear_lifted(const Periodic_table<d>& table, std::span<const std::size_t> cells,
                                      const Near_shifts<d>& shifts, const Coordinates<d>* x,
                                      std::vector<std::size_t>& rest) {
    constexpr std::size_t ahead = 8;
    Lifted_cells<d> four{{x}, shifts.data()};
    std::size_t size = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (k + ahead < cells.size())
            for (const Corner_index h : table.twin[cells[k + ahead]]) {
                __builtin_prefetch(&table.vertex[table.cell_of(h)]);
                __builtin_prefetch(&table.offset[table.cell_of(h)]);
            }
        if (!four.set(table, size, cells[k])) {
            rest.push_back(cells[k]);
            continue;
        }
        if (++size < 4) continue;
        size = 0;
        test_four<d>(four, four.plain.cell, rest);
    }
    rest.insert(rest.end(), four.plain.cell.begin(), four.plain.cell.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace

template <int d>
void Clear_periodic_cells<d>::find(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                   std::span<const Coordinates<d>> x) {
    constexpr std::size_t length = 8192;  // of a run
    const std::size_t cells = table.size();
    lifted_.assign(cells, 0);
    found_.resize((cells + length - 1) / length);
    for_each_run(cells, length, threads_,
                 [&](std::size_t first, std::size_t last) { mark_lifted(table, first, last, lifted_.data()); });
    const Near_shifts<d> shifts(lattice);
    for_each_run(cells, length, threads_, [&](std::size_t first, std::size_t last) {
        Found& found = found_[first / length];
        found.left.clear();
        found.rest.clear();
        find_unclear_plain(table, first, last, lifted_.data(), x.data(), found.left, found.rest);
        find_unclear_lifted(table, std::span<const std::size_t>(found.left), shifts, x.data(), found.rest);
        std::sort(found.rest.begin(), found.rest.end());
    });
    rest_.clear();
    for (const Found& found : found_) rest_.insert(rest_.end(), found.rest.begin(), found.rest.end());
}

template class Clear_periodic_cells<2>;
template class Clear_periodic_cells<3>;

}  // namespace annulus::inline v1
