// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/exchange_text.h>

namespace annulus::inline v1 {

namespace {

// Gmsh's numbers of element types, and the tags of the groups, which are those of the entities, too.
constexpr const char* triangle = "2";
constexpr const char* tetrahedron = "4";
constexpr const char* surface_tag = "2";
constexpr const char* domain_tag = "1";

std::string head_of_msh(const char* version) {
    return std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 " + surface_tag +
           " \"surface\"\n3 " + domain_tag + " \"domain\"\n$EndPhysicalNames\n";
}

/// $NodeData or $ElementData of each field: no time series, one number for each item.
void append_views(std::string& out, const std::string& section, std::span<const Vtu_field> fields) {
    for (const Vtu_field& field : fields)
        std::visit(
            [&](const auto& values) {
                out += "$" + section + "\n1\n\"" + field.name + "\"\n1\n0\n3\n0\n1\n" + std::to_string(values.size());
                out += '\n';
                std::size_t number = 0;
                for (const auto value : values) {
                    append_decimal(out, ++number);
                    out += ' ';
                    append_decimal(out, value);
                    out += '\n';
                }
                out += "$End" + section + "\n";
            },
            field.values);
}

/// Version 2.2: each element with its type and two tags, of the group and of the entity.
void append_elements_2(std::string& out, const Mesh_part& part) {
    out += "$Nodes\n" + std::to_string(part.points.size()) + "\n";
    std::size_t number = 0;
    for (const Coordinates<3>& p : part.points) {
        append_decimal(out, ++number);
        out += ' ';
        append_point(out, p);
    }
    out += "$EndNodes\n$Elements\n" + std::to_string(part.tetrahedra.size() + part.triangles.size()) + "\n";
    number = 0;
    const auto append = [&](const auto& cells, const std::string& type, const std::string& tag) {
        const std::string tags = " " + type + " 2 " + tag + " " + tag;
        for (const auto& cell : cells) {
            append_decimal(out, ++number);
            out += tags;
            append_corners(out, cell, 1);
        }
    };
    append(part.tetrahedra, tetrahedron, domain_tag);
    append(part.triangles, triangle, surface_tag);
    out += "$EndElements\n";
}

/// "TAG lower upper 1 GROUP": an entity with its bounding box and its group.
std::string entity(const Mesh_part& part, const std::string& tag) {
    Coordinates<3> lower{}, upper{};
    if (!part.points.empty()) lower = upper = part.points[0];
    for (const Coordinates<3>& p : part.points)
        for (std::size_t k = 0; k < 3; ++k) {
            lower[k] = std::min(lower[k], p[k]);
            upper[k] = std::max(upper[k], p[k]);
        }
    std::string out = tag;
    for (const Coordinates<3>& corner : {lower, upper})
        for (const double x : corner) {
            out += ' ';
            append_decimal(out, x);
        }
    return out + " 1 " + tag;
}

/// Version 4.1: blocks by entity. All points are in one block, that of the volume, so that they keep their order where
/// readers number them by it.
void append_elements_4(std::string& out, const Mesh_part& part) {
    const auto blocks_of = [](std::size_t blocks, std::size_t items) {
        const std::string n = std::to_string(items);
        return std::to_string(blocks) + " " + n + (items > 0 ? " 1 " : " 0 ") + n + "\n";
    };
    const std::string volume = std::string("3 ") + domain_tag;
    out += "$Entities\n0 0 1 1\n" + entity(part, surface_tag) + " 0\n" + entity(part, domain_tag) + " 1 " +
           surface_tag + "\n$EndEntities\n$Nodes\n" + blocks_of(part.points.empty() ? 0 : 1, part.points.size());
    if (!part.points.empty()) out += volume + " 0 " + std::to_string(part.points.size()) + "\n";
    for (std::size_t i = 1; i <= part.points.size(); ++i) {
        append_decimal(out, i);
        out += '\n';
    }
    for (const Coordinates<3>& p : part.points) append_point(out, p);
    const std::size_t cells = part.tetrahedra.size() + part.triangles.size();
    const std::size_t blocks = (part.tetrahedra.empty() ? 0u : 1u) + (part.triangles.empty() ? 0u : 1u);
    out += "$EndNodes\n$Elements\n" + blocks_of(blocks, cells);
    std::size_t number = 0;
    const auto append = [&](const auto& block, const std::string& head) {
        if (!block.empty()) out += head + " " + std::to_string(block.size()) + "\n";
        for (const auto& cell : block) {
            append_decimal(out, ++number);
            append_corners(out, cell, 1);
        }
    };
    append(part.tetrahedra, volume + " " + tetrahedron);
    append(part.triangles, std::string("2 ") + surface_tag + " " + triangle);
    out += "$EndElements\n";
}

}  // namespace

std::string write_msh(const Mesh_part& part, Msh_version version, std::span<const Vtu_field> point_fields,
                      std::span<const Vtu_field> cell_fields) {
    require_part(part, point_fields, cell_fields, "write_msh");
    const bool second = version == Msh_version::v2_2;
    std::string out = head_of_msh(second ? "2.2" : "4.1");
    if (second) append_elements_2(out, part);
    else append_elements_4(out, part);
    append_views(out, "NodeData", point_fields);
    append_views(out, "ElementData", cell_fields);
    return out;
}

}  // namespace annulus::inline v1
