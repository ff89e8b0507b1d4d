// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../motions/stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace bench {

/// Replaces the contents of the caches, as other code does between two time steps.
inline double seconds(const std::function<void()>& f) {
    static std::vector<std::uint64_t> others(std::size_t{1} << 20);
    for (std::uint64_t& word : others) word += 1;
    const Stopwatch watch;
    const double begin = watch.seconds();
    f();
    return watch.seconds() - begin;
}

/// The least of several: disturbances only add time.
inline double least(int times, const std::function<void()>& f) {
    double best = seconds(f);
    for (int k = 1; k < times; ++k) best = std::min(best, seconds(f));
    return best;
}

/// The factor f of y = f x, by least squares of relative errors.
class Factor {
  public:
    void add(double x, double y) {
        if (!(y > 0.0)) return;
        xy_ += x / y;
        xx_ += x / y * (x / y);
    }
    /// NaN for an empty list.
    [[nodiscard]] double value() const { return xy_ / xx_; }

  private:
    double xy_ = 0.0;
    double xx_ = 0.0;
};

}  // namespace bench
