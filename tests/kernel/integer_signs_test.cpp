// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's integers compared with GMP: products of all widths, signs of points on grids of any fineness, degenerate
// or nearly so.
#include <annulus/arithmetic/wide_integer.h>
#include <annulus/kernel/integer_signs.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/predicate/exact_sign.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <cmath>
#include <numeric>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <std::size_t N>
mpz_class value_of(const Wide_integer<N>& x) {
    mpz_class z;
    mpz_import(z.get_mpz_t(), N, -1, sizeof(std::uint64_t), 0, 0, x.word.data());
    if (x.sign() < 0) z -= mpz_class(1) << (64 * N);
    return z;
}

/// Any number; often next to the ends of the range or to 0.
template <std::size_t N>
Wide_integer<N> any_integer(Random& random) {
    Wide_integer<N> x;
    for (std::uint64_t& w : x.word) {
        const auto kind = random() % 4;
        w = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random();
    }
    if (random() % 4 == 0) x.word[N - 1] = std::uint64_t{1} << 63;
    return x;
}

template <std::size_t N, std::size_t M>
void check_products(Random& random) {
    const auto a = any_integer<N>(random), c = any_integer<N>(random);
    const auto b = any_integer<M>(random);
    CAPTURE(N, M, value_of(a).get_str(), value_of(b).get_str());
    CHECK(value_of(product(a, b)) == value_of(a) * value_of(b));
    const mpz_class whole = mpz_class(1) << (64 * N);
    const auto wraps = [&whole](const mpz_class& is, const mpz_class& exact) {
        mpz_class rest = exact - is;
        return mpz_divisible_p(rest.get_mpz_t(), whole.get_mpz_t()) != 0;
    };
    CHECK(wraps(value_of(a + c), value_of(a) + value_of(c)));
    CHECK(wraps(value_of(a - c), value_of(a) - value_of(c)));
    CHECK(a.sign() == sgn(value_of(a)));
}

/// Points of a grid of 2^bits steps a side, on a sphere, a plane or a lattice of few steps more often than not; some of
/// them far finer than others.
template <int d, std::size_t k>
std::array<Coordinates<d>, k> grid_points(Random& random, int bits) {
    const auto steps = [&](int b) { return static_cast<double>(static_cast<std::int64_t>(random() >> (64 - b))); };
    const auto kind = random() % 4;
    std::array<Coordinates<d>, k> x{};
    const double far = kind == 1 ? steps(bits) : 0;
    for (auto& p : x)
        for (double& c : p) c = kind == 0 ? steps(2) : kind == 1 ? far + steps(std::min(bits, 3)) : steps(bits);
    if (kind == 2)
        for (auto& p : x) p[d - 1] = x[0][d - 1];
    if (kind == 3)  // two opposite corners of a box, and others of it: on one sphere
        for (std::size_t i = 2; i < k; ++i)
            for (std::size_t c = 0; c < d; ++c) x[i][c] = x[random() % 2][c];
    if (random() % 4 == 0)  // then only the wider integers have enough bits
        for (double& c : x[random() % k]) c = std::ldexp(c, -static_cast<int>(random() % 130));
    const int scale = static_cast<int>(random() % 400) - 200;
    for (auto& p : x)
        for (double& c : p) c = std::ldexp(c, scale);
    return x;
}

template <int d, std::size_t k>
auto scaled(const std::array<Coordinates<d>, k>& x) {
    std::array<Scaled_point<d>, k> p;
    for (std::size_t i = 0; i < k; ++i) p[i] = {&x[i], grid_scale<d>(x[i])};
    return p;
}

}  // namespace

TEST_CASE("Wide integers are those of GMP", "[kernel]") {
    Random random(run_seed());
    for (int i = 0; i < repeats(2000); ++i) {
        check_products<1, 1>(random);
        check_products<2, 1>(random);
        check_products<2, 2>(random);
        check_products<3, 2>(random);
        check_products<1, 4>(random);
        check_products<4, 2>(random);
        check_products<6, 4>(random);
    }
}

TEMPLATE_TEST_CASE_SIG("Signs in integers are those of GMP, dimension", "[kernel]", ((int d), d), 2, 3) {
    Random random(run_seed());
    int decided = 0, zeros = 0, wide = 0, left = 0;
    for (int i = 0; i < repeats(20000); ++i) {
        const int bits = 1 + static_cast<int>(random() % 53);
        auto x = grid_points<d, d + 2>(random, bits);
        CAPTURE(d, i, bits);
        Tuple<d, d + 1> cell;
        for (std::size_t k = 0; k <= d; ++k) cell[k] = &x[k];
        std::array<Coordinates<d>, d + 1> corners;
        std::copy_n(x.begin(), d + 1, corners.begin());
        const auto orientation = integer_orientation<d>(scaled<d>(corners));
        const int sign = exact_orientation_sign(cell).sign;
        REQUIRE((!orientation || *orientation == sign));
        if (sign == 0) continue;
        if (sign < 0) std::swap(x[0], x[1]);
        bool distinct = true;
        for (std::size_t k = 0; k <= d; ++k) distinct = distinct && x[k] != x[d + 1];
        if (!distinct) continue;
        const auto holds = integer_sphere_holds<d>(scaled<d>(x));
        Tuple<d, d + 2> all;
        for (std::size_t k = 0; k < d; ++k) all[k] = &x[k];
        all[d] = &x[d + 1];
        all[d + 1] = &x[d];
        const int empty = exact_empty_sphere_sign(all).sign;
        zeros += empty == 0 ? 1 : 0;
        left += holds ? 0 : 1;
        if (!holds) continue;
        ++decided;
        double largest = 0, finest = 0;
        for (const auto& p : scaled<d>(x)) {
            finest = std::max(finest, p.scale);
            for (const double c : *p.x) largest = std::max(largest, std::fabs(c));
        }
        wide += largest * finest >= 0x1p60 ? 1 : 0;
        REQUIRE(*holds == ((empty != 0 ? empty : perturbed_sign(all)) < 0));
    }
    CHECK(decided > repeats(2000));
    CHECK(zeros > repeats(200));
    CHECK(wide > repeats(500));
    CHECK(left > repeats(50));
}

TEMPLATE_TEST_CASE_SIG("What has too many bits for integers is left alone, dimension", "[kernel]", ((int d), d), 2, 3) {
    std::array<Coordinates<d>, d + 2> x{};
    for (std::size_t k = 0; k <= d + 1; ++k) x[k][k % d] = k < d ? 1.0 : 0x1p-130 * static_cast<double>(k);
    CHECK(!integer_sphere_holds<d>(scaled<d>(x)));
    for (auto& p : x) p[0] = 0x1p-1074 * p[1];
    x[0][0] = 0x1p-1074;  // times no double an integer
    CHECK(grid_scale<d>(x[0]) == 0.0);
    CHECK(!integer_sphere_holds<d>(scaled<d>(x)));
}
