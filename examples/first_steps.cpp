// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ example of README.md: points move, and the triangulation follows.
#include <annulus/moving_delaunay_2.h>

#include <cmath>
#include <iostream>
#include <vector>

using Point = annulus::Moving_delaunay_2::Point;

static void move_a_little(std::vector<Point>& points) {
    for (Point& p : points) p = Point(p.x() + 0.01 * std::sin(p.y()), p.y());  // a gentle shear
}

int main() {
    std::vector<Point> points;  // a sunflower
    for (int i = 0; i < 1000; ++i)
        points.emplace_back(std::sqrt(i) * std::cos(2.39996 * i), std::sqrt(i) * std::sin(2.39996 * i));
    // [docs]
    annulus::Moving_delaunay_2 dt(points.begin(), points.end());
    for (int step = 0; step < 100; ++step) {
        move_a_little(points);
        dt.move_all(points);                   // for most points one comparison
        const auto& now = dt.triangulation();  // CGAL's, at the new places: circulate, locate, draw the dual
        auto v = now.incident_vertices(dt.vertex(7)), first = v;
        do std::cout << dt.index(v) << ' ';  // the neighbours of point 7
        while (++v != first);
    }
    // [docs]
    std::cout << "\n";
    return dt.audit().delaunay() ? 0 : 1;
}
