// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/decimal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace annulus::inline v1 {

/// How far the times of successive frames are apart.
class Time_distances {
  public:
    /// Takes the time of the next frame, which is above the one before, and the line where the frame begins.
    void take(double time, std::uint64_t line) {
        if (count_++ > 0) {
            const double distance = time - last_;
            if (distance < least_) {
                least_ = distance;
                before_ = last_;
                after_ = time;
                line_ = line;
            }
            most_ = std::max(most_, distance);
        }
        last_ = time;
    }

    /// Whether two of them differ no more than the same time would that was computed in two ways: by a few units in the
    /// last place, or by less than a hundred-thousandth of the largest distance.
    [[nodiscard]] bool by_rounding() const {
        constexpr double share = 1e-5, few = 8 * std::numeric_limits<double>::epsilon();
        return count_ > 1 && (least_ < share * most_ || least_ <= few * std::max(std::abs(before_), std::abs(after_)));
    }
    /// Whether some frames are more than one and a half times as far apart as others.
    [[nodiscard]] bool are_uneven() const { return count_ > 1 && most_ > 1.5 * least_; }

    /// The line of the frame that is closest to the one before.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    /// "0.6000000000000001 after 0.6": the two that are closest.
    [[nodiscard]] std::string closest() const { return decimal(after_) + " after " + decimal(before_); }
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] double most() const { return most_; }

  private:
    double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
    double before_ = 0, after_ = 0;  ///< the two times that are closest
    std::uint64_t line_ = 0;         ///< of the second of these
    double last_ = 0;
    std::uint64_t count_ = 0;
};

}  // namespace annulus::inline v1
