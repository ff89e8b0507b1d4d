// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A periodic box that changes step after step; the seed says how.

#include <support/generators.h>
#include <support/periodic_boxes.h>

#include <annulus/box.h>
#include <annulus/error.h>
#include <annulus/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace annulus::soak {

enum class Box_motion_kind { still, strain, shear, collapse, turn, bases };

/// Points keep their coordinates in the vectors of the box, but for another basis of its lattice: at().
template <int d>
class Box_motion {
  public:
    using Vectors = typename Box<d>::Vectors;

    explicit Box_motion(testing::Random& random)
        : random_(random()),
          kind_(static_cast<Box_motion_kind>(random() % 6)),
          omega_(std::exp2(testing::between(random, -12, -4))),
          shape_(shape(random(), kind_)),
          carrying_(shape_),
          vectors_(shape_) {}

    [[nodiscard]] Box<d> box(double scale) const {
        Vectors v = vectors_;
        for (auto& row : v)
            for (double& c : row) c *= scale;
        return Box<d>(v);
    }
    /// A point by its coordinates in the vectors that carry the points.
    [[nodiscard]] Coordinates<d> at(const Coordinates<d>& f) const {
        Coordinates<d> p{};
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) p[i] += f[j] * carrying_[j][i];
        return p;
    }

    /// Where the next box would be refused, as too skewed, it stays.
    void advance() {
        const Vectors vectors = vectors_, carrying = carrying_;
        go_on();
        if (is_possible(vectors_)) return;
        vectors_ = vectors;
        carrying_ = carrying;
    }

  private:
    static bool is_possible(const Vectors& vectors) {
        try {
            (void)Box<d>(vectors);
            return true;
        } catch (const Error&) {
            return false;
        }
    }
    void go_on() {
        ++step_;
        const double phase = omega_ * static_cast<double>(step_);
        carrying_ = shape_;
        switch (kind_) {
            case Box_motion_kind::strain:
                for (std::size_t i = 0; i < d; ++i) {
                    const auto k = static_cast<double>(i);
                    scale_axis(i, 1 + 0.1 * std::sin(phase * (1 + 0.3 * k) + k));
                }
                break;
            case Box_motion_kind::shear:
                for (std::size_t i = 0; i < d; ++i) carrying_[1][i] += 3 * std::sin(phase / 3) * shape_[0][i];
                break;
            case Box_motion_kind::collapse: scale_axis(0, std::exp2(-4 * (1 - std::cos(phase)))); break;
            case Box_motion_kind::turn: turn(phase / 4); break;
            default: break;
        }
        if (kind_ == Box_motion_kind::bases && random_() % 16 == 0) another_basis();
        if (kind_ != Box_motion_kind::bases) vectors_ = carrying_;
        // What programs of molecular dynamics do with a tilt of more than half an edge.
        if (kind_ == Box_motion_kind::shear) {
            double along = 0, square = 0;
            for (std::size_t i = 0; i < d; ++i) {
                along += vectors_[1][i] * vectors_[0][i];
                square += vectors_[0][i] * vectors_[0][i];
            }
            for (std::size_t i = 0; i < d; ++i) vectors_[1][i] -= std::round(along / square) * vectors_[0][i];
        }
    }

    /// A box that nearly always stays one of the library's while it moves: not thin in a direction that is not along an
    /// axis.
    static Vectors shape(std::uint64_t seed, Box_motion_kind kind) {
        testing::Periodic_cases cases(seed);
        const std::size_t some = cases.below(testing::Periodic_cases::kinds);
        const bool gentle = kind == Box_motion_kind::still || kind == Box_motion_kind::strain;
        return cases.box<d>(gentle ? static_cast<int>(some) : std::array{0, 1, 4, 9}[some % 4]).vectors();
    }
    void scale_axis(std::size_t axis, double by) {
        for (auto& row : carrying_) row[axis] *= by;
    }
    void turn(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        for (auto& row : carrying_) {
            const double x = row[0];
            row[0] = c * x - s * row[1];
            row[1] = s * x + c * row[1];
        }
    }
    void another_basis() {
        Vectors next = vectors_;
        const std::size_t i = random_() % d, j = (i + 1 + random_() % (d - 1)) % d;
        const double sign = random_() % 2 == 0 ? 1 : -1;
        for (std::size_t k = 0; k < d; ++k) next[i][k] += sign * vectors_[j][k];
        vectors_ = is_possible(next) ? next : shape_;
    }

    testing::Random random_;
    Box_motion_kind kind_;
    double omega_;
    Vectors shape_, carrying_, vectors_;
    std::uint64_t step_ = 0;
};

}  // namespace annulus::soak
