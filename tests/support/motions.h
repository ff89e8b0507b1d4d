// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Motions of any number of steps, in 2D and in 3D. A seed always gives the same motion; its length, the audits and the
// strategy that follows it do not change it.

#include <support/generators.h>
#include <support/motion_kinds.h>
#include <support/motion_parts.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace annulus::testing {

/// Positions of n points, step after step. Most kinds keep to a box of side 1; none leaves the domain.
/// Points are distinct at the start and nearly always later: a degenerate kind may bring two together.
template <int d>
class Long_motion {
  public:
    using Place = Coordinates<d>;

    Long_motion(Motion_kind kind, std::size_t n, Random& random)
        : kind_(kind), random_(random()), spacing_(std::pow(static_cast<double>(n), -1.0 / d)), members_(n), x_(n) {
        pace_ = std::exp2(between(random_, -20, -7)) * spacing_;
        amplitude_ = std::exp2(between(random_, -12, -1)) * spacing_;
        omega_ = std::exp2(between(random_, -17, -7));
        flow_ = between(random_, 1, 3);
        for (double& phase : phases_) phase = between(random_, 0, 6);
        place_grid_or_circle();
        for (std::size_t i = 0; i < n; ++i) start(i);
        common_ = direction();
        for (std::size_t i = 0; i < n; ++i) x_[i] = at_present(i);
    }

    [[nodiscard]] const std::vector<Place>& positions() const { return x_; }
    [[nodiscard]] Motion_kind kind() const { return kind_; }

    /// One step on.
    const std::vector<Place>& advance() {
        ++step_;
        time_ += 1;
        begin_step();
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = next(i);
        return x_;
    }

    /// Puts another point at index i, as if it had been there from the beginning. Returns its position.
    const Place& renew(std::size_t i) {
        members_[i].home = anywhere();
        start(i);
        return x_[i] = at_present(i);
    }

  private:
    struct Member {
        Place home{};
        Place velocity{};
        double rate = 1;
        double phase = 0;
    };

    // ---- Where points begin -------------------------------------------------------------------------------------

    [[nodiscard]] Place anywhere() {
        Place p;
        for (double& c : p) c = between(random_, 0, 1);
        return p;
    }
    /// Uniform in the cube [-1, 1]^d.
    [[nodiscard]] Place direction() {
        Place p;
        for (double& c : p) c = between(random_, -1, 1);
        return p;
    }
    void place_grid_or_circle() {
        std::vector<Place> homes;
        if (kind_ == Motion_kind::cocircular) homes = integer_points_of_one_norm<d>();
        std::shuffle(homes.begin(), homes.end(), random_);
        int side = 1;
        while (std::pow(side, d) < static_cast<double>(members_.size())) ++side;
        grid_ = 1.0 / std::exp2(std::ceil(std::log2(side)));  // a power of two: places of the grid are exact
        for (std::size_t i = 0; i < members_.size(); ++i) {
            Place& home = members_[i].home;
            if (kind_ == Motion_kind::oscillation || kind_ == Motion_kind::sliding) {
                std::size_t rest = i;
                for (double& c : home) {
                    c = grid_ * static_cast<double>(rest % static_cast<std::size_t>(side));
                    rest /= static_cast<std::size_t>(side);
                }
            } else if (kind_ == Motion_kind::clusters) {
                // A cluster of about eight, each with its size and its middle.
                if (i % 8 == 0) size_ = std::exp2(-2.0 * integer(random_, 1, 10)), middle_ = anywhere();
                members_[i].rate = size_;
                for (std::size_t k = 0; k < d; ++k) home[k] = middle_[k] + size_ * between(random_, -1, 1);
            } else {
                home = i < homes.size() ? homes[i] : anywhere();
            }
        }
    }
    void start(std::size_t i) {
        Member& m = members_[i];
        m.velocity = direction();
        m.phase = between(random_, 0, 2 * std::numbers::pi);
        if (kind_ != Motion_kind::clusters) m.rate = between(random_, 0.5, 1.5) * (random_() % 2 == 0 ? 1 : -1);
        x_[i] = m.home;
    }

    // ---- A step -------------------------------------------------------------------------------------------------

