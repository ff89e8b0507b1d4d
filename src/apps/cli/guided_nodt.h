// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/guided_motion.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/nodt_scene.h>
#include <apps/motion/nodt_3.h>

#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// Natural ODT with its own triangulation, as Guided_lloyd.
class Guided_nodt final : public Guided_motion<Moving_mesh_3> {
  public:
    Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const char* step_name() const override { return "natural ODT iteration"; }
    [[nodiscard]] const std::vector<Coordinates<3>>& points() const { return scene_.points; }
    [[nodiscard]] Moving start(const Options& options) const override { return Moving(points(), options); }
    [[nodiscard]] double spacing() const override { return scene_.spacing(); }
    bool next(Time_step<3>& t) override;
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const override;
    [[nodiscard]] const Moving& guide() const { return guide_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return scene_.notes; }
    /// The quality of its current mesh; `locked` counts the vertices that rested in the last step.
    [[nodiscard]] Mesh_step quality();

  private:
    void read_mesh();

    int threads_;
    Nodt_scene scene_;
    Moving guide_;
    Nodt_3 nodt_;
    Mesh_3 mesh_;
    Nodt_memory memory_;
    Nodt_step last_;
    Cut_plane cut_;     // of all pictures
    bool read_ = true;  // mesh_ is up to date with guide_
    bool cells_changed_ = true;
};

}  // namespace annulus::inline v1::cli
