// SPDX-License-Identifier: GPL-3.0-or-later
// The predicates of annulus/predicates.h for points in any order and position, compared with rational numbers: signs
// with determinants, tolerances with the truth for all bi-cells of the points, and with motions within the tolerance.
#include <annulus/error.h>
#include <annulus/predicates.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Matrix = std::vector<std::vector<mpq_class>>;

mpq_class determinant(const Matrix& m) {
    if (m.size() == 1) return m[0][0];
    mpq_class sum = 0;
    for (std::size_t k = 0; k < m.size(); ++k) {
        Matrix minor;
        for (std::size_t i = 1; i < m.size(); ++i) {
            minor.push_back(m[i]);
            minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(k));
        }
        const mpq_class term = m[0][k] * determinant(minor);
        sum += k % 2 == 0 ? term : mpq_class(-term);
    }
    return sum;
}

/// The sign of orient_2d, orient_3d (`lifted` false), in_circle, in_sphere: of the matrix with a row for each point but
/// the last, relative to it.
template <std::size_t d, std::size_t k>
int true_sign(const std::array<std::array<double, d>, k>& x) {
    Matrix m;
    for (std::size_t i = 0; i + 1 < k; ++i) {
        auto& row = m.emplace_back();
        mpq_class square = 0;
        for (std::size_t c = 0; c < d; ++c) {
            row.emplace_back(mpq_class(x[i][c]) - mpq_class(x[k - 1][c]));
            square += row.back() * row.back();
        }
        if (k == d + 2) row.push_back(square);
    }
    // The corner of the lifted paraboloid below the origin is inside: this sign is that of Shewchuk's predicates, whose
    // orient3d and insphere are the negatives of ours and each other's.
    const int sign = sgn(determinant(m));
    return d == 3 ? -sign : sign;
}

Certified_sign call(const std::array<Coordinates<2>, 3>& x) { return orient_2d(x[0], x[1], x[2]); }
Certified_sign call(const std::array<Coordinates<3>, 4>& x) { return orient_3d(x[0], x[1], x[2], x[3]); }
Certified_sign call(const std::array<Coordinates<2>, 4>& x) { return in_circle(x[0], x[1], x[2], x[3]); }
Certified_sign call(const std::array<Coordinates<3>, 5>& x) { return in_sphere(x[0], x[1], x[2], x[3], x[4]); }

bool same(const Certified_sign& a, const Certified_sign& b) {
    return a.sign == b.sign && a.tolerance == b.tolerance && a.width_lower == b.width_lower &&
           a.width_upper == b.width_upper && (a.theta == b.theta || (std::isnan(a.theta) && std::isnan(b.theta))) &&
           a.stage == b.stage;
}

