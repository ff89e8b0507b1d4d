// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes of Voronoi cells compared with cells that are cut out in rational numbers (voronoi_oracle.h), for
// points of every kind.
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <measure/voronoi_oracle.h>
#include <support/catch.h>
#include <support/meshes.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cmath>
#include <limits>
#include <set>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// |volume - truth| <= relative |truth|, and the guarantee at the ends of the range of doubles.
bool is_near(double volume, const mpq_class& truth, double relative) {
    if (!std::isfinite(volume)) return false;
    if (volume == largest && truth > mpq_class(largest)) return true;
    mpq_class least = 1;
    least >>= 1074;
    const mpq_class off = mpq_class(volume) - truth;
    return abs(off) <= mpq_class(relative) * truth + (volume < 0x1p-1021 ? least : mpq_class(0));
}

template <int d>
Mesh_cells<d> cells_of(const Points_d<d>& x) {
    return Moving_mesh<d>(std::span<const Coordinates<d>>(x)).cells();
}

template <int d>
std::vector<std::size_t> cells_around(const Mesh_cells<d>& cells, Index v) {
    std::vector<std::size_t> out;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        if (std::count(cells.vertices[c].begin(), cells.vertices[c].end(), v) > 0) out.push_back(c);
    return out;
}

/// Both methods for a volume, at each vertex of x.
template <int d>
Voronoi_counts check_all(const Points_d<d>& x) {
    const Mesh_cells<d> cells = cells_of<d>(x);
    Voronoi_counts counts;
    const std::vector<double> volume = voronoi_volumes<d>(x, cells, &counts);
    REQUIRE(volume.size() == x.size());
    std::size_t bounded = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        const auto truth = exact_cell(std::span<const Coordinates<d>>(x), v);
        CAPTURE(v, volume[v]);
        REQUIRE(truth.has_value() == std::isfinite(volume[v]));
        if (!truth) {
            REQUIRE(volume[v] == infinity);
            continue;
        }
        ++bounded;
        CAPTURE(truth->get_d());
        REQUIRE(is_near(volume[v], *truth, voronoi_volume_error));
        const auto i = static_cast<Index>(v);
        REQUIRE(is_near(exact_voronoi_volume<d>(x, cells, i, cells_around<d>(cells, i)), *truth, 0x1p-49));
    }
    REQUIRE(counts.bounded == bounded);
    REQUIRE(counts.exact <= bounded);
    return counts;
}

template <int d>
std::vector<Index> counted_from_edges(std::size_t n, const Mesh_cells<d>& cells) {
    std::vector<std::set<Index>> met(n);
    for (const auto& cell : cells.vertices)
        for (const Index a : cell)
            for (const Index b : cell)
                if (a != none && b != none && a != b) met[static_cast<std::size_t>(a)].insert(b);
    std::vector<Index> out;
    for (const auto& m : met) out.push_back(static_cast<Index>(m.size()));
    return out;
}

}  // namespace

TEST_CASE("Areas of Voronoi cells are those of cells cut out exactly, points of every kind", "[measure][voronoi]") {
    for (int i = 0; i < repeats(6); ++i)
        for (const Family family : all_families) {
            const auto seed = static_cast<std::uint64_t>(1000 + i);
            Random random(seed);
            const Points x = point_set(family, 6 + random() % 40, random);
            INFO(name_of(family) << ", seed " << seed << "\n" << as_code(x));
            (void)check_all<2>(x);
            CHECK(voronoi_neighbour_counts<2>(x.size(), cells_of<2>(x)) ==
                  counted_from_edges<2>(x.size(), cells_of<2>(x)));
        }
}

TEST_CASE("Volumes of Voronoi cells are those of cells cut out exactly, points of every kind", "[measure][voronoi]") {
    for (int i = 0; i < repeats(3); ++i)
        for (const Set_3 set : all_sets_3) {
            const auto seed = static_cast<std::uint64_t>(2000 + i);
            Random random(seed);
            const Points_3 x = point_set(set, 8 + random() % 12, random);
            INFO(name_of(set) << ", seed " << seed << "\n" << as_code(x));
            (void)check_all<3>(x);
            CHECK(voronoi_neighbour_counts<3>(x.size(), cells_of<3>(x)) ==
                  counted_from_edges<3>(x.size(), cells_of<3>(x)));
        }
}

