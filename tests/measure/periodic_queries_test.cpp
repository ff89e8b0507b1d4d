// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::nearest_vertices, natural_neighbours and thetas, beside all images, insertion, and bi-cells of lists.
#include <annulus/error.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/kernel/periodic_locate.h>
#include <annulus/measure/laplace_weights.h>
#include <annulus/measure/nearest_vertex.h>
#include <annulus/measure/periodic_nearest.h>
#include <annulus/mesh/evaluate.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
Coordinates<d> moved(const Coordinates<d>& p, const Shift<d>& shift, const typename Box<d>::Vectors& box) {
    Coordinates<d> x = p;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) x[i] += shift[j] * box[j][i];
    return x;
}

/// The walk finds what all images are compared for, and nothing is nearer.
template <int d>
void expect_nearest(const typename Box<d>::Vectors& vectors, std::size_t n, Periodic_cases& cases) {
    const Box<d> box(vectors);
    const Lattice<d> lattice(vectors);
    std::vector<Coordinates<d>> place;
    for (const auto& p : cases.points<d>(box, n)) place.push_back(lattice.representative(p, 0).place);
    Periodic_table<d> table;
    Periodic_builder<d>().build(lattice, place, 1, table);
    for (int k = 0; k < 20; ++k) {
        const Coordinates<d> p = lattice.representative(cases.point<d>(box, 2), 0).place;
        const Lifted_cell<d> seen = locate<d>(table, lattice, place, p);
        const Lifted_corner<d> corner =
            nearest_corner<d>(table, lattice, place, p, {seen.cell, Offset<d>{} - seen.shift});
        const Image<d> found = table.image(corner.at.cell, corner.slot, corner.at.shift);
        const auto at = [&](Image<d> s) { return lattice.place(place[static_cast<std::size_t>(s.vertex)], s.label); };
        const Image<d> of_all = nearest_of_all<d>(lattice, place, p);
        CHECK_FALSE(is_nearer<d>(p, at(of_all), at(found)));
        CHECK_FALSE(is_nearer<d>(p, at(found), at(of_all)));
        const Lifted_corner<d> same = corner_at<d>(table, of_all);
        CHECK(table.image(same.at.cell, same.slot, same.at.shift) == of_all);
        bool any = false;
        Shift<d> o;
        o.fill(-4);
        for (std::size_t i = 0; i < d;) {
            for (std::size_t v = 0; v < n; ++v)
                any = any || is_nearer<d>(p, at(Image<d>(static_cast<Index>(v), Offset<d>(o))), at(found));
            for (i = 0; i < d && ++o[i] > 4; ++i) o[i] = -4;
        }
        CHECK_FALSE(any);
    }
}

/// Weights are those of the facets of the point as a vertex, shifts are from the images that were given.
template <int d>
void expect_natural_neighbours(int kind, std::size_t n) {
    CAPTURE(d, kind, n);
    Periodic_cases cases(n);
    const Box<d> box = cases.box<d>(kind);
    Periodic_mesh<d> mesh(cases.points<d>(box, n, 2), box);
    const auto& vectors = mesh.box().vectors();
    auto queries = cases.points<d>(box, 6, 3);
    queries.push_back(mesh.points()[n / 2]);
    const Periodic_weights<d> found = mesh.natural_neighbours(queries);
    const auto nearest = mesh.nearest_vertices(queries);
    REQUIRE(found.begin.size() == queries.size() + 1);
    CHECK((found.begin.front() == 0 && found.begin.back() == found.image.size()));
    REQUIRE(found.image.size() == found.weight.size());
    for (std::size_t q = 0; q < queries.size(); ++q) {
        double sum = 0, least = std::numeric_limits<double>::infinity();
        Coordinates<d> mean{};
        std::vector<double> of_vertex(n, 0.0);
        for (std::size_t k = found.begin[q]; k < found.begin[q + 1]; ++k) {
            const auto v = static_cast<std::size_t>(found.image[k].vertex);
            const Coordinates<d> x = moved<d>(mesh.points()[v], found.image[k].shift, vectors);
            double squares = 0;
            for (std::size_t i = 0; i < d; ++i) {
                mean[i] += found.weight[k] * (x[i] - queries[q][i]);
                squares += (x[i] - queries[q][i]) * (x[i] - queries[q][i]);
            }
            CHECK(found.weight[k] > 0);
            sum += found.weight[k];
            of_vertex[v] += found.weight[k];
            least = std::min(least, squares);
        }
        CHECK(std::fabs(sum - 1) < 1e-12);
        for (const double m : mean) CHECK(std::fabs(m) < 1e-9);
        const Coordinates<d> x =
            moved<d>(mesh.points()[static_cast<std::size_t>(nearest[q].vertex)], nearest[q].shift, vectors);
        double squares = 0;
        for (std::size_t i = 0; i < d; ++i) squares += (x[i] - queries[q][i]) * (x[i] - queries[q][i]);
        CHECK(std::fabs(squares - least) <= 1e-12);  // the nearest one is a natural neighbour
        if (q + 1 == queries.size()) {
            CHECK(of_vertex[n / 2] > 1 - 1e-6);  // a point in another box may be rounded to a place beside
            if (kind == 0) CHECK((of_vertex[n / 2] == 1 && found.begin[q + 1] - found.begin[q] == 1));
            continue;
        }
        Periodic_mesh<d> other(mesh.saved());
        const Index p = other.insert(queries[q]);
        const auto list = other.neighbours();
        double total = 0;
        for (std::size_t k = 0; k < list.first.size(); ++k)
            if (list.first[k] == p && list.second[k] != p) total += list.area[k] / list.distance[k];
        for (std::size_t k = 0; k < list.first.size(); ++k)
            if (list.first[k] == p && list.second[k] != p)
                of_vertex[static_cast<std::size_t>(list.second[k])] -= list.area[k] / list.distance[k] / total;
        for (const double w : of_vertex) CHECK(std::fabs(w) < 1e-7);
    }
}

