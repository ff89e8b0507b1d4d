// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi diagrams in periodic boxes: polygons and polyhedra from their corners, which close; crystals, few points, any
// box; after moves, insertions and removals; beside rational numbers, and beside the images as an open set.
#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>
#include <annulus/voronoi.h>

#include <measure/facet_oracle.h>
#include <measure/periodic_diagram_checks.h>
#include <support/catch.h>
#include <support/crystals.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;
using namespace annulus::testing::periodic_diagrams;

namespace {

template <int d>
void expect_any_box(std::uint64_t seed) {
    Periodic_cases cases(seed);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 3U, 7U, 40U}) {
            CAPTURE(d, seed, kind, n);
            Box<d> box = cases.box<d>(kind);
            auto x = cases.points<d>(box, n);
            Periodic_mesh<d> mesh(x, box);
            expect_whole<d>(mesh);
            if (n == 2) continue;
            for (auto& p : x)
                for (double& c : p) c += cases.uniform(-0.1, 0.1);
            mesh.move_all(x);
            expect_whole<d>(mesh);
            box = cases.box<d>(kind == 9 ? 4 : kind);
            mesh.move_all(x, box);
            mesh.insert(cases.points<d>(box, 3));
            mesh.remove(static_cast<Index>(n / 2));
            expect_whole<d>(mesh);
        }
}

template <int d>
void expect_crystal(const Point_list<d>& basis, std::size_t facets, std::size_t vertices) {
    for (const int k : {1, 2}) {
        CAPTURE(d, k, facets);
        Point_list<d> x = crystal<d>(basis, k, 1);
        for (int step = 0; step < 3; ++step) {
            const Periodic_mesh<d> mesh(x, cube<d>(k));
            expect_whole<d>(mesh);
            const auto v = mesh.voronoi();
            CHECK(std::count(v.exactly_empty.begin(), v.exactly_empty.end(), 0) * 2 ==
                  static_cast<std::ptrdiff_t>(facets * x.size()));
            const std::set<Index> different(v.vertex_of_cell.begin(), v.vertex_of_cell.end());
            CHECK(different.size() * basis.size() == vertices * x.size());
            for (std::size_t i = 0; i < x.size(); ++i) {
                CHECK(v.volume[i] * static_cast<double>(basis.size()) == Approx(1).epsilon(1e-12));
                for (std::size_t a = 0; a < d; ++a) CHECK(v.cell_centroid[i][a] == Approx(x[i][a]).margin(1e-12));
            }
            for (auto& p : x) p[0] += 0.625, p[1] -= 0.375;
            x[0][0] += 4 * k, x.back()[d - 1] -= 3 * k;  // other images
        }
    }
}

/// All images from -reach to reach, the given points first.
template <int d>
std::pair<Point_list<d>, std::map<std::pair<Index, Shift<d>>, std::size_t>> images_of(const Periodic_mesh<d>& mesh,
                                                                                      int reach) {
    Point_list<d> all;
    std::map<std::pair<Index, Shift<d>>, std::size_t> number;
    std::vector<Shift<d>> shifts{{}};
    for (int k = -reach; k <= reach; ++k)
        for (int l = -reach; l <= reach; ++l)
            for (int m = d == 2 ? 0 : -reach; m <= (d == 2 ? 0 : reach); ++m) {
                Shift<d> s{};
                const std::array<int, 3> by{k, l, m};
                std::copy_n(by.begin(), d, s.begin());
                if (s != Shift<d>{}) shifts.push_back(s);
            }
    for (const auto& s : shifts)
        for (std::size_t i = 0; i < mesh.points().size(); ++i) {
            number[{static_cast<Index>(i), s}] = all.size();
            all.push_back(image<d>(mesh.points()[i], s, mesh.box()));
        }
    return {all, number};
}

