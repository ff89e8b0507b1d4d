// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/error.h>

#include <support/periodic_boxes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Periodic boxes that move with their points.
namespace annulus::testing {

enum class Moving { jitter, strain, shear, drift, few, turn, basis, oscillation, wraps, rest };
inline constexpr std::array all_moving{Moving::jitter, Moving::strain, Moving::shear, Moving::drift,
                                       Moving::few,    Moving::turn,   Moving::basis, Moving::oscillation,
                                       Moving::wraps,  Moving::rest};

/// Points and a box that move in one of these ways, by a part of the mean spacing in each step.
template <int d>
class Moving_box {
  public:
    Moving_box(Moving how, int kind, std::size_t n, double step)
        : cases_(1000 * n + 10 * static_cast<std::size_t>(kind) + static_cast<std::size_t>(how)),
          how_(how),
          step_(step),
          vectors_(cases_.box<d>(kind).vectors()),
          x_(cases_.points<d>(Box<d>(vectors_), n, 1)) {}

    void advance() {
        ++steps_;
        const double spacing = std::pow(Box<d>(vectors_).volume() / static_cast<double>(x_.size()), 1.0 / d);
        const double jitter = step_ * spacing;
        switch (how_) {
            case Moving::strain: deform(by_stretch(1 + 0.1 * step_)); break;
            case Moving::oscillation: {
                Matrix m = by_stretch(1);
                m[0][0] += step_ * std::sin(0.3 * steps_);
                m[d - 1][0] += step_ * std::cos(0.2 * steps_);
                deform(m);
                break;
            }
            case Moving::shear: {
                Matrix m = by_stretch(1);
                m[0][1] += step_;
                deform(m);
                reduce_tilt();
                break;
            }
            case Moving::turn: {
                Matrix m = by_stretch(1);
                m[0][0] = m[1][1] = std::cos(step_);
                m[0][1] = -std::sin(step_);
                m[1][0] = std::sin(step_);
                deform(m);
                break;
            }
            case Moving::drift:
                for (auto& p : x_)
                    for (std::size_t i = 0; i < d; ++i) p[i] += jitter * (1.0 + static_cast<double>(i));
                break;
            case Moving::basis:
                if (steps_ % 4 == 0) add_vector();
                break;
            case Moving::wraps:
                for (auto& p : x_)
                    for (std::size_t i = 0; i < d; ++i)
                        p[i] += (static_cast<double>(cases_.below(5)) - 2) * vectors_[0][i];
                break;
            default: break;
        }
        if (how_ == Moving::rest && steps_ % 3 != 0) return;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            const double most = how_ != Moving::few ? 0.3 * jitter : v % 16 == 3 ? 20 * jitter : 0;
            for (double& c : x_[v]) c += cases_.uniform(-most, most);
        }
    }
    [[nodiscard]] Box<d> box() const { return Box<d>(vectors_); }
    [[nodiscard]] const std::vector<Coordinates<d>>& points() const { return x_; }

  private:
    using Matrix = std::array<Coordinates<d>, static_cast<std::size_t>(d)>;

    static Matrix by_stretch(double factor) {
        Matrix m{};
        for (std::size_t i = 0; i < d; ++i) m[i][i] = factor;
        return m;
    }
    void deform(const Matrix& m) {
        const auto apply = [&](Coordinates<d>& p) {
            const auto old = p;
            for (std::size_t i = 0; i < d; ++i) {
                p[i] = 0;
                for (std::size_t k = 0; k < d; ++k) p[i] += m[i][k] * old[k];
            }
        };
        for (auto& v : vectors_) apply(v);
        for (auto& p : x_) apply(p);
    }
    /// As programs of molecular dynamics do.
    void reduce_tilt() {
        double along = 0, square = 0;
        for (std::size_t i = 0; i < d; ++i) {
            along += vectors_[1][i] * vectors_[0][i];
            square += vectors_[0][i] * vectors_[0][i];
        }
        for (std::size_t i = 0; i < d; ++i) vectors_[1][i] -= std::round(along / square) * vectors_[0][i];
    }
    void add_vector() {
        auto next = vectors_;
        const double sign = cases_.below(2) == 0 ? 1 : -1;
        for (std::size_t i = 0; i < d; ++i) next[1][i] += sign * next[0][i];
        try {
            (void)Box<d>(next);
            vectors_ = next;
        } catch (const Error&) {  // too skewed
        }
    }

    Periodic_cases cases_;
    Moving how_;
    double step_;
    typename Box<d>::Vectors vectors_;
    std::vector<Coordinates<d>> x_;
    int steps_ = 0;
};

}  // namespace annulus::testing
