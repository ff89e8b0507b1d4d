// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/lloyd_2.h>

#include <annulus/arithmetic/error.h>
#include <annulus/motion/moments_2.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/motion/voronoi_cell_2.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace annulus {

namespace {

/// Vertices are worked on in runs of this many, with one work space each; sums are added run by run, in order, so that
/// they do not depend on which thread did which run.
constexpr std::size_t run_length = 256;

struct Partial {
    double sum = 0, max = 0;
    std::size_t count = 0, kept = 0;
};

/// How far a cell's corners are from the first, at most. A cell that contains its vertex is about as large as its centroid
/// is far. One that is a point up to rounding belongs to a vertex outside of the domain and touches it there, and so
/// may the cell of a neighbour: both vertices would go to one place.
double reach(const Cell_2& cell) {
    double most = 0;
    for (const Corner_2& corner : cell.corners)
        most = std::max(most, std::hypot(corner.offset[0] - cell.corners[0].offset[0],
                                         corner.offset[1] - cell.corners[0].offset[1]));
    return most;
}

}  // namespace

bool centroid(Density density, const Cell_2& cell, Coordinates<2>& offset) {
    const Moments_2 m = moments(density, cell.origin, cell.corners);
    if (!(m.mass > 0)) return false;
    offset = {m.first[0] / m.mass, m.first[1] / m.mass};
    const std::size_t n = cell.corners.size();
    double square = 0;
    for (const Corner_2& corner : cell.corners)
        square = std::max(square, corner.offset[0] * corner.offset[0] + corner.offset[1] * corner.offset[1]);
    // Not 0: where neighbours are cocircular two corners nearly coincide, and the edge between them points anywhere.
    const double slack = -1e-12 * square;
    bool inside = std::isfinite(offset[0]) && std::isfinite(offset[1]);
    for (std::size_t i = 0; inside && i < n; ++i) {
        if (cell.corners[i].arc) continue;  // a chord: the region goes beyond it
        const Coordinates<2>& a = cell.corners[i].offset;
        const Coordinates<2>& b = cell.corners[i + 1 < n ? i + 1 : 0].offset;
        inside = (b[0] - a[0]) * (offset[1] - a[1]) - (b[1] - a[1]) * (offset[0] - a[0]) >= slack;
    }
    if (inside) return true;
    offset = {0, 0};
    for (const Corner_2& corner : cell.corners)
        for (std::size_t k = 0; k < 2; ++k) offset[k] += corner.offset[k] / static_cast<double>(n);
    return true;
}

Lloyd_2::Lloyd_2(Domain_2 domain, Density density, int threads)
    : domain_(std::move(domain)), density_(density), threads_(threads) {
    if (threads < 1) throw Error(Error_code::usage, "Lloyd needs at least 1 thread");
}

Lloyd_step Lloyd_2::step(const Neighbours_2& neighbours, std::span<const Coordinates<2>> position,
                         std::span<Coordinates<2>> target) const {
    const std::size_t n = neighbours.size();
    if (position.size() != n || target.size() != n)
        throw Error(Error_code::wrong_size, "Lloyd needs a position and a target for every vertex");
    std::vector<Partial> partial((n + run_length - 1) / run_length);

    for_each_run(n, run_length, threads_, [&](std::size_t first, std::size_t last) {
        Voronoi_cell_2 cell_of(domain_);
        Partial sums;
        for (std::size_t v = first; v < last; ++v) {
            target[v] = position[v];
            const auto around = neighbours.of(v);
            if (around.empty() && n > 1) continue;
            ++sums.count;
            const Cell_2& cell = cell_of(position[v], around, position, neighbours.hull[v] == 0);
            Coordinates<2> offset;
            if (!centroid(density_, cell, offset)) {
                ++sums.kept;
                continue;
            }
            const Coordinates<2> wanted{cell.origin[0] + offset[0], cell.origin[1] + offset[1]};
            const double moved = std::hypot(wanted[0] - position[v][0], wanted[1] - position[v][1]);
            if (!domain_.contains(wanted) || !(reach(cell) > 1e-12 * moved)) {
                ++sums.kept;
                continue;
            }
            target[v] = wanted;
            sums.sum += moved;
            sums.max = std::max(sums.max, moved);
        }
        partial[first / run_length] = sums;
    });

    Partial total;
    for (const Partial& p : partial) {
        total.sum += p.sum;
        total.max = std::max(total.max, p.max);
        total.count += p.count;
        total.kept += p.kept;
    }
    return {total.count > 0 ? total.sum / static_cast<double>(total.count) : 0, total.max, total.kept};
}

}  // namespace annulus
