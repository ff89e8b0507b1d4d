// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/audit_points.h>

#include <unordered_map>

namespace annulus::inline v1 {

namespace auditing {

int Audit_predicates_2::turn(Index a, Index b, Index c) {
    const Point& A = s_[at(a)];
    const Point& B = s_[at(b)];
    const Point& C = s_[at(c)];
    mpz_sub(t_[0], *B.x, *A.x);
    mpz_sub(t_[1], *C.y, *A.y);
    mpz_sub(t_[2], *B.y, *A.y);
    mpz_sub(t_[3], *C.x, *A.x);
    mpz_mul(t_[4], t_[0], t_[1]);
    mpz_submul(t_[4], t_[2], t_[3]);
    return sign(t_[4]);
}

int Audit_predicates_2::inside(Index a, Index b, Index c, Index e) {
    const std::array<Index, 3> v{a, b, c};
    const Point& E = s_[at(e)];
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& V = s_[at(v[i])];
        mpz_sub(dx_[i], *V.x, *E.x);
        mpz_sub(dy_[i], *V.y, *E.y);
        mpz_mul(lift_[i], dx_[i], dx_[i]);
        mpz_addmul(lift_[i], dy_[i], dy_[i]);
        if (V.z != nullptr) {
            mpz_sub(t_[4], *V.z, *E.z);
            mpz_addmul(lift_[i], t_[4], t_[4]);
        }
    }
    mpz_set_ui(t_[5], 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        mpz_mul(t_[4], dx_[j], dy_[k]);
        mpz_submul(t_[4], dx_[k], dy_[j]);
        mpz_addmul(t_[5], t_[4], lift_[i]);
    }
    return sign(t_[5]);
}

int Audit_predicates_2::half_plane(Index a, Index b) const {
    const int dy = mpz_cmp(*s_[at(b)].y, *s_[at(a)].y);
    if (dy != 0) return dy > 0 ? 1 : -1;
    return mpz_cmp(*s_[at(b)].x, *s_[at(a)].x) > 0 ? 1 : -1;
}

Audit_result audit_plane(Audit_predicates_2& predicates, std::size_t n, const std::vector<std::array<Index, 3>>& cells,
                         Findings r) {
    std::vector<char> used(n, 0);
    // Directed edge a -> b of a cell, with its opposite vertex.
    std::unordered_map<std::uint64_t, Index> opposite;
    opposite.reserve(3 * cells.size());
    const auto key = [](Index a, Index b) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
    };
    for (const auto& c : cells) {
        r.poll();
        if (*std::min_element(c.begin(), c.end()) < 0 || at(*std::max_element(c.begin(), c.end())) >= n) {
            fault(r, Fault::unknown_vertex, "a cell names a vertex that is not there:", {c[0], c[1], c[2]});
            return r;
        }
        for (const Index v : c) used[at(v)] = 1;
        if (predicates.turn(c[0], c[1], c[2]) <= 0)
            fault(r, Fault::flat_cell, "cell not positively oriented:", {c[0], c[1], c[2]});
        for (std::size_t i = 0; i < 3; ++i)
            if (!opposite.emplace(key(c[(i + 1) % 3], c[(i + 2) % 3]), c[i]).second)
                fault(r, Fault::overlap, "two cells on one side of the edge", {c[(i + 1) % 3], c[(i + 2) % 3]},
                      {opposite.at(key(c[(i + 1) % 3], c[(i + 2) % 3])), c[i]});
    }
    for (std::size_t v = 0; v < n; ++v)
        if (!used[v]) fault(r, Fault::unused_vertex, "vertex in no cell:", {static_cast<Index>(v)});

    // Interior edges must be locally Delaunay. Border edges a -> b, with the interior on their left, define `next`.
    std::unordered_map<Index, Index> next;
    for (const auto& [edge, apex] : opposite) {
        r.poll();
        const auto a = static_cast<Index>(edge >> 32);
        const auto b = static_cast<Index>(edge & 0xffffffffU);
        const auto other = opposite.find(key(b, a));
        if (other == opposite.end()) {
            if (!next.emplace(a, b).second) fault(r, Fault::hull_broken, "the border passes twice through vertex", {a});
            continue;
        }
        if (a > b) continue;
        const int side = predicates.inside(a, b, apex, other->second);
        if (side == 0) ++r.degenerate_facets;
        if (side > 0)
            fault(r, Fault::not_delaunay, "not locally Delaunay: edge, opposites", {a, b, apex, other->second});
    }
    // The border must be one closed curve, convex, and turn once: its direction enters the upper half-plane exactly
    // once.
    if (next.empty()) {
        fault(r, Fault::hull_broken, "no border");
        return r;
    }
    std::size_t length = 0;
    int turns = 0;
    const Index first = next.begin()->first;
    Index a = first;
    do {
        const auto b = next.find(a);
        const auto c = b == next.end() ? next.end() : next.find(b->second);
        if (c == next.end()) {
            fault(r, Fault::hull_broken, "the border is open at vertex", {a});
            return r;
        }
        const int turn = predicates.turn(a, b->second, c->second);
        const int before = predicates.half_plane(a, b->second);
        const int after = predicates.half_plane(b->second, c->second);
        if (turn < 0) fault(r, Fault::hull_not_convex, "border not convex at", {a, b->second, c->second});
        if (turn == 0 && before != after)
            fault(r, Fault::hull_not_convex, "border folds back at", {a, b->second, c->second});
        if (before < 0 && after > 0) ++turns;
        a = b->second;
        ++length;
    } while (a != first && length <= next.size());
    if (length != next.size()) fault(r, Fault::hull_broken, "the border is more than one closed curve");
    if (turns != 1) fault(r, Fault::hull_broken, "the border does not wind once");
    return r;
}

}  // namespace auditing

Audit_result audit(const Audit_input<2>& in, Index first_index) {
    using namespace auditing;
    Findings r(in, first_index);
    const std::vector<Index> order = lexicographic<2>(in.points);
    find_duplicates<2>(in.points, order, r);
    const auto sites = integer_points<2>(in.points);
    std::vector<Audit_predicates_2::Point> points;
    for (const auto& s : sites) points.push_back({&s[0], &s[1]});
    Audit_predicates_2 predicates(std::move(points));
    if (std::any_of(in.cells.begin(), in.cells.end(), [](const auto& c) { return c[2] != none; }))
        return audit_plane(predicates, in.points.size(), in.cells, std::move(r));
    // Points that span no area must all be collinear, and the edges must join neighbours on the line.
    for (std::size_t i = 2; i < order.size(); ++i)
        if (predicates.turn(order[0], order[1], order[i]) != 0)
            fault(r, Fault::not_flat, "no triangle, but not collinear with the rest: vertex", {order[i]});
    expect_chain(in.cells, order, r);
    return r;
}

}  // namespace annulus::inline v1
