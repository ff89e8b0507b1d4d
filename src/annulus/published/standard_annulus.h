// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>
#include <annulus/predicate/filtered.h>

#include <algorithm>
#include <cmath>
#include <span>

// The paper's numbers of a bi-cell (2.2, 2.3), in plain double as in the paper: nothing is certified.
namespace annulus::inline v1 {

/// Half the width of the standard annulus, ab | pq and abc | pq; 0 where the circle or sphere is not empty.
[[nodiscard]] inline double standard_half_width(const Tuple<2, 4>& x) {
    const auto p = detail::difference(x, 2, 0), q = detail::difference(x, 3, 0);
    const auto t = annulus_terms(detail::difference(x, 1, 0), p, q, detail::difference(x, 3, 2));
    return std::max(0.0, t.determinant / (std::sqrt(t.inner) + std::sqrt(t.outer)));
}
[[nodiscard]] inline double standard_half_width(const Tuple<3, 5>& x) { return paper_annulus(x); }

/// The tolerance that the certificate of a facet gives its points: half the width of its standard annulus or slab.
template <int d>
[[nodiscard]] double paper_half_width(const Facet_certificate<d>& f, std::span<const Coordinates<d>> x) {
    if (f.kind == Facet_kind::empty_sphere) return standard_half_width(tuple<d, d + 2>(f.point, x));
    const auto y = tuple<d, d + 1>(f.point, x);
    return std::max(0.0, f.kind == Facet_kind::ridge ? paper_ridge(y) : paper_slab(y));
}

}  // namespace annulus::inline v1
