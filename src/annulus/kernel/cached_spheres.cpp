// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/cached_spheres.h>

#include <algorithm>
#include <array>
#include <cstddef>

#if defined(__x86_64__) && defined(__GNUC__)
#define ANNULUS_HAS_AVX2 1
#include <immintrin.h>
#endif

namespace annulus::inline v1 {

namespace {

template <int d>
void one_by_one(Growing_cells<d>& g, std::span<const std::uint32_t> made) {
    for (const std::uint32_t c : made) {
        auto& cell = g.cells[c];
        const Coordinates<d>& p = g.at(cell.vertex[0]);
        const auto corner = [&](std::size_t i) { return Lifted<d>(g.at(cell.vertex[i]), p); };
        if constexpr (d == 2) cell.sphere = cached_sphere(corner(1), corner(2), g.bound(c));
        else cell.sphere = cached_sphere(corner(1), corner(2), corner(3), g.bound(c));
    }
}

#ifdef ANNULUS_HAS_AVX2

#define ANNULUS_AVX2 __attribute__((target("avx2"), always_inline)) inline

using Numbers = std::array<std::uint32_t, 4>;

/// A corner of four cells relative to p: the same bits as Lifted of each. In 2D there is no z.
struct Four {
    __m256d x, y, z, square;
};

/// Four rows as columns.
ANNULUS_AVX2 void transpose(__m256d& a, __m256d& b, __m256d& c, __m256d& e) {
    const __m256d ab = _mm256_unpacklo_pd(a, b), ba = _mm256_unpackhi_pd(a, b);
    const __m256d ce = _mm256_unpacklo_pd(c, e), ec = _mm256_unpackhi_pd(c, e);
    a = _mm256_permute2f128_pd(ab, ce, 0x20);
    b = _mm256_permute2f128_pd(ba, ec, 0x20);
    c = _mm256_permute2f128_pd(ab, ce, 0x31);
    e = _mm256_permute2f128_pd(ba, ec, 0x31);
}
template <int d>
ANNULUS_AVX2 Four four(const Growing_cells<d>& g, const Numbers& cell, std::size_t corner, const __m256d* p) {
    __m256d r[4];
    for (std::size_t i = 0; i < 4; ++i)
        r[i] = _mm256_load_pd(
            reinterpret_cast<const double*>(&g.sites[static_cast<std::size_t>(g.cells[cell[i]].vertex[corner])]));
    transpose(r[0], r[1], r[2], r[3]);
    Four f{_mm256_sub_pd(r[0], p[0]), _mm256_sub_pd(r[1], p[1]), {}, {}};
    f.square = _mm256_add_pd(_mm256_mul_pd(f.x, f.x), _mm256_mul_pd(f.y, f.y));
    if constexpr (d == 3) {
        f.z = _mm256_sub_pd(r[2], p[2]);
        f.square = _mm256_add_pd(f.square, _mm256_mul_pd(f.z, f.z));
    }
    return f;
}
ANNULUS_AVX2 __m256d minor(__m256d a, __m256d b, __m256d c, __m256d e) {
    return _mm256_sub_pd(_mm256_mul_pd(a, e), _mm256_mul_pd(b, c));
}
ANNULUS_AVX2 __m256d sum(__m256d a, __m256d x, __m256d b, __m256d y, __m256d c, __m256d z) {
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(a, x), _mm256_mul_pd(b, y)), _mm256_mul_pd(c, z));
}
template <int d>
ANNULUS_AVX2 __m256d magnitude(const Four& f) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    const __m256d m = _mm256_max_pd(_mm256_andnot_pd(sign, f.x), _mm256_andnot_pd(sign, f.y));
    return d == 2 ? m : _mm256_max_pd(m, _mm256_andnot_pd(sign, f.z));
}

/// 1 / t of power_above() for four cells; stores their bounds.
template <int d>
ANNULUS_AVX2 __m256d inverse_powers(__m256d m, Growing_cells<d>& g, const Numbers& cell) {
    const __m256d in_range = _mm256_and_pd(_mm256_cmp_pd(m, _mm256_set1_pd(0x1p-200), _CMP_GE_OQ),
                                           _mm256_cmp_pd(m, _mm256_set1_pd(0x1p60), _CMP_LE_OQ));
    alignas(32) std::array<double, 4> each;
    if (_mm256_movemask_pd(in_range) != 15) [[unlikely]] {
        _mm256_store_pd(each.data(), m);
        for (std::size_t i = 0; i < 4; ++i) {
            const detail::Power t = detail::power_above<d>(each[i]);
            each[i] = t.inverse;
            g.bound(cell[i]) = t.bound;
        }
        return _mm256_load_pd(each.data());
    }
    const __m256i exponent = _mm256_and_si256(_mm256_castpd_si256(m), _mm256_set1_epi64x(0x7ff0000000000000LL));
    const __m256i power = _mm256_add_epi64(exponent, _mm256_set1_epi64x(0x0010000000000000LL));
    const __m256d t = _mm256_castsi256_pd(power);
    const __m128 bound =
        _mm_max_ps(_mm256_cvtpd_ps(_mm256_mul_pd(_mm256_set1_pd(Cached_sphere<d>::unit), _mm256_mul_pd(t, t))),
                   _mm_set1_ps(Cached_sphere<d>::least_bound));
    alignas(16) std::array<float, 4> bounds;
    _mm_store_ps(bounds.data(), bound);
    for (std::size_t i = 0; i < 4; ++i) g.bound(cell[i]) = bounds[i];
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(2046LL << 52), power));
}

