// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/decimal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace annulus::inline v1 {

/// How far the times of successive frames are apart.
class Time_distances {
  public:
    /// Takes the time of the next frame, which is above the one before, and the line where the frame begins.
    void take(double time, std::uint64_t line) {
        if (count_++ > 0) {
            const Step step{last_, time, line};
            least_ = std::min(least_, step.distance());
            most_ = std::max(most_, step.distance());
            if (!by_rounding_ && step.is_few_units()) by_rounding_ = step;
            if (!by_rounding_ && count_ > 3 && step_.distance() < share * std::min(distance_, step.distance()))
                by_rounding_ = step_;
            distance_ = step_.distance();
            step_ = step;
        }
        last_ = time;
    }

    /// Whether two of them differ no more than the same time would that was computed in two ways: by a few units in the
    /// last place, or by less than a hundred-thousandth of the distances before and after. A pause is none of these.
    [[nodiscard]] bool by_rounding() const { return by_rounding_.has_value(); }
    /// Whether some frames are more than one and a half times as far apart as others.
    [[nodiscard]] bool are_uneven() const { return count_ > 1 && most_ > 1.5 * least_; }

    /// The line of the frame that differs from the one before by rounding. Precondition, here and below: by_rounding().
    [[nodiscard]] std::uint64_t line() const { return by_rounding_->line; }
    /// "0.6000000000000001 after 0.6": these two times.
    [[nodiscard]] std::string closest() const {
        return decimal(by_rounding_->after) + " after " + decimal(by_rounding_->before);
    }
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] double most() const { return most_; }

  private:
    static constexpr double share = 1e-5;

    struct Step {
        double before, after;
        std::uint64_t line;

        [[nodiscard]] double distance() const { return after - before; }
        [[nodiscard]] bool is_few_units() const {
            constexpr double few = 8 * std::numeric_limits<double>::epsilon();
            return distance() <= few * std::max(std::abs(before), std::abs(after));
        }
    };

    double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
    std::optional<Step> by_rounding_;  ///< the first
    Step step_{};                      ///< the last one taken
    double distance_ = 0;              ///< of the one before
    double last_ = 0;
    std::uint64_t count_ = 0;
};

}  // namespace annulus::inline v1
