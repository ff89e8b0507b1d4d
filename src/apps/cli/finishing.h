// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/mesh_3.h>
#include <apps/cli/nodt_scene.h>
#include <apps/motion/finish_3.h>

#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// --finish
void add_finish(CLI::App& app, bool& finish);

/// The end of an optimisation: Finish_3 on a triangulation of its own, with progress on standard error. Vertices on
/// sharp edges rest. An interruption ends it early.
class Finishing {
  public:
    Finishing(const Nodt_scene& scene, const Moving_mesh_3& optimised, bool quiet);

    /// By vertex index.
    [[nodiscard]] const std::vector<Coordinates<3>>& position() const { return position_; }
    /// Mean over all vertices, and the largest.
    [[nodiscard]] double mean_displacement() const { return mean_; }
    [[nodiscard]] double max_displacement() const { return max_; }
    /// One sentence for the page.
    [[nodiscard]] std::string note() const;

  private:
    std::vector<Coordinates<3>> position_;
    double mean_ = 0, max_ = 0;
    Finish_3::Counts counts_;
};

}  // namespace annulus::inline v1::cli
