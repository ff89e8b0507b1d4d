// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/boxed_points.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

/// The area of a parallelogram of two vectors.
double face(const Coordinates<3>& a, const Coordinates<3>& b) {
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return std::sqrt(x * x + y * y + z * z);
}
double thickness(const Box<2>& box) {
    const auto& [a, b] = box.vectors();
    const auto length = [](const Coordinates<2>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); };
    return box.volume() / std::max(length(a), length(b));
}
double thickness(const Box<3>& box) {
    const auto& [a, b, c] = box.vectors();
    return box.volume() / std::max({face(a, b), face(b, c), face(c, a)});
}

/// The position of the unit square or cube that these shares of the box's vectors give.
template <int d>
Coordinates<d> at_shares(const Box<d>& box, const Coordinates<d>& share) {
    Coordinates<d> p{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < d; ++k) p[k] += share[i] * box.vectors()[i][k];
    return p;
}

template <int d>
std::vector<Coordinates<d>> clusters_in(const Box<d>& box, std::size_t n, std::uint64_t seed) {
    const double size = spacing_in(box, 1);
    std::vector<Coordinates<d>> points;
    points.reserve(n);
    for (const auto& [centre, offset] : points_of_clusters<d>(n, seed)) {
        points.push_back(at_shares(box, centre));
        for (std::size_t k = 0; k < d; ++k) points.back()[k] += size * offset[k];
    }
    return points;
}

}  // namespace

template <int d>
double root_of(double x) {
    if (d == 2) return std::sqrt(x);
    double y = std::ldexp(1.0, std::ilogb(x) / 3 + 1);  // not below the root: Newton's method descends
    while (true) {
        const double next = (2 * y + x / (y * y)) / 3;
        if (!(next < y)) return y;
        y = next;
    }
}

template <int d>
double spacing_in(const Box<d>& box, std::size_t n) {
    return root_of<d>(box.volume() / static_cast<double>(n));
}

template <int d>
std::vector<Coordinates<d>> generate_in(const Box<d>& box, Point_family family, std::size_t n, std::uint64_t seed) {
    if (family == Point_family::clusters) return clusters_in(box, n, seed);
    std::vector<Coordinates<d>> points = generate<d>(family, n, seed);
    if (family == Point_family::cospherical || family == Point_family::surface) {
        Coordinates<d> half;
        half.fill(0.5);
        const Coordinates<d> middle = at_shares(box, half);
        const double width = thickness(box) / 2;
        for (auto& p : points)
            for (std::size_t k = 0; k < d; ++k) p[k] = middle[k] + width * (p[k] - 0.5);
    } else {
        for (auto& p : points) p = at_shares(box, p);
    }
    return points;
}

template double root_of<2>(double);
template double root_of<3>(double);
template double spacing_in<2>(const Box<2>&, std::size_t);
template double spacing_in<3>(const Box<3>&, std::size_t);
template std::vector<Coordinates<2>> generate_in<2>(const Box<2>&, Point_family, std::size_t, std::uint64_t);
template std::vector<Coordinates<3>> generate_in<3>(const Box<3>&, Point_family, std::size_t, std::uint64_t);

}  // namespace annulus::inline v1
