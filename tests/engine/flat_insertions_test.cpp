// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices inserted one by one while all of them are in a plane or on a line: no insertion rebuilds.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/viewed_mesh.h>

#include <cstdint>
#include <random>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Delaunay_of = testing::Viewed_mesh<d>;

/// A lattice in scan order, `side` along the first d - 1 axes.
template <int d>
std::vector<Coordinates<d>> layer(std::size_t side) {
    std::vector<Coordinates<d>> x(1, Coordinates<d>{});
    for (std::size_t k = 0; k + 1 < d; ++k) {
        std::vector<Coordinates<d>> more;
        for (const auto& p : x)
            for (std::size_t i = 0; i < side; ++i) {
                more.push_back(p);
                more.back()[k] = static_cast<double>(i);
            }
        x = std::move(more);
    }
    return x;
}

template <int d, class Triangulation>
void check(Strategy strategy) {
    CAPTURE(name_of(strategy));
    Options options;
    options.strategy = strategy;
    Triangulation dt(options);
    const auto x = layer<d>(d == 2 ? 2500 : 50);
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Failing_new counting(std::uint64_t{1} << 60);
        (void)dt.insert(x[i]);
        if (2 * i > x.size()) bytes += Failing_new::bytes();
    }
    CHECK(bytes < x.size() / 2 * 3 * x.size());  // listing all vertices for each takes more than 4 n
    CHECK(dt.audit().delaunay());
    Coordinates<d> above{};
    above[d - 1] = 1.0;
    (void)dt.insert(above);
    CHECK(dt.cells().vertices.size() >= x.size() - 1);
    CHECK(dt.audit().delaunay());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A layer that is filled vertex by vertex is not rebuilt for each of them, dimension",
                       "[engine][flat]", ((int d), d), 2, 3) {
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::tolerances, Strategy::rebuild, Strategy::tolerances_each}) {
        check<d, Moving_mesh<d>>(strategy);
        check<d, Delaunay_of<d>>(strategy);
    }
}

TEMPLATE_TEST_CASE_SIG("Vertices come and go in a hyperplane, and into it and out of it, dimension", "[engine][flat]",
                       ((int d), d), 2, 3) {
    std::mt19937_64 random(3);
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances, Strategy::relocate}) {
        CAPTURE(name_of(strategy));
        Options options;
        options.strategy = strategy;
        Delaunay_of<d> dt(options);
        std::vector<Index> there;
        for (int change = 0; change < 300; ++change) {
            CAPTURE(change);
            Coordinates<d> p{};
            const std::size_t free = random() % 12 == 0 ? d : 1 + random() % (d - 1);  // coordinates that are not 0
            for (std::size_t k = 0; k < free; ++k) p[k] = static_cast<double>(random() % 64);
            try {
                if (random() % 3 == 0 && !there.empty()) {
                    const std::size_t k = random() % there.size();
                    if (random() % 2 == 0) {
                        (void)dt.move(there[k], p);
                    } else {
                        dt.remove(there[k]);
                        there.erase(there.begin() + static_cast<std::ptrdiff_t>(k));
                    }
                } else {
                    there.push_back(dt.insert(p));
                }
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
            }
            const Audit_result verdict = dt.audit();
            INFO(verdict.first_fault);
            REQUIRE(verdict.delaunay());
            REQUIRE(dt.view_is_valid());
            REQUIRE(dt.view_dimension() == dt.mesh().dimension());
            // Mostly flat: removes vertices that are not in the hyperplane.
            if (dt.mesh().dimension() == d && random() % 2 == 0)
                for (std::size_t k = there.size(); k-- > 0;)
                    if (dt.points()[static_cast<std::size_t>(there[k])][d - 1] != 0.0) {
                        dt.remove(there[k]);
                        there.erase(there.begin() + static_cast<std::ptrdiff_t>(k));
                    }
        }
    }
}
