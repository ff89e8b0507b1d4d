// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/cell_2.h>
#include <apps/motion/polygon_rings_2.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// An axis-aligned rectangle.
struct Rectangle_2 {
    Coordinates<2> lower{}, upper{};
};

/// A triangle with its corners counter-clockwise. `side[i]` is the line from corner i to the next, as a unit outward
/// normal and the bound from (0, 0). Triangles with a common side have opposite normals and bounds there, bit for bit.
struct Triangle_2 {
    std::array<Coordinates<2>, 3> corner{};
    std::array<Half_plane_2, 3> side{};
};

/// The triangles of a polygon with holes: a constrained Delaunay triangulation (CGAL) of its rings. What an odd number
/// of rings encloses belongs to the polygon. Search trees (Boost.Geometry) find triangles and edges near a place. The
/// same bits for every list of the same rings. Immutable.
class Triangles_2 {
  public:
    /// O(n log n) expected for n edges.
    explicit Triangles_2(const Polygon_edges_2& edges);
    Triangles_2(const Triangles_2&) = delete;
    Triangles_2& operator=(const Triangles_2&) = delete;
    ~Triangles_2();

    [[nodiscard]] std::span<const Triangle_2> all() const { return triangle_; }
    /// Writes the numbers of the triangles whose bounding rectangles meet this one, ascending.
    void near(const Rectangle_2& box, std::vector<std::size_t>& numbers) const;
    /// Whether an edge of a ring comes into the rectangle, or within `slack` of it.
    [[nodiscard]] bool edge_near(const Rectangle_2& box, double slack) const;
    /// Is p in the polygon or on its border? Exact.
    [[nodiscard]] bool contains(const Coordinates<2>& p) const;
    /// The number of an edge that is no farther from p than `distance`, the nearest of them; `edges().size()` if there
    /// is none.
    [[nodiscard]] std::size_t edge_at(const Coordinates<2>& p, double distance) const;
    [[nodiscard]] std::span<const std::array<Coordinates<2>, 2>> edges() const { return edge_; }

  private:
    struct Trees;
    std::vector<Triangle_2> triangle_;
    std::vector<std::array<Coordinates<2>, 2>> edge_;
    std::unique_ptr<const Trees> trees_;
};

/// The nearest point of a segment.
[[nodiscard]] Coordinates<2> nearest_on(const std::array<Coordinates<2>, 2>& segment, const Coordinates<2>& p);

}  // namespace annulus::inline v1
