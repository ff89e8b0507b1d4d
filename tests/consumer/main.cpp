// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/moving_delaunay_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

int main() {
    std::vector<Point> points;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) points.emplace_back(i + 0.1 * (j % 3), j + 0.1 * (i % 4));

    annulus::Moving_delaunay_2 dt(points.begin(), points.end());

    // One vertex, then all of them.
    const auto v = dt.vertex(7);
    const Point there(0.03, 7.02);
    [[maybe_unused]] const auto report = dt.move(v, there);
    if (dt.index(v) != 7 || dt.position(v) != there) {
        std::cerr << "vertex 7 is not where it was moved\n";
        return 1;
    }

    std::vector<Point> moved;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle = 0.05 * static_cast<double>(i % 5);
        moved.emplace_back(points[i].x() - angle * points[i].y(), points[i].y() + angle * points[i].x());
    }
    dt.move_all(moved);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (dt.position(dt.vertex(static_cast<int>(i))) != moved[i]) {
            std::cerr << "vertex " << i << " is not where it was moved\n";
            return 1;
        }
    }

    if (!dt.audit().delaunay()) {
        std::cerr << "not Delaunay after the moves\n";
        return 1;
    }
    std::cout << "consumer: " << points.size() << " points moved, Delaunay\n";
    return 0;
}
