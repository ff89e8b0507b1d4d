// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/surface_3.h>

#include <annulus/error.h>
#include <apps/motion/cgal_versions.h>
#include <apps/motion/nearest_search.h>
#include <apps/motion/surface_faults.h>
#include <apps/motion/voxel_marks.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

namespace annulus::inline v1 {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<K::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;

bool is_finite(const Coordinates<3>& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// A kernel in which the point of a triangle nearest to a point is always one: where the triangle is so thin, or some
/// of its coordinates so small, that CGAL's construction ends in a quotient of zeros, it is a corner.
struct Guarded_kernel : K {
    struct Construct_projected_point_3 {
        Point_3 operator()(const Triangle_3& t, const Point_3& p) const {
            const Point_3 q = K().construct_projected_point_3_object()(t, p);
            if (std::isfinite(q.x()) && std::isfinite(q.y()) && std::isfinite(q.z())) return q;
            const auto compare = K().compare_distance_3_object();
            Point_3 nearest = t[0];
            for (const int i : {1, 2})
                if (compare(p, t[i], nearest) == CGAL::SMALLER) nearest = t[i];
            return nearest;
        }
    };
    [[nodiscard]] Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
};
#if CGAL_VERSION_NR >= 1060000000
using Aabb_traits = CGAL::AABB_traits_3<Guarded_kernel, Primitive>;
#else
using Aabb_traits = CGAL::AABB_traits<Guarded_kernel, Primitive>;
#endif
using Aabb_tree = CGAL::AABB_tree<Aabb_traits>;
using Side = CGAL::Side_of_triangle_mesh<Mesh, K, CGAL::Default, Aabb_tree>;

/// The triangles whose boxes are within a distance of a ball's centre, with their distances.
struct Listing {
    struct Query {
        Coordinates<3> centre;
        double reach;
    };
    static double gap(const Query& ball, const CGAL::Bbox_3& b) {
        return std::sqrt(squared_gap(ball.centre, std::array{b.xmin(), b.ymin(), b.zmin()},
                                     std::array{b.xmax(), b.ymax(), b.zmax()}));
    }
    [[nodiscard]] static constexpr bool go_further() { return true; }
    [[nodiscard]] bool do_intersect(const Query& ball, const CGAL::AABB_node<Aabb_traits>& node) const {
        return gap(ball, node.bbox()) <= ball.reach;
    }
    void intersection(const Query& ball, const Primitive& primitive) {
        const auto number = static_cast<std::int32_t>(primitive.id());
        const double least = gap(ball, (*triangles)[static_cast<std::size_t>(number)].bbox());
        if (least <= ball.reach) parts->push_back({least, number});
    }
    const std::vector<K::Triangle_3>* triangles;
    std::vector<Nearby_3::Part>* parts;
};

K::Point_3 cgal(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
Coordinates<3> ours(const K::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Four digits are enough to locate a point.
std::string shortened(double x) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, x, std::chars_format::general, 4).ptr};
}

/// CGAL computes quotients of high powers of coordinates, so these must be neither too large nor too small, and the
/// surface must be near enough to the origin for doubles to distinguish the corners of small triangles. Coordinates
/// below 1e-30 times the longest side become 0: far below the resolution of positions in doubles.
Triangle_surface in_sane_lengths(Triangle_surface s) {
    double longest = 0, farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax_element(s.points.begin(), s.points.end(),
                                                     [k](const auto& p, const auto& q) { return p[k] < q[k]; });
        longest = std::max(longest, (*high)[k] - (*low)[k]);
        farthest = std::max({farthest, std::abs((*high)[k]), std::abs((*low)[k])});
    }
    // Side_of_triangle_mesh shoots rays of length 1, and goes wrong from about 1e16 on.
    if (!(longest >= 1e-30 && farthest <= 1e12))
        throw Error(Error_code::out_of_domain, "its longest side is below 1e-30, or a coordinate beyond 1e12");
    if (!(farthest <= 1e7 * longest))
        throw Error(Error_code::out_of_domain, "it is more than 1e7 times its longest side away from the origin");
    for (auto& p : s.points)
        for (double& x : p)
            if (std::abs(x) < 1e-30 * longest) x = 0;
    return s;
}

