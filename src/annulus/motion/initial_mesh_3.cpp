// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/initial_mesh_3.h>

#include <annulus/arithmetic/error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <unordered_set>

namespace annulus {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

Coordinates<3> ours(const K::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// A Domain_3 as Mesh_3 wants it (its concept MeshDomain_3): one subdomain, one surface patch.
class Mesh_domain {
  public:
    using R = K;
    using FT = K::FT;
    using Point_3 = K::Point_3;
    using Segment_3 = K::Segment_3;
    using Ray_3 = K::Ray_3;
    using Line_3 = K::Line_3;
    using Vector_3 = K::Vector_3;
    using Sphere_3 = K::Sphere_3;
    using Bbox_3 = CGAL::Bbox_3;
    using Has_features = CGAL::Tag_false;
    using Subdomain_index = int;
    using Surface_patch_index = int;
    using Index = int;
    using Subdomain = boost::optional<Subdomain_index>;
    using Surface_patch = boost::optional<Surface_patch_index>;
    using Intersection = std::tuple<Point_3, Index, int>;
    static constexpr int solid = 1, skin = 2;

    Mesh_domain(const Domain_3& domain, std::uint64_t seed) : domain_(domain), seed_(seed) {}

    [[nodiscard]] Bbox_3 bbox() const {
        const auto b = domain_.bounding_box();
        return {b.lower[0], b.lower[1], b.lower[2], b.upper[0], b.upper[1], b.upper[2]};
    }

    struct Construct_initial_points {
        const Mesh_domain& domain;
        template <class Out>
        Out operator()(Out out, int n = 40) const {
            for (const auto& p : domain.domain_.surface_sample(static_cast<std::size_t>(n), domain.seed_))
                *out++ = std::pair(Point_3(p[0], p[1], p[2]), Index(skin));
            return out;
        }
    };
    struct Is_in_domain {
        const Mesh_domain& domain;
        Subdomain operator()(const Point_3& p) const {
            return domain.domain_.contains(ours(p)) ? Subdomain(solid) : Subdomain();
        }
    };
    struct Construct_intersection {
        const Mesh_domain& domain;
        Intersection operator()(const Segment_3& s) const {
            const auto p = domain.domain_.crossing(ours(s.source()), ours(s.target()));
            return p ? Intersection(Point_3((*p)[0], (*p)[1], (*p)[2]), skin, 2) : Intersection(CGAL::ORIGIN, 0, 0);
        }
        Intersection operator()(const Ray_3& r) const { return clipped(r); }
        Intersection operator()(const Line_3& l) const { return clipped(l); }

      private:
        template <class Query>
        Intersection clipped(const Query& q) const {
            const auto part = CGAL::intersection(q, domain.clip());
            const Segment_3* s = part ? boost::get<Segment_3>(&*part) : nullptr;
            return s != nullptr ? (*this)(*s) : Intersection(CGAL::ORIGIN, 0, 0);
        }
    };
    struct Do_intersect_surface {
        const Mesh_domain& domain;
        template <class Query>
        Surface_patch operator()(const Query& q) const {
            return std::get<2>(domain.construct_intersection_object()(q)) == 2 ? Surface_patch(skin) : Surface_patch();
        }
    };
    [[nodiscard]] Construct_initial_points construct_initial_points_object() const { return {*this}; }
    [[nodiscard]] Is_in_domain is_in_domain_object() const { return {*this}; }
    [[nodiscard]] Do_intersect_surface do_intersect_surface_object() const { return {*this}; }
    [[nodiscard]] Construct_intersection construct_intersection_object() const { return {*this}; }

    static Index index_from_surface_patch_index(Surface_patch_index i) { return i; }
    static Index index_from_subdomain_index(Subdomain_index i) { return i; }
    static Surface_patch_index surface_patch_index(Index i) { return i; }
    static Subdomain_index subdomain_index(Index i) { return i; }

  private:
    /// The bounding box and a margin, so that rays end beyond the surface.
    [[nodiscard]] K::Iso_cuboid_3 clip() const {
        const Bbox_3 b = bbox();
        const double m = 0.01 * std::max({b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin()});
        return {b.xmin() - m, b.ymin() - m, b.zmin() - m, b.xmax() + m, b.ymax() + m, b.zmax() + m};
    }

    const Domain_3& domain_;
    std::uint64_t seed_;
};

struct Field {
    using FT = K::FT;
    using Point_3 = K::Point_3;
    using Index = int;
    const Sizing_3* sizing;
    double unit;
    FT operator()(const Point_3& p, int, const Index&) const { return unit * sizing->at(ours(p)); }
};

using Triangulation = CGAL::Mesh_triangulation_3<Mesh_domain>::type;
/// A class of this namespace, so that `dump_c3t3` below is found for it.
struct Complex : CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> {};
/// Mesh_3 writes a file named dump-bug before some of its failures. Not here: they are caught.
[[maybe_unused]] void dump_c3t3(const Complex&, const std::string&) {}
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// Refinement for angles of facets need not end where the surface has sharp edges (points coincide at last, and Mesh_3
/// throws): then without.
Complex refined(const Mesh_domain& domain, const Field& field, double h, std::uint64_t seed) {
    for (const double angle : {25.0, 0.0}) {
        CGAL::get_default_random() = CGAL::Random(static_cast<unsigned>(seed));
        const Criteria criteria(Criteria::Facet_criteria(angle, field, 0.2 * h), Criteria::Cell_criteria(2, field));
        try {
            return CGAL::make_mesh_3<Complex>(domain, criteria, CGAL::parameters::no_perturb(),
                                              CGAL::parameters::no_exude());
        } catch (const CGAL::Failure_exception&) {
            if (angle == 0) throw Error(Error_code::bad_input, "Mesh_3 cannot refine this domain");
        }
    }
    return {};
}

std::vector<K::Point_3> mesh(const Domain_3& domain, const Sizing_3& sizing, double h, std::uint64_t seed) {
    const Complex c3t3 = refined(Mesh_domain(domain, seed), Field{&sizing, h}, h, seed);
    std::unordered_set<const void*> seen;
    std::vector<K::Point_3> points;
    for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
        for (int i = 0; i < 4; ++i)
            if (seen.insert(&*c->vertex(i)).second) points.push_back(c->vertex(i)->point().point());
    return points;
}

}  // namespace

std::vector<Coordinates<3>> initial_mesh(const Domain_3& domain, const Sizing_3& sizing, std::size_t n,
                                         std::uint64_t seed) {
    if (n < 4) throw Error(Error_code::usage, "a mesh needs at least 4 vertices");
    // Of the counts so far, those around n, as logarithms of (size, count); the count falls with the size about as its
    // third power.
    double h = 1.2 * std::cbrt(domain.volume() / static_cast<double>(n));
    std::optional<std::array<double, 2>> coarse, fine;
    std::vector<K::Point_3> best;
    const auto distance = [n](std::size_t count) {
        return count == 0 ? 1e9 : std::abs(std::log(static_cast<double>(count) / static_cast<double>(n)));
    };
    for (int tries = 0; tries < 12 && distance(best.size()) > 0.01; ++tries) {
        std::vector<K::Point_3> points = mesh(domain, sizing, h, seed);
        const double count = std::max(1.0, static_cast<double>(points.size())), wanted = static_cast<double>(n);
        const std::array<double, 2> now{std::log(h), std::log(count / wanted)};
        (now[1] > 0 ? fine : coarse) = now;
        if (distance(points.size()) < distance(best.size())) best = std::move(points);
        if (coarse && fine) {
            // The false position, kept off the ends, where it would stay.
            const double t = std::clamp((*fine)[1] / ((*fine)[1] - (*coarse)[1]), 0.1, 0.9);
            h = std::exp((*fine)[0] + t * ((*coarse)[0] - (*fine)[0]));
        } else {
            h *= std::clamp(std::cbrt(count / wanted) * (now[1] > 0 ? 1.02 : 0.98), 0.4, 2.5);
        }
    }
    if (best.size() < 4) throw Error(Error_code::too_few, "refinement found no cell in the domain");
    CGAL::hilbert_sort(best.begin(), best.end(), K());
    std::vector<Coordinates<3>> points;
    points.reserve(best.size());
    for (const K::Point_3& p : best) points.push_back(ours(p));
    return points;
}

}  // namespace annulus
