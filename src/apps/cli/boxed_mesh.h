// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/options.h>
#include <annulus/periodic_mesh.h>
#include <annulus/types.h>
#include <apps/cli/image_path.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1::cli {

/// A Periodic_mesh as a Tracker needs it: with what a Moving_mesh can be asked for at every step. The vertices are the
/// points of the last frame, in the order of their ids.
template <int d>
class Boxed_mesh {
  public:
    static constexpr int dimension_of_space = d;

    /// The strategy is one of boxed_options_of; `rebuild` builds at every step, the others where flips would cost more.
    /// Throws what Periodic_mesh throws.
    Boxed_mesh(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box,
               const Options& options);
    /// The next frame: other points, for a new mesh, or other positions of the same, in the same box or another.
    /// Throws what Periodic_mesh throws, and then is as it was.
    Move_result follow(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box);

    [[nodiscard]] const Periodic_mesh<d>& mesh() const { return mesh_; }
    [[nodiscard]] const Image_path<d>& path() const { return path_; }
    [[nodiscard]] std::span<const std::uint64_t> ids() const { return id_; }
    /// The box as it was given, not rounded.
    [[nodiscard]] const Box<d>& box() const { return box_; }

    [[nodiscard]] std::size_t number_of_vertices() const { return id_.size(); }
    [[nodiscard]] std::size_t index_bound() const { return id_.size(); }
    [[nodiscard]] bool is_vertex(Index v) const { return v >= 0 && static_cast<std::size_t>(v) < id_.size(); }
    [[nodiscard]] Audit_result audit() const { return mesh_.audit(); }
    /// Does nothing: tolerances begin with a step.
    Move_result recompute_tolerances() { return {}; }
    /// Tolerances alone: what is left of them while they are kept, else those of the present places. O(n).
    [[nodiscard]] Measures measure() const { return {.tolerance = mesh_.tolerances(), .annulus_width = {}}; }

  private:
    Periodic_mesh<d> mesh_;
    Box<d> box_;
    std::vector<std::uint64_t> id_;
    Image_path<d> path_;
    bool rebuilds_;
};

extern template class Boxed_mesh<2>;
extern template class Boxed_mesh<3>;

}  // namespace annulus::inline v1::cli
