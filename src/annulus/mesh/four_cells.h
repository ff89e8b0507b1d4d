// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/sphere_terms.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(__x86_64__)
#define ANNULUS_AVX2 __attribute__((target("avx2")))
#else
#define ANNULUS_AVX2
#endif
#define ANNULUS_INLINE ANNULUS_AVX2 __attribute__((always_inline)) inline

// The test of excludes_all() of Circumcircle_2 and Circumsphere_3 for four cells side by side, in registers of AVX2.
// What calls it has the target of ANNULUS_AVX2, and runs only where has_fast_clear_cells().
namespace annulus::inline v1::four_cells {

using Register = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));

/// A number of each of four cells. `Lanes` (predicate/lanes.h) has only as many as the baseline of the target. A class,
/// since clang lets no function return a vector that its own target does not have. Its operators have the target of the
/// function that they are inlined into.
struct Four {
    Register v;
    [[gnu::always_inline]] friend inline Four operator+(const Four& a, const Four& b) { return {a.v + b.v}; }
    [[gnu::always_inline]] friend inline Four operator-(const Four& a, const Four& b) { return {a.v - b.v}; }
    [[gnu::always_inline]] friend inline Four operator*(const Four& a, const Four& b) { return {a.v * b.v}; }
};
ANNULUS_INLINE Four four(double x) { return {x - Register{}}; }
ANNULUS_INLINE Four greater(const Four& a, const Four& b) { return {a.v > b.v ? a.v : b.v}; }
ANNULUS_INLINE Four lesser(const Four& value, const Four& least) { return {value.v < least.v ? value.v : least.v}; }
ANNULUS_INLINE Four absolute(const Four& a) { return greater(a, {-a.v}); }

template <int d>
using Vector = std::conditional_t<d == 2, Vector_2<Four>, Vector_3<Four>>;

// What sphere_terms.h calls, always inlined like it. Elsewhere code would double if these were (width_terms_3.h).
[[gnu::always_inline]] inline Four squared(const Four& a) { return a * a; }
[[gnu::always_inline]] inline Four dot(const Vector<3>& a, const Vector<3>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
[[gnu::always_inline]] inline Four square(const Vector<3>& a) { return dot(a, a); }
[[gnu::always_inline]] inline Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

ANNULUS_INLINE Four magnitude(const Vector<2>& a) { return greater(absolute(a.x), absolute(a.y)); }
ANNULUS_INLINE Four magnitude(const Vector<3>& a) {
    return greater(greater(absolute(a.x), absolute(a.y)), absolute(a.z));
}
ANNULUS_INLINE Vector<2> difference(const Vector<2>& a, const Vector<2>& b) { return {a.x - b.x, a.y - b.y}; }
ANNULUS_INLINE Vector<3> difference(const Vector<3>& a, const Vector<3>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

ANNULUS_INLINE Vector<2> sum(const Vector<2>& a, const Vector<2>& b) { return {a.x + b.x, a.y + b.y}; }
ANNULUS_INLINE Vector<3> sum(const Vector<3>& a, const Vector<3>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

ANNULUS_INLINE Register two_pairs(const double* a, const double* b) {
    Two low, high;
    std::memcpy(&low, a, sizeof low);
    std::memcpy(&high, b, sizeof high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// The positions of four vertices.
template <int d>
ANNULUS_INLINE Vector<d> read(const Coordinates<d>* x, const std::array<Index, 4>& v) {
    const double *a = x[v[0]].data(), *b = x[v[1]].data(), *c = x[v[2]].data(), *e = x[v[3]].data();
    const Register ac = two_pairs(a, c), be = two_pairs(b, e);
    Vector<d> p;
    p.x = {__builtin_shufflevector(ac, be, 0, 4, 2, 6)};
    p.y = {__builtin_shufflevector(ac, be, 1, 5, 3, 7)};
    if constexpr (d == 3) p.z = {Register{a[2], b[2], c[2], e[2]}};
    return p;
}

/// Of four cells: true where one is positive and no point beyond its facets is in its sphere, each certainly. `cells`
/// has functions corner(k) and beyond(k), k from 0 to d, that give the places of the k-th corners and of the points
/// opposite to their facets, a Vector<d> of each. The same operations as those classes, so that the answers are the
/// same.
template <int d, class Cells>
ANNULUS_INLINE auto are_clear(const Cells& cells) {
    const Vector<d> origin = cells.corner(0);
    std::array<Vector<d>, d> edge;
    Four own{};  // magnitude
    for (std::size_t k = 0; k < d; ++k) {
        edge[k] = difference(cells.corner(k + 1), origin);
        own = greater(own, magnitude(edge[k]));
    }
    Sphere_terms<Vector<d>, Four> terms;
    if constexpr (d == 2) terms = sphere_terms(edge[0], edge[1]);
    else terms = sphere_terms(edge[0], edge[1], edge[2]);
    Four m = own;
    Four least = four(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k <= d; ++k) {
        const Vector<d> w = difference(cells.beyond(k), origin);
        least = lesser(sphere_determinant(terms.normal, terms.determinant, w), least);
        m = greater(m, magnitude(w));
    }
    constexpr double range = d == 2 ? bounds::filter_range : bounds::filter_range_3;
    constexpr double error = (d == 2 ? bounds::circumcircle_2 : bounds::circumsphere_3) * bounds::u;
    constexpr double own_error = (d == 2 ? bounds::orientation_2 : bounds::orientation_3) * bounds::u;
    const Four m2 = m * m;
    const Four m_power = d == 2 ? m2 * m2 : m2 * m2 * m;
    const Four own_power = d == 2 ? own * own : own * own * own;
    return (least.v > error * m_power.v) & (m.v <= range) & (terms.determinant.v > own_error * own_power.v) &
           (own.v <= range) & (own.v * range >= 1.0);
}

}  // namespace annulus::inline v1::four_cells
