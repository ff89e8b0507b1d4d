// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/run_tracker.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// One strategy that follows a motion with open boundaries: its triangulation is a Moving_mesh.
template <class Moving>
class Tracker : public Run_tracker<Moving> {
  public:
    static constexpr int d = Moving::dimension_of_space;
    using Run_tracker<Moving>::Run_tracker;
    using Run_tracker<Moving>::step;

    /// Builds the triangulation of these points; see Run_tracker.
    Tracker(std::string name, std::span<const Coordinates<d>> points, const Options& options, double spacing,
            std::uint64_t iterations, std::uint64_t audit_every, bool measure);

    /// Follows one time step. The motion measures its seconds and displacements itself.
    void step(std::span<const Coordinates<d>> x, double motion_seconds, double displacement_mean,
              double displacement_max);
    /// Follows one time step in which some vertices leave, then the others move to x (by index), then some arrive:
    /// removals, one move_all, insertions. Returns the indices of the vertices that arrived. Throws what the
    /// triangulation throws.
    std::vector<Index> follow(std::span<const Index> leave, std::span<const Coordinates<d>> x,
                              std::span<const Coordinates<d>> arrive, double motion_seconds, double displacement_mean,
                              double displacement_max);
};

/// Corners of a cell in a periodic box: vertices, and which images of them.
template <int d>
using Boxed_cell = std::array<std::pair<Index, Shift<d>>, static_cast<std::size_t>(d) + 1>;

/// The cells in a canonical order, each with its vertices in a canonical order: equal for equal triangulations, in a
/// box of the same images of points. O(n log n).
template <int d>
[[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> canonical_cells(const Moving_mesh<d>& dt);
template <int d>
[[nodiscard]] std::vector<Boxed_cell<d>> canonical_cells(const Boxed_mesh<d>& dt);

extern template class Tracker<Moving_mesh_2>;
extern template class Tracker<Moving_mesh_3>;

using Tracker_2 = Tracker<Moving_mesh_2>;
using Tracker_3 = Tracker<Moving_mesh_3>;

/// The plane x[axis] = at.
struct Cut_plane {
    std::size_t axis = 2;
    double at = 0;
};
/// Where all pictures of a page cut a 3D triangulation: chosen by the first picture with points.
using Chosen_cut = std::optional<Cut_plane>;

/// The triangulation as a picture for the report; of a periodic one the cells whose middles are in the box, and its
/// outline. In 2D there is no cut.
[[nodiscard]] Picture picture_of(const Moving_mesh_2& dt, std::string caption);
[[nodiscard]] Picture picture_of(const Boxed_mesh<2>& dt, std::string caption);
[[nodiscard]] inline Picture picture_of(const Moving_mesh_2& dt, std::string caption, Chosen_cut&) {
    return picture_of(dt, std::move(caption));
}
[[nodiscard]] inline Picture picture_of(const Boxed_mesh<2>& dt, std::string caption, Chosen_cut&) {
    return picture_of(dt, std::move(caption));
}

}  // namespace annulus::inline v1::cli
