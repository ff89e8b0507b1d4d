// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/generated_points.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

template <int d>
Coordinates<d> uniform_point(Portable_random& random) {
    Coordinates<d> p;
    for (double& c : p) c = random.unit();
    return p;
}

/// A point on the sphere in the cube: the direction of a uniform point of the ball inside.
template <int d>
Coordinates<d> point_on_sphere(Portable_random& random) {
    while (true) {
        Coordinates<d> p;
        double square = 0;
        for (double& c : p) {
            c = 2 * random.unit() - 1;
            square += c * c;
        }
        if (square > 1 || square < 0.01) continue;
        const double length = std::sqrt(square);
        for (double& c : p) c = 0.5 + 0.5 * c / length;
        return p;
    }
}

template <int d>
std::vector<Coordinates<d>> grid(std::size_t n) {
    const std::size_t side = grid_side<d>(n);
    std::vector<Coordinates<d>> points(n);
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t rest = i;
        for (double& c : points[i]) {
            c = (static_cast<double>(rest % side) + 0.5) / static_cast<double>(side);
            rest /= side;
        }
    }
    return points;
}

}  // namespace

template <int d>
std::vector<Point_of_cluster<d>> points_of_clusters(std::size_t n, std::uint64_t seed) {
    Portable_random random(seed);
    struct Cluster {
        Coordinates<d> centre;
        double width;
    };
    std::vector<Cluster> all(n / 100 + 1);
    for (Cluster& c : all) {
        c.centre = uniform_point<d>(random);
        c.width = 0.1;
        for (std::size_t decade = random.below(7); decade > 0; --decade) c.width /= 10;
    }
    std::vector<Point_of_cluster<d>> points(n);
    for (auto& p : points) {
        const Cluster& c = all[random.below(all.size())];
        p.centre = c.centre;
        for (double& x : p.offset) x = c.width * random.bell();
    }
    return points;
}

template <int d>
std::size_t grid_side(std::size_t n) {
    std::size_t side = 1;
    const auto holds = [&] {
        std::size_t all = 1;
        for (int k = 0; k < d; ++k) all *= side;
        return all;
    };
    while (holds() < n) ++side;
    return side;
}

double Portable_random::bell() {
    double sum = -2;
    for (int i = 0; i < 4; ++i) sum += unit();
    return sum * std::sqrt(3.0);  // a uniform number has a variance of a twelfth
}

template <int d>
std::vector<Coordinates<d>> generate(Point_family family, std::size_t n, std::uint64_t seed) {
    Portable_random random(seed);
    std::vector<Coordinates<d>> points(n);
    switch (family) {
        case Point_family::grid:
        case Point_family::jittered: {
            points = grid<d>(n);
            const double most = family == Point_family::grid ? 0 : 0.25 / static_cast<double>(grid_side<d>(n));
            if (most > 0)
                for (auto& p : points)
                    for (double& c : p) c += most * (2 * random.unit() - 1);
            break;
        }
        case Point_family::cospherical:
            for (auto& p : points) p = point_on_sphere<d>(random);
            break;
        case Point_family::surface:
            for (auto& p : points) {
                p = point_on_sphere<d>(random);
                for (std::size_t k = 1; k < d; ++k) p[k] = 0.5 + (p[k] - 0.5) * (k == 1 ? 0.8 : 0.6);
            }
            break;
        case Point_family::clusters: {
            const auto placed = points_of_clusters<d>(n, seed);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t k = 0; k < d; ++k) points[i][k] = placed[i].centre[k] + placed[i].offset[k];
            break;
        }
        default:
            for (auto& p : points) p = uniform_point<d>(random);
    }
    return points;
}

template std::size_t grid_side<2>(std::size_t);
template std::size_t grid_side<3>(std::size_t);
template std::vector<Point_of_cluster<2>> points_of_clusters<2>(std::size_t, std::uint64_t);
template std::vector<Point_of_cluster<3>> points_of_clusters<3>(std::size_t, std::uint64_t);
template std::vector<Coordinates<2>> generate<2>(Point_family, std::size_t, std::uint64_t);
template std::vector<Coordinates<3>> generate<3>(Point_family, std::size_t, std::uint64_t);

}  // namespace annulus::inline v1
