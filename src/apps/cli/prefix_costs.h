// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/frame_change.h>
#include <apps/report/advice_record.h>

#include <cstdint>
#include <span>

namespace annulus::inline v1::cli {

/// What strategies `auto` and `tolerances` cost on the first steps of a motion, in rebuilds, by counts of work. They
/// follow every frame as `replay` does: removals, one move_all, insertions. The first step, in which strategies have no
/// past to judge by, is counted only if there is no other.
template <int d>
class Prefix_costs {
  public:
    /// No step is followed after which more vertices would have been moved: half a minute or so.
    static constexpr std::uint64_t most_moves = 20'000'000;

    /// From the first frame; counts `most_steps` at most. Throws what Moving_mesh throws.
    Prefix_costs(const Frame_points<d>& first, std::uint64_t most_steps, int threads);
    /// One step, unless there were enough.
    void follow(const Frame_points<d>& frame);
    [[nodiscard]] Prefix_record record() const;
    /// Of strategy `auto`.
    [[nodiscard]] const Moving_mesh<d>& mesh() const { return automatic_.mesh; }

  private:
    struct Follower {
        Moving_mesh<d> mesh;
        Present present;
        double cost = 0;  // in rebuilds

        Move_result follow(const Frame_points<d>& frame);
    };
    [[nodiscard]] static Follower start(const Frame_points<d>& first, Strategy strategy, int threads);

    Follower automatic_, tolerances_;
    std::uint64_t most_steps_;
    std::uint64_t followed_ = 0, moves_ = 0;
    Prefix_record record_;
};

extern template class Prefix_costs<2>;
extern template class Prefix_costs<3>;

}  // namespace annulus::inline v1::cli
