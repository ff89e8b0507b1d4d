// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the audits of both dimensions share: coordinates as integers, and the record of faults.
#include <annulus/audit.h>
#include <annulus/mesh/at.h>

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace annulus::inline v1::auditing {

/// An integer that frees itself. Temporaries are reused, because allocation would dominate.
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

inline int sign(const Integer& z) {
    const mpz_srcptr p = z;
    return mpz_sgn(p);
}

template <int d>
using Integer_point = std::array<Integer, static_cast<std::size_t>(d)>;

/// All coordinates, multiplied by one power of two that makes them integers.
template <int d>
std::vector<Integer_point<d>> integer_points(const std::vector<Coordinates<d>>& points) {
    int least = 1100;
    for (const auto& p : points)
        for (const double c : p) {
            int e = 0;
            if (c == 0.0) continue;
            (void)std::frexp(c, &e);
            least = std::min(least, e - 53);
        }
    std::vector<Integer_point<d>> sites(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < points[i].size(); ++k) {
            if (points[i][k] == 0.0) continue;
            int e = 0;
            const double mantissa = std::frexp(points[i][k], &e);
            mpz_set_d(sites[i][k], std::ldexp(mantissa, 53));
            mpz_mul_2exp(sites[i][k], sites[i][k], static_cast<mp_bitcnt_t>(e - 53 - least));
        }
    return sites;
}

/// The result of an audit so far, with the names of vertices and the function that is called between two parts of the
/// work.
struct Findings : Audit_result {
    template <int d>
    Findings(const Audit_input<d>& input, Index first_index)
        : first(first_index), names(input.names), between(input.between), most_faults(input.most_faults) {}

    [[nodiscard]] long long name_of(Index i) const {
        if (i >= 0 && at(i) < names.size()) i = names[at(i)];
        return static_cast<long long>(i) + first;
    }
    /// To be called once per cell or facet. Calls `between` every 1024th time, that is after a few milliseconds at
    /// most.
    void poll() {
        if (++steps % 1024 == 0 && between) between();
    }

    Index first;
    std::span<const Index> names;
    const std::function<void()>& between;
    std::size_t most_faults;
    std::uint32_t steps = 0;
};

/// A text followed by vertices under the caller's names.
inline std::string named(const Findings& r, const char* what, std::initializer_list<Index> v) {
    std::string s = what;
    for (const Index i : v) {
        s += ' ';
        s += std::to_string(r.name_of(i));
    }
    return s;
}

inline std::uint64_t& count_of(Audit_result& r, Fault kind) {
    if (kind == Fault::flat_cell) return r.inverted_cells;
    if (kind == Fault::not_delaunay) return r.violated_facets;
    return kind == Fault::hull_not_convex ? r.concave_ridges : r.topological_faults;
}

/// Counts a fault, and lists it while there is room: a text, the vertices that it names, and others for the list only.
inline void fault(Findings& r, Fault kind, const char* what, std::initializer_list<Index> v = {},
                  std::initializer_list<Index> unnamed = {}) {
    ++count_of(r, kind);
    if (!r.first_fault.empty() && r.faults.size() >= r.most_faults) return;
    std::string text = named(r, what, v);
    if (r.first_fault.empty()) r.first_fault = text;
    if (r.faults.size() >= r.most_faults) return;
    Audit_fault& f = r.faults.emplace_back();
    f.kind = kind;
    f.text = std::move(text);
    std::size_t k = 0;
    for (const auto& list : {v, unnamed})
        for (const Index i : list) f.vertices[k++] = static_cast<Index>(r.name_of(i));
}

template <int d>
std::vector<Index> lexicographic(const std::vector<Coordinates<d>>& p) {
    std::vector<Index> order(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) order[i] = static_cast<Index>(i);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return p[at(a)] < p[at(b)]; });
    return order;
}

/// Records vertices at one position. `order` is lexicographic.
template <int d>
void find_duplicates(const std::vector<Coordinates<d>>& p, const std::vector<Index>& order, Findings& r) {
    for (std::size_t i = 1; i < order.size(); ++i)
        if (p[at(order[i - 1])] == p[at(order[i])])
            fault(r, Fault::duplicate_point, "two vertices at one place:", {order[i - 1], order[i]});
}

/// Compares the edges with those that join consecutive points of a line; `order` is lexicographic.
template <std::size_t k>
void expect_chain(const std::vector<std::array<Index, k>>& cells, const std::vector<Index>& order, Findings& r) {
    if (order.size() <= 1 && !cells.empty()) fault(r, Fault::hull_broken, "cells, but not two points to join");
    if (order.size() <= 1) return;
    std::vector<std::array<Index, 2>> expected;
    for (std::size_t i = 1; i < order.size(); ++i)
        expected.push_back({std::min(order[i - 1], order[i]), std::max(order[i - 1], order[i])});
    std::vector<std::array<Index, 2>> found;
    for (const auto& c : cells) found.push_back({std::min(c[0], c[1]), std::max(c[0], c[1])});
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    if (expected != found) fault(r, Fault::hull_broken, "the edges do not join consecutive points of the line");
}

/// Points of a plane in 3D, seen from one of its sides: orientation and circles by integers. Lengths are measured in
/// 3D, so that circles are circles.
class Audit_predicates_2 {
  public:
    /// A point with two coordinates that orientations use, and optionally a third that only adds to the squared
    /// lengths.
    struct Point {
        const Integer* x;
        const Integer* y;
        const Integer* z = nullptr;
    };
    explicit Audit_predicates_2(std::vector<Point> points) : s_(std::move(points)) {}

    /// Sign of (b - a) x (c - a).
    int turn(Index a, Index b, Index c);
    /// Positive when e is strictly inside the circle of the positive triangle a b c: the lifted 3 x 3 determinant.
    int inside(Index a, Index b, Index c, Index e);
    /// Sign of the direction from a to b: +1 when it points up, or right when level; -1 otherwise.
    [[nodiscard]] int half_plane(Index a, Index b) const;

  private:
    std::vector<Point> s_;
    std::array<Integer, 6> t_;
    std::array<Integer, 3> dx_;
    std::array<Integer, 3> dy_;
    std::array<Integer, 3> lift_;
};

/// The audit of triangles that fill a convex polygon; r has what is known already.
Audit_result audit_plane(Audit_predicates_2& predicates, std::size_t vertices,
                         const std::vector<std::array<Index, 3>>& cells, Findings r);

}  // namespace annulus::inline v1::auditing
