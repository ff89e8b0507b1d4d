// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "stopwatch.h"

#include <apps/cli/lloyd_scene.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/nodt_scene.h>
#include <apps/cli/tracker.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/nodt_3.h>

namespace bench {

/// The tool's Lloyd iterations with a separate triangulation, so that the contenders do not influence the motion.
/// Unlike the tool's Guided_lloyd it distinguishes the seconds of the motion from those of that triangulation.
class Lloyd {
  public:
    static constexpr int dimension = 2;
    using Moving = annulus::Moving_mesh_2;

    explicit Lloyd(const annulus::cli::Lloyd_scene& scene)
        : points_(scene.points), spacing_(scene.spacing()), guide_(points_), lloyd_(scene.domain, scene.density, 1) {}
    [[nodiscard]] const Points<2>& points() const { return points_; }
    [[nodiscard]] double spacing() const { return spacing_; }
    /// Computes the next positions; returns the time, and the displacement of the vertices in spacings.
    [[nodiscard]] std::pair<double, double> next(Points<2>& target) {
        const double begin = watch_.seconds();
        if (cells_changed_) annulus::cli::read_stars(guide_, stars_);
        const annulus::Lloyd_step step = lloyd_.step(stars_, guide_.points(), target, memory_);
        const double taken = watch_.seconds() - begin;
        cells_changed_ = annulus::cli::changes_cells(guide_.move_all(std::span<const annulus::Coordinates<2>>(target)));
        return {taken, step.mean_displacement / spacing_};
    }

  private:
    Points<2> points_;
    double spacing_;
    Moving guide_;
    annulus::Lloyd_2 lloyd_;
    annulus::Stars_2 stars_;
    annulus::Lloyd_memory memory_;
    bool cells_changed_ = true;
    Stopwatch watch_;
};

/// The same for natural ODT.
class Nodt {
  public:
    static constexpr int dimension = 3;
    using Moving = annulus::Moving_mesh_3;

    Nodt(const annulus::cli::Nodt_scene& scene, const annulus::cli::Nodt_arguments& arguments)
        : scene_(scene), guide_(scene.points), nodt_(scene.motion(arguments, 1)) {}
    [[nodiscard]] const Points<3>& points() const { return scene_.points; }
    [[nodiscard]] double spacing() const { return scene_.spacing(); }
    [[nodiscard]] std::pair<double, double> next(Points<3>& target) {
        const double begin = watch_.seconds();
        mesh_.read(guide_, cells_changed_, *scene_.domain, 1);
        const annulus::Nodt_step step = nodt_.step(mesh_.kept(), mesh_.points(), target, memory_);
        const double taken = watch_.seconds() - begin;
        cells_changed_ = annulus::cli::changes_cells(guide_.move_all(std::span<const annulus::Coordinates<3>>(target)));
        return {taken, step.mean_displacement / scene_.spacing()};
    }

  private:
    const annulus::cli::Nodt_scene& scene_;
    Moving guide_;
    annulus::Nodt_3 nodt_;
    annulus::cli::Mesh_3 mesh_;
    annulus::Nodt_memory memory_;
    bool cells_changed_ = true;
    Stopwatch watch_;
};

}  // namespace bench
