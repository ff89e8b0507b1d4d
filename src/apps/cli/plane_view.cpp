// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/plane_view.h>

#include <annulus/error.h>
#include <annulus/voronoi.h>
#include <apps/cli/frame_clip.h>
#include <apps/cli/lloyd_scene.h>
#include <apps/cli/solid_mesh.h>
#include <apps/motion/cell_energy.h>
#include <apps/motion/cell_quality.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/region_cell_2.h>
#include <apps/motion/vector_2.h>
#include <apps/motion/voronoi_cell_2.h>
#include <apps/report/face_limits.h>
#include <apps/report/joined_outlines.h>
#include <apps/report/shades.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

/// A view while it is made, cell by cell and triangle by triangle.
class View_maker {
  public:
    View_maker(std::vector<Coordinates<2>> sites, const Density_2* density, std::string caption)
        : density_(density), part_(window_of(sites, most_faces, faces_in_window)) {
        view_.cells.points = std::move(sites);
        view_.cells.caption = std::move(caption);
        if (density != nullptr) view_.measures.energy = 0;
    }

    /// A cell, in parts with disjoint interiors.
    void add_cell(const Coordinates<2>& site, bool at_border, Index neighbours, std::span<const Cell_2> parts) {
        const unsigned char shade = shade_of_neighbours(neighbours);
        if (!at_border) {
            ++view_.measures.inner;
            ++view_.measures.neighbours[shade];
        }
        if (density_ != nullptr)
            for (const Cell_2& part : parts) *view_.measures.energy += cell_energy(*density_, part, site);
        // The window of a page is that of two pictures, and may be a little larger than this one.
        const double off = std::max(std::fabs(site[0] - part_.centre[0]), std::fabs(site[1] - part_.centre[1]));
        if (part_.whole || off < 1.5 * part_.half_side) add_face(parts, at_border ? border_shade : shade);
    }

    void add_triangle(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
        const double angle = triangle_quality({a[0], a[1], 0}, {b[0], b[1], 0}, {c[0], c[1], 0}).angle_min;
        Plane_step& m = view_.measures;
        m.angle_min = triangles_ == 0 ? angle : std::min(m.angle_min, angle);
        m.angle_mean += angle;
        ++triangles_;
    }

    [[nodiscard]] Plane_view finish() {
        if (triangles_ > 0) view_.measures.angle_mean /= static_cast<double>(triangles_);
        // A length of 1e100 to the fourth power is no number.
        if (view_.measures.energy && !std::isfinite(*view_.measures.energy)) view_.measures.energy.reset();
        return std::move(view_);
    }

  private:
    /// One face: no line is drawn where the parts of a cell meet.
    void add_face(std::span<const Cell_2> parts, unsigned char shade) {
        std::vector<std::vector<Coordinates<2>>> outlines;
        for (const Cell_2& part : parts) outlines.push_back(outline_of(part));
        outlines = joined_outlines(std::move(outlines));
        if (outlines.empty()) return;
        Face& face = view_.cells.faces.emplace_back(Face{std::move(outlines.front()), shade});
        face.more.assign(std::move_iterator(outlines.begin() + 1), std::move_iterator(outlines.end()));
    }

    const Density_2* density_;
    Window part_;
    Plane_view view_;
    std::size_t triangles_ = 0;
};

/// By vertex: how many Voronoi facets are not exactly empty.
std::vector<Index> side_counts(const Moving_mesh_2& dt) {
    const Voronoi_diagram<2> diagram = voronoi(dt);
    std::vector<Index> count(dt.index_bound(), 0);
    for (std::size_t k = 0; k < diagram.pair.size(); ++k)
        for (const Index v : diagram.pair[k]) count[static_cast<std::size_t>(v)] += diagram.exactly_empty[k] == 0;
    return count;
}

