// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/triangle_surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace annulus {

/// The point of a triangle nearest to p, up to rounding; always a point of the triangle, up to rounding, however thin that is. Products
/// of four lengths must neither overflow nor vanish.
[[nodiscard]] Coordinates<3> nearest_in_triangle(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                                 const Coordinates<3>& p);

/// Finds the nearest point of a triangle surface: a tree of boxes, the nearer half first. Immutable; const members may run concurrently.
class Triangle_tree {
  public:
    /// At least one triangle. O(n log n).
    explicit Triangle_tree(const Triangle_surface& surface);

    /// The point of the surface nearest to p, up to rounding. O(log n) expected near the surface.
    [[nodiscard]] Coordinates<3> nearest(const Coordinates<3>& p) const;
    /// The same, told of a point that is near p and, up to rounding, of the surface: what is farther from p is not looked at.
    [[nodiscard]] Coordinates<3> nearest(const Coordinates<3>& p, const Coordinates<3>& near) const;

  private:
    /// A box around triangles [first, first + count), or, where count is 0, around the nodes behind this one and at `first`.
    struct Node {
        Coordinates<3> lower{}, upper{};
        std::size_t first = 0, count = 0;
    };
    using Triangle = std::array<Coordinates<3>, 3>;

    std::size_t build(std::size_t first, std::size_t last, std::vector<std::array<double, 4>>& middle);
    [[nodiscard]] bool search(const Coordinates<3>& p, double bound, Coordinates<3>& found) const;

    std::vector<Node> node_;
    std::vector<Triangle> triangle_;  // in the order of the leaves
};

}  // namespace annulus
