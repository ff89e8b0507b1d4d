// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/integer_signs.h>

#include <annulus/arithmetic/wide_integer.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace annulus::inline v1 {

namespace {

template <int d>
using Vector = std::array<std::int64_t, static_cast<std::size_t>(d)>;

/// Differences of k points to the last of k + 1, as integers on the finest of their grids.
template <int d, std::size_t k>
struct Differences {
    std::array<Vector<d>, k> v;
    int bits = 64;  ///< all magnitudes are below 2^bits; 64: they are not known

    explicit Differences(const std::array<Scaled_point<d>, k + 1>& p) {
        double scale = 0, least = p[0].scale, largest = 0;
        for (const auto& q : p) {
            scale = std::max(scale, q.scale);
            least = std::min(least, q.scale);
            for (const double c : *q.x) largest = std::max(largest, std::fabs(c));
        }
        if (!(least > 0) || !(largest * scale < 0x1p60)) return;
        const auto on_grid = [scale](const Coordinates<d>& x) {
            Vector<d> n;
            for (std::size_t c = 0; c < d; ++c) n[c] = static_cast<std::int64_t>(x[c] * scale);
            return n;
        };
        const Vector<d> last = on_grid(*p[k].x);
        std::uint64_t magnitude = 0;
        for (std::size_t i = 0; i < k; ++i) {
            v[i] = Euclidean<d>::difference(on_grid(*p[i].x), last);
            for (const std::int64_t c : v[i]) magnitude |= static_cast<std::uint64_t>(std::abs(c));
        }
        bits = static_cast<int>(std::bit_width(magnitude));
    }
};

int sign_of(Int128 x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
template <std::size_t N>
int sign_of(const Wide_integer<N>& x) {
    return x.sign();
}

Int128 minor(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t e) { return Int128{a} * e - Int128{b} * c; }
template <int d>
Int128 square(const Vector<d>& a) {
    Int128 s = 0;
    for (const std::int64_t c : a) s += Int128{c} * c;
    return s;
}
Vector<3> small_cross(const Vector<3>& a, const Vector<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::array<Int128, 3> cross(const Vector<3>& a, const Vector<3>& b) {
    return {minor(a[1], a[2], b[1], b[2]), minor(a[2], a[0], b[2], b[0]), minor(a[0], a[1], b[0], b[1])};
}
Int128 small_dot(const Vector<3>& a, const Vector<3>& b) {
    return Int128{a[0]} * b[0] + Int128{a[1]} * b[1] + Int128{a[2]} * b[2];
}
Wide_integer<3> dot(const std::array<Int128, 3>& n, const Vector<3>& a) {
    return product(wide(n[0]), wide(a[0])) + product(wide(n[1]), wide(a[1])) + product(wide(n[2]), wide(a[2]));
}

/// The sign of the determinant of r_k and |r_k|^2, positive when the last point is inside, and the signs of its
/// minors: orientation[i] is that of the cell with the last point in place of corner i.
template <int d>
struct Sphere_signs {
    int sphere;
    std::array<int, static_cast<std::size_t>(d + 1)> orientation;
};

Sphere_signs<2> sphere_signs(const std::array<Vector<2>, 3>& r, int bits) {
    const auto& [a, b, c] = r;
    const Int128 bc = minor(b[0], b[1], c[0], c[1]), ca = minor(c[0], c[1], a[0], a[1]),
                 ab = minor(a[0], a[1], b[0], b[1]);
    const std::array orientation{sign_of(bc), sign_of(ca), sign_of(ab)};
    if (bits <= 30)  // products of degree 4 and their sum: below 2^(4 * 30 + 4)
        return {sign_of(square<2>(a) * bc + square<2>(b) * ca + square<2>(c) * ab), orientation};
    // Below 2^(4 * 61 + 4) < 2^255.
    return {sign_of(product(wide(square<2>(a)), wide(bc)) + product(wide(square<2>(b)), wide(ca)) +
                    product(wide(square<2>(c)), wide(ab))),
            orientation};
}

Sphere_signs<3> sphere_signs(const std::array<Vector<3>, 4>& r, int bits) {
    const auto& [a, b, c, e] = r;
    const auto signs = [&r](const auto& bce, const auto& ace, const auto& abe, const auto& abc, auto times) {
        const auto sum = (times(bce, square<3>(r[0])) - times(ace, square<3>(r[1]))) +
                         (times(abe, square<3>(r[2])) - times(abc, square<3>(r[3])));
        return Sphere_signs<3>{sign_of(sum), {sign_of(bce), -sign_of(ace), sign_of(abe), -sign_of(abc)}};
    };
    if (bits <= 24) {  // minors below 2^50, of degree 3 below 2^76, products of degree 5 below 2^125
        const Vector<3> ce = small_cross(c, e), ab = small_cross(a, b);
        return signs(small_dot(b, ce), small_dot(a, ce), small_dot(e, ab), small_dot(c, ab),
                     [](Int128 x, Int128 y) { return x * y; });
    }
    // Minors below 2^123, of degree 3 below 2^186, squares below 2^124, the sum below 2^312.
    const auto ce = cross(c, e), ab = cross(a, b);
    return signs(dot(ce, b), dot(ce, a), dot(ab, e), dot(ab, c),
                 [](const Wide_integer<3>& x, Int128 y) { return product(x, wide(y)); });
}

}  // namespace

template <int d>
double grid_scale(const Coordinates<d>& x) {
    constexpr int nothing = 5000, most = 1023;
    int lowest = nothing;  // of the places of bits that are set, above 2^-1075
    for (const double c : x) {
        const auto bits = std::bit_cast<std::uint64_t>(c);
        const int exponent = static_cast<int>(bits >> 52 & 2047);
        const std::uint64_t mantissa =
            (bits & ((std::uint64_t{1} << 52) - 1)) | (exponent != 0 ? std::uint64_t{1} << 52 : 0);
        if (mantissa != 0) lowest = std::min(lowest, std::max(exponent, 1) + std::countr_zero(mantissa));
    }
    if (lowest == nothing) return std::ldexp(1.0, -most);  // the origin: any scale makes it an integer
    const int power = 1075 - lowest;
    return power > most ? 0.0 : std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52);
}

template <int d>
std::optional<int> integer_orientation(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 1)>& p) {
    const Differences<d, d> r(p);
    if (r.bits > 61) return {};
    // Differences to the last of three points: the sign is that of the orientation. With four points it is the
    // opposite.
    if constexpr (d == 2) return sign_of(minor(r.v[0][0], r.v[0][1], r.v[1][0], r.v[1][1]));
    else return -sign_of(dot(cross(r.v[0], r.v[1]), r.v[2]));
}

