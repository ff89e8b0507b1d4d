// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/sampling_2.h>

#include <annulus/arithmetic/error.h>

#include <algorithm>
#include <bit>
#include <random>
#include <unordered_set>
#include <utility>

namespace annulus {

namespace {

/// Uniform points of a domain.
class Uniform {
  public:
    Uniform(const Domain_2& domain, std::uint64_t seed) : domain_(domain), bits_(seed) {
        const auto corners = domain.corners();
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Coordinates<2> a = side(i), b = side(i + 1);
            area_up_to_.push_back((area_up_to_.empty() ? 0 : area_up_to_.back()) + (a[0] * b[1] - a[1] * b[0]));
        }
    }

    /// In [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

    /// A point that is in the domain up to rounding; for a disc it may be outside.
    Coordinates<2> point() {
        double s = unit(), t = unit();
        if (domain_.kind() == Domain_2::Kind::disc)
            return {(2 * s - 1) * domain_.radius(), (2 * t - 1) * domain_.radius()};
        const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end(), unit() * area_up_to_.back());
        const auto at = std::min(static_cast<std::size_t>(found - area_up_to_.begin()), area_up_to_.size() - 1);
        if (s + t > 1) s = 1 - s, t = 1 - t;  // fold the parallelogram onto the triangle
        const Coordinates<2>& p = domain_.corners()[0];
        const Coordinates<2> a = side(at + 1), b = side(at + 2);
        return {p[0] + s * a[0] + t * b[0], p[1] + s * a[1] + t * b[1]};
    }

  private:
    Coordinates<2> side(std::size_t i) const {
        const auto corners = domain_.corners();
        return {corners[i][0] - corners[0][0], corners[i][1] - corners[0][1]};
    }

    const Domain_2& domain_;
    std::mt19937_64 bits_;
    std::vector<double> area_up_to_;
};

struct Hash {
    std::size_t operator()(const Coordinates<2>& p) const {
        const std::uint64_t a = std::bit_cast<std::uint64_t>(p[0]), b = std::bit_cast<std::uint64_t>(p[1]);
        return static_cast<std::size_t>((a ^ std::rotl(b, 29)) * 0x9E3779B97F4A7C15u);
    }
};

}  // namespace

namespace {

/// Every other bit of the result is a bit of i.
std::uint64_t spread_bits(std::uint64_t i) {
    i = (i | (i << 16)) & 0x0000ffff0000ffffULL;
    i = (i | (i << 8)) & 0x00ff00ff00ff00ffULL;
    i = (i | (i << 4)) & 0x0f0f0f0f0f0f0f0fULL;
    i = (i | (i << 2)) & 0x3333333333333333ULL;
    return (i | (i << 1)) & 0x5555555555555555ULL;
}

/// Morton's order (Z curve) on a grid of 2^16 by 2^16 over the box.
void sort_along_curve(std::vector<Coordinates<2>>& points, const Domain_2::Box& box) {
    std::vector<std::pair<std::uint64_t, Coordinates<2>>> keyed;
    keyed.reserve(points.size());
    const auto cell = [&](double c, std::size_t k) {
        return static_cast<std::uint64_t>(65535.0 *
                                          std::clamp((c - box.lower[k]) / (box.upper[k] - box.lower[k]), 0.0, 1.0));
    };
    for (const auto& p : points) keyed.emplace_back(spread_bits(cell(p[0], 0)) | (spread_bits(cell(p[1], 1)) << 1), p);
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = keyed[i].second;
}

}  // namespace

std::vector<Coordinates<2>> sample(const Domain_2& domain, Density density, std::size_t n, std::uint64_t seed) {
    const double bound = density_upper_bound(density, domain.extent());
    Uniform uniform(domain, seed);
    std::vector<Coordinates<2>> points;
    points.reserve(n);
    std::unordered_set<Coordinates<2>, Hash> seen(2 * n);
    int failures = 0;
    while (points.size() < n) {
        Coordinates<2> p = uniform.point();
        p = {p[0] + 0.0, p[1] + 0.0};  // -0 equals 0 but hashes apart
        const bool kept = uniform.unit() * bound < density_at(density, p) && domain.contains(p);
        if (kept && seen.insert(p).second) {
            points.push_back(p);
            failures = 0;
        } else if (++failures == 1'000'000) {
            throw Error(Error_code::bad_input, "the domain has not that many different points");
        }
    }
    sort_along_curve(points, domain.bounding_box());
    return points;
}

}  // namespace annulus
