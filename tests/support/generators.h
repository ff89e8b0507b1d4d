// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Point sets, bi-cells and triangles that are hard for floating-point geometry. All is a function of the state of a
// std::mt19937_64 (no standard distribution is used), so a seed gives the same case on every platform. The RapidCheck
// part is in arbitrary.h; this header needs only the standard library.

#include <annulus/predicate/certificate_value.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::testing {

using Random = std::mt19937_64;
using Point = Coordinates<2>;
using Points = std::vector<Point>;

// ---- Numbers ----------------------------------------------------------------------------------------------------

/// Uniform in [0, 1), a multiple of 2^-53.
[[nodiscard]] double unit(Random& random);
/// Uniform in [low, high).
[[nodiscard]] double between(Random& random, double low, double high);
/// Uniform in {low, ..., high}.
[[nodiscard]] int integer(Random& random, int low, int high);
/// x moved by -ulps..ulps units in the last place.
[[nodiscard]] double ulp_noise(Random& random, double x, int ulps);
/// Any finite double of magnitude at most 2^500: every exponent alike, subnormals, zeros of both signs, few-bit values.
[[nodiscard]] double any_in_domain(Random& random);

// ---- Exact signs, from rational numbers, sharing nothing with the library ---------------------------------------

/// Sign of the orientation of a, b, c: positive when they turn left.
[[nodiscard]] int exact_orientation(const Point& a, const Point& b, const Point& c);
/// Positive when p is strictly outside the circle of the positive triangle a, b, q; 0 when the four are cocircular.
[[nodiscard]] int exact_empty_circle(const Point& a, const Point& b, const Point& q, const Point& p);

// ---- Point sets -------------------------------------------------------------------------------------------------

enum class Family {
    uniform,             ///< the square [-1, 1]^2
    grid,                ///< integer grid
    noisy_grid,          ///< integer grid, each coordinate off by a few ulps
    cocircular_rounded,  ///< a circle, rounded to doubles
    cocircular_exact,    ///< exactly on one or more concentric circles (Pythagorean points)
    cocircular_near,     ///< a circle, off by 2^-10 to 2^-40 of its radius
    collinear,           ///< exactly on one line
    nearly_collinear,    ///< a line, rounded or off by a few ulps
    clustered,           ///< clusters of clusters, down to 2^-30 of the whole
    tiny,                ///< magnitude about 2^-400
    subnormal,           ///< every coordinate a multiple of 2^-1074 below 2^-1022
    huge,                ///< magnitude 2^400 to 2^500
    far_offset,          ///< integer spacing, far (2^40) from the origin
    mixture,             ///< parts of two or three of the above
};
inline constexpr std::array all_families{Family::uniform,          Family::grid,
                                         Family::noisy_grid,       Family::cocircular_rounded,
                                         Family::cocircular_exact, Family::cocircular_near,
                                         Family::collinear,        Family::nearly_collinear,
                                         Family::clustered,        Family::tiny,
                                         Family::subnormal,        Family::huge,
                                         Family::far_offset,       Family::mixture};
[[nodiscard]] std::string_view name_of(Family family);

/// Points of the family, in the coordinate domain and in random order: n distinct ones, or, with `duplicates`, n of
/// which about a fifth repeat an earlier one (never the first three).
[[nodiscard]] Points point_set(Family family, std::size_t n, Random& random, bool duplicates = false);

// ---- Bi-cells ---------------------------------------------------------------------------------------------------

/// The edge a b with p strictly right of it and q strictly left.
struct Bicell {
    Point a, b, p, q;

    /// {a, b, p, q} as the filtered predicate takes it; valid while this object is.
    [[nodiscard]] Tuple<2, 4> tuple() const { return {&a, &b, &p, &q}; }
    /// Seen from the other side: the same bi-cell.
    [[nodiscard]] Bicell turned() const { return {b, a, q, p}; }
    /// The other diagonal, also a bi-cell when the four points are in convex position.
    [[nodiscard]] Bicell flipped() const { return {p, q, b, a}; }
};

