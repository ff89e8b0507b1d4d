// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of fixed width compared with GMP and rational numbers: products of all widths, signs of points on grids of
// any fineness, degenerate or nearly so, beyond the widths, too; and what decides by them, the exact signs and values
// of certificates and the public predicates.
#include <annulus/arithmetic/wide_integer.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/integer_signs.h>
#include <annulus/predicates.h>

#include <support/catch.h>
#include <support/generators_3.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

template <std::size_t d, std::size_t k>
auto tuple_of(const std::array<std::array<double, d>, k>& x) {
    std::array<const std::array<double, d>*, k> t;
    for (std::size_t i = 0; i < k; ++i) t[i] = &x[i];
    return t;
}
template <std::size_t d, std::size_t k>
auto scaled(const std::array<std::array<double, d>, k>& x) {
    return scaled_points(tuple_of(x));
}
template <std::size_t d, std::size_t k>
std::array<std::array<double, d>, k - 1> without_last(const std::array<std::array<double, d>, k>& x) {
    std::array<std::array<double, d>, k - 1> y;
    std::copy_n(x.begin(), k - 1, y.begin());
    return y;
}

// The truth, in rational numbers; points in the order of the predicates.
int true_sign(const std::array<Coordinates<2>, 3>& x) { return exact_orientation(x[0], x[1], x[2]); }
int true_sign(const std::array<Coordinates<3>, 4>& x) { return exact_orientation(x[0], x[1], x[2], x[3]); }
int true_sign(const std::array<Coordinates<2>, 4>& x) { return exact_empty_circle(x[0], x[1], x[3], x[2]); }
int true_sign(const std::array<Coordinates<3>, 5>& x) { return exact_empty_sphere(x[0], x[1], x[2], x[4], x[3]); }

std::optional<int> by_integers(const std::array<Coordinates<2>, 3>& x) { return integer_orientation<2>(scaled(x)); }
std::optional<int> by_integers(const std::array<Coordinates<3>, 4>& x) { return integer_orientation<3>(scaled(x)); }
std::optional<int> by_integers(const std::array<Coordinates<2>, 4>& x) { return integer_empty_sphere<2>(scaled(x)); }
std::optional<int> by_integers(const std::array<Coordinates<3>, 5>& x) { return integer_empty_sphere<3>(scaled(x)); }

template <std::size_t d>
Staged_sign exact_sign(const std::array<std::array<double, d>, d + 1>& x) {
    return exact_orientation_sign(tuple_of(x));
}
template <std::size_t d>
Staged_sign exact_sign(const std::array<std::array<double, d>, d + 2>& x) {
    return exact_empty_sphere_sign(tuple_of(x));
}
Certificate_value exact_value(const std::array<Coordinates<2>, 3>& x) { return orientation_exact(tuple_of(x)); }
Certificate_value exact_value(const std::array<Coordinates<3>, 4>& x) { return orientation_exact(tuple_of(x)); }
Certificate_value exact_value(const std::array<Coordinates<2>, 4>& x) { return empty_sphere_exact(tuple_of(x)); }
Certificate_value exact_value(const std::array<Coordinates<3>, 5>& x) {
    const Certificate_value v = empty_sphere_exact(tuple_of(x));
    const Annuli annuli = annuli_exact(tuple_of(x));  // by GMP
    for (std::size_t k = 1; k < partitions_3; ++k) CHECK((v.wrong_side >> k & 1U) == (annuli.side[k] <= 0 ? 1U : 0U));
    if (const auto signs = integer_bicell(scaled(x))) {
        CHECK(signs->sphere == annuli.sign);
        for (std::size_t k = 1; k < partitions_3; ++k) CHECK(signs->side[k - 1] == annuli.side[k]);
    }
    return v;
}
Certified_sign in_public(const std::array<Coordinates<2>, 3>& x) { return orient_2d(x[0], x[1], x[2]); }
Certified_sign in_public(const std::array<Coordinates<3>, 4>& x) { return orient_3d(x[0], x[1], x[2], x[3]); }
Certified_sign in_public(const std::array<Coordinates<2>, 4>& x) { return in_circle(x[0], x[1], x[3], x[2]); }
Certified_sign in_public(const std::array<Coordinates<3>, 5>& x) { return in_sphere(x[0], x[1], x[2], x[4], x[3]); }

