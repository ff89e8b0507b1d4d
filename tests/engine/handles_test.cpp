// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that name no vertex.
#include <common/oracle_3.h>

#include <support/cases.h>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <class Call>
Error_code code_of(Call call) {
    try {
        call();
    } catch (const Error& e) {
        return e.code();
    }
    return Error_code::usage;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A null handle, the vertex at infinity and a stranger name no vertex, dimension", "[relocation]",
                       ((int d), d), 2, 3) {
    using Moving = typename Space<d>::Moving;
    Points_of<d> corners(d + 1, Coordinates<d>{});
    for (std::size_t k = 0; k < d; ++k) corners[k + 1][k] = 1.0;
    Points_of<d> more = corners;
    more.push_back(corners[0]);
    more.back().fill(5.0);
    const Moving other(more);
    const typename Moving::Point there = Space<d>::point(more.back());
    for (const Setting& setting : certified_settings) {
        CAPTURE(name_of(setting));
        Moving dt(corners, options_of(setting));
        // One of the foreign handles has an index that this triangulation has, too.
        for (const auto v : {typename Moving::Vertex_handle(), dt.triangulation().infinite_vertex(), other.vertex(1),
                             other.vertex(d + 1)}) {
            CHECK(code_of([&] { dt.move(v, there); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { dt.remove(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.index(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.position(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.fixed_position(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.displacement(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.tolerance(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.theta(v); }) == Error_code::unknown_vertex);
        }
        CHECK(code_of([&] { (void)dt.vertex(d + 1); }) == Error_code::unknown_vertex);
        CHECK(dt.audit().delaunay());
    }
}
