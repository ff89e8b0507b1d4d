// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/certificate_attack.h>

#include <annulus/engine/displacement.h>
#include <annulus/predicate/filtered.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

using Point = Coordinates<3>;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether the certificate of these points fails, exactly. A cell of a bi-cell that is not positive is a failure, too.
bool fails(std::span<const Point> x) {
    const auto positive = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t e) {
        return orientation_exact(Tuple<3, 4>{&x[a], &x[b], &x[c], &x[e]}).sign > 0;
    };
    if (x.size() == 4) return !positive(0, 1, 2, 3);
    return empty_sphere_exact(Tuple<3, 5>{&x[0], &x[1], &x[2], &x[3], &x[4]}).sign < 0 || !positive(0, 1, 2, 4) ||
           !positive(1, 0, 2, 3);
}

/// Directions for points: along way[i], of any length, towards the other side of an annulus or a slab.
using Ways = std::vector<Point>;

/// The annulus with three of the points on one sphere and two on the other: they move towards its middle.
std::optional<Ways> annulus_ways(std::span<const Point> x, const std::array<std::size_t, 3>& three,
                                 const std::array<std::size_t, 2>& two) {
    const Point &o = x[three[0]], u = x[three[1]] - o, v = x[three[2]] - o, p = x[two[0]] - o, q = x[two[1]] - o,
                w = q - p;
    // The centre, from o: u.c = |u|^2/2, v.c = |v|^2/2, w.c = (|q|^2 - |p|^2)/2.
    const double k0 = 0.5 * dot(u, u), k1 = 0.5 * dot(v, v), k2 = 0.5 * (dot(q, q) - dot(p, p));
    const Point vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const double det = dot(u, vw);
    Point centre{};
    for (std::size_t k = 0; k < 3; ++k) centre[k] = (k0 * vw[k] + k1 * wu[k] + k2 * uv[k]) / det;
    const double inner = std::sqrt(dot(centre, centre)), outer = std::sqrt(dot(p - centre, p - centre));
    if (!std::isfinite(inner) || !std::isfinite(outer)) return std::nullopt;
    const double sign = inner < outer ? 1 : -1;
    Ways ways(x.size());
    for (const std::size_t i : three)
        for (std::size_t k = 0; k < 3; ++k) ways[i][k] = sign * (x[i][k] - o[k] - centre[k]);
    for (const std::size_t i : two)
        for (std::size_t k = 0; k < 3; ++k) ways[i][k] = -sign * (x[i][k] - o[k] - centre[k]);
    return ways;
}

/// A slab of four of the points with normal n, `low` on its lower side: bit i of it is four[i].
Ways slab_ways(std::span<const Point> x, const std::array<std::size_t, 4>& four, Point n, unsigned low) {
    double below = 0, above = 0;
    for (std::size_t i = 0; i < 4; ++i) (low >> i & 1U ? below : above) = dot(n, x[four[i]]);
    if (above < below) n = {-n[0], -n[1], -n[2]};
    Ways ways(x.size());
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k) ways[four[i]][k] = low >> i & 1U ? n[k] : -n[k];
    return ways;
}

template <class Try>
bool any_slab(std::span<const Point> x, const std::array<std::size_t, 4>& four, const Try& attempt) {
    const auto p = [&](std::size_t i) -> const Point& { return x[four[i]]; };
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t a = (i + 1) % 4, b = (i + 2) % 4, c = (i + 3) % 4;
        if (attempt(slab_ways(x, four, cross(p(b) - p(a), p(c) - p(a)), 1U << i))) return true;
    }
    for (std::size_t i = 1; i < 4; ++i) {
        const std::size_t a = i % 3 + 1, b = (i + 1) % 3 + 1;
        if (attempt(slab_ways(x, four, cross(p(i) - p(0), p(b) - p(a)), 1U | 1U << i))) return true;
    }
    return false;
}

}  // namespace

std::optional<std::vector<Coordinates<3>>> break_certificate(std::span<const Coordinates<3>> x,
                                                             std::span<const double> reach) {
    std::vector<Point> moved;
    const auto attempt = [&](const Ways& ways) {
        moved.assign(x.begin(), x.end());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double length = std::sqrt(dot(ways[i], ways[i]));
            if (!(length > 0)) continue;
            for (std::size_t k = 0; k < 3; ++k) moved[i][k] += 0.999999 * reach[i] / length * ways[i][k];
            if (!(distance_upper<3>(moved[i], x[i]) < reach[i])) return false;
        }
        return fails(moved);
    };
    if (x.size() == 4) {
        if (any_slab(x, {0, 1, 2, 3}, attempt)) return moved;
        return std::nullopt;
    }
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = i + 1; j < 5; ++j) {
            std::array<std::size_t, 3> three{};
            for (std::size_t k = 0, m = 0; k < 5; ++k)
                if (k != i && k != j) three[m++] = k;
            const auto ways = annulus_ways(x, three, {i, j});
            if (ways && attempt(*ways)) return moved;
        }
    if (any_slab(x, {0, 1, 2, 4}, attempt) || any_slab(x, {1, 0, 2, 3}, attempt)) return moved;
    return std::nullopt;
}

Attack_record attack(Moving_delaunay_3& dt, std::span<const std::vector<Index>> certificates, std::uint64_t most,
                     std::uint64_t audits) {
    Attack_record r;
    const std::uint64_t stride = most == 0 ? 1 : std::max<std::uint64_t>(1, (certificates.size() + most - 1) / most);
    for (std::size_t c = 0; c < certificates.size(); c += stride) {
        const std::vector<Index>& vertices = certificates[c];
        std::vector<Point> x;
        std::vector<double> reach;
        for (const Index v : vertices) {
            x.push_back(dt.positions()[static_cast<std::size_t>(v)]);
            reach.push_back(dt.tolerance(dt.vertex(static_cast<std::size_t>(v))));
        }
        ++r.certificates;
        const auto moved = break_certificate(x, reach);
        if (!moved) continue;
        ++r.broken;
        std::uint64_t passed = 0;
        for (std::size_t i = 0; i < x.size(); ++i) passed += dt.move(vertices[i], (*moved)[i]).moves.within_tolerance;
        if (passed == x.size()) {
            ++r.accepted;
            if (r.audited < audits) {
                ++r.audited;
                const Audit_result verdict = dt.audit();
                if (!verdict.delaunay()) {
                    ++r.refuted;
                    if (r.example.empty()) r.example = verdict.first_fault;
                }
            }
        }
        for (std::size_t i = 0; i < x.size(); ++i) (void)dt.move(vertices[i], x[i]);
        if (passed != x.size()) (void)dt.recompute_tolerances();
    }
    return r;
}

}  // namespace annulus::inline v1
