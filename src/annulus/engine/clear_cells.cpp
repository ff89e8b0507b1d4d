// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/clear_cells.h>

#include <annulus/predicate/bounds.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#define ANNULUS_AVX2 __attribute__((target("avx2")))
#else
#define ANNULUS_AVX2
#endif
#define ANNULUS_INLINE ANNULUS_AVX2 __attribute__((always_inline)) inline

namespace annulus::inline v1 {

namespace {

/// A number of each of four cells. `Lanes` (predicate/lanes.h) has only as many as the baseline of the target.
using Four = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));
template <int d>
using Vector = std::array<Four, d>;

ANNULUS_INLINE Four greater(Four a, Four b) { return a > b ? a : b; }
template <int d>
ANNULUS_INLINE Four magnitude(const Vector<d>& a) {
    Four m = greater(a[0], -a[0]);
    for (std::size_t k = 1; k < d; ++k) m = greater(m, greater(a[k], -a[k]));
    return m;
}
template <std::size_t d>
ANNULUS_INLINE std::array<Four, d> difference(const std::array<Four, d>& a, const std::array<Four, d>& b) {
    std::array<Four, d> r;
    for (std::size_t k = 0; k < d; ++k) r[k] = a[k] - b[k];
    return r;
}
ANNULUS_INLINE Four dot(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[0] + a[1] * b[1]; }
ANNULUS_INLINE Four dot(const Vector<3>& a, const Vector<3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ANNULUS_INLINE Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The determinants of cells and a normal, from their edges, and the determinant of a point w: Circumcircle_2.
ANNULUS_INLINE Vector<2> sphere(const std::array<Vector<2>, 2>& e, Four& determinant) {
    const auto& [u, v] = e;
    const Four uu = dot(u, u), vv = dot(v, v);
    determinant = u[0] * v[1] - u[1] * v[0];
    return {u[1] * vv - v[1] * uu, v[0] * uu - u[0] * vv};
}
ANNULUS_INLINE Four outside(const Vector<2>& normal, Four determinant, const Vector<2>& w) {
    return dot(w, normal) + dot(w, w) * determinant;
}
/// The same: Circumsphere_3.
ANNULUS_INLINE Vector<3> sphere(const std::array<Vector<3>, 3>& e, Four& determinant) {
    const auto& [u, v, t] = e;
    const Vector<3> uv = cross(u, v), vt = cross(v, t), tu = cross(t, u);
    const Four uu = dot(u, u), vv = dot(v, v), tt = dot(t, t);
    determinant = dot(uv, t);
    Vector<3> n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = (uu * vt[k] + vv * tu[k]) + tt * uv[k];
    return n;
}
ANNULUS_INLINE Four outside(const Vector<3>& normal, Four determinant, const Vector<3>& w) {
    return dot(w, w) * determinant - dot(w, normal);
}

ANNULUS_INLINE Four two_pairs(const double* a, const double* b) {
    Two low, high;
    std::memcpy(&low, a, sizeof low);
    std::memcpy(&high, b, sizeof high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// The positions of four vertices.
template <int d>
ANNULUS_INLINE Vector<d> read(const Coordinates<d>* x, const std::array<Index, 4>& v) {
    const double *a = x[v[0]].data(), *b = x[v[1]].data(), *c = x[v[2]].data(), *e = x[v[3]].data();
    const Four ac = two_pairs(a, c), be = two_pairs(b, e);
    Vector<d> p{__builtin_shufflevector(ac, be, 0, 4, 2, 6), __builtin_shufflevector(ac, be, 1, 5, 3, 7)};
    if constexpr (d == 3) p[2] = Four{a[2], b[2], c[2], e[2]};
    return p;
}

/// Of four finite cells: true where one is clear.
template <int d>
ANNULUS_INLINE auto are_clear(const Corner_table<d>& t, const Coordinates<d>* x, const std::array<Cell_index, 4>& c) {
    std::array<std::array<Index, 4>, d + 1> corner, beyond;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k <= d; ++k) {
            const Corner_index h = t.corner(c[i], static_cast<int>(k));
            const Index v = t.vertex(t.twin(h));
            corner[k][i] = t.vertex(h);
            beyond[k][i] = v == infinite ? corner[0][i] : v;
        }
    const Vector<d> origin = read<d>(x, corner[0]);
    std::array<Vector<d>, d> edge;
    Four own{};  // magnitude
    for (std::size_t k = 0; k < d; ++k) {
        edge[k] = difference(read<d>(x, corner[k + 1]), origin);
        own = greater(own, magnitude<d>(edge[k]));
    }
    Four determinant;
    const Vector<d> normal = sphere(edge, determinant);
    Four m = own;
    Four least = std::numeric_limits<double>::infinity() - Four{};
    for (std::size_t k = 0; k <= d; ++k) {
        const Vector<d> w = difference(read<d>(x, beyond[k]), origin);
        const Four value = outside(normal, determinant, w);
        least = value < least ? value : least;
        m = greater(m, magnitude<d>(w));
    }
    constexpr double range = d == 2 ? bounds::filter_range : bounds::filter_range_3;
    constexpr double error = (d == 2 ? bounds::circumcircle_2 : bounds::circumsphere_3) * bounds::u;
    constexpr double own_error = (d == 2 ? bounds::orientation_2 : bounds::orientation_3) * bounds::u;
    const Four m2 = m * m;
    const Four m_power = d == 2 ? m2 * m2 : m2 * m2 * m;
    const Four own_power = d == 2 ? own * own : own * own * own;
    return (least > error * m_power) & (m <= range) & (determinant > own_error * own_power) & (own <= range) &
           (own * range >= 1.0);
}

template <int d>
ANNULUS_AVX2 std::size_t find_clear(const Corner_table<d>& table, std::span<const Coordinates<d>> x, Cell_index first,
                                    Cell_index last, std::vector<Cell_index>& rest) {
    std::size_t count = 0;
    std::array<Cell_index, 4> four;
    std::size_t size = 0;
    for (Cell_index c = first; c < last; ++c) {
        // The positions of a cell's neighbours are three dependent loads away.
        constexpr Index ahead = 16;
        if (const Cell_index far(c.value() + 2 * ahead); d == 3 && far < last)
            for (int i = 0; i <= d; ++i) table.prefetch_opposite(table.corner(far, i));
        if (const Cell_index far(c.value() + ahead); far < last)
            for (int i = 0; i <= d; ++i)
                if (const Corner_index t = table.twin(table.corner(far, i)); t != no_corner)
                    __builtin_prefetch(&x[static_cast<std::size_t>(std::max(table.vertex(t), Index{0}))]);
        if (!table.is_cell(c)) continue;
        if (table.is_infinite(c)) {
            rest.push_back(c);
            continue;
        }
        four[size] = c;
        if (++size < 4) continue;
        size = 0;
        const auto clear = are_clear<d>(table, x.data(), four);
        for (std::size_t i = 0; i < 4; ++i) {
            if (clear[i] != 0) ++count;
            else rest.push_back(four[i]);
        }
    }
    rest.insert(rest.end(), four.begin(), four.begin() + static_cast<std::ptrdiff_t>(size));
    return count;
}

}  // namespace

bool has_fast_clear_cells() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
#else
    return false;
#endif
}

template <int d>
std::size_t clear_cells(const Corner_table<d>& table, std::span<const Coordinates<d>> x, Cell_index first,
                        Cell_index last, std::vector<Cell_index>& rest) {
    return find_clear<d>(table, x, first, last, rest);
}

template std::size_t clear_cells(const Corner_table<2>&, std::span<const Coordinates<2>>, Cell_index, Cell_index,
                                 std::vector<Cell_index>&);
template std::size_t clear_cells(const Corner_table<3>&, std::span<const Coordinates<3>>, Cell_index, Cell_index,
                                 std::vector<Cell_index>&);

}  // namespace annulus::inline v1
