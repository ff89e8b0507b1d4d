// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>
#include <annulus/predicate/filtered.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

// The paper's numbers of a bi-cell, in plain double as in the paper: nothing is certified.
namespace annulus {

/// Half the width of the standard annulus, ab | pq and abc | pq; 0 where the circle or sphere is not empty.
[[nodiscard]] inline double standard_half_width(const Tuple<2, 4>& x) {
    const auto p = detail::difference(x, 2, 0), q = detail::difference(x, 3, 0);
    const auto t = annulus_terms(detail::difference(x, 1, 0), p, q, detail::difference(x, 3, 2));
    return std::max(0.0, t.determinant / (std::sqrt(t.inner) + std::sqrt(t.outer)));
}
[[nodiscard]] inline double standard_half_width(const Tuple<3, 5>& x) { return paper_annulus(x); }

/// The points of a facet's annulus or slab in an order that depends neither on the side from which the facet is seen
/// nor on the order of corners.
inline void put_in_order(Facet_certificate<2>& f) {
    auto& x = f.point;
    if (f.kind == Facet_kind::empty_sphere && x[3] < x[2]) {
        std::swap(x[2], x[3]);
        std::swap(x[0], x[1]);
    }
}
inline void put_in_order(Facet_certificate<3>& f) {
    auto& x = f.point;
    if (f.kind == Facet_kind::ridge) {
        if (x[1] < x[0]) std::swap(x[0], x[1]);
        if (x[3] < x[2]) std::swap(x[2], x[3]);
        return;
    }
    if (f.kind == Facet_kind::empty_sphere && x[4] < x[3]) {
        std::swap(x[3], x[4]);
        std::swap(x[1], x[2]);
    }
    std::rotate(x.begin(), std::min_element(x.begin(), x.begin() + 3), x.begin() + 3);
}

/// The tolerance of a facet's points by its certificate (paper 2.2): half the width of its annulus, or of its slab.
template <int d>
[[nodiscard]] double paper_half_width(const Facet_certificate<d>& f, std::span<const Coordinates<d>> x) {
    if (f.kind == Facet_kind::empty_sphere) return standard_half_width(tuple<d, d + 2>(f.point, x));
    const auto y = tuple<d, d + 1>(f.point, x);
    return std::max(0.0, f.kind == Facet_kind::ridge ? paper_ridge(y) : paper_slab(y));
}

}  // namespace annulus
