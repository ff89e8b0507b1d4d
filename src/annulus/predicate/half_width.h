// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/certificate_value.h>
#include <annulus/types.h>

#include <array>
#include <cstdint>
#include <span>

namespace annulus::inline v1 {

/// Two doubles that enclose half a width. For analysis, where it matters equally that a width is small and that it is
/// not. The filter needs only the lower end, and computes it more cheaply (filtered.h).
struct Half_width {
    double lower = 0.0;             ///< lower <= half width; after the exact stage the largest double that is
    double upper = 0.0;             ///< half width <= upper; 0 exactly where the half width is 0
    Stage stage = Stage::interval;  ///< interval or exact

    /// Whether the half width is certainly below y; whether it certainly is not. After the exact stage one of the two
    /// is true for every double.
    [[nodiscard]] bool is_below(double y) const { return upper < y || (stage == Stage::exact && lower < y); }
    [[nodiscard]] bool is_not_below(double y) const { return lower >= y; }
};

/// Which half width of the d + 1 points of an orientation. A negative determinant counts as 0.
enum class Width : std::uint8_t {
    least,  ///< half the width of the simplex
    slab,   ///< the paper's slab of a facet: half the altitude of the last point over the others
    /// The paper's slab of a hull ridge: in 2D the same; in 3D half the distance between the line through the first
    /// two points and the line through the last two, whatever the sign.
    ridge,
};

/// The half widths of a bi-cell.
struct Bicell_half_widths {
    Half_width least;     ///< of its annuli, four in 3D; without its cells
    Half_width standard;  ///< of the paper's annulus, through the facet and through p and q
    /// No other annulus is narrower; after the exact stage: none by more than a unit in the last place.
    bool standard_is_least = false;
};

/// out[i] encloses the half width of x[i] to 2^-10 of itself: by intervals, and exactly where these do not suffice.
/// Preconditions: x.size() == out.size(), rounding to nearest. A fraction of a microsecond each.
void enclose(std::span<const Tuple<2, 3>> x, Width which, std::span<Half_width> out);
void enclose(std::span<const Tuple<3, 4>> x, Width which, std::span<Half_width> out);
void enclose(std::span<const Tuple<2, 4>> x, std::span<Bicell_half_widths> out);
void enclose(std::span<const Tuple<3, 5>> x, std::span<Bicell_half_widths> out);

/// The exact stage: microseconds.
[[nodiscard]] Half_width enclose_exactly(const Tuple<2, 3>& x, Width which);
[[nodiscard]] Half_width enclose_exactly(const Tuple<3, 4>& x, Width which);
[[nodiscard]] Bicell_half_widths enclose_exactly(const Tuple<2, 4>& x);
[[nodiscard]] Bicell_half_widths enclose_exactly(const Tuple<3, 5>& x);

}  // namespace annulus::inline v1
