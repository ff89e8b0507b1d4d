// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Motions of any number of steps, in 2D and in 3D. A seed always gives the same motion; its length, the audits and the
// strategy that follows it do not change it.

#include <support/generators.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace annulus::testing {

enum class Motion_kind {
    shear,         ///< x += rate * y, back where the shear has become large
    rotation,      ///< as a whole, about an axis
    drift,         ///< all points move straight, reflected by the walls of the box
    common_drift,  ///< all points move away together, a few at their own pace
    breathing,     ///< every axis swells and shrinks at its own pace
    orbits,        ///< every point on its own circle
    flow,          ///< a steady divergence-free flow
    reversal,      ///< a drift that turns round every 4,094 to 4,098 steps
    acceleration,  ///< a drift from 1e-9 to 1e-1 spacings a step, and again
    settling,      ///< steps that shrink until nothing changes any more, then a new start
    growth,        ///< from 2^-60 to 2^60 and back
    jitter,        ///< again around the same places
    bursts,        ///< rest, and now and then a few steps that are large, or a vertex far away
    teleports,     ///< one vertex a step to any place
    few_movers,    ///< one to three vertices walk, then others
    rest_and_go,   ///< a drift that stops for a while and goes on
    oscillation,   ///< a grid that is perturbed and becomes exactly a grid again
    cocircular,    ///< the same of points that are exactly on one circle or sphere
    sliding,       ///< rows of a grid slide along each other, by exact fractions of the spacing
    clusters,      ///< a walk in clusters of very different sizes
    walk_tiny,     ///< random walks: steps of 1e-6 spacings
    walk_small,    ///< 1e-3
    walk_middle,   ///< 0.03
    walk_large,    ///< 1
};
inline constexpr std::array all_motions{
    Motion_kind::shear,        Motion_kind::rotation,   Motion_kind::drift,       Motion_kind::common_drift,
    Motion_kind::breathing,    Motion_kind::orbits,     Motion_kind::flow,        Motion_kind::reversal,
    Motion_kind::acceleration, Motion_kind::settling,   Motion_kind::growth,      Motion_kind::jitter,
    Motion_kind::bursts,       Motion_kind::teleports,  Motion_kind::few_movers,  Motion_kind::rest_and_go,
    Motion_kind::oscillation,  Motion_kind::cocircular, Motion_kind::sliding,     Motion_kind::clusters,
    Motion_kind::walk_tiny,    Motion_kind::walk_small, Motion_kind::walk_middle, Motion_kind::walk_large};

[[nodiscard]] constexpr std::string_view name_of(Motion_kind kind) {
    constexpr std::array<std::string_view, all_motions.size()> names{
        "shear",   "rotation",  "drift",        "common-drift", "breathing",   "orbits",
        "flow",    "reversal",  "acceleration", "settling",     "growth",      "jitter",
        "bursts",  "teleports", "few-movers",   "rest-and-go",  "oscillation", "cocircular",
        "sliding", "clusters",  "walk-tiny",    "walk-small",   "walk-middle", "walk-large"};
    return names[static_cast<std::size_t>(kind)];
}

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
        if (kind_ == Motion_kind::cocircular) homes = integer_points_of_one_norm();
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
    static std::vector<Place> integer_points_of_one_norm() {
        std::vector<Place> points;
        if constexpr (d == 2) {
            constexpr int r = 32045;  // 5 * 13 * 17 * 29: 324 points
            for (int x = -r; x <= r; ++x) {
                const double square = static_cast<double>(r) * r - static_cast<double>(x) * x;
                const double y = std::sqrt(square);  // exact where it is an integer
                if (y != std::floor(y)) continue;
                points.push_back({x * 0x1p-16, y * 0x1p-16});
                if (y != 0) points.push_back({x * 0x1p-16, -y * 0x1p-16});
            }
        } else {
            constexpr int r = 45;
            for (int x = -r; x <= r; ++x)
                for (int y = -r; y <= r; ++y)
                    for (int z = -r; z <= r; ++z)
                        if (x * x + y * y + z * z == r * r) points.push_back({x * 0x1p-6, y * 0x1p-6, z * 0x1p-6});
        }
        return points;
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
            case Motion_kind::flow: return along_flow(p);
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
    /// Taylor and Green's vortices in 2D, one of the flows of Arnold, Beltrami and Childress in 3D.
    [[nodiscard]] Place along_flow(const Place& p) const {
        constexpr double pi = std::numbers::pi;
        Place u{};
        if constexpr (d == 2) {
            u = {std::sin(pi * flow_ * p[0]) * std::cos(pi * flow_ * p[1]),
                 -std::cos(pi * flow_ * p[0]) * std::sin(pi * flow_ * p[1])};
        } else {
            u = {std::sin(pi * flow_ * p[2]) + std::cos(pi * flow_ * p[1]),
                 std::sin(pi * flow_ * p[0]) + std::cos(pi * flow_ * p[2]),
                 std::sin(pi * flow_ * p[1]) + std::cos(pi * flow_ * p[0])};
        }
        return shifted(p, u, pace_);
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
