// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_repair.h>

#include <annulus/engine/cost_model.h>
#include <annulus/engine/rebuild_policy.h>
#include <annulus/kernel/periodic_proof.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr int most_rounds = 64;
constexpr int most_idle_rounds = 24;  // in each a vertex tries half as much of its way; a build costs more

}  // namespace

template <int d>
Periodic_repair_result Periodic_repair<d>::repair(Periodic_table<d>& table, const Periodic_points<d>& from,
                                                  const Periodic_points<d>& to, Budget& budget) {
    Periodic_repair_result result;
    if (!motion_.begin(from, to)) return result;
    budget_ = &budget;
    made_.flips = 0;
    made_.unused.clear();
    bool copied = false;
    const auto copy = [&] {
        if (!copied) work_ = table;
        copied = true;
    };
    if (motion_.relabels_home()) {
        copy();
        if (!motion_.relabel_home(work_)) return result;
    }
    signs_.begin(copied ? work_ : table, to.lattice, motion_.goal(), budget);
    auto& cospherical = work_.cospherical;
    signs_.test_all_cells(cospherical);
    const bool calm = signs_.inverted().empty() && signs_.violated().empty();
    if (calm && !copied && !motion_.relabels_goal()) {
        std::swap(table.cospherical, cospherical);
        result.done = true;
        return result;
    }
    const double least = Cost_model<d>::inverted * static_cast<double>(signs_.inverted().size()) +
                         Cost_model<d>::violated * static_cast<double>(signs_.violated().size());
    if (Rebuild_policy<d>::expected(least) > budget.left()) return result;
    copy();
    signs_.rebind(work_);
    if (!calm && !flip_until_done(to.lattice)) return result;
    close_gaps<d>(work_, made_.unused);
    if (!motion_.relabel_goal(work_) || !is_proved_delaunay<d>(work_, to.lattice, to.place)) return result;
    result.done = true;
    result.flips = made_.flips;
    if (!calm) result.flipped = static_cast<std::size_t>(std::count(made_.flipped.begin(), made_.flipped.end(), 1));
    std::swap(table, work_);
    return result;
}

template <int d>
void Periodic_repair<d>::moved(Index v) {
    for (const Corner_index h : star_.of(work_, v)) signs_.test_cell(work_.cell_of(h));
}

template <int d>
bool Periodic_repair<d>::replace(std::span<const Lifted_cell<d>> gone, std::span<const Cell_images<d>> came) {
    if (!replace_periodic_cells<d>(work_, gone, came, made_.unused, made_.latest)) return false;
    ++made_.flips;
    budget_->charge(Cost_model<d>::flip);
    for (const std::size_t c : made_.latest) {
        star_.add(work_, c);
        for (const Index v : work_.vertex[c]) made_.flipped[static_cast<std::size_t>(v)] = 1;
        signs_.test_cell(c);
    }
    return true;
}

/// Afterwards no cell is inverted except those in `inverted_at_source`. False when it has become too expensive.
template <int d>
bool Periodic_repair<d>::hold_back_inverted() {
    auto& inverted = signs_.inverted();
    while (!inverted.empty()) {
        const std::size_t c = inverted.back();
        inverted.pop_back();
        if (!is_cell(c) || !signs_.is_inverted(c)) continue;
        if (!budget_->within_limit()) return false;
        Cell_sites<d> vertices;
        for (std::size_t i = 0; i <= d; ++i) vertices[i] = Site<d>(work_.vertex[c][i]);
        const Index v = held_.hold_back(vertices);
        if (v != none) moved(v);
        else left_.inverted_at_source.push_back(c);
    }
    return true;
}

/// A facet that no flip repairs waits for other flips; it is stuck when there are none left.
template <int d>
bool Periodic_repair<d>::flip_violated() {
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
        const Corner_index h = violated.back();
        violated.pop_back();
        if (!is_cell(work_.cell_of(h)) || !signs_.is_violated(h)) continue;
        if (!budget_->within_limit()) return false;
        if (flip(h)) flipped = true;
        else waiting.push_back(h);
    }
    std::swap(stuck, waiting);
    sort_unique(stuck);
    return true;
}

/// Whether no cell is inverted; then the list is empty.
template <int d>
bool Periodic_repair<d>::nothing_inverted() {
    std::erase_if(signs_.inverted(), [this](std::size_t c) { return !is_cell(c) || !signs_.is_inverted(c); });
    return signs_.inverted().empty();
}

template <int d>
bool Periodic_repair<d>::flip_until_done(const Lattice<d>& lattice) {
    left_ = {};
    made_.flipped.assign(motion_.home().size(), 0);
    star_.begin(work_, motion_.home().size());
    held_.begin({.x = motion_.goal(), .source = motion_.home(), .mover = none, .grid = lattice.grid()},
                motion_.home().size());
    struct Back {
        Held_back<d>& held;
        ~Back() {
            held.release([](Index) {});
        }
    } back{held_};
    int idle = 0;
    for (int round = 0; round < most_rounds && idle < most_idle_rounds; ++round) {
        auto& inverted = signs_.inverted();
        inverted.insert(inverted.end(), left_.inverted_at_source.begin(), left_.inverted_at_source.end());
        left_.inverted_at_source.clear();
        if (!hold_back_inverted() || !flip_violated()) return false;
        if (held_.empty() && left_.inverted_at_source.empty() && nothing_inverted()) break;
        idle = held_.advance([this](Index v) { moved(v); }) ? 0 : idle + 1;
    }
    return held_.empty() && left_.inverted_at_source.empty() && left_.stuck.empty() && signs_.inverted().empty() &&
           signs_.violated().empty();
}

template class Periodic_repair<2>;
template class Periodic_repair<3>;

}  // namespace annulus::inline v1
