// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/records.h>
#include <annulus/reproduction/survey.h>

#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace annulus {

/// How one strategy of a race follows the motion.
struct Racer_plan {
    enum class Kind {
        cgal,      ///< CGAL's insertion of a range: the paper's rebuilding
        follower,  ///< a triangulation that goes all the way
        copy,      ///< one that is built at the positions before each step that it follows: for what is slow
        paper_hybrid,  ///< the paper's variant (4.2): CGAL's insertion of a range until a sample stays within tolerance, then its filter
    };
    std::string name;
    Kind kind = Kind::follower;
    Options options{};
    std::uint64_t every = 1;        ///< steps; others are not followed. 1 for followers
    std::uint64_t audit_every = 0;  ///< steps; 0: at the end alone
};

/// One of them under way. Times are of one thread's processor; what a follower needs to be built is timed apart.
template <int d>
class Racer {
  public:
    Racer(Racer_plan plan, std::span<const Coordinates<d>> points, std::uint64_t seed);
    /// Step number `step`, from 1: every point from `before` to `target`.
    void follow(std::uint64_t step, std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target);
    /// The exact audit of the end, and the record.
    [[nodiscard]] Racer_record finish();

  private:
    void build(std::span<const Coordinates<d>> points);
    void note(std::uint64_t step, double seconds, const Move_report& report);
    void audit(std::uint64_t step);
    void follow_hybrid(std::uint64_t step, std::span<const Coordinates<d>> before,
                       std::span<const Coordinates<d>> target);
    [[nodiscard]] bool sample_stays(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target);

    Racer_plan plan_;
    Racer_record record_;
    std::unique_ptr<Moving_of<d>> dt_;
    std::mt19937_64 random_;
    std::uint64_t last_audit_ = 0;
};

extern template class Racer<2>;
extern template class Racer<3>;

}  // namespace annulus
