// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/mesh_3.h>
#include <apps/cli/solid_mesh.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <apps/motion/mesh_quality.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/cut_picture.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

void Mesh_3::read(const Moving_mesh_3& dt) {
    Audit_input<3> in = dt.audit_input();
    std::erase_if(in.cells, [](const auto& c) { return c[3] == none; });  // the cells of a flat set
    read(std::move(in.points), std::move(in.cells));
}

void Mesh_3::read(std::vector<Coordinates<3>> points, std::vector<std::array<Index, 4>> cells) {
    points_ = std::move(points);
    kept_.read(std::move(cells), points_.size());
    all_.assign(kept_.cells().vertices.size(), 1);
    domain_ = false;
}

void Mesh_3::read(const Moving_mesh_3& dt, bool cells_changed, const Domain_3& domain, int threads) {
    points_.assign(dt.points().begin(), dt.points().end());
    if (cells_changed && dt.mesh().dimension() == 3) kept_.read(dt.mesh().table(), threads);
    else if (cells_changed) kept_.read(std::vector<std::array<Index, 4>>(), points_.size(), threads);
    kept_.measure(domain, points_, threads);
    domain_ = true;
}

namespace {

/// The lower and upper corner of the bounding box.
std::pair<Coordinates<3>, Coordinates<3>> box(const std::vector<Coordinates<3>>& points) {
    Coordinates<3> low{}, high{};
    if (!points.empty()) low = high = points[0];
    for (const auto& p : points)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    return {low, high};
}

}  // namespace

Cut_plane middle_of(const Coordinates<3>& low, const Coordinates<3>& high, const std::vector<Coordinates<3>>& points) {
    Cut_plane plane;
    double volume = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        if (high[k] - low[k] < high[plane.axis] - low[plane.axis]) plane.axis = k;
        volume *= high[k] - low[k];
    }
    const auto n = static_cast<double>(std::max<std::size_t>(points.size(), 1));
    const double spacing = std::cbrt(volume / n);
    plane.at = 0.5 * (low[plane.axis] + high[plane.axis]);
    const auto near = std::count_if(points.begin(), points.end(), [&](const auto& p) {
        return std::fabs(p[plane.axis] - plane.at) < 0.05 * spacing;
    });
    if (static_cast<double>(near) > 0.5 * std::pow(n, 2. / 3)) plane.at += 0.25 * spacing;
    if (std::fabs(plane.at) < 1e-6 * (high[plane.axis] - low[plane.axis])) plane.at = 0;
    return plane;
}

Cut_plane Mesh_3::middle() const {
    const auto [low, high] = box(points_);
    return middle_of(low, high, points_);
}

Picture Mesh_3::cut(std::string caption, const Cut_plane& plane) const {
    return cut_picture(cells(), inside(), points_, plane.axis, plane.at,
                       std::move(caption) + ", cut at " + "xyz"[plane.axis] + " = " + readable(plane.at), domain_);
}

Mesh_step measured(const Mesh_3& mesh, const Nodt_step& step) {
    const Mesh_quality q = mesh_quality(mesh.cells(), mesh.inside(), mesh.points());
    const auto counts = q.dihedral.counts();
    return {.vertices = q.vertices,
            .boundary = q.boundary,
            .locked = step.locked,
            .kept = step.kept,
            .cells = q.cells,
            .slivers = q.slivers,
            .dihedral_min = q.cells > 0 ? q.dihedral.min() : 0,
            .dihedral_max = q.cells > 0 ? q.dihedral.max() : 0,
            .dihedral = {counts.begin(), counts.end()}};
}

namespace {

/// The section of the box by the plane: a convex polygon, or nothing.
std::vector<Coordinates<2>> section_of(const Box<3>::Vectors& v, const Cut_plane& plane) {
    const std::size_t right = plane.axis == 0 ? 1 : 0, up = plane.axis == 2 ? 1 : 2;
    std::vector<Coordinates<2>> points;
    for (std::size_t k = 0; k < 3; ++k)  // the four edges along vector k
        for (const bool i : {false, true})
            for (const bool j : {false, true}) {
                Coordinates<3> p{};
                for (std::size_t c = 0; c < 3; ++c) p[c] = (i ? v[(k + 1) % 3][c] : 0) + (j ? v[(k + 2) % 3][c] : 0);
                const double t = (plane.at - p[plane.axis]) / v[k][plane.axis];
                if (t >= 0 && t <= 1) points.push_back({p[right] + t * v[k][right], p[up] + t * v[k][up]});
            }
    Coordinates<2> centre{};
    for (const auto& p : points)
        for (std::size_t c = 0; c < 2; ++c) centre[c] += p[c] / static_cast<double>(points.size());
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return std::atan2(a[1] - centre[1], a[0] - centre[0]) < std::atan2(b[1] - centre[1], b[0] - centre[0]);
    });
    return points;
}

}  // namespace

Picture picture_of(const Moving_mesh_3& dt, std::string caption, Chosen_cut& plane) {
    Mesh_3 mesh;
    mesh.read(dt);
    const Cut_plane now = plane ? *plane : mesh.middle();
    if (!mesh.points().empty()) plane = now;
    return mesh.cut(std::move(caption), now);
}

Picture picture_of(const Boxed_mesh<3>& dt, std::string caption, Chosen_cut& plane) {
    Solid_mesh<3> solid = cells_in_box(dt);
    const Box<3>::Vectors& vectors = dt.box().vectors();
    Coordinates<3> low{}, high{};
    for (const auto& v : vectors)
        for (std::size_t k = 0; k < 3; ++k) (v[k] < 0 ? low : high)[k] += v[k];
    if (!plane) plane = middle_of(low, high, solid.points);
    Mesh_3 mesh;
    mesh.read(std::move(solid.points), std::move(solid.cells));
    Picture picture = mesh.cut(std::move(caption) + with_images, *plane);
    picture.outline.push_back(section_of(vectors, *plane));
    return picture;
}

}  // namespace annulus::inline v1::cli
