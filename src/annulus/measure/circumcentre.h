// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The centre of a cell's circumscribed circle or sphere, relative to the first vertex of the cell.
template <int d>
struct Circumcentre {
    Coordinates<d> offset{};
    /// An upper bound of the sum of |offset - truth| over the coordinates; at least 2^-52 times the sum of |offset|.
    double error = 0;
};

/// Corners of a cell, positively oriented.
template <int d>
using Corners = std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>;

/// The circumcentre of a cell in the unit 1/scale, in which no coordinate of the cell may be above 1; scale is a
/// power of two.
///
/// In doubles with a bound of their error, while that is below 2^-40 times the shortest edge of the cell; else
/// exactly, rounded, with an error of 2^-51 times the circumradius at most. O(1): some 30 ns in doubles, some
/// microseconds exactly. Preconditions: rounding to nearest, corners in the coordinate domain. Throws
/// Error(bad_input) for a cell that is not positive.
template <int d>
[[nodiscard]] Circumcentre<d> circumcentre(const Corners<d>& x, double scale);

/// The same for the cell of these vertices, which the error names.
template <int d>
[[nodiscard]] Circumcentre<d> circumcentre_of(std::span<const Index> vertices, const Corners<d>& x, double scale) {
    try {
        return circumcentre<d>(x, scale);
    } catch (const Error& e) {
        std::vector<std::int64_t> names(vertices.begin(), vertices.end());
        std::sort(names.begin(), names.end());
        throw Error(e.code(), e.what(), std::move(names));
    }
}

extern template Circumcentre<2> circumcentre(const Corners<2>&, double);
extern template Circumcentre<3> circumcentre(const Corners<3>&, double);

/// The circumcentre is numerator / (2 * denominator), relative to the corner from which the others are given. The same
/// formula serves doubles and integers; numerator and denominator both change sign with the orientation.
template <class T>
struct Circumcentre_2 {
    std::array<T, 2> numerator;
    T denominator;

    Circumcentre_2(const std::array<T, 2>& b, const std::array<T, 2>& c) {
        const T bb = b[0] * b[0] + b[1] * b[1];
        const T cc = c[0] * c[0] + c[1] * c[1];
        numerator = {T(bb * c[1] - cc * b[1]), T(cc * b[0] - bb * c[0])};
        denominator = b[0] * c[1] - b[1] * c[0];
    }
};

template <class T>
struct Circumcentre_3 {
    std::array<T, 3> numerator;
    T denominator;

    Circumcentre_3(const std::array<T, 3>& b, const std::array<T, 3>& c, const std::array<T, 3>& e) {
        const T bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
        const T cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
        const T ee = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        std::array<T, 3> normal;  // of the plane of c and e
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3;
            const std::size_t j = (k + 2) % 3;
            normal[k] = c[i] * e[j] - c[j] * e[i];
            numerator[k] = bb * normal[k] + cc * T(e[i] * b[j] - e[j] * b[i]) + ee * T(b[i] * c[j] - b[j] * c[i]);
        }
        denominator = b[0] * normal[0] + b[1] * normal[1] + b[2] * normal[2];
    }
};

}  // namespace annulus::inline v1
