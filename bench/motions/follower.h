// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "stopwatch.h"

#include <annulus/options.h>
#include <annulus/types.h>

#include <memory>
#include <string>

namespace bench {

/// An object that follows a motion.
template <int d>
class Follower {
  public:
    virtual ~Follower() = default;
    /// One time step: removals, the move of all, insertions. Returns the time.
    virtual double follow(const Motion<d>& motion, Stopwatch watch, annulus::Move_result& report) = 0;
    [[nodiscard]] virtual bool is_delaunay() const = 0;
};

/// `name` is a strategy of Moving_delaunay; with the suffix `:view` CGAL's triangulation is requested at each time
/// step, and this is counted; with `:mesh` it is Moving_mesh. Throws std::invalid_argument for other names.
template <int d>
[[nodiscard]] std::unique_ptr<Follower<d>> follower(const std::string& name, int threads, const Points<d>& x);

extern template std::unique_ptr<Follower<2>> follower<2>(const std::string&, int, const Points<2>&);
extern template std::unique_ptr<Follower<3>> follower<3>(const std::string&, int, const Points<3>&);

}  // namespace bench
