// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_certificates.h>
#include <annulus/measure/periodic_nearest.h>

#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// Images of vertices, and their weights.
template <int d>
struct Weighted_images {
    std::vector<Image<d>> image;
    std::vector<double> weight;
};

/// The natural neighbours of points in a periodic box, with Laplace's weights (laplace_weights.h): of a point p as it
/// would be inserted, with all of its images. These bound its cell, too, where there are few vertices, and have no
/// weight: those of the others are divided by their own sum. As an image and the opposite one have equal facets,
/// sum_j weight_j (x_j - p) is 0 nevertheless. Preconditions: the table is proved for these places, rounding is to
/// nearest.
template <int d>
class Periodic_natural_neighbours {
  public:
    /// Refers to what the view does. O(1).
    explicit Periodic_natural_neighbours(const Periodic_view<d>& view);

    /// Of a representative p that `start` contains (kernel/periodic_locate.h). Expected O(1), some twenty microseconds
    /// in 2D, a hundred in 3D. Throws bad_alloc.
    [[nodiscard]] Weighted_images<d> of(const Coordinates<d>& p, Lifted_cell<d> start) const;

  private:
    struct Own_image {
        Offset<d> offset;
        double length;
    };
    [[nodiscard]] Coordinates<d> at(Image<d> s) const {
        return view_.lattice.place(view_.place[static_cast<std::size_t>(s.vertex)], s.label);
    }
    [[nodiscard]] std::vector<Image<d>> images_around(const Coordinates<d>& p, const Lifted_corner<d>& nearest) const;
    [[nodiscard]] bool is_in_reach(const Coordinates<d>& p, Lifted_cell<d> c) const;
    [[nodiscard]] bool is_in_sphere(const Coordinates<d>& p, Lifted_cell<d> c) const;

    Periodic_view<d> view_;
    std::vector<Own_image> own_;  // of the images of a point those that may bound its cell
};

extern template class Periodic_natural_neighbours<2>;
extern template class Periodic_natural_neighbours<3>;

}  // namespace annulus::inline v1
