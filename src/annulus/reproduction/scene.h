// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/report/run_record.h>
#include <annulus/report/svg_triangulation.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus {

/// A motion that the paper measured, as the program shows it: where points begin, and
/// where they go at each step, whatever follows them.
template <int d>
class Scene {
  public:
    virtual ~Scene() = default;
    [[nodiscard]] virtual const std::vector<Coordinates<d>>& points() const = 0;
    /// Root of the domain's content per point: the paper's unit of length.
    [[nodiscard]] virtual double spacing() const = 0;
    /// The next positions, and the mean way there in the caller's unit.
    [[nodiscard]] virtual double next(std::vector<Coordinates<d>>& target) = 0;
    /// The points where they are now; in 3D what a plane cuts of the mesh.
    [[nodiscard]] virtual Picture picture(std::string caption) const = 0;
    /// Of a mesh in 3D where it is now; what rested did so in the last step.
    [[nodiscard]] virtual std::optional<Mesh_step> quality() = 0;
    /// What a reader should know about it, a paragraph each.
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
};

}  // namespace annulus
