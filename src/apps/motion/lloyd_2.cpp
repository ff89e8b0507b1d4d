// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/lloyd_2.h>

#include <annulus/error.h>
#include <annulus/mesh/parallel_runs.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/region_cell_2.h>
#include <apps/motion/voronoi_cell_2.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

/// Vertices are processed in runs of this many, with one work space each; sums are added run by run, in order, so that
/// they do not depend on which thread processed which run.
constexpr std::size_t run_length = 256;

struct Partial {
    double sum = 0, max = 0;
    std::size_t count = 0, kept = 0;
};

/// The greatest distance of a cell's corners from the first. The size of a cell that contains its vertex is about the
/// distance of its centroid. A cell that is a point up to rounding belongs to a vertex outside the domain and touches
/// the domain there, and so may the cell of a neighbour: both vertices would have the same target.
double reach(const Cell_2& cell) {
    double most = 0;
    for (const Corner_2& corner : cell.corners)
        most = std::max(most, std::hypot(corner.offset[0] - cell.corners[0].offset[0],
                                         corner.offset[1] - cell.corners[0].offset[1]));
    return most;
}

/// The target of the vertex of a cell, if it has one, and its distance.
struct Target {
    Coordinates<2> place{};
    double way = 0;
};

bool target_of(const Voronoi_cell_2& cell_of, const Cell_2& cell, const Coordinates<2>& from, const Domain_2& domain,
               const Density_2& density, Target& found) {
    Coordinates<2> offset;
    if (cell_of.plump()) {
        // The cell is well shaped and lengths are those of the domain: no check of the centroid's place is needed, nor
        // hypot.
        const Moments_2 m = moments(density, cell.origin, cell.corners);
        if (!(m.mass > 0)) return false;
        offset = {m.first[0] / m.mass, m.first[1] / m.mass};
        found = {{cell.origin[0] + offset[0], cell.origin[1] + offset[1]}, 0};
        const double x = found.place[0] - from[0], y = found.place[1] - from[1];
        found.way = std::sqrt(x * x + y * y);
        return domain.contains(found.place);
    }
    if (!centroid(density, cell, offset)) return false;
    found = {{cell.origin[0] + offset[0], cell.origin[1] + offset[1]}, 0};
    found.way = std::hypot(found.place[0] - from[0], found.place[1] - from[1]);
    return domain.contains(found.place) && reach(cell) > 1e-12 * found.way;
}

/// The same in a domain that is not convex; `parts` are those of the cell in it.
bool target_of(std::span<const Cell_2> parts, const Cell_2& cell, const Coordinates<2>& from, const Region_2& domain,
               const Density_2& density, Target& found) {
    const Moments_2 m = moments(density, cell.origin, parts);
    if (!(m.mass > 0)) return false;
    const Coordinates<2> offset{m.first[0] / m.mass, m.first[1] / m.mass};
    found.place = {cell.origin[0] + offset[0], cell.origin[1] + offset[1]};
    if (!domain.contains(found.place)) found.place = nearest_inside(parts, found.place);
    found.way = std::hypot(found.place[0] - from[0], found.place[1] - from[1]);
    return domain.contains(found.place) && reach(cell) > 1e-12 * found.way;
}

void require_sizes(std::size_t lists, std::size_t positions, std::size_t targets) {
    if (positions != lists || targets != lists)
        throw Error(Error_code::wrong_size, "Lloyd needs a position and a target for every vertex");
}

bool is_cyclic(const Neighbours_2& lists, std::size_t v) { return lists.hull[v] == 0; }
bool is_cyclic(const Stars_2& lists, std::size_t v) { return lists.cyclic(v); }

}  // namespace

