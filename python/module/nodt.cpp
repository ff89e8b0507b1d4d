// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/following.h>
#include <module/parts.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>
#include <apps/formats/read_surface.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/initial_mesh_3.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/surface_3.h>

#include <pybind11/stl.h>

#include <filesystem>
#include <mutex>
#include <utility>

namespace annulus::python {

namespace {

/// A closed surface from points and triangles, which are all counter-clockwise seen from outside, or all clockwise.
Triangle_surface surface_from(const py::sequence& pair) {
    if (pair.size() != 2) throw Error(Error_code::wrong_size, "surface must be a pair, points and triangles");
    const Points_in<3> points(pair[0], "surface: points");
    Triangle_surface s;
    s.points.assign(points.span().begin(), points.span().end());
    s.triangles = triangles_of(pair[1], s.points.size());
    if (!s.points.empty() && enclosed_volume(s) < 0)
        for (auto& t : s.triangles) std::swap(t[0], t[2]);  // reverses the orientation
    return s;
}

/// The domain inside a surface: the unit ball for None, the name of a file for bytes, or a pair of arrays.
std::unique_ptr<const Domain_3> domain_of(const py::object& surface, bool allow_crossing) {
    if (surface.is_none()) return std::make_unique<Ball_3>(1);
    Triangle_surface s;
    if (!py::isinstance<py::bytes>(surface)) s = surface_from(surface);
    const auto file = py::isinstance<py::bytes>(surface) ? surface.cast<std::string>() : std::string();
    const Without_gil without_gil;
    try {
        if (!file.empty()) s = read_surface(std::filesystem::path(file)).surface;
        return std::make_unique<Surface_3>(s, allow_crossing);
    } catch (const Error& e) {
        throw Error(e.code(), std::string("surface: ") + e.what());
    }
}

/// Reads the cells of the triangulation and finds those of the domain.
void read_cells(const Moving_mesh_3& dt, bool changed, const Domain_3& domain, int threads, Kept_cells_3& kept) {
    if (changed && dt.mesh().dimension() == 3) kept.read(dt.mesh().table(), threads);
    else if (changed) kept.read(std::vector<std::array<Index, 4>>(), dt.points().size(), threads);
    kept.measure(domain, dt.points(), threads);
}

struct Mesh_of_domain {
    std::vector<Coordinates<3>> points;
    std::vector<std::array<Index, 4>> cells;
    std::vector<char> on_surface;
};

/// Runs the iterations. Precondition: no GIL.
Mesh_of_domain iterate(const Domain_3& domain, std::size_t vertices, double gradation, std::optional<double> lock,
                       std::int64_t iterations, const Options& options, std::uint64_t seed, const py::object& callback,
                       History& history) {
    const Sizing_3 sizing(domain, gradation);
    Mesh_of_domain out;
    {
        static std::mutex one_at_a_time;  // Mesh_3 uses a global random number generator
        const std::lock_guard hold(one_at_a_time);
        out.points = initial_mesh(domain, sizing, vertices, seed);
    }
    Moving_mesh_3 dt{std::span<const Coordinates<3>>(out.points), options};
    Kept_cells_3 kept;
    read_cells(dt, true, domain, options.threads, kept);
    out.on_surface = vertices_on_surface(domain, out.points);
    const Nodt_3 nodt(domain, sizing, out.on_surface, lock, options.threads);
    Nodt_memory memory;
    for (std::int64_t i = 0; i < iterations; ++i) {
        const Nodt_step step = nodt.step(kept, dt.points(), out.points, memory);
        const Move_result report = dt.move_all(std::span<const Coordinates<3>>(out.points));
        const bool changed =
            report.statistics.flips + report.moves.reinserted + report.moves.rebuilt + report.moves.flipped > 0;
        read_cells(dt, changed, domain, options.threads, kept);
        history.add(step.mean_displacement, step.max_displacement, report);
        if (!goes_on(callback, history)) break;
    }
    for (std::size_t c = 0; c < kept.cells().vertices.size(); ++c)
        if (kept.inside()[c] != 0) out.cells.push_back(kept.cells().vertices[c]);
    return out;
}

py::tuple run_nodt(const py::object& surface, std::int64_t vertices, double gradation, std::optional<double> lock,
                   bool allow_crossing, std::int64_t iterations, const Options& options, std::uint64_t seed,
                   const py::object& callback) {
    require_iterations(iterations);
    if (vertices < 4 || vertices > 10'000'000)
        throw Error(Error_code::usage, "vertices must be from 4 to 10000000, not " + std::to_string(vertices));
    if (lock && !(*lock > 0 && *lock < 70.5)) throw Error(Error_code::usage, "lock must be between 0 and 70.5 degrees");
    if (!(gradation >= 0 && gradation <= 100)) throw Error(Error_code::usage, "gradation must be from 0 to 100");
    const auto domain = domain_of(surface, allow_crossing);
    History history;
    Mesh_of_domain mesh;
    {
        const Without_gil without_gil;
        mesh = iterate(*domain, static_cast<std::size_t>(vertices), gradation, lock, iterations, options, seed,
                       callback, history);
    }
    std::vector<std::uint8_t> on_surface(mesh.on_surface.begin(), mesh.on_surface.end());
    return py::make_tuple(give_rows(std::move(mesh.points)), give_rows(std::move(mesh.cells)),
                          give(std::move(on_surface)).attr("astype")("bool"), give(std::move(history.mean)),
                          give(std::move(history.max)), Report(std::move(history.total), 3, false));
}

}  // namespace

void add_nodt(py::module_& m) { m.def("nodt", &run_nodt); }

}  // namespace annulus::python
