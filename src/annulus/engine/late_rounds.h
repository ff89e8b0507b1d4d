// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/rebuild_policy.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

/// Decides, after each round of a repair by flips (Flip_repair) of a time step, whether the vertices that are still
/// held back go on, or are removed and inserted again at their targets: the cost of a reinsertion is known, that of the
/// rounds to come is not. So a repair that has cost half a rebuild rarely fails, and then costs one more. Costs are
/// counted (cost_model.h).
template <int d>
class Late_rounds {
  public:
    /// Where a rebuild costs so much, or where repair may cost more, so much; `spent` is the cost of the time step so
    /// far.
    Late_rounds(double rebuild, double spent) : rebuild_(rebuild), spent_(spent) {}

    /// A round is over, after which the step has cost `spent`, and the reinsertion of all that are not at their targets
    /// would cost `reinsertion`: 0 when all are.
    void note(double spent, double reinsertion) {
        cost_ = spent - spent_;
        idle_ = begun_ && reinsertion >= reinsertion_ ? idle_ + 1 : 0;
        // A round pays if it costs less than the reinsertion of those that it brings to their targets.
        if (std::exchange(begun_, true)) debt_ = std::max(0.0, debt_ + cost_ - (reinsertion_ - reinsertion));
        spent_ = spent;
        reinsertion_ = reinsertion;
    }
    /// Whether those that are not at their targets after it are to be reinserted. `last`: another round would help
    /// nothing.
    [[nodiscard]] bool reinserts(bool last) const {
        if (reinsertion_ == 0.0) return false;
        // Another round may cost as much as this one. In an expensive step that is not tried.
        if (spent_ > 0.5 * rebuild_ && reinsertion_ <= std::min(1.6 * cost_, 0.9 * rebuild_)) return true;
        return !is_too_expensive() && (last || (idle_ >= 2 && !pays()) || reinsertion_ <= 2.0 * debt_);
    }
    /// Whether everything is to be rebuilt instead: rounds do not pay, and reinsertion would cost as much.
    [[nodiscard]] bool gives_up() const { return is_too_expensive() && !pays(); }

  private:
    [[nodiscard]] bool pays() const { return debt_ <= 0.03 * rebuild_; }
    [[nodiscard]] bool is_too_expensive() const { return reinsertion_ > 0.6 * rebuild_; }

    double rebuild_;
    double spent_;
    double cost_ = 0.0;  // of the last round
    bool begun_ = false;
    int idle_ = 0;              // the last rounds that brought no vertex to its target
    double reinsertion_ = 0.0;  // after it
    double debt_ = 0.0;         // what rounds have cost that did not pay
};

}  // namespace annulus::inline v1
