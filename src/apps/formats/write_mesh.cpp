// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/decimal.h>
#include <apps/formats/write_mesh.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace annulus::inline v1 {

namespace {

/// The section of the cells with k corners; an empty section is written for solid cells only.
template <std::size_t corners>
void append_section(std::string& out, std::size_t points, std::span<const std::array<Index, corners>> cells,
                    std::size_t k) {
    const auto belongs = [k](const auto& cell) {
        return std::find(cell.begin() + 2, cell.end(), none) == cell.begin() + static_cast<std::ptrdiff_t>(k);
    };
    const auto count = std::count_if(cells.begin(), cells.end(), belongs);
    if (count == 0 && k < corners) return;
    constexpr std::array<std::string_view, 3> names{"Edges", "Triangles", "Tetrahedra"};
    out += '\n';
    out += names[k - 2];
    out += '\n' + std::to_string(count) + '\n';
    for (const auto& cell : cells) {
        if (!belongs(cell)) continue;
        for (std::size_t i = 0; i < corners; ++i) {
            if (i >= k && cell[i] == none) continue;
            if (i >= k || cell[i] < 0 || static_cast<std::size_t>(cell[i]) >= points)
                throw Error(Error_code::unknown_vertex, "write_mesh: a cell names no point");
            append_decimal(out, cell[i] + 1LL);
            out += ' ';
        }
        out += "0\n";
    }
}

template <int d>
std::string head_of(std::span<const Coordinates<d>> points) {
    std::string out = "MeshVersionFormatted 2\nDimension " + std::to_string(d) + "\n\nVertices\n" +
                      std::to_string(points.size()) + "\n";
    for (const Coordinates<d>& p : points) {
        for (const double x : p) {
            if (!std::isfinite(x)) throw Error(Error_code::not_finite, "write_mesh: a coordinate is not finite");
            append_decimal(out, x);
            out += ' ';
        }
        out += "0\n";
    }
    return out;
}

constexpr std::string_view tail = "\nEnd\n";

}  // namespace

template <int d>
std::string write_mesh(std::span<const Coordinates<d>> points,
                       std::span<const std::array<Index, static_cast<std::size_t>(d) + 1>> cells) {
    static_assert(d == 2 || d == 3);
    std::string out = head_of<d>(points);
    constexpr std::size_t corners = static_cast<std::size_t>(d) + 1;
    for (std::size_t k = 2; k <= corners; ++k) append_section<corners>(out, points.size(), cells, k);
    return out += tail;
}

std::string write_mesh(const Mesh_part& part) {
    std::string out = head_of<3>(part.points);
    append_section<3>(out, part.points.size(), part.triangles, 3);
    append_section<4>(out, part.points.size(), part.tetrahedra, 4);
    return out += tail;
}

template std::string write_mesh<2>(std::span<const Coordinates<2>>, std::span<const std::array<Index, 3>>);
template std::string write_mesh<3>(std::span<const Coordinates<3>>, std::span<const std::array<Index, 4>>);

}  // namespace annulus::inline v1
