// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/mesh_3.h>

#include <annulus/io/cut_picture.h>

#include <algorithm>
#include <utility>

namespace annulus::cli {

void Mesh_3::read(const Moving_delaunay_3& dt) {
    Audit_input<3> in = dt.audit_input();
    points = std::move(in.points);
    std::erase_if(in.cells, [](const auto& c) { return c[3] == none; });  // the simplices of a flat set
    cells = linked(std::move(in.cells), points.size());
    inside.assign(cells.size(), 1);
}

void Mesh_3::read(const Moving_delaunay_3& dt, bool cells_changed, const Domain_3& domain, int threads) {
    if (cells_changed) read(dt);
    else points.assign(dt.positions().begin(), dt.positions().end());
    inside = cells_inside(domain, cells, points, threads);
}

Picture Mesh_3::cut(std::string caption) const {
    Coordinates<3> low{}, high{};
    if (!points.empty()) low = high = points[0];
    for (const auto& p : points)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    std::size_t axis = 2;
    for (std::size_t k = 0; k < 3; ++k)
        if (high[k] - low[k] < high[axis] - low[axis]) axis = k;
    const double at = 0.5 * (low[axis] + high[axis]);
    return cut_picture(cells, inside, points, axis, at, std::move(caption) + ", cut across " + "xyz"[axis]);
}

}  // namespace annulus::cli
