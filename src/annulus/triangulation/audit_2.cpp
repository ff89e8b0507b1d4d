// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/triangulation/audit.h>

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// An integer that frees itself; temporaries are reused, allocation would dominate.
class Integer {
  public:
    Integer() { mpz_init(z_); }
    Integer(const Integer& o) { mpz_init_set(z_, o.z_); }
    Integer& operator=(const Integer& o) {
        mpz_set(z_, o.z_);
        return *this;
    }
    ~Integer() { mpz_clear(z_); }
    operator mpz_ptr() { return z_; }
    operator mpz_srcptr() const { return z_; }

  private:
    mpz_t z_;
};

int sign(const Integer& z) {
    const mpz_srcptr p = z;
    return mpz_sgn(p);
}

struct Site {
    Integer x;
    Integer y;
};

/// All coordinates times one power of two that makes them integers.
std::vector<Site> integer_sites(const std::vector<Coordinates<2>>& points) {
    int least = 1100;
    for (const auto& p : points)
        for (const double c : p) {
            int e = 0;
            if (c == 0.0) continue;
            (void)std::frexp(c, &e);
            least = std::min(least, e - 53);
        }
    const auto set = [least](Integer& z, double c) {
        if (c == 0.0) return;
        int e = 0;
        const double mantissa = std::frexp(c, &e);
        mpz_set_d(z, std::ldexp(mantissa, 53));
        mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(e - 53 - least));
    };
    std::vector<Site> sites(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        set(sites[i].x, points[i][0]);
        set(sites[i].y, points[i][1]);
    }
    return sites;
}

/// Exact predicates with their own temporaries.
class Judge {
  public:
    explicit Judge(const std::vector<Site>& s) : s_(s) {}

    /// Sign of (b - a) x (c - a).
    int turn(Index a, Index b, Index c) {
        const Site& A = s_[at(a)];
        sub(t_[0], s_[at(b)].x, A.x);
        sub(t_[1], s_[at(c)].y, A.y);
        sub(t_[2], s_[at(b)].y, A.y);
        sub(t_[3], s_[at(c)].x, A.x);
        mpz_mul(t_[4], t_[0], t_[1]);
        mpz_submul(t_[4], t_[2], t_[3]);
        return sign(t_[4]);
    }

    /// Positive when e is strictly inside the circle of the positive triangle a b c: the lifted 3 x 3 determinant.
    int inside(Index a, Index b, Index c, Index e) {
        const std::array<Index, 3> v{a, b, c};
        for (std::size_t i = 0; i < 3; ++i) {
            sub(dx_[i], s_[at(v[i])].x, s_[at(e)].x);
            sub(dy_[i], s_[at(v[i])].y, s_[at(e)].y);
            mpz_mul(lift_[i], dx_[i], dx_[i]);
            mpz_addmul(lift_[i], dy_[i], dy_[i]);
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

    /// Sign of the direction from a to b: +1 when it points up, or right when level; -1 otherwise.
    int half_plane(Index a, Index b) const {
        const int dy = mpz_cmp(s_[at(b)].y, s_[at(a)].y);
        if (dy != 0) return dy > 0 ? 1 : -1;
        return mpz_cmp(s_[at(b)].x, s_[at(a)].x) > 0 ? 1 : -1;
    }

  private:
    static void sub(Integer& r, const Integer& a, const Integer& b) { mpz_sub(r, a, b); }
    const std::vector<Site>& s_;
    std::array<Integer, 6> t_;
    std::array<Integer, 3> dx_;
    std::array<Integer, 3> dy_;
    std::array<Integer, 3> lift_;
};

void fault(Audit_result& r, std::uint64_t& counter, const std::string& words) {
    ++counter;
    if (r.first_fault.empty()) r.first_fault = words;
}

/// Words and vertices, counted from `first`.
struct Namer {
    Index first;
    std::string operator()(const char* what, std::initializer_list<Index> v) const {
        std::string s = what;
        for (const Index i : v) {
            s += ' ';
            s += std::to_string(static_cast<long long>(i) + first);
        }
        return s;
    }
};

std::vector<Index> lexicographic(const std::vector<Coordinates<2>>& p) {
    std::vector<Index> order(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) order[i] = static_cast<Index>(i);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return p[at(a)] < p[at(b)]; });
    return order;
}

