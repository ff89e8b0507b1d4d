// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../motions/motion.h"

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace bench {

/// A library that triangulates sets of points, one after the other. It may keep its arrays from one call to the next.
template <int d>
class Contestant {
  public:
    virtual ~Contestant() = default;
    Contestant() = default;
    Contestant(const Contestant&) = delete;
    Contestant& operator=(const Contestant&) = delete;

    /// Triangulates these points, which are distinct and not all in a plane (2D: on a line), with one thread. What it
    /// takes to hand the points over is a part of it. Throws std::runtime_error where the library fails.
    virtual void rebuild(const Points<d>& x) = 0;
    /// The number of finite cells. Precondition: `rebuild`, and no `forget` since then. O(n).
    [[nodiscard]] virtual std::size_t cells() const = 0;
    /// Destroys the triangulation where the library has no way to reuse it. Not timed.
    virtual void forget() {}
};

template <int d>
using Make_contestant = std::unique_ptr<Contestant<d>> (*)();

// Each in a file of its own; bench/peers adds the files of libraries whose sources it was given.
template <int d>
std::unique_ptr<Contestant<d>> moving_mesh();  ///< Moving_mesh with Strategy::rebuild, the object kept
template <int d>
std::unique_ptr<Contestant<d>> moving_mesh_anew();  ///< the constructor of Moving_mesh
template <int d>
std::unique_ptr<Contestant<d>> cgal();            ///< insertion of a range of points with indices
std::unique_ptr<Contestant<3>> geogram();         ///< BDEL, the object kept
std::unique_ptr<Contestant<3>> hxt();             ///< hxtDelaunaySteadyVertices: vertices keep their order
std::unique_ptr<Contestant<3>> hxt_reordering();  ///< hxtDelaunay: vertices get another order

template <int d>
struct Named_contestant {
    std::string_view name;
    Make_contestant<d> make;
};

/// Those that this program was compiled with; the first one is what the others are compared with.
template <int d>
[[nodiscard]] const std::vector<Named_contestant<d>>& contestants();

}  // namespace bench
