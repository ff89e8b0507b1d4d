// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/periodic_region.h>

#include <algorithm>
#include <functional>
#include <tuple>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t stays = ~std::size_t{0};

/// Room for more entries, so that a growth by few costs O(1) on average.
template <class T>
void make_room(std::vector<T>& v, std::size_t size) {
    if (v.capacity() < size) v.reserve(std::max(size, 2 * v.size()));
}

}  // namespace

template <int d>
std::size_t Periodic_region<d>::gone_number(std::size_t cell) const {
    const auto k = std::lower_bound(index_.begin(), index_.end(), std::array<std::size_t, 2>{cell, 0});
    return k != index_.end() && (*k)[0] == cell ? (*k)[1] : stays;
}

template <int d>
bool Periodic_region<d>::find_border(const Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone) {
    index_.clear();
    for (std::size_t k = 0; k < gone.size(); ++k) index_.push_back({gone[k].cell, k});
    std::sort(index_.begin(), index_.end());
    for (std::size_t k = 1; k < index_.size(); ++k)
        if (index_[k - 1][0] == index_[k][0]) return false;
    border_.clear();
    for (const Lifted_cell<d>& g : gone)
        for (std::size_t i = 0; i < corners; ++i) {
            const Lifted_cell<d> m = beyond<d>(table, g, i);
            const std::size_t other = gone_number(m.cell);
            if (other != stays && gone[other] == m) continue;  // inside
            const Corner_index twin = table.twin[g.cell][i];
            Border_facet& b = border_.emplace_back();
            if (other == stays) b.outer = twin;
            else b.partner = facet_images<d>(table.images(gone[other].cell, gone[other].shift), table.slot_of(twin));
            sides_.push_back({facet_images<d>(table.images(g.cell, g.shift), i), border_.size() - 1});
        }
    return true;
}

/// Every facet has two sides: two of new cells, or one of a new cell and one of the border.
template <int d>
bool Periodic_region<d>::match(std::size_t halves) {
    std::sort(sides_.begin(), sides_.end(), [](const Side& l, const Side& r) {
        return l.images != r.images ? l.images < r.images : l.number < r.number;
    });
    partner_.assign(halves, stays);
    if (sides_.size() % 2 != 0) return false;
    for (std::size_t k = 0; k < sides_.size(); k += 2) {
        const auto& [images, a] = sides_[k];
        const std::size_t b = sides_[k + 1].number;
        if (images != sides_[k + 1].images || a >= halves || a / corners == b / corners) return false;
        if (k > 0 && images == sides_[k - 1].images) return false;
        partner_[a] = b;
        if (b < halves) partner_[b] = a;
        else border_[b - halves].half = a;
    }
    return true;
}

/// The new cells as they will be in the table, which has so many.
template <int d>
bool Periodic_region<d>::find_cells(std::size_t cells, std::span<const Lifted_cell<d>> gone,
                                    std::span<const Cell_images<d>> came) {
    const std::size_t halves = came.size() * corners;
    numbers_.made.clear();
    numbers_.unused.clear();
    for (std::size_t k = 0; k < came.size(); ++k)
        numbers_.made.push_back(k < gone.size() ? gone[k].cell : cells + (k - gone.size()));
    for (std::size_t k = came.size(); k < gone.size(); ++k) numbers_.unused.push_back(gone[k].cell);
    new_.clear();
    for (std::size_t k = 0; k < came.size(); ++k) {
        Cell& cell = new_.emplace_back();
        cell.cospherical = {};
        for (std::size_t i = 0; i < corners; ++i) {
            cell.vertex[i] = came[k][i].vertex;
            cell.offset[i] = came[k][i].label;
            const std::size_t p = partner_[k * corners + i];
            if (p < halves) {
                cell.twin[i] = half(p);
                continue;
            }
            const Border_facet& b = border_[p - halves];
            cell.twin[i] = b.outer;
            if (b.outer != no_corner) continue;
            const auto s = std::lower_bound(sides_.begin(), sides_.end(), b.partner,
                                            [](const Side& l, const Facet_images<d>& r) { return l.images < r; });
            if (s == sides_.end() || s->images != b.partner || (s + 1)->number < halves) return false;
            cell.twin[i] = half(border_[(s + 1)->number - halves].half);
        }
        if (!normalise<d>(cell.offset)) return false;
    }
    return true;
}

template <int d>
void Periodic_region<d>::write(Periodic_table<d>& table, std::size_t c, const Cell& cell) noexcept {
    std::tie(table.vertex[c], table.offset[c], table.twin[c], table.cospherical[c]) =
        std::tie(cell.vertex, cell.offset, cell.twin, cell.cospherical);
}

template <int d>
bool Periodic_region<d>::replace(Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone,
                                 std::span<const Cell_images<d>> came) {
    const std::size_t halves = came.size() * corners;
    sides_.clear();
    if (!find_border(table, gone)) return false;
    for (Side& s : sides_) s.number += halves;
    for (std::size_t h = 0; h < halves; ++h) sides_.push_back({facet_images<d>(came[h / corners], h % corners), h});
    if (!match(halves) || !find_cells(table.size(), gone, came)) return false;
    old_.clear();
    for (const auto& [cell, k] : index_) old_.push_back(cell_of(table, cell));
    cells_before_ = table.size();
    const std::size_t size = cells_before_ + (came.size() > gone.size() ? came.size() - gone.size() : 0);
    make_room(table.vertex, size);
    make_room(table.offset, size);
    make_room(table.twin, size);
    make_room(table.cospherical, size);
    table.vertex.resize(size);
    table.offset.resize(size);
    table.twin.resize(size);
    table.cospherical.resize(size);
    for (std::size_t k = 0; k < new_.size(); ++k) write(table, numbers_.made[k], new_[k]);
    for (const Border_facet& b : border_)
        if (b.outer != no_corner) table.twin[table.cell_of(b.outer)][table.slot_of(b.outer)] = half(b.half);
    return true;
}

template <int d>
void Periodic_region<d>::undo(Periodic_table<d>& table) noexcept {
    table.vertex.resize(cells_before_);
    table.offset.resize(cells_before_);
    table.twin.resize(cells_before_);
    table.cospherical.resize(cells_before_);
    for (std::size_t k = 0; k < index_.size(); ++k) write(table, index_[k][0], old_[k]);
    for (const auto& [cell, k] : index_)
        for (std::size_t i = 0; i < corners; ++i) {
            const Corner_index t = table.twin[cell][i];
            table.twin[table.cell_of(t)][table.slot_of(t)] = table.corner(cell, i);
        }
}

template <int d>
void Periodic_region<d>::keep(Periodic_table<d>& table) noexcept {
    std::sort(numbers_.unused.begin(), numbers_.unused.end(), std::greater<>());  // the order of close_gaps
    for (const std::size_t c : numbers_.unused) {
        table.cospherical[c] = table.cospherical.back();
        table.cospherical.pop_back();
    }
    close_gaps<d>(table, numbers_.unused);
}

template class Periodic_region<2>;
template class Periodic_region<3>;

}  // namespace annulus::inline v1
