// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <apps/formats/decimal.h>
#include <apps/formats/write_exchange.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <variant>

namespace annulus::inline v1 {

/// Throws what the writers of write_exchange.h throw. `writer` is the name of one.
inline void require_part(const Mesh_part& part, std::span<const Vtu_field> point_fields,
                         std::span<const Vtu_field> cell_fields, const std::string& writer) {
    for (const Coordinates<3>& p : part.points)
        for (const double x : p)
            if (!std::isfinite(x)) throw Error(Error_code::not_finite, writer + ": a coordinate is not finite");
    const auto known = [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < part.points.size(); };
    const auto all_known = [&](const auto& cell) { return std::all_of(cell.begin(), cell.end(), known); };
    if (!std::all_of(part.tetrahedra.begin(), part.tetrahedra.end(), all_known) ||
        !std::all_of(part.triangles.begin(), part.triangles.end(), all_known))
        throw Error(Error_code::unknown_vertex, writer + ": a cell names no point");
    const auto require_size = [&](std::span<const Vtu_field> fields, std::size_t size) {
        for (const Vtu_field& field : fields)
            if (std::visit([](const auto& values) { return values.size(); }, field.values) != size)
                throw Error(Error_code::wrong_size,
                            writer + ": the field " + field.name + " has not " + std::to_string(size) + " values");
    };
    require_size(point_fields, part.points.size());
    require_size(cell_fields, part.tetrahedra.size() + part.triangles.size());
}

/// Appends "x y z\n".
inline void append_point(std::string& out, const Coordinates<3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        append_decimal(out, p[k]);
        out += k < 2 ? ' ' : '\n';
    }
}

/// Appends the indices, each more by `first`: " a b c\n".
template <std::size_t n>
void append_corners(std::string& out, const std::array<Index, n>& cell, Index first) {
    for (const Index v : cell) {
        out += ' ';
        append_decimal(out, v + first);
    }
    out += '\n';
}

}  // namespace annulus::inline v1
