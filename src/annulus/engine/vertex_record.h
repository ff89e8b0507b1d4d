// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/truncated_double.h>

namespace annulus {

/// What a step reads of every vertex to tell whether it moved too far.
template <int d>
struct Vertex_record {
    Coordinates<d> fixed{};      ///< fixed position
    Truncated_double threshold;  ///< squared, compared with |moving - fixed|^2
};

}  // namespace annulus
