// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/following.h>
#include <module/parts.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/kernel/read_neighbours.h>
#include <annulus/moving_mesh.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/sampling_2.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace annulus::python {

namespace {

/// The domain from its name, or from its corners, clockwise or counter-clockwise; nothing for None.
std::optional<Domain_2> domain_of(const py::object& domain, double radius) {
    if (domain.is_none()) return {};
    if (py::isinstance<py::str>(domain)) {
        const auto name = domain.cast<std::string>();
        if (name == "disc") return Domain_2::disc(radius);
        if (name == "square") return Domain_2::square(radius);
        throw Error(Error_code::usage,
                    "domain '" + name + "' is none; there are disc, square, and the corners of a convex polygon");
    }
    const Points_in<2> corners(domain, "domain");
    require_in_domain(corners.span(), "corner");
    return Domain_2::polygon(corners.span());
}

std::vector<Coordinates<2>> points_in(const std::optional<Domain_2>& domain, std::span<const Coordinates<2>> points) {
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
void iterate(const Domain_2& domain, Density density, std::int64_t iterations, const Options& options,
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

py::tuple run(const py::object& points, const std::string& density_name, const py::object& domain_object,
              std::optional<double> radius_given, std::int64_t iterations, const Options& options, std::uint64_t seed,
              const py::object& callback) {
    require_iterations(iterations);
    const Density density = parse_density(density_name);
    if (radius_given && !(*radius_given > 0 && std::isfinite(*radius_given)))
        throw Error(Error_code::bad_input, "radius must be a number above 0, not " + std::to_string(*radius_given));
    const double radius = radius_given.value_or(density == Density::sin2 ? 2 * std::numbers::pi : 1.0);
    std::optional<Domain_2> domain = domain_of(domain_object, radius);
    std::vector<Coordinates<2>> x;
    if (py::isinstance<py::int_>(points)) {  // how many
        const auto n = points.cast<std::int64_t>();
        if (n < 3 || n > 100'000'000)
            throw Error(Error_code::usage, "points must be from 3 to 100000000, not " + std::to_string(n));
        if (!domain) domain = Domain_2::disc(radius);
        const Without_gil without_gil;
        x = sample(*domain, density, static_cast<std::size_t>(n), seed);
    } else {
        const Points_in<2> given(points);
        if (given.span().size() < 3) throw Error(Error_code::too_few, "points must be three or more");
        x = points_in(domain, given.span());
        if (!domain) domain = Domain_2::convex_hull_of(x);
    }
    const auto& box = domain->bounding_box();
    if (density == Density::sin2 && std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]) > 1000)
        throw Error(Error_code::usage, "density sin2 takes domains up to 1000 wide; its rings are 3.1 apart");
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
