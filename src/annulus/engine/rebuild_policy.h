// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/cost_model.h>
#include <annulus/engine/repair_estimate.h>
#include <annulus/engine/sample.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// Decides whether `auto` rebuilds or repairs a time step: by a sample of cells before it, by what repair cost, and
/// by how it ended. No clock is read, and correctness does not depend on the decision.
template <int d>
class Rebuild_policy {
  public:
    [[nodiscard]] static double rebuild_cost(std::size_t vertices) {
        return Cost_model<d>::rebuild * static_cast<double>(vertices);
    }
    /// The same when all tolerances are recomputed afterwards.
    [[nodiscard]] static double rebuild_with_tolerances_cost(std::size_t vertices) {
        return (Cost_model<d>::rebuild + Cost_model<d>::recomputation) * static_cast<double>(vertices);
    }
    /// The cost at which repair gives up.
    [[nodiscard]] static double repair_limit(std::size_t vertices) { return share() * static_cast<double>(vertices); }
    /// The same for steps that are not promised to cost so little: a small mesh is not rebuilt only because it is
    /// small.
    [[nodiscard]] static double generous_repair_limit(std::size_t vertices) { return 8000.0 + repair_limit(vertices); }

    /// What a time step of `auto` may cost with the tolerances that it recomputes: the first time these take up to 1.3
    /// times as long as is counted, since their memory is new to the process.
    [[nodiscard]] static double step_limit(std::size_t vertices) { return 1.2 * rebuild_cost(vertices); }
    /// The cost at which repair of a time step gives up once its first round is over: what is left then is mostly known
    /// (Late_rounds), and giving up costs a rebuild.
    [[nodiscard]] static double late_limit(std::size_t vertices) { return late_share * rebuild_cost(vertices); }

    /// The cost of flips whose least cost was estimated (Sign_evaluator::estimate): they find more to repair. Measured
    /// in 2D: 1.2 to 1.7 times the estimate, except where they lead nowhere; a little is added, since repair that costs
    /// nearly as much as a rebuild wins less than is lost where it is given up. In 3D, in 2,500 steps of seven
    /// families: 1.2 times what was violated and 5.5 times what was inverted, with a spread of a quarter, for which a
    /// fifth is added: where many cells are inverted, most of the vertices that are held back stay behind.
    [[nodiscard]] static constexpr double expected(const Repair_estimate& e) {
        return d == 2 ? 1.8 * (e.inverted + e.violated) : 6.6 * e.inverted + 1.45 * e.violated;
    }
    /// The same for a repair limit of the step, when later stages have already cost this to decide signs: the estimate
    /// is by the filter, and where a good part of the signs need more, so do those of the flips. Measured on clusters
    /// of points over six decades of scale: 4.3 to 5.4 times as much where later stages cost 0.17 to 0.2 of the limit,
    /// at prices twice as high as those in cost_model.h: this begins later than then, and costs no more by any motion
    /// of bench/ (PROFILES.md).
    [[nodiscard]] static constexpr double expected(const Repair_estimate& e, double later_stages, double limit) {
        return expected(e) * (1.0 + 43.0 * std::max(0.0, later_stages / limit - 0.1));
    }
    /// The cost at which such flips give up, for a repair limit of the step of which the signs have cost a part: when
    /// they cost clearly more than expected, not only when they have cost as much as a rebuild.
    [[nodiscard]] static constexpr double flips_limit(const Repair_estimate& estimate, double spent, double limit) {
        return 1.5 * expected(estimate) + std::clamp(0.45 * limit - spent, 0.0, limit / 4.0);
    }

    /// The cost at which work on a part gives up and everything is rebuilt instead.
    [[nodiscard]] static double generous_rebuild_limit(std::size_t vertices) { return 8000.0 + rebuild_cost(vertices); }
    /// For vertices that move one by one, `done` of them at this cost so far: whether all `movers` are going to cost
    /// more than a rebuild of this cost, judging by these. False until they have cost an eighth of it, so that they
    /// are evidence.
    [[nodiscard]] static bool exceeds_rebuild_one_by_one(double cost, std::size_t done, std::size_t movers,
                                                         double rebuild) {
        return cost > rebuild / 8.0 && cost / static_cast<double>(done) * static_cast<double>(movers) > rebuild;
    }
    /// The same for a strategy that moves vertices one by one: whether they have cost more than a rebuild plus what
    /// such moves cost where their changes are local.
    [[nodiscard]] static bool exceeds_rebuild_in_sequence(double cost, std::size_t done, std::size_t vertices) {
        return cost > generous_rebuild_limit(vertices) + 4.0 * Cost_model<d>::reinsertion * static_cast<double>(done);
    }

    /// While every step is a rebuild: whether a larger sample is pointless, and this one need not be counted either.
    [[nodiscard]] bool is_clearly_infeasible(const Sample& few) const { return cost_of(few) > 3.0 * share(); }
    /// While every step is a rebuild: whether the next one is to be repaired, judging by these cells.
    [[nodiscard]] bool repairs(const Sample& sample) {
        const double cost = cost_of(sample);
        const bool calmer = cost < 0.4 * gave_up_at_;
        if (wait_ > 0 && !calmer) {
            --wait_;
            return false;
        }
        wait_ = 0;
        tried_ = cost;
        return cost < share();
    }
    /// A step was repaired.
    void repaired() {
        backoff_ = std::max(backoff_ / 2, std::uint32_t{1});
        tried_ = 0.0;
    }
    /// Repair gave up: it is not tried again for a while, longer the more often this happens, unless the motion
    /// becomes calmer.
    void gave_up() {
        gave_up_at_ = tried_ > 0.0 ? tried_ : share();
        wait_ = backoff_;
        backoff_ = std::min(2 * backoff_, longest_wait);
    }

    /// The repair limit per vertex: as much as a rebuild, so that with the rebuild that follows no step costs more
    /// than twice the best choice (the ski-rental rule). Most steps that are given up cost little: what the signs and
    /// an estimate of the flips make too expensive is rebuilt at once, and flips stop that cost more than expected.
    static constexpr double share() { return Cost_model<d>::rebuild - (Cost_model<d>::signs - Cost_model<d>::cells); }
    /// late_limit(), in rebuilds.
    static constexpr double late_share = 1.7;
    static_assert(late_share * Cost_model<d>::rebuild + Cost_model<d>::rebuild < 1.45 * Cost_model<d>::insertion);
    static_assert(late_share * Cost_model<d>::rebuild + Cost_model<d>::recomputation < 1.45 * Cost_model<d>::insertion);
    static_assert(share() + Cost_model<d>::rebuild + (Cost_model<d>::signs - Cost_model<d>::cells) <
                  1.45 * Cost_model<d>::insertion);

  private:
    static constexpr std::uint32_t longest_wait = 64;

    /// The cost of repair, per vertex.
    [[nodiscard]] static double cost_of(const Sample& sample) {
        if (sample.cells == 0) return 0.0;
        const double more = Cost_model<d>::violated * 0.5 * static_cast<double>(sample.violated) +
                            Cost_model<d>::inverted * static_cast<double>(sample.inverted) +
                            Cost_model<d>::unclear * static_cast<double>(sample.unclear);
        return Cost_model<d>::cells * (1.0 + more / static_cast<double>(sample.cells));
    }

    std::uint32_t wait_ = 0;
    std::uint32_t backoff_ = 1;
    double tried_ = 0.0;  // what the sample said of the step before the first repaired one; 0 once one was repaired
    double gave_up_at_ = 0.0;  // what it had said when repair gave up; the limit if others had been repaired before
};

}  // namespace annulus::inline v1
