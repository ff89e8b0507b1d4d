// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/domain_files.h>

#include <annulus/error.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_exchange.h>
#include <apps/formats/write_mesh.h>
#include <apps/formats/write_vtu.h>
#include <apps/report/summary.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

constexpr std::size_t worst_count = 10;

bool has(const std::vector<std::string>& formats, const char* name) {
    return std::find(formats.begin(), formats.end(), name) != formats.end();
}

}  // namespace

void add_domain_formats(CLI::App& app, std::vector<std::string>& formats) {
    app.add_option("--domain-as", formats,
                   "Also write the domain as Gmsh's domain.msh, in version 4.1 (msh) or 2.2 (msh22), and as domain.vtk "
                   "of legacy VTK: one of these names, or several with commas")
        ->type_name("FORMAT")
        ->delimiter(',')
        ->check(CLI::IsMember({"msh", "msh22", "vtk"}));
}

void check_domain_formats(const std::vector<std::string>& formats, const Common_arguments& common) {
    if (!formats.empty() && common.output.empty())
        throw Error(Error_code::usage, "--domain-as is for files: say where with --output DIR");
    if (has(formats, "msh") && has(formats, "msh22"))
        throw Error(Error_code::usage, "--domain-as: msh and msh22 are both domain.msh, say which");
}

Domain_files::Domain_files(const Mesh_3& mesh) : mesh_(mesh) {
    std::vector<std::array<Index, 4>> inside;
    for (std::size_t c = 0; c < mesh.cells().vertices.size(); ++c)
        if (mesh.inside()[c] != 0) inside.push_back(mesh.cells().vertices[c]);
    part_ = mesh_part(mesh.points(), inside, surface_facets(mesh.cells(), mesh.inside()));
    const auto x = [&](Index v) { return part_.points[static_cast<std::size_t>(v)]; };
    for (const auto& c : part_.tetrahedra) quality_.push_back(cell_quality(x(c[0]), x(c[1]), x(c[2]), x(c[3])));
}

std::vector<Worst_cell> Domain_files::worst() const {
    std::vector<Worst_cell> worst;
    for (const std::size_t i : worst_cells(quality_, worst_count)) {
        Worst_cell cell{i, quality_[i].dihedral_min, quality_[i].radius_ratio, quality_[i].aspect, {}};
        for (std::size_t k = 0; k < 3; ++k)
            for (const Index v : part_.tetrahedra[i]) cell.at[k] += part_.points[static_cast<std::size_t>(v)][k] / 4;
        worst.push_back(cell);
    }
    return worst;
}

std::string Domain_files::quality_csv() const {
    Csv_table table;
    table.header = {"cell", "volume", "radius_ratio", "aspect", "dihedral_min", "dihedral_max", "plane_min"};
    for (std::size_t i = 0; i < quality_.size(); ++i) {
        const Cell_quality& q = quality_[i];
        table.rows.push_back(
            {std::uint64_t{i}, q.volume, q.radius_ratio, q.aspect, q.dihedral_min, q.dihedral_max, q.plane_min});
    }
    return write_csv(table);
}

std::vector<Vtu_field> Domain_files::point_fields() const {
    std::vector<std::int64_t> boundary(part_.points.size(), 0);
    for (const auto& t : part_.triangles)
        for (const Index v : t) boundary[static_cast<std::size_t>(v)] = 1;
    return {{"boundary", std::move(boundary)}};
}

std::vector<Vtu_field> Domain_files::cell_fields() const {
    std::vector<std::int64_t> dimension(part_.tetrahedra.size(), 3);
    dimension.resize(part_.tetrahedra.size() + part_.triangles.size(), 2);
    std::vector<double> radius_ratio, aspect, angle_min;
    const auto add = [&](double ratio, double longest, double angle) {
        radius_ratio.push_back(ratio);
        aspect.push_back(longest);
        angle_min.push_back(angle);
    };
    for (const Cell_quality& q : quality_) add(q.radius_ratio, q.aspect, q.dihedral_min);
    const auto x = [&](Index v) { return part_.points[static_cast<std::size_t>(v)]; };
    for (const auto& t : part_.triangles) {
        const Triangle_quality q = triangle_quality(x(t[0]), x(t[1]), x(t[2]));
        add(q.radius_ratio, q.aspect, q.angle_min);
    }
    return {{"dimension", std::move(dimension)},
            {"radius_ratio", std::move(radius_ratio)},
            {"aspect", std::move(aspect)},
            {"angle_min", std::move(angle_min)}};
}

void Domain_files::add_to(Run_page<Moving_mesh_3>& page, const Run_record& run,
                          const std::vector<std::string>& formats) const {
    page.cells = mesh_.cells().vertices;
    std::vector<std::int64_t> flag, boundary(mesh_.points().size(), 0);
    for (const char inside : mesh_.inside()) flag.push_back(inside != 0 ? 1 : 0);
    for (const auto& facet : surface_facets(mesh_.cells(), mesh_.inside()))
        for (const Index v : facet) boundary[static_cast<std::size_t>(v)] = 1;
    page.point_fields.push_back({"boundary", std::move(boundary)});
    page.cell_fields.push_back({"domain", std::move(flag)});
    page.files.emplace_back("dihedral.csv", write_csv(dihedral_table(run)));
    page.files.emplace_back("quality.csv", quality_csv());
    page.files.emplace_back("domain.mesh", write_mesh(part_));
    const std::vector<Vtu_field> points = point_fields(), cells = cell_fields();
    page.files.emplace_back("domain.vtu", write_vtu(part_, points, cells));
    // Not the fields of cells, with which Debian 12's meshio, 5.0.0, takes no file of this version.
    if (has(formats, "msh22")) page.files.emplace_back("domain.msh", write_msh(part_, Msh_version::v2_2, points));
    if (has(formats, "msh")) page.files.emplace_back("domain.msh", write_msh(part_, Msh_version::v4_1, points, cells));
    if (has(formats, "vtk")) page.files.emplace_back("domain.vtk", write_vtk(part_, points, cells));
}

void print_worst(const Run_record& run) {
    const char* label = "worst cells";
    for (const Worst_cell& c : run.worst) {
        std::printf("%-15s%llu: dihedral angle %.2f degrees, radius ratio %.3f, aspect %.1f, at %.6g %.6g %.6g\n",
                    label, static_cast<unsigned long long>(c.cell), c.dihedral_min, c.radius_ratio, c.aspect, c.at[0],
                    c.at[1], c.at[2]);
        label = "";
    }
}

}  // namespace annulus::inline v1::cli