bool centroid(const Density_2& density, const Cell_2& cell, Coordinates<2>& offset) {
    const Moments_2 m = moments(density, cell.origin, cell.corners);
    if (!(m.mass > 0)) return false;
    offset = {m.first[0] / m.mass, m.first[1] / m.mass};
    const std::size_t n = cell.corners.size();
    double square = 0;
    for (const Corner_2& corner : cell.corners)
        square = std::max(square, corner.offset[0] * corner.offset[0] + corner.offset[1] * corner.offset[1]);
    // Not 0: where neighbours are cocircular two corners nearly coincide, and the direction of the edge between them is
    // noise.
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

Lloyd_2::Lloyd_2(Region_2 domain, Density_2 density, int threads, Kept_border_2 border)
    : domain_(std::move(domain)), density_(std::move(density)), threads_(threads), border_(std::move(border)) {
    require_density(density_, domain_.hull());
    if (threads < 1) throw Error(Error_code::usage, "Lloyd needs at least 1 thread");
}

/// Writes to `way` the distance to the target of each vertex, negative for those that stay; where remembered(v) it is
/// there already, and so is the target.
template <class Lists, class Remembered>
Lloyd_step Lloyd_2::step_over(const Lists& lists, std::span<const Coordinates<2>> position,
                              std::span<Coordinates<2>> target, std::vector<double>& way, Remembered remembered) const {
    const std::size_t n = lists.size();
    std::vector<Partial> partial((n + run_length - 1) / run_length);
    for_each_run(n, run_length, threads_, [&](std::size_t first, std::size_t last) {
        Voronoi_cell_2 cell_of(domain_.hull());
        std::optional<Region_cell_2> parts_of;
        if (!domain_.convex()) parts_of.emplace(domain_);
        Partial sums;
        for (std::size_t v = first; v < last; ++v) {
            const auto around = lists.of(v);
            if (around.empty() && n > 1) {
                target[v] = position[v];
                continue;
            }
            ++sums.count;
            if (!remembered(v)) {
                Target found;
                const Cell_2& cell = cell_of(position[v], around, position, is_cyclic(lists, v));
                const bool goes = parts_of ? target_of((*parts_of)(cell), cell, position[v], domain_, density_, found)
                                           : target_of(cell_of, cell, position[v], domain_.hull(), density_, found);
                if (goes && border_.has(v)) {
                    found.place = border_.along(v, position[v], found.place);
                    found.way = std::hypot(found.place[0] - position[v][0], found.place[1] - position[v][1]);
                }
                target[v] = goes ? found.place : position[v];
                way[v] = goes ? found.way : -1;
            }
            if (way[v] < 0) {
                ++sums.kept;
                continue;
            }
            sums.sum += way[v];
            sums.max = std::max(sums.max, way[v]);
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

Lloyd_step Lloyd_2::step(const Neighbours_2& neighbours, std::span<const Coordinates<2>> position,
                         std::span<Coordinates<2>> target) const {
    require_sizes(neighbours.size(), position.size(), target.size());
    std::vector<double> way(neighbours.size());
    return step_over(neighbours, position, target, way, [](std::size_t) { return false; });
}

/// Whether enough vertices rest for the memory to be worth while. Stores the positions in the memory.
bool Lloyd_2::find_moved(const Stars_2& stars, std::span<const Coordinates<2>> position, Lloyd_memory& memory) const {
    const std::size_t n = position.size();
    const bool known = memory.position_.size() == n && memory.readings_ <= stars.readings();
    memory.position_.resize(n);
    memory.target_.resize(n);
    memory.way_.resize(n, -1);
    memory.moved_.assign(n, 1);
    std::vector<std::size_t> rest((n + run_length - 1) / run_length);
    for_each_run(n, run_length, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) {
            memory.moved_[v] = memory.position_[v] != position[v];
            rest[first / run_length] += memory.moved_[v] == 0;
            memory.position_[v] = position[v];
        }
    });
    return known && 4 * std::accumulate(rest.begin(), rest.end(), std::size_t{0}) >= n;
}

Lloyd_step Lloyd_2::step(const Stars_2& stars, std::span<const Coordinates<2>> position,
                         std::span<Coordinates<2>> target, Lloyd_memory& memory) const {
    require_sizes(stars.size(), position.size(), target.size());
    const bool asking = find_moved(stars, position, memory);
    const auto moved = [&](Index u) { return memory.moved_[static_cast<std::size_t>(u)] != 0; };
    const auto remembered = [&](std::size_t v) {
        if (!asking || memory.moved_[v] != 0 || stars.since(v) > memory.readings_) return false;
        const auto around = stars.of(v);
        if (std::any_of(around.begin(), around.end(), moved)) return false;
        target[v] = memory.target_[v];
        return true;
    };
    const Lloyd_step step = step_over(stars, position, target, memory.way_, remembered);
    std::copy(target.begin(), target.end(), memory.target_.begin());
    memory.readings_ = stars.readings();
    return step;
}

}  // namespace annulus::inline v1
