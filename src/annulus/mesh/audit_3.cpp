// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary is checked first. If every boundary triangle has its inner side towards a point o, the boundary
// projects to the directions seen from o as a covering that may branch only at vertices; its number of sheets is the
// number of triangles that any one ray meets. With one sheet it does not branch: the boundary is star-shaped and
// embedded, and as it is convex at its edges, it is convex. Positive cells with this boundary cover every point inside
// once and none outside, because the number of cells at a point that is on no facet is how often the boundary winds
// around it.
#include <annulus/mesh/audit_predicates_3.h>

#include <unordered_map>

namespace annulus::inline v1 {

namespace {

using namespace auditing;

struct Triple_hash {
    std::size_t operator()(const Triple& t) const {
        std::uint64_t h = 0;
        for (const Index v : t) h = (h ^ static_cast<std::uint32_t>(v)) * 0x9e3779b97f4a7c15U;
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
};

/// A triangle with its least vertex first, rotated but not reversed.
Triple canonical(Triple t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

/// The facets of a positive cell as seen from outside, then the vertex behind.
constexpr std::array<std::array<std::size_t, 4>, 4> outer_facets{
    {{1, 2, 3, 0}, {0, 3, 2, 1}, {0, 1, 3, 2}, {0, 2, 1, 3}}};

/// Checks that a boundary is one convex surface, covered once. The triangles of `border` turn left as seen from
/// outside.
void audit_border(Audit_predicates_3& predicates, const Cell& any, const std::vector<Triple>& border, Findings& r) {
    if (border.empty()) {
        fault(r, Fault::hull_broken, "no boundary");
        return;
    }
    // Directed edge a -> b and the third vertex of the triangle on its left.
    std::unordered_map<std::uint64_t, Index> left;
    left.reserve(3 * border.size());
    const auto key = [](Index a, Index b) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
    };
    for (const Triple& f : border)
        for (std::size_t i = 0; i < 3; ++i)
            if (!left.emplace(key(f[i], f[(i + 1) % 3]), f[(i + 2) % 3]).second)
                fault(r, Fault::hull_broken, "two boundary triangles on one side of the edge", {f[i], f[(i + 1) % 3]});
    for (const auto& [edge, c] : left) {
        const auto a = static_cast<Index>(edge >> 32);
        const auto b = static_cast<Index>(edge & 0xffffffffU);
        const auto other = left.find(key(b, a));
        if (other == left.end()) {
            fault(r, Fault::hull_broken, "the boundary is open at the edge", {a, b});
            continue;
        }
        if (a > b) continue;
        const int side = predicates.orientation(a, b, c, other->second);  // positive: outside the triangle a b c
        if (side > 0 || (side == 0 && !predicates.opposite(a, b, c, other->second)))
            fault(r, Fault::hull_not_convex, "boundary not convex at edge, opposites", {a, b, c, other->second});
    }
    predicates.take_middle(any);
    bool star_shaped = true;
    for (const Triple& f : border)
        if (predicates.orientation_of_middle(f) >= 0) {
            if (star_shaped)
                fault(r, Fault::hull_not_convex, "a cell is not behind the boundary triangle", {f[0], f[1], f[2]});
            star_shaped = false;
        }
    if (!star_shaped) return;
    std::size_t sheets = 0;
    for (const Triple& f : border)
        if (predicates.meets(f, border.front())) ++sheets;
    if (sheets != 1) fault(r, Fault::hull_broken, "the boundary does not wind once");
}

/// The audit of points that span no volume.
Audit_result audit_flat(const Audit_input<3>& in, const std::vector<Index>& order, Findings r) {
    const auto sites = integer_points<3>(in.points);
    Audit_predicates_3 predicates(sites);
    const bool triangles = std::any_of(in.cells.begin(), in.cells.end(), [](const Cell& c) { return c[2] != none; });
    if (!triangles) {
        for (std::size_t i = 2; i < order.size(); ++i)
            if (!predicates.collinear(order[0], order[1], order[i]))
                fault(r, Fault::not_flat, "no triangle, but not collinear with the rest: vertex", {order[i]});
        expect_chain(in.cells, order, r);
        return r;
    }
    std::vector<Triple> cells;
    for (const Cell& c : in.cells) {
        if (*std::min_element(c.begin(), c.begin() + 3) < 0 ||
            at(*std::max_element(c.begin(), c.end())) >= sites.size()) {
            fault(r, Fault::unknown_vertex, "a cell names a vertex that is not there:", {c[0], c[1], c[2]});
            return r;
        }
        cells.push_back({c[0], c[1], c[2]});
    }
    const Triple first = cells.front();
    for (Index v = 0; at(v) < sites.size(); ++v)
        if (predicates.orientation(first[0], first[1], first[2], v) != 0)
            fault(r, Fault::not_flat, "no cell, but not coplanar with the rest: vertex", {v});
    // Seen along an axis along which the first triangle has an area, from the side on which it turns left.
    std::size_t axis = 0;
    while (axis < 3 && predicates.turn(first[0], first[1], first[2], axis) == 0) ++axis;
    if (axis == 3) {
        fault(r, Fault::flat_cell, "cell not positively oriented:", {first[0], first[1], first[2]});
        return r;
    }
    std::size_t x = (axis + 1) % 3;
    std::size_t y = (axis + 2) % 3;
    if (predicates.turn(first[0], first[1], first[2], axis) < 0) std::swap(x, y);
    std::vector<Audit_predicates_2::Point> points;
    for (const auto& s : sites) points.push_back({&s[x], &s[y], &s[axis]});
    Audit_predicates_2 plane(std::move(points));
    return audit_plane(plane, sites.size(), cells, std::move(r));
}

}  // namespace

Audit_result audit(const Audit_input<3>& in, Index first_index) {
    Findings r(in, first_index);
    const std::vector<Index> order = lexicographic<3>(in.points);
    find_duplicates<3>(in.points, order, r);
    if (std::none_of(in.cells.begin(), in.cells.end(), [](const Cell& c) { return c[3] != none; }))
        return audit_flat(in, order, std::move(r));

    const std::size_t n = in.points.size();
    const auto sites = integer_points<3>(in.points);
    Audit_predicates_3 predicates(sites);
    std::vector<char> used(n, 0);
    // A facet as seen from outside its cell, and the vertex behind it.
    std::unordered_map<Triple, Index, Triple_hash> behind;
    behind.reserve(4 * in.cells.size());
    std::vector<std::uint64_t> edges;
    for (const Cell& c : in.cells) {
        r.poll();
        if (*std::min_element(c.begin(), c.end()) < 0 || at(*std::max_element(c.begin(), c.end())) >= n) {
            fault(r, Fault::unknown_vertex, "a cell names a vertex that is not there:", {c[0], c[1], c[2], c[3]});
            return r;
        }
        for (const Index v : c) used[at(v)] = 1;
        if (predicates.orientation(c[0], c[1], c[2], c[3]) <= 0)
            fault(r, Fault::flat_cell, "cell not positively oriented:", {c[0], c[1], c[2], c[3]});
        for (const auto& f : outer_facets)
            if (!behind.emplace(canonical({c[f[0]], c[f[1]], c[f[2]]}), c[f[3]]).second)
                fault(r, Fault::overlap, "two cells on one side of the facet", {c[f[0]], c[f[1]], c[f[2]]},
                      {behind.at(canonical({c[f[0]], c[f[1]], c[f[2]]})), c[f[3]]});
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                edges.push_back((static_cast<std::uint64_t>(std::min(c[i], c[j])) << 32) |
                                static_cast<std::uint32_t>(std::max(c[i], c[j])));
    }
    for (std::size_t v = 0; v < n; ++v)
        if (!used[v]) fault(r, Fault::unused_vertex, "vertex in no cell:", {static_cast<Index>(v)});

    std::vector<Triple> border;
    for (const auto& [f, q] : behind) {
        r.poll();
        const auto other = behind.find(canonical({f[0], f[2], f[1]}));
        if (other == behind.end()) {
            border.push_back(f);
            continue;
        }
        if (f[1] > f[2]) continue;
        // From inside, f turns the other way.
        const int side = predicates.inside({f[0], f[2], f[1], q}, other->second);
        if (side == 0) ++r.degenerate_facets;
        if (side > 0)
            fault(r, Fault::not_delaunay, "not locally Delaunay: facet, opposites",
                  {f[0], f[1], f[2], q, other->second});
    }
    std::sort(edges.begin(), edges.end());
    const auto e = static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
    const std::size_t facets = border.size() + (behind.size() - border.size()) / 2;
    if (n + facets != e + in.cells.size() + 1) fault(r, Fault::hull_broken, "Euler's relation fails");
    audit_border(predicates, in.cells.front(), border, r);
    return r;
}

}  // namespace annulus::inline v1
