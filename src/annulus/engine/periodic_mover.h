// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_repair.h>
#include <annulus/engine/periodic_state.h>
#include <annulus/engine/periodic_tolerances.h>
#include <annulus/engine/tolerance_policy.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/options.h>

#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Moves a Periodic_state to places elsewhere, in another box, too: by flips, or else by a build; and decides whether
/// tolerances are kept for the next move.
template <int d>
class Periodic_mover {
  public:
    /// Builds with this object, and as many threads; it has to outlive the mover.
    Periodic_mover(Periodic_builder<d>& builder, Periodic_strategy strategy, int threads)
        : builder_(builder), strategy_(strategy), threads_(threads) {
        repair_.set_threads(threads);
        tolerances_.set_threads(threads);
    }

    /// `next` has no cells: those of `state`, which it becomes, are made its own. Where it throws, the state is as it
    /// was, and no tolerances are kept. Throws what Periodic_builder::build throws.
    Move_result move(Periodic_state<d>& state, Periodic_state<d> next);
    /// Whether it is expected to cost less to remove these vertices and insert them where they go (Periodic_editor)
    /// than to move all. O(their number). One is always reinserted, since many calls of one are expected.
    [[nodiscard]] bool is_for_editor(const Periodic_state<d>& state, std::span<const Vertex_move<d>> moves) const;
    /// Periodic_mesh::recompute_tolerances. Throws bad_alloc, without tolerances.
    void recompute(const Periodic_state<d>& state, Move_statistics& statistics);
    /// To be called when the state has changed otherwise.
    void forget() noexcept { tolerances_.invalidate(); }
    /// By vertex; Periodic_mesh::tolerances. O(n). Throws bad_alloc.
    [[nodiscard]] std::vector<double> tolerances(const Periodic_state<d>& state) const;
    [[nodiscard]] bool keeps_tolerances() const { return tolerances_.kept(); }
    /// Memory for a state.
    [[nodiscard]] Placed_points<d> take_memory() { return std::move(spare_); }

  private:
    [[nodiscard]] std::size_t most_failed(std::size_t vertices) const;
    void consider(const Periodic_state<d>& before, const Periodic_state<d>& after, Move_statistics& statistics);
    void finish(const Periodic_state<d>& state, bool kept_before, const Periodic_repair_result& done,
                Move_statistics& statistics);
    void evaluate_all(const Periodic_state<d>& state, Move_statistics& statistics);

    Periodic_builder<d>& builder_;
    Periodic_strategy strategy_;
    int threads_;
    Periodic_repair<d> repair_;
    Periodic_tolerances<d> tolerances_;
    Tolerance_policy<d> policy_;
    Placed_points<d> spare_;  // of the state before, for its memory
};

extern template class Periodic_mover<2>;
extern template class Periodic_mover<3>;

}  // namespace annulus::inline v1
