// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/lloyd_scene.h>

#include <annulus/kernel/read_neighbours.h>
#include <annulus/predicate/filtered.h>
#include <apps/cli/box_size.h>
#include <apps/formats/read_gray_image.h>
#include <apps/formats/read_points.h>
#include <apps/formats/read_rings.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/polygon_rings_2.h>
#include <apps/motion/sampling_2.h>
#include <apps/motion/voronoi_cell_2.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/svg_gray.h>
#include <apps/report/svg_stipples.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

namespace annulus::inline v1::cli {

void add_lloyd(CLI::App& app, Lloyd_arguments& a) {
    auto* points = app.add_option("-n,--points", a.points, "Sample N points with the density")
                       ->type_name("N")
                       ->check(whole_number(3, 100'000'000));
    auto* input =
        app.add_option(
               "--input", a.input,
               "Start from the points of a .xyz, .csv, .lammpstrj, .npy, .off, .ply or .mesh file; - is standard input")
            ->type_name("FILE");
    points->excludes(input);
    add_format(app, a.format, point_formats);
    app.add_flag("--ignore-z", a.ignore_z, "Drop the z coordinate of the input")->needs(input);
    add_open(app, a.open);
    app.add_option("--density", a.density,
                   "Density of the centroids that points move to, or a picture, .png, .jpg, .pgm or\n"
                   ".ppm, which is stippled: dense where it is dark")
        ->type_name("FILE:{one,x2+y2,x2,sin2}")
        ->check([](const std::string& word) {
            const bool known = std::any_of(std::begin(all_densities), std::end(all_densities),
                                           [&](Density d) { return name_of(d) == word; });
            return known || is_gray_image(word)
                       ? std::string()
                       : "'" + word + "' is none of one, x2+y2, x2, sin2, and no picture (.png, .jpg, .pgm, .ppm)";
        })
        ->capture_default_str();
    app.add_flag("--invert", a.invert, "For a picture: dense where it is bright");
    app.add_option("--dots", a.dots,
                   "For a picture: discs of equal radius in stipples.svg, or each as large as\n"
                   "the dark area in its Voronoi cell")
        ->check(CLI::IsMember({"equal", "cells"}))
        ->capture_default_str();
    app.add_option("--domain", a.domain,
                   "disc, square, box, or a file with the corners of a polygon in order, where a blank line begins\n"
                   "another ring: holes, islands (default: disc; the convex hull for --input)")
        ->type_name("DOMAIN");
    app.add_option("--radius", a.radius,
                   "Radius of the disc, half side of the square (default 1; 2 pi for sin2, two rings)")
        ->check([](const std::string& word) {
            char* end = nullptr;
            const double r = std::strtod(word.c_str(), &end);
            const bool number = end != word.c_str() && *end == '\0';
            if (number && std::isfinite(r) && r > 0) return std::string();
            const bool beyond = number && std::isinf(r) && word.find_first_of("0123456789") != std::string::npos;
            return "'" + word + (beyond ? "' is beyond what a double can hold" : "' is not a positive number");
        });
    app.add_option("--size", a.size,
                   "Of --domain box, 2D or 3D: the lengths of its edges from the origin on, Lx,Ly or Lx,Ly,Lz, or\n"
                   "the 4 or 6 coordinates of its lower and its upper corner")
        ->type_name("LIST");
    app.add_flag("--keep-boundary", a.keep_boundary,
                 "Points of the input on the border of a polygon stay there: at corners they rest, on\n"
                 "edges they move along them")
        ->needs(input);
    app.add_option("-i,--iterations", a.iterations, "Number of iterations")
        ->check(whole_number(0, 1'000'000'000))
        ->capture_default_str();
}

double Lloyd_scene::spacing() const { return std::sqrt(domain.area() / static_cast<double>(points.size())); }

namespace {

Region_2 polygon_from(const std::string& file) {
    const Ring_file rings = read_rings(file);
    const char* expected = "the corners of a polygon in order, a blank line between rings";
    try {
        return Region_2::polygon(rings.corners.points, rings.begin);
    } catch (const Edge_error& e) {
        throw rings.corners.fault(e.corner(), Error_code::bad_input,
                                  "the edge that begins here meets the one that begins in line " +
                                      std::to_string(rings.corners.lines.at(e.other())) + ": " + e.what(),
                                  "rings that neither cross nor touch themselves or each other");
    } catch (const Corner_error& e) {
        throw rings.corners.fault(e.corner(), Error_code::bad_input, e.what(), expected);
    } catch (const Error& e) {
        throw rings.corners.fault(0, Error_code::bad_input, e.what(), expected);
    }
}

bool collinear(const std::vector<Coordinates<2>>& p) {
    return std::all_of(p.begin(), p.end(), [&](const auto& c) {
        return evaluate_orientation({&p[0], &p[1], &c}, false).sign == 0;
    });
}

/// The default domain of points from a file: their convex hull, or a square around them if they are on a line.
Domain_2 domain_around(const std::vector<Coordinates<2>>& p) {
    if (!collinear(p)) return Domain_2::convex_hull_of(p);
    Coordinates<2> low = p[0];
    Coordinates<2> high = p[0];
    for (const auto& c : p)
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], c[k]);
            high[k] = std::max(high[k], c[k]);
        }
    const double half = 0.55 * std::max(high[0] - low[0], high[1] - low[1]);
    const double x = 0.5 * (low[0] + high[0]);
    const double y = 0.5 * (low[1] + high[1]);
    const std::vector<Coordinates<2>> square{
        {x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
    return Domain_2::polygon(square);
}

/// Throws Error(usage) for sin2 on a wide domain: the time for its moments is proportional to the area of the domain if
/// cells span several rings.
void require_rings_to_be_few(Density density, const Region_2& domain) {
    const auto& box = domain.bounding_box();
    const double width = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    if (density == Density::sin2 && width > 1000)
        throw Error(Error_code::usage, "--density sin2 takes domains up to 1000 wide; its rings are 3.1 apart");
}

Domain_2 rectangle(const Lloyd_arguments& a) {
    if (dimension_of_size(a.size) != 2)
        throw Error(Error_code::usage, "--size has a box in 3D, which only `annulus lloyd` itself takes");
    const auto [low, high] = box_of_size<2>(a.size);
    return Domain_2::polygon(std::vector<Coordinates<2>>{low, {high[0], low[1]}, high, {low[0], high[1]}});
}

/// The picture, if --density names one.
std::optional<Stippling> stippling_from(const Lloyd_arguments& a) {
    if (!is_gray_image(a.density)) {
        if (a.invert)
            throw Error(Error_code::usage, "--invert is for a picture: --density FILE.png, .jpg, .pgm or .ppm");
        if (a.dots != "equal")
            throw Error(Error_code::usage, "--dots is for a picture: --density FILE.png, .jpg, .pgm or .ppm");
        return {};
    }
    if (!a.domain.empty() || a.radius != 0 || !a.size.empty())
        throw Error(Error_code::usage,
                    "with a picture for --density the domain is the picture: no --domain, --radius or --size");
    Gray_image image = read_gray_image(a.density);
    try {
        return Stippling(std::move(image), a.invert);
    } catch (const Error& e) {
        throw Input_error(Error_code::bad_input, a.density, 0, e.what(), "something to stipple");
    }
}

}  // namespace

Lloyd_scene make_scene(const Lloyd_arguments& a, std::uint64_t seed) {
    if (a.points == 0 && a.input.empty())
        throw Error(Error_code::usage, "say how many points with --points N, or name a file with --input FILE");
    std::optional<Stippling> stippling = stippling_from(a);
    const Density formula = stippling ? Density::one : parse_density(a.density);
    if (!a.size.empty() && a.domain != "box") throw Error(Error_code::usage, "--size is for --domain box");
    const bool named = a.domain == "disc" || a.domain == "square";
    if (a.radius != 0 && !named && !(a.domain.empty() && a.input.empty()))
        throw Error(Error_code::usage, a.domain.empty()
                                           ? "--radius needs --domain disc or square when points come from a file"
                                           : "--radius is for --domain disc or square, not for a polygon");
    if (!std::isfinite(a.radius)) throw Error(Error_code::usage, "--radius must be a finite number");
    const double radius = a.radius > 0 ? a.radius : formula == Density::sin2 ? 2 * std::numbers::pi : 1.0;
    std::optional<Region_2> domain;
    if (stippling) {
        const auto w = static_cast<double>(stippling->width()), h = static_cast<double>(stippling->height());
        domain = Domain_2::polygon(std::vector<Coordinates<2>>{{0, 0}, {w, 0}, {w, h}, {0, h}});
    } else if (a.domain == "disc" || (a.domain.empty() && a.input.empty())) {
        domain = Domain_2::disc(radius);
    } else if (a.domain == "square") {
        domain = Domain_2::square(radius);
    } else if (a.domain == "box") {
        domain = rectangle(a);
    } else if (!a.domain.empty()) {
        domain = polygon_from(a.domain);
    }
    if (domain) require_rings_to_be_few(formula, *domain);
    if (a.input.empty()) {
        std::vector<Coordinates<2>> points =
            sample(*domain, stippling ? Density_2(stippling->ink()) : formula, a.points, seed);
        const Density_2 density = stippling ? Density_2(stippling->density()) : formula;
        return {*domain, density, std::move(points), 0, {}, std::move(stippling)};
    }
    const Point_file<2> file =
        read_points<2>(a.input, {.ignore_z = a.ignore_z, .format = a.format, .box = {.ignored = a.open}});
    std::vector<Coordinates<2>> points = distinct_points(file, 3).x;
    for (std::size_t i = 0; domain && i < file.points.size(); ++i)
        if (!domain->contains(file.points[i]))
            throw file.fault(i, Error_code::out_of_domain, "point outside the domain",
                             "points in the " + (stippling ? "picture" : a.domain));
    const std::uint64_t merged = file.points.size() - points.size();
    if (!domain) {
        try {
            domain = domain_around(points);
        } catch (const Error& e) {
            throw file.fault(0, Error_code::out_of_domain, e.what(), "lengths between 1e-100 and 1e100");
        }
        require_rings_to_be_few(formula, *domain);
    }
    const Density_2 density = stippling ? Density_2(stippling->density()) : formula;
    Kept_border_2 border;
    Input_record input = input_of(file);
    if (a.keep_boundary) {
        if (domain->hull().kind() == Domain_2::Kind::disc)
            throw Error(Error_code::usage, "--keep-boundary is for polygons, not for a disc");
        border = Kept_border_2(*domain, points);
        if (border.count() == 0) input.warnings.push_back(a.input + ": no point is on the boundary that is to be kept");
    }
    return {*domain, density, std::move(points), merged, std::move(input), std::move(stippling), std::move(border)};
}

std::string stipples_of(const Lloyd_arguments& a, const Lloyd_scene& scene, const Moving_mesh_2& dt) {
    const Stippling& picture = *scene.stippling;
    const std::span<const Coordinates<2>> points = dt.points();
    std::vector<double> radii{disc_radius(picture.area(), points.size())};
    if (a.dots == "cells") {
        Stars_2 stars;
        read_stars(dt, stars);
        Voronoi_cell_2 cell_of(scene.domain.hull());  // a rectangle
        const Density_2 ink = picture.ink();
        radii.clear();
        for (std::size_t v = 0; v < points.size(); ++v) {
            const Cell_2& cell = cell_of(points[v], stars.of(v), points, stars.cyclic(v));
            const double mass = moments(ink, cell.origin, cell.corners).mass;
            radii.push_back(disc_radius(std::max(mass, 0.0) / picture.full(), 1));
        }
    }
    return svg_stipples(picture.width(), picture.height(), points, radii, a.invert);
}

std::vector<Drawing> drawings_of(const Lloyd_scene& scene, const std::string& stipples) {
    constexpr std::size_t most = 20000;
    const Gray_image& image = scene.stippling->image();
    std::vector<Drawing> drawings{
        {"", svg_gray(image, "The picture"),
         "The picture, " + grouped(image.width) + " × " + grouped(image.height) + " pixels, coarsened for this page."}};
    const std::string dots = grouped(scene.points.size()) + " dots";
    if (scene.points.size() <= most) drawings.push_back({"", stipples, dots + ": stipples.svg."});
    else drawings.front().caption += " Its " + dots + " are too many for a page: they are in stipples.svg.";
    return drawings;
}

void read_stars(const Moving_mesh_2& dt, Stars_2& stars) {
    if (dt.mesh().dimension() == 2) return stars.read(dt.mesh().table());
    Neighbours_2 lists;
    read_neighbours(dt.mesh(), dt.points(), lists);
    stars.read(lists);
}

}  // namespace annulus::inline v1::cli
