// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Half widths in 3D from their definitions, in rational numbers: slabs from normals, annuli from centres that
// solve a linear system. Nothing here calls the library.

#include <annulus/predicate/certificate_value.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace annulus::oracle {

using Vector_q = std::array<mpq_class, 3>;

[[nodiscard]] inline Vector_q between(const Coordinates<3>& from, const Coordinates<3>& to) {
    Vector_q v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = mpq_class(to[k]) - mpq_class(from[k]);
    return v;
}
[[nodiscard]] inline mpq_class dot(const Vector_q& u, const Vector_q& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
[[nodiscard]] inline Vector_q cross(const Vector_q& u, const Vector_q& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// The least of the half widths of slabs and annuli, compared with doubles exactly.
class Half_width_3 {
  public:
    explicit Half_width_3(int sign) : sign_(sign) {}

    [[nodiscard]] int sign() const { return sign_; }
    /// y <= the half width. Preconditions: sign() > 0, y >= 0.
    [[nodiscard]] bool is_at_least(double y) const {
        const mpq_class q(y);
        return std::all_of(slabs_.begin(), slabs_.end(), [&](const mpq_class& s) { return 4 * q * q <= s; }) &&
               std::all_of(annuli_.begin(), annuli_.end(), [&](const Annulus& a) {
                   // 2 y + r <= R, squared twice.
                   const mpq_class rest = a.R2 - a.r2 - 4 * q * q;
                   return rest >= 0 && 16 * q * q * a.r2 <= rest * rest;
               });
    }

    /// A slab with normal n between two points; n = 0 is no slab.
    void add_slab(const Vector_q& n, const Vector_q& from_one_to_other) {
        const mpq_class norm = dot(n, n);
        if (norm == 0) return;
        const mpq_class height = dot(n, from_one_to_other);
        slabs_.push_back(height * height / norm);
    }
    void add_annulus(mpq_class r2, mpq_class R2) {
        if (R2 < r2) std::swap(r2, R2);
        annuli_.push_back({std::move(r2), std::move(R2)});
    }
    void add(const Half_width_3& o) {
        slabs_.insert(slabs_.end(), o.slabs_.begin(), o.slabs_.end());
        annuli_.insert(annuli_.end(), o.annuli_.begin(), o.annuli_.end());
    }

  private:
    struct Annulus {
        mpq_class r2, R2;
    };
    int sign_;
    std::vector<mpq_class> slabs_;  ///< squared widths
    std::vector<Annulus> annuli_;   ///< squared radii
};

/// Half the width of a tetrahedron: four facets, three pairs of opposite edges.
[[nodiscard]] inline Half_width_3 simplex(const Tuple<3, 4>& x) {
    const Vector_q u = between(*x[0], *x[1]), v = between(*x[0], *x[2]), w = between(*x[0], *x[3]);
    const mpq_class volume = dot(cross(u, v), w);
    Half_width_3 h(sgn(volume));
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& a = *x[(i + 1) % 4];
        h.add_slab(cross(between(a, *x[(i + 2) % 4]), between(a, *x[(i + 3) % 4])), between(a, *x[i]));
    }
    for (std::size_t i = 1; i < 4; ++i) {
        const auto& c = *x[i % 3 + 1];
        const auto& e = *x[(i + 1) % 3 + 1];
        h.add_slab(cross(between(*x[0], *x[i]), between(c, e)), between(*x[0], c));
    }
    return h;
}

/// Positive when the sphere through a, b, c, p leaves q outside, both cells being positive.
[[nodiscard]] inline int empty_sphere_sign(const Tuple<3, 5>& x) {
    // The sphere of a, b, c, p: 2 y . (v - a) = |v - a|^2 for its centre y from a.
    const Vector_q b = between(*x[0], *x[1]), c = between(*x[0], *x[2]), p = between(*x[0], *x[3]),
                   q = between(*x[0], *x[4]);
    const mpq_class det = dot(b, cross(c, p));
    const Vector_q cp = cross(c, p), pb = cross(p, b), bc = cross(b, c);
    mpq_class centre_q = 0;  // 2 y . q
    for (std::size_t k = 0; k < 3; ++k)
        centre_q += (dot(b, b) * cp[k] + dot(c, c) * pb[k] + dot(p, p) * bc[k]) / det * q[k];
    return sgn(mpq_class(dot(q, q) - centre_q));
}

/// The annulus with one group on one sphere and the other on a concentric one; parallel planes where the centre is at
/// infinity.
inline void add_annulus(Half_width_3& h, const std::vector<const Coordinates<3>*>& one,
                        const std::vector<const Coordinates<3>*>& other) {
    const Coordinates<3>& origin = *one[0];
    std::vector<Vector_q> row;
    std::vector<mpq_class> side;
    for (const auto* group : {&one, &other})
        for (std::size_t i = 1; i < group->size(); ++i) {
            const Vector_q first = between(origin, *group->front()), p = between(origin, *(*group)[i]);
            row.push_back(between(*group->front(), *(*group)[i]));
            side.emplace_back((dot(p, p) - dot(first, first)) / 2);
        }
    const Vector_q to_other = between(origin, *other[0]);
    const mpq_class det = dot(row[0], cross(row[1], row[2]));
    if (det == 0) {  // all directions lie in a plane: its normal is that of the slab
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector_q n = cross(row[i], row[(i + 1) % 3]);
            if (dot(n, n) == 0) continue;
            h.add_slab(n, to_other);
            return;
        }
        return;
    }
    const Vector_q n0 = cross(row[1], row[2]), n1 = cross(row[2], row[0]), n2 = cross(row[0], row[1]);
    Vector_q centre;
    for (std::size_t k = 0; k < 3; ++k) centre[k] = (side[0] * n0[k] + side[1] * n1[k] + side[2] * n2[k]) / det;
    Vector_q away;
    for (std::size_t k = 0; k < 3; ++k) away[k] = centre[k] - to_other[k];
    h.add_annulus(dot(centre, centre), dot(away, away));
}

[[nodiscard]] inline Half_width_3 standard_annulus(const Tuple<3, 5>& x) {
    Half_width_3 h(empty_sphere_sign(x));
    add_annulus(h, {x[0], x[1], x[2]}, {x[3], x[4]});
    return h;
}
[[nodiscard]] inline Half_width_3 least_annulus(const Tuple<3, 5>& x) {
    Half_width_3 h = standard_annulus(x);
    for (std::size_t i = 0; i < 3; ++i) add_annulus(h, {x[i], x[(i + 1) % 3]}, {x[(i + 2) % 3], x[3], x[4]});
    return h;
}
[[nodiscard]] inline Half_width_3 least_annulus_and_cells(const Tuple<3, 5>& x) {
    Half_width_3 h = least_annulus(x);
    h.add(simplex({x[1], x[0], x[2], x[3]}));
    h.add(simplex({x[0], x[1], x[2], x[4]}));
    return h;
}

}  // namespace annulus::oracle
