// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/medit_parser.h>
#include <apps/formats/point_formats.h>
#include <apps/formats/read_mesh.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The simplices of flat points, which have no solid cells.
template <std::size_t corners>
void take_if_empty(Medit_cells<corners>& cells, Medit_cells<corners - 1>&& flat) {
    if (!cells.cells.empty()) return;
    cells.lines = std::move(flat.lines);
    for (const auto& c : flat.cells) {
        std::copy(c.begin(), c.end(), cells.cells.emplace_back().begin());
        cells.cells.back().back() = none;
    }
}

template <int d, std::size_t corners>
Mesh_file<d> mesh_of(std::string name, Medit_content&& content, Medit_cells<corners>&& cells) {
    static_assert(corners == static_cast<std::size_t>(d) + 1);
    if (!content.has_vertices)
        throw Input_error(Error_code::bad_input, std::move(name), content.last_line, "has no points",
                          "a section Vertices");
    if (cells.cells.empty() && content.points.size() > 1)
        throw Input_error(Error_code::bad_input, std::move(name), content.last_line,
                          d == 2 ? "has no triangles" : "has no tetrahedra",
                          d == 2 ? "a section Triangles, or Edges where all points are collinear"
                                 : "a section Tetrahedra, or Triangles where all points are coplanar");
    Mesh_file<d> mesh;
    mesh.name = std::move(name);
    mesh.points.reserve(content.points.size());
    for (const Coordinates<3>& p : content.points) {
        Coordinates<d> q;
        std::copy_n(p.begin(), d, q.begin());
        mesh.points.push_back(q);
    }
    mesh.point_lines = std::move(content.lines);
    mesh.cells = std::move(cells.cells);
    mesh.cell_lines = std::move(cells.lines);
    return mesh;
}

}  // namespace

std::variant<Mesh_file<2>, Mesh_file<3>> read_mesh(const std::filesystem::path& file) {
    const Source source = load_file(file);
    Medit_content content = parse_medit(source);
    take_if_empty(content.triangles, std::move(content.edges));
    if (content.dimension == 2) return mesh_of<2>(source.name, std::move(content), std::move(content.triangles));
    take_if_empty(content.tetrahedra, std::move(content.triangles));
    return mesh_of<3>(source.name, std::move(content), std::move(content.tetrahedra));
}

Raw_points read_medit_points(const Source& source) {
    Medit_content content = parse_medit(source);
    return {std::move(content.points), std::move(content.lines), content.dimension == 3};
}

}  // namespace annulus::inline v1
