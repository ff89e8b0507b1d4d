// SPDX-License-Identifier: GPL-3.0-or-later
// Certificate_checker: the list of pending certificates. Their values: certificate_checker_evaluate.cpp.
#include <annulus/engine/certificate_checker.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

template <int d>
void Certificate_checker<d>::begin(std::span<const Coordinates<d>> x) {
    clear();
    x_ = x;
    changing_ = false;
}

template <int d>
void Certificate_checker<d>::clear() {
    if (placed_) {
        for (const auto& s : facets_) entries_of_[Corner_table<d>::cell_of(s.id)] = 0;
        for (const auto& s : cells_) entries_of_[s.id] = 0;
    }
    placed_ = true;
    facets_.clear();
    cells_.clear();
}

template <int d>
void Certificate_checker<d>::assign_places() {
    if (placed_) return;
    grow(entries_of_, table_.cell_bound());  // first, because it may throw
    placed_ = true;
    for (std::size_t i = 0; i < facets_.size(); ++i)
        enter(facets_[i], Corner_table<d>::cell_of(facets_[i].id), facet_place(i));
    for (std::size_t i = 0; i < cells_.size(); ++i) enter(cells_[i], cells_[i].id, cell_place(i));
}

/// The first entry of a cell. The array has no memory before it is needed: signs alone never do.
template <int d>
auto Certificate_checker<d>::first_entry_of(Cell_index cell) -> Place& {
    if (!entries_of_.has(cell)) grow(entries_of_, std::max(table_.cell_bound(), Cell_index(cell.value() + 1)));
    return entries_of_[cell];
}

/// Links an entry into the list of its cell.
template <int d>
template <class S>
void Certificate_checker<d>::enter(S& s, Cell_index cell, Place place) {
    s.next = std::exchange(first_entry_of(cell), place);
}

/// The entry of facet f; created if there is none.
template <int d>
auto Certificate_checker<d>::entry(Corner_index f) -> Pending_facet& {
    assign_places();
    const Cell_index c = Corner_table<d>::cell_of(f);
    for (Place p = first_entry_of(c); p != 0; p = next(p))
        if (is_facet_place(p) && facets_[place(p)].id == f) return facets_[place(p)];
    facets_.emplace_back();
    enter(facets_.back(), c, facet_place(facets_.size() - 1));
    return facets_.back();
}

template <int d>
auto Certificate_checker<d>::entry(Cell_index c) -> Pending_cell& {
    assign_places();
    for (Place p = first_entry_of(c); p != 0; p = next(p))
        if (!is_facet_place(p)) return cells_[place(p)];
    cells_.emplace_back();
    enter(cells_.back(), c, cell_place(cells_.size() - 1));
    return cells_.back();
}

template <int d>
void Certificate_checker<d>::describe(Pending_facet& s, Corner_index f) const {
    s.id = f;
    s.stale = true;
    const Facet_certificate<d> facet = facet_certificate(table_, f, false);
    s.kind = facet.kind;
    s.point = facet.point;
}

template <int d>
void Certificate_checker<d>::describe(Pending_cell& s, Cell_index c) const {
    s.id = c;
    s.stale = true;
    s.point = cell_sites(table_, c);
    const bool infinite_cell =
        std::any_of(s.point.begin(), s.point.end(), [](Site<d> p) { return p.vertex == infinite; });
    s.kind = infinite_cell ? Facet_kind::nothing : Facet_kind::empty_sphere;
}

template <int d>
void Certificate_checker<d>::add_facet(Corner_index f) {
    describe(entry(f), f);
}

template <int d>
void Certificate_checker<d>::add_cell(Cell_index c) {
    describe(entry(c), c);
}

template <int d>
void Certificate_checker<d>::add_new_facet(Corner_index f) {
    placed_ = placed_ && !(facets_.empty() && cells_.empty());
    describe(placed_ ? entry(f) : facets_.emplace_back(), f);
}

template <int d>
void Certificate_checker<d>::add_new_cell(Cell_index c) {
    placed_ = placed_ && !(facets_.empty() && cells_.empty());
    describe(placed_ ? entry(c) : cells_.emplace_back(), c);
}

template <int d>
void Certificate_checker<d>::release_memory() noexcept {
    placed_ = true;
    release(facets_);
    release(cells_);
    release(entries_of_);
}

template <int d>
void Certificate_checker<d>::add_star(Index v) {
    const bool alone = facets_.empty() && cells_.empty();
    if (alone) placed_ = false;
    for_each_certificate(
        table_, v,
        [&](Corner_index h) {
            const Cell_index c = Corner_table<d>::cell_of(h);
            describe(alone ? cells_.emplace_back() : entry(c), c);
        },
        [&](Corner_index h) {
            const Corner_index f = table_.facet(h);
            describe(alone ? facets_.emplace_back() : entry(f), f);
        });
}

template <int d>
void Certificate_checker<d>::add_cells(std::span<const Cell_index> cells) {
    for (const Cell_index c : cells) {
        add_cell(c);
        for (int i = 0; i <= d; ++i) add_facet(table_.facet(table_.corner(c, i)));
    }
}

template class Certificate_checker<2>;
template class Certificate_checker<3>;

}  // namespace annulus::inline v1