template <int d>
std::optional<bool> integer_sphere_holds(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p) {
    constexpr std::size_t last = d + 1;
    const Differences<d, d + 1> r(p);
    if (r.bits > 61) return {};
    const Sphere_signs<d> s = sphere_signs(r.v, r.bits);
    if (s.sphere != 0) return s.sphere > 0;
    // The perturbation (perturbed_sign) lifts the lexicographically largest point most: its effect on the sphere
    // decides, then that of the second largest.
    const auto largest_but = [&p](std::size_t but) {
        std::size_t f = but == 0 ? 1 : 0;
        for (std::size_t i = 0; i <= last; ++i)
            if (i != but && *p[f].x < *p[i].x) f = i;
        return f;
    };
    const std::size_t f = largest_but(last + 1);
    if (f == last) return false;
    if (s.orientation[f] != 0) return s.orientation[f] > 0;
    const std::size_t g = largest_but(f);
    return g != last && s.orientation[g] > 0;
}

template double grid_scale<2>(const Coordinates<2>&);
template double grid_scale<3>(const Coordinates<3>&);
template std::optional<int> integer_orientation<2>(const std::array<Scaled_point<2>, 3>&);
template std::optional<int> integer_orientation<3>(const std::array<Scaled_point<3>, 4>&);
template std::optional<bool> integer_sphere_holds<2>(const std::array<Scaled_point<2>, 4>&);
template std::optional<bool> integer_sphere_holds<3>(const std::array<Scaled_point<3>, 5>&);

}  // namespace annulus::inline v1