/// The least theta of the bi-cells that the lists of cells have.
template <int d>
void expect_thetas(int kind, std::size_t n) {
    CAPTURE(d, kind, n);
    Periodic_cases cases(n + 100);
    const Box<d> box = cases.box<d>(kind);
    Periodic_mesh<d> mesh(cases.points<d>(box, n + 1), box);
    mesh.remove(0);
    const auto input = mesh.audit_input();
    std::vector<double> expected(n + 1, std::numbers::pi / 2);
    for (std::size_t c = 0; c < input.cells.vertices.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)> x;
            std::vector<Index> of;
            const auto take = [&](std::size_t cell, std::size_t k, const Shift<d>& by) {
                Shift<d> s = input.cells.offsets[cell][k];
                for (std::size_t a = 0; a < d; ++a) s[a] += by[a];
                const Index v = input.cells.vertices[cell][k];
                const auto image = std::pair(v, s);
                x[of.size()] = moved<d>(input.points[static_cast<std::size_t>(v)], s, mesh.box().vectors());
                of.push_back(v);
                return image;
            };
            std::vector<std::pair<Index, Shift<d>>> facet;
            for (std::size_t k = 0; k <= d; ++k)
                if (k != i) facet.push_back(take(c, k, {}));
            const auto beyond = static_cast<std::size_t>(input.cells.neighbours[c][i]);
            const Shift<d>& by = input.cells.translations[c][i];
            for (std::size_t k = 0; k <= d; ++k) {
                Shift<d> s = input.cells.offsets[beyond][k];
                for (std::size_t a = 0; a < d; ++a) s[a] += by[a];
                const auto image = std::pair(input.cells.vertices[beyond][k], s);
                if (std::find(facet.begin(), facet.end(), image) == facet.end()) (void)take(beyond, k, by);
            }
            REQUIRE(of.size() == d + 1);
            (void)take(c, i, {});
            const double theta = bicell_theta(x);
            for (const Index v : of) {
                double& least = expected[static_cast<std::size_t>(v)];
                least = std::min(least, theta);
            }
        }
    const auto thetas = mesh.thetas();
    REQUIRE(thetas.size() == n + 1);
    CHECK(std::isnan(thetas[0]));
    for (std::size_t v = 1; v <= n; ++v) CHECK(std::fabs(thetas[v] - expected[v]) <= 1e-9);
}

}  // namespace

TEST_CASE("The nearest vertex of a box is nearer than all other images", "[measure][periodic]") {
    Periodic_cases cases(1);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (int k = 0; k < repeats(1); ++k)
            for (const std::size_t n : {1U, 2U, 9U, 60U}) {
                CAPTURE(kind, n);
                expect_nearest<2>(cases.box<2>(kind).vectors(), n, cases);
                expect_nearest<3>(cases.box<3>(kind).vectors(), n, cases);
            }
    for (const double thin : {1e-2, 1e-4})
        for (const std::size_t n : {1U, 3U, 40U}) {
            CAPTURE(thin, n);
            expect_nearest<2>(cases.thin<2>(1, thin), n, cases);
            expect_nearest<3>(cases.thin<3>(1, thin), n, cases);
            expect_nearest<3>(cases.thin<3>(2, thin), n, cases);
        }
}

TEST_CASE("Natural neighbours in a box have the facets of the point as a vertex", "[measure][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 9U, 60U}) {
            expect_natural_neighbours<2>(kind, n);
            expect_natural_neighbours<3>(kind, n);
        }
}

TEST_CASE("Thetas in a box are those of bi-cells with images", "[measure][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 9U, 60U}) {
            expect_thetas<2>(kind, n);
            expect_thetas<3>(kind, n);
        }
}

TEST_CASE("Queries without vertices, of NaN and of points that are refused", "[measure][periodic]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Box<2> box = Box<2>::orthorhombic({1, 1});
    const Periodic_mesh<2> none({}, box);
    const std::vector<Coordinates<2>> queries{{0.5, nan}, {0.5, 0.5}, {nan, 0}};
    CHECK(none.nearest_vertex({0.5, 0.5}).vertex == -1);
    CHECK(none.natural_neighbours(queries).begin == std::vector<std::size_t>{0, 0, 0, 0});
    const Periodic_mesh<2> mesh(std::vector<Coordinates<2>>{{0.25, 0.5}}, box);
    CHECK(mesh.nearest_vertices(queries)[0].vertex == -1);
    CHECK(mesh.nearest_vertices(queries)[1].vertex == 0);
    const auto found = mesh.natural_neighbours(queries);
    CHECK((found.begin[1] == 0 && found.begin[2] > 0 && found.begin[3] == found.begin[2]));
    CHECK_THROWS_AS(mesh.nearest_vertex({std::numeric_limits<double>::infinity(), 0}), Error);
    CHECK_THROWS_AS(mesh.natural_neighbours(std::vector<Coordinates<2>>{{1e40, 0}}), Error);
}

TEST_CASE("A point outside of a hull has no weights", "[measure]") {
    const std::vector<Coordinates<2>> near{{0, 0}, {1, 0}, {0, 1}};
    CHECK(laplace_weights<2>(near, {2, 2}).weight.empty());
    CHECK(std::isinf(laplace_weights<2>(near, {0.5, 0.5}).reach_upper));  // on its border
    const auto inside = laplace_weights<2>(near, {0.25, 0.25});
    CHECK((inside.point.size() == 3 && std::isfinite(inside.reach_upper)));
    CHECK(laplace_weights<2>(near, {1, 0}).point == std::vector<std::size_t>{1});
}
