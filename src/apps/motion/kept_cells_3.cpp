// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/kept_cells_3.h>

#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The vertices stored for a number of the table that is not a cell.
constexpr Index absent = none;
constexpr Index outside = Mesh_cells<3>::outside;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }
std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

bool is_finite_cell(const std::array<Index, 4>& c) { return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[3] >= 0; }

}  // namespace

std::array<Index, 4> in_order(std::array<Index, 4> c) {
    const auto exchange = [&c](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {  // two swaps: even
        std::swap(c[i], c[j]);
        std::swap(c[k], c[l]);
    };
    const auto least = static_cast<std::size_t>(std::min_element(c.begin(), c.end()) - c.begin());
    if (least == 1) exchange(0, 1, 2, 3);
    if (least == 2) exchange(0, 2, 1, 3);
    if (least == 3) exchange(0, 3, 1, 2);
    std::rotate(c.begin() + 1, std::min_element(c.begin() + 1, c.end()), c.end());
    return c;
}

void sort_cells(std::vector<std::array<Index, 4>>& cells, std::size_t n) {
    std::vector<std::size_t> begin(n + 2, 0);
    for (const auto& c : cells) ++begin[at(c[0]) + 2];
    for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::array<Index, 4>> sorted(cells.size());
    for (const auto& c : cells) sorted[begin[at(c[0]) + 1]++] = c;
    for (std::size_t v = 0; v < n; ++v)
        std::sort(sorted.begin() + offset(begin[v]), sorted.begin() + offset(begin[v + 1]));
    cells.swap(sorted);
}

void Kept_cells_3::read(std::vector<std::array<Index, 4>> cells, std::size_t n, int threads) {
    for_each_run(cells.size(), 4096, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) cells[c] = in_order(cells[c]);
    });
    for (const Cell& c : cells)
        if (c[0] < 0 || at(*std::max_element(c.begin(), c.end())) >= n)
            throw Error(Error_code::unknown_vertex, "a cell names no vertex");
    sort_cells(cells, n);
    seen_.clear();
    // Nothing has changed where only infinite cells or cell numbers have.
    if (cells == cells_.vertices) return;
    cells_ = linked(std::move(cells), n, threads);
    known_.assign(cells_.vertices.size(), 0);
    inside_.assign(cells_.vertices.size(), 0);
    moment_.resize(cells_.vertices.size());
}

/// A new cell differs from the cell that had its number before. One that has only changed its number is both gone and
/// fresh, hence neither.
void Kept_cells_3::find_changes(const Corner_table<3>& table) {
    gone_.clear();
    fresh_number_.clear();
    const Cell_index bound = table.cell_bound();
    for (Cell_index c = bound; seen_.has(c); ++c)
        if (is_finite_cell(seen_[c])) gone_.push_back(in_order(seen_[c]));
    seen_.resize(bound.offset(), {absent, absent, absent, absent});
    for (Cell_index c(0); c < bound; ++c) {
        Cell now{absent, absent, absent, absent};
        if (table.is_cell(c))
            now = {table.vertex(table.corner(c, 0)), table.vertex(table.corner(c, 1)), table.vertex(table.corner(c, 2)),
                   table.vertex(table.corner(c, 3))};
        if (now == seen_[c]) continue;
        if (is_finite_cell(seen_[c])) gone_.push_back(in_order(seen_[c]));
        if (is_finite_cell(now)) fresh_number_.push_back(c);
        seen_[c] = now;
    }
}

Index Kept_cells_3::find(const Cell& cell) const {
    const auto place = std::lower_bound(cells_.vertices.begin(), cells_.vertices.end(), cell);
    return static_cast<Index>(place - cells_.vertices.begin());
}

void Kept_cells_3::read(const Corner_table<3>& table, int threads) {
    const bool known = !seen_.empty();
    find_changes(table);
    if (known && 16 * (gone_.size() + fresh_number_.size()) < cells_.vertices.size()) return merge(table);
    std::vector<Cell> all;
    all.reserve(seen_.size());
    std::copy_if(seen_.begin(), seen_.end(), std::back_inserter(all), is_finite_cell);
    By_cell<Cell> seen = std::move(seen_);
    read(std::move(all), at(table.vertex_bound()), threads);
    seen_ = std::move(seen);
}

