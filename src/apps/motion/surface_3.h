// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>
#include <apps/motion/triangle_surface.h>

#include <memory>

namespace annulus::inline v1 {

/// The set that a closed triangle surface encloses: the points from which a ray crosses it an odd number of times.
///
/// CGAL's AABB tree answers all queries but one: for the nearest point after a query close by, which is the most
/// frequent query of motions, few triangles are left (`Nearest_search`), and CGAL projects on these. `contains` is
/// decided by exact predicates, or in O(1) for points in a voxel of a grid that the surface does not enter: such a
/// voxel is inside or outside as a whole.
class Surface_3 final : public Domain_3 {
  public:
    /// Throws Error(bad_input) unless every edge is in two triangles that run through it in opposite directions,
    /// triangles have area and, unless `crossings` are allowed, meet in nothing but common corners and edges;
    /// Error(not_finite); and Error(out_of_domain) unless the longest side of its box is 1e-30 at least and 1e-7 of the
    /// largest coordinate, which is 1e12 at most. Coordinates below 1e-30 of that side are taken as 0. O(n log n), and
    /// the pairs of triangles whose boxes meet.
    explicit Surface_3(const Triangle_surface& surface, bool crossings = false);
    ~Surface_3() override;

    /// O(1) away from the surface, O(log n) expected near it. A point of the surface is not contained.
    [[nodiscard]] bool contains(const Coordinates<3>& p) const override;
    [[nodiscard]] Coordinates<3> project(const Coordinates<3>& p) const override;
    /// O(1) while p stays close to the point of the last query; else a search of the tree, and a list of the triangles
    /// within five times |p - near|.
    [[nodiscard]] Coordinates<3> project(const Coordinates<3>& p, const Coordinates<3>& near,
                                         Nearby_3& nearby) const override;
    [[nodiscard]] std::optional<Coordinates<3>> crossing(const Coordinates<3>& a,
                                                         const Coordinates<3>& b) const override;
    [[nodiscard]] std::vector<Coordinates<3>> surface_sample(std::size_t n, std::uint64_t seed) const override;
    [[nodiscard]] Box bounding_box() const override;
    [[nodiscard]] double volume() const override;

    /// `contains` without the grid.
    [[nodiscard]] bool contains_by_ray(const Coordinates<3>& p) const;

  private:
    struct Tree;
    std::unique_ptr<const Tree> tree_;
};

}  // namespace annulus::inline v1
