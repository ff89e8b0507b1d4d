// SPDX-License-Identifier: GPL-3.0-or-later
// [docs]
#include <annulus/moving_delaunay_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;  // or yours, with any triangulation data structure

int main() {
    Delaunay before;
    for (int i = 0; i < 1000; ++i)
        before.insert(Kernel::Point_2(std::sqrt(i) * std::cos(2.39996 * i), std::sqrt(i) * std::sin(2.39996 * i)));

    annulus::Moving_delaunay<Delaunay> dt(before);

    // One vertex, as before.
    const Delaunay::Vertex_handle v = dt.vertex(500), w = dt.vertex(501);
    if (dt.move_if_no_collision(v, Kernel::Point_2(40, 40)) != v) return 1;
    if (dt.move_if_no_collision(v, dt.position(w)) != w) return 1;  // w is there, and nothing has changed

    // All vertices in one step, where a loop of move_if_no_collision was.
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i < dt.number_of_vertices(); ++i) points.push_back(dt.position(dt.vertex(i)));
    for (int step = 0; step < 3; ++step) {
        for (Kernel::Point_2& p : points) p = Kernel::Point_2(p.x() + 0.01 * std::sin(p.y()), p.y());
        const annulus::Move_result result = dt.move_all(points);
        std::cout << result.moves.within_tolerance << " of " << result.moves.asked << " within tolerance\n";
    }

    const Delaunay& after = dt.triangulation();  // call it again after each change
    std::cout << after.number_of_faces() << " triangles\n";
    return after.is_valid() ? 0 : 1;
}
// [docs]
