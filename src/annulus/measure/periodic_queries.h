// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/engine/periodic_state.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Where points are in a periodic triangulation: what Periodic_mesh says of its members. Shifts are by vectors of the
/// box, from the images that the caller gave. Preconditions: a proved table, rounding to nearest.
template <int d>
class Periodic_queries {
  public:
    using Points = std::span<const Coordinates<d>>;

    /// Refers to the state.
    explicit Periodic_queries(const Periodic_state<d>& state) : state_(state) {}

    [[nodiscard]] std::vector<Periodic_location<d>> cells(Points points) const;
    [[nodiscard]] std::vector<Periodic_image<d>> nearest(Points points) const;
    [[nodiscard]] Periodic_weights<d> natural_neighbours(Points points) const;

  private:
    /// Calls with(number, representative, the cell that contains it as that is beside it) for each point that is no
    /// NaN, unless there are no cells.
    template <class With>
    void for_each_located(Points points, With with) const;
    [[nodiscard]] Periodic_image<d> named(Image<d> image, const Representative<d>& beside) const;

    const Periodic_state<d>& state_;
};

extern template class Periodic_queries<2>;
extern template class Periodic_queries<3>;

}  // namespace annulus::inline v1
