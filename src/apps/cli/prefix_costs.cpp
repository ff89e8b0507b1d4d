// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/rebuild_policy.h>
#include <apps/cli/prefix_costs.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace annulus::inline v1::cli {

template <int d>
auto Prefix_costs<d>::start(const Frame_points<d>& first, Strategy strategy, int threads) -> Follower {
    Follower f{Moving_mesh<d>(first.x, Options{.strategy = strategy, .threads = threads}),
               {first.id, std::vector<Index>(first.x.size())}};
    std::iota(f.present.index.begin(), f.present.index.end(), Index{0});
    return f;
}

template <int d>
Prefix_costs<d>::Prefix_costs(const Frame_points<d>& first, std::uint64_t most_steps, int threads)
    : automatic_(start(first, Strategy::automatic, threads)),
      tolerances_(start(first, Strategy::tolerances, threads)),
      most_steps_(most_steps) {}

template <int d>
Move_result Prefix_costs<d>::Follower::follow(const Frame_points<d>& frame) {
    Frame_change<d> change(present, mesh.points(), frame);
    // Insertions and removals count no cost themselves.
    double work = Cost_model<d>::reinsertion / 2 * static_cast<double>(change.leave.size() + change.arrive.size());
    for (const Index i : change.leave) mesh.remove(i);
    Move_result moved = mesh.move_all(change.x);
    work += moved.statistics.cost;
    auto arrives = change.arrive.begin();
    for (Index& index : change.index)
        if (index == none) index = mesh.insert(*arrives++);
    present = {frame.id, std::move(change.index)};
    cost += work / Rebuild_policy<d>::rebuild_cost(std::max<std::size_t>(frame.x.size(), 1));
    return moved;
}

template <int d>
void Prefix_costs<d>::follow(const Frame_points<d>& frame) {
    const bool enough = followed_ > most_steps_;
    if (most_steps_ == 0 || enough) return;
    if (moves_ + frame.x.size() > most_moves) {
        most_steps_ = 0;  // no step after a gap
        return;
    }
    moves_ += frame.x.size();
    if (++followed_ == 2) {
        record_ = {};
        automatic_.cost = tolerances_.cost = 0;
    }
    ++record_.steps;
    (void)tolerances_.follow(frame);
    const Move_result r = automatic_.follow(frame);
    record_.moves += r.moves;
    record_.flips += r.statistics.flips;
    record_.rebuild_steps += r.statistics.rebuild_steps;
}

template <int d>
Prefix_record Prefix_costs<d>::record() const {
    Prefix_record r = record_;
    const double steps = static_cast<double>(std::max<std::uint64_t>(r.steps, 1));
    r.automatic = automatic_.cost / steps;
    r.tolerances = tolerances_.cost / steps;
    return r;
}

template class Prefix_costs<2>;
template class Prefix_costs<3>;

}  // namespace annulus::inline v1::cli
