// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/follower.h>
#include <apps/reproduction/records.h>

#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How one strategy of a benchmark follows the motion.
struct Contender_plan {
    enum class Kind {
        cgal_rebuild,   ///< CGAL's insertion of a range: the paper's rebuilding
        cgal_relocate,  ///< CGAL's insertion and removal of each vertex: the paper's relocation
        follower,       ///< a triangulation that follows all steps
        copy,           ///< one that is built at the positions before each step that it follows: for slow strategies
        /// The paper's variant (4.2): CGAL's insertion of a range until a sample stays within tolerance, then the
        /// algorithm of 3.2.
        hybrid,
    };
    std::string name;
    Kind kind = Kind::follower;
    Options options{};
    std::uint64_t every = 1;              ///< every which step is followed; 1 for followers
    std::uint64_t audit_every = 0;        ///< in steps; 0: only at the end
    std::optional<Paper_choice> paper{};  ///< a variant of the paper's algorithms, instead of the options' strategy
};

/// One contender in a run. Times are processor times of one thread; the construction of a follower is timed separately.
template <int d>
class Contender {
  public:
    Contender(Contender_plan plan, std::span<const Coordinates<d>> points, std::uint64_t seed);
    /// Step number `step`, from 1: every point from `before` to `target`.
    void follow(std::uint64_t step, std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target);
    /// Makes the exact audit at the end, and returns the record.
    [[nodiscard]] Contender_record finish();

  private:
    void build(std::span<const Coordinates<d>> points);
    void move_all(std::uint64_t step, std::span<const Coordinates<d>> target, double more);
    void count_streaks(std::uint64_t step);
    void note(std::uint64_t step, double seconds, const Move_result& report);
    void audit(std::uint64_t step);
    void follow_hybrid(std::uint64_t step, std::span<const Coordinates<d>> before,
                       std::span<const Coordinates<d>> target);
    [[nodiscard]] bool sample_stays(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target);

    Contender_plan plan_;
    Contender_record record_;
    std::unique_ptr<Follower<d>> dt_;
    std::vector<std::uint64_t> streak_, last_failure_;  // by vertex: consecutive failures, and the last step with one
    std::mt19937_64 random_;
    std::uint64_t last_audit_ = 0;
};

extern template class Contender<2>;
extern template class Contender<3>;

}  // namespace annulus::inline v1
