// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/error.h>
#include <annulus/measure/convex_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace annulus::inline v1 {

/// A cube is cut, and the corners that are left are looked at; again with smaller cubes, for the sake of digits. A
/// corner of half-spaces with normals of length 1 may be far beyond their offsets where they are nearly parallel: 2^20
/// times the largest offset is where they count as unbounded.
template <int d>
Voronoi_clip<d> voronoi_clip(std::span<const Half_space<d>> half_spaces) {
    std::vector<Half_space<d>> unit;
    double largest = 0;
    for (std::size_t h = 0; h < half_spaces.size(); ++h) {
        auto [normal, offset] = half_spaces[h];
        double length = 0;
        for (const double c : normal) length = std::hypot(length, c);
        if (!std::isfinite(length) || !std::isfinite(offset))
            throw Error(Error_code::not_finite, "half-space " + std::to_string(h) + " of the clip is not finite");
        if (!(length > 0))
            throw Error(Error_code::bad_input, "half-space " + std::to_string(h) + " of the clip has no normal");
        for (double& c : normal) c /= length;
        offset /= length;
        largest = std::max(largest, std::fabs(offset));
        unit.push_back({normal, offset});
    }
    const double far = largest > 0 ? 0x1p20 * largest : 1;
    Voronoi_clip<d> out;
    out.lower.fill(-far);
    out.upper.fill(far);
    for (int round = 0; round < 3; ++round) {
        Convex_cell<d> cell(out.lower, out.upper, -1);
        for (const auto& [normal, offset] : unit) cell.cut(normal, offset, 0);
        const auto [lower, upper] = cell.bounds();
        if (cell.is_empty() || !(cell.content().volume > 0))
            throw Error(Error_code::bad_input, "the half-spaces of the clip have no position in common");
        for (std::size_t k = 0; k < d; ++k) {
            if (round == 0 && (lower[k] <= -far || upper[k] >= far))
                throw Error(Error_code::bad_input, "the half-spaces of the clip do not bound it");
            const double margin = (round == 2 ? 0x1p-40 : 0.5) * (upper[k] - lower[k]);
            out.lower[k] = lower[k] - margin;
            out.upper[k] = upper[k] + margin;
        }
    }
    out.half_spaces.assign(half_spaces.begin(), half_spaces.end());
    return out;
}

template Voronoi_clip<2> voronoi_clip<2>(std::span<const Half_space<2>>);
template Voronoi_clip<3> voronoi_clip<3>(std::span<const Half_space<3>>);

}  // namespace annulus::inline v1
