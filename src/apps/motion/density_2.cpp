// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/density_2.h>

#include <annulus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace annulus::inline v1 {

std::string_view name_of(Density density) {
    switch (density) {
        case Density::one: return "one";
        case Density::x2_plus_y2: return "x2+y2";
        case Density::x2: return "x2";
        case Density::sin2: return "sin2";
    }
    return "";
}

Density parse_density(std::string_view name) {
    for (const Density density : all_densities)
        if (name == name_of(density)) return density;
    throw Error(Error_code::usage, "unknown density '" + std::string(name) + "': expected one, x2+y2, x2 or sin2");
}

double density_at(Density density, const Coordinates<2>& p) {
    switch (density) {
        case Density::one: return 1;
        case Density::x2_plus_y2: return p[0] * p[0] + p[1] * p[1];
        case Density::x2: return p[0] * p[0];
        case Density::sin2: {
            const double s = std::sin(std::sqrt(p[0] * p[0] + p[1] * p[1]));
            return s * s;
        }
    }
    return 0;
}

double density_at(const Density_2& density, const Coordinates<2>& p) {
    if (const auto* formula = std::get_if<Density>(&density)) return density_at(*formula, p);
    if (const auto* smooth = std::get_if<Smooth_density>(&density)) return smooth->at(p);
    if (const auto* placed = std::get_if<Placed_image>(&density)) return placed->image.at(placed->in_image(p));
    return std::get<Image_density>(density).at(p);
}

const Image_density* image_of(const Density_2& density) {
    if (const auto* placed = std::get_if<Placed_image>(&density)) return &placed->image;
    return std::get_if<Image_density>(&density);
}

double density_upper_bound(const Density_2& density, const Extent_2& extent) {
    if (const auto* formula = std::get_if<Density>(&density)) return density_upper_bound(*formula, extent);
    if (const auto* smooth = std::get_if<Smooth_density>(&density)) return smooth->most;
    return image_of(density)->most();
}

double density_upper_bound(Density density, const Extent_2& extent) {
    // The factor covers the roundings here and in density_at.
    const double above = 1 + 1e-14;
    switch (density) {
        case Density::one: return 1;
        case Density::x2_plus_y2: return extent.r_max * extent.r_max * above;
        case Density::x2: return extent.abs_x_max * extent.abs_x_max * above;
        case Density::sin2: {
            // A crest of sin^2, at pi/2 + k pi, in the range of r?
            const double pi = std::numbers::pi;
            const double crest = (std::ceil((extent.r_min - pi / 2) / pi - 1e-12) + 0.5) * pi;
            if (crest <= extent.r_max) return 1;
            const double low = std::sin(extent.r_min), high = std::sin(extent.r_max);
            // Far from a crest an error of r moves the value: a little slack in proportion to r.
            const double top = std::max(std::abs(low), std::abs(high)) + 1e-15 * extent.r_max;
            return std::min(1.0, top * top * above);
        }
    }
    return 1;
}

}  // namespace annulus::inline v1
