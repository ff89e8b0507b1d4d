// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

// Boxes of ten kinds, and points in them.
namespace annulus::testing {

class Periodic_cases {
  public:
    static constexpr int kinds = 10;
    explicit Periodic_cases(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
    }
    [[nodiscard]] std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

    /// 0 a cube; 1 orthorhombic; 2 thin; 3 flat; 4 triclinic; 5 skewed by up to 2, and 6 by a basis that is far from
    /// reduced; 7 any vectors, left-handed ones, too; 8 any thin box; 9 hexagonal.
    template <int d>
    [[nodiscard]] Box<d> box(int kind) {
        typename Box<d>::Vectors v{};
        for (std::size_t i = 0; i < d; ++i) v[i][i] = 1;
        const auto tilt = [&](double most) {
            for (std::size_t i = 0; i < d; ++i)
                for (std::size_t j = 0; j < i; ++j) v[i][j] = uniform(-most, most);
        };
        if (kind == 1)
            for (std::size_t i = 0; i < d; ++i) v[i][i] = uniform(0.6, 1.6);
        if (kind == 2) v[0][0] = 0.05;
        if (kind == 2 && d == 3) v[1][1] = 0.3;
        if (kind == 3) v[d - 1][d - 1] = 0.03;
        if (kind == 4) tilt(0.5);
        if (kind == 5) tilt(2);
        if (kind == 6)
            for (std::size_t i = 0; i < d; ++i) v[d - 1][i] += 3 * v[0][i];
        if (kind == 7 || kind == 8) return any_box<d>(kind == 8 ? 0.1 : 1);
        if (kind == 9) v[1] = {}, v[1][0] = 0.5, v[1][1] = std::sqrt(0.75);
        return Box<d>(v);
    }

    /// Vectors of which the last ones are `thin` times as long as the first ones, along the axes.
    template <int d>
    [[nodiscard]] typename Box<d>::Vectors thin(int thin_vectors, double thin) {
        typename Box<d>::Vectors v = box<d>(4).vectors();
        const auto first = static_cast<std::size_t>(d - thin_vectors);
        for (std::size_t j = first; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) v[j][i] *= i < first ? 0 : thin;
        for (std::size_t i = 0; i < d; ++i) v[0][i] += uniform(-0.4, 0.4) * v[d - 1][i];
        return v;
    }
    /// The vectors turned by random angles.
    template <int d>
    [[nodiscard]] typename Box<d>::Vectors turned(typename Box<d>::Vectors box) {
        for (std::size_t i = 0; i < d; ++i) {
            const std::size_t k = (i + 1) % d;
            const double angle = uniform(-3, 3), c = std::cos(angle), s = std::sin(angle);
            for (auto& v : box) {
                const double x = v[i];
                v[i] = c * x - s * v[k];
                v[k] = s * x + c * v[k];
            }
        }
        return box;
    }

    /// A point with coordinates up to `far` in the box's vectors.
    template <int d>
    [[nodiscard]] Coordinates<d> point(const Box<d>& box, double far) {
        Coordinates<d> p{};
        for (const auto& v : box.vectors()) {
            const double f = uniform(-far, far);
            for (std::size_t i = 0; i < d; ++i) p[i] += f * v[i];
        }
        return p;
    }
    template <int d>
    [[nodiscard]] std::vector<Coordinates<d>> points(const Box<d>& box, std::size_t n, double far = 3) {
        std::vector<Coordinates<d>> x(n);
        for (auto& p : x) p = point<d>(box, far);
        return x;
    }

  private:
    /// Any vectors, one axis times `thin`, that are not too skewed.
    template <int d>
    [[nodiscard]] Box<d> any_box(double thin) {
        for (;;) {
            typename Box<d>::Vectors v;
            for (auto& row : v)
                for (double& c : row) c = uniform(-1, 1);
            for (auto& row : v) row[0] *= thin;
            try {
                if (const Box<d> box(v); box.volume() > 0.005 * thin) return box;
            } catch (const Error&) {  // too skewed
            }
        }
    }
    std::mt19937_64 random_;
};

/// Multiples of 2^-20, so that sums of a few of them and of vectors of a box are doubles.
template <std::size_t d>
[[nodiscard]] std::array<double, d> coarse(std::array<double, d> p) {
    for (double& c : p) c = std::ldexp(std::floor(std::ldexp(c, 20)), -20);
    return p;
}

}  // namespace annulus::testing
