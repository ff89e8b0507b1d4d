// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of Voronoi volumes in periodic boxes: finite differences, sums, the same set as an open one, crystals.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>
#include <annulus/voronoi.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Points = std::vector<Coordinates<d>>;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::vector<double> weights_of(Periodic_cases& cases, std::size_t n) {
    std::vector<double> weights(n);
    for (double& w : weights) w = cases.uniform(-1, 1);
    return weights;
}

double weighted(const std::vector<double>& volumes, const std::vector<double>& weights) {
    double sum = 0;
    for (std::size_t v = 0; v < volumes.size(); ++v) sum += weights[v] * volumes[v];
    return sum;
}

/// Rows are complete, ascending and add up to 0, so do columns; the matrix and the gradient agree.
template <int d>
void expect_consistent(const Periodic_mesh<d>& mesh, const std::vector<double>& weights, double size) {
    const std::size_t n = mesh.number_of_vertices();
    const auto gradient = mesh.voronoi_gradient(weights);
    const auto jacobian = mesh.voronoi_jacobian();
    REQUIRE(gradient.size() == n);
    REQUIRE(jacobian.begin.size() == n + 1);
    REQUIRE(at(jacobian.begin[n]) == jacobian.index.size());
    Points<d> product(n), column(n);
    for (std::size_t i = 0; i < n; ++i) {
        Coordinates<d> row{};
        bool itself = false;
        for (Index k = jacobian.begin[i]; k < jacobian.begin[i + 1]; ++k) {
            CHECK((k == jacobian.begin[i] || jacobian.index[at(k - 1)] < jacobian.index[at(k)]));
            itself = itself || at(jacobian.index[at(k)]) == i;
            for (std::size_t a = 0; a < d; ++a) {
                row[a] += jacobian.value[at(k)][a];
                column[at(jacobian.index[at(k)])][a] += jacobian.value[at(k)][a];
                product[at(jacobian.index[at(k)])][a] += weights[i] * jacobian.value[at(k)][a];
            }
        }
        CHECK(itself);
        for (std::size_t a = 0; a < d; ++a) CHECK(std::fabs(row[a]) < 1e-9 * size);
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t a = 0; a < d; ++a) {
            CHECK(std::fabs(column[i][a]) < 1e-12 * size);
            CHECK(std::fabs(product[i][a] - gradient[i][a]) < 1e-12 * size);
        }
    for (const auto& g : mesh.voronoi_gradient(std::vector<double>(n, 0.7)))
        for (const double c : g) CHECK(c == 0);
}

template <int d>
void expect_differences(const Points<d>& x, const Box<d>& box, const std::vector<double>& weights, double h) {
    const auto gradient = Periodic_mesh<d>(x, box).voronoi_gradient(weights);
    Periodic_mesh<d> mesh(x, box);
    for (std::size_t v = 0; v < x.size(); ++v)
        for (std::size_t a = 0; a < d; ++a) {
            double sum[2];
            for (const int side : {0, 1}) {
                auto moved = x;
                moved[v][a] += side == 1 ? h : -h;
                mesh.move_all(moved);
                sum[side] = weighted(mesh.voronoi_volumes(), weights);
            }
            CHECK(gradient[v][a] == Approx((sum[1] - sum[0]) / (2 * h)).margin(2e-6));
        }
}

/// The periodic set, images from -2 to 2, as an open one: those of the cell in the middle are the first.
template <int d>
Points<d> images_of(const Points<d>& x, const Box<d>& box) {
    Points<d> all = x;
    for (int k = -2; k <= 2; ++k)
        for (int l = -2; l <= 2; ++l)
            for (int m = d == 2 ? 0 : -2; m <= (d == 2 ? 0 : 2); ++m) {
                if (k == 0 && l == 0 && m == 0) continue;
                const std::array<int, 3> by{k, l, m};
                for (const auto& p : x) {
                    Coordinates<d> q = p;
                    for (std::size_t b = 0; b < d; ++b)
                        for (std::size_t a = 0; a < d; ++a) q[a] += by[b] * box.vectors()[b][a];
                    all.push_back(q);
                }
            }
    return all;
}

template <int d>
void expect_as_open(const Periodic_mesh<d>& mesh, const std::vector<double>& weights) {
    const Points<d> given(mesh.points().begin(), mesh.points().end());
    const auto all = images_of<d>(given, mesh.box());
    std::vector<double> of_all;
    for (std::size_t k = 0; k < all.size(); ++k) of_all.push_back(weights[k % given.size()]);
    const Moving_mesh<d> open(all);
    const auto expected = open.voronoi_gradient(of_all);
    const auto gradient = mesh.voronoi_gradient(weights);
    for (std::size_t v = 0; v < given.size(); ++v)
        for (std::size_t a = 0; a < d; ++a) CHECK(gradient[v][a] == Approx(expected[v][a]).margin(1e-12));
}

template <int d>
void expect_right(std::uint64_t seed) {
    Periodic_cases cases(seed);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {2U, 5U, 30U}) {
            CAPTURE(d, kind, n);
            const Box<d> box = cases.box<d>(kind);
            const auto x = cases.points<d>(box, n);
            const auto weights = weights_of(cases, n);
            const Periodic_mesh<d> mesh(x, box);
            expect_consistent<d>(mesh, weights, 1);
            if (n < 30) expect_differences<d>(x, box, weights, 1e-6);
        }
}

}  // namespace

