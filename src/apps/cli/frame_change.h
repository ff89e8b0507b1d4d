// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/frame_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1::cli {

/// The points that are present: their ids, ascending, and the index of each in the triangulation.
struct Present {
    std::vector<std::uint64_t> id;
    std::vector<Index> index;
};

/// The change from the points that are present to the next frame.
template <int d>
struct Frame_change {
    std::vector<Index> leave;
    std::vector<Coordinates<d>> x, arrive;
    std::vector<Index> index;  ///< of the points of the frame; `none` for those that arrive
    double sum = 0, max = 0;   ///< sum and maximum of the displacements of the points that stay
    std::size_t moved = 0;

    Frame_change(const Present& present, std::span<const Coordinates<d>> now, const Frame_points<d>& frame)
        : x(now.begin(), now.end()) {
        std::size_t p = 0;
        for (std::size_t f = 0; f < frame.id.size(); ++f) {
            while (p < present.id.size() && present.id[p] < frame.id[f]) leave.push_back(present.index[p++]);
            if (p == present.id.size() || present.id[p] != frame.id[f]) {
                arrive.push_back(frame.x[f]);
                index.push_back(none);
                continue;
            }
            index.push_back(present.index[p++]);
            Coordinates<d>& at = x[static_cast<std::size_t>(index.back())];
            double way = 0;
            for (std::size_t k = 0; k < d; ++k) way = std::hypot(way, frame.x[f][k] - at[k]);
            sum += way;
            max = std::max(max, way);
            ++moved;
            at = frame.x[f];
        }
        leave.insert(leave.end(), present.index.begin() + static_cast<std::ptrdiff_t>(p), present.index.end());
    }

    [[nodiscard]] double mean() const { return moved > 0 ? sum / static_cast<double>(moved) : 0; }
};

/// The unit of length: the d-th root of the volume of the bounding box per point; for flat sets, in fewer dimensions.
template <int d>
[[nodiscard]] double spacing_of(std::span<const Coordinates<d>> points) {
    if (points.empty()) return 1;
    double logarithms = 0;  // the product of the sides could overflow
    int dimension = 0;
    for (std::size_t k = 0; k < d; ++k) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                     [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        const double side = (*high)[k] - (*low)[k];
        if (!(side > 0)) continue;
        logarithms += std::log(side);
        ++dimension;
    }
    if (dimension == 0) return 1;
    return std::exp((logarithms - std::log(static_cast<double>(points.size()))) / dimension);
}

}  // namespace annulus::inline v1::cli
