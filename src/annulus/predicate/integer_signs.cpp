// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/integer_signs.h>

#include <annulus/predicate/integer_products.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace annulus::inline v1 {

namespace {

using namespace fixed_width;

template <int d, class Integer>
using Vector = std::array<Integer, static_cast<std::size_t>(d)>;

template <class Integer>
constexpr int most_bits = static_cast<int>(8 * sizeof(Integer)) - 4;  // of a coordinate; a difference has one more

template <class Integer>
Unsigned128 magnitude(Integer x) {
    return static_cast<Unsigned128>(x < 0 ? -x : x);
}
int width(Unsigned128 x) {
    const auto high = static_cast<std::uint64_t>(x >> 64);
    return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                     : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x)));
}

/// The finest of the grids of some points, and whether all coordinates are integers of so many bits on it.
template <int d, std::size_t k>
struct Common_grid {
    double scale = 0;
    double largest = 0;  ///< on the grid; infinity: there is none

    explicit Common_grid(const std::array<Scaled_point<d>, k>& p) {
        double least = p[0].scale;
        for (const auto& q : p) {
            scale = std::max(scale, q.scale);
            least = std::min(least, q.scale);
            for (const double c : *q.x) largest = std::max(largest, std::fabs(c));
        }
        largest = least > 0 ? largest * scale : std::numeric_limits<double>::infinity();
    }
    template <class Integer>
    [[nodiscard]] bool fits() const {
        return largest < std::bit_cast<double>(std::uint64_t{1023 + most_bits<Integer>} << 52);
    }
};

/// Differences of k points to the last of k + 1, on a grid on which all are integers.
template <int d, class Integer, std::size_t k>
struct Differences {
    std::array<Vector<d, Integer>, k> v;
    int bits;  ///< all magnitudes are below 2^bits

    Differences(const std::array<Scaled_point<d>, k + 1>& p, double scale) {
        const auto on_grid = [scale](const Coordinates<d>& x) {
            Vector<d, Integer> n;
            for (std::size_t c = 0; c < d; ++c) n[c] = static_cast<Integer>(x[c] * scale);
            return n;
        };
        const Vector<d, Integer> last = on_grid(*p[k].x);
        Unsigned128 any = 0;
        for (std::size_t i = 0; i < k; ++i) {
            v[i] = Euclidean<d>::difference(on_grid(*p[i].x), last);
            for (const Integer c : v[i]) any |= magnitude(c);
        }
        bits = width(any);
    }
};

/// The determinant of r_k and |r_k|^2, positive when the last point is inside the sphere of the others and these are a
/// positive cell, and its minors.
template <class Minor, class Determinant>
struct Sphere_minors_2 {
    Determinant determinant;
    Minor bc, ca, ab;

    /// Of the cell with the last point in place of corner i.
    [[nodiscard]] std::array<int, 3> orientations() const { return {sign_of(bc), sign_of(ca), sign_of(ab)}; }
};
template <class Minor, class Determinant>
struct Sphere_minors_3 {
    Determinant determinant;
    Minor bce, ace, abe, abc;

    [[nodiscard]] std::array<int, 4> orientations() const {
        return {sign_of(bce), -sign_of(ace), sign_of(abe), -sign_of(abc)};
    }
};

template <class By, class Integer>
auto sphere_minors(const std::array<Vector<2, Integer>, 3>& r) {
    const auto& [a, b, c] = r;
    const auto bc = By::minor(b[0], b[1], c[0], c[1]), ca = By::minor(c[0], c[1], a[0], a[1]),
               ab = By::minor(a[0], a[1], b[0], b[1]);
    const auto sum = By::times(By::square(a), bc) + By::times(By::square(b), ca) + By::times(By::square(c), ab);
    return Sphere_minors_2<std::remove_const_t<decltype(bc)>, std::remove_const_t<decltype(sum)>>{sum, bc, ca, ab};
}

template <class By, class Integer>
auto sphere_minors(const std::array<Vector<3, Integer>, 4>& r) {
    const auto& [a, b, c, e] = r;
    const auto ce = cross<By, Integer>(c, e), ab = cross<By, Integer>(a, b);
    const auto bce = By::dot(ce, b), ace = By::dot(ce, a), abe = By::dot(ab, e), abc = By::dot(ab, c);
    const auto sum = (By::times(bce, By::square(a)) - By::times(ace, By::square(b))) +
                     (By::times(abe, By::square(c)) - By::times(abc, By::square(e)));
    return Sphere_minors_3<std::remove_const_t<decltype(bce)>, std::remove_const_t<decltype(sum)>>{sum, bce, ace, abe,
                                                                                                   abc};
}

// Determinants of the sphere are of degree d + 2. With coordinates below 2^b:
// 2D: minors and squares below 2^(2b + 1), products below 2^(4b + 2), their sum below 2^(4b + 4);
// 3D: minors below 2^(2b + 1), squares below 2^(2b + 2), of degree 3 below 2^(3b + 3), a sum of two of these below
// 2^(3b + 4), products below 2^(5b + 5), their sum below 2^(5b + 7).
template <int d, class Result>
constexpr int fitting_bits = (static_cast<int>(8 * sizeof(Result)) - 1 - (d == 2 ? 4 : 7)) / (d + 2);
static_assert(fitting_bits<2, std::int64_t> == 14 && fitting_bits<2, Int128> == 30);
static_assert(fitting_bits<3, std::int64_t> == 11 && fitting_bits<3, Int128> == 24);
// Growing integers have w, 2w, 3w, (d + 2)w words for coordinates below 2^(64w - 3).
static_assert(4 * (most_bits<std::int64_t> + 1) + 4 < 255 && 5 * (most_bits<std::int64_t> + 1) + 7 < 319);
static_assert(4 * (most_bits<Int128> + 1) + 4 < 511 && 5 * (most_bits<Int128> + 1) + 7 < 639);