/// y <= the tolerance of some bi-cell of these points with an empty sphere, by rational numbers.
bool is_tolerance(std::array<Coordinates<2>, 4> x, double y) {
    std::sort(x.begin(), x.end());
    do {
        const Bicell c{x[0], x[1], x[2], x[3]};
        const Triangle q{c.a, c.b, c.q}, p{c.b, c.a, c.p};
        if (!is_bicell(c) || exact_empty_circle(c.a, c.b, c.q, c.p) <= 0) continue;
        if (Bicell_truth(c).is_at_least(y) && Triangle_truth(q).is_at_least(y) && Triangle_truth(p).is_at_least(y))
            return true;
    } while (std::next_permutation(x.begin(), x.end()));
    return false;
}
bool is_tolerance(std::array<Coordinates<3>, 5> x, double y) {
    std::sort(x.begin(), x.end());
    do {
        if (x[0] > x[1] || x[0] > x[2]) continue;  // each facet turned once
        const Bicell_3 c{x[0], x[1], x[2], x[3], x[4]};
        if (exact_orientation(c.a, c.b, c.c, c.q) <= 0 || exact_orientation(c.b, c.a, c.c, c.p) <= 0) continue;
        if (exact_empty_sphere(c.a, c.b, c.c, c.q, c.p) <= 0) continue;
        if (Bicell_3_truth(c, true).is_at_least(y)) return true;
    } while (std::next_permutation(x.begin(), x.end()));
    return false;
}
/// These are the ends of the width of the standard annulus of a bi-cell with this tolerance.
bool is_width(std::array<Coordinates<3>, 5> x, const Certified_sign& s) {
    std::sort(x.begin(), x.end());
    do {
        const Bicell_3 c{x[0], x[1], x[2], x[3], x[4]};
        if (exact_orientation(c.a, c.b, c.c, c.q) <= 0 || exact_orientation(c.b, c.a, c.c, c.p) <= 0) continue;
        if (exact_empty_sphere(c.a, c.b, c.c, c.q, c.p) <= 0) continue;
        const Annulus_truth standard(c, 0);
        if (Bicell_3_truth(c, true).is_at_least(s.tolerance) && standard.is_at_least(s.width_lower / 2) &&
            !standard.is_at_least(s.width_upper / 2 * (1 + 0x1p-52) + 0x1p-1074))
            return true;
    } while (std::next_permutation(x.begin(), x.end()));
    return false;
}
bool is_width(const std::array<Coordinates<2>, 4>& x, const Certified_sign& s) {
    return is_tolerance(x, s.tolerance) && s.width_lower >= 2 * s.tolerance * (1 - 0x1p-8);
}

bool is_tolerance(const std::array<Coordinates<2>, 3>& x, double y) {
    const bool left = exact_orientation(x[0], x[1], x[2]) > 0;
    return Triangle_truth(left ? Triangle{x[0], x[1], x[2]} : Triangle{x[1], x[0], x[2]}).is_at_least(y);
}
bool is_tolerance(const std::array<Coordinates<3>, 4>& x, double y) {
    const bool positive = exact_orientation(x[0], x[1], x[2], x[3]) > 0;
    return Tetrahedron_truth(positive ? Tetrahedron{x[0], x[1], x[2], x[3]} : Tetrahedron{x[1], x[0], x[2], x[3]})
        .is_at_least(y);
}

template <std::size_t d, std::size_t k>
void check(const std::array<std::array<double, d>, k>& x, Random& random) {
    std::string code;
    for (const auto& p : x) code += as_code(p) + ", ";
    INFO(code);
    const Certified_sign s = call(x);
    REQUIRE(int{s.sign} == true_sign(x));
    CHECK(std::isnan(s.theta) == (k == d + 1));
    if (k == d + 2) CHECK((s.theta >= 0 && s.theta <= 1.5707963267948968));
    std::vector<Certified_sign> out(1);
    if constexpr (k == d + 1 && d == 2) orient_2d(std::span(&x, 1), out);
    if constexpr (k == d + 1 && d == 3) orient_3d(std::span(&x, 1), out);
    if constexpr (k == d + 2 && d == 2) in_circle(std::span(&x, 1), out);
    if constexpr (k == d + 2 && d == 3) in_sphere(std::span(&x, 1), out);
    CHECK(same(out[0], s));
    if (s.sign == 0) {
        CHECK(s.tolerance == 0);
        CHECK((s.width_lower == 0 && s.width_upper == 0));
        CHECK(s.stage == Stage::exact);
        return;
    }
    CHECK((s.width_lower <= s.width_upper && s.width_upper > 0));
    CHECK(s.width_upper <= s.width_lower * (1 + 0x1p-9) + 0x1p-1072);
    CHECK(is_tolerance(x, s.tolerance));
    CHECK_FALSE(is_tolerance(x, s.tolerance * (1 + 0x1p-8) + 0x1p-1073));
    CHECK(s.tolerance * 2 <= s.width_upper);
    if constexpr (k == d + 2) CHECK(is_width(x, s));
    if constexpr (k == d + 1) {
        CHECK(is_tolerance(x, s.width_lower / 2));
        CHECK_FALSE(is_tolerance(x, s.width_upper / 2 * (1 + 0x1p-52) + 0x1p-1074));
    }
    // Every point moves by less than the tolerance, each coordinate by less than a part of it.
    for (int run = 0; run < 4; ++run) {
        auto y = x;
        for (auto& p : y)
            for (double& c : p) {
                const double by = s.tolerance * (random() % 2 == 0 ? 0.57 : -0.57);  // 0.57 sqrt(3) < 1
                const double to = c + by;
                if (std::fabs(to - c) <= std::fabs(by) && std::fabs(to) <= 0x1p500) c = to;
            }
        CHECK(true_sign(y) == s.sign);
    }
}