/// Facets of the cell of each point, in 3D of two, which takes half a second, from cuts in rational numbers, of all
/// images: those that are listed, and no others.
template <int d>
void expect_rational(const Periodic_mesh<d>& mesh, int reach) {
    const auto v = mesh.voronoi();
    const auto [all, number] = images_of<d>(mesh, reach);
    for (std::size_t i = 0; i < std::min<std::size_t>(mesh.points().size(), d == 2 ? 5 : 2); ++i) {
        const auto exact = exact_polytope<d>(all, i);
        std::vector<std::size_t> facet_of(all.size(), v.pair.size());
        for (std::size_t f = 0; f < v.pair.size(); ++f)
            for (const bool other : {false, true}) {
                if (at(v.pair[f][other ? 1 : 0]) != i) continue;
                const Shift<d> shift = other ? difference<d>({}, v.shift[f]) : v.shift[f];
                facet_of[number.at({v.pair[f][other ? 0 : 1], shift})] = f;
            }
        CHECK(v.volume[i] == Approx(exact.volume.get_d()).epsilon(voronoi_diagram_error));
        for (std::size_t a = 0; a < d; ++a)
            CHECK(v.cell_centroid[i][a] == Approx(exact.centroid[a].get_d()).margin(1e-9));
        for (std::size_t k = 0, side = 0; k < all.size(); ++k) {
            if (k == i) continue;
            const auto& truth = exact.sides[side++];
            const std::size_t f = facet_of[k];
            REQUIRE(truth.bounded);
            const double measure = f < v.pair.size() ? v.measure[f] : 0;
            CHECK(measure == Approx(std::sqrt(truth.square.get_d())).epsilon(voronoi_diagram_error));
            CHECK((measure == 0) == (sgn(truth.square) == 0));
            if (measure == 0 || at(v.pair[f][0]) != i ||
                all[k] != image<d>(mesh.points()[at(v.pair[f][1])], v.shift[f], mesh.box()))
                continue;
            for (std::size_t a = 0; a < d; ++a)
                CHECK(v.centroid[f][a] == Approx(truth.centroid[a].get_d()).margin(1e-8));
        }
    }
}

template <int d>
void expect_as_open(const Periodic_mesh<d>& mesh) {
    const auto v = mesh.voronoi();
    const auto [all, number] = images_of<d>(mesh, 2);
    const auto open = voronoi(Moving_mesh<d>(all));
    for (std::size_t f = 0; f < v.pair.size(); ++f) {
        const auto other = static_cast<Index>(number.at({v.pair[f][1], v.shift[f]}));
        const std::array<Index, 2> pair{std::min(v.pair[f][0], other), std::max(v.pair[f][0], other)};
        const auto found = std::lower_bound(open.pair.begin(), open.pair.end(), pair);
        REQUIRE((found != open.pair.end() && *found == pair));
        const auto k = static_cast<std::size_t>(found - open.pair.begin());
        CHECK(v.measure[f] == Approx(open.measure[k]).epsilon(2 * voronoi_diagram_error));
        for (std::size_t a = 0; a < d; ++a) CHECK(v.centroid[f][a] == Approx(open.centroid[k][a]).margin(1e-8));
        // The same corners in the same order, from any of them on; in 2D in any order.
        Point_list<d> here, there;
        for (const auto& [vertex, shift] : corners_of<d>(v, f))
            here.push_back(image<d>(v.vertex[at(vertex)], shift, mesh.box()));
        for (Index r = open.ring_begin[k]; r < open.ring_begin[k + 1]; ++r)
            there.push_back(open.vertex[at(open.ring[at(r)])]);
        REQUIRE(here.size() == there.size());
        std::size_t begin = 0;
        while (begin + 1 < there.size() && length<d>(minus<d>(there[begin], here[0])) > 1e-9) ++begin;
        if (d == 2 || pair[0] != v.pair[f][0])
            std::reverse(there.begin(), there.end()), begin = there.size() - 1 - begin;
        if (d == 2 && length<d>(minus<d>(there[begin], here[0])) > 1e-9) begin = 1 - begin;
        for (std::size_t c = 0; c < here.size(); ++c)
            CHECK(length<d>(minus<d>(there[(begin + c) % there.size()], here[c])) < 1e-8);
    }
    for (std::size_t i = 0; i < v.volume.size(); ++i) {
        CHECK(v.volume[i] == Approx(open.volume[i]).epsilon(2 * voronoi_diagram_error));
        CHECK(v.surface[i] == Approx(open.surface[i]).epsilon(2 * voronoi_diagram_error));
    }
}

}  // namespace

TEST_CASE("Voronoi diagrams in any periodic box are polygons that close, of few points and many",
          "[measure][periodic][voronoi]") {
    for (int k = 0; k < repeats(2); ++k) {
        expect_any_box<2>(static_cast<std::uint64_t>(140 + k));
        expect_any_box<3>(static_cast<std::uint64_t>(160 + k));
    }
}

TEST_CASE("Voronoi diagrams of periodic crystals have their facets and vertices, each once",
          "[measure][periodic][voronoi]") {
    expect_crystal<3>(sc, 6, 1);
    expect_crystal<3>(bcc, 14, 12);
    expect_crystal<3>(fcc, 12, 12);
    expect_crystal<3>(diamond, 16, 24);
    expect_crystal<2>({{0, 0}}, 4, 1);
    expect_crystal<2>({{0, 0}, {.5, .5}}, 4, 2);
}

