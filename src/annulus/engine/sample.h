// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <span>

namespace annulus {

/// What the filter stage says of some cells and their facets at positions to which the triangulation may not belong.
struct Sample {
    std::size_t cells = 0;     ///< looked at
    std::size_t inverted = 0;  ///< of these
    std::size_t facets = 0;
    std::size_t violated = 0;
    std::size_t unclear = 0;  ///< cells and facets of which it cannot tell
};

/// Adds a cell: its vertices in positive order, and the vertex beyond each of its facets. Facets of an inverted cell say nothing.
template <int d>
void add_cell(Sample& sample, std::span<const Coordinates<d>> x, const Cell_points<d>& v, const Cell_points<d>& beyond) {
    ++sample.cells;
    Verdict verdict;
    if (!orientation_filter(tuple<d, d + 1>(v, x), false, verdict)) {
        ++sample.unclear;
        return;
    }
    if (verdict.sign <= 0) {
        ++sample.inverted;
        return;
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (beyond[i] == infinite) continue;
        ++sample.facets;
        Facet_points<d> points{};
        if constexpr (d == 2) {
            points = {v[(i + 1) % 3], v[(i + 2) % 3], beyond[i], v[i]};
        } else {
            for (std::size_t k = 0; k < 3; ++k) points[k] = v[static_cast<std::size_t>(facing_corners[i][k])];
            points[3] = beyond[i];
            points[4] = v[i];
        }
        if (!empty_sphere_filter(tuple<d, d + 2>(points, x), false, verdict)) ++sample.unclear;
        else if (verdict.sign < 0) ++sample.violated;
    }
}

}  // namespace annulus
