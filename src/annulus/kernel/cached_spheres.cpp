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

using Cells = Growing_cells<3>;

void one_by_one(Cells& g, std::span<const std::uint32_t> made) {
    for (const std::uint32_t c : made) {
        auto& cell = g.cells[c];
        const Coordinates<3>& p = g.at(cell.vertex[0]);
        const auto corner = [&](std::size_t i) { return Lifted<3>(g.at(cell.vertex[i]), p); };
        cell.sphere = cached_sphere(corner(1), corner(2), corner(3), g.bound(c));
    }
}

#ifdef ANNULUS_HAS_AVX2

#define ANNULUS_AVX2 __attribute__((target("avx2"), always_inline)) inline

/// A corner of four cells relative to p: the same bits as Lifted of each.
struct Four {
    __m256d x, y, z, square;
};

ANNULUS_AVX2 __m256d load(const Cells& g, std::uint32_t c, std::size_t corner) {
    return _mm256_load_pd(
        reinterpret_cast<const double*>(&g.sites[static_cast<std::size_t>(g.cells[c].vertex[corner])]));
}
ANNULUS_AVX2 Four four(const Cells& g, const std::array<std::uint32_t, 4>& c, std::size_t corner, const __m256d* p) {
    const __m256d a = load(g, c[0], corner), b = load(g, c[1], corner), e = load(g, c[2], corner),
                  f = load(g, c[3], corner);
    const __m256d ab = _mm256_unpacklo_pd(a, b), ef = _mm256_unpacklo_pd(e, f);
    Four r;
    r.x = _mm256_sub_pd(_mm256_permute2f128_pd(ab, ef, 0x20), p[0]);
    r.y = _mm256_sub_pd(_mm256_permute2f128_pd(_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(e, f), 0x20), p[1]);
    r.z = _mm256_sub_pd(_mm256_permute2f128_pd(ab, ef, 0x31), p[2]);
    r.square = _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(r.x, r.x), _mm256_mul_pd(r.y, r.y)), _mm256_mul_pd(r.z, r.z));
    return r;
}
ANNULUS_AVX2 __m256d minor(__m256d a, __m256d b, __m256d c, __m256d e) {
    return _mm256_sub_pd(_mm256_mul_pd(a, e), _mm256_mul_pd(b, c));
}
ANNULUS_AVX2 __m256d sum(__m256d a, __m256d x, __m256d b, __m256d y, __m256d c, __m256d z) {
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(a, x), _mm256_mul_pd(b, y)), _mm256_mul_pd(c, z));
}
ANNULUS_AVX2 __m256d magnitude(const Four& f) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return _mm256_max_pd(_mm256_max_pd(_mm256_andnot_pd(sign, f.x), _mm256_andnot_pd(sign, f.y)),
                         _mm256_andnot_pd(sign, f.z));
}

/// 1 / t of power_above() for four cells; stores their bounds.
ANNULUS_AVX2 __m256d inverse_powers(__m256d m, Cells& g, const std::array<std::uint32_t, 4>& cell) {
    const __m256d in_range = _mm256_and_pd(_mm256_cmp_pd(m, _mm256_set1_pd(0x1p-200), _CMP_GE_OQ),
                                           _mm256_cmp_pd(m, _mm256_set1_pd(0x1p60), _CMP_LE_OQ));
    alignas(32) std::array<double, 4> each;
    if (_mm256_movemask_pd(in_range) != 15) [[unlikely]] {
        _mm256_store_pd(each.data(), m);
        for (std::size_t i = 0; i < 4; ++i) {
            const detail::Power t = detail::power_above<3>(each[i]);
            each[i] = t.inverse;
            g.bounds[cell[i]] = t.bound;
        }
        return _mm256_load_pd(each.data());
    }
    const __m256i exponent = _mm256_and_si256(_mm256_castpd_si256(m), _mm256_set1_epi64x(0x7ff0000000000000LL));
    const __m256i power = _mm256_add_epi64(exponent, _mm256_set1_epi64x(0x0010000000000000LL));
    const __m256d t = _mm256_castsi256_pd(power);
    const __m128 bound =
        _mm_max_ps(_mm256_cvtpd_ps(_mm256_mul_pd(_mm256_set1_pd(Cached_sphere<3>::unit), _mm256_mul_pd(t, t))),
                   _mm_set1_ps(Cached_sphere<3>::least_bound));
    alignas(16) std::array<float, 4> bounds;
    _mm_store_ps(bounds.data(), bound);
    for (std::size_t i = 0; i < 4; ++i) g.bounds[cell[i]] = bounds[i];
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(2046LL << 52), power));
}

