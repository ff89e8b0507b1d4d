// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1::bounds {

/// Unit roundoff of double, u = 2^-53: a rounded operation is off by at most u relative to its result.
inline constexpr double u = 0x1p-53;

// Upper bounds of the forward errors of the filter stage in units of u, when every computed difference of coordinates
// is at most 1 in magnitude. For any other magnitude m they hold as the constant times u m^k, where k is the degree of
// the determinant, because the proofs use only the relative error of each operation. (A bound proved for the unit box
// in binary64 as such would hold for powers of two only: an ulp below 1 is half of one above; orientation reaches
// 8 u m^2 at m = 1 + 2^-22.) proofs/check compares the constants with the scripts, and Gappa refuses each one lowered
// by 1 or 2.

// In 2D: proofs/gappa/certificates_2.g proves each line for exactly the order of operations in width_terms.h.

inline constexpr double orientation_2 = 9.0;         ///< orientation_terms: determinant, degree 2
inline constexpr double annulus_2_incircle = 177.0;  ///< annulus_terms: determinant, degree 4
inline constexpr double annulus_2_inner = 69.0;      ///< annulus_terms: each coordinate of N, degree 3
inline constexpr double annulus_2_outer = 123.0;     ///< annulus_terms: each coordinate of M, degree 3

/// |M~| + |N~| falls short of |M| + |N| by at most sqrt(2) (69 + 123) u m^3 < 272 u m^3 for the vectors themselves; the
/// rounding of squares, roots and sum is relative and is in `tail`.
inline constexpr double annulus_2_norms = 273.0;

/// circumcircle_2.h, degree 4: proofs/gappa/circumcircle_2.g.
inline constexpr double circumcircle_2 = 129.0;

// In 3D: proofs/gappa/certificates_3.g, with the order of operations of width_terms_3.h.

inline constexpr double orientation_3 = 47.0;       ///< orientation_terms: determinant, degree 3
inline constexpr double orientation_3_slab = 35.0;  ///< orientation_terms: each coordinate of an area vector, degree 2
inline constexpr double annulus_3_insphere = 1105.0;  ///< annulus_terms: determinant, degree 5
inline constexpr double annulus_3_n = 691.0;          ///< annulus_terms: each coordinate of n1 to n4, degree 4
inline constexpr double annulus_3_m = 1183.0;         ///< annulus_terms: each coordinate of m1 to m4, degree 4
inline constexpr double annulus_3_side = 169.0;       ///< annulus_terms: l1 to l4, degree 3

/// Like annulus_2_norms, with vectors of three coordinates: twice the longest area vector, sqrt(3) (35 + 35) < 122,
/// and the two norms of a partition, sqrt(3) (691 + 1183) < 3246.
inline constexpr double orientation_3_norms = 122.0;
inline constexpr double annulus_3_norms = 3246.0;

/// circumsphere_3.h, degree 5: proofs/gappa/circumsphere_3.g.
inline constexpr double circumsphere_3 = 1123.0;

/// kernel/cached_sphere.h, errors of the two terms of its value: proofs/gappa/cached_sphere_2.g, cached_sphere_3.g.
inline constexpr double cached_sphere_2_square = 37.0;  ///< degree 2 in the cell, 2 in the point
inline constexpr double cached_sphere_2_linear = 81.0;  ///< 3 in the cell, 1 in the point
inline constexpr double cached_sphere_3_square = 241.0;
inline constexpr double cached_sphere_3_linear = 811.0;

/// measure/circumcentre.cpp, of the computed magnitudes of all terms: proofs/gappa/circumcentre_2.g, circumcentre_3.g.
inline constexpr double circumcentre_2_numerator = 8.0;
inline constexpr double circumcentre_2_denominator = 6.0;
inline constexpr double circumcentre_3_numerator = 16.0;
inline constexpr double circumcentre_3_denominator = 10.0;

/// measure/voronoi_facets.h, relative to the length, and to the magnitudes of an area's terms:
/// proofs/gappa/voronoi_facets_2.g, voronoi_facets_3.g.
inline constexpr double facet_length_2 = 4.0;
inline constexpr double facet_area_3 = 11.0;

/// measure/voronoi_terms.h, products that make up Voronoi volumes: proofs/gappa/voronoi_terms_2.g,
/// voronoi_terms_3.g.
inline constexpr double voronoi_2 = 9.0;         ///< degree 1 in the edge, 1 in the dual edge
inline constexpr double voronoi_3_edge = 41.0;   ///< 1 in the edge, 1 in the circumcentre, 1 in the dual edge
inline constexpr double voronoi_3_facet = 47.0;  ///< 1 in each of two edges, 1 in the dual edge

/// Relative error of the tail: two or three squares and their sum (3u), square root (half of that plus u), sum of the
/// roots (u), quotient (u), and the few operations on the bounds themselves (6u). 16u is above the total to first
/// order, with room for the second.
inline constexpr double tail = 16.0;

/// The filter answers only when its error bounds reduce the answer by at most this share; otherwise the next stage
/// answers. This is for tightness, not validity: a less tight lower bound is still a lower bound.
inline constexpr double filter_slack = 0x1p-10;

/// The same for the interval stage: the upper end of the quotient is at most this share above the lower one. Not more,
/// because recomputed tolerances are promised to a fifth of a per cent.
inline constexpr double interval_slack = 0x1p-10;

/// The filter works on unscaled differences whose largest magnitude m is in [1 / filter_range, filter_range]. There
/// nothing overflows, and the absolute bounds above absorb every underflow: docs/theory.md 4.1, proofs/gappa/tail_2.g,
/// tail_3.g. Outside this range the interval stage scales. In 3D the squares of the norms have degree 8.
inline constexpr double filter_range = 0x1p120;
inline constexpr double filter_range_3 = 0x1p100;

}  // namespace annulus::inline v1::bounds
