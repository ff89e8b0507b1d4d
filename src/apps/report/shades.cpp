// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/shades.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

std::string legend_of(Shading shading, std::string_view border) {
    const std::array<std::string_view, border_shade + 1> cells{"4 or fewer", "5", "6", "7", "8 or more", border};
    static constexpr std::array<std::string_view, 6> angles{"below 10°", "10–20°", "20–30°",
                                                            "30–40°",    "40–50°", "50° or more"};
    const bool by_neighbours = shading == Shading::neighbours;
    std::span<const std::string_view> names = angles;
    if (by_neighbours) names = std::span(cells).first(border.empty() ? border_shade : cells.size());
    std::string out = "<p class=\"keys\"><span>";
    out += by_neighbours ? "Neighbours of a cell:" : "Least dihedral angle of a tetrahedron:";
    out += "</span>";
    for (std::size_t k = 0; k < names.size(); ++k)
        out += " <span><svg class=\"key\" viewBox=\"0 0 10 10\" aria-hidden=\"true\"><path class=\"face " +
               std::string(by_neighbours ? "n" : "q") + std::to_string(k) + "\" d=\"M1 1h8v8h-8z\"/></svg>" +
               std::string(names[k]) + "</span>";
    return out + "</p>\n";
}

}  // namespace annulus::inline v1
