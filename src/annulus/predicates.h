// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstdint>
#include <span>

namespace annulus::inline v1 {

/// The exact sign of a determinant of points, and how firmly it holds. Lengths are in the unit of the points.
struct Certified_sign {
    std::int8_t sign;  ///< -1, 0 or 1; 0 where the determinant is exactly 0
    /// A certified lower bound: while every point is less than this from where it is here, the sign stays. 0 if the
    /// sign is 0, otherwise above 0, unless the truth is below the least subnormal double.
    double tolerance;
    /// The ends of an enclosure of the width of the standard annulus (in_circle, in_sphere), or of the narrowest slab
    /// that holds the points (orient_2d, orient_3d): at most a thousandth apart, relatively, and below 2^-1062 at most
    /// two subnormal doubles. Both are 0 if the sign is.
    double width_lower;
    double width_upper;
    /// The angle between the axis of the common facet and the bisector of the two points off it, in radians, 0 to pi/2:
    /// near 0 the centre of the annulus is ill-conditioned. NaN for orientations, which have none.
    double theta;
    Stage stage;  ///< the stage that decided the sign
};

// Points are of the coordinate domain: every coordinate is a number of magnitude at most 2^500. Then
//   (1) sign is 0 if and only if the determinant is exactly 0: nothing is perturbed;
//   (2) swapping two points negates the sign;
//   (3) while every point is less than tolerance from where it is here, the sign stays;
//   (4) if sign is 0, so are tolerance, width_lower and width_upper.
// Errors: not_finite and out_of_domain, with the number of the argument, counted from 0, in vertices(); environment. A
// call takes 0.1 to 1.5 microseconds, and up to some ten where the sign needs integers. Thread-safe.
//
// The forms for many rows of points check the environment once. Their errors name the row; no row has been computed
// then. Precondition: points.size() == out.size().

/// Positive if a, b, c turn left. The tolerance is half the width of the triangle, its least altitude: the largest
/// number that is a tolerance, up to rounding down.
[[nodiscard]] Certified_sign orient_2d(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c);

/// Positive if det(b - a, c - a, d - a) > 0: a, b, c turn left as seen from d. That is CGAL's sign, and the opposite of
/// Shewchuk's. The tolerance is half the width of the tetrahedron, the distance of the nearest two parallel planes that
/// hold it between them: the largest number that is a tolerance, up to rounding down.
[[nodiscard]] Certified_sign orient_3d(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                       const Coordinates<3>& d);

/*
        . . . . .            A bi-cell: two triangles with the common edge a b, and the points p, q off it.
     .             .         Inner circle: through a and b. Outer circle: concentric, through p and q.
   .     . .a. .     .       The ring between them is the standard annulus. While no point moves by half its
  .    .    |    .    .      width, a and b are inside the circle half-way between the two, p and q outside:
  p    .    +    .    q      the sign stays.
  .    .    |    .    .
   .     . .b. .     .
     .             .
        . . . . .
*/
/// Positive if d is strictly inside the circle through a, b, c, and these turn left; negative if it is strictly
/// outside. The signs are the opposite ones if a, b, c turn right. 0 if all four are on one circle or on one line.
///
/// Tolerance, width and theta are those of a bi-cell of the Delaunay triangulation of the four points: two triangles
/// with a common edge. The tolerance is half the width of its standard annulus, or of one of its triangles if that is
/// narrower. If one point is inside the triangle of the others there are three bi-cells, and it is the one with the
/// greatest tolerance; where two are nearly as great, the order of the points decides. If the sign is 0 and the points
/// are four on a circle, there are two, with the same theta; otherwise there is none, and theta is 0.
[[nodiscard]] Certified_sign in_circle(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c,
                                       const Coordinates<2>& d);

/// Positive if e is strictly inside the sphere through a, b, c, d, and orient_3d of these is positive; negative if it
/// is strictly outside. The signs are the opposite ones if orient_3d is negative. 0 if all five are on one sphere or in
/// one plane.
///
/// Tolerance, width and theta are those of a bi-cell of the Delaunay triangulation of the five points: two tetrahedra
/// with a common facet. The tolerance is the least of half the widths of its four annuli and its two tetrahedra. Of
/// several bi-cells it is the one with the greatest tolerance. If the sign is 0, theta is the smallest one of all bi-
/// cells with positive cells; 0 if there is none.
[[nodiscard]] Certified_sign in_sphere(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                       const Coordinates<3>& d, const Coordinates<3>& e);

/// out[i] is what the functions above return for the points of row i.
void orient_2d(std::span<const std::array<Coordinates<2>, 3>> points, std::span<Certified_sign> out);
void orient_3d(std::span<const std::array<Coordinates<3>, 4>> points, std::span<Certified_sign> out);
void in_circle(std::span<const std::array<Coordinates<2>, 4>> points, std::span<Certified_sign> out);
void in_sphere(std::span<const std::array<Coordinates<3>, 5>> points, std::span<Certified_sign> out);

}  // namespace annulus::inline v1
