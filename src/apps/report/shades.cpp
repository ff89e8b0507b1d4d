// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/shades.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

std::string legend_of(Shading shading, bool border) {
    static constexpr std::array cells{"4 or fewer", "5", "6", "7", "8 or more", "at the border"};
    static constexpr std::array angles{"below 10°", "10–20°", "20–30°", "30–40°", "40–50°", "50° or more"};
    const bool by_neighbours = shading == Shading::neighbours;
    const std::span<const char* const> names =
        by_neighbours ? std::span<const char* const>(cells).first(border ? cells.size() : border_shade) : angles;
    std::string out = "<p class=\"keys\"><span>";
    out += by_neighbours ? "Neighbours of a cell:" : "Least dihedral angle of a tetrahedron:";
    out += "</span>";
    for (std::size_t k = 0; k < names.size(); ++k)
        out += " <span><svg class=\"key\" viewBox=\"0 0 10 10\" aria-hidden=\"true\"><path class=\"face " +
               std::string(by_neighbours ? "n" : "q") + std::to_string(k) + "\" d=\"M1 1h8v8h-8z\"/></svg>" + names[k] +
               "</span>";
    return out + "</p>\n";
}

}  // namespace annulus::inline v1