TEST_CASE("Flat tetrahedra among the lattice points of a cube, off by ulps, spoil no volume", "[measure][voronoi]") {
    for (int i = 0; i < repeats(4); ++i) {
        const auto seed = static_cast<std::uint64_t>(3000 + i);
        Random random(seed);
        Points_3 x;
        for (int k = 0; k < 27; ++k) x.push_back({double(k % 3), double(k / 3 % 3), double(k / 9)});
        for (auto& p : x)
            for (double& c : p) c = ulp_noise(random, 1 + c, 2);
        INFO("seed " << seed);
        CHECK(check_all<3>(x).bounded >= 1);
    }
}

TEMPLATE_TEST_CASE_SIG("Cells that are thin and reach far out are as good as others, dimension", "[measure][voronoi]",
                       ((int d), d), 2, 3) {
    std::size_t exact = 0;
    for (int i = 0; i < repeats(3); ++i)
        for (const double far : {0x1p12, 0x1p20, 0x1p26, 0x1p32, 0x1p40}) {
            const auto seed = static_cast<std::uint64_t>(4000 + i);
            Random random(seed);
            Points_d<d> x(14);  // one between two near ones, in a ring of far ones
            for (std::size_t k = 0; k < x.size(); ++k) {
                double length = 0;
                for (double& c : x[k]) c = between(random, -0.1, 0.1);
                for (std::size_t c = 0; c + 1 < d && k > 2; ++c) {
                    x[k][c] = between(random, -1, 1);
                    length = std::hypot(length, x[k][c]);
                }
                for (std::size_t c = 0; c + 1 < d && k > 2; ++c) x[k][c] *= far / length;
                if (k == 1 || k == 2) {
                    x[k] = x[0];
                    x[k][d - 1] += between(random, 1, 2) * (k == 1 ? 1 : -1);
                }
            }
            INFO("seed " << seed << ", far " << far);
            exact += check_all<d>(x).exact;
        }
    CHECK(exact > 0);
}

TEMPLATE_TEST_CASE_SIG(
    "Volumes scale with the points, exactly, from where they are subnormal to where they are too large, dimension",
    "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(17);
    Points_d<d> x(60);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    const auto cells = cells_of<d>(x);
    const auto once = voronoi_volumes<d>(x, cells);
    for (const int e : {-1000, -700, -400, -345, -300, 1, 300, 340, 499}) {
        Points_d<d> y = x;
        for (auto& p : y)
            for (double& c : p) c = std::ldexp(c, e);
        if (e < -1000 + 60) continue;  // coordinates would be rounded
        const auto volume = voronoi_volumes<d>(y, cells);
        CAPTURE(e);
        for (std::size_t v = 0; v < x.size(); ++v) {
            const double expected = std::isinf(once[v]) ? infinity : std::min(std::ldexp(once[v], d * e), largest);
            CHECK(volume[v] == expected);
        }
    }
}

TEST_CASE("The cells of a lattice are its boxes, exactly, in doubles alone", "[measure][voronoi]") {
    Points_3 x;
    for (int i = 0; i < 343; ++i) x.push_back({double(i % 7), 0.5 * (i / 7 % 7), 4.0 * (i / 49)});
    Voronoi_counts counts;
    const auto volume = voronoi_volumes<3>(x, cells_of<3>(x), &counts);
    CHECK(counts.bounded == 125);
    CHECK(counts.exact == 0);
    for (int i = 0; i < 343; ++i) {
        const auto within = [](int k) { return k > 0 && k < 6; };
        CHECK(volume[static_cast<std::size_t>(i)] ==
              (within(i % 7) && within(i / 7 % 7) && within(i / 49) ? 2.0 : infinity));
    }
}

TEMPLATE_TEST_CASE_SIG("Few cells of random points need integers, and all of them when that is requested, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(5);
    Points_d<d> x(4000);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    const auto cells = cells_of<d>(x);
    Voronoi_counts counts;
    const auto volume = voronoi_volumes<d>(x, cells, &counts);
    CAPTURE(counts.bounded, counts.exact);
    CHECK(counts.exact < counts.bounded / 50);
    double worst = 0;
    for (std::size_t v = 0; v < x.size(); v += 37) {
        if (!std::isfinite(volume[v])) continue;
        const auto i = static_cast<Index>(v);
        worst =
            std::max(worst, std::fabs(volume[v] / exact_voronoi_volume<d>(x, cells, i, cells_around<d>(cells, i)) - 1));
    }
    CAPTURE(worst);
    CHECK(worst < 1e-11);
}

