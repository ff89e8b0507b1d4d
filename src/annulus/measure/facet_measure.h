// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/measure/voronoi_facet_exact.h>
#include <annulus/predicate/bounds.h>

#include <cmath>
#include <cstddef>

// A facet between the Voronoi cells of i and j is the polygon of the circumcentres C_0, C_1 .. around the edge i j, in
// 2D the segment from C_0 to C_1. With e = x_j - x_i and P_k = C_k - C_0 its area is the sum of
//
//     a_k = e . (P_k x P_k+1) / (2 |e|),
//
// and its centroid is C_0 plus the mean of (P_k + P_k+1) / 3 with these weights.
//
// Errors, u = 2^-53; |v| is the sum of the magnitudes of the coordinates of a vector, an upper bound of its length. C_k
// relative to x_i is off by h_k: a circumcentre's own bound, and u of the difference and the sum on the way. P_k is
// then off by h_k + h_0 and by a rounding, u |P_k|, which g_k is to cover, too. So
//
//     2 a_k   is off by   |P_k| g_k+1 + |P_k+1| g_k + g_k g_k+1 + 16 u |P_k| |P_k+1|:
//
// a coordinate of the product of two vectors is two products and a difference, 2 u of its terms, the sum of three
// times e another 4 u of terms that add up to less than |e|_2 |P_k| |P_k+1|, the direction e / |e| 4 u: facet_area_3 u
// at most (proofs/gappa/voronoi_facets_3.g), of the 16. The rest is for the rounding of the bound.
// Edges are below 2, in the unit of circumcentre(), so an underflow is an error of 2^-1070 (1 + |P_k|) (1 + |P_k+1|) /
// |e| at most; `lost` covers it, because edges with a coordinate below 2^-400 are left to integers.
//
// A sum of positive terms is as good as the terms; where the bound is above an eighth of the promise, integers
// compute the facet. In 2D the length |C_1 - C_0| is off by g_1 and facet_length_2 u of itself (voronoi_facets_2.g);
// another 4 u are for the rounding of the bound.

namespace annulus::inline v1 {

template <int d>
[[nodiscard]] double sum_of_magnitudes(const Coordinates<d>& x) {
    double sum = std::fabs(x[0]);
    for (std::size_t k = 1; k < d; ++k) sum += std::fabs(x[k]);
    return sum;
}

/// A circumcentre relative to vertex i of a facet, with its error, as that of a circumcentre.
template <int d>
struct Seen_centre {
    Coordinates<d> offset;
    double error;
};

/// The circumcentre of a cell whose first corner is at `base`, relative to vertex i, each coordinate with a relative
/// error of u at most.
template <int d>
[[nodiscard]] Seen_centre<d> seen_centre(const Coordinates<d>& base, const Circumcentre<d>& centre) {
    Seen_centre<d> out{base, 0};
    for (std::size_t k = 0; k < d; ++k) out.offset[k] += centre.offset[k];
    out.error = centre.error + bounds::u * (sum_of_magnitudes<d>(base) + sum_of_magnitudes<d>(out.offset));
    return out;
}

/// Measures a facet that is bounded and not empty, in doubles and in the unit of circumcentres: the edge is e = x_j -
/// x_i, and seen(k) the k-th of the n circumcentres around it, a Seen_centre, counter-clockwise seen from j. False
/// where doubles are not accurate enough. It does not set the exponent. O(n).
template <int d, class Seen>
[[nodiscard]] bool measure_facet(const Coordinates<d>& e, std::size_t n, Seen seen, Facet_measure<d>& facet) {
    constexpr double u = bounds::u;
    constexpr double good = 0x1p-35;
    constexpr double lost = 0x1p-500;
    const Seen_centre<d> first = seen(0);
    if constexpr (d == 2) {
        const Seen_centre<d> last = seen(1);
        const double x = last.offset[0] - first.offset[0];
        const double y = last.offset[1] - first.offset[1];
        const double length = std::sqrt(x * x + y * y);
        facet.measure = length;
        for (std::size_t k = 0; k < 2; ++k) facet.centroid[k] = 0.5 * (first.offset[k] + last.offset[k]);
        const double error = first.error + last.error + (bounds::facet_length_2 + 4) * u * length + lost;
        return error < good * length;
    } else {
        const double length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
        if (!(length > 0x1p-400)) return false;
        Coordinates<d> p{};
        double size = 0;
        double g = 0;
        double sum = 0;
        double error = 0;
        Coordinates<d> moment{};
        for (std::size_t k = 1; k < n; ++k) {
            const Seen_centre<d> next = seen(k);
            const Coordinates<d> r = {next.offset[0] - first.offset[0], next.offset[1] - first.offset[1],
                                      next.offset[2] - first.offset[2]};
            const double size_r = sum_of_magnitudes<d>(r);
            const double g_r = next.error + first.error + u * size_r;
            if (k > 1) {
                const double twice = e[0] * (p[1] * r[2] - p[2] * r[1]) + e[1] * (p[2] * r[0] - p[0] * r[2]) +
                                     e[2] * (p[0] * r[1] - p[1] * r[0]);
                sum += twice;
                for (std::size_t a = 0; a < d; ++a) moment[a] += twice * (p[a] + r[a]);
                error += size * g_r + size_r * g + g * g_r + (bounds::facet_area_3 + 5) * u * size * size_r +
                         lost * (1 + size) * (1 + size_r);
            }
            p = r;
            size = size_r;
            g = g_r;
        }
        const double twice_area = sum / length;
        facet.measure = 0.5 * twice_area;
        for (std::size_t a = 0; a < d; ++a) facet.centroid[a] = first.offset[a] + moment[a] / (3 * sum);
        return error < good * twice_area;
    }
}

}  // namespace annulus::inline v1
