// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/repair.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/chooser.h>
#include <annulus/engine/prices.h>
#include <annulus/mesh/border.h>
#include <annulus/mesh/distinct_facets.h>

#include <algorithm>
#include <iterator>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

template <int d>
void Repair<d>::begin(std::span<const Coordinates<d>> x, bool many) {
    many_ = many;
    signs_ = hopeless_ = false;
    aside_ = 0.0;
    counted_ = {};
    mender_.begin(x);
    forget();
    x_ = x;
    grow(suspects_of_, mesh_.table().cell_bound());
    disturbed_.clear();
    reinserted_.clear();
    changed_.clear();
    renumbered_.clear();
    mending_ = false;
    report_ = {};
}

template <int d>
void Repair<d>::forget() {
    if (placed_) {
        for (const auto& s : facets_) suspects_of_[Cell_table<d>::cell_of(s.id)] = 0;
        for (const auto& s : cells_) suspects_of_[s.id] = 0;
    }
    placed_ = true;
    facets_.clear();
    cells_.clear();
}

template <int d>
void Repair<d>::assign_places() {
    if (placed_) return;
    placed_ = true;
    for (std::size_t i = 0; i < facets_.size(); ++i) enter(facets_[i], Cell_table<d>::cell_of(facets_[i].id), facet_place(i));
    for (std::size_t i = 0; i < cells_.size(); ++i) enter(cells_[i], cells_[i].id, cell_place(i));
}

/// Puts a suspect on the list of its cell.
template <int d>
template <class S>
void Repair<d>::enter(S& s, Cell_index cell, Place place) {
    s.next = suspects_of_[cell];
    suspects_of_[cell] = place;
}

/// Where facet f is, or is put, among the suspects.
template <int d>
auto Repair<d>::suspected_facet(Corner_index f) -> Facet_suspect& {
    assign_places();
    const Cell_index c = Cell_table<d>::cell_of(f);
    if (!suspects_of_.has(c)) grow(suspects_of_, c.offset() + 1);
    for (Place p = suspects_of_[c]; p != 0; p = next(p))
        if (is_facet_place(p) && facets_[place(p)].id == f) return facets_[place(p)];
    facets_.emplace_back();
    enter(facets_.back(), c, facet_place(facets_.size() - 1));
    return facets_.back();
}

template <int d>
auto Repair<d>::suspected_cell(Cell_index c) -> Cell_suspect& {
    assign_places();
    if (!suspects_of_.has(c)) grow(suspects_of_, c.offset() + 1);
    for (Place p = suspects_of_[c]; p != 0; p = next(p))
        if (!is_facet_place(p)) return cells_[place(p)];
    cells_.emplace_back();
    enter(cells_.back(), c, cell_place(cells_.size() - 1));
    return cells_.back();
}

template <int d>
void Repair<d>::describe(Facet_suspect& s, Corner_index f) const {
    s.id = f;
    s.stale = true;
    const Facet_certificate<d> facet = facet_certificate(mesh_.table(), f, kind_ == Tolerance_kind::paper);
    s.kind = facet.kind;
    s.point = facet.point;
}

template <int d>
void Repair<d>::describe(Cell_suspect& s, Cell_index c) const {
    s.id = c;
    s.stale = true;
    s.point = cell_points(mesh_.table(), c);
    const bool infinite_cell = std::find(s.point.begin(), s.point.end(), infinite) != s.point.end();
    s.kind = infinite_cell ? Facet_kind::nothing : Facet_kind::empty_sphere;
}

template <int d>
void Repair<d>::suspect_facet(Corner_index f) {
    describe(suspected_facet(f), f);
}

template <int d>
void Repair<d>::suspect_cell(Cell_index c) {
    describe(suspected_cell(c), c);
}

template <int d>
void Repair<d>::suspect_everything() {
    const auto& t = mesh_.table();
    for (const Corner_index f : t.facets()) suspect_facet(f);
    for (const Cell_index c : t.cells()) suspect_cell(c);
}

template <int d>
void Repair<d>::suspect_star(Index v) {
    const auto& t = mesh_.table();
    const bool alone = facets_.empty() && cells_.empty();
    if (alone) placed_ = false;
    for_each_certificate(
        t, v,
        [&](Corner_index h) {
            const Cell_index c = t.cell_of(h);
            describe(alone ? cells_.emplace_back() : suspected_cell(c), c);
        },
        [&](Corner_index h) {
            const Corner_index f = t.facet(h);
            describe(alone ? facets_.emplace_back() : suspected_facet(f), f);
        });
}

template <int d>
void Repair<d>::suspect_cells(std::span<const Cell_index> cells) {
    const auto& t = mesh_.table();
    for (const Cell_index c : cells) {
        suspect_cell(c);
        for (int i = 0; i <= d; ++i) suspect_facet(t.facet(t.corner(c, i)));
    }
}

template <int d>
void Repair<d>::note_disturbed(const Facet_points<d>& points) {
    for (const Index v : points)
        if (v != none) disturbed_.push_back(v);
}

