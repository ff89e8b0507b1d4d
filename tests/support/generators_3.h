// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// 3D bi-cells and tetrahedra that are hard for floating-point geometry, like generators.h in 2D.

#include <support/generators.h>

namespace annulus::testing {

using Point_3 = Coordinates<3>;

/// Sign of the orientation of four points, CGAL's; from rational numbers, sharing nothing with the library.
[[nodiscard]] int exact_orientation(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d);
/// Positive when e is strictly outside the sphere of the positive tetrahedron a, b, c, d; 0 when the five are
/// cospherical.
[[nodiscard]] int exact_empty_sphere(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d,
                                     const Point_3& e);

/// Four points in any position.
struct Tetrahedron {
    Point_3 a, b, c, d;

    [[nodiscard]] Tuple<3, 4> tuple() const { return {&a, &b, &c, &d}; }
};

/// The facet a b c with q on its positive side and p on the other.
struct Bicell_3 {
    Point_3 a, b, c, p, q;

    [[nodiscard]] Tuple<3, 5> tuple() const { return {&a, &b, &c, &p, &q}; }
    [[nodiscard]] Tetrahedron cell_q() const { return {a, b, c, q}; }
    [[nodiscard]] Tetrahedron cell_p() const { return {b, a, c, p}; }
    /// Seen from the other side: the same bi-cell.
    [[nodiscard]] Bicell_3 turned() const { return {b, a, c, q, p}; }
    /// Its facet named from another corner.
    [[nodiscard]] Bicell_3 rotated() const { return {b, c, a, p, q}; }
};

enum class Family_3 {
    uniform,
    grid,                 ///< small integers
    noisy_grid,           ///< small integers, off by a few ulps
    cospherical_rounded,  ///< a sphere, rounded
    cospherical_near,     ///< a sphere, off by 2^-10 to 2^-52 of its radius
    cospherical_exact,    ///< integer points of one norm
    theta_zero,           ///< p q nearly parallel to the facet
    sliver,               ///< within 2^-10 to 2^-50 of a plane
    needle,               ///< one edge shorter than the others by up to 2^-50
    flat_sphere,          ///< slivers of four nearly cocircular points, and a fifth
    tiny,                 ///< magnitude about 2^-400
    subnormal,            ///< all coordinates below 2^-1022
    huge,                 ///< up to 2^500
    far_offset,           ///< integer spacing, 2^40 from the origin
    mixed_scales,         ///< every coordinate of another magnitude, anywhere in the domain
};
inline constexpr std::array all_families_3{Family_3::uniform,
                                           Family_3::grid,
                                           Family_3::noisy_grid,
                                           Family_3::cospherical_rounded,
                                           Family_3::cospherical_near,
                                           Family_3::cospherical_exact,
                                           Family_3::theta_zero,
                                           Family_3::sliver,
                                           Family_3::needle,
                                           Family_3::flat_sphere,
                                           Family_3::tiny,
                                           Family_3::subnormal,
                                           Family_3::huge,
                                           Family_3::far_offset,
                                           Family_3::mixed_scales};
[[nodiscard]] std::string_view name_of(Family_3 family);

/// A bi-cell of the family, both cells positive. About half of them have an empty sphere.
[[nodiscard]] Bicell_3 bicell(Family_3 family, Random& random);
/// The same with an empty sphere, or with cospherical points.
[[nodiscard]] Bicell_3 delaunay_bicell(Family_3 family, Random& random);
/// Four points of the family, of either orientation or degenerate.
[[nodiscard]] Tetrahedron tetrahedron(Family_3 family, Random& random);

[[nodiscard]] std::string as_code(const Point_3& p);
[[nodiscard]] std::string as_code(const Bicell_3& c);
[[nodiscard]] std::string as_code(const Tetrahedron& t);

}  // namespace annulus::testing
