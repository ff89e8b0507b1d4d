// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/exchange_text.h>

#include <cstdint>
#include <type_traits>

namespace annulus::inline v1 {

namespace {

void append_arrays(std::string& out, const char* section, std::size_t size, std::span<const Vtu_field> fields) {
    if (fields.empty()) return;
    out += section + std::to_string(size) + "\nFIELD FieldData " + std::to_string(fields.size()) + "\n";
    for (const Vtu_field& field : fields)
        std::visit(
            [&](const auto& values) {
                using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
                constexpr const char* type = std::is_same_v<Value, double>         ? "double"
                                             : std::is_same_v<Value, std::int64_t> ? "long"  // as meshio names it
                                                                                   : "unsigned_long";
                out += field.name + " 1 " + std::to_string(size) + " " + type + "\n";
                for (const auto value : values) {
                    append_decimal(out, value);
                    out += '\n';
                }
            },
            field.values);
}

}  // namespace

std::string write_vtk(const Mesh_part& part, std::span<const Vtu_field> point_fields,
                      std::span<const Vtu_field> cell_fields) {
    require_part(part, point_fields, cell_fields, "write_vtk");
    std::string out = "# vtk DataFile Version 4.2\nwritten by annulus\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                      std::to_string(part.points.size()) + " double\n";
    for (const Coordinates<3>& p : part.points) append_point(out, p);
    const std::size_t four = part.tetrahedra.size(), three = part.triangles.size();
    out += "\nCELLS " + std::to_string(four + three) + " " + std::to_string(5 * four + 4 * three) + "\n";
    for (const auto& cell : part.tetrahedra) {
        out += '4';
        append_corners(out, cell, 0);
    }
    for (const auto& cell : part.triangles) {
        out += '3';
        append_corners(out, cell, 0);
    }
    out += "\nCELL_TYPES " + std::to_string(four + three) + "\n";
    for (std::size_t i = 0; i < four; ++i) out += "10\n";
    for (std::size_t i = 0; i < three; ++i) out += "5\n";
    append_arrays(out, "\nPOINT_DATA ", part.points.size(), point_fields);
    append_arrays(out, "\nCELL_DATA ", four + three, cell_fields);
    return out;
}

}  // namespace annulus::inline v1
