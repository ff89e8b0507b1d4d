// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/tally.h>

#include <map>
#include <string>
#include <vector>

namespace annulus {

/// What experiments that differ in nothing but their seed have found together.
struct Grid_point {
    nlohmann::ordered_json where;  ///< what they have in common, from "grid" to "step" or "frame"
    Tally tally{};
};

/// Adds lines of results by grid point. Points are in the order in which they are met first; their sums do not depend
/// on any order.
class Sums {
  public:
    /// One experiment, as its line has it.
    void add(const nlohmann::ordered_json& line);
    [[nodiscard]] const std::vector<Grid_point>& points() const { return point_; }

  private:
    std::vector<Grid_point> point_;
    std::map<std::string, std::size_t> place_;  // by `where` as text
};

}  // namespace annulus
