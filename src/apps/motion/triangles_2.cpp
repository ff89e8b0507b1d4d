// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/triangles_2.h>

#include <apps/motion/vector_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace annulus::inline v1 {

namespace {

namespace bg = boost::geometry;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Epick>;
/// Whether a face was visited, and whether an odd number of rings encloses it.
enum class Place : char { unknown, outside, inside };
using Faces =
    CGAL::Constrained_triangulation_face_base_2<Epick, CGAL::Triangulation_face_base_with_info_2<Place, Epick>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Epick, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                               CGAL::No_constraint_intersection_tag>;

using Tree_point = bg::model::point<double, 2, bg::cs::cartesian>;
using Tree_box = bg::model::box<Tree_point>;
using Entry = std::pair<Tree_box, std::size_t>;
using Tree = bg::index::rtree<Entry, bg::index::rstar<16>>;

Epick::Point_2 point(const Coordinates<2>& p) { return {p[0], p[1]}; }

Tree_box tree_box(const Rectangle_2& r) { return {{r.lower[0], r.lower[1]}, {r.upper[0], r.upper[1]}}; }

Rectangle_2 around(std::span<const Coordinates<2>> points) {
    Rectangle_2 box{points[0], points[0]};
    for (const Coordinates<2>& p : points)
        for (std::size_t k = 0; k < 2; ++k) {
            box.lower[k] = std::min(box.lower[k], p[k]);
            box.upper[k] = std::max(box.upper[k], p[k]);
        }
    return box;
}

Rectangle_2 widened(Rectangle_2 box, double slack) {
    for (std::size_t k = 0; k < 2; ++k) {
        box.lower[k] -= slack;
        box.upper[k] += slack;
    }
    return box;
}

/// The outward side from a to b, computed from the lesser of the two.
Half_plane_2 side_of(const Coordinates<2>& a, const Coordinates<2>& b) {
    const bool turned = b < a;
    const Coordinates<2>& from = turned ? b : a;
    const Coordinates<2> d = minus(turned ? a : b, from);
    const double length = norm(d);
    Half_plane_2 side{{d[1] / length, -d[0] / length}, 0};
    side.bound = dot(side.normal, from);
    if (turned) side = {{-side.normal[0], -side.normal[1]}, -side.bound};
    return side;
}

Triangle_2 triangle_of(std::array<Coordinates<2>, 3> corner) {
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    Triangle_2 t{corner, {}};
    for (std::size_t i = 0; i < 3; ++i) t.side[i] = side_of(corner[i], corner[(i + 1) % 3]);
    return t;
}

/// From the outside inwards; behind an edge of a ring the place is the other one.
void mark(Triangulation& dt) {
    dt.infinite_face()->info() = Place::outside;
    std::vector<Triangulation::Face_handle> waiting{dt.infinite_face()};
    while (!waiting.empty()) {
        const Triangulation::Face_handle face = waiting.back();
        waiting.pop_back();
        for (int i = 0; i < 3; ++i) {
            const Triangulation::Face_handle next = face->neighbor(i);
            if (next->info() != Place::unknown) continue;
            const bool inside = (face->info() == Place::inside) != face->is_constrained(i);
            next->info() = inside ? Place::inside : Place::outside;
            waiting.push_back(next);
        }
    }
}

bool in_triangle(const Triangle_2& t, const Coordinates<2>& p) {
    for (std::size_t i = 0; i < 3; ++i)
        if (CGAL::orientation(point(t.corner[i]), point(t.corner[(i + 1) % 3]), point(p)) == CGAL::RIGHT_TURN)
            return false;
    return true;
}

/// Whether the segment comes within the rectangle. Precondition: their bounding boxes meet.
bool comes_into(const std::array<Coordinates<2>, 2>& segment, const Rectangle_2& box, double slack) {
    const Half_plane_2 line = side_of(segment[0], segment[1]);
    bool left = false, right = false;
    for (const double x : {box.lower[0], box.upper[0]})
        for (const double y : {box.lower[1], box.upper[1]}) {
            const double height = dot(line.normal, {x, y}) - line.bound;
            left = left || height <= slack;
            right = right || height >= -slack;
        }
    return left && right;
}

}  // namespace