/// The same points in a random order.
template <class Row>
Row shuffled(Row x, Random& random) {
    for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[random() % i]);
    return x;
}

const int tries = repeats(25);

}  // namespace

TEST_CASE("orient_2d is exact and certified", "[predicates]") {
    Random random(21);
    for (const Triangle_family family : all_triangle_families)
        for (int i = 0; i < tries; ++i) {
            const Triangle t = triangle(family, random);
            check(std::array{t.a, t.b, t.c}, random);
        }
}

TEST_CASE("orient_3d is exact and certified", "[predicates]") {
    Random random(22);
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < tries; ++i) {
            const Tetrahedron t = tetrahedron(family, random);
            check(std::array{t.a, t.b, t.c, t.d}, random);
        }
}

TEST_CASE("in_circle is exact and certified, in whatever order and position the points are", "[predicates]") {
    Random random(23);
    for (const Bicell_family family : all_bicell_families)
        for (int i = 0; i < tries; ++i) {
            const Bicell c = bicell(family, random);
            check(shuffled(std::array{c.a, c.b, c.p, c.q}, random), random);
        }
    for (int i = 0; i < 8 * tries; ++i) {  // small integers: collinear, equal, one inside the triangle of the others
        std::array<Coordinates<2>, 4> x;
        for (auto& p : x)
            for (double& c : p) c = static_cast<double>(random() % 4);
        check(x, random);
    }
}

TEST_CASE("in_sphere is exact and certified, in whatever order and position the points are", "[predicates]") {
    Random random(24);
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < tries / 2 + 1; ++i) {
            const Bicell_3 c = bicell(family, random);
            check(shuffled(std::array{c.a, c.b, c.c, c.p, c.q}, random), random);
        }
    for (int i = 0; i < 4 * tries; ++i) {
        std::array<Coordinates<3>, 5> x;
        for (auto& p : x)
            for (double& c : p) c = static_cast<double>(random() % 3);
        check(x, random);
    }
}

TEST_CASE("theta of cospherical points is the least of their bi-cells", "[predicates]") {
    Random random(25);
    for (int i = 0; i < tries; ++i) {
        const Bicell_3 given = bicell(Family_3::cospherical_exact, random);
        std::array<Coordinates<3>, 5> x{given.a, given.b, given.c, given.p, given.q};
        const Certified_sign s = call(x);
        REQUIRE(int{s.sign} == 0);
        double least = 2;
        std::sort(x.begin(), x.end());
        do {
            if (exact_orientation(x[0], x[1], x[2], x[4]) <= 0 || exact_orientation(x[1], x[0], x[2], x[3]) <= 0)
                continue;
            double e[3], u[3], v[3];
            for (std::size_t k = 0; k < 3; ++k)
                e[k] = x[4][k] - x[3][k], u[k] = x[1][k] - x[0][k], v[k] = x[2][k] - x[0][k];
            const double normal[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
            const double along = e[0] * normal[0] + e[1] * normal[1] + e[2] * normal[2];
            least = std::min(least, std::asin(std::min(1.0, along / std::hypot(e[0], e[1], e[2]) /
                                                                std::hypot(normal[0], normal[1], normal[2]))));
        } while (std::next_permutation(x.begin(), x.end()));
        CHECK(s.theta == Approx(least).epsilon(1e-9).margin(1e-7));
    }
}