/// A rectangle around points, half a spacing away from them.
Domain_2 around(std::span<const Coordinates<2>> points, double more = 0) {
    Coordinates<2> low = points[0], high = points[0];
    for (const auto& p : points)
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    const double side = std::max(high[0] - low[0], high[1] - low[1]);
    const double margin = more + 0.5 * side / std::sqrt(static_cast<double>(points.size()));
    for (std::size_t k = 0; k < 2; ++k) {
        low[k] -= margin;
        high[k] += margin;
    }
    return Domain_2::polygon(std::vector<Coordinates<2>>{low, {high[0], low[1]}, high, {low[0], high[1]}});
}

double area_of(const Cell_2& cell) { return moments(Density::one, cell.origin, cell.corners).mass; }

/// Whether the border of a convex domain cuts off a part of the cell, or all of it, or comes as near as rounding.
bool reaches_border(const Domain_2& domain, const Cell_2& cell) {
    return cell.corners.empty() || std::any_of(cell.corners.begin(), cell.corners.end(), [&](const Corner_2& corner) {
               return !domain.well_contains(plus(cell.origin, corner.offset));
           });
}

/// Whether the parts are less than the cell by more than rounding.
bool is_less(std::span<const Cell_2> parts, const Cell_2& cell) {
    double area = 0;
    for (const Cell_2& part : parts) area += area_of(part);
    return area < (1 - 1e-9) * area_of(cell);
}

/// The image of a point in the box of these vectors from the origin.
Coordinates<2> in_box(const Coordinates<2>& p, const Coordinates<2>& a, const Coordinates<2>& b) {
    const double area = a[0] * b[1] - a[1] * b[0];
    const double along_a = std::floor((p[0] * b[1] - p[1] * b[0]) / area),
                 along_b = std::floor((a[0] * p[1] - a[1] * p[0]) / area);
    return {p[0] - along_a * a[0] - along_b * b[0], p[1] - along_a * a[1] - along_b * b[1]};
}

/// Not finite where the corners are on a line.
Coordinates<2> circumcentre(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const double area = 2 * (bx * cy - by * cx), bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    return {a[0] + (cy * bb - by * cc) / area, a[1] + (bx * cc - cx * bb) / area};
}

std::vector<Coordinates<2>> present(const Moving_mesh_2& dt) {
    std::vector<Coordinates<2>> points;
    for (std::size_t i = 0; i < dt.index_bound(); ++i)
        if (dt.is_vertex(static_cast<Index>(i))) points.push_back(dt.points()[i]);
    return points;
}

/// `open`: there is no domain, only a frame for the picture; then unbounded cells are at the border.
Plane_view view_in(const Moving_mesh_2& dt, const Region_2& domain, bool open, const Density_2* density,
                   std::string caption) {
    View_maker maker(present(dt), density, std::move(caption));
    const std::span<const Coordinates<2>> points = dt.points();
    Stars_2 stars;
    read_stars(dt, stars);
    Voronoi_cell_2 cell_of(domain.hull());
    std::optional<Region_cell_2> parts_of;
    if (!domain.convex()) parts_of.emplace(domain);
    const std::vector<Index> sides = side_counts(dt);
    for (std::size_t v = 0; v < sides.size(); ++v) {
        if (!dt.is_vertex(static_cast<Index>(v))) continue;
        const Cell_2& cell = cell_of(points[v], stars.of(v), points, stars.cyclic(v));
        const std::span<const Cell_2> parts = parts_of ? (*parts_of)(cell) : std::span(&cell, 1);
        const bool cut = !open && (reaches_border(domain.hull(), cell) || (parts_of && is_less(parts, cell)));
        maker.add_cell(points[v], cut || !stars.cyclic(v), sides[v], parts);
    }
    const auto at = [&](Index v) { return points[static_cast<std::size_t>(v)]; };
    for (const auto& c : dt.cells().vertices) {
        if (c[2] == none) continue;
        const Coordinates<2> centre = circumcentre(at(c[0]), at(c[1]), at(c[2]));
        if (!open && !(std::isfinite(centre[0]) && std::isfinite(centre[1]) && domain.contains(centre))) continue;
        maker.add_triangle(at(c[0]), at(c[1]), at(c[2]));
    }
    return maker.finish();
}

}  // namespace