struct Triangles_2::Trees {
    Tree triangles, edges;
};

Triangles_2::Triangles_2(const Polygon_edges_2& edges) {
    Triangulation dt;
    std::vector<std::pair<Epick::Point_2, std::size_t>> points;
    for (std::size_t i = 0; i < edges.corner.size(); ++i) points.emplace_back(point(edges.corner[i]), i);
    dt.insert(points.begin(), points.end());
    std::vector<Triangulation::Vertex_handle> vertex(points.size());
    for (const Triangulation::Vertex_handle v : dt.finite_vertex_handles()) vertex[v->info()] = v;
    for (const auto& [a, b] : edges.edge) {
        dt.insert_constraint(vertex[a], vertex[b]);
        edge_.push_back({edges.corner[a], edges.corner[b]});
    }
    for (const Triangulation::Face_handle f : dt.all_face_handles()) f->info() = Place::unknown;
    mark(dt);
    for (const Triangulation::Face_handle f : dt.finite_face_handles())
        if (f->info() == Place::inside)
            triangle_.push_back(triangle_of({edges.corner[f->vertex(0)->info()], edges.corner[f->vertex(1)->info()],
                                             edges.corner[f->vertex(2)->info()]}));
    const auto before = [](const Triangle_2& a, const Triangle_2& b) { return a.corner < b.corner; };
    std::sort(triangle_.begin(), triangle_.end(), before);
    std::vector<Entry> triangles, sides;
    for (std::size_t i = 0; i < triangle_.size(); ++i) triangles.emplace_back(tree_box(around(triangle_[i].corner)), i);
    for (std::size_t i = 0; i < edge_.size(); ++i) sides.emplace_back(tree_box(around(edge_[i])), i);
    trees_ = std::make_unique<const Trees>(Trees{Tree(triangles), Tree(sides)});
}

Triangles_2::~Triangles_2() = default;

void Triangles_2::near(const Rectangle_2& box, std::vector<std::size_t>& numbers) const {
    numbers.clear();
    const auto add = boost::make_function_output_iterator([&](const Entry& e) { numbers.push_back(e.second); });
    trees_->triangles.query(bg::index::intersects(tree_box(box)), add);
    std::sort(numbers.begin(), numbers.end());
}

bool Triangles_2::edge_near(const Rectangle_2& box, double slack) const {
    const auto comes = [&](const Entry& e) { return comes_into(edge_[e.second], box, slack); };
    const auto found =
        trees_->edges.qbegin(bg::index::intersects(tree_box(widened(box, slack))) && bg::index::satisfies(comes));
    return found != trees_->edges.qend();
}

bool Triangles_2::contains(const Coordinates<2>& p) const {
    const auto has = [&](const Entry& e) { return in_triangle(triangle_[e.second], p); };
    const auto found = trees_->triangles.qbegin(bg::index::intersects(tree_box({p, p})) && bg::index::satisfies(has));
    return found != trees_->triangles.qend();
}

std::size_t Triangles_2::edge_at(const Coordinates<2>& p, double distance) const {
    std::size_t nearest = edge_.size();
    double least = distance;
    const auto add = boost::make_function_output_iterator([&](const Entry& e) {
        const double far = norm(minus(nearest_on(edge_[e.second], p), p));
        if (far > least || (far == least && e.second > nearest)) return;
        least = far;
        nearest = e.second;
    });
    trees_->edges.query(bg::index::intersects(tree_box(widened({p, p}, distance))), add);
    return nearest;
}

Coordinates<2> nearest_on(const std::array<Coordinates<2>, 2>& segment, const Coordinates<2>& p) {
    const Coordinates<2> d = minus(segment[1], segment[0]);
    const double t = std::clamp(dot(minus(p, segment[0]), d) / dot(d, d), 0.0, 1.0);
    return {segment[0][0] + t * d[0], segment[0][1] + t * d[1]};
}

}  // namespace annulus::inline v1
