// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// What the colour of a face says. Shade k of `neighbours` has the CSS class nk, that of `angles` qk (report_style.h).
enum class Shading { neighbours, angles };

/// The shades of Voronoi cells by number of neighbours: up to 4, 5, 6, 7, from 8 on, and cells at the border.
inline constexpr std::array neighbour_shades{"four or fewer", "five", "six", "seven", "eight or more"};
inline constexpr unsigned char border_shade = 5;
[[nodiscard]] constexpr unsigned char shade_of_neighbours(Index neighbours) {
    return neighbours <= 4 ? 0 : neighbours >= 8 ? 4 : static_cast<unsigned char>(neighbours - 4);
}

/// The shades of tetrahedra by least dihedral angle, ten degrees each, the last from 50 on. A regular one has 70.5.
[[nodiscard]] constexpr unsigned char shade_of_angle(double degrees) {
    return degrees >= 50 ? 5 : degrees >= 10 ? static_cast<unsigned char>(degrees / 10) : 0;
}

/// The colours and their meaning as a paragraph of a page. `border`: what cells with the last shade are; empty where
/// there are none, as in a periodic box.
[[nodiscard]] std::string legend_of(Shading shading, std::string_view border = "at the border");

}  // namespace annulus::inline v1
