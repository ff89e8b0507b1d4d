// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/verdict.h>

#include <cmath>

namespace annulus {

/// A circle between the facet a b and the opposite vertices p, q of a bi-cell: a delimiter (paper 2.3).
///
/// Any two doubles and a radius are a delimiter, as exact numbers: rounding in their computation costs tightness only.
/// While a, b are strictly inside and p, q strictly outside and both cells are positive, the bi-cell is locally
/// Delaunay (docs/theory.md, pointwise lemma), wherever the points were when the circle was chosen.
struct Delimiter_2 {
    Coordinates<2> centre{};
    double radius = 0.0;  ///< 0: none
};

/// The standard delimiter of x = {a, b, p, q}: the median circle of the standard annulus, in plain double.
[[nodiscard]] inline Delimiter_2 standard_delimiter(const Tuple<2, 4>& x) {
    const auto rel = [&](std::size_t i, std::size_t k) { return (*x[i])[k] - (*x[0])[k]; };
    const double bx = rel(1, 0), by = rel(1, 1), px = rel(2, 0), py = rel(2, 1), qx = rel(3, 0), qy = rel(3, 1);
    const double D = (bx * qy - by * qx) + (by * px - bx * py);
    const double s = (qx - px) * ((qx + px) - bx) + (qy - py) * ((qy + py) - by);
    const double cx = 0.5 * (bx - s / D * by);
    const double cy = 0.5 * (by + s / D * bx);
    const double inner = std::hypot(cx, cy);
    const double outer = std::hypot(px - cx, py - cy);
    const Delimiter_2 out{{(*x[0])[0] + cx, (*x[0])[1] + cy}, 0.5 * (inner + outer)};
    return std::isfinite(out.radius) && std::isfinite(out.centre[0]) && std::isfinite(out.centre[1]) ? out
                                                                                                     : Delimiter_2{};
}

/// How far each point of x may move, whatever the others do, with the circle still a delimiter: lower bounds in `room`.
/// False when some point is not certainly on its side. Round to nearest; errors of the squared distances are relative,
/// 6u, and radii that squares could not carry are refused.
[[nodiscard]] inline bool safe_region_lower(const Delimiter_2& c, const Tuple<2, 4>& x, std::array<double, 4>& room) {
    if (!(c.radius > 0x1p-400 && c.radius < 0x1p500)) return false;
    for (std::size_t k = 0; k < 4; ++k) {
        const double dx = (*x[k])[0] - c.centre[0];
        const double dy = (*x[k])[1] - c.centre[1];
        const double distance = std::sqrt(dx * dx + dy * dy);
        const double error = (distance + c.radius) * 0x1p-48;
        room[k] = (k < 2 ? c.radius - distance : distance - c.radius) - error;
        if (!(room[k] > 0.0)) return false;
    }
    return true;
}

}  // namespace annulus
