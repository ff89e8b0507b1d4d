// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/tally.h>

#include <map>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The sum of the results of experiments that differ only in their seed.
struct Grid_point {
    nlohmann::ordered_json where;  ///< their common values, from "grid" to "step" or "frame"
    Tally tally{};
};

/// Adds lines of results by grid point. Grid points are in the order of their first line; their sums do not depend on
/// any order.
class Sums {
  public:
    /// Adds one experiment, given as its line.
    void add(const nlohmann::ordered_json& line);
    [[nodiscard]] const std::vector<Grid_point>& points() const { return point_; }

  private:
    std::vector<Grid_point> point_;
    std::map<std::string, std::size_t> place_;  // by `where` as text
};

}  // namespace annulus::inline v1