/// Points in any order and position. Returns whether integers of fixed width decided.
template <std::size_t d, std::size_t k>
bool check_signs(const std::array<std::array<double, d>, k>& x) {
    const int truth = true_sign(x);
    const std::optional<int> integers = by_integers(x);
    CHECK((!integers || *integers == truth));
    const Staged_sign s = exact_sign(x);
    CHECK(s.sign == truth);
    CHECK((s.stage == Stage::exact) == (integers || s.of_any_size));
    CHECK(!(integers && s.of_any_size));
    CHECK((truth != 0 || s.stage == Stage::exact));
    const Certificate_value v = exact_value(x);
    CHECK((v.sign == truth && v.stage == Stage::exact && (v.tolerance == 0 || truth > 0)));
    const Certified_sign p = in_public(x);
    CHECK(int{p.sign} == (k == d + 1 ? truth : -truth));
    CHECK((p.stage == Stage::filter || p.stage == s.stage));
    return integers.has_value();
}

/// The number of steps of the finest grid that the largest coordinate is.
template <std::size_t d, std::size_t k>
double steps_of(const std::array<std::array<double, d>, k>& x) {
    double largest = 0, finest = 0;
    for (const auto& p : scaled(x)) {
        finest = std::max(finest, p.scale);
        for (const double c : *p.x) largest = std::max(largest, std::fabs(c));
    }
    return largest * finest;
}

}  // namespace

TEST_CASE("Wide integers are those of GMP", "[certificate]") {
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

TEMPLATE_TEST_CASE_SIG("Signs in integers are those of rational numbers, dimension", "[certificate]", ((int d), d), 2,
                       3) {
    Random random(run_seed());
    int decided = 0, zeros = 0, wide = 0, left = 0;
    for (int i = 0; i < repeats(4000); ++i) {
        const int bits = 1 + static_cast<int>(random() % 53);
        const auto x = grid_points<d, d + 2>(random, bits);
        CAPTURE(d, i, bits);
        (void)check_signs(without_last(x));
        const bool by_integers = check_signs(x);
        const double steps = steps_of(x);
        CHECK(by_integers == (steps < 0x1p124));
        ++(by_integers ? decided : left);
        wide += by_integers && steps >= 0x1p60 ? 1 : 0;
        zeros += true_sign(x) == 0 ? 1 : 0;
    }
    CHECK(decided > repeats(1000));
    CHECK(zeros > repeats(100));
    CHECK(wide > repeats(200));
    CHECK(left > repeats(20));
}

TEMPLATE_TEST_CASE_SIG("A sphere holds a point in integers as by the ladder and the perturbation, dimension",
                       "[certificate]", ((int d), d), 2, 3) {
    Random random(run_seed());
    int decided = 0, perturbed = 0;
    for (int i = 0; i < repeats(20000); ++i) {
        auto x = grid_points<d, d + 2>(random, 1 + static_cast<int>(random() % 53));
        CAPTURE(d, i);
        const int sign = true_sign(without_last(x));
        if (sign == 0 || std::find(x.begin(), x.end() - 1, x[d + 1]) != x.end() - 1) continue;
        if (sign < 0) std::swap(x[0], x[1]);
        const auto holds = integer_sphere_holds<d>(scaled(x));
        if (!holds) continue;
        ++decided;
        auto in_order = x;
        std::swap(in_order[d], in_order[d + 1]);
        const int empty = true_sign(in_order);
        perturbed += empty == 0 ? 1 : 0;
        REQUIRE(*holds == ((empty != 0 ? empty : perturbed_sign(tuple_of(in_order))) < 0));
    }
    CHECK(decided > repeats(2000));
    CHECK(perturbed > repeats(200));
}

TEMPLATE_TEST_CASE_SIG("What has too many bits for integers is left to the other stages, dimension", "[certificate]",
                       ((int d), d), 2, 3) {
    std::array<Coordinates<d>, d + 2> x{};
    for (std::size_t k = 0; k <= d + 1; ++k) x[k][k % d] = k < d ? 1.0 : 0x1p-130 * static_cast<double>(k);
    CHECK(!integer_sphere_holds<d>(scaled(x)));
    CHECK(!check_signs(x));
    for (auto& p : x) p[0] = 0x1p-1074 * p[1];
    x[0][0] = 0x1p-1074;  // times no double an integer
    CHECK(grid_scale<d>(x[0]) == 0.0);
    CHECK(!integer_sphere_holds<d>(scaled(x)));
    CHECK(!check_signs(x));
    // Five points of a plane, or four of a line, one of them far finer: neither the filter nor intervals can tell.
    for (std::size_t k = 0; k <= d + 1; ++k) x[k].fill(static_cast<double>(k));
    x[1].fill(0x1p-140);
    CHECK(!check_signs(x));
    CHECK(exact_sign(x).of_any_size);
}
