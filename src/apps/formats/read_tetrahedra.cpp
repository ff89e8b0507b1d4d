// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/distinct.h>
#include <apps/formats/medit_parser.h>
#include <apps/formats/read_tetrahedra.h>
#include <apps/motion/surface_faults.h>
#include <apps/motion/tetrahedral_faults.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Points that cells use, each position once.
void number_points(const Medit_content& content, Tetrahedra_file& mesh) {
    std::vector<Coordinates<3>> given = content.points;
    for (auto& p : given)
        for (double& x : p) x += 0.0;  // -0 is 0
    const std::vector<std::size_t> first = first_at_place<3>(given);
    std::vector<char> used(given.size(), 0), wanted(given.size(), 0);
    for (const auto& c : content.tetrahedra.cells)
        for (const Index v : c) used[static_cast<std::size_t>(v)] = 1;
    for (std::size_t v = 0; v < given.size(); ++v) {
        if (used[v] == 0) ++mesh.unused;
        else if (wanted[first[v]] != 0) ++mesh.merged;
        else wanted[first[v]] = 1;
    }
    std::vector<Index> number(given.size(), none);
    for (std::size_t v = 0; v < given.size(); ++v) {
        if (wanted[v] == 0) continue;
        number[v] = static_cast<Index>(mesh.points.size());
        mesh.points.push_back(given[v]);
    }
    for (const auto& c : content.tetrahedra.cells) {
        std::array<Index, 4> cell;
        for (std::size_t i = 0; i < 4; ++i) cell[i] = number[first[static_cast<std::size_t>(c[i])]];
        mesh.cells.push_back(cell);
    }
}

/// Reports a fault on the line of a cell.
class Complaint {
  public:
    explicit Complaint(const Tetrahedra_file& mesh) : mesh_(mesh) {}
    [[noreturn]] void operator()(std::size_t cell, std::string fault, std::string expected) const {
        throw Input_error(Error_code::bad_input, mesh_.name, mesh_.cell_lines[cell], std::move(fault),
                          std::move(expected));
    }
    [[nodiscard]] std::string line_of(std::size_t cell) const {
        return "line " + std::to_string(mesh_.cell_lines[cell]);
    }

  private:
    const Tetrahedra_file& mesh_;
};

void check_cells(Tetrahedra_file& mesh, const Complaint& fail) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        auto v = mesh.cells[c];
        std::sort(v.begin(), v.end());
        if (std::adjacent_find(v.begin(), v.end()) != v.end())
            fail(c, "a tetrahedron has two corners at one point", "four different points");
    }
    const std::array<Index, 4> before = mesh.cells.front();
    if (const auto fault = cell_fault(mesh.points, mesh.cells)) {
        switch (fault->kind) {
            case Cell_fault::Kind::flat:
                fail(fault->cell, "a tetrahedron has no volume", "four corners that are not in one plane");
            case Cell_fault::Kind::inverted:
                fail(fault->cell, "a tetrahedron is inverted against that at " + fail.line_of(fault->other),
                     "all of one orientation");
            case Cell_fault::Kind::crowded:
                fail(fault->cell,
                     "a facet is in more than two tetrahedra, one of them at " + fail.line_of(fault->other),
                     "two at most");
            case Cell_fault::Kind::folded:
                fail(fault->cell,
                     "a tetrahedron is on the same side of their common facet as that at " + fail.line_of(fault->other),
                     "one on each side");
        }
    }
    mesh.turned = mesh.cells.front() != before;
}

void check_boundary(const Tetrahedra_file& mesh, const Complaint& fail) {
    const std::vector<std::size_t>& cell = mesh.boundary.cells;
    const Triangle_surface surface = mesh.surface();
    if (const auto fault = edge_fault(surface.triangles))
        fail(cell[fault->triangle], "an edge is in " + std::to_string(fault->count) + " facets of the boundary", "two");
    if (const auto pair = crossing_triangles(surface))
        fail(cell[(*pair)[0]],
             "a facet of the boundary meets one of the tetrahedron at " + fail.line_of(cell[(*pair)[1]]) +
                 " elsewhere than in common corners and edges",
             "tetrahedra that share whole facets, and a boundary that does not touch itself");
}

}  // namespace

Triangle_surface Tetrahedra_file::surface() const {
    std::vector<Index> number(points.size(), none);
    for (const auto& t : boundary.triangles)
        for (const Index v : t) number[static_cast<std::size_t>(v)] = 0;
    Triangle_surface surface;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == none) continue;
        number[v] = static_cast<Index>(surface.points.size());
        surface.points.push_back(points[v]);
    }
    surface.triangles = boundary.triangles;
    for (auto& t : surface.triangles)
        for (Index& v : t) v = number[static_cast<std::size_t>(v)];
    return surface;
}

Tetrahedra_file read_tetrahedra(const std::filesystem::path& file) {
    const Source source = load_file(file);
    Medit_content content = parse_medit(source);
    const auto refuse = [&](std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, content.last_line, std::move(fault), std::move(expected));
    };
    if (content.dimension != 3) refuse("is a 2D mesh", "Dimension 3");
    if (!content.has_vertices) refuse("has no points", "a section Vertices");
    if (content.tetrahedra.cells.empty()) refuse("has no tetrahedra", "a section Tetrahedra");
    Tetrahedra_file mesh;
    mesh.name = source.name;
    number_points(content, mesh);
    mesh.cell_lines = std::move(content.tetrahedra.lines);
    const Complaint fail(mesh);
    check_cells(mesh, fail);
    mesh.boundary = boundary_facets(mesh.cells);
    check_boundary(mesh, fail);
    return mesh;
}

}  // namespace annulus::inline v1