/// Points that span no area: all collinear, and the edges join neighbours on the line.
Audit_result audit_flat(const Audit_input<2>& in, const Namer& named) {
    Audit_result r;
    const auto sites = integer_sites(in.points);
    Judge judge(sites);
    const std::vector<Index> order = lexicographic(in.points);
    for (std::size_t i = 2; i < order.size(); ++i)
        if (judge.turn(order[0], order[1], order[i]) != 0)
            fault(r, r.topological_faults, named("no triangle, but not collinear with the rest: vertex", {order[i]}));
    std::vector<std::array<Index, 2>> expected;
    for (std::size_t i = 1; i < order.size(); ++i)
        expected.push_back({std::min(order[i - 1], order[i]), std::max(order[i - 1], order[i])});
    std::vector<std::array<Index, 2>> found;
    if (order.size() <= 1 && !in.cells.empty())
        fault(r, r.topological_faults, "cells, but not two points to join");
    if (order.size() > 1)
        for (const auto& c : in.cells) found.push_back({std::min(c[0], c[1]), std::max(c[0], c[1])});
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    if (expected != found) fault(r, r.topological_faults, "the edges do not join consecutive points of the line");
    return r;
}

}  // namespace

Audit_result audit(const Audit_input<2>& in, Index first_index) {
    const Namer named{first_index};
    Audit_result r;
    const std::vector<Index> order = lexicographic(in.points);
    for (std::size_t i = 1; i < order.size(); ++i)
        if (in.points[at(order[i - 1])] == in.points[at(order[i])])
            fault(r, r.topological_faults, named("two vertices at one place:", {order[i - 1], order[i]}));
    const bool solid = std::any_of(in.cells.begin(), in.cells.end(), [](const auto& c) { return c[2] != none; });
    if (!solid) {
        Audit_result flat = audit_flat(in, named);
        flat.topological_faults += r.topological_faults;
        if (!r.first_fault.empty()) flat.first_fault = r.first_fault;
        return flat;
    }

    const std::size_t n = in.points.size();
    const auto sites = integer_sites(in.points);
    Judge judge(sites);
    std::vector<char> used(n, 0);
    // Directed edge a -> b of a cell, with its opposite vertex.
    std::unordered_map<std::uint64_t, Index> opposite;
    opposite.reserve(3 * in.cells.size());
    const auto key = [](Index a, Index b) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
    };
    for (const auto& c : in.cells) {
        if (*std::min_element(c.begin(), c.end()) < 0 || at(*std::max_element(c.begin(), c.end())) >= n) {
            fault(r, r.topological_faults, named("a cell names a vertex that is not there:", {c[0], c[1], c[2]}));
            return r;
        }
        for (const Index v : c) used[at(v)] = 1;
        if (judge.turn(c[0], c[1], c[2]) <= 0)
            fault(r, r.inverted_cells, named("cell not positively oriented:", {c[0], c[1], c[2]}));
        for (std::size_t i = 0; i < 3; ++i)
            if (!opposite.emplace(key(c[(i + 1) % 3], c[(i + 2) % 3]), c[i]).second)
                fault(r, r.topological_faults,
                      named("two cells on one side of the edge", {c[(i + 1) % 3], c[(i + 2) % 3]}));
    }
    for (std::size_t v = 0; v < n; ++v)
        if (!used[v]) fault(r, r.topological_faults, named("vertex in no cell:", {static_cast<Index>(v)}));

    // Interior edges are locally Delaunay; border edges a -> b (interior on their left) give the next on the border.
    std::unordered_map<Index, Index> next;
    for (const auto& [edge, apex] : opposite) {
        const auto a = static_cast<Index>(edge >> 32);
        const auto b = static_cast<Index>(edge & 0xffffffffU);
        const auto other = opposite.find(key(b, a));
        if (other == opposite.end()) {
            if (!next.emplace(a, b).second)
                fault(r, r.topological_faults, named("the border passes twice through vertex", {a}));
            continue;
        }
        if (a > b) continue;
        const int side = judge.inside(a, b, apex, other->second);
        if (side == 0) ++r.degenerate_facets;
        if (side > 0)
            fault(r, r.violated_facets, named("not locally Delaunay: edge, opposites", {a, b, apex, other->second}));
    }
    // One closed border, convex, turning once: the direction enters the upper half-plane exactly once.
    if (next.empty()) {
        fault(r, r.topological_faults, "no border");
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
            fault(r, r.topological_faults, named("the border is open at vertex", {a}));
            return r;
        }
        const int turn = judge.turn(a, b->second, c->second);
        const int before = judge.half_plane(a, b->second);
        const int after = judge.half_plane(b->second, c->second);
        if (turn < 0)
            fault(r, r.concave_ridges, named("border not convex at", {a, b->second, c->second}));
        if (turn == 0 && before != after)
            fault(r, r.concave_ridges, named("border folds back at", {a, b->second, c->second}));
        if (before < 0 && after > 0) ++turns;
        a = b->second;
        ++length;
    } while (a != first && length <= next.size());
    if (length != next.size()) fault(r, r.topological_faults, "the border is more than one closed curve");
    if (turns != 1) fault(r, r.topological_faults, "the border does not wind once");
    return r;
}

}  // namespace annulus
