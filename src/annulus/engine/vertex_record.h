// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/truncated_double.h>
#include <annulus/types.h>

namespace annulus::inline v1 {

/// What a step reads of every vertex to test whether it left its tolerance.
template <int d>
struct Vertex_record {
    Coordinates<d> fixed{};      ///< the fixed position
    Truncated_double threshold;  ///< of the squared displacement |moving - fixed|^2
};

}  // namespace annulus::inline v1
