// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/displacement_budget.h>
#include <annulus/engine/move_outcomes.h>
#include <annulus/engine/rebuild_policy.h>
#include <annulus/engine/repair.h>
#include <annulus/engine/step.h>
#include <annulus/engine/tolerance_policy.h>
#include <annulus/engine/tolerance_slices.h>
#include <annulus/engine/update_strategy.h>
#include <annulus/options.h>

#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The strategies that repair the mesh: `tolerances`, `auto`, `tolerances-each`, `in-place`.
///
/// A step starts with the new positions. It finds the vertices that left their tolerances and the certificates that
/// expired (Displacement_budget); without tolerances it takes all certificates, or all those of one vertex. It
/// evaluates them, flips, and holds vertices back (Repair). At last it writes the new expiries (Displacement_budget
/// again). What one stage finds is passed to the next in a Step. Tolerance_policy decides whether tolerances are
/// kept, Rebuild_policy whether a time step is rebuilt.
template <int d>
class Tolerance_strategy final : public Update_strategy<d> {
  public:
    /// How a step is made.
    enum class Means : std::uint8_t {
        tolerances,  ///< while they pay; otherwise signs
        any,         ///< also rebuilds, while these are the cheapest: `auto`
        signs,       ///< of all certificates of what moves; never tolerances: `in-place`
    };
    /// Precondition: one of these four.
    explicit Tolerance_strategy(Delaunay_mesh<d>& mesh, Strategy strategy = Strategy::tolerances)
        : Update_strategy<d>(strategy),
          means_(strategy == Strategy::automatic  ? Means::any
                 : strategy == Strategy::in_place ? Means::signs
                                                  : Means::tolerances),
          mesh_(mesh),
          table_(mesh.table()),
          repair_(mesh),
          displacement_budget_(table_) {}

    /// For the step test, evaluations and signs. Results and counts do not depend on the number of threads.
    void set_threads(int threads) {
        threads_ = threads;
        repair_.set_threads(threads);
    }

    /// Takes the present triangulation and positions x as they are, as Delaunay, and evaluates every certificate
    /// again. When it throws (bad_alloc), no position was written. O(n).
    void recompute_tolerances(std::span<const Coordinates<d>> x, Move_result& report);
    /// The same; without tolerances nothing is evaluated: the first time steps tell whether tolerances pay.
    void begin(std::span<const Coordinates<d>> x, Move_result& report) override;
    [[nodiscard]] bool begins_with_tolerances() const override { return means_ == Means::tolerances; }
    void refresh_all(Move_result& report) override;
    void refresh_rebuilt(Move_result& report) override {
        if (!rebuilding_) refresh_all(report);
    }

    /// Moves every vertex to x. Throws Error, with everything as it was: not_finite, out_of_domain, or
    /// duplicate_point when two would coincide. After any other exception (bad_alloc, Error(too_large)) positions()
    /// are as they were and all else is unspecified: rebuild there and recompute tolerances. Precondition: begun in
    /// dimension d.
    void move_all(std::span<const Coordinates<d>> x, Move_result& report) override;
    void move(Index v, const Coordinates<d>& p, Move_result& report) override;

