// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/lloyd_scene.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/nodt_scene.h>
#include <annulus/cli/tracker.h>
#include <annulus/motion/lloyd_2.h>
#include <annulus/motion/nodt_3.h>

#include <span>
#include <string>
#include <vector>

namespace annulus::cli {

/// How far the vertices go in a step.
struct Way {
    double mean = 0, max = 0;
};

/// Lloyd iterations with a triangulation of their own, kept by certified tolerances and timed for nobody, so that what
/// follows them does not decide where they go.
class Guided_lloyd {
  public:
    using Moving = Moving_delaunay_2;
    static constexpr const char* step_name = "Lloyd iteration";

    Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const std::vector<Coordinates<2>>& points() const { return scene_.points; }
    [[nodiscard]] double spacing() const { return scene_.spacing(); }
    /// The positions of the next timestamp.
    Way next(std::span<Coordinates<2>> target);
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const;

  private:
    Lloyd_scene scene_;
    Moving guide_;
    Lloyd_2 lloyd_;
    Stars_2 stars_;
    Lloyd_memory memory_;
    bool cells_changed_ = true;
};

/// The same of natural ODT.
class Guided_nodt {
  public:
    using Moving = Moving_delaunay_3;
    static constexpr const char* step_name = "natural ODT iteration";

    Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const std::vector<Coordinates<3>>& points() const { return scene_.points; }
    [[nodiscard]] double spacing() const { return scene_.spacing(); }
    Way next(std::span<Coordinates<3>> target);
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const;

  private:
    int threads_;
    Nodt_scene scene_;
    Moving guide_;
    Nodt_3 nodt_;
    Mesh_3 mesh_;
    Nodt_memory memory_;
    bool cells_changed_ = true;
};

}  // namespace annulus::cli
