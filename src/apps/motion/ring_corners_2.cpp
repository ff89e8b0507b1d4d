// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/ring_corners_2.h>

#include <annulus/predicate/exact_sign.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

using Ring = std::vector<Listed_corner>;

void require_finite(std::span<const Coordinates<2>> corners, std::size_t first) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (const double c : corners[i])
            if (!std::isfinite(c))
                throw Corner_error(first + i,
                                   "the coordinates of a polygon must be finite, which they are not at corner " +
                                       std::to_string(first + i) + ", counted from 0");
}

Ring without_repetitions(std::span<const Coordinates<2>> corners, std::size_t first, double scale) {
    const double least = 0x1p-60 * scale;
    const auto repeats = [&](const Coordinates<2>& a, const Coordinates<2>& b) {
        return std::abs(a[0] - b[0]) <= least && std::abs(a[1] - b[1]) <= least;
    };
    Ring ring;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (ring.empty() || !repeats(ring.back().p, corners[i]))
            ring.push_back({{corners[i][0] + 0.0, corners[i][1] + 0.0}, first + i});  // -0 and 0 are one place
    while (ring.size() > 1 && repeats(ring.back().p, ring.front().p)) ring.pop_back();
    return ring;
}

void require_area(const Ring& ring, std::size_t given, std::size_t first, double scale) {
    const std::string need = "a polygon needs 3 corners that are not on a line; ";
    if (ring.size() == 1 && given > 1)
        throw Corner_error(first, need + "all its " + std::to_string(given) + " are at one place");
    if (given > 0 && !(scale >= 1e-100 && scale <= 1e100))
        throw Corner_error(first, "the largest coordinate of a polygon must lie between 1e-100 and 1e100");
    if (ring.size() < 3) throw Corner_error(first, need + "different ones here: " + std::to_string(ring.size()));
    for (const Listed_corner& c : ring)
        if (exact_orientation_sign({&ring[0].p, &ring[1].p, &c.p}).sign != 0) return;
    throw Corner_error(first, need + "all its " + std::to_string(given) + " are on one line");
}

}  // namespace

double largest_coordinate(std::span<const Coordinates<2>> corners) {
    double scale = 0;
    for (const Coordinates<2>& p : corners)
        for (const double c : p) scale = std::max(scale, std::abs(c));
    return scale;
}

std::vector<Listed_corner> ring_corners(std::span<const Coordinates<2>> corners, std::size_t first) {
    require_finite(corners, first);
    const double scale = largest_coordinate(corners);
    Ring ring = without_repetitions(corners, first, scale);
    require_area(ring, corners.size(), first, scale);
    return ring;
}

}  // namespace annulus::inline v1
