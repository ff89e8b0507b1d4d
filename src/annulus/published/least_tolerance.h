// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace annulus::inline v1 {

/// The least tolerance of each point among some certificates.
class Least_tolerance {
  public:
    void resize(std::size_t vertices) { least_.resize(vertices, unlimited); }

    /// Notes a certificate with this tolerance; its sites may end in `none`.
    template <class Sites>
    void note(const Sites& sites, double tolerance) {
        for (const auto& [v, label] : sites) {
            if (v == none) continue;
            double& least = least_[static_cast<std::size_t>(v)];
            if (least == unlimited) touched_.push_back(v);
            least = std::min(least, tolerance);
        }
    }
    /// Calls visit(v, tolerance) for every point, and resets everything.
    template <class Visit>
    void take(Visit visit) {
        for (const Index v : touched_) {
            double& least = least_[static_cast<std::size_t>(v)];
            const double tolerance = least;
            least = unlimited;
            visit(v, tolerance);
        }
        touched_.clear();
    }
    void clear() {
        take([](Index, double) {});
    }

  private:
    static constexpr double unlimited = std::numeric_limits<double>::infinity();
    std::vector<double> least_;   // by vertex
    std::vector<Index> touched_;  // those that are not unlimited
};

}  // namespace annulus::inline v1