TEST_CASE("Voronoi diagrams in periodic boxes are those of rational numbers", "[measure][periodic][voronoi]") {
    Periodic_cases cases(81);
    for (const int kind : {0, 1, 4, 9})
        for (const std::size_t n : {1U, 2U, 5U}) {
            CAPTURE(kind, n);
            const Box<2> flat = cases.box<2>(kind);
            expect_rational<2>({cases.points<2>(flat, n, 0.5), flat}, 3);
            if (n == 5 || (n == 2 && kind != 0 && kind != 9)) continue;
            const Box<3> solid = cases.box<3>(kind);
            expect_rational<3>({cases.points<3>(solid, n, 0.5), solid}, 2);
        }
    expect_rational<3>({sc, cube<3>(1)}, 2);
    expect_rational<3>({bcc, cube<3>(1)}, 2);
    expect_rational<3>({fcc, cube<3>(1)}, 2);
    expect_rational<2>({Point_list<2>{{0, 0}, {.5, .5}}, cube<2>(1)}, 3);
}

TEST_CASE("Voronoi diagrams in periodic boxes are those of the images as an open set", "[measure][periodic][voronoi]") {
    Periodic_cases cases(82);
    for (const int kind : {0, 1, 4}) {
        const Box<2> flat = cases.box<2>(kind);
        expect_as_open<2>({cases.points<2>(flat, 15, 0.5), flat});
        const Box<3> solid = cases.box<3>(kind);
        expect_as_open<3>({cases.points<3>(solid, 15, 0.5), solid});
    }
}

TEST_CASE("A Voronoi diagram in a periodic box without points is empty, and scales with the box",
          "[measure][periodic][voronoi]") {
    Periodic_mesh<3> mesh(Point_list<3>{}, cube<3>(1));
    CHECK(mesh.voronoi().pair.empty());
    CHECK(mesh.voronoi().vertex.empty());
    CHECK(mesh.voronoi().ring_begin == std::vector<Index>{0});
    mesh.insert({0.5, 0.25, 0.75});
    expect_whole<3>(mesh);
    mesh.remove(0);
    CHECK(mesh.voronoi().pair.empty());
    CHECK(std::isnan(mesh.voronoi().volume.at(0)));
    Periodic_cases cases(83);
    const auto vectors = cases.box<3>(4).vectors();
    const auto x = cases.points<3>(Box<3>(vectors), 20);
    const auto usual = Periodic_mesh<3>(x, Box<3>(vectors)).voronoi();
    for (const int unit : {-100, 100}) {
        auto longer = vectors;
        auto y = x;
        for (auto& v : longer)
            for (double& c : v) c = std::ldexp(c, unit);
        for (auto& p : y)
            for (double& c : p) c = std::ldexp(c, unit);
        const auto v = Periodic_mesh<3>(y, Box<3>(longer)).voronoi();
        REQUIRE(v.ring == usual.ring);
        CHECK(v.ring_shift == usual.ring_shift);
        for (std::size_t f = 0; f < v.pair.size(); ++f) CHECK(std::ldexp(v.measure[f], -2 * unit) == usual.measure[f]);
        for (std::size_t i = 0; i < v.volume.size(); ++i) CHECK(std::ldexp(v.volume[i], -3 * unit) == usual.volume[i]);
        for (std::size_t c = 0; c < v.vertex.size(); ++c)
            CHECK(std::ldexp(v.vertex[c][0], -unit) == usual.vertex[c][0]);
    }
}

TEST_CASE("Voronoi diagrams in periodic boxes that are very thin have the measures of lines",
          "[measure][periodic][voronoi]") {
    const double thin = 1e-12;
    const Periodic_mesh<2> mesh(Point_list<2>{{0.0, 0}, {0.25, 0}, {0.625, 0}}, Box<2>::orthorhombic({1, thin}));
    const auto v = mesh.voronoi();
    const std::array<double, 3> width{0.3125, 0.3125, 0.375};
    for (std::size_t i = 0; i < 3; ++i) CHECK(v.volume[i] == Approx(thin * width[i]).epsilon(1e-9));
    for (std::size_t f = 0; f < v.pair.size(); ++f) {
        if (v.exactly_empty[f] != 0) continue;
        const bool itself = v.pair[f][0] == v.pair[f][1];
        CHECK(v.measure[f] == Approx(itself ? width[at(v.pair[f][0])] : thin).epsilon(1e-9));
    }
}
