// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace annulus::inline v1 {

/// Whether p, the new position of vertex v of the bi-cell, is on the side of the standard delimiter where v must stay
/// (paper 2.3): inside for a vertex of the facet, outside for an opposite one; for a slab on its side of the middle
/// line. The delimiter is that of the positions x. Plain double.
[[nodiscard]] inline bool keeps_its_side(const Facet_certificate<2>& f, std::span<const Coordinates<2>> x, Index v,
                                         const Coordinates<2>& p) {
    const auto place = [&](std::size_t k) -> const Coordinates<2>& {
        return x[static_cast<std::size_t>(f.point[k].vertex)];
    };
    const auto slot = static_cast<std::size_t>(std::find(f.point.begin(), f.point.end(), Site<2>(v)) - f.point.begin());
    const Coordinates<2>& a = place(0);
    const auto [bx, by] = Euclidean<2>::difference(place(1), a);
    const auto [px, py] = Euclidean<2>::difference(place(2), a);
    const auto [ax, ay] = Euclidean<2>::difference(p, a);
    if (f.kind != Facet_kind::empty_sphere) {
        const double altitude = bx * py - by * px;  // times |b - a|
        const double mine = bx * ay - by * ax;
        return slot == 2 ? mine > 0.5 * altitude : mine < 0.5 * altitude;
    }
    const auto [qx, qy] = Euclidean<2>::difference(place(3), a);
    // The centre, from a: b . c = |b|^2 / 2 and (q - p) . c = (|q|^2 - |p|^2) / 2.
    const double ex = qx - px, ey = qy - py, k0 = 0.5 * (bx * bx + by * by),
                 k1 = 0.5 * ((qx * qx + qy * qy) - (px * px + py * py)), det = bx * ey - by * ex;
    const double cx = (k0 * ey - k1 * by) / det, cy = (bx * k1 - ex * k0) / det;
    const double radius = 0.5 * (std::hypot(cx, cy) + std::hypot(px - cx, py - cy)), way = std::hypot(ax - cx, ay - cy);
    return slot < 2 ? way < radius : way > radius;  // false where there is no centre
}

}  // namespace annulus::inline v1
