// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1 {

/// The least cost of repairing what does not hold (cost_model.h), before any of it is repaired.
struct Repair_estimate {
    double inverted = 0.0;  ///< of cells that are turned over
    double violated = 0.0;  ///< of facets whose empty sphere is not empty
};

}  // namespace annulus::inline v1
