// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/tracker.h>
#include <apps/motion/kept_cells_3.h>
#include <apps/motion/nodt_3.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// The solid cells of a 3D triangulation, as indices of `points`, and which of them are in the domain. Their order does
/// not depend on the history of the triangulation, so that a motion computed from them is the same bit for bit.
class Mesh_3 {
  public:
    [[nodiscard]] const std::vector<Coordinates<3>>& points() const {
        return points_;
    }  ///< by vertex index; precondition: no vertex was removed
    [[nodiscard]] const Mesh_cells<3>& cells() const { return kept_.cells(); }
    [[nodiscard]] std::span<const char> inside() const { return domain_ ? kept_.inside() : all_; }
    /// The cells in the form that a motion takes. Precondition: read with a domain.
    [[nodiscard]] const Kept_cells_3& kept() const { return kept_; }

    /// Reads the cells; every cell is in the domain.
    void read(const Moving_mesh_3& dt);
    void read(std::vector<Coordinates<3>> points, std::vector<std::array<Index, 4>> cells);
    /// A cell is in the domain if its circumcentre is. The cells are read again only if they have changed.
    void read(const Moving_mesh_3& dt, bool cells_changed, const Domain_3& domain, int threads);

    /// The middle of the bounding box: a cut across its shortest side is the widest view of the mesh.
    [[nodiscard]] Cut_plane middle() const;
    /// The cells of the domain, cut by a plane, one for all pictures of a motion; the caption says where. Where they
    /// were read with a domain, they are filled with the shades of their least dihedral angles.
    [[nodiscard]] Picture cut(std::string caption, const Cut_plane& plane) const;

  private:
    std::vector<Coordinates<3>> points_;
    Kept_cells_3 kept_;
    std::vector<char> all_;  // flags of all cells if there is no domain
    bool domain_ = false;
};

/// The plane across the shortest side of the box between these corners, in its middle. In a layer of points a cut has
/// no triangles: then it is a quarter of their mean distance off the middle. Linear.
[[nodiscard]] Cut_plane middle_of(const Coordinates<3>& low, const Coordinates<3>& high,
                                  const std::vector<Coordinates<3>>& points);

/// The quality of the mesh after a step, for the files; `locked` and `kept` are those of that step.
[[nodiscard]] Mesh_step measured(const Mesh_3& mesh, const Nodt_step& step);

/// All cells of the triangulation, cut by this plane, or else in the middle; of a periodic one in that of the box,
/// whose outline is drawn.
[[nodiscard]] Picture picture_of(const Moving_mesh_3& dt, std::string caption, Chosen_cut& plane);
[[nodiscard]] Picture picture_of(const Boxed_mesh<3>& dt, std::string caption, Chosen_cut& plane);

}  // namespace annulus::inline v1::cli
