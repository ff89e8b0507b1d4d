// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/generated_points.h>
#include <apps/reproduction/scene.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

/// Uniform random points of the unit square or cube. At each step a newly drawn share of them moves, each in its own
/// direction by `pace` mean spacings; the others stay.
template <int d>
class Partial_motion_scene final : public Scene<d> {
  public:
    Partial_motion_scene(std::size_t points, double share, double pace, std::uint64_t seed)
        : begin_(generate<d>(Point_family::uniform, points, seed)),
          x_(begin_),
          share_(share),
          pace_(pace),
          random_(seed + 1) {}

    [[nodiscard]] const std::vector<Coordinates<d>>& points() const override { return begin_; }
    [[nodiscard]] double spacing() const override { return std::pow(static_cast<double>(x_.size()), -1.0 / d); }
    [[nodiscard]] double next(std::vector<Coordinates<d>>& target) override {
        const auto movers = static_cast<std::size_t>(std::llround(share_ * static_cast<double>(x_.size())));
        if (order_.empty())
            for (std::size_t i = 0; i < x_.size(); ++i) order_.push_back(i);
        for (std::size_t k = 0; k < movers; ++k) {
            std::swap(order_[k], order_[k + random_.below(order_.size() - k)]);
            go(x_[order_[k]]);
        }
        target = x_;
        return share_ * pace_ * spacing();
    }
    [[nodiscard]] Picture picture(std::string) const override { return {}; }
    [[nodiscard]] std::optional<Mesh_step> quality() override { return std::nullopt; }

  private:
    void go(Coordinates<d>& p) {
        Coordinates<d> way{};
        double length = 0;
        while (!(length > 0)) {
            for (double& c : way) c = random_.bell();
            length = 0;
            for (const double c : way) length += c * c;
        }
        for (std::size_t k = 0; k < way.size(); ++k) p[k] += pace_ * spacing() / std::sqrt(length) * way[k];
    }

    std::vector<Coordinates<d>> begin_, x_;
    double share_, pace_;
    Portable_random random_;
    std::vector<std::size_t> order_;
};

}  // namespace annulus::inline v1
