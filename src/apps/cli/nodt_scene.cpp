// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/nodt_scene.h>

#include <annulus/error.h>
#include <apps/formats/format.h>
#include <apps/formats/read_image.h>
#include <apps/formats/read_surface.h>
#include <apps/formats/read_tetrahedra.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/initial_mesh_3.h>
#include <apps/motion/surface_3.h>
#include <apps/motion/tetrahedral_faults.h>
#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// The name of the input in error messages.
const std::string& source_of(const Nodt_arguments& a) {
    static const std::string sphere = "--sphere";
    return a.sphere ? sphere : a.mesh.empty() ? a.surface : a.mesh;
}

}  // namespace

double Nodt_scene::spacing() const { return std::cbrt(domain->volume() / static_cast<double>(points.size())); }

void Nodt_scene::require_cells(const Nodt_arguments& a, std::span<const char> inside) const {
    if (std::any_of(inside.begin(), inside.end(), [](char flag) { return flag != 0; })) return;
    throw Input_error(Error_code::too_few, source_of(a), 0,
                      "no Delaunay cell of its vertices has its circumcentre inside",
                      "vertices close enough together for its shape");
}

Nodt_3 Nodt_scene::motion(const Nodt_arguments& a, int threads) const {
    Curve_motion along;
    if (features) along = Curve_motion(features, features->places(points, rounding_of(*domain)));
    return Nodt_3(*domain, sizing, on_surface, a.lock, threads, std::move(along));
}

namespace {

bool is_image(const std::string& file) { return has_extension_of(file, Format::inr); }

Triangle_surface surface_from(const Nodt_arguments& a, std::vector<std::string>& notes) {
    if (is_image(a.surface)) {
        const Labelled_image image = read_image(a.surface);
        try {
            Triangle_surface surface = surface_of(image);
            notes.push_back("The domain is what is labelled in the image, averaged in blocks: a surface of " +
                            grouped(surface.triangles.size(), "triangle") + ".");
            return surface;
        } catch (const Error& e) {
            throw Input_error(Error_code::bad_input, a.surface, 0, e.what(), "labels other than 0");
        }
    }
    Surface_file file = read_surface(a.surface);
    if (file.merged > 0) notes.push_back(grouped(file.merged, "duplicate point") + " of the surface merged.");
    return std::move(file.surface);
}

Sizing_3 sizing_of(const Nodt_arguments& a, const Domain_3& domain) {
    return Sizing_3(domain, a.sizing == "graded" ? a.gradation.value_or(2) : 0);
}

std::shared_ptr<const Feature_curves> features_of(const Nodt_arguments& a, const Triangle_surface& surface,
                                                  std::vector<std::string>& notes) {
    if (!a.sharp) return nullptr;
    auto features = std::make_shared<const Feature_curves>(surface, *a.sharp);
    notes.push_back("Sharp edges are kept: " + grouped(features->curves().size(), "curve") + ", " +
                    grouped(features->corners().size(), "corner") + ".");
    return features;
}

/// From an initial mesh by CGAL.
Nodt_scene refined_scene(const Nodt_arguments& a, std::uint64_t seed) {
    std::vector<std::string> notes;
    std::unique_ptr<const Domain_3> domain;
    std::shared_ptr<const Feature_curves> features;
    if (a.sphere) {
        domain = std::make_unique<Ball_3>(1);
    } else {
        const Triangle_surface surface = surface_from(a, notes);
        domain = std::make_unique<Surface_3>(surface, a.allow_crossing);
        features = features_of(a, surface, notes);
    }
    const Sizing_3 sizing = sizing_of(a, *domain);
    std::vector<Coordinates<3>> points = initial_mesh(*domain, sizing, a.vertices, seed, features.get());
    if (features) features->snap(points, rounding_of(*domain));
    std::vector<char> on_surface = vertices_on_surface(*domain, points);
    return {std::move(domain), sizing, std::move(points), std::move(on_surface), std::move(features), std::move(notes)};
}

/// From the vertices of a file.
Nodt_scene read_scene(const Nodt_arguments& a) {
    Tetrahedra_file mesh = read_tetrahedra(a.mesh);
    std::vector<std::string> notes;
    if (mesh.merged > 0) notes.push_back(grouped(mesh.merged, "duplicate point") + " of the mesh merged.");
    if (mesh.unused > 0)
        notes.push_back(grouped(mesh.unused, "point") + " of the mesh without a tetrahedron left out.");
    if (mesh.turned) notes.push_back("All tetrahedra of the mesh were negative.");
    const Triangle_surface surface = mesh.surface();
    auto domain = std::make_unique<Surface_3>(surface, true);  // read_tetrahedra has checked for crossings
    if (const auto cell = covered_twice(*domain, mesh.points, mesh.cells, mesh.boundary))
        throw Input_error(Error_code::bad_input, mesh.name, mesh.cell_lines[*cell],
                          "a tetrahedron lies within another part of the mesh", "parts that do not overlap");
    std::vector<char> on_surface(mesh.points.size(), 0);
    for (const auto& t : mesh.boundary.triangles)
        for (const Index v : t) on_surface[static_cast<std::size_t>(v)] = 1;
    std::shared_ptr<const Feature_curves> features = features_of(a, surface, notes);
    const Sizing_3 sizing = sizing_of(a, *domain);
    return {std::move(domain),   sizing,          std::move(mesh.points), std::move(on_surface),
            std::move(features), std::move(notes)};
}

}  // namespace

Nodt_scene make_scene(const Nodt_arguments& a, std::uint64_t seed) {
    if (!a.sphere && a.surface.empty() && a.mesh.empty())
        throw Error(Error_code::usage, "say what to mesh with --surface FILE, --mesh FILE or --sphere");
    if (a.gradation && a.sizing != "graded") throw Error(Error_code::usage, "--gradation is for --sizing graded");
    if (a.vertices == 0 && a.mesh.empty()) throw Error(Error_code::usage, "say how many vertices with --vertices N");
    try {
        return a.mesh.empty() ? refined_scene(a, seed) : read_scene(a);
    } catch (const Input_error&) {
        throw;
    } catch (const Error& e) {
        const bool crosses = std::string_view(e.what()).starts_with("it crosses");
        const bool refined = std::string_view(e.what()).find("Mesh_3") != std::string_view::npos;
        throw Input_error(e.code(), source_of(a), 0, e.what(),
                          crosses ? "a surface that does not, or --allow-crossing"
                          : refined && a.sharp
                              ? "sharp edges that are farther apart: a larger angle for --sharp, or none"
                              : "");
    }
}

}  // namespace annulus::inline v1::cli
