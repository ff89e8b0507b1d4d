// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/io/read_mesh.h>
#include <annulus/triangulation/audit.h>

#include <cstdio>
#include <memory>

namespace annulus::cli {

Run add_audit_command(CLI::App& app, const Invocation&) {
    auto* sub = app.add_subcommand("audit", "Exact verdict: is this Medit mesh the Delaunay triangulation of its points?");
    const auto file = std::make_shared<std::string>();
    const auto quiet = std::make_shared<bool>(false);
    sub->add_option("FILE", *file, "A .mesh file with vertices and triangles")->required();
    sub->add_flag("-q,--quiet", *quiet, "Only the exit status: 0 Delaunay, 1 not");
    return [file, quiet] {
        const auto mesh = read_mesh(*file);
        const auto* plane = std::get_if<Mesh_file<2>>(&mesh);
        if (plane == nullptr)
            throw Input_error(Error_code::bad_input, *file, 0, "a mesh of dimension 3", "dimension 2 in this version");
        const Audit_result r = audit(Audit_input<2>{plane->points, plane->cells});
        if (!*quiet) {
            const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
            std::printf("%zu points, %zu triangles: %s\n", plane->points.size(), plane->cells.size(),
                        r.delaunay() ? "Delaunay" : "NOT Delaunay");
            std::printf("inverted %llu, edges violated %llu, border not convex %llu, topology %llu; cocircular %llu\n",
                        count(r.inverted_cells), count(r.violated_facets), count(r.concave_ridges),
                        count(r.topological_faults), count(r.degenerate_facets));
            if (!r.delaunay()) std::printf("first: %s\n", r.first_fault.c_str());
        }
        return r.delaunay() ? done : audit_failed;
    };
}

}  // namespace annulus::cli
