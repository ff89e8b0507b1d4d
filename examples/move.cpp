// SPDX-License-Identifier: GPL-3.0-or-later
// [docs]
#include <annulus/moving_delaunay_2.h>

#include <cmath>
#include <iostream>
#include <vector>

int main() {
    using Point = annulus::Moving_delaunay_2::Point;
    std::vector<Point> points;  // a sunflower
    for (int i = 0; i < 1000; ++i)
        points.emplace_back(std::sqrt(i) * std::cos(2.39996 * i), std::sqrt(i) * std::sin(2.39996 * i));

    annulus::Moving_delaunay_2 dt(points.begin(), points.end());
    std::cout << "vertex 500 may go " << dt.tolerance(dt.vertex(500)) << " before anything is computed\n";

    for (int step = 0; step < 3; ++step) {
        for (Point& p : points) p = Point(p.x() + 0.01 * std::sin(p.y()), p.y());  // a gentle shear
        const annulus::Move_result report = dt.move_all(points);
        std::cout << report.moves.within_tolerance << " within tolerance, " << report.moves.kept_in_place
                  << " kept in place, " << report.moves.flipped << " flipped; " << report.statistics.evaluated
                  << " certificates evaluated\n";
    }
    dt.move(dt.vertex(500), Point(40, 40));  // handles stay valid wherever a vertex goes
    std::cout << dt.triangulation().number_of_faces() << " triangles, Delaunay: " << std::boolalpha
              << dt.audit().delaunay() << "\n";
    return dt.audit().delaunay() ? 0 : 1;
}
// [docs]
