// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/upper_half.h>
#include <annulus/relocation/displacement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace annulus {

/// What a step reads of every vertex to tell whether it moved too far: in the plane half a cache line.
template <int d>
struct Vertex_record {
    using Time = std::uint32_t;

    Coordinates<d> fixed{};                                     ///< fixed position, at time `since`
    std::array<float, static_cast<std::size_t>(d)> velocity{};  ///< in units of Prediction::speed() a tick
    Upper_half threshold;                                       ///< squared, compared with |moving - expected|^2
    Time since = 0;

    /// Where the vertex is expected at time `now`: its fixed position when nothing is predicted. `speed` is that of the
    /// prediction, a power of two.
    [[nodiscard]] Coordinates<d> expected(Time now, double speed) const {
        Coordinates<d> e = fixed;
        const double way = static_cast<std::int32_t>(now - since) * speed;
        for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) e[k] += way * static_cast<double>(velocity[k]);
        return e;
    }
    [[nodiscard]] bool rests() const { return velocity == std::array<float, static_cast<std::size_t>(d)>{}; }
};

/// Prediction of a motion: fixed positions that move along, so that a drift shared by neighbours costs nothing.
///
/// Vertex v anchored at f at time t_v is expected at f + (t - t_v) u_v. Certificates do not change when all their points
/// move by one vector, so what wears out a certificate evaluated at time t0 with tolerance s is the difference of the
/// velocities of its points and their deviations from the prediction: with all velocities within rho of some vector,
/// it holds while (t - t0) rho + deviation < s at every point (docs/theory.md 5.4). Each gets a share of s; `Term::until`
/// is the last time at which the first share suffices. Without velocities the prediction is that everything rests,
/// terms never end and deviations have all of s.
///
/// Time is not the number of steps. It may pass as it likes, as long as it is the same for all vertices: each step
/// lasts as many ticks as fit best what the vertices did (`ticks_of_step`), so that a motion that slows down everywhere
/// alike goes on as predicted.
///
/// The predicted position is computed in doubles: off by at most 2^-51 times the largest coordinate or so, per
/// coordinate. `slack()` is above that and is added to every deviation.
template <int d>
class Prediction {
  public:
    using Time = typename Vertex_record<d>::Time;
    static constexpr Time forever = std::numeric_limits<Time>::max();
    /// What deviations get of a tolerance; measured to need the fewest evaluations.
    static constexpr double deviation_share = 0.6875;
    /// Settle when this is reached.
    static constexpr Time latest = Time{1} << 30;

