// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "stopwatch.h"

#include <annulus/engine/move_report.h>
#include <annulus/engine/options.h>

#include <memory>
#include <string>

namespace bench {

/// An object that is kept up to date with a motion.
template <int d>
class Follower {
  public:
    virtual ~Follower() = default;
    /// One time step: departures, the move of all, arrivals. Returns what it took.
    virtual double follow(const Motion<d>& motion, Stopwatch watch, annulus::Move_report& report) = 0;
    [[nodiscard]] virtual bool is_delaunay() const = 0;
};

/// `name` is that of a strategy, of Moving_delaunay; with `:view` behind it CGAL's triangulation is asked for at each
/// time step, which is counted; with `:mesh` it is Moving_mesh. Throws std::invalid_argument for other names.
template <int d>
[[nodiscard]] std::unique_ptr<Follower<d>> follower(const std::string& name, int threads, const Points<d>& x);

extern template std::unique_ptr<Follower<2>> follower<2>(const std::string&, int, const Points<2>&);
extern template std::unique_ptr<Follower<3>> follower<3>(const std::string&, int, const Points<3>&);

}  // namespace bench
