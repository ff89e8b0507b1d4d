// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace annulus::inline v1 {

/// What a step may cost and has cost so far, in cells tested (cost_model.h). It is passed down to the functions that
/// spend it. It decides when to give up; correctness never depends on it.
struct Budget {
    double limit = std::numeric_limits<double>::infinity();
    double spent = 0.0;
    double later_stages = 0.0;  ///< what the filter left open, in the weights of doubt_of() (cost_model.h)

    void charge(double cost) { spent += cost; }
    /// For a sign that the filter left open.
    void charge_later_stage(double cost, double doubt) {
        spent += cost;
        later_stages += doubt;
    }
    [[nodiscard]] bool within_limit() const { return spent <= limit; }
    [[nodiscard]] double left() const { return limit - spent; }
};

}  // namespace annulus::inline v1
