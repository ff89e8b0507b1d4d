// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/medit_parser.h>
#include <annulus/io/point_formats.h>
#include <annulus/io/read_mesh.h>

#include <algorithm>
#include <utility>

namespace annulus {

namespace {

/// The edges of points on a line, which have no triangles.
Medit_cells<3> padded(Medit_cells<2>&& edges) {
    Medit_cells<3> cells;
    cells.lines = std::move(edges.lines);
    for (const auto& [a, b] : edges.cells) cells.cells.push_back({a, b, none});
    return cells;
}

template <int d, std::size_t corners>
Mesh_file<d> mesh_of(std::string name, Medit_content&& content, Medit_cells<corners>&& cells) {
    static_assert(corners == static_cast<std::size_t>(d) + 1);
    if (content.points.empty())
        throw Input_error(Error_code::bad_input, std::move(name), content.last_line, "has no points",
                          "a section Vertices");
    if (cells.cells.empty())
        throw Input_error(
            Error_code::bad_input, std::move(name), content.last_line,
            d == 2 ? "has no triangles" : "has no tetrahedra",
            d == 2 ? "a section Triangles, or Edges where all points are collinear" : "a section Tetrahedra");
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
    if (content.dimension == 2 && content.triangles.cells.empty()) content.triangles = padded(std::move(content.edges));
    if (content.dimension == 2) return mesh_of<2>(source.name, std::move(content), std::move(content.triangles));
    return mesh_of<3>(source.name, std::move(content), std::move(content.tetrahedra));
}

Raw_points read_medit_points(const Source& source) {
    Medit_content content = parse_medit(source);
    return {std::move(content.points), std::move(content.lines), content.dimension == 3};
}

}  // namespace annulus