TEST_CASE("Derivatives of volumes in periodic boxes are those of finite differences", "[measure][periodic]") {
    for (int k = 0; k < repeats(3); ++k) {
        expect_right<2>(static_cast<std::uint64_t>(40 + k));
        expect_right<3>(static_cast<std::uint64_t>(60 + k));
    }
}

TEST_CASE("Derivatives of volumes in periodic boxes are those of the images as an open set", "[measure][periodic]") {
    Periodic_cases cases(71);
    const Box<2> flat[] = {Box<2>::orthorhombic({2, 1.5}), Box<2>({{{1.5, 0}, {0.5, 1.25}}})};
    const Box<3> solid[] = {Box<3>::orthorhombic({1, 1.5, 2}), Box<3>({{{2, 0, 0}, {0.5, 1.5, 0}, {-.25, .5, 1.25}}})};
    for (const std::size_t n : {12U, 25U}) {
        for (const auto& box : flat) expect_as_open<2>({cases.points<2>(box, n, 0.5), box}, weights_of(cases, n));
        for (const auto& box : solid) expect_as_open<3>({cases.points<3>(box, n, 0.5), box}, weights_of(cases, n));
    }
}

TEST_CASE("A point alone in a periodic box has no derivative", "[measure][periodic]") {
    const Periodic_mesh<3> one(Points<3>{{0.5, 0.25, 0.125}}, Box<3>({{{2, 0, 0}, {0.5, 1.5, 0}, {-.25, .5, 1.25}}}));
    CHECK(one.voronoi_gradient(std::vector<double>{3}) == Points<3>{{0, 0, 0}});
    CHECK(one.voronoi_jacobian().begin == std::vector<Index>{0, 1});
    CHECK(one.voronoi_jacobian().index == std::vector<Index>{0});
    CHECK(one.voronoi_jacobian().value == Points<3>{{0, 0, 0}});
    const Periodic_mesh<2> empty(Points<2>{}, Box<2>::orthorhombic({1, 1}));
    CHECK(empty.voronoi_gradient({}).empty());
    CHECK(empty.voronoi_jacobian().begin == std::vector<Index>{0});
    for (const std::size_t n : {0U, 2U}) {
        try {
            (void)one.voronoi_gradient(std::vector<double>(n));
            FAIL("no error");
        } catch (const Error& e) {
            CHECK(e.code() == Error_code::wrong_size);
        }
    }
}

TEST_CASE("Empty facets add nothing to derivatives in periodic boxes, nor do images", "[measure][periodic]") {
    // Four atoms of fcc; an octahedron's centre has six empty facets.
    const Points<3> x{{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
    const Box<3> box = Box<3>::orthorhombic({1, 1, 1});
    const std::vector<double> weights{1, -0.5, 0.25, 2};
    const Periodic_mesh<3> mesh(x, box);
    expect_consistent<3>(mesh, weights, 1);
    expect_differences<3>(x, box, weights, 1e-8);
    auto away = x;
    away[1][0] += 3, away[2][1] -= 7, away[3][2] += 1;
    CHECK(Periodic_mesh<3>(away, box).voronoi_gradient(weights) == mesh.voronoi_gradient(weights));
    // In a crystal that is nearly degenerate facets are computed exactly, and hardly contribute.
    Periodic_cases cases(5);
    auto shaken = x;
    for (auto& p : shaken)
        for (double& c : p) c += cases.uniform(-1e-13, 1e-13);
    const auto gradient = mesh.voronoi_gradient(weights);
    const auto near = Periodic_mesh<3>(shaken, box).voronoi_gradient(weights);
    for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t a = 0; a < 3; ++a) CHECK(near[v][a] == Approx(gradient[v][a]).margin(1e-11));
}

TEST_CASE("Derivatives of volumes scale with the periodic box, which may be thin", "[measure][periodic]") {
    Periodic_cases cases(9);
    const auto vectors = cases.box<3>(1).vectors();
    const auto x = cases.points<3>(Box<3>(vectors), 20);
    const auto weights = weights_of(cases, 20);
    const auto usual = Periodic_mesh<3>(x, Box<3>(vectors)).voronoi_gradient(weights);
    for (const int unit : {-100, 100}) {
        auto longer = vectors;
        auto y = x;
        for (auto& v : longer)
            for (double& c : v) c = std::ldexp(c, unit);
        for (auto& p : y)
            for (double& c : p) c = std::ldexp(c, unit);
        const auto gradient = Periodic_mesh<3>(y, Box<3>(longer)).voronoi_gradient(weights);
        for (std::size_t v = 0; v < 20; ++v)
            for (std::size_t a = 0; a < 3; ++a) CHECK(std::ldexp(gradient[v][a], -2 * unit) == usual[v][a]);
    }
    // A layer of one point each, so thin that areas are lengths: those of points on a line, w_k (x_k+1 - x_k-1) / 2.
    const double thin = 1e-12;
    const Box<2> flat = Box<2>::orthorhombic({1, thin});
    const Points<2> line{{0.0, 0}, {0.25, 0}, {0.625, 0}};
    const auto gradient = Periodic_mesh<2>(line, flat).voronoi_gradient(std::vector<double>{1, 2, 4});
    CHECK(gradient[0][0] == Approx(thin * (4 - 2) / 2).epsilon(1e-9));
    CHECK(gradient[1][0] == Approx(thin * (1 - 4) / 2).epsilon(1e-9));
    CHECK(gradient[2][0] == Approx(thin * (2 - 1) / 2).epsilon(1e-9));
}