    void begin_step() {
        switch (kind_) {
            case Motion_kind::shear:
                if (std::fabs(sheared_ + forward_ * shear_rate()) > 3) forward_ = -forward_;
                sheared_ += forward_ * shear_rate();
                break;
            case Motion_kind::reversal:
                if (--rest_ <= 0) forward_ = -forward_, rest_ = integer(random_, 4094, 4098);
                break;
            case Motion_kind::acceleration:
                pace_ *= 1.0005;
                if (pace_ < 1e-9 * spacing_ || pace_ > 0.1 * spacing_) pace_ = 1e-9 * spacing_;
                break;
            case Motion_kind::settling:
                pace_ *= 0.995;
                if (pace_ < 0x1p-60) pace_ = 0.1 * spacing_;
                break;
            case Motion_kind::growth:
                if (std::fabs(logarithm_ + forward_ / 512) > 60) forward_ = -forward_;
                logarithm_ += forward_ / 512;
                break;
            case Motion_kind::bursts:
            case Motion_kind::rest_and_go:
                if (--rest_ > 0) break;
                going_ = !going_;
                rest_ = kind_ == Motion_kind::bursts ? integer(random_, 1, going_ ? 8 : 100)
                                                     : integer(random_, 1, integer(random_, 0, 3) == 0 ? 5000 : 50);
                if (kind_ == Motion_kind::bursts) amplitude_ = std::exp2(between(random_, -8, 0)) * spacing_;
                break;
            case Motion_kind::few_movers:
                if (--rest_ <= 0) {
                    rest_ = integer(random_, 1, 1000);
                    movers_.assign(static_cast<std::size_t>(integer(random_, 1, 3)), 0);
                    for (std::size_t& m : movers_) m = random_() % x_.size();
                }
                break;
            case Motion_kind::teleports: movers_.assign(1, random_() % x_.size()); break;
            case Motion_kind::oscillation:
            case Motion_kind::cocircular:
                // A wave of whole numbers, so that it is exactly 0 twice in a period.
                if (++tick_ % period_ == 0) {
                    period_ = integer(random_, 1, 400);
                    tick_ = 0;
                    for (Member& m : members_) m.velocity = direction();
                }
                break;
            default: break;
        }
    }

    /// Position after the step that begin_step() began.
    [[nodiscard]] Place next(std::size_t i) {
        Place p = x_[i];
        Member& m = members_[i];
        switch (kind_) {
            case Motion_kind::shear: p[0] += forward_ * shear_rate() * p[1]; return p;
            case Motion_kind::drift:
            case Motion_kind::acceleration: return reflected(shifted(p, m.velocity, pace_), m.velocity);
            case Motion_kind::reversal: return shifted(p, m.velocity, forward_ * std::min(pace_, spacing_ * 0x1p-12));
            case Motion_kind::common_drift: return shifted(shifted(p, common_, pace_), m.velocity, pace_ / 64);
            case Motion_kind::flow: return shifted(p, steady_flow<d>(p, flow_), pace_);
            case Motion_kind::settling: return reflected(shifted(p, m.velocity, pace_), m.velocity);
            case Motion_kind::jitter: return shifted(m.home, direction(), amplitude_);
            case Motion_kind::bursts:
                if (!going_) return p;
                if (random_() % 64 == 0) return anywhere();
                return reflected(shifted(p, direction(), amplitude_), m.velocity);
            case Motion_kind::rest_and_go: return going_ ? reflected(shifted(p, m.velocity, pace_), m.velocity) : p;
            case Motion_kind::few_movers:
                if (std::find(movers_.begin(), movers_.end(), i) == movers_.end()) return p;
                return reflected(shifted(p, direction(), 0.02 * spacing_), m.velocity);
            case Motion_kind::teleports: return i == movers_[0] ? anywhere() : p;
            case Motion_kind::clusters: return shifted(p, direction(), 0.01 * m.rate);
            case Motion_kind::walk_tiny: return walked(p, 1e-6);
            case Motion_kind::walk_small: return walked(p, 1e-3);
            case Motion_kind::walk_middle: return walked(p, 0.03);
            case Motion_kind::walk_large: return walked(p, 1);
            default: return at_present(i);
        }
    }

