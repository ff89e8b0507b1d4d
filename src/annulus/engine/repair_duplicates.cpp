// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a vertex would come to the position of another one.
#include <annulus/engine/repair.h>

#include <annulus/mesh/at.h>

#include <cmath>

namespace annulus::inline v1 {

namespace {

// These distances do not underflow.
double distance(const Coordinates<2>& a, const Coordinates<2>& b) {
    const auto [x, y] = Euclidean<2>::difference(a, b);
    return std::hypot(x, y);
}
double distance(const Coordinates<3>& a, const Coordinates<3>& b) {
    const auto [x, y, z] = Euclidean<3>::difference(a, b);
    return std::hypot(x, y, z);
}

}  // namespace

/// Whether another vertex is at the target of the mover, whose cells are still those of its source. Walks from
/// neighbour to neighbour, always nearer: in a Delaunay triangulation this ends at the nearest vertex. What rounding
/// misses is found by the rebuild that follows when nothing else helps.
template <int d>
bool Repair<d>::is_occupied(Step<d>& step) {
    const Index v = step.mover;
    const auto& t = mesh_.table();
    const Coordinates<d>& target = step.x[at(v)];
    Index nearest = v;
    double least = distance(step.source, target);
    for (Index from = none; from != nearest;) {
        from = nearest;
        t.for_each_corner(from, [&](Corner_index h) {
            const Cell_index c = t.cell_of(h);
            step.budget.charge(1.0);
            for (int i = 0; i <= d; ++i) {
                const Index w = t.vertex(t.corner(c, i));
                if (w == infinite || w == v) continue;
                const double here = distance(step.x[at(w)], target);
                if (!(here < least)) continue;
                least = here;
                nearest = w;
            }
        });
    }
    return nearest != v && step.x[at(nearest)] == target;
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus::inline v1
