// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/clear_cells.h>

#include <annulus/mesh/four_cells.h>

#include <algorithm>
#include <array>

namespace annulus::inline v1 {

namespace {

/// Four finite cells. A corner of a cell stands in for infinity.
template <int d>
struct Finite_cells {
    ANNULUS_INLINE Finite_cells(const Corner_table<d>& t, const Coordinates<d>* positions,
                                const std::array<Cell_index, 4>& c)
        : x(positions) {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k <= d; ++k) {
                const Corner_index h = t.corner(c[i], static_cast<int>(k));
                const Index v = t.vertex(t.twin(h));
                vertex[k][i] = t.vertex(h);
                opposite[k][i] = v == infinite ? vertex[0][i] : v;
            }
    }
    ANNULUS_INLINE four_cells::Vector<d> corner(std::size_t k) const { return four_cells::read<d>(x, vertex[k]); }
    ANNULUS_INLINE four_cells::Vector<d> beyond(std::size_t k) const { return four_cells::read<d>(x, opposite[k]); }

    const Coordinates<d>* x;
    std::array<std::array<Index, 4>, d + 1> vertex, opposite;
};

template <int d>
ANNULUS_AVX2 std::size_t find_clear(const Corner_table<d>& table, std::span<const Coordinates<d>> x, Cell_index first,
                                    Cell_index last, std::vector<Cell_index>& rest) {
    std::size_t count = 0;
    std::array<Cell_index, 4> four;
    std::size_t size = 0;
    for (Cell_index c = first; c < last; ++c) {
        // The positions of a cell's neighbours are three dependent loads away.
        constexpr Index ahead = 16;
        if (const Cell_index far(c.value() + 2 * ahead); d == 3 && far < last)
            for (int i = 0; i <= d; ++i) table.prefetch_opposite(table.corner(far, i));
        if (const Cell_index far(c.value() + ahead); far < last)
            for (int i = 0; i <= d; ++i)
                if (const Corner_index t = table.twin(table.corner(far, i)); t != no_corner)
                    __builtin_prefetch(&x[static_cast<std::size_t>(std::max(table.vertex(t), Index{0}))]);
        if (!table.is_cell(c)) continue;
        if (table.is_infinite(c)) {
            rest.push_back(c);
            continue;
        }
        four[size] = c;
        if (++size < 4) continue;
        size = 0;
        const auto clear = four_cells::are_clear<d>(Finite_cells<d>(table, x.data(), four));
        for (std::size_t i = 0; i < 4; ++i) {
            if (clear[i] != 0) ++count;
            else rest.push_back(four[i]);
        }
    }
    rest.insert(rest.end(), four.begin(), four.begin() + static_cast<std::ptrdiff_t>(size));
    return count;
}

}  // namespace

bool has_fast_clear_cells() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
#else
    return false;
#endif
}

template <int d>
std::size_t clear_cells(const Corner_table<d>& table, std::span<const Coordinates<d>> x, Cell_index first,
                        Cell_index last, std::vector<Cell_index>& rest) {
    return find_clear<d>(table, x, first, last, rest);
}

template std::size_t clear_cells(const Corner_table<2>&, std::span<const Coordinates<2>>, Cell_index, Cell_index,
                                 std::vector<Cell_index>&);
template std::size_t clear_cells(const Corner_table<3>&, std::span<const Coordinates<3>>, Cell_index, Cell_index,
                                 std::vector<Cell_index>&);

}  // namespace annulus::inline v1