/// Precondition: all cells have the same vertex in slot 0.
__attribute__((target("avx2"))) void four_at_a_time(Cells& g, std::span<const std::uint32_t> made) {
    const Coordinates<3>& at = g.at(g.cells[made[0]].vertex[0]);
    const __m256d p[3] = {_mm256_set1_pd(at[0]), _mm256_set1_pd(at[1]), _mm256_set1_pd(at[2])};
    for (std::size_t k = 0; k < made.size(); k += 4) {
        std::array<std::uint32_t, 4> cell;  // the last one repeated where there are fewer
        for (std::size_t i = 0; i < 4; ++i) cell[i] = made[std::min(k + i, made.size() - 1)];
        const Four a = four(g, cell, 1, p), b = four(g, cell, 2, p), c = four(g, cell, 3, p);
        const __m256d t =
            inverse_powers(_mm256_max_pd(magnitude(a), _mm256_max_pd(magnitude(b), magnitude(c))), g, cell);
        const __m256d scale = _mm256_mul_pd(_mm256_mul_pd(t, t), t);
        const __m256d bcx = minor(b.y, b.z, c.y, c.z), bcy = minor(b.z, b.x, c.z, c.x), bcz = minor(b.x, b.y, c.x, c.y);
        const __m256d cax = minor(c.y, c.z, a.y, a.z), cay = minor(c.z, c.x, a.z, a.x), caz = minor(c.x, c.y, a.x, a.y);
        const __m256d abx = minor(a.y, a.z, b.y, b.z), aby = minor(a.z, a.x, b.z, b.x), abz = minor(a.x, a.y, b.x, b.y);
        const __m256d x = _mm256_mul_pd(sum(a.square, bcx, b.square, cax, c.square, abx), scale);
        const __m256d y = _mm256_mul_pd(sum(a.square, bcy, b.square, cay, c.square, aby), scale);
        const __m256d z = _mm256_mul_pd(sum(a.square, bcz, b.square, caz, c.square, abz), scale);
        const __m256d e = _mm256_mul_pd(sum(a.x, bcx, a.y, bcy, a.z, bcz), scale);
        const __m256d xy = _mm256_unpacklo_pd(x, y), yx = _mm256_unpackhi_pd(x, y);
        const __m256d ze = _mm256_unpacklo_pd(z, e), ez = _mm256_unpackhi_pd(z, e);
        const __m256d sphere[4] = {_mm256_permute2f128_pd(xy, ze, 0x20), _mm256_permute2f128_pd(yx, ez, 0x20),
                                   _mm256_permute2f128_pd(xy, ze, 0x31), _mm256_permute2f128_pd(yx, ez, 0x31)};
        for (std::size_t i = 0; i < 4; ++i)
            _mm256_store_pd(reinterpret_cast<double*>(&g.cells[cell[i]].sphere), sphere[i]);
    }
}

#endif

}  // namespace

void cached_spheres(Cells& cells, std::span<const std::uint32_t> made) {
#ifdef ANNULUS_HAS_AVX2
    static_assert(sizeof(Cached_sphere<3>) == 32 && sizeof(Cells::Site) == 32);
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    if (has) return four_at_a_time(cells, made);
#endif
    one_by_one(cells, made);
}

}  // namespace annulus::inline v1
