// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcentres compared with rational numbers: |centre - x|^2 is the same for every corner, solved by Cramer's rule.
#include <annulus/error.h>
#include <annulus/measure/circumcentre.h>
#include <support/catch.h>
#include <support/generators_3.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Row = std::vector<mpq_class>;

mpq_class determinant(const std::vector<Row>& m) {
    if (m.size() == 1) return m[0][0];
    mpq_class sum = 0;
    for (std::size_t k = 0; k < m.size(); ++k) {
        std::vector<Row> minor;
        for (std::size_t i = 1; i < m.size(); ++i) {
            Row row;
            for (std::size_t j = 0; j < m.size(); ++j)
                if (j != k) row.push_back(m[i][j]);
            minor.push_back(row);
        }
        sum += (k % 2 == 0 ? 1 : -1) * m[0][k] * determinant(minor);
    }
    return sum;
}

struct Seen {
    int computed = 0, exact = 0;
};

/// Compares, and counts whether doubles were accurate enough.
template <int d>
void check(Corners<d> x, Seen& seen) {
    std::vector<Row> m(d, Row(d));
    Row right(d);
    double size = 0;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < d; ++k) {
            m[i][k] = mpq_class(x[i + 1][k]) - mpq_class(x[0][k]);
            right[i] += m[i][k] * m[i][k] / 2;
        }
    for (const auto& p : x)
        for (const double c : p) size = std::max(size, std::fabs(c));
    const mpq_class whole = determinant(m);
    const double scale = std::ldexp(1.0, size == 0 ? 0 : -std::ilogb(size) - 1);
    if (!std::isnormal(scale)) return;
    if (sgn(whole) <= 0) {
        CHECK_THROWS_AS(circumcentre<d>(x, scale), Error);
        return;
    }
    const Circumcentre<d> c = circumcentre<d>(x, scale);
    if (!std::isfinite(c.error)) return;  // out of the range of doubles, and reported as such
    mpq_class off = 0;
    double length = 0;
    for (std::size_t k = 0; k < d; ++k) {
        std::vector<Row> with = m;
        for (std::size_t i = 0; i < d; ++i) with[i][k] = right[i];
        off += abs(determinant(with) / whole * mpq_class(scale) - mpq_class(c.offset[k]));
        length += std::fabs(c.offset[k]);
    }
    CAPTURE(c.error, length, off.get_d());
    REQUIRE(off <= mpq_class(c.error));
    REQUIRE(0x1p-52 * length <= c.error);
    ++(c.error == 0x1p-51 * length + 0x1p-1000 ? seen.exact : seen.computed);
}

}  // namespace

TEST_CASE("Circumcentres of triangles are within the error that they come with", "[measure][voronoi]") {
    Seen seen;
    for (int i = 0; i < repeats(300); ++i)
        for (const Triangle_family family : all_triangle_families) {
            Random random(static_cast<std::uint64_t>(i));
            const Triangle t = triangle(family, random);
            INFO(name_of(family) << ", seed " << i);
            check<2>({t.a, t.b, t.c}, seen);
            check<2>({t.a, t.c, t.b}, seen);
        }
    CHECK(seen.computed > 100);
    CHECK(seen.exact > 100);
}

TEST_CASE("Circumcentres of tetrahedra are within the error that they come with", "[measure][voronoi]") {
    Seen seen;
    for (int i = 0; i < repeats(200); ++i)
        for (const Family_3 family : all_families_3) {
            Random random(static_cast<std::uint64_t>(i));
            const Tetrahedron t = tetrahedron(family, random);
            INFO(name_of(family) << ", seed " << i);
            check<3>({t.a, t.b, t.c, t.d}, seen);
            check<3>({t.b, t.a, t.c, t.d}, seen);
        }
    CHECK(seen.computed > 100);
    CHECK(seen.exact > 100);
}
