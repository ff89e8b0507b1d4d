// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/audit.h>
#include <annulus/version.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/result_files.h>
#include <apps/formats/read_mesh.h>
#include <apps/formats/write_json.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <variant>

namespace annulus::inline v1::cli {

namespace {

struct Audit_call {
    Common_arguments common;
    std::string file;
};

bool is_audit(std::string_view name) { return name == "audit.json"; }

template <int d>
nlohmann::ordered_json json(const Mesh_file<d>& mesh, const Audit_result& r, const std::string& command) {
    return {{"command", command},
            {"version", ANNULUS_VERSION_STRING},
            {"file", mesh.name},
            {"dimension", d},
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

/// The number of cells and their kind, "edge", "triangle" or "tetrahedron", from the corners of the first cell.
template <int d>
std::string cells_of(const Mesh_file<d>& mesh) {
    if (mesh.cells.empty()) return "no cells";
    const auto& first = mesh.cells.front();
    const auto corners = std::find(first.begin(), first.end(), none) - first.begin();
    if (corners == 4)
        return std::to_string(mesh.cells.size()) + (mesh.cells.size() == 1 ? " tetrahedron" : " tetrahedra");
    return counted(mesh.cells.size(), corners == 3 ? "triangle" : "edge");
}

template <int d>
void print(const Mesh_file<d>& mesh, const Audit_result& r) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%s, %s: %s\n", counted(mesh.points.size(), "point").c_str(), cells_of(mesh).c_str(),
                r.delaunay() ? "Delaunay" : "NOT Delaunay");
    std::printf("inverted %llu, %s violated %llu, border not convex %llu, topology %llu; %s %llu\n",
                count(r.inverted_cells), d == 2 ? "edges" : "facets", count(r.violated_facets), count(r.concave_ridges),
                count(r.topological_faults), d == 2 ? "cocircular" : "cospherical", count(r.degenerate_facets));
    if (!r.delaunay()) std::printf("first: %s (vertices counted from 1, as in the file)\n", r.first_fault.c_str());
}

template <int d>
int judge(const Mesh_file<d>& mesh, const Audit_call& a, const std::string& command) {
    const Audit_result r = audit(Audit_input<d>{mesh.points, mesh.cells}, 1);
    if (!a.common.output.empty()) {
        Result_files out(a.common, is_audit);
        out.write("audit.json", write_json(json(mesh, r, command)));
        out.commit();
    }
    if (!a.common.quiet) print(mesh, r);
    return r.delaunay() ? done : audit_failed;
}

int run(const Audit_call& a, const std::string& command) {
    return std::visit([&](const auto& mesh) { return judge(mesh, a, command); }, read_mesh(a.file));
}

}  // namespace

Run add_audit_command(CLI::App& app, const Invocation& invocation) {
    auto* sub =
        app.add_subcommand("audit", "Exact check: is this Medit mesh the Delaunay triangulation of its points?");
    const auto a = std::make_shared<Audit_call>();
    sub->add_option(
           "FILE", a->file,
           "A .mesh file with vertices and triangles, or tetrahedra (edges or triangles if all points are flat)")
        ->required();
    add_common(*sub, a->common, "audit.json", {no_seed, no_threads});
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