    /// The present position for a kind that is a function of time; for others the first position.
    [[nodiscard]] Place at_present(std::size_t i) const {
        const Member& m = members_[i];
        Place p = m.home;
        switch (kind_) {
            case Motion_kind::rotation: {
                const double c = std::cos(omega_ * time_);
                const double s = std::sin(omega_ * time_);
                p = {};
                for (std::size_t k = 0; k < d; ++k) p[k] = m.home[k] - 0.5;
                const double x = c * p[0] - s * p[1];
                p[1] = s * p[0] + c * p[1];
                p[0] = x;
                return p;
            }
            case Motion_kind::breathing:
                for (std::size_t k = 0; k < d; ++k)
                    p[k] *= 1 + 0.4 * std::sin(omega_ * time_ * (1 + 0.37 * static_cast<double>(k)) + phases_[k]);
                return p;
            case Motion_kind::orbits: {
                const double angle = m.phase + omega_ * time_ * m.rate;
                p[0] += amplitude_ * std::cos(angle);
                p[1] += amplitude_ * std::sin(angle);
                if constexpr (d == 3) p[2] += amplitude_ * std::sin(2 * angle + 1);
                return p;
            }
            case Motion_kind::growth: {
                // A little slower at one end than at the other, else there would be no flips.
                for (std::size_t k = 0; k < d; ++k)
                    p[k] = (p[k] + 0.02 * std::sin(omega_ * time_ * m.rate + m.phase)) * std::exp2(logarithm_);
                return p;
            }
            case Motion_kind::oscillation: return shifted(p, m.velocity, 0.3 * grid_ * wave());
            case Motion_kind::cocircular: return shifted(p, m.velocity, amplitude_ * wave());
            case Motion_kind::sliding: {
                const int row =
                    static_cast<int>(std::lround(m.home[1] / grid_ + (d == 3 ? 2 * m.home[d - 1] / grid_ : 0)));
                const double far = std::fabs(std::remainder(static_cast<double>(step_), 0x1p13)) * 0x1p-10;
                p[0] += grid_ * far * (row % 3 - 1);
                return p;
            }
            default: return p;
        }
    }

    [[nodiscard]] double shear_rate() const { return std::clamp(amplitude_ / spacing_ * 1e-3, 1e-6, 2e-4); }
    [[nodiscard]] double wave() const {
        return static_cast<double>(std::min(tick_, period_ - tick_)) / static_cast<double>(period_);
    }
    [[nodiscard]] static Place shifted(Place p, const Place& direction, double by) {
        for (std::size_t k = 0; k < d; ++k) p[k] += by * direction[k];
        return p;
    }
    [[nodiscard]] Place walked(const Place& p, double spacings) {
        Place ignored{};
        return reflected(shifted(p, direction(), spacings * spacing_), ignored);
    }
    /// Moves a point back into the box, and reflects its velocity at the wall.
    [[nodiscard]] static Place reflected(Place p, Place& velocity) {
        for (std::size_t k = 0; k < d; ++k) {
            if (p[k] >= 0 && p[k] <= 1) continue;
            p[k] = p[k] < 0 ? -p[k] : 2 - p[k];
            velocity[k] = -velocity[k];
        }
        return p;
    }
    Motion_kind kind_;
    Random random_;
    double spacing_;
    std::vector<Member> members_;
    std::vector<Place> x_;
    std::uint64_t step_ = 0;
    double time_ = 0;
    double pace_ = 0;       // a step
    double amplitude_ = 0;  // around a home
    double omega_ = 0;      // radians a step
    double flow_ = 1;
    double grid_ = 1;
    double size_ = 1;
    Place middle_{};
    Place common_{};
    std::array<double, 3> phases_{};
    double sheared_ = 0;
    double logarithm_ = -60;
    double forward_ = 1;
    bool going_ = false;
    int rest_ = 0;
    int tick_ = 0;
    int period_ = 100;
    std::vector<std::size_t> movers_;
};

/// The kind with that name.
[[nodiscard]] inline std::optional<Motion_kind> motion_named(std::string_view name) {
    for (const Motion_kind kind : all_motions)
        if (name_of(kind) == name) return kind;
    return std::nullopt;
}

}  // namespace annulus::testing
