// SPDX-License-Identifier: GPL-3.0-or-later
// What a sign costs that the filter leaves open, by the stage that decides it: corners of a box, which is a cube or so
// thin that integers of fixed width do not hold it.
#include <annulus/engine/sign_evaluator.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;

namespace {

template <int d>
std::vector<Coordinates<d>> box(double height) {
    std::vector<Coordinates<d>> x;
    for (unsigned corner = 0; corner < 1U << d; ++corner) {
        Coordinates<d>& p = x.emplace_back();
        for (std::size_t c = 0; c < d; ++c) p[c] = (corner >> c & 1U) != 0 ? 1.0 : 0.0;
        p[d - 1] *= height;
    }
    return x;
}

/// The cost of the later stages for the first facet between two cells, which is degenerate, and what decided.
template <int d>
Budget cost_of_facet(const std::vector<Coordinates<d>>& x, Stage_counts& counts) {
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    Sign_evaluator<d> signs(mesh.table());
    Budget budget;
    signs.begin(x, budget);
    for (const Corner_index f : mesh.table().facets()) {
        if (facet_kind(mesh.table(), f) != Facet_kind::empty_sphere) continue;
        CHECK(!signs.is_violated(f));
        break;
    }
    counts = signs.take_counts();
    return budget;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A sign by integers of any size costs more than one by those that fit, dimension", "[engine]",
                       ((int d), d), 2, 3) {
    using Cost = Cost_model<d>;
    Stage_counts counts;
    Budget budget = cost_of_facet<d>(box<d>(1.0), counts);
    CHECK(counts.exact == 1);
    CHECK(counts.interval == 0);
    CHECK(budget.later_stages == Cost::exact);
    CHECK(budget.spent == Approx(Cost::integers + Cost::filter * static_cast<double>(counts.filter)));

    budget = cost_of_facet<d>(box<d>(0x1p-140), counts);
    CHECK(counts.exact == 1);
    CHECK(counts.interval == 2);  // of the cells, which are too thin for the filter
    CHECK(budget.later_stages == Cost::exact + 2 * Cost::interval);
    CHECK(budget.spent == Approx(budget.later_stages + Cost::filter * static_cast<double>(counts.filter)));
    CHECK(Cost::integers < Cost::interval);
    CHECK(Cost::interval < Cost::exact);
}
