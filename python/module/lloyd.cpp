// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/following.h>
#include <module/parts.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/kernel/read_neighbours.h>
#include <annulus/moving_mesh.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/region_2.h>
#include <apps/motion/sampling_2.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace annulus::python {

namespace {

/// The domain from its name, or from the corners of its rings, of which `begin` has the first ones; nothing for None.
std::optional<Region_2> domain_of(const py::object& domain, const std::vector<std::size_t>& begin, double radius) {
    if (domain.is_none()) return {};
    if (py::isinstance<py::str>(domain)) {
        const auto name = domain.cast<std::string>();
        if (name == "disc") return Domain_2::disc(radius);
        if (name == "square") return Domain_2::square(radius);
        throw Error(Error_code::usage,
                    "domain '" + name + "' is none; there are disc, square, and the corners of a polygon");
    }
    const Points_in<2> corners(domain, "domain");
    require_in_domain(corners.span(), "corner");
    return Region_2::polygon(corners.span(), begin);
}

/// The density from its name, or from the weights of pixels, the first row on top, laid over the box of the domain.
Density_2 density_of(const py::object& density, const Domain_2::Box& box) {
    if (py::isinstance<py::str>(density)) return parse_density(density.cast<std::string>());
    const auto weights = density.cast<py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>>();
    const auto rows = static_cast<std::size_t>(weights.shape(0)), columns = static_cast<std::size_t>(weights.shape(1));
    return Placed_image{Image_density(columns, rows, {weights.data(), rows * columns}),
                        box.lower,
                        {(box.upper[0] - box.lower[0]) / static_cast<double>(columns),
                         (box.upper[1] - box.lower[1]) / static_cast<double>(rows)}};
}

std::vector<Coordinates<2>> points_in(const std::optional<Region_2>& domain, std::span<const Coordinates<2>> points) {
    require_in_domain(points, "point");
    std::vector<std::int64_t> strays;
    for (std::size_t i = 0; domain && i < points.size(); ++i)
        if (!domain->contains(points[i])) strays.push_back(static_cast<std::int64_t>(i));
    if (!strays.empty())
        throw Error(Error_code::out_of_domain, "point " + std::to_string(strays.front()) + " is outside of the domain",
                    strays);
    return {points.begin(), points.end()};
}

void read_stars(const Moving_mesh_2& dt, Stars_2& stars) {
    if (dt.mesh().dimension() == 2) return stars.read(dt.mesh().table());
    Neighbours_2 lists;
    read_neighbours(dt.mesh(), dt.points(), lists);
    stars.read(lists);
}

/// Runs the iterations. `points` are the initial positions and become the final ones. Precondition: no GIL.
void iterate(const Region_2& domain, const Density_2& density, std::int64_t iterations, const Options& options,
             const py::object& callback, std::vector<Coordinates<2>>& points, History& history) {
    Moving_mesh_2 dt{std::span<const Coordinates<2>>(points), options};
    points.assign(dt.points().begin(), dt.points().end());  // fewer if duplicate points were merged
    const Lloyd_2 lloyd(domain, density, options.threads);
    Stars_2 stars;
    Lloyd_memory memory;
    bool changed = true;
    for (std::int64_t i = 0; i < iterations; ++i) {
        if (changed) read_stars(dt, stars);
        const Lloyd_step step = lloyd.step(stars, dt.points(), points, memory);
        const Move_result report = dt.move_all(std::span<const Coordinates<2>>(points));
        changed = report.statistics.flips + report.moves.reinserted + report.moves.rebuilt + report.moves.flipped > 0;
        history.add(step.mean_displacement, step.max_displacement, report);
        if (!goes_on(callback, history)) return;
    }
}

py::tuple run(const py::object& points, const py::object& density_object, const py::object& domain_object,
              const std::vector<std::size_t>& begin, std::optional<double> radius_given, std::int64_t iterations,
              const Options& options, std::uint64_t seed, const py::object& callback) {
    require_iterations(iterations);
    const bool rings =
        py::isinstance<py::str>(density_object) && parse_density(density_object.cast<std::string>()) == Density::sin2;
    if (radius_given && !(*radius_given > 0 && std::isfinite(*radius_given)))
        throw Error(Error_code::bad_input, "radius must be a number above 0, not " + std::to_string(*radius_given));
    const double radius = radius_given.value_or(rings ? 2 * std::numbers::pi : 1.0);
    std::optional<Region_2> domain = domain_of(domain_object, begin, radius);
    std::vector<Coordinates<2>> x;
    if (py::isinstance<py::int_>(points)) {  // how many
        const auto n = points.cast<std::int64_t>();
        if (n < 3 || n > 100'000'000)
            throw Error(Error_code::usage, "points must be from 3 to 100000000, not " + std::to_string(n));
        if (!domain) domain = Domain_2::disc(radius);
        const Density_2 density = density_of(density_object, domain->bounding_box());
        const Without_gil without_gil;
        x = sample(*domain, density, static_cast<std::size_t>(n), seed);
    } else {
        const Points_in<2> given(points);
        if (given.span().size() < 3) throw Error(Error_code::too_few, "points must be three or more");
        x = points_in(domain, given.span());
        if (!domain) domain = Domain_2::convex_hull_of(x);
    }
    const auto& box = domain->bounding_box();
    if (rings && std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]) > 1000)
        throw Error(Error_code::usage, "density sin2 takes domains up to 1000 wide; its rings are 3.1 apart");
    const Density_2 density = density_of(density_object, box);
    History history;
    {
        const Without_gil without_gil;
        iterate(*domain, density, iterations, options, callback, x, history);
    }
    return py::make_tuple(give_rows(std::move(x)), give(std::move(history.mean)), give(std::move(history.max)),
                          Report(std::move(history.total), 2, false));
}

}  // namespace

void add_lloyd(py::module_& m) { m.def("lloyd", &run); }

}  // namespace annulus::python
