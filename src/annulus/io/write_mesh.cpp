// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/error.h>
#include <annulus/io/decimal.h>
#include <annulus/io/write_mesh.h>

#include <cmath>

namespace annulus {

template <int d>
std::string write_mesh(std::span<const Coordinates<d>> points,
                       std::span<const std::array<Index, static_cast<std::size_t>(d) + 1>> cells) {
    static_assert(d == 2 || d == 3);
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
    out += (d == 2 ? "\nTriangles\n" : "\nTetrahedra\n") + std::to_string(cells.size()) + "\n";
    for (const auto& cell : cells) {
        for (const Index i : cell) {
            if (i < 0 || static_cast<std::size_t>(i) >= points.size())
                throw Error(Error_code::unknown_vertex, "write_mesh: a cell names no point");
            append_decimal(out, i + 1LL);
            out += ' ';
        }
        out += "0\n";
    }
    out += "\nEnd\n";
    return out;
}

template std::string write_mesh<2>(std::span<const Coordinates<2>>, std::span<const std::array<Index, 3>>);
template std::string write_mesh<3>(std::span<const Coordinates<3>>, std::span<const std::array<Index, 4>>);

}  // namespace annulus
