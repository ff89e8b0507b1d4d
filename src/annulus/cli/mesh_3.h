// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/tracker.h>
#include <annulus/motion/kept_cells_3.h>
#include <annulus/motion/nodt_3.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::cli {

/// The solid cells of a 3D triangulation, numbered like `points`, and which of them are of the domain. In one
/// order whatever the history of the triangulation, so that a motion computed from them is the same bit for bit.
class Mesh_3 {
  public:
    [[nodiscard]] const std::vector<Coordinates<3>>& points() const {
        return points_;
    }  ///< where no vertex was removed, by vertex index
    [[nodiscard]] const Cells_3& cells() const { return kept_.cells(); }
    [[nodiscard]] std::span<const char> inside() const { return domain_ ? kept_.inside() : all_; }
    /// As a motion takes them; after a reading with a domain.
    [[nodiscard]] const Kept_cells_3& kept() const { return kept_; }

    /// Every cell is of the domain.
    void read(const Moving_mesh_3& dt);
    /// Those cells are of the domain whose circumcentre is. The cells are read again only if they have changed.
    void read(const Moving_mesh_3& dt, bool cells_changed, const Domain_3& domain, int threads);

    /// The shortest side of the box of the points: cut across it, a mesh shows its widest view.
    [[nodiscard]] std::size_t shortest_side() const;
    /// The cells of the domain, cut across that side, through the middle of the box.
    [[nodiscard]] Picture cut(std::string caption) const { return cut(std::move(caption), shortest_side()); }
    /// Across another one: pictures of a motion show it from one side.
    [[nodiscard]] Picture cut(std::string caption, std::size_t axis) const;

  private:
    std::vector<Coordinates<3>> points_;
    Kept_cells_3 kept_;
    std::vector<char> all_;  // flags where there is no domain
    bool domain_ = false;
};

/// The mesh after a step as the files tell it; what rested did so in that step.
[[nodiscard]] Mesh_step measured(const Mesh_3& mesh, const Nodt_step& step);

/// All cells of the triangulation, cut as above.
[[nodiscard]] Picture picture_of(const Moving_mesh_3& dt, std::string caption);

}  // namespace annulus::cli
