// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/cell_order.h>

#include <atomic>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Adds one and returns the previous value. Several threads may do so at once where it is `shared`.
template <bool shared>
std::uint32_t add_one(std::uint32_t& x) {
    if constexpr (shared) return std::atomic_ref(x).fetch_add(1, std::memory_order_relaxed);
    else return x++;
}

}  // namespace

template <int d>
std::uint8_t Cell_order<d>::turn_of(const std::array<Rank, corners>& v, Rank infinity) {
    const auto rank = [&](std::size_t i) { return v[i] == infinity ? Rank{-1} : v[i]; };
    std::size_t top = 0;
    for (std::size_t i = 1; i < corners; ++i) top = rank(i) > rank(top) ? i : top;
    if constexpr (d == 2) {
        return static_cast<std::uint8_t>(top);
    } else {
        static constexpr auto others = facing<d>();
        const Rank a = v[others[top][0]], b = v[others[top][1]], c = v[others[top][2]];
        const std::size_t second = b < a ? 1 : 0;
        const std::size_t least = c < std::min(a, b) ? 2 : second;
        return static_cast<std::uint8_t>(3 * top + least);
    }
}

template <int d>
template <bool shared>
void Cell_order<d>::count(const Cells& cells, std::size_t first, std::size_t last) {
    static constexpr Slots old = old_slots();
    for (std::size_t c = first; c < last; ++c) {
        number_[c] = Cells::no_cell;
        if (!cells.is_cell(static_cast<Cell>(c))) continue;
        const auto& v = cells.cells[c].vertex;
        turn_[c] = turn_of(v, cells.infinity);
        number_[c] = static_cast<std::uint32_t>(v[old[turn_[c]][0]]);
        (void)add_one<shared>(end_[number_[c]]);
    }
}

template <int d>
template <bool shared>
void Cell_order<d>::place(std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c)
        if (number_[c] != Cells::no_cell) cell_[add_one<shared>(end_[number_[c]])] = static_cast<Cell>(c);
}

template <int d>
std::size_t Cell_order<d>::group(const Cells& cells, int threads) {
    end_.assign(static_cast<std::size_t>(cells.infinity), 0);
    if (number_.size() < cells.used) number_.resize(cells.used);
    if (turn_.size() < cells.used) turn_.resize(cells.used);
    for_each_run(cells.used, run, threads, [&](std::size_t first, std::size_t last) {
        if (threads > 1) count<true>(cells, first, last);
        else count<false>(cells, first, last);
    });
    std::size_t size = 0;
    for (std::uint32_t& e : end_) e = static_cast<std::uint32_t>(std::exchange(size, size + e));
    cell_.resize(size);
    for_each_run(cells.used, run, threads, [&](std::size_t first, std::size_t last) {
        if (threads > 1) place<true>(first, last);
        else place<false>(first, last);
    });
    return size;
}

template class Cell_order<2>;
template class Cell_order<3>;

}  // namespace annulus::inline v1
