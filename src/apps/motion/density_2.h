// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/image_density.h>
#include <apps/motion/placed_image.h>

#include <functional>
#include <string_view>
#include <variant>

namespace annulus::inline v1 {

/// The densities of the paper's section 4.1, functions of the position in the caller's unit of length.
enum class Density {
    one,         ///< 1
    x2_plus_y2,  ///< x^2 + y^2
    x2,          ///< x^2
    sin2,        ///< sin^2(sqrt(x^2 + y^2)), radians
};

/// All densities, for loops.
inline constexpr Density all_densities[] = {Density::one, Density::x2_plus_y2, Density::x2, Density::sin2};

/// The density's name on a command line: `one`, `x2+y2`, `x2`, `sin2`.
[[nodiscard]] std::string_view name_of(Density density);

/// The density with that name. Throws Error(usage) that lists the choices when there is none.
[[nodiscard]] Density parse_density(std::string_view name);

/// Any density that is smooth.
struct Smooth_density {
    std::function<double(const Coordinates<2>&)>
        at;           ///< at least 0, finite; may be called from several threads at once
    double most = 1;  ///< no less than the density anywhere in the domain
    /// Along a line its k-th derivative is nowhere more than amplitude * rate^k, for k from 3 to 12. `sin2` has 1/2
    /// and 2; a sum of waves that are no shorter than a length l has 2 pi / l; exp(-x^2 / 2) has 1 and 2.4.
    double amplitude = 1, rate = 1;
};

/// A density by which cells are weighted.
using Density_2 = std::variant<Density, Smooth_density, Image_density, Placed_image>;

/// The density at p, at least 0. Error: a few roundings of the value, plus, for sin2, of |p| in the argument.
[[nodiscard]] double density_at(Density density, const Coordinates<2>& p);
[[nodiscard]] double density_at(const Density_2& density, const Coordinates<2>& p);

/// The image of a density that has one, else nullptr.
[[nodiscard]] const Image_density* image_of(const Density_2& density);

/// The extent of a region: all that a bound of a density over it needs.
struct Extent_2 {
    double r_min = 0;      ///< least distance from (0, 0) to the region, or less
    double r_max = 0;      ///< greatest distance from (0, 0), or more
    double abs_x_max = 0;  ///< greatest |x|, or more
};

/// No less than the density anywhere in the region, and attained in it (up to the extent being tight). O(1).
[[nodiscard]] double density_upper_bound(Density density, const Extent_2& extent);
/// The same; attained for a formula only.
[[nodiscard]] double density_upper_bound(const Density_2& density, const Extent_2& extent);

}  // namespace annulus::inline v1
