// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/nodt_scene.h>

#include <annulus/arithmetic/error.h>
#include <annulus/formats/format.h>
#include <annulus/formats/read_image.h>
#include <annulus/formats/read_surface.h>
#include <annulus/motion/ball_3.h>
#include <annulus/motion/initial_mesh_3.h>
#include <annulus/motion/surface_3.h>

#include <cmath>
#include <utility>

namespace annulus::cli {

void add_nodt(CLI::App& app, Nodt_arguments& a) {
    auto* surface =
        app.add_option("--surface", a.surface,
                       "Closed surface: a .off, .obj, .ply or .stl file, or a labelled image, .inr or .inr.gz")
            ->type_name("FILE");
    app.add_flag("--allow-crossing", a.allow_crossing,
                 "Take a surface that crosses itself: inside is where a ray leaves it an odd number of times")
        ->needs(surface);
    auto* sphere = app.add_flag("--sphere", a.sphere, "The unit sphere");
    surface->excludes(sphere);
    app.add_option("-n,--vertices", a.vertices, "Start from a mesh with about N vertices")
        ->type_name("N")
        ->check(whole_number(4, 10'000'000));
    app.add_option("-i,--iterations", a.iterations, "Number of iterations")
        ->check(whole_number(0, 1'000'000'000))
        ->capture_default_str();
    app.add_option("--sizing", a.sizing, "Edges as long everywhere, or longer away from the surface")
        ->check(CLI::IsMember({"constant", "graded"}))
        ->capture_default_str();
    app.add_option("--gradation", a.gradation,
                   "With --sizing graded: 1 + this much more at the depth of the ball of the same volume (2)")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option("--lock", a.lock,
                   "Vertices rest while the dihedral angles of their cells are between this and 180 degrees less it")
        ->type_name("DEGREES")
        ->check(CLI::Range(0.01, 70.0));
}

double Nodt_scene::spacing() const { return std::cbrt(domain->volume() / static_cast<double>(points.size())); }

namespace {

bool is_image(const std::string& file) { return has_extension_of(file, Format::inr); }

std::unique_ptr<const Domain_3> surface_domain(const Nodt_arguments& a, std::vector<std::string>& notes) {
    Triangle_surface surface;
    if (is_image(a.surface)) {
        const Labelled_image image = read_image(a.surface);
        try {
            surface = surface_of(image);
        } catch (const Error& e) {
            throw Input_error(Error_code::bad_input, a.surface, 0, e.what(), "labels other than 0");
        }
        notes.push_back("The domain is what is labelled in the image, averaged in blocks: a surface of " +
                        counted(surface.triangles.size(), "triangle") + ".");
    } else {
        Surface_file file = read_surface(a.surface);
        if (file.merged > 0) notes.push_back(counted(file.merged, "duplicate point") + " of the surface merged.");
        surface = std::move(file.surface);
    }
    return std::make_unique<Surface_3>(surface, a.allow_crossing);
}

}  // namespace

Nodt_scene make_scene(const Nodt_arguments& a, std::uint64_t seed) {
    if (!a.sphere && a.surface.empty())
        throw Error(Error_code::usage, "say what to mesh with --surface FILE or --sphere");
    if (a.gradation && a.sizing != "graded") throw Error(Error_code::usage, "--gradation is for --sizing graded");
    if (a.vertices == 0) throw Error(Error_code::usage, "say how many vertices with --vertices N");
    std::vector<std::string> notes;
    try {
        std::unique_ptr<const Domain_3> domain;
        if (a.sphere) domain = std::make_unique<Ball_3>(1);
        else domain = surface_domain(a, notes);
        const Sizing_3 sizing(*domain, a.sizing == "graded" ? a.gradation.value_or(2) : 0);
        std::vector<Coordinates<3>> points = initial_mesh(*domain, sizing, a.vertices, seed);
        return {std::move(domain), sizing, std::move(points), std::move(notes)};
    } catch (const Input_error&) {
        throw;
    } catch (const Error& e) {
        const bool crosses = std::string_view(e.what()).starts_with("it crosses");
        throw Input_error(e.code(), a.sphere ? "--sphere" : a.surface, 0, e.what(),
                          crosses ? "a surface that does not, or --allow-crossing" : "");
    }
}

}  // namespace annulus::cli
