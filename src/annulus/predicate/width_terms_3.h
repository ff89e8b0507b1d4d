// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/width_terms.h>

#include <array>

namespace annulus::inline v1 {

// Each function below is one line of the proofs (proofs/gappa/certificates_3.g): the order of operations is part of
// what is proved.

template <class T>
[[nodiscard]] Vector_3<T> cross(const Vector_3<T>& u, const Vector_3<T>& v) {
    return {T(u.y * v.z - u.z * v.y), T(u.z * v.x - u.x * v.z), T(u.x * v.y - u.y * v.x)};
}

template <class T>
[[nodiscard]] T dot(const Vector_3<T>& u, const Vector_3<T>& v) {
    return (u.x * v.x + u.y * v.y) + u.z * v.z;
}

template <class T>
[[nodiscard]] T square(const Vector_3<T>& u) {
    return (squared(u.x) + squared(u.y)) + squared(u.z);
}

template <class T>
[[nodiscard]] Vector_3<T> operator+(const Vector_3<T>& u, const Vector_3<T>& v) {
    return {T(u.x + v.x), T(u.y + v.y), T(u.z + v.z)};
}

template <class T>
[[nodiscard]] Vector_3<T> operator-(const Vector_3<T>& u, const Vector_3<T>& v) {
    return {T(u.x - v.x), T(u.y - v.y), T(u.z - v.z)};
}

template <class T>
[[nodiscard]] Vector_3<T> operator-(const Vector_3<T>& u) {
    return {T(-u.x), T(-u.y), T(-u.z)};
}

/// r u - s v + t w.
template <class T>
[[nodiscard]] Vector_3<T> combination(const T& r, const Vector_3<T>& u, const T& s, const Vector_3<T>& v, const T& t,
                                      const Vector_3<T>& w) {
    return {T((r * u.x - s * v.x) + t * w.x), T((r * u.y - s * v.y) + t * w.y), T((r * u.z - s * v.z) + t * w.z)};
}

/// n - 2 l x.
template <class T>
[[nodiscard]] Vector_3<T> minus_twice(const Vector_3<T>& n, const T& l, const Vector_3<T>& x) {
    const T twice = l + l;
    return {T(n.x - twice * x.x), T(n.y - twice * x.y), T(n.z - twice * x.z)};
}

/// The largest squared area vector (doubled areas) of the slabs of the tetrahedron 0, u, v, w, given uv = u x v,
/// vw = v x w and wu = w x u: four facets and three pairs of opposite edges. Each of the seven is a sum of the three:
///     v - u, w - u:  uv + vw + wu        u, w - v:  -(uv + wu)
///     v, u - w:      -(vw + uv)          w, v - u:  -(wu + vw)
template <class T>
[[nodiscard]] T largest_slab(const Vector_3<T>& uv, const Vector_3<T>& vw, const Vector_3<T>& wu) {
    using std::max;
    const Vector_3<T> v_pair = uv + vw;
    const Vector_3<T> w_pair = vw + wu;
    const Vector_3<T> u_pair = wu + uv;
    const Vector_3<T> facet = v_pair + wu;
    const T facets = max(T(max(T(square(uv)), T(square(vw)))), T(max(T(square(wu)), T(square(facet)))));
    const T pairs = max(T(max(T(square(u_pair)), T(square(v_pair)))), T(square(w_pair)));
    return max(facets, pairs);
}

/// Half the width of the tetrahedron 0, u, v, w; positive when (u x v).w is, CGAL's positive orientation.
///
/// Four points can become coplanar under a displacement of each by s exactly when a slab of width 2s holds them. The
/// slab whose planes hold two opposite edges, or a facet and its vertex, has width determinant / |area vector|. Here
/// determinant = 6V and inner = outer = the largest area vector squared.
template <class T>
[[nodiscard]] Width_terms<T> orientation_terms(const Vector_3<T>& u, const Vector_3<T>& v, const Vector_3<T>& w) {
    const Vector_3<T> uv = cross(u, v);
    const T largest = largest_slab(uv, cross(v, w), cross(w, u));
    return {dot(uv, w), largest, largest};
}

/// Partitions A | B of the points of a bi-cell in 3D that its cells do not exclude, in the order of all arrays. abc_pq
/// is that of the standard annulus.
enum Partition_3 : std::size_t { abc_pq, ab_cpq, ca_bpq, bc_apq, partitions_3 };

/// The terms of the half widths of the four annuli of a bi-cell. They share the determinant: half width of partition k
/// = |determinant| / (sqrt(inner[k]) + sqrt(outer[k])).
template <class T>
struct Bicell_terms_3 {
    T determinant;                        ///< insphere: positive when q is outside the sphere of a, b, c, p
    std::array<T, partitions_3> inner;    ///< (2 L r_A)^2, L = side[k], r_A the radius of the sphere through A
    std::array<T, partitions_3> outer;    ///< (2 L r_B)^2
    std::array<T, partitions_3> side;     ///< L = sum over B of lambda; side[abc_pq] > 0 where both cells are positive
    T cell_p;                             ///< 6V of the cell b, a, c, p, positive when it is
    T cell_q;                             ///< 6V of the cell a, b, c, q, positive when it is
    std::array<Vector_3<T>, 6> products;  ///< bc, bp, bq, cp, cq, pq
};

/// Half widths of the annuli of the facet a b c with opposite vertices p and q, vectors b, c, p, q relative to a. The
/// cells a, b, c, q and b, a, c, p are positive in CGAL's sense: q is on the side of b x c, p on the other.
///
/// With the affine dependence lambda of the five points (sum of lambda = 0, sum of lambda x = 0; lambda_p = (b x c).q,
/// lambda_q = -(b x c).p) the determinant is P = sum of lambda |x|^2. U_i = 2 lambda_i c_i, where c_i is the centre of
/// the sphere through all points but i, needs no division. For a partition A | B let L = sum over B of lambda and
/// N = sum over B of U. Then N / 2L is the centre of the annulus, its radii are |N - 2 L x| / 2L with x in A or in B,
/// and P = L (r_B^2 - r_A^2). Hence
///     half width = |P| / (|N - 2 L x_A| + |N - 2 L x_B|)          (docs/theory.md 4; proofs/identities).
/// In each partition a is one of the two points, with norm |N|. The lambda add up to 0, and so do the U. So sums over
/// B and over A are the same up to the sign, and the shorter one is used.
template <class T>
[[nodiscard]] Bicell_terms_3<T> annulus_terms(const Vector_3<T>& b, const Vector_3<T>& c, const Vector_3<T>& p,
                                              const Vector_3<T>& q) {
    const Vector_3<T> bc = cross(b, c);
    const Vector_3<T> bp = cross(b, p);
    const Vector_3<T> bq = cross(b, q);
    const Vector_3<T> cp = cross(c, p);
    const Vector_3<T> cq = cross(c, q);
    const Vector_3<T> pq = cross(p, q);
    const T bb = square(b);
    const T cc = square(c);
    const T pp = square(p);
    const T qq = square(q);
    // lambda; that of q is -nq, so that cells and signs need no negation.
    const T lb = dot(cp, q);
    const T lc = dot(bq, p);
    const T lp = dot(bc, q);
    const T nq = dot(bc, p);
    const T determinant = (lb * bb + lc * cc) + (lp * pp - nq * qq);
    // U of b and p, and -U of c and q.
    const Vector_3<T> up = combination(bb, cq, cc, bq, qq, bc);
    const Vector_3<T> vq = combination(bb, cp, cc, bp, pp, bc);
    const Vector_3<T> ub = combination(cc, pq, pp, cq, qq, cp);
    const Vector_3<T> vc = combination(bb, pq, pp, bq, qq, bp);
    // abc | pq
    const T l1 = lp - nq;
    const Vector_3<T> n1 = up - vq;
    const Vector_3<T> m1 = minus_twice(n1, l1, p);
    // ab | cpq
    const T l2 = l1 + lc;
    const Vector_3<T> n2 = n1 - vc;
    const Vector_3<T> m2 = minus_twice(n2, l2, c);
    // ca | bpq
    const T l3 = l1 + lb;
    const Vector_3<T> n3 = n1 + ub;
    const Vector_3<T> m3 = minus_twice(n3, l3, b);
    // bc | apq, from A; a is in B
    const T l4 = lb + lc;
    const Vector_3<T> n4 = ub - vc;
    const Vector_3<T> m4 = minus_twice(n4, l4, b);
    return {determinant,
            {T(square(n1)), T(square(n2)), T(square(n3)), T(square(m4))},
            {T(square(m1)), T(square(m2)), T(square(m3)), T(square(n4))},
            {l1, l2, l3, T(-l4)},
            T(-nq),
            lp,
            {bc, bp, bq, cp, cq, pq}};
}

/// The terms of the half widths of the two cells of a bi-cell, b a c p and a b c q, from the products of
/// annulus_terms: exactly the numbers of orientation_terms(c, b, p) and orientation_terms(b, c, q).
template <class T>
[[nodiscard]] Width_terms<T> cell_p_terms(const Bicell_terms_3<T>& t) {
    const T largest = largest_slab(-t.products[0], t.products[1], -t.products[3]);
    return {t.cell_p, largest, largest};
}
template <class T>
[[nodiscard]] Width_terms<T> cell_q_terms(const Bicell_terms_3<T>& t) {
    const T largest = largest_slab(t.products[0], t.products[4], -t.products[2]);
    return {t.cell_q, largest, largest};
}

}  // namespace annulus::inline v1