/// Old cells keep their order and their data; fresh ones are inserted between them. Two old cells are adjacent if they
/// were before, so that only the neighbours of fresh ones are read from the table.
void Kept_cells_3::merge(const Corner_table<3>& table) {
    std::vector<Cell> made;
    for (const Cell_index k : fresh_number_) made.push_back(in_order(seen_[k]));
    std::sort(gone_.begin(), gone_.end());
    std::sort(made.begin(), made.end());
    fresh_.clear();
    std::vector<Cell> lost;
    std::set_difference(made.begin(), made.end(), gone_.begin(), gone_.end(), std::back_inserter(fresh_));
    std::set_difference(gone_.begin(), gone_.end(), made.begin(), made.end(), std::back_inserter(lost));
    if (fresh_.empty() && lost.empty()) return;
    cells_.vertices.swap(before_.vertices);
    cells_.neighbours.swap(before_.neighbours);
    moment_.swap(moment_before_);
    inside_.swap(inside_before_);
    known_.swap(known_before_);
    const std::size_t old = before_.vertices.size(), size = old + fresh_.size() - lost.size();
    cells_.vertices.resize(size);
    cells_.neighbours.resize(size);
    moment_.resize(size);
    inside_.resize(size);
    known_.resize(size);
    new_place_.resize(old);
    std::size_t from = 0, to = 0;
    const auto keep_until = [&](std::size_t end) {
        const auto first = offset(from), last = offset(end), there = offset(to);
        std::copy(before_.vertices.begin() + first, before_.vertices.begin() + last, cells_.vertices.begin() + there);
        std::copy(before_.neighbours.begin() + first, before_.neighbours.begin() + last,
                  cells_.neighbours.begin() + there);
        std::copy(moment_before_.begin() + first, moment_before_.begin() + last, moment_.begin() + there);
        std::copy(inside_before_.begin() + first, inside_before_.begin() + last, inside_.begin() + there);
        std::copy(known_before_.begin() + first, known_before_.begin() + last, known_.begin() + there);
        for (; from < end; ++from) new_place_[from] = static_cast<Index>(to++);
    };
    const auto place_of = [&](const Cell& c) {
        const auto begin = before_.vertices.begin() + offset(from);
        return static_cast<std::size_t>(std::lower_bound(begin, before_.vertices.end(), c) - before_.vertices.begin());
    };
    for (std::size_t g = 0, f = 0; g < lost.size() || f < fresh_.size();) {
        if (f == fresh_.size() || (g < lost.size() && lost[g] < fresh_[f])) {
            keep_until(place_of(lost[g++]));
            new_place_[from++] = outside;
        } else {
            keep_until(place_of(fresh_[f]));
            cells_.vertices[to] = fresh_[f++];
            cells_.neighbours[to] = {outside, outside, outside, outside};
            known_[to++] = 0;
        }
    }
    keep_until(old);
    for (auto& four : cells_.neighbours)
        for (Index& c : four)
            if (c != outside) c = new_place_[at(c)];
    // A second pass for fresh cells, which had no old place to be mapped.
    for (const Cell_index k : fresh_number_) link(table, k);
}

/// Writes the adjacency of a cell of the table, on both sides.
void Kept_cells_3::link(const Corner_table<3>& table, Cell_index number) {
    const Cell cell = in_order(seen_[number]);
    const Index here = find(cell);
    for (int i = 0; i < 4; ++i) {
        const Corner_index h = table.corner(number, i), t = table.twin(h);
        const auto slot = [](const Cell& c, Index v) {
            return static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
        };
        const Cell& beyond = seen_[table.cell_of(t)];
        Index& mine = cells_.neighbours[at(here)][slot(cell, table.vertex(h))];
        mine = outside;
        if (!is_finite_cell(beyond)) continue;
        const Cell other = in_order(beyond);
        mine = find(other);
        cells_.neighbours[at(mine)][slot(other, table.vertex(t))] = here;
    }
}

void Kept_cells_3::measure(const Domain_3& domain, std::span<const Coordinates<3>> position, int threads) {
    const std::size_t n = position.size();
    const bool known = position_.size() == n && domain_ == &domain;
    position_.resize(n);
    moved_.assign(n, 1);
    if (known)
        for_each_run(n, 4096, threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t v = first; v < last; ++v) moved_[v] = position_[v] != position[v];
        });
    domain_ = &domain;
    for_each_run(cells_.vertices.size(), 1024, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            const Cell& v = cells_.vertices[c];
            if (known_[c] != 0 && (moved_[at(v[0])] | moved_[at(v[1])] | moved_[at(v[2])] | moved_[at(v[3])]) == 0)
                continue;
            const Coordinates<3>& a = position[at(v[0])];
            moment_[c] = cell_moment(a, position[at(v[1])], position[at(v[2])], position[at(v[3])]);
            inside_[c] = is_inside(domain, a, moment_[c]) ? 1 : 0;
            known_[c] = 1;
        }
    });
    std::copy(position.begin(), position.end(), position_.begin());
}

}  // namespace annulus::inline v1
