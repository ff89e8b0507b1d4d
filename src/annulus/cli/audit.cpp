// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/result_files.h>
#include <annulus/io/read_mesh.h>
#include <annulus/io/write_json.h>
#include <annulus/triangulation/audit.h>

#include <cstdio>
#include <memory>

namespace annulus::cli {

namespace {

struct Audit_call {
    Common_arguments common;
    std::string file;
};

nlohmann::ordered_json json(const Mesh_file<2>& mesh, const Audit_result& r) {
    return {{"file", mesh.name},
            {"dimension", 2},
            {"vertices", mesh.points.size()},
            {"cells", mesh.cells.size()},
            {"delaunay", r.delaunay()},
            {"faults",
             {{"inverted_cells", r.inverted_cells},
              {"violated_facets", r.violated_facets},
              {"concave_ridges", r.concave_ridges},
              {"topological_faults", r.topological_faults}}},
            {"degenerate_facets", r.degenerate_facets},
            {"first_fault", r.first_fault}};
}

void print(const Mesh_file<2>& mesh, const Audit_result& r) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    const bool flat = mesh.cells.front()[2] == none;
    std::printf("%s, %s: %s\n", counted(mesh.points.size(), "point").c_str(),
                counted(mesh.cells.size(), flat ? "edge" : "triangle").c_str(),
                r.delaunay() ? "Delaunay" : "NOT Delaunay");
    std::printf("inverted %llu, edges violated %llu, border not convex %llu, topology %llu; cocircular %llu\n",
                count(r.inverted_cells), count(r.violated_facets), count(r.concave_ridges), count(r.topological_faults),
                count(r.degenerate_facets));
    if (!r.delaunay()) std::printf("first: %s (vertices counted from 1, as in the file)\n", r.first_fault.c_str());
}

int run(const Audit_call& a) {
    const auto mesh = read_mesh(a.file);
    const auto* plane = std::get_if<Mesh_file<2>>(&mesh);
    if (plane == nullptr)
        throw Input_error(Error_code::bad_input, a.file, 0, "a mesh of dimension 3", "dimension 2 in this version");
    const Audit_result r = audit(Audit_input<2>{plane->points, plane->cells}, 1);
    if (!a.common.output.empty()) {
        Result_files out(a.common.output);
        out.write("audit.json", write_json(json(*plane, r)));
        out.commit();
    }
    if (!a.common.quiet) print(*plane, r);
    return r.delaunay() ? done : audit_failed;
}

}  // namespace

Run add_audit_command(CLI::App& app, const Invocation&) {
    auto* sub =
        app.add_subcommand("audit", "Exact verdict: is this Medit mesh the Delaunay triangulation of its points?");
    const auto a = std::make_shared<Audit_call>();
    sub->add_option("FILE", a->file, "A .mesh file with vertices and triangles (edges where the points are collinear)")
        ->required();
    add_common(*sub, a->common, "audit.json", false);
    return [a] { return run(*a); };
}

}  // namespace annulus::cli