Plane_view plane_view(const Moving_mesh_2& dt, const Region_2& domain, const Density_2* density, std::string caption) {
    return view_in(dt, domain, false, density, std::move(caption));
}

std::optional<Plane_view> plane_view(const Moving_mesh_2& dt, const std::optional<Clip_record>& clip,
                                     std::string caption) {
    if (dt.number_of_vertices() == 0) return {};
    std::optional<Domain_2> frame;
    try {
        frame = clip ? domain_of(*clip) : around(present(dt));
    } catch (const Error&) {
        return {};
    }
    return view_in(dt, *frame, !clip, nullptr, std::move(caption));
}

std::optional<Plane_view> plane_view(const Boxed_mesh<2>& dt, const Density_2* density, std::string caption) {
    const auto& box = dt.mesh().box().vectors();
    const std::span<const Coordinates<2>> given = dt.mesh().points();
    if (given.empty()) return {};
    // The images in the box, so that pictures of two frames show the same part of the plane.
    std::vector<Coordinates<2>> points(given.begin(), given.end());
    for (Coordinates<2>& p : points) p = in_box(p, box[0], box[1]);
    const Periodic_neighbours<2> all = dt.mesh().neighbours();
    std::optional<Domain_2> domain;  // larger than any cell
    try {
        domain = around(points, *std::max_element(all.distance.begin(), all.distance.end()));
    } catch (const Error&) {
        return {};
    }
    View_maker maker(points, density, std::move(caption));
    Voronoi_cell_2 cell_of(*domain);
    std::vector<Coordinates<2>> vectors, position;
    std::vector<Index> numbers;
    std::size_t next = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        vectors.clear();
        for (; next < all.first.size() && static_cast<std::size_t>(all.first[next]) == v; ++next)
            if (all.area[next] > 0) vectors.push_back(all.vector[next]);
        std::sort(vectors.begin(), vectors.end(),
                  [](const auto& a, const auto& b) { return std::atan2(a[1], a[0]) < std::atan2(b[1], b[0]); });
        position.assign(1, points[v]);
        numbers.clear();
        for (const auto& u : vectors) {
            numbers.push_back(static_cast<Index>(position.size()));
            position.push_back({points[v][0] + u[0], points[v][1] + u[1]});
        }
        const Cell_2& cell = cell_of(points[v], numbers, position, true);
        maker.add_cell(points[v], false, static_cast<Index>(vectors.size()), std::span(&cell, 1));
    }
    const Periodic_cells<2> cells = dt.mesh().cells();
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
        std::array<Coordinates<2>, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 2; ++i) {
                const Shift<2>& shift = cells.offsets[c][k];
                corner[k][i] = given[static_cast<std::size_t>(cells.vertices[c][k])][i] + shift[0] * box[0][i] +
                               shift[1] * box[1][i];
            }
        maker.add_triangle(corner[0], corner[1], corner[2]);
    }
    Plane_view view = maker.finish();
    view.cells.outline.push_back(outline_of(dt.box()));
    return view;
}

std::vector<std::vector<Coordinates<2>>> border_of(const Region_2& domain) {
    std::vector<std::vector<Coordinates<2>>> border;
    if (!domain.convex()) {
        for (const auto& [a, b] : domain.triangles().edges()) border.push_back({a, b, a});
        return border;
    }
    std::vector<Coordinates<2>>& ring = border.emplace_back();
    const Domain_2& hull = domain.hull();
    ring.assign(hull.corners().begin(), hull.corners().end());
    for (int i = 0; i < 180 && hull.kind() == Domain_2::Kind::disc; ++i) {
        const double angle = i * std::numbers::pi / 90;
        ring.push_back({hull.radius() * std::cos(angle), hull.radius() * std::sin(angle)});
    }
    return border;
}

bool is_viewed(std::uint64_t i, std::uint64_t last) {
    if (i == last) return true;
    while (i >= 10 && i % 10 == 0) i /= 10;
    return i == 1 || i == 2 || i == 3 || i == 5 || i == 7;
}

}  // namespace annulus::inline v1::cli
