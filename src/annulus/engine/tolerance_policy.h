// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_checker.h>
#include <annulus/engine/cost_model.h>
#include <annulus/types.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Decides whether `tolerances` keeps tolerances or evaluates signs alone, by what steps cost and what a sample
/// predicts, in cells tested (cost_model.h). Correctness does not depend on the decision.
///
/// While so many certificates expire at every step (the first steps of an optimisation) that the signs of all of them
/// cost less than the tolerances of these, no tolerances are kept. The cost of tolerances in excess of that of signs
/// is added up; when it reaches the cost of recomputing all tolerances, they are given up (the ski-rental rule).
/// Without them, a sample of certificates and the displacements of every eighth time step tell whether they would
/// last.
template <int d>
class Tolerance_policy {
  public:
    /// With tolerances: whether they have to be given up, now that so many vertices failed in this step.
    [[nodiscard]] bool exceeds_budget(std::size_t failures, std::size_t vertices) const;
    /// A step of this time step, with tolerances.
    void note_step(std::size_t failures, std::uint64_t evaluated) {
        failures_ += failures;
        evaluated_ += evaluated;
    }
    /// The end of a time step with tolerances; `each` when its vertices moved one by one. True when they are to be
    /// given up.
    [[nodiscard]] bool end_step_with_tolerances(bool each, std::size_t vertices);
    /// The end of a time step without tolerances.
    void note_step_without_tolerances() { ++steps_without_; }

    /// Without tolerances: records the displacements of the vertices, if it is time to check.
    void note_displacements(const Corner_table<d>& table, std::span<const Coordinates<d>> from,
                            std::span<const Coordinates<d>> to);
    void forget_displacements() { displacement_.clear(); }
    /// Decides by these displacements whether to recompute tolerances next; uses `checker` for a sample of tolerances
    /// at x.
    void reconsider(const Corner_table<d>& table, Certificate_checker<d>& checker, std::span<const Coordinates<d>> x,
                    bool each, Move_result& report);
    /// Without tolerances: whether it is time to check whether they would pay.
    [[nodiscard]] bool is_time_to_check() const;
    /// Decides by the share of certificates that would expire at a time step.
    void decide(double share, bool each);
    /// Tolerances that pay have to be computed again: whether that still does, so soon.
    [[nodiscard]] bool renews(std::size_t vertices);
    /// Whether tolerances would last, judging by the last time step; true once.
    [[nodiscard]] bool take_recomputation() { return std::exchange(recomputes_next_, false); }

    /// A vertex moves alone without tolerances: whether to recompute tolerances for it and for those to come, by a
    /// sample as in reconsider().
    [[nodiscard]] bool recomputes_for_single_move(const Corner_table<d>& table, Certificate_checker<d>& checker,
                                                  std::span<const Coordinates<d>> x, std::size_t vertices,
                                                  Move_result& report);
    /// After that: `calm` when everything held at its target, as it must within a tolerance.
    void note_single_move(bool calm) { calm_moves_ += calm ? 1 : 0; }
    /// A vertex moved alone, with tolerances: whether they have to be given up.
    [[nodiscard]] bool end_single_move(std::size_t vertices);

    void note_recomputed();
    void note_dropped();

    /// Whether the stages after the filter make tolerances much more expensive than Cost_model says, where so many of
    /// a sample needed them: up to fifty times. There they are next to nothing, since the points are degenerate or
    /// nearly so.
    [[nodiscard]] static bool are_too_expensive(const Stage_counts& sample) {
        return Certificate_checker<d>::later_cost(sample) * Cost_model<d>::certificates >
               2.0 * Cost_model<d>::recomputation * static_cast<double>(sample.total());
    }

  private:
    [[nodiscard]] static bool evaluate_sample(const Corner_table<d>& table, Certificate_checker<d>& checker,
                                              std::span<const Coordinates<d>> x, Move_result& report);
    [[nodiscard]] double expired_share(const Certificate_checker<d>& checker) const;

    std::vector<Coordinates<d>> displacement_;  // recorded to check whether tolerances would last
    std::uint64_t failures_ = 0;                // with tolerances, in this time step
    std::uint64_t evaluated_ = 0;               // certificates, for these failures
    double excess_cost_ = 0.0;                  // of tolerances, above that of signs, since the last recomputation
    std::uint64_t steps_without_ = 0;           // time steps since tolerances were given up
    std::uint64_t calm_moves_ = 0;              // of single vertices, since then
    bool recomputes_next_ = false;
};

extern template class Tolerance_policy<2>;
extern template class Tolerance_policy<3>;

}  // namespace annulus::inline v1
