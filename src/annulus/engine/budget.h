// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <limits>

namespace annulus {

/// What a step may cost and has cost, in cells looked at (cost_model.h). It is handed down to what spends; nothing that
/// is spent has a say in what is right.
struct Budget {
    double limit = std::numeric_limits<double>::infinity();
    double spent = 0.0;

    void charge(double cost) { spent += cost; }
    [[nodiscard]] bool within_limit() const { return spent <= limit; }
    [[nodiscard]] double left() const { return limit - spent; }
};

}  // namespace annulus