/// Where the sphere passes through the last point the perturbation (perturbed_sign) lifts the lexicographically
/// largest point most: its effect on the sphere decides, then that of the second largest.
template <int d, class Integer>
bool perturbed(const std::array<Vector<d, Integer>, static_cast<std::size_t>(d + 1)>& r,
               const std::array<int, static_cast<std::size_t>(d + 1)>& orientation) {
    constexpr std::size_t last = d + 1;
    const auto largest_but = [&r](std::size_t but) {
        std::size_t f = last;
        Vector<d, Integer> most{};  // the last point
        for (std::size_t i = 0; i < last; ++i)
            if (i != but && most < r[i]) f = i, most = r[i];
        return f;
    };
    const std::size_t f = largest_but(last);
    if (f == last) return false;
    if (orientation[f] != 0) return orientation[f] > 0;
    const std::size_t g = largest_but(f);
    return g != last && orientation[g] > 0;
}

/// Calls decide(minors) with the sphere of r, whose numbers have the narrowest type that is known to hold them.
template <int d, class Integer, class Decide>
auto of_sphere(const Differences<d, Integer, d + 1>& r, Decide decide) {
    if constexpr (sizeof(Integer) == sizeof(std::int64_t)) {
        if (r.bits <= fitting_bits<d, std::int64_t>) return decide(sphere_minors<Fitting<std::int64_t>, Integer>(r.v));
        if (r.bits <= fitting_bits<d, Int128>) return decide(sphere_minors<Fitting<Int128>, Integer>(r.v));
    }
    return decide(sphere_minors<Growing_words, Integer>(r.v));
}

/// Calls decide(r) with the differences of the points; empty where these have too many bits.
template <int d, std::size_t k, class Decide>
auto of_differences(const std::array<Scaled_point<d>, k + 1>& p, Decide decide)
    -> std::optional<decltype(decide(Differences<d, std::int64_t, k>(p, 1.0)))> {
    const Common_grid<d, k + 1> grid(p);
    if (grid.template fits<std::int64_t>()) return decide(Differences<d, std::int64_t, k>(p, grid.scale));
    if (grid.template fits<Int128>()) return decide(Differences<d, Int128, k>(p, grid.scale));
    return {};
}

/// From the order of the predicates to that of a cell and a point.
template <int d>
auto point_last(std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)> p) {
    std::swap(p[d], p[d + 1]);
    return p;
}

/// Differences to the last of three points: the sign is that of the orientation. With four points it is the opposite.
template <class Integer>
int orientation(const Differences<2, Integer, 2>& r) {
    return sign_of(Growing_words::minor(r.v[0][0], r.v[0][1], r.v[1][0], r.v[1][1]));
}
template <class Integer>
int orientation(const Differences<3, Integer, 3>& r) {
    return -sign_of(Growing_words::dot(cross<Growing_words, Integer>(r.v[0], r.v[1]), r.v[2]));
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
    for (std::size_t c = 0; c < d; ++c)  // in a plane across an axis, as faces of boxes are
        if (std::all_of(p.begin(), p.end(), [&](const auto& q) { return (*q.x)[c] == (*p[0].x)[c]; })) return 0;
    return of_differences<d, static_cast<std::size_t>(d)>(p, [](const auto& r) { return orientation(r); });
}

template <int d>
std::optional<int> integer_empty_sphere(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p) {
    return of_differences<d, static_cast<std::size_t>(d + 1)>(point_last<d>(p), [](const auto& r) {
        return of_sphere<d>(r, [](const auto& m) { return -sign_of(m.determinant); });
    });
}

std::optional<Bicell_signs> integer_bicell(const std::array<Scaled_point<3>, 5>& p) {
    return of_differences<3, 4>(point_last<3>(p), [](const auto& r) {
        // lambda of a, b, c is -bce, ace, -abe, and the sum of all five is 0.
        return of_sphere<3>(r, [](const auto& m) {
            return Bicell_signs{-sign_of(m.determinant),
                                {sign_of(m.bce - m.ace), sign_of(m.bce + m.abe), sign_of(m.abe - m.ace)}};
        });
    });
}

template <int d>
std::optional<bool> integer_sphere_holds(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p) {
    return of_differences<d, static_cast<std::size_t>(d + 1)>(p, [](const auto& r) {
        return of_sphere<d>(r, [&r](const auto& m) {
            const int inside = sign_of(m.determinant);
            return inside != 0 ? inside > 0 : perturbed<d>(r.v, m.orientations());
        });
    });
}

template double grid_scale<2>(const Coordinates<2>&);
template double grid_scale<3>(const Coordinates<3>&);
template std::optional<int> integer_orientation<2>(const std::array<Scaled_point<2>, 3>&);
template std::optional<int> integer_orientation<3>(const std::array<Scaled_point<3>, 4>&);
template std::optional<int> integer_empty_sphere<2>(const std::array<Scaled_point<2>, 4>&);
template std::optional<int> integer_empty_sphere<3>(const std::array<Scaled_point<3>, 5>&);
template std::optional<bool> integer_sphere_holds<2>(const std::array<Scaled_point<2>, 4>&);
template std::optional<bool> integer_sphere_holds<3>(const std::array<Scaled_point<3>, 5>&);

}  // namespace annulus::inline v1
