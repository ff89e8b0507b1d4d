// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/engine.h>
#include <annulus/published/paper_strategy.h>
#include <annulus/published/strategies.h>

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The paper's filtering algorithm (3.2), which also lists the vertices that fail.
template <int d>
class Watched_paper_strategy final : public Paper_strategy<d> {
  public:
    using Paper_strategy<d>::Paper_strategy;
    /// The vertices that moved beyond their tolerance in the current time step, or, between time steps, in the last
    /// one.
    [[nodiscard]] std::span<const Index> failed() const { return failed_; }

    void begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) override {
        failed_.clear();
        Paper_strategy<d>::begin_transaction(x, report);
    }
    void move(Index v, const Coordinates<d>& p, Move_result& report) override {
        const std::uint64_t within = report.moves.within_tolerance;
        Paper_strategy<d>::move(v, p, report);
        if (report.moves.within_tolerance == within) failed_.push_back(v);
    }

  private:
    std::vector<Index> failed_;
};

/// A triangulation that follows a motion, by a strategy of the library or a variant of the paper's algorithms.
template <int d>
class Follower {
  public:
    /// `paper`, if it has a value, replaces the options' strategy. Throws what Moving_mesh does.
    Follower(std::span<const Coordinates<d>> points, const Options& options, const std::optional<Paper_choice>& paper)
        : engine_(mesh_, options, make(options, paper)) {
        engine_.build(points);
    }
    Follower(const Follower&) = delete;
    Follower& operator=(const Follower&) = delete;

    [[nodiscard]] Move_result move_all(std::span<const Coordinates<d>> target) { return engine_.move_all(target); }
    /// Recomputes every tolerance, if tolerances are kept.
    void recompute_tolerances() {
        Move_result report;
        strategy_->refresh_all(report);
    }
    [[nodiscard]] Audit_result audit() const { return annulus::audit(engine_.audit_input()); }
    /// Null unless it follows by a variant of the paper's filtering algorithm.
    [[nodiscard]] Watched_paper_strategy<d>* paper_strategy() { return paper_strategy_; }

  private:
    std::unique_ptr<Update_strategy<d>> make(const Options& options, const std::optional<Paper_choice>& paper) {
        std::unique_ptr<Update_strategy<d>> made;
        if (!paper) {
            made = make_strategy<d>(mesh_, options);
        } else if (!paper->tolerances) {
            made = make_paper<d>(mesh_, *paper, options.tolerance);
        } else {
            auto watched =
                std::make_unique<Watched_paper_strategy<d>>(mesh_, *paper, Tolerance_kind::paper, options.seed);
            paper_strategy_ = watched.get();
            made = std::move(watched);
        }
        strategy_ = made.get();
        return made;
    }

    Delaunay_mesh<d> mesh_;
    Update_strategy<d>* strategy_ = nullptr;
    Watched_paper_strategy<d>* paper_strategy_ = nullptr;
    Engine<d> engine_;  // owns the strategy
};

}  // namespace annulus::inline v1
