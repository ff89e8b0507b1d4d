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

std::size_t Mesh_3::shortest_side() const {
    const auto [low, high] = box(points_);
    std::size_t axis = 2;
    for (std::size_t k = 0; k < 3; ++k)
        if (high[k] - low[k] < high[axis] - low[axis]) axis = k;
    return axis;
}

Picture Mesh_3::cut(std::string caption, std::size_t axis) const {
    const auto [low, high] = box(points_);
    const double at = 0.5 * (low[axis] + high[axis]);
    const bool zero = std::fabs(at) < 1e-6 * (high[axis] - low[axis]);
    return cut_picture(cells(), inside(), points_, axis, at,
                       std::move(caption) + ", cut at " + "xyz"[axis] + " = " + readable(zero ? 0 : at), domain_);
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

Picture cut(const Mesh_3& mesh, std::string caption, Cut_axis& axis) {
    const std::size_t now = axis.value_or(mesh.shortest_side());
    if (!mesh.points().empty()) axis = now;
    return mesh.cut(std::move(caption), now);
}

}  // namespace

Picture picture_of(const Moving_mesh_3& dt, std::string caption, Cut_axis& axis) {
    Mesh_3 mesh;
    mesh.read(dt);
    return cut(mesh, std::move(caption), axis);
}

Picture picture_of(const Boxed_mesh<3>& dt, std::string caption, Cut_axis& axis) {
    Solid_mesh<3> solid = solid_mesh(dt);
    Mesh_3 mesh;
    mesh.read(std::move(solid.points), std::move(solid.cells));
    return cut(mesh, std::move(caption) + with_images, axis);
}

}  // namespace annulus::inline v1::cli
