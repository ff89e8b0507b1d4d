// SPDX-License-Identifier: GPL-3.0-or-later
// Flip_repair: what rounds of flips do not bring to its target, in a time step.
#include <annulus/engine/flip_repair.h>

#include <annulus/engine/reinsertion_cost.h>
#include <annulus/error.h>
#include <annulus/mesh/border.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>
#include <iterator>

namespace annulus::inline v1 {

/// Tests the cells that were touched, from this one on. Returns whether cells with infinity are among them.
template <int d>
bool Flip_repair<d>::test_touched(std::size_t first) {
    bool at_border = false;
    for (std::size_t i = first; i < result_.touched.size(); ++i) {
        const Cell_index c = result_.touched[i];
        if (!table_.is_cell(c)) continue;
        signs_.test_cell(c, true);
        at_border = at_border || table_.is_infinite(c);
    }
    return at_border;
}

/// Whether a walk around each vertex meets every new cell that has it, of those touched from this one on. A cavity that
/// was rebuilt beside inverted cells may have left two stars at one vertex, of which a walk meets one.
template <int d>
bool Flip_repair<d>::stars_are_whole(std::size_t first) const {
    std::vector<Cell_index> made;
    std::copy_if(result_.touched.begin() + static_cast<std::ptrdiff_t>(first), result_.touched.end(),
                 std::back_inserter(made), [this](Cell_index c) { return table_.is_cell(c); });
    sort_unique(made);
    std::vector<Index> vertices;  // of each of them
    for (const Cell_index c : made)
        for (const Index v : cell_vertices(table_, c))
            if (v != infinite) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    for (auto v = vertices.begin(); v != vertices.end();) {
        const auto next = std::upper_bound(v, vertices.end(), *v);
        std::ptrdiff_t met = 0;
        table_.for_each_corner(*v, [&](Corner_index h) {
            met += std::binary_search(made.begin(), made.end(), Corner_table<d>::cell_of(h)) ? 1 : 0;
        });
        if (met != next - v) return false;
        v = next;
    }
    return true;
}

/// Rebuilds the cells at facets that no flip repairs, with vertices where they are tried. Otherwise each round would
/// test these facets again after each flip, exactly as a rule. Vertices may move afterwards only because the border
/// and the stars of vertices are still in one piece (docs/theory.md 6.5). False when they are not, or this has become
/// too expensive.
template <int d>
bool Flip_repair<d>::rebuild_stuck() {
    std::vector<Cell_index> seeds;
    for (const Corner_index f : left_.stuck) {
        if (!table_.is_facet(f)) continue;
        for (const Cell_index c : {table_.cell_of(f), table_.cell_of(table_.twin(f))}) {
            seeds.push_back(c);
            for (const Index v : cell_vertices(table_, c))
                if (v != infinite) result_.reinserted.push_back(v);
        }
    }
    sort_unique(seeds);
    sort_unique(result_.reinserted);
    const std::size_t first = result_.touched.size();
    result_.cells_rebuilt = true;
    const double room = std::max(0.0, budget_->left()) / Cost_model<d>::point;
    const double most = std::min(room, static_cast<double>(at(table_.vertex_bound()) + 64));
    (void)local_.rebuild(held_.positions(), seeds, static_cast<std::size_t>(most), result_.touched);
    budget_->charge(Cost_model<d>::point * static_cast<double>(local_.points()));
    if (test_touched(first) && !border_is_whole(table_)) return false;
    return stars_are_whole(first) && nothing_inverted() && flip_violated();
}

/// The cost of the reinsertion of all vertices that are not at their targets.
template <int d>
double Flip_repair<d>::cost_of_reinsertion() const {
    double cost = 0.0;
    for (const auto& held : held_.held())
        if (held_.is_waiting(held)) cost += reinsertion_cost(table_, held.vertex);
    return cost;
}

/// Removes each vertex that is held back and inserts it at its target: where vertices are tried, the triangulation is
/// Delaunay, provided that its border winds once.
template <int d>
bool Flip_repair<d>::reinsert_held() {
    std::size_t seen = 0;
    const bool whole = border_winds_once(table_, held_.positions(), seen);
    budget_->charge(Cost_model<d>::border * static_cast<double>(seen));
    if (!whole) return false;
    const std::size_t first = result_.touched.size();
    std::vector<Cell_index> changed;
    const auto place = [&](std::span<Coordinates<d>> x, Index v, const Coordinates<d>& target) {
        changed.clear();
        const double cost = reinsertion_cost(table_, v);
        if (cost > budget_->limit) return false;
        budget_->charge(cost);
        result_.reinserted.push_back(v);
        const bool placed = mesh_.reinsert(x, v, target, changed);
        result_.touched.insert(result_.touched.end(), changed.begin(), changed.end());
        return placed;
    };
    try {
        if (!held_.place(place)) return false;
    } catch (const Error&) {  // a vertex is there, which may be on its way
        return false;
    }
    sort_unique(result_.reinserted);
    (void)test_touched(first);
    return nothing_inverted() && flip_violated() && left_.stuck.empty() && nothing_inverted();
}

template class Flip_repair<2>;
template class Flip_repair<3>;

}  // namespace annulus::inline v1
