// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/report/run_record.h>
#include <apps/report/svg_triangulation.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A motion that the paper measured: the first positions of points, and their positions after each step, whichever
/// strategy follows them.
template <int d>
class Scene {
  public:
    virtual ~Scene() = default;
    [[nodiscard]] virtual const std::vector<Coordinates<d>>& points() const = 0;
    /// The d-th root of the domain's content per point: the paper's unit of length.
    [[nodiscard]] virtual double spacing() const = 0;
    /// The next positions, and the mean displacement in the caller's unit.
    [[nodiscard]] virtual double next(std::vector<Coordinates<d>>& target) = 0;
    /// The points at their present positions; in 3D the section of the mesh with a plane.
    [[nodiscard]] virtual Picture picture(std::string caption) const = 0;
    /// Of a 3D mesh at its present positions; resting vertices are those of the last step.
    [[nodiscard]] virtual std::optional<Mesh_step> quality() = 0;
    /// Remarks on it for a reader, a paragraph each.
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace annulus::inline v1