Triangle_surface sound(const Triangle_surface& given, bool crossings) {
    if (given.triangles.empty()) throw Error(Error_code::bad_input, "there are no triangles");
    for (const auto& t : given.triangles)
        for (const Index i : t)
            if (i < 0 || static_cast<std::size_t>(i) >= given.points.size())
                throw Error(Error_code::bad_input, "a triangle names no point");
    for (const auto& p : given.points)
        if (!is_finite(p)) throw Error(Error_code::not_finite, "a coordinate is not finite");
    const Triangle_surface s = in_sane_lengths(given);
    if (const auto fault = edge_fault(s.triangles))
        throw Error(Error_code::bad_input, fault->kind == Edge_fault::Kind::open ? "it is not closed"
                                           : fault->kind == Edge_fault::Kind::crowded
                                               ? "an edge is in more than two triangles"
                                               : "a triangle is turned against the one beside it");
    const auto near = [&s](std::size_t t) {
        const auto& p = s.points[static_cast<std::size_t>(s.triangles[t][0])];
        return " near (" + shortened(p[0]) + ", " + shortened(p[1]) + ", " + shortened(p[2]) + ")";
    };
    if (const auto t = flat_triangle(s)) throw Error(Error_code::bad_input, "a triangle has no area" + near(*t));
    const auto pair = crossings ? std::nullopt : crossing_triangles(s);
    if (pair) throw Error(Error_code::bad_input, "it crosses or touches itself" + near((*pair)[0]));
    return s;
}

/// Every triangle has corners of its own where three or more meet in a way that a halfedge structure cannot hold: the
/// parity of crossings does not care, and closedness is checked before.
Mesh mesh_of(const Triangle_surface& s) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> v;
    for (const auto& p : s.points) v.push_back(mesh.add_vertex(cgal(p)));
    const auto at = [&](Index i) { return v[static_cast<std::size_t>(i)]; };
    for (const auto& t : s.triangles)
        if (mesh.add_face(at(t[0]), at(t[1]), at(t[2])) == Mesh::null_face()) {
            // Two sheets touch at a vertex.
            const auto twin = [&](Index i) { return mesh.add_vertex(cgal(s.points[static_cast<std::size_t>(i)])); };
            mesh.add_face(twin(t[0]), twin(t[1]), twin(t[2]));
        }
    return mesh;
}

}  // namespace

struct Surface_3::Tree {
    Tree(const Triangle_surface& s, bool crossings)
        : surface(sound(s, crossings)),
          mesh(mesh_of(surface)),
          tree(faces(mesh).first, faces(mesh).second, mesh),
          box(box_of(s)),
          marks(box, std::clamp<std::size_t>(160 * s.triangles.size(), 65'536, 16'777'216)) {
        tree.build();
        tree.accelerate_distance_queries();
        side.emplace(tree);
        mark();
        for (const auto f : mesh.faces()) {
            const auto h = mesh.halfedge(f);
            triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                   mesh.point(mesh.target(mesh.next(h))));
        }
        double sum = 0;
        for (const auto& t : surface.triangles) {
            const K::Point_3 p[3] = {corner(t, 0), corner(t, 1), corner(t, 2)};
            area_up_to.push_back(sum += std::sqrt(CGAL::squared_area(p[0], p[1], p[2])));
        }
    }

    static Box box_of(const Triangle_surface& s) {
        Box b{s.points[0], s.points[0]};
        for (const auto& p : s.points)
            for (std::size_t k = 0; k < 3; ++k) {
                b.lower[k] = std::min(b.lower[k], p[k]);
                b.upper[k] = std::max(b.upper[k], p[k]);
            }
        return b;
    }
    [[nodiscard]] K::Point_3 corner(const std::array<Index, 3>& t, std::size_t i) const {
        return cgal(surface.points[static_cast<std::size_t>(t[i])]);
    }
    void mark() {
        for (const auto& t : surface.triangles) {
            const K::Triangle_3 triangle(corner(t, 0), corner(t, 1), corner(t, 2));
            const CGAL::Bbox_3 b = triangle.bbox();
            const auto r = marks.range({{b.xmin(), b.ymin(), b.zmin()}, {b.xmax(), b.ymax(), b.zmax()}});
            const bool one = r[0][0] == r[0][1] && r[1][0] == r[1][1] && r[2][0] == r[2][1];
            for (std::size_t z = r[2][0]; z <= r[2][1]; ++z)
                for (std::size_t y = r[1][0]; y <= r[1][1]; ++y)
                    for (std::size_t x = r[0][0]; x <= r[0][1]; ++x) {
                        const Box v = marks.box({x, y, z});
                        if (one || CGAL::do_intersect(triangle, K::Iso_cuboid_3(cgal(v.lower), cgal(v.upper))))
                            marks.set_near({x, y, z});
                    }
        }
        marks.fill([this](const Coordinates<3>& p) { return (*side)(cgal(p)) == CGAL::ON_BOUNDED_SIDE; });
    }