enum class Bicell_family {
    uniform,
    grid,                ///< small integers
    noisy_grid,          ///< a grid square or the like, off by a few ulps
    cocircular_rounded,  ///< a circle, rounded: the determinant is rounding noise
    cocircular_near,     ///< a circle, off by 2^-10 to 2^-52 of its radius
    cocircular_exact,    ///< Pythagorean points: the determinant is 0
    theta_zero,          ///< p q nearly parallel to a b
    sliver,              ///< all four within 2^-10 to 2^-50 of a line
    needle,              ///< one edge shorter than the others by up to 2^-50
    non_convex,          ///< a or b is reflex
    nearly_collinear,    ///< three or four points on a line up to ulps
    tiny,                ///< magnitude about 2^-400
    subnormal,           ///< all coordinates below 2^-1022
    huge,                ///< up to 2^500
    far_offset,          ///< integer spacing, 2^40 from the origin
    mixed_scales,        ///< every coordinate of another magnitude, anywhere in the domain
};
inline constexpr std::array all_bicell_families{Bicell_family::uniform,          Bicell_family::grid,
                                                Bicell_family::noisy_grid,       Bicell_family::cocircular_rounded,
                                                Bicell_family::cocircular_near,  Bicell_family::cocircular_exact,
                                                Bicell_family::theta_zero,       Bicell_family::sliver,
                                                Bicell_family::needle,           Bicell_family::non_convex,
                                                Bicell_family::nearly_collinear, Bicell_family::tiny,
                                                Bicell_family::subnormal,        Bicell_family::huge,
                                                Bicell_family::far_offset,       Bicell_family::mixed_scales};
[[nodiscard]] std::string_view name_of(Bicell_family family);

/// A bi-cell of the family, both triangles positive. About half of them have an empty circle (all in non_convex, none
/// in cocircular_exact).
[[nodiscard]] Bicell bicell(Bicell_family family, Random& random);
/// The same, flipped where needed: exact_empty_circle is never negative.
[[nodiscard]] Bicell delaunay_bicell(Bicell_family family, Random& random);
/// Both triangles positive (exactly).
[[nodiscard]] bool is_bicell(const Bicell& c);

// ---- Triangles --------------------------------------------------------------------------------------------------

struct Triangle {
    Point a, b, c;

    [[nodiscard]] Tuple<2, 3> tuple() const { return {&a, &b, &c}; }
    [[nodiscard]] Triangle rotated() const { return {b, c, a}; }
    [[nodiscard]] Triangle reversed() const { return {b, a, c}; }
};

enum class Triangle_family {
    uniform,
    grid,              ///< small integers, often collinear
    noisy_grid,        ///< small integers off by ulps
    collinear,         ///< exactly collinear, sometimes with equal points
    nearly_collinear,  ///< a line up to ulps
    sliver,            ///< an altitude of 2^-10 to 2^-52 of the longest side
    needle,            ///< a side of 2^-10 to 2^-50 of the others
    tiny,
    subnormal,
    huge,
    far_offset,
    mixed_scales,
};
inline constexpr std::array all_triangle_families{Triangle_family::uniform,          Triangle_family::grid,
                                                  Triangle_family::noisy_grid,       Triangle_family::collinear,
                                                  Triangle_family::nearly_collinear, Triangle_family::sliver,
                                                  Triangle_family::needle,           Triangle_family::tiny,
                                                  Triangle_family::subnormal,        Triangle_family::huge,
                                                  Triangle_family::far_offset,       Triangle_family::mixed_scales};
[[nodiscard]] std::string_view name_of(Triangle_family family);

/// A triangle of the family, of either orientation or degenerate.
[[nodiscard]] Triangle triangle(Triangle_family family, Random& random);

// ---- Cases as code ----------------------------------------------------------------------------------------------

/// A double as a hexadecimal literal, bit for bit.
[[nodiscard]] std::string as_code(double x);
/// "{0x1p+0, -0x1.8p-3}"
[[nodiscard]] std::string as_code(const Point& p);
/// A definition `const std::vector<annulus::Coordinates<2>> points{...};` ready to paste.
[[nodiscard]] std::string as_code(const Points& points);
/// A definition `const annulus::testing::Bicell x{...};` ready to paste.
[[nodiscard]] std::string as_code(const Bicell& c);
[[nodiscard]] std::string as_code(const Triangle& t);

}  // namespace annulus::testing
