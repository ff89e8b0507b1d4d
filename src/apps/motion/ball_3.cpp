// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/ball_3.h>

#include <annulus/error.h>
#include <apps/motion/vectors_3.h>

#include <cmath>
#include <numbers>
#include <random>

namespace annulus::inline v1 {

Ball_3::Ball_3(double radius) : radius_(radius) {
    if (!(radius >= 1e-100 && radius <= 1e100))
        throw Error(Error_code::usage, "the radius must be between 1e-100 and 1e100");
}

bool Ball_3::contains(const Coordinates<3>& p) const { return dot(p, p) < radius_ * radius_; }

Coordinates<3> Ball_3::project(const Coordinates<3>& p) const {
    const double length = std::hypot(p[0], p[1], p[2]);
    if (!(length > 0)) return {radius_, 0, 0};
    const double s = radius_ / length;
    return {s * p[0], s * p[1], s * p[2]};
}

std::optional<Coordinates<3>> Ball_3::crossing(const Coordinates<3>& a, const Coordinates<3>& b) const {
    // |a + t e|² = r²
    const Coordinates<3> e{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double ee = dot(e, e), ae = dot(a, e), c = dot(a, a) - radius_ * radius_;
    const double discriminant = ae * ae - ee * c;
    if (!(ee > 0 && discriminant >= 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    // The larger of the two in magnitude without cancellation, the other from their product.
    const double q = ae > 0 ? -ae - root : -ae + root;
    for (const double t : {q / ee, q != 0 ? c / q : 0.0})
        if (t >= 0 && t <= 1) return project({a[0] + t * e[0], a[1] + t * e[1], a[2] + t * e[2]});
    return std::nullopt;
}

std::vector<Coordinates<3>> Ball_3::surface_sample(std::size_t n, std::uint64_t seed) const {
    std::mt19937_64 bits(seed);
    const auto number = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
    std::vector<Coordinates<3>> points;
    while (points.size() < n) {
        const double x = number(), y = number(), z = number();
        const double square = x * x + y * y + z * z;
        if (square <= 1 && square > 0.01) points.push_back(project({x, y, z}));
    }
    return points;
}

Domain_3::Box Ball_3::bounding_box() const { return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}}; }

double Ball_3::volume() const { return 4 * std::numbers::pi / 3 * radius_ * radius_ * radius_; }

}  // namespace annulus::inline v1
