// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the filter in 3D compared with its errors, maximised by climbing; and the interval stage's
// numbers compared with CGAL's intervals.

#include "worst_cases.h"

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages_3.h>

#include <annulus/predicate/bounds.h>

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

using namespace annulus;
using namespace annulus::testing;

namespace {

bool within_bounds(const Space_errors& e) {
    return e.orientation <= bounds::orientation_3 && e.slabs <= bounds::orientation_3_norms &&
           e.insphere <= bounds::annulus_3_insphere && e.norms <= bounds::annulus_3_norms &&
           e.side <= bounds::annulus_3_side;
}

}  // namespace

TEST_CASE("the filter in space is never off by more than its bounds", "[certificate][space]") {
    REQUIRE(for_all("on coordinates of one magnitude and of many", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 10; ++i) {
            Numbers x = start(15, 3, random);
            if (i % 2 == 0)
                for (double& c : x) c = std::ldexp(c, -integer(random, 0, 99));
            if (!within_bounds(space_errors(x))) RC_FAIL(as_code(x));
        }
    }));
}

TEST_CASE("the filter in space is never off by more than its bounds, sought by climbing", "[certificate][space]") {
    Random random(run_seed());
    for (const auto& [name, somewhere] : {std::tuple{"orientation_3", 3.0}, std::tuple{"orientation_3_norms", 0.0},
                                          std::tuple{"annulus_3_insphere", 5.0}, std::tuple{"annulus_3_norms", 5.0},
                                          std::tuple{"annulus_3_side", 3.0}}) {
        CAPTURE(name);
        CHECK(climb_from_anywhere(name, 3, 1000, random) > somewhere);
    }
}

TEST_CASE("the bounds of the norms in space are made of those of the vectors", "[certificate][space]") {
    CHECK(bounds::orientation_3_norms >= std::sqrt(3.0) * 2 * bounds::orientation_3_slab);
    CHECK(bounds::annulus_3_norms >= std::sqrt(3.0) * (bounds::annulus_3_n + bounds::annulus_3_m));
}

TEST_CASE("Boost's intervals and CGAL's enclose the same terms", "[certificate][space]") {
    using Cgal = CGAL::Interval_nt<false>;
    REQUIRE(for_all("of bi-cells of usual magnitudes", [](const Seed& seed) {
        for_each_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            for (const Point_3* p : c.tuple())
                for (const double x : *p)
                    if (x != 0.0 && (std::fabs(x) < 0x1p-60 || std::fabs(x) > 0x1p60)) return;
            Numbers x(15);
            std::size_t i = 0;
            for (const Point_3* p : c.tuple())
                for (const double v : *p) x[i++] = v;
            std::array<std::pair<double, double>, 10> boost, cgal;
            {
                const Rounding_guard guard(FE_UPWARD);
                const auto d = filter_errors::differences<Interval>(x);
                const auto t = annulus_terms(d[0], d[1], d[2], d[3]);
                boost[0] = {t.determinant.lower(), t.determinant.upper()};
                for (std::size_t k = 0; k < 4; ++k) boost[1 + k] = {t.inner[k].lower(), t.inner[k].upper()};
                for (std::size_t k = 0; k < 4; ++k) boost[5 + k] = {t.side[k].lower(), t.side[k].upper()};
                boost[9] = {t.cell_q.lower(), t.cell_q.upper()};
            }
            {
                const Cgal::Protector protector;
                const auto d = filter_errors::differences<Cgal>(x);
                const auto t = annulus_terms(d[0], d[1], d[2], d[3]);
                cgal[0] = {t.determinant.inf(), t.determinant.sup()};
                for (std::size_t k = 0; k < 4; ++k) cgal[1 + k] = {t.inner[k].inf(), t.inner[k].sup()};
                for (std::size_t k = 0; k < 4; ++k) cgal[5 + k] = {t.side[k].inf(), t.side[k].sup()};
                cgal[9] = {t.cell_q.inf(), t.cell_q.sup()};
            }
            const auto D = filter_errors::differences<mpq_class>(x);
            const auto T = annulus_terms(D[0], D[1], D[2], D[3]);
            const std::array<mpq_class, 10> truth{T.determinant, T.inner[0], T.inner[1], T.inner[2], T.inner[3],
                                                  T.side[0],     T.side[1],  T.side[2],  T.side[3],  T.cell_q};
            for (std::size_t k = 0; k < truth.size(); ++k) {
                HOLDS(mpq_class(boost[k].first) <= truth[k] && truth[k] <= mpq_class(boost[k].second), c);
                HOLDS(mpq_class(cgal[k].first) <= truth[k] && truth[k] <= mpq_class(cgal[k].second), c);
                // Neither is much wider than the other; square(x) is never negative, x * x may be.
                if (k >= 1 && k <= 4) continue;
                const double ours = boost[k].second - boost[k].first, theirs = cgal[k].second - cgal[k].first;
                HOLDS(ours <= 2 * theirs + 0x1p-1000 && theirs <= 8 * ours + 0x1p-1000, c);
            }
        });
    }));
}
