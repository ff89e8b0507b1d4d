// SPDX-License-Identifier: GPL-3.0-or-later
// Flip_repair: holding back, flipping, advancing; what is the same in every dimension.
#include <annulus/engine/flip_repair.h>

#include <annulus/engine/cost_model.h>
#include <annulus/engine/late_rounds.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {
constexpr int most_rounds = 64;
constexpr int most_idle_rounds = 3;
}  // namespace

template <int d>
void Flip_repair<d>::made(std::span<const Cell_index> cells) {
    ++result_.flips;
    budget_->charge(Cost_model<d>::flip);
    for (const Cell_index c : cells) {
        result_.touched.push_back(c);
        signs_.test_cell(c, true);
    }
}

template <int d>
void Flip_repair<d>::moved(Index v) {
    signs_.test_star(v, true);
}

/// Afterwards no cell is inverted except those in `inverted_at_source`. False when it has become too expensive.
template <int d>
bool Flip_repair<d>::untangle_or_hold_back() {
    auto& inverted = signs_.inverted();
    while (!inverted.empty()) {
        const Cell_index c = inverted.back();
        inverted.pop_back();
        if (!table_.is_cell(c) || !signs_.is_inverted(c)) continue;
        if (!budget_->within_limit()) return false;
        if (untangle(c)) continue;
        const Index v = held_.hold_back(cell_sites(table_, c));
        if (v != none) moved(v);
        else left_.inverted_at_source.push_back(c);
    }
    return true;
}

/// A facet that no flip repairs waits for other flips; it is stuck when there are none left.
template <int d>
bool Flip_repair<d>::flip_violated() {
    auto& violated = signs_.violated();
    auto& [inverted_at_source, stuck, waiting] = left_;
    violated.insert(violated.end(), stuck.begin(), stuck.end());
    stuck.clear();
    bool flipped = false;
    while (!violated.empty() || (flipped && !waiting.empty())) {
        if (violated.empty()) {
            sort_unique(waiting);
            std::swap(violated, waiting);
            flipped = false;
        }
        const Corner_index f = violated.back();
        violated.pop_back();
        if (!table_.is_facet(f) || !signs_.is_violated(f)) continue;
        if (!budget_->within_limit()) return false;
        if (flip(f)) flipped = true;
        else waiting.push_back(f);
    }
    std::swap(stuck, waiting);
    sort_unique(stuck);
    return true;
}

/// Collects the cells at which flips are stuck, and their vertices, with all vertices at their targets. Empties the
/// lists.
template <int d>
void Flip_repair<d>::note_stuck(std::vector<Cell_index>& seeds) {
    const auto seed = [&](Cell_index c) {
        seeds.push_back(c);
        for (const Index v : cell_vertices(table_, c))
            if (v != infinite) result_.reinserted.push_back(v);
    };
    auto& violated = signs_.violated();
    violated.insert(violated.end(), left_.stuck.begin(), left_.stuck.end());
    left_.stuck.clear();
    for (const Cell_index c : left_.inverted_at_source)
        if (table_.is_cell(c)) seed(c);
    left_.inverted_at_source.clear();
    for (const Cell_index c : signs_.inverted())
        if (table_.is_cell(c) && signs_.is_inverted(c)) seed(c);
    for (const Corner_index f : violated) {
        if (!table_.is_facet(f) || !signs_.is_violated(f)) continue;
        seed(table_.cell_of(f));
        seed(table_.cell_of(table_.twin(f)));
    }
    signs_.inverted().clear();
    violated.clear();
    sort_unique(result_.reinserted);
    sort_unique(seeds);
}

/// Puts all vertices at their targets and rebuilds what does not hold there.
template <int d>
bool Flip_repair<d>::finish_locally() {
    std::vector<Cell_index> seeds;
    for (const auto& held : held_.held()) result_.reinserted.push_back(held.vertex);
    held_.release([this](Index v) { moved(v); });
    note_stuck(seeds);
    result_.cells_rebuilt = true;
    const std::size_t first = result_.touched.size();
    const double room = std::max(0.0, budget_->left()) / Cost_model<d>::point;
    const std::size_t most_points = at(table_.vertex_bound()) + 64;  // with more, everything is rebuilt
    const bool built =
        local_.rebuild(held_.positions(), seeds,
                       static_cast<std::size_t>(std::min(room, static_cast<double>(most_points))), result_.touched);
    budget_->charge(Cost_model<d>::point * static_cast<double>(local_.points()));
    if (!built) return false;
    (void)test_touched(first);
    return nothing_inverted() && flip_violated() && left_.stuck.empty() && nothing_inverted();
}

/// Whether no cell is inverted; then the list is empty.
template <int d>
bool Flip_repair<d>::nothing_inverted() {
    std::erase_if(signs_.inverted(), [this](Cell_index c) { return !table_.is_cell(c) || !signs_.is_inverted(c); });
    return signs_.inverted().empty();
}

template <int d>
void Flip_repair<d>::run() {
    const bool many = !held_.is_of_one();
    Late_rounds<d> rounds(std::max(Rebuild_policy<d>::rebuild_cost(mesh_.vertices()), budget_->limit), budget_->spent);
    int idle = 0;
    bool was_stuck = false;
    for (int round = 0; round < most_rounds && idle < most_idle_rounds; ++round) {
        signs_.inverted().insert(signs_.inverted().end(), left_.inverted_at_source.begin(),
                                 left_.inverted_at_source.end());
        left_.inverted_at_source.clear();
        if (!untangle_or_hold_back() || !flip_violated()) return;
        const bool still_stuck = std::exchange(was_stuck, !left_.stuck.empty()) && was_stuck;
        if (many && still_stuck && !rebuild_stuck()) return;
        if (held_.empty() && left_.inverted_at_source.empty() && nothing_inverted()) break;
        if (many) {
            budget_->limit = std::max(budget_->limit, Rebuild_policy<d>::late_limit(mesh_.vertices()));
            rounds.note(budget_->spent, cost_of_reinsertion());
            if (rounds.gives_up()) return;
            const bool last = round + 1 == most_rounds || (idle + 1 == most_idle_rounds && !held_.has_advanced());
            if (left_.stuck.empty() && left_.inverted_at_source.empty() && nothing_inverted() &&
                rounds.reinserts(last)) {
                result_.done = reinsert_held();
                return;
            }
        }
        idle = held_.advance([this](Index v) { moved(v); }) ? 0 : idle + 1;
    }
    const bool lists_empty = left_.inverted_at_source.empty() && left_.stuck.empty() && signs_.inverted().empty() &&
                             signs_.violated().empty();
    result_.done = (held_.empty() && lists_empty) || finish_locally();
}

template <int d>
void Flip_repair<d>::begin() {
    result_.done = result_.cells_rebuilt = false;
    result_.flips = 0;
    result_.touched.clear();
    result_.reinserted.clear();
    left_.inverted_at_source.clear();
    left_.stuck.clear();
    left_.waiting.clear();
}

template <int d>
const Repair_result& Flip_repair<d>::repair(const Motion_path<d>& path, Budget& budget) {
    budget_ = &budget;
    signs_.rebind(path.x);
    held_.begin(path, at(table_.vertex_bound()));
    struct Back {
        Flip_repair& repair;
        ~Back() {
            repair.held_.release([](Index) {});
            sort_unique(repair.result_.touched);
        }
    } back{*this};
    run();
    return result_;
}

template class Flip_repair<2>;
template class Flip_repair<3>;

}  // namespace annulus::inline v1
