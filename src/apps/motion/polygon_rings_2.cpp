// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/polygon_rings_2.h>

#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

Epick::Point_2 place_of(const Coordinates<2>& p) { return {p[0], p[1]}; }

/// An edge of a ring; its corners are numbers of the list.
struct Edge {
    Listed_corner from, to;
    [[nodiscard]] Epick::Segment_2 segment() const { return {place_of(from.p), place_of(to.p)}; }
};

/// Whether two edges meet elsewhere than at a corner from which one goes on where the other ends.
bool meet(const Edge& a, const Edge& b) {
    if (a.to.index != b.from.index && b.to.index != a.from.index) return CGAL::do_intersect(a.segment(), b.segment());
    const Edge &before = a.to.index == b.from.index ? a : b, &after = &before == &a ? b : a;
    const Epick::Point_2 p = place_of(before.from.p), q = place_of(before.to.p), r = place_of(after.to.p);
    return CGAL::collinear(p, q, r) && !CGAL::collinear_are_strictly_ordered_along_line(p, q, r);
}

/// The first two edges of the list that meet.
std::optional<std::pair<std::size_t, std::size_t>> first_fault(const std::vector<Edge>& edges) {
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Edge*>;
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const Edge& edge : edges) boxes.emplace_back(edge.segment().bbox(), &edge);
    std::optional<std::pair<std::size_t, std::size_t>> first;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        const Edge &e = *std::min(a.handle(), b.handle()), &f = *std::max(a.handle(), b.handle());
        const std::pair pair{e.from.index, f.from.index};
        if ((!first || pair < *first) && meet(e, f)) first = pair;
    });
    return first;
}

}  // namespace

Polygon_edges_2 polygon_edges(std::span<const Coordinates<2>> corners, std::span<const std::size_t> begin) {
    if (corners.empty() || begin.empty()) throw Corner_error(0, "a polygon needs 3 corners that are not on a line");
    std::vector<Edge> edges;
    for (std::size_t r = 0; r < begin.size(); ++r) {
        const std::size_t end = r + 1 < begin.size() ? begin[r + 1] : corners.size();
        const std::vector<Listed_corner> ring = ring_corners(corners.subspan(begin[r], end - begin[r]), begin[r]);
        for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
    }
    if (const auto fault = first_fault(edges))
        throw Edge_error(fault->first, fault->second,
                         "edges of a polygon must meet at their common corners only; those that begin at corners " +
                             std::to_string(fault->first) + " and " + std::to_string(fault->second) +
                             ", counted from 0, meet elsewhere");
    Polygon_edges_2 result;
    for (const Edge& edge : edges) result.corner.push_back(edge.from.p);
    std::sort(result.corner.begin(), result.corner.end());
    const auto number = [&](const Coordinates<2>& p) {
        const auto found = std::lower_bound(result.corner.begin(), result.corner.end(), p);
        return static_cast<std::size_t>(found - result.corner.begin());
    };
    for (const Edge& edge : edges) {
        const auto [low, high] = std::minmax({number(edge.from.p), number(edge.to.p)});
        result.edge.push_back({low, high});
    }
    std::sort(result.edge.begin(), result.edge.end());
    return result;
}

}  // namespace annulus::inline v1
