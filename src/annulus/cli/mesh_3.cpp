// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/mesh_3.h>

#include <annulus/report/cut_picture.h>

#include <algorithm>
#include <utility>

namespace annulus::cli {

namespace {

/// The same cell with its least vertex first and the least of the others second: one of the orders that keep its orientation.
std::array<Index, 4> in_order(std::array<Index, 4> c) {
    const auto exchange = [&c](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {  // two swaps: even
        std::swap(c[i], c[j]);
        std::swap(c[k], c[l]);
    };
    const auto least = static_cast<std::size_t>(std::min_element(c.begin(), c.end()) - c.begin());
    if (least == 1) exchange(0, 1, 2, 3);
    if (least == 2) exchange(0, 2, 1, 3);
    if (least == 3) exchange(0, 3, 1, 2);
    std::rotate(c.begin() + 1, std::min_element(c.begin() + 1, c.end()), c.end());
    return c;
}

}  // namespace

void Mesh_3::read(const Moving_delaunay_3& dt) {
    Audit_input<3> in = dt.audit_input();
    points = std::move(in.points);
    std::erase_if(in.cells, [](const auto& c) { return c[3] == none; });  // the simplices of a flat set
    for (auto& c : in.cells) c = in_order(c);
    std::sort(in.cells.begin(), in.cells.end());
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
