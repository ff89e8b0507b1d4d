// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/clear_cells.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/sphere_terms.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(__x86_64__)
#define ANNULUS_AVX2 __attribute__((target("avx2")))
#else
#define ANNULUS_AVX2
#endif
#define ANNULUS_INLINE ANNULUS_AVX2 __attribute__((always_inline)) inline

namespace annulus::inline v1 {

namespace {

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
        own = greater(own, magnitude(edge[k]));
    }
    Sphere_terms<Vector<d>, Four> terms;
    if constexpr (d == 2) terms = sphere_terms(edge[0], edge[1]);
    else terms = sphere_terms(edge[0], edge[1], edge[2]);
    Four m = own;
    Four least = four(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k <= d; ++k) {
        const Vector<d> w = difference(read<d>(x, beyond[k]), origin);
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