    /// While so many vertices fail that the signs around a vertex cost less than its tolerances, no tolerances are
    /// kept.
    void begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) override;
    void move_sequentially(Index v, const Coordinates<d>& p, Move_result& report) override { move_one(v, p, report); }
    void commit_transaction(Move_result& report) override;
    void rollback() noexcept override;
    void resume_after_rollback() override;

    /// Evaluates the certificates of these cells.
    void refresh(std::span<const Cell_index> cells, Move_result& report) override;
    /// Vertex v has position p, moving and fixed.
    void add_vertex(Index v, const Coordinates<d>& p) override;
    void restore_position(Index v, const Coordinates<d>& p) noexcept override;
    void clear_position(Index v) noexcept override { position_[at(v)].fill(std::numeric_limits<double>::quiet_NaN()); }
    [[nodiscard]] std::span<Coordinates<d>> resize_for_insertion(std::size_t bound) override {
        position_.resize(bound);
        return position_;
    }
    void truncate(std::size_t bound) override;

    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override {
        return displacement_budget_.kept() ? displacement_budget_.fixed(v) : position_[at(v)];
    }
    [[nodiscard]] bool repairs() const override { return true; }
    [[nodiscard]] bool is_sequential() const override {
        return this->strategy() == Strategy::tolerances_each || this->strategy() == Strategy::in_place;
    }
    /// False while the motion is so fast that tolerances would not last a step and are not kept.
    [[nodiscard]] bool keeps_tolerances() const { return displacement_budget_.kept(); }
    /// Lower bound of the distance that v may be from its fixed position while every other vertex is within its own;
    /// while keeps_tolerances().
    [[nodiscard]] std::optional<double> tolerance(Index v) const override {
        return displacement_budget_.kept() ? std::optional(std::max(0.0, displacement_budget_.slack(v))) : std::nullopt;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bool is_present(std::size_t v) const { return mesh_.has(static_cast<Index>(v)); }
    /// The budget of a time step.
    [[nodiscard]] double repair_limit() const {
        const std::size_t n = mesh_.vertices();
        return means_ == Means::any ? Rebuild_policy<d>::repair_limit(n) : Rebuild_policy<d>::generous_repair_limit(n);
    }
    [[nodiscard]] Step<d> new_step(std::span<const Coordinates<d>> x, Index mover, Scope scope) {
        return Step<d>::recycled(previous_, x, mover, scope);
    }

    // tolerance_strategy.cpp: a step.
    [[nodiscard]] bool find_failed(Step<d>& step) const;
    [[nodiscard]] bool find_failed(Step<d>& step, std::size_t first, std::size_t last,
                                   std::vector<Index>& failed) const;
    void require_domain(std::span<const Coordinates<d>> x) const;
    [[nodiscard]] bool too_many_failed(const Step<d>& step) const;
    void move_one(Index v, const Coordinates<d>& p, Move_result& report);
    [[nodiscard]] bool examine(Step<d>& step);
    template <class Repair_call>
    void process(Step<d>& step, Repair_call repair, Move_result& report);
    void finish(Step<d>& step, Move_result& report);
    void renew_renumbered(const Step<d>& step);

    // tolerance_strategy_state.cpp: how it starts, what it keeps, rebuilds.
    void resize();
    void stop_rebuilding();
    void compute_tolerances(std::span<const Coordinates<d>> x, Move_result& report);
    void invalidate_tolerances() noexcept;
    void drop_tolerances();
    void recompute_if_worthwhile(Move_result& report);
    void recompute_afterwards(Move_result& report);
    void note_displacements(std::span<const Coordinates<d>> x);
    void end_step(bool each, Move_result& report);
    [[nodiscard]] bool next_is_repaired(std::span<const Coordinates<d>> x);
    void rebuild_from_now_on();
    void rebuild(Step<d>& step);
    void rebuild_all(std::span<const Coordinates<d>> x, bool last, Move_result& report);

    // tolerance_strategy_slices.cpp: all tolerances, at once or in slices.
    Stage_counts evaluate_slice(std::span<const Coordinates<d>> x, std::size_t facets,
                                std::pair<std::size_t, std::size_t> slice, Move_result& report);
    void recompute_slice(Move_result& report);
    [[nodiscard]] bool finish_slices(double room, Move_result& report);

    Means means_;
    int threads_ = 1;
    bool rebuilding_ = false;  // with `any`: each time step is rebuilt
    Delaunay_mesh<d>& mesh_;
    const Corner_table<d>& table_;
    Repair<d> repair_;
    Displacement_budget<d> displacement_budget_;
    Tolerance_policy<d> tolerance_policy_;
    Tolerance_slices<d> slices_;
    Rebuild_policy<d> rebuild_policy_;
    Move_outcomes<d> outcomes_;
    std::vector<Coordinates<d>> position_;
    std::vector<Coordinates<d>> saved_;  // position_ before a time step of single moves
    Step<d> previous_;                   // the last one, for its memory
};

extern template class Tolerance_strategy<2>;
extern template class Tolerance_strategy<3>;

}  // namespace annulus::inline v1