TEMPLATE_TEST_CASE_SIG("Free indices have no volume, whatever stands there; flat sets have unbounded cells, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Moving_mesh<d> mesh{std::span<const Coordinates<d>>(grid<d>())};
    Index middle = d == 2 ? 12 : 13;
    const auto before = voronoi_volumes<d>(mesh.points(), mesh.cells());
    CHECK(std::isfinite(before[static_cast<std::size_t>(middle)]));
    mesh.remove(middle);
    mesh.remove(0);
    Points_d<d> x(mesh.points().begin(), mesh.points().end());
    x[0].fill(std::numeric_limits<double>::quiet_NaN());
    const auto after = voronoi_volumes<d>(x, mesh.cells());
    CHECK(std::isnan(after[0]));
    CHECK(std::isnan(after[static_cast<std::size_t>(middle)]));
    CHECK(after[1] == infinity);
    const auto counts = voronoi_neighbour_counts<d>(x.size(), mesh.cells());
    CHECK(counts == counted_from_edges<d>(x.size(), mesh.cells()));
    CHECK(counts[0] == 0);

    CHECK(voronoi_volumes<d>(Points_d<d>{}, Mesh_cells<d>{}).empty());
    CHECK(std::isnan(voronoi_volumes<d>(Points_d<d>(1), Mesh_cells<d>{})[0]));
    for (int spans = 1; spans < d; ++spans) {
        Points_d<d> flat;
        for (int i = 0; i < 9; ++i) {
            Coordinates<d> p{};
            p[0] = spans == 1 ? i : i % 3;
            p[1] = spans == 1 ? i : i / 3;
            flat.push_back(p);
        }
        const auto cells = cells_of<d>(flat);
        for (const double volume : voronoi_volumes<d>(flat, cells)) CHECK(volume == infinity);
        CHECK(voronoi_neighbour_counts<d>(flat.size(), cells) == counted_from_edges<d>(flat.size(), cells));
    }
}

TEST_CASE("What is no triangulation is refused", "[measure][voronoi]") {
    const Points_3 x = grid<3>();
    const Mesh_cells<3> cells = cells_of<3>(x);
    const auto code = [&](auto change, Points_3 points) {
        Mesh_cells<3> other = cells;
        change(other);
        try {
            (void)voronoi_volumes<3>(points, other);
        } catch (const Error& e) {
            return static_cast<int>(e.code());
        }
        return -1;
    };
    const auto same = [](auto&) {};
    CHECK(code(same, x) == -1);
    CHECK(code([](auto& c) { c.vertices[3][2] = 27; }, x) == static_cast<int>(Error_code::unknown_vertex));
    CHECK(code([](auto& c) { c.vertices[3][2] = -1; }, x) == static_cast<int>(Error_code::unknown_vertex));
    CHECK(code([](auto& c) { c.vertices[3][2] = none; }, x) == static_cast<int>(Error_code::unknown_vertex));
    CHECK(code([](auto& c) { std::swap(c.vertices[3][2], c.vertices[3][1]); }, x) ==
          static_cast<int>(Error_code::bad_input));
    CHECK(code([](auto& c) { c.vertices[3][2] = c.vertices[3][1]; }, x) == static_cast<int>(Error_code::bad_input));
    CHECK(code([&](auto& c) { c.neighbours[3][2] = static_cast<Index>(c.neighbours.size()); }, x) ==
          static_cast<int>(Error_code::bad_input));
    CHECK(code([](auto& c) { c.neighbours[3][2] = -2; }, x) == static_cast<int>(Error_code::bad_input));
    CHECK(code([](auto& c) { c.neighbours.pop_back(); }, x) == static_cast<int>(Error_code::wrong_size));
    CHECK(code(same, Points_3(x.begin(), x.end() - 1)) == static_cast<int>(Error_code::unknown_vertex));
    Points_3 bad = x;
    bad[4][1] = infinity;
    CHECK(code(same, bad) == static_cast<int>(Error_code::not_finite));
    bad[4][1] = 0x1p501;
    CHECK(code(same, bad) == static_cast<int>(Error_code::out_of_domain));
    // Flat cells only where there were some that spanned the space.
    Mesh_cells<3> mixed = cells;
    mixed.vertices[3][3] = none;
    for (const double volume : voronoi_volumes<3>(x, mixed)) CHECK(volume == infinity);
    const Rounding_guard guard(FE_UPWARD);
    CHECK(code(same, x) == static_cast<int>(Error_code::environment));
}
