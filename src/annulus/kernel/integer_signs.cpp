// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/integer_signs.h>

#include <annulus/arithmetic/wide_integer.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

namespace {

template <int d, class Integer>
using Vector = std::array<Integer, static_cast<std::size_t>(d)>;

template <class Integer>
constexpr int most_bits = static_cast<int>(8 * sizeof(Integer)) - 4;  // of a coordinate; a difference has one more

Unsigned128 magnitude(std::int64_t x) { return static_cast<Unsigned128>(x < 0 ? -x : x); }
Unsigned128 magnitude(Int128 x) { return static_cast<Unsigned128>(x < 0 ? -x : x); }
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

template <class Integer>
int sign_of(Integer x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}
template <std::size_t N>
int sign_of(const Wide_integer<N>& x) {
    return x.sign();
}

/// Products and sums of products of integers that grow: with w words for a coordinate, 2 w for a minor and a square,
/// 3 w for a determinant of three vectors, and 4 w and 5 w for the determinants of spheres.
struct Growing_words {
    static Wide_integer<2> minor(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t e) {
        return wide(Int128{a} * e - Int128{b} * c);
    }
    static Wide_integer<4> minor(Int128 a, Int128 b, Int128 c, Int128 e) {
        return product(wide(a), wide(e)) - product(wide(b), wide(c));
    }
    template <std::size_t d>
    static Wide_integer<2> square(const std::array<std::int64_t, d>& a) {
        Int128 s = 0;
        for (const std::int64_t c : a) s += Int128{c} * c;
        return wide(s);
    }
    template <std::size_t d>
    static Wide_integer<4> square(const std::array<Int128, d>& a) {
        Wide_integer<4> s;
        for (const Int128 c : a) s = s + product(wide(c), wide(c));
        return s;
    }
    template <class Minor, class Integer>
    static auto dot(const std::array<Minor, 3>& n, const std::array<Integer, 3>& a) {
        return product(n[0], wide(a[0])) + product(n[1], wide(a[1])) + product(n[2], wide(a[2]));
    }
    template <class A, class B>
    static auto times(const A& a, const B& b) {
        return product(a, b);
    }
};

/// The same where everything fits into one type.
template <class Result>
struct Fitting {
    template <class Integer>
    static Result minor(Integer a, Integer b, Integer c, Integer e) {
        return Result{a} * e - Result{b} * c;
    }
    template <class Integer, std::size_t d>
    static Result square(const std::array<Integer, d>& a) {
        Result s = 0;
        for (const Integer c : a) s += Result{c} * c;
        return s;
    }
    template <class Integer>
    static Result dot(const std::array<Result, 3>& n, const std::array<Integer, 3>& a) {
        return n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
    }
    static Result times(Result a, Result b) { return a * b; }
};

template <class By, class Integer>
auto cross(const Vector<3, Integer>& a, const Vector<3, Integer>& b) {
    return std::array{By::minor(a[1], a[2], b[1], b[2]), By::minor(a[2], a[0], b[2], b[0]),
                      By::minor(a[0], a[1], b[0], b[1])};
}

/// The sign of the determinant of r_k and |r_k|^2, positive when the last point is inside, and the signs of its
/// minors: orientation[i] is that of the cell with the last point in place of corner i.
template <int d>
struct Sphere_signs {
    int sphere;
    std::array<int, static_cast<std::size_t>(d + 1)> orientation;
};

template <class By, class Integer>
Sphere_signs<2> sphere_signs(const std::array<Vector<2, Integer>, 3>& r) {
    const auto& [a, b, c] = r;
    const auto bc = By::minor(b[0], b[1], c[0], c[1]), ca = By::minor(c[0], c[1], a[0], a[1]),
               ab = By::minor(a[0], a[1], b[0], b[1]);
    return {sign_of(By::times(By::square(a), bc) + By::times(By::square(b), ca) + By::times(By::square(c), ab)),
            {sign_of(bc), sign_of(ca), sign_of(ab)}};
}

template <class By, class Integer>
Sphere_signs<3> sphere_signs(const std::array<Vector<3, Integer>, 4>& r) {
    const auto& [a, b, c, e] = r;
    const auto ce = cross<By, Integer>(c, e), ab = cross<By, Integer>(a, b);
    const auto bce = By::dot(ce, b), ace = By::dot(ce, a), abe = By::dot(ab, e), abc = By::dot(ab, c);
    const auto sum = (By::times(bce, By::square(a)) - By::times(ace, By::square(b))) +
                     (By::times(abe, By::square(c)) - By::times(abc, By::square(e)));
    return {sign_of(sum), {sign_of(bce), -sign_of(ace), sign_of(abe), -sign_of(abc)}};
}

// Determinants of the sphere are of degree d + 2. With coordinates below 2^b:
// 2D: minors and squares below 2^(2b + 1), products below 2^(4b + 2), their sum below 2^(4b + 4);
// 3D: minors below 2^(2b + 1), squares below 2^(2b + 2), of degree 3 below 2^(3b + 3), products below 2^(5b + 5), their
// sum below 2^(5b + 7).
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

template <int d, class Integer>
bool sphere_holds(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p, double scale) {
    const Differences<d, Integer, d + 1> r(p, scale);
    const auto holds = [&r](const Sphere_signs<d>& s) {
        return s.sphere != 0 ? s.sphere > 0 : perturbed<d, Integer>(r.v, s.orientation);
    };
    if constexpr (sizeof(Integer) == sizeof(std::int64_t)) {
        if (r.bits <= fitting_bits<d, std::int64_t>) return holds(sphere_signs<Fitting<std::int64_t>, Integer>(r.v));
        if (r.bits <= fitting_bits<d, Int128>) return holds(sphere_signs<Fitting<Int128>, Integer>(r.v));
    }
    return holds(sphere_signs<Growing_words, Integer>(r.v));
}

template <int d, class Integer>
int orientation(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 1)>& p, double scale) {
    const Differences<d, Integer, d> r(p, scale);
    // Differences to the last of three points: the sign is that of the orientation. With four points it is the
    // opposite.
    if constexpr (d == 2) return sign_of(Growing_words::minor(r.v[0][0], r.v[0][1], r.v[1][0], r.v[1][1]));
    else return -sign_of(Growing_words::dot(cross<Growing_words, Integer>(r.v[0], r.v[1]), r.v[2]));
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
    const Common_grid<d, d + 1> grid(p);
    if (grid.template fits<std::int64_t>()) return orientation<d, std::int64_t>(p, grid.scale);
    if (grid.template fits<Int128>()) return orientation<d, Int128>(p, grid.scale);
    return {};
}

template <int d>
std::optional<bool> integer_sphere_holds(const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p) {
    const Common_grid<d, d + 2> grid(p);
    if (grid.template fits<std::int64_t>()) return sphere_holds<d, std::int64_t>(p, grid.scale);
    if (grid.template fits<Int128>()) return sphere_holds<d, Int128>(p, grid.scale);
    return {};
}

template double grid_scale<2>(const Coordinates<2>&);
template double grid_scale<3>(const Coordinates<3>&);
template std::optional<int> integer_orientation<2>(const std::array<Scaled_point<2>, 3>&);
template std::optional<int> integer_orientation<3>(const std::array<Scaled_point<3>, 4>&);
template std::optional<bool> integer_sphere_holds<2>(const std::array<Scaled_point<2>, 4>&);
template std::optional<bool> integer_sphere_holds<3>(const std::array<Scaled_point<3>, 5>&);

}  // namespace annulus::inline v1
