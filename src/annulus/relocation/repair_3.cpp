// SPDX-License-Identifier: GPL-3.0-or-later
// Flips of space: 2-3, 3-2 and, where four points are coplanar, 4-4, with infinity among the vertices like any other. A
// triangulation whose finite cells are all positive is led towards the Delaunay one by flips of violated facets; inverted
// cells are unfolded before. Either may get stuck: then all is taken back, and vertices are taken out instead.
#include <annulus/relocation/repair.h>

#include <algorithm>

namespace annulus {

namespace {
std::size_t at(Index i) { return static_cast<std::size_t>(i); }
}  // namespace

template <>
std::size_t Repair<3>::inverted_among(std::span<const Cell_points<3>> cells) const {
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [this](const Cell_points<3>& c) {
        if (std::find(c.begin(), c.end(), infinite) != c.end()) return false;
        return orientation_verdict({&x_[at(c[0])], &x_[at(c[1])], &x_[at(c[2])], &x_[at(c[3])]}, false).sign <= 0;
    }));
}

template <>
void Repair<3>::flip(const Flip_3& flip, std::vector<Index>& created) {
    Flip_record<3> record;
    for (const Index c : flip.gone()) record.gone.push_back(cell_points(embedding_.table(), c));
    record.came.assign(flip.came().begin(), flip.came().end());
    log_.push_back(std::move(record));
    embedding_.replace(flip.gone(), flip.came(), created);
    ++report_.flips;
    // Even with one mover the border has to be walked when it changes: the mover may have passed over a part of the hull
    // that its cells do not touch.
    const auto touches_infinity = [](const Cell_points<3>& c) {
        return std::find(c.begin(), c.end(), infinite) != c.end();
    };
    many_ |= std::any_of(flip.came().begin(), flip.came().end(), touches_infinity);
}

/// Cells have other numbers after a replacement, so that they are found by their vertices. What was evaluated at the flipped
/// cells is void: the restored cells are suspects again.
template <>
void Repair<3>::take_back_flips() {
    const auto& t = embedding_.table();
    const auto find = [&t](const Cell_points<3>& x) {
        const Index v = x[0] == infinite ? x[1] : x[0];
        Index found = none;
        t.for_each_corner(v, [&](Index h) {
            const Index c = t.cell_of(h);
            if (std::all_of(x.begin(), x.end(), [&](Index w) { return t.slot(c, w) >= 0; })) found = c;
        });
        return found;
    };
    for (; !log_.empty(); log_.pop_back()) {
        std::vector<Index> gone;
        for (const auto& x : log_.back().came) gone.push_back(find(x));
        std::vector<Index> restored;
        embedding_.replace(gone, log_.back().gone, restored);
        suspect_around(restored);
    }
}

/// Flips so that fewer of the cells are inverted than before. False when no flip at c does that.
template <>
bool Repair<3>::unfold(Index c) {
    const auto& t = embedding_.table();
    const auto make = [&](const std::optional<Flip_3>& candidate) {
        if (!candidate) return false;
        std::vector<Cell_points<3>> before;
        for (const Index k : candidate->gone()) before.push_back(cell_points(t, k));
        if (inverted_among(candidate->came()) >= inverted_among(before)) return false;
        std::vector<Index> created;
        flip(*candidate, created);
        suspect_around(created);
        for (const Index k : created)
            if (violated(examine_cell(k))) inverted_.push_back(k);
        return true;
    };
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j < i; ++j)
            if (make(flip_3_2(t, c, i, j))) return true;
    for (int i = 0; i <= 3; ++i)
        if (make(flip_2_3(t, t.corner(c, i)))) return true;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j)
            if (i != j && make(flip_4_4(t, t.corner(c, i), t.corner(c, j)))) return true;
    return false;
}

/// Of the two triangulations of five points (six, for 4-4) one is locally Delaunay. Which flip leads to it need not be found
/// out: the others leave an inverted cell.
template <>
bool Repair<3>::mend_facet(Index h) {
    const auto& t = embedding_.table();
    const auto make = [&](const std::optional<Flip_3>& candidate) {
        if (!candidate || inverted_among(candidate->came()) > 0) return false;
        std::vector<Index> created;
        flip(*candidate, created);
        suspect_around(created);
        return true;
    };
    if (make(flip_2_3(t, h))) return true;
    const Index c = t.cell_of(h);
    const int own = t.slot_of(h);
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j < i; ++j)
            if (i != own && j != own && make(flip_3_2(t, c, i, j))) return true;
    // 4-4 only where the two edges cross, or it could go on for ever.
    const Index p = t.vertex(t.twin(h));
    const Index q = t.vertex(h);
    if (p == infinite || q == infinite) return false;
    for (int i = 0; i <= 3; ++i) {
        if (i == own) continue;
        Cell_points<3> x = cell_points(t, c);
        x[static_cast<std::size_t>(i)] = p;
        if (std::find(x.begin(), x.end(), infinite) != x.end()) continue;
        if (orientation_verdict({&x_[at(x[0])], &x_[at(x[1])], &x_[at(x[2])], &x_[at(x[3])]}, false).sign != 0)
            continue;
        if (make(flip_4_4(t, h, t.corner(c, i)))) return true;
    }
    return false;
}

template <>
Repair<3>::Progress Repair<3>::run_flips() {
    const auto& t = embedding_.table();
    stuck_.clear();
    std::size_t budget = 16 + 16 * inverted_.size();
    // What no flip could mend, though others may help: first inverted cells, then violated facets.
    std::vector<Index> waiting;
    bool flipped = false;
    while (!inverted_.empty() || (flipped && !waiting.empty())) {
        if (inverted_.empty()) {
            std::swap(inverted_, waiting);
            flipped = false;
        }
        const Index c = inverted_.back();
        inverted_.pop_back();
        if (!t.is_cell(c) || t.is_infinite(c) || !violated(examine_cell(c))) continue;
        if (unfold(c)) {
            flipped = true;
            if (--budget == 0) return Progress::stuck;
        } else {
            waiting.push_back(c);
        }
    }
    for (const Index c : waiting) {
        if (!t.is_cell(c) || !violated(examine_cell(c))) continue;
        const Cell_points<3> x = cell_points(t, c);
        stuck_.push_back({x[0], x[1], x[2], x[3], none});
    }
    if (!stuck_.empty()) return Progress::stuck;
    waiting.clear();
    budget = 1000 + 64 * queue_.size();
    flipped = false;
    while (!queue_.empty() || (flipped && !waiting.empty())) {
        if (queue_.empty()) {
            std::swap(queue_, waiting);
            flipped = false;
        }
        const Index f = queue_.back();
        queue_.pop_back();
        if (!t.is_facet(f) || !violated(examine_facet(f))) continue;
        if (mend_facet(t.half(f))) {
            flipped = true;
            if (--budget == 0) return Progress::stuck;
        } else {
            waiting.push_back(f);
        }
    }
    for (const Index f : waiting)
        if (t.is_facet(f) && violated(examine_facet(f))) stuck_.push_back(examine_facet(f).point);
    return waiting.empty() && evaluate() ? Progress::done : Progress::stuck;
}

}  // namespace annulus
