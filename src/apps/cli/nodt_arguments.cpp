// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/nodt_scene.h>

namespace annulus::inline v1::cli {

void add_nodt(CLI::App& app, Nodt_arguments& a) {
    auto* surface =
        app.add_option("--surface", a.surface,
                       "Closed surface: a .off, .obj, .ply or .stl file, or a labelled image, .inr or .inr.gz")
            ->type_name("FILE");
    app.add_flag("--allow-crossing", a.allow_crossing,
                 "Accept a surface that crosses itself: a point is inside if a ray from it crosses the surface an odd "
                 "number of times")
        ->needs(surface);
    auto* sphere = app.add_flag("--sphere", a.sphere, "The unit sphere");
    auto* mesh =
        app.add_option("--mesh", a.mesh,
                       "Tetrahedral mesh to start from, a Medit file .mesh: its vertices, and its boundary as surface")
            ->type_name("FILE");
    surface->excludes(sphere);
    mesh->excludes(sphere)->excludes(surface);
    app.add_option("-n,--vertices", a.vertices, "Start from a mesh with about N vertices")
        ->type_name("N")
        ->check(whole_number(4, 10'000'000))
        ->excludes(mesh);
    app.add_option("-i,--iterations", a.iterations, "Number of iterations")
        ->check(whole_number(0, 1'000'000'000))
        ->capture_default_str();
    app.add_option("--sizing", a.sizing, "Edges of the same length everywhere, or longer away from the surface")
        ->check(CLI::IsMember({"constant", "graded"}))
        ->capture_default_str();
    app.add_option("--gradation", a.gradation,
                   "With --sizing graded: edges are 1 + this times as long at the depth of the ball of the same volume "
                   "(2)")
        ->check(number_within(0.0, 100.0));
    app.add_option("--lock", a.lock,
                   "Vertices rest while the dihedral angles of their cells are between this and 180 degrees minus this")
        ->type_name("DEGREES")
        ->check(number_within(0.01, 70.0));
    app.add_option("--sharp", a.sharp,
                   "Keep edges of the surface whose triangles depart by more than this from one plane: vertices move "
                   "along them, corners rest")
        ->type_name("DEGREES")
        ->check(number_within(0.01, 179.99))
        ->excludes(sphere);
}

}  // namespace annulus::inline v1::cli
