// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/relocation/displacement.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace annulus {

/// Linear prediction of a motion: fixed positions that move along, so that a drift shared by neighbours costs nothing.
///
/// Vertex v anchored at f at time t_v is expected at f + (t - t_v) u_v. Certificates do not change when all their points
/// move by one vector, so what wears out a certificate evaluated at time t0 with tolerance s is the difference of the
/// velocities of its points and their deviations from the prediction: with all velocities within rho of some vector,
/// it holds while (t - t0) rho + deviation < s at every point (docs/theory.md, section on prediction). Half of s goes to
/// each; `Term::until` is the last time at which the first half suffices. Without velocities the prediction is that
/// everything rests, terms never end and deviations have all of s.
///
/// The predicted position is computed in doubles: off by at most 2^-51 times the largest coordinate or so, per
/// coordinate. `slack()` is above that and is added to every deviation.
template <int d>
class Prediction {
  public:
    using Time = std::uint32_t;
    static constexpr Time forever = std::numeric_limits<Time>::max();

    struct Term {
        double tolerance;  ///< for the deviation of each point
        Time until;        ///< last time at which the certificate may be trusted
    };

    [[nodiscard]] bool active() const { return !velocity_.empty(); }
    [[nodiscard]] Time now() const { return now_; }
    [[nodiscard]] double slack() const { return slack_; }

    /// Everything rests from now on, and nothing is scheduled.
    void clear() {
        velocity_.clear();
        anchored_.clear();
        for (auto& bucket : calendar_) bucket.clear();
        slack_ = 0.0;
        now_ = 0;
    }
    /// Vertex v, now at x[v], moves by velocity[v] a step. Replaces everything predicted before.
    void adopt(std::vector<Coordinates<d>> velocity, std::span<const Coordinates<d>> x) {
        clear();
        velocity_ = std::move(velocity);
        anchored_.assign(velocity_.size(), 0);
        calendar_.resize(horizon);
        reach_ = 0.0;
        for (const auto& p : x)
            for (const double c : p)
                if (std::fabs(c) <= 0x1p500) reach_ = std::max(reach_, std::fabs(c));  // vacant entries may be anything
        slack_ = reach_ * 0x1p-46;
    }
    /// False when a position is so far out that slack() no longer covers rounding: settle anew.
    [[nodiscard]] bool covers(const Coordinates<d>& p) const {
        bool near = true;
        for (const double c : p) near &= std::fabs(c) <= 2.0 * reach_;  // no branch: this runs over all positions
        return near;
    }

    void advance() { ++now_; }
    void retreat() { --now_; }
    /// There is room for new vertices; they rest.
    void resize(std::size_t n) {
        if (!active()) return;
        velocity_.resize(n, Coordinates<d>{});
        anchored_.resize(n, now_);
    }
    void anchor(std::size_t v) {
        if (active()) anchored_[v] = now_;
    }
    [[nodiscard]] bool rests(std::size_t v) const { return !active() || velocity_[v] == Coordinates<d>{}; }
    [[nodiscard]] const Coordinates<d>& velocity(std::size_t v) const { return velocity_[v]; }
    /// Where v, anchored at f, is expected now.
    [[nodiscard]] Coordinates<d> expected(std::size_t v, const Coordinates<d>& f) const {
        Coordinates<d> e = f;
        const double steps = now_ - anchored_[v];
        for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) e[k] += steps * velocity_[v][k];
        return e;
    }

    /// Half the diagonal of the box of the points' velocities, rounded up: all are within that of its middle.
    template <class Points>
    [[nodiscard]] static double spread(const Points& points, const std::vector<Coordinates<d>>& velocity) {
        Coordinates<d> low;
        Coordinates<d> high;
        low.fill(std::numeric_limits<double>::infinity());
        high.fill(-std::numeric_limits<double>::infinity());
        for (const Index v : points) {
            if (v == none) continue;
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
                low[k] = std::min(low[k], velocity[static_cast<std::size_t>(v)][k]);
                high[k] = std::max(high[k], velocity[static_cast<std::size_t>(v)][k]);
            }
        }
        return low == high ? 0.0 : 0.5 * distance_upper<d>(low, high) * (1.0 + 0x1p-50);
    }
    /// The term of a certificate evaluated now.
    template <class Points>
    [[nodiscard]] Term term(const Points& points, double tolerance) const {
        if (!active()) return {tolerance, forever};
        const double rho = spread(points, velocity_);
        if (rho == 0.0) return {tolerance, forever};
        const double steps = 0.5 * tolerance / rho * (1.0 - 0x1p-40);
        const double most = horizon - 2;
        return {0.5 * tolerance, now_ + static_cast<Time>(std::min(most, std::floor(std::max(0.0, steps))))};
    }
    /// Certificate `id` wants to be looked at when its term has ended.
    void schedule(Index id, Time until) {
        if (until != forever) calendar_[(until + 1) % horizon].push_back(id);
    }
    /// Those whose term may have ended (a certificate evaluated since has another term now).
    [[nodiscard]] std::span<const Index> due() const {
        return active() ? std::span<const Index>(calendar_[now_ % horizon]) : std::span<const Index>{};
    }
    void forget_due() {
        if (active()) calendar_[now_ % horizon].clear();
    }

  private:
    static constexpr Time horizon = 1024;  // the longest term

    std::vector<Coordinates<d>> velocity_;  // by vertex, a step; empty: everything rests
    std::vector<Time> anchored_;            // by vertex: time of its fixed position
    std::vector<std::vector<Index>> calendar_;
    double reach_ = 0.0;
    double slack_ = 0.0;
    Time now_ = 0;
};

}  // namespace annulus
