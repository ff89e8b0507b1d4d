// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../motions/families.h"

#include <annulus/engine/tolerance_strategy.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <memory>
#include <string_view>
#include <type_traits>

namespace bench {

/// The parts of an engine by themselves: a triangulation of points of a family, and the strategy `strategy` on it. The
/// same as Moving_delaunay without the checks on entry.
template <int d>
class Workbench {
  public:
    using Mesh = annulus::Delaunay_mesh<d>;

    /// For every family in the unit of a uniform family in the unit cube.
    Workbench(std::string_view family, std::size_t n, std::uint64_t seed = 1)
        : random_(seed + 1000),
          x_(Scene<d>(family, "walk", n, 0.0, seed).points()),
          spacing_(std::pow(static_cast<double>(n), -1.0 / d)) {
        mesh_ = std::make_unique<Mesh>();
        mesh_->build(x_);
        strategy_ = std::make_unique<annulus::Tolerance_strategy<d>>(*mesh_);
        annulus::Move_result report;
        strategy_->begin(x_, report);
    }

    [[nodiscard]] const Points<d>& points() const { return x_; }
    [[nodiscard]] Points<d>& points() { return x_; }
    [[nodiscard]] Mesh& mesh() { return *mesh_; }
    [[nodiscard]] annulus::Tolerance_strategy<d>& strategy() { return *strategy_; }
    [[nodiscard]] double spacing() const { return spacing_; }

    /// Moves the points, and nothing else, by `spacings`: all of them, or each `share`-th.
    void walk(double spacings, std::size_t share = 1) {
        for (std::size_t i = share == 1 ? 0 : random_.bits() % share; i < x_.size(); i += share)
            for (double& c : x_[i]) c += spacings * spacing_ * random_.normal() / std::sqrt(static_cast<double>(d));
    }
    annulus::Move_result step() {
        annulus::Move_result report;
        strategy_->move_all(x_, report);
        return report;
    }
    /// Steps so large that tolerances are dropped.
    void drop_tolerances() {
        for (int k = 0; k < 100 && strategy_->keeps_tolerances(); ++k) {
            walk(0.02);
            (void)step();
        }
    }
    void recompute_tolerances() {
        annulus::Move_result report;
        strategy_->recompute_tolerances(x_, report);
    }

  private:
    Random random_;
    Points<d> x_;
    double spacing_;
    std::unique_ptr<Mesh> mesh_;
    std::unique_ptr<annulus::Tolerance_strategy<d>> strategy_;
};

}  // namespace bench
