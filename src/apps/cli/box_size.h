// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <string>

namespace annulus::inline v1::cli {

/// An axis-aligned box that is not periodic.
template <int d>
struct Sized_box {
    Coordinates<d> lower{}, upper{};

    [[nodiscard]] double volume() const {
        double product = 1;
        for (std::size_t k = 0; k < d; ++k) product *= upper[k] - lower[k];
        return product;
    }
};

/// 2 or 3: the dimension of the box of --size: 2 or 3 lengths, or 4 or 6 coordinates of its lower and its upper corner,
/// separated by commas. Throws Error(usage).
[[nodiscard]] int dimension_of_size(const std::string& words);
/// The box; that of lengths begins at the origin. Throws Error(usage) also where a length is not from 1e-100 to 1e100.
/// Precondition: that is its dimension.
template <int d>
[[nodiscard]] Sized_box<d> box_of_size(const std::string& words);

extern template Sized_box<2> box_of_size<2>(const std::string&);
extern template Sized_box<3> box_of_size<3>(const std::string&);

}  // namespace annulus::inline v1::cli
