// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cgal_versions.h>
#include <apps/motion/domain_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace annulus::inline v1 {

/// A Domain_3 as a model of Mesh_3's concept MeshDomain_3: one subdomain, one surface patch.
class Mesh_domain_3 {
  public:
    using R = CGAL::Exact_predicates_inexact_constructions_kernel;
    using FT = R::FT;
    using Point_3 = R::Point_3;
    using Segment_3 = R::Segment_3;
    using Ray_3 = R::Ray_3;
    using Line_3 = R::Line_3;
    using Vector_3 = R::Vector_3;
    using Sphere_3 = R::Sphere_3;
    using Bbox_3 = CGAL::Bbox_3;
    using Has_features = CGAL::Tag_false;
    using Subdomain_index = int;
    using Surface_patch_index = std::pair<int, int>;  // another type than numbers of curves and corners
    using Index = Cgal_variant<Subdomain_index, Surface_patch_index>;
    using Subdomain = Cgal_optional<Subdomain_index>;
    using Surface_patch = Cgal_optional<Surface_patch_index>;
    using Intersection = std::tuple<Point_3, Index, int>;
    static constexpr Subdomain_index solid = 1;
    static constexpr Surface_patch_index skin{1, 0};

    /// Mesh_3 sees lengths in `unit`, a power of two. Sets `stop` after that many queries.
    Mesh_domain_3(const Domain_3& domain, double unit, std::uint64_t seed, std::uint64_t questions,
                  std::atomic<bool>* stop)
        : domain_(domain), unit_(unit), seed_(seed), left_(questions), stop_(stop) {}

    [[nodiscard]] Coordinates<3> outside(const Point_3& p) const {
        return {unit_ * p.x(), unit_ * p.y(), unit_ * p.z()};
    }
    [[nodiscard]] Point_3 inside(const Coordinates<3>& p) const { return {p[0] / unit_, p[1] / unit_, p[2] / unit_}; }

    [[nodiscard]] Bbox_3 bbox() const {
        const auto b = domain_.bounding_box();
        return inside(b.lower).bbox() + inside(b.upper).bbox();
    }

    struct Construct_initial_points {
        const Mesh_domain_3& domain;
        template <class Out>
        Out operator()(Out out, int n = 40) const {
            for (const auto& p : domain.domain_.surface_sample(static_cast<std::size_t>(n), domain.seed_))
                *out++ = std::pair(domain.inside(p), Index(skin));
            return out;
        }
    };
    struct Is_in_domain {
        const Mesh_domain_3& domain;
        Subdomain operator()(const Point_3& p) const {
            domain.count();
            return domain.domain_.contains(domain.outside(p)) ? Subdomain(solid) : Subdomain();
        }
    };
    struct Construct_intersection {
        const Mesh_domain_3& domain;
        Intersection operator()(const Segment_3& s) const {
            domain.count();
            const auto p = domain.domain_.crossing(domain.outside(s.source()), domain.outside(s.target()));
            return p ? Intersection(domain.inside(*p), Index(skin), 2) : Intersection(CGAL::ORIGIN, Index(), 0);
        }
        Intersection operator()(const Ray_3& r) const { return clipped(r); }
        Intersection operator()(const Line_3& l) const { return clipped(l); }

      private:
        template <class Query>
        Intersection clipped(const Query& q) const {
            const auto part = CGAL::intersection(q, domain.clip());
            const Segment_3* s = part ? alternative<Segment_3>(*part) : nullptr;
            return s != nullptr ? (*this)(*s) : Intersection(CGAL::ORIGIN, Index(), 0);
        }
    };
    struct Do_intersect_surface {
        const Mesh_domain_3& domain;
        template <class Query>
        Surface_patch operator()(const Query& q) const {
            return std::get<2>(domain.construct_intersection_object()(q)) == 2 ? Surface_patch(skin) : Surface_patch();
        }
    };
    [[nodiscard]] Construct_initial_points construct_initial_points_object() const { return {*this}; }
    [[nodiscard]] Is_in_domain is_in_domain_object() const { return {*this}; }
    [[nodiscard]] Do_intersect_surface do_intersect_surface_object() const { return {*this}; }
    [[nodiscard]] Construct_intersection construct_intersection_object() const { return {*this}; }

  private:
    /// The bounding box and a margin, so that rays end beyond the surface.
    [[nodiscard]] R::Iso_cuboid_3 clip() const {
        const Bbox_3 b = bbox();
        const double m = 0.01 * std::max({b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin()});
        return {b.xmin() - m, b.ymin() - m, b.zmin() - m, b.xmax() + m, b.ymax() + m, b.zmax() + m};
    }

    void count() const {
        if (left_ == 0) *stop_ = true;
        else --left_;
    }

    const Domain_3& domain_;
    double unit_;
    std::uint64_t seed_;
    mutable std::uint64_t left_;
    std::atomic<bool>* stop_;
};

}  // namespace annulus::inline v1
