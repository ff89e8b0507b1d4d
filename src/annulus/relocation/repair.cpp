// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/relocation/repair.h>

#include <algorithm>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

template <int d>
void Repair<d>::begin(std::span<const Coordinates<d>> x, bool many) {
    many_ = many;
    everything_ = false;
    forget();
    x_ = x;
    const auto& t = embedding_.table();
    place_of_facet_.resize(at(t.facet_bound()), 0);
    place_of_cell_.resize(at(t.cell_bound()), 0);
    disturbed_.clear();
    detached_.clear();
    changed_.clear();
    rebuilt_ = false;
    mending_ = false;
    log_.clear();
    report_ = {};
}

template <int d>
void Repair<d>::forget() {
    if (placed_) {
        for (const auto& s : facets_) place_of_facet_[at(s.id)] = 0;
        for (const auto& s : cells_) place_of_cell_[at(s.id)] = 0;
    }
    placed_ = true;
    facets_.clear();
    cells_.clear();
}

template <int d>
void Repair<d>::assign_places() {
    if (placed_) return;
    placed_ = true;
    for (std::size_t i = 0; i < facets_.size(); ++i) place_of_facet_[at(facets_[i].id)] = static_cast<Index>(i + 1);
    for (std::size_t i = 0; i < cells_.size(); ++i) place_of_cell_[at(cells_[i].id)] = static_cast<Index>(i + 1);
}

/// Where a facet or a cell is, or is put, among the suspects of its kind.
template <int d>
template <class Suspects>
typename Suspects::value_type& Repair<d>::suspected(Suspects& suspects, std::vector<Index>& places, Index id) {
    assign_places();
    if (at(id) >= places.size()) places.resize(at(id) + 1, 0);
    Index& place = places[at(id)];
    if (place == 0) {
        suspects.emplace_back();
        place = static_cast<Index>(suspects.size());
    }
    return suspects[at(place - 1)];
}

/// Facet f, seen from half-facet h.
template <int d>
void Repair<d>::describe(Facet_suspect& s, Index f, Index h) const {
    s.id = f;
    s.stale = true;
    const Facet_certificate<d> facet = facet_certificate(embedding_.table(), h, kind_ == Tolerance_kind::paper);
    s.kind = facet.kind;
    s.point = facet.point;
}

template <int d>
void Repair<d>::describe(Cell_suspect& s, Index c) const {
    s.id = c;
    s.stale = true;
    s.point = cell_points(embedding_.table(), c);
    const bool infinite_cell = std::find(s.point.begin(), s.point.end(), infinite) != s.point.end();
    s.kind = infinite_cell ? Facet_kind::border : Facet_kind::empty_sphere;
}

template <int d>
void Repair<d>::suspect_facet(Index f, Facet_kind kind, const Facet_points<d>& points) {
    Facet_suspect& s = suspected(facets_, place_of_facet_, f);
    s.id = f;
    s.stale = true;
    s.point = points;
    s.kind = kind;
}

template <int d>
void Repair<d>::suspect_facet(Index f) {
    describe(suspected(facets_, place_of_facet_, f), f, embedding_.table().half(f));
}

template <int d>
void Repair<d>::suspect_cell(Index c) {
    describe(suspected(cells_, place_of_cell_, c), c);
}

template <int d>
void Repair<d>::suspect_everything() {
    const auto& t = embedding_.table();
    for (Index f = 0; f < t.facet_bound(); ++f)
        if (t.is_facet(f)) suspect_facet(f);
    for (Index c = 0; c < t.cell_bound(); ++c)
        if (t.is_cell(c)) suspect_cell(c);
}

template <int d>
void Repair<d>::suspect_star(Index v) {
    const auto& t = embedding_.table();
    const bool alone = facets_.empty() && cells_.empty();
    if (alone) placed_ = false;
    for_each_certificate(
        t, v,
        [&](Index h) {
            const Index c = t.cell_of(h);
            describe(alone ? cells_.emplace_back() : suspected(cells_, place_of_cell_, c), c);
        },
        [&](Index h) {
            const Index f = t.facet(h);
            describe(alone ? facets_.emplace_back() : suspected(facets_, place_of_facet_, f), f, h);
        });
}

template <int d>
void Repair<d>::suspect_cells(std::span<const Index> cells) {
    const auto& t = embedding_.table();
    for (const Index c : cells) {
        suspect_cell(c);
        for (int i = 0; i <= d; ++i) suspect_facet(t.facet(t.corner(c, i)));
    }
}

template <int d>
void Repair<d>::suspect_around(std::span<const Index> cells) {
    const auto& t = embedding_.table();
    changed_.insert(changed_.end(), cells.begin(), cells.end());
    suspect_cells(cells);
    for (const Index c : cells)
        for (int i = 0; i <= d; ++i) queue_.push_back(t.facet(t.corner(c, i)));
}

template <int d>
void Repair<d>::list_changes(Move_report& report) const {
    const auto& t = embedding_.table();
    const auto list = [&](Index c) {
        if (!t.is_cell(c)) return;
        for (int i = 0; i <= d; ++i) report.changed.push_back(t.vertex(t.corner(c, i)));
    };
    if (rebuilt_) {
        for (Index c = 0; c < t.cell_bound(); ++c) list(c);
    } else {
        for (const Index c : changed_) list(c);
    }
}

template <int d>
void Repair<d>::collect_violated() {
    queue_.clear();
    inverted_.clear();
    for (const auto& s : cells_) {
        if (!exists(s) || !violated(s)) continue;
        inverted_.push_back(s.id);
        disturbed_.insert(disturbed_.end(), s.point.begin(), s.point.end());
    }
    for (const auto& s : facets_) {
        if (!exists(s) || s.verdict.sign > 0) continue;
        queue_.push_back(s.id);
        if (s.kind == Facet_kind::empty_sphere && s.verdict.sign == 0) continue;  // degenerate, not violated yet
        for (const Index v : s.point)
            if (v != none) disturbed_.push_back(v);
    }
}

template <int d>
typename Repair<d>::Outcome Repair<d>::mend(std::span<const Coordinates<d>> old, std::span<const Index> movers) {
    assign_places();
    mending_ = true;
    collect_violated();
    if (run_flips() == Progress::done) return Outcome::flipped;
    undo_flips();
    require_distinct(movers);
    // Without certified tolerances the triangulation may be wrong in places nobody suspects; CGAL's removal and
    // location need a right one, a rebuild does not.
    if (trusted_ && reinsert(old, movers)) return Outcome::reinserted;
    forget();
    detached_.clear();
    embedding_.rebuild(x_);
    rebuilt_ = true;
    return Outcome::rebuilt;
}

template <int d>
void Repair<d>::undo_flips() {
    report_.undone_flips += log_.size();
    report_.flips -= log_.size();
    take_back_flips();
    // What is under examination has other points again.
    std::vector<Index> again;
    for (const auto& s : cells_)
        if (exists(s)) again.push_back(s.id);
    for (const Index c : again) suspect_cell(c);
    again.clear();
    for (const auto& s : facets_)
        if (exists(s)) again.push_back(s.id);
    for (const Index f : again) suspect_facet(f);
    (void)evaluate();
    const std::size_t known = disturbed_.size();
    collect_violated();
    disturbed_.resize(known);
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