    // The interface that Nearest_search needs.
    [[nodiscard]] const K::Triangle_3& triangle(std::int32_t number) const {
        return triangles[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] static Coordinates<3> project(const K::Triangle_3& t, const Coordinates<3>& p) {
        return ours(Guarded_kernel().construct_projected_point_3_object()(t, cgal(p)));
    }
    void list(const Coordinates<3>& centre, double reach, std::vector<Nearby_3::Part>& parts) const {
        Listing listing{&triangles, &parts};
        tree.traversal(Listing::Query{centre, reach}, listing);
    }
    [[nodiscard]] Coordinates<3> nearest(const Coordinates<3>& p) const { return ours(tree.closest_point(cgal(p))); }

    Triangle_surface surface;
    Mesh mesh;
    Aabb_tree tree;
    std::vector<K::Triangle_3> triangles;  // by the number of their face in the mesh
    Box box;
    Voxel_marks marks;
    std::optional<Side> side;
    std::vector<double> area_up_to;
};

Surface_3::Surface_3(const Triangle_surface& surface, bool crossings)
    : tree_(std::make_unique<const Tree>(surface, crossings)) {}
Surface_3::~Surface_3() = default;

bool Surface_3::contains(const Coordinates<3>& p) const {
    switch (tree_->marks.of(p)) {
        case Voxel_marks::Mark::inside: return true;
        case Voxel_marks::Mark::outside: return false;
        default: return contains_by_ray(p);
    }
}

bool Surface_3::contains_by_ray(const Coordinates<3>& p) const {
    for (std::size_t k = 0; k < 3; ++k)  // NaN and infinity, too
        if (!(p[k] >= tree_->box.lower[k] && p[k] <= tree_->box.upper[k])) return false;
    return (*tree_->side)(cgal(p)) == CGAL::ON_BOUNDED_SIDE;
}

Coordinates<3> Surface_3::project(const Coordinates<3>& p) const { return tree_->nearest(p); }

Coordinates<3> Surface_3::project(const Coordinates<3>& p, const Coordinates<3>& near, Nearby_3& nearby) const {
    return Nearest_search(*tree_, nearby).nearest(p, near);
}

std::optional<Coordinates<3>> Surface_3::crossing(const Coordinates<3>& a, const Coordinates<3>& b) const {
    if (!is_finite(a) || !is_finite(b)) return std::nullopt;
    const auto hit = tree_->tree.any_intersection(K::Segment_3(cgal(a), cgal(b)));
    if (!hit) return std::nullopt;
    if (const K::Point_3* p = alternative<K::Point_3>(hit->first)) {
        Coordinates<3> c = ours(*p);
        // That they meet is exact, the point is not: for a segment nearly in the plane of the triangle it may be
        // anywhere or NaN.
        for (std::size_t k = 0; k < 3; ++k)
            c[k] =
                std::isnan(c[k]) ? 0.5 * (a[k] + b[k]) : std::clamp(c[k], std::min(a[k], b[k]), std::max(a[k], b[k]));
        // On a segment that is long compared with the surface the rounding of a crossing is large, too: project it back
        // onto the surface.
        return project(c);
    }
    if (const K::Segment_3* s = alternative<K::Segment_3>(hit->first))
        return ours(CGAL::midpoint(s->source(), s->target()));
    return std::nullopt;
}

std::vector<Coordinates<3>> Surface_3::surface_sample(std::size_t n, std::uint64_t seed) const {
    std::mt19937_64 bits(seed);
    const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    const auto& areas = tree_->area_up_to;
    std::vector<Coordinates<3>> points;
    for (std::size_t i = 0; i < n; ++i) {
        const auto found = std::upper_bound(areas.begin(), areas.end(), unit() * areas.back());
        const auto& t =
            tree_->surface.triangles[std::min(static_cast<std::size_t>(found - areas.begin()), areas.size() - 1)];
        double s = unit(), u = unit();
        if (s + u > 1) s = 1 - s, u = 1 - u;  // fold the parallelogram onto the triangle
        const K::Point_3 p = tree_->corner(t, 0);
        points.push_back(ours(p + s * (tree_->corner(t, 1) - p) + u * (tree_->corner(t, 2) - p)));
    }
    return points;
}

Domain_3::Box Surface_3::bounding_box() const { return tree_->box; }
double Surface_3::volume() const { return enclosed_volume(tree_->surface); }

}  // namespace annulus::inline v1