ANNULUS_AVX2 void spheres(Growing_cells<2>& g, const Numbers& cell, const __m256d* p) {
    const Four a = four(g, cell, 1, p), b = four(g, cell, 2, p);
    const __m256d t = inverse_powers(_mm256_max_pd(magnitude<2>(a), magnitude<2>(b)), g, cell);
    const __m256d scale = _mm256_mul_pd(t, t);
    __m256d x = _mm256_mul_pd(minor(a.square, b.square, a.y, b.y), scale);
    __m256d y = _mm256_mul_pd(minor(b.square, a.square, b.x, a.x), scale);
    __m256d e = _mm256_mul_pd(minor(a.x, a.y, b.x, b.y), scale);
    __m256d none = e;
    transpose(x, y, e, none);
    const __m256d sphere[4] = {x, y, e, none};
    for (std::size_t i = 0; i < 4; ++i) {
        Cached_sphere<2>& s = g.cells[cell[i]].sphere;
        _mm_storeu_pd(s.normal.data(), _mm256_castpd256_pd128(sphere[i]));
        _mm_store_sd(&s.determinant, _mm256_extractf128_pd(sphere[i], 1));
    }
}

ANNULUS_AVX2 void spheres(Growing_cells<3>& g, const Numbers& cell, const __m256d* p) {
    static_assert(sizeof(Cached_sphere<3>) == 32);
    const Four a = four(g, cell, 1, p), b = four(g, cell, 2, p), c = four(g, cell, 3, p);
    const __m256d t =
        inverse_powers(_mm256_max_pd(magnitude<3>(a), _mm256_max_pd(magnitude<3>(b), magnitude<3>(c))), g, cell);
    const __m256d scale = _mm256_mul_pd(_mm256_mul_pd(t, t), t);
    const __m256d bcx = minor(b.y, b.z, c.y, c.z), bcy = minor(b.z, b.x, c.z, c.x), bcz = minor(b.x, b.y, c.x, c.y);
    const __m256d cax = minor(c.y, c.z, a.y, a.z), cay = minor(c.z, c.x, a.z, a.x), caz = minor(c.x, c.y, a.x, a.y);
    const __m256d abx = minor(a.y, a.z, b.y, b.z), aby = minor(a.z, a.x, b.z, b.x), abz = minor(a.x, a.y, b.x, b.y);
    __m256d x = _mm256_mul_pd(sum(a.square, bcx, b.square, cax, c.square, abx), scale);
    __m256d y = _mm256_mul_pd(sum(a.square, bcy, b.square, cay, c.square, aby), scale);
    __m256d z = _mm256_mul_pd(sum(a.square, bcz, b.square, caz, c.square, abz), scale);
    __m256d e = _mm256_mul_pd(sum(a.x, bcx, a.y, bcy, a.z, bcz), scale);
    transpose(x, y, z, e);
    const __m256d sphere[4] = {x, y, z, e};
    for (std::size_t i = 0; i < 4; ++i) _mm256_store_pd(reinterpret_cast<double*>(&g.cells[cell[i]].sphere), sphere[i]);
}

/// Precondition: all cells have the same vertex in slot 0.
template <int d>
__attribute__((target("avx2"))) void four_at_a_time(Growing_cells<d>& g, std::span<const std::uint32_t> made) {
    const Coordinates<d>& at = g.at(g.cells[made[0]].vertex[0]);
    const __m256d p[3] = {_mm256_set1_pd(at[0]), _mm256_set1_pd(at[1]), _mm256_set1_pd(at[d - 1])};
    for (std::size_t k = 0; k < made.size(); k += 4) {
        Numbers cell;  // the last one repeated where there are fewer
        for (std::size_t i = 0; i < 4; ++i) cell[i] = made[std::min(k + i, made.size() - 1)];
        spheres(g, cell, p);
    }
}

#endif

}  // namespace

template <int d>
void cached_spheres(Growing_cells<d>& cells, std::span<const std::uint32_t> made) {
#ifdef ANNULUS_HAS_AVX2
    static_assert(sizeof(typename Growing_cells<d>::Site) == 32);
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    if (has) return four_at_a_time(cells, made);
#endif
    one_by_one(cells, made);
}

template void cached_spheres(Growing_cells<2>&, std::span<const std::uint32_t>);
template void cached_spheres(Growing_cells<3>&, std::span<const std::uint32_t>);

}  // namespace annulus::inline v1