    struct Term {
        double tolerance;  ///< for the deviation of each point
        Time until;        ///< last time at which the certificate may be trusted
    };

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] Time now() const { return now_; }
    [[nodiscard]] double slack() const { return slack_; }
    /// The unit of velocities, a power of two.
    [[nodiscard]] double speed() const { return speed_; }

    /// Everything rests from now on, and nothing is scheduled.
    void clear(std::span<Vertex_record<d>> vertices) {
        for (auto& v : vertices) {
            v.velocity = {};
            v.since = 0;
        }
        for (auto& bucket : calendar_) bucket.clear();
        active_ = false;
        slack_ = 0.0;
        speed_ = 1.0;
        before_ = now_ = 0;
    }
    /// Vertex v moves by displacement[v] in a step of ordinary length. Replaces everything predicted before. `reach`
    /// bounds the coordinates.
    void adopt(std::span<const Coordinates<d>> displacement, std::span<Vertex_record<d>> vertices, double reach) {
        clear(vertices);
        double most = 0.0;
        for (const auto& u : displacement)
            for (const double c : u) most = std::max(most, std::fabs(c));
        speed_ = most > 0x1p-900 ? std::ldexp(1.0, std::ilogb(most)) : 0x1p-900;
        for (std::size_t v = 0; v < displacement.size(); ++v)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
                vertices[v].velocity[k] = static_cast<float>(displacement[v][k] / speed_);
        speed_ /= ticks_a_step;
        calendar_.resize(horizon);
        active_ = true;
        limit_ = 2.0 * reach;
        slack_ = reach * 0x1p-46;
    }
    /// Coordinates up to this are covered by slack(); when one is larger, settle anew.
    [[nodiscard]] double limit() const { return active_ ? limit_ : std::numeric_limits<double>::infinity(); }

    /// The number of ticks after which the prediction fits best where the vertices went, in the mean of squares over a
    /// sample of them.
    [[nodiscard]] Time ticks_of_step(std::span<const Coordinates<d>> from, std::span<const Coordinates<d>> to,
                                     std::span<const Vertex_record<d>> vertices) const {
        if (!active_) return 0;
        const std::size_t stride = 1 + to.size() / 256;
        double along = 0.0;
        double length = 0.0;
        for (std::size_t v = 0; v < to.size(); v += stride)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
                const double u = static_cast<double>(vertices[v].velocity[k]);
                along += (to[v][k] - from[v][k]) * u;
                length += u * u;
            }
        const double ticks = along / (length * speed_);
        return ticks > 0.0 ? static_cast<Time>(std::min(ticks + 0.5, 4.0 * ticks_a_step)) : Time{0};
    }
    void advance(Time ticks) {
        before_ = now_;
        now_ += ticks;
    }
    void retreat() { now_ = before_; }

    /// Half the diagonal of the box of the points' velocities, rounded up: all are within that of its middle.
    /// `velocity(v)` is that of vertex v.
    template <class Points, class Velocity>
    [[nodiscard]] static double spread(const Points& points, Velocity velocity) {
        Coordinates<d> low;
        Coordinates<d> high;
        low.fill(std::numeric_limits<double>::infinity());
        high.fill(-std::numeric_limits<double>::infinity());
        for (const Index v : points) {
            if (v == none) continue;
            const Coordinates<d> u = velocity(v);
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
                low[k] = std::min(low[k], u[k]);
                high[k] = std::max(high[k], u[k]);
            }
        }
        return low == high ? 0.0 : 0.5 * distance_upper<d>(low, high) * (1.0 + 0x1p-50);
    }
    /// The term of a certificate evaluated now.
    template <class Points>
    [[nodiscard]] Term term(const Points& points, double tolerance, std::span<const Vertex_record<d>> vertices) const {
        if (!active_) return {tolerance, forever};
        const double rho = speed_ * spread(points, [vertices](Index v) {
                               Coordinates<d> u;
                               for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
                                   u[k] = static_cast<double>(vertices[static_cast<std::size_t>(v)].velocity[k]);
                               return u;
                           });
        if (rho == 0.0) return {tolerance, forever};
        const double ticks = (1.0 - deviation_share) * tolerance / rho * (1.0 - 0x1p-40);
        const double most = (horizon - 2) * ticks_a_day;
        const Time end = now_ + static_cast<Time>(std::min(most, std::floor(std::max(0.0, ticks))));
        const Time midnight = end / ticks_a_day * ticks_a_day;  // terms end with a day of the calendar if they can
        return {deviation_share * tolerance, midnight > now_ ? midnight - 1 : end};
    }
    /// Certificate `id` wants to be looked at when its term has ended.
    void schedule(Index id, Time until) {
        if (until != forever) calendar_[day(until + 1) % horizon].push_back({id, until});
    }
    /// Calls visit(id, until) for those whose term may have ended with this step (a certificate evaluated since has
    /// another term now).
    template <class Visit>
    void for_each_due(Visit visit) const {
        if (!active_ || now_ == before_) return;
        for (Time t = day(before_); t <= day(now_); ++t)
            for (const auto& entry : calendar_[t % horizon])
                if (entry.until < now_) visit(entry.id, entry.until);
    }
    [[nodiscard]] bool any_due() const {
        bool any = false;
        for_each_due([&any](Index, Time) { any = true; });
        return any;
    }
    /// To be called once the step is done.
    void forget_due() {
        if (!active_ || now_ == before_) return;
        for (Time t = day(before_); t < day(now_); ++t) calendar_[t % horizon].clear();
        std::erase_if(calendar_[day(now_) % horizon], [this](const Entry& entry) { return entry.until < now_; });
    }

  private:
    struct Entry {
        Index id;
        Time until;
    };
    static constexpr Time ticks_a_step = 1024;  // of ordinary length
    static constexpr Time ticks_a_day = 256;
    static constexpr Time horizon = 4096;  // the longest term in days, about
    [[nodiscard]] static Time day(Time t) { return t / ticks_a_day; }

    std::vector<std::vector<Entry>> calendar_;  // by day, modulo horizon
    bool active_ = false;
    double limit_ = 0.0;
    double slack_ = 0.0;
    double speed_ = 1.0;
    Time before_ = 0;  // before this step
    Time now_ = 0;
};

}  // namespace annulus