/// Hands what does not hold over to the mender.
template <int d>
void Repair<d>::collect_violated() {
    for (const auto& s : cells_) {
        if (!violated(s)) continue;
        mender_.signs().inverted().push_back(s.id);
        disturbed_.insert(disturbed_.end(), s.point.begin(), s.point.end());
    }
    for (const auto& s : facets_) {
        if (s.kind == Facet_kind::nothing || s.verdict.sign > 0) continue;
        mender_.signs().violated().push_back(s.id);
        if (s.kind == Facet_kind::empty_sphere && s.verdict.sign == 0) continue;  // degenerate, not violated yet
        note_disturbed(s.point);
    }
}

template <int d>
bool Repair<d>::mend_all(std::span<const Coordinates<d>> old, double most) {
    std::vector<Coordinates<d>> trial(x_.begin(), x_.end());
    return mend({trial, old}, most);
}

template <int d>
bool Repair<d>::mend_one(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& old, double most) {
    if (collides(v, old)) throw Error(Error_code::collision, "another vertex is at that position");
    if (mend({x, {}, v, old}, std::min(most, Prices<d>::reinsertion))) return true;
    if (!trusted_) return false;  // nor need it be simplicial then, which restoring wants
    const Coordinates<d> goal = std::exchange(x[at(v)], old);
    mesh_.restore_cells(x, mender_.touched(), renumbered_);
    aside_ += Prices<d>::flip * static_cast<double>(mender_.touched().size());
    const double price = reinsertion_price(v);
    if (price <= Chooser<d>::most_generous_rebuild(mesh_.vertices()) && reinsert(x, v, goal, price)) return true;
    x[at(v)] = goal;
    return false;
}

/// Of taking v out and putting it back in: the gap is filled with the triangulation of its neighbours, which in the plane
/// takes the square of their number where it goes badly.
template <int d>
double Repair<d>::reinsertion_price(Index v) const {
    double cells = 0.0;
    mesh_.table().for_each_corner(v, [&cells](Corner_index) { ++cells; });
    const double filling = d == 2 ? Prices<d>::insertion * cells + 0.05 * cells * cells : Prices<d>::insertion * cells;
    return std::max(Prices<d>::reinsertion, filling);
}

template <int d>
bool Repair<d>::reinsert(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& goal, double price) {
    const auto gone = [this](Cell_index c) { return !mesh_.table().is_cell(c); };
    std::vector<Cell_index> changed;
    try {
        if (!mesh_.reinsert(x, v, goal, changed)) return false;
    } catch (const Error&) {
        renumbered_.insert(renumbered_.end(), changed.begin(), changed.end());
        std::erase_if(renumbered_, gone);
        throw;
    }
    aside_ += price + Prices<d>::flip * static_cast<double>(changed.size());
    changed_ = std::move(changed);
    changed_.insert(changed_.end(), renumbered_.begin(), renumbered_.end());
    std::erase_if(changed_, gone);
    reinserted_.assign(1, v);
    many_ = true;
    signs_ = false;
    forget();  // what was evaluated before may have the number of something else by now
    suspect_cells(changed_);
    suspect_star(v);
    return evaluate();
}

template <int d>
bool Repair<d>::mend(const Course<d>& course, double most) {
    if (hopeless_ || mender_.price() > most) return false;
    if (!signs_) collect_violated();
    assign_places();
    mending_ = true;
    const bool mended = mender_.mend(course, most);
    count_signs();
    if (mended && holds_after_mending(most - mender_.price())) {
        report_.flips += mender_.flips();
        changed_ = mender_.touched();
        reinserted_ = mender_.reinserted();
        return true;
    }
    report_.undone_flips += mender_.flips();
    return false;
}

template <int d>
bool Repair<d>::holds_after_mending(double most) {
    const auto& t = mesh_.table();
    std::vector<Cell_index> alive;
    std::copy_if(mender_.touched().begin(), mender_.touched().end(), std::back_inserter(alive),
                 [&t](Cell_index c) { return t.is_cell(c); });
    // Where tolerances may be wrong, flips may have begun in what was no Delaunay triangulation.
    if (!certified() && !facets_are_distinct_around<d>(t, alive)) return false;
    // Even one mover may have passed over a part of the hull that its cells do not touch.
    const bool at_border = std::any_of(alive.begin(), alive.end(), [&t](Cell_index c) { return t.is_infinite(c); });
    many_ |= at_border;
    if (at_border && mender_.built_anew() && !border_is_whole(t)) return false;
    if (signs_) return border_holds();
    // Their tolerances are to be paid for too, and what later stages cost nobody knows before.
    const std::size_t chunk = std::max(alive.size() / 16, std::size_t{128});
    const double before = evaluation_price();
    for (std::span<const Cell_index> left(alive); !left.empty();) {
        const std::size_t facets = facets_.size();
        const std::size_t cells = cells_.size();
        suspect_cells(left.first(std::min(chunk, left.size())));
        left = left.subspan(std::min(chunk, left.size()));
        if (left.empty()) break;
        // Those that are new; suspects of before that have become stale again come last, with evaluate().
        evaluate_stale(std::span(facets_).subspan(facets));
        evaluate_stale(std::span(cells_).subspan(cells));
        if (evaluation_price() - before > most) return false;
    }
    return evaluate();
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
