// SPDX-License-Identifier: GPL-3.0-or-later
// A tolerance from both sides, exactly: for all pairs of hyperplanes or spheres between which the points of a
// certificate are squeezed, 0.9999 of the tolerance is not enough to make it fail, and for the nearest pair 1.001 of it
// is. Positions are rational numbers, so a ten-thousandth of any tolerance is representable.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/certificates_of.h>
#include <support/exact_moves.h>
#include <support/generators_3.h>
#include <support/repeats.h>
#include <support/small_sets.h>
#include <support/squeezes.h>
#include <support/stages.h>

#include <annulus/predicate/filtered.h>

#include <cstdio>

namespace annulus::testing {
template <std::size_t d, std::size_t n>
std::string as_code(const std::array<std::array<double, d>, n>& x) {
    std::string s;
    for (const auto& p : x) {
        s += s.empty() ? "{{" : ", {";
        for (std::size_t k = 0; k < d; ++k) s += (k > 0 ? ", " : "") + as_code(p[k]);
        s += "}";
    }
    return s + "}";
}
template <std::size_t d>
std::string as_code(const std::vector<std::array<double, d>>& x) {
    std::string s;
    for (const auto& p : x) s += as_code(std::array{p}) + " ";
    return s;
}
}  // namespace annulus::testing

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double inside = 0.9999, outside = 1.001;

template <int d, std::size_t n>
using Corners = Points_of_certificate<d, n>;

template <int d, std::size_t n>
Tuple<d, static_cast<int>(n)> tuple(const Corners<d, n>& x) {
    Tuple<d, static_cast<int>(n)> t;
    for (std::size_t i = 0; i < n; ++i) t[i] = &x[i];
    return t;
}

/// Counts of the certificates that were tried, and of the results of 1.001 tolerances.
struct Tried {
    int simplices = 0, bicells = 0;  ///< with a tolerance
    int inverted = 0;                ///< bi-cells whose sphere is still empty, but of cells that are not both positive
    int by_cells = 0;                ///< bi-cells in 3D whose tolerance is a width of their cells'
    int turned = 0;                  ///< of these, those whose sphere was no longer empty, too
    std::vector<double> further{};   ///< the least annuli of the others, in tolerances
    void print(const char* what) {
        further.push_back(1);
        std::sort(further.begin(), further.end());
        std::printf(
            "%s: 1.001 tolerances undo %d of %d orientations; of %d empty spheres whose tolerance is an annulus they "
            "fill %d "
            "and turn a cell of the others over; of %d whose tolerance is the width of a cell they turn all cells over "
            "and fill "
            "%d spheres (the annuli of the others are %.3g times as wide, half of them less than %.3g)\n",
            what, simplices, simplices, bicells - by_cells, bicells - by_cells - inverted, by_cells, turned,
            further.back(), further[further.size() / 2]);
    }
};

/// The half width of the nearest squeeze is s, which is the largest double not above it.
template <class Real>
bool is_largest_double_below(double s, const Real& half_width) {
    const double next = std::nextafter(s, HUGE_VAL);
    const mpf_class slack = half_width * mpf_class(0x1p-200, squeezing::precision);
    return mpf_class(s, 1100) <= half_width + slack && mpf_class(next, 1100) > half_width - slack;
}

template <std::size_t n, std::size_t d>
std::array<std::array<double, d>, n> any_directions(const std::array<std::array<double, d>, n>& worst, Random& random) {
    auto u = worst;
    const auto kind = random() % 3;
    for (auto& v : u) {
        if (kind == 0 && random() % 2 == 0) v = {};  // some of the points only
        if (kind == 1)
            for (double& c : v) c = -c;  // the other way round
        if (kind == 2) {
            double square = 0;
            for (double& c : v) c = between(random, -1, 1), square += c * c;
            for (double& c : v) c /= std::sqrt(square);
        }
    }
    return u;
}

template <int d>
void check_simplex(const Corners<d, d + 1>& x, Random& random, Tried& tried) {
    const Certificate_value v = orientation_exact(tuple<d, d + 1>(x));
    if (v.sign <= 0) return;
    const auto all = slabs<mpq_class, d>(x);
    const auto& nearest = least_of(all);
    HOLDS(is_largest_double_below(v.tolerance, nearest.half_width), x);
    if (!(v.tolerance > 0x1p-1020)) return;  // in subnormal numbers a ten-thousandth is nothing
    ++tried.simplices;
    for (const auto& s : all) HOLDS(sign_of_simplex<d>(moved<d>(x, s.direction, inside * v.tolerance)) > 0, x);
    HOLDS(sign_of_simplex<d>(moved<d>(x, any_directions(nearest.direction, random), inside * v.tolerance)) > 0, x);
    HOLDS(sign_of_simplex<d>(moved<d>(x, nearest.direction, outside * v.tolerance)) < 0, x);
}

template <int d>
bool has_cells(const Places<d, d + 2>& x) {
    return sign_of_cell<d>(x, true) > 0 && sign_of_cell<d>(x, false) > 0;
}

template <int d>
void check_bicell(const Corners<d, d + 2>& x, Random& random, Tried& tried) {
    const Certificate_value v = empty_sphere_exact(tuple<d, d + 2>(x));
    if (v.sign <= 0) return;
    auto all = annuli<mpq_class, d>(x);
    const auto narrowest = least_of(all);
    bool cells = false;
    if constexpr (d == 3) {
        cells = v.wrong_side != 0;
        if (cells)
            for (const bool with_q : {false, true})
                for (const auto& s : slabs_of_cell<mpq_class, d>(x, with_q)) all.push_back(s);
        // Alone, the annuli are the tolerance of Cell_widths::never.
        HOLDS(is_largest_double_below(empty_sphere_exact(tuple<d, d + 2>(x), Cell_widths::never).tolerance,
                                      narrowest.half_width),
              x);
    }
    const auto& nearest = least_of(all);
    HOLDS(is_largest_double_below(v.tolerance, nearest.half_width), x);
    if (!(v.tolerance > 0x1p-1020)) return;
    ++tried.bicells;

    const auto holds = [&](const Corners<d, d + 2>& direction, double length) {
        const auto y = moved<d>(x, direction, length);
        // Positive cells are a hypothesis, except where their widths are in the tolerance: then they follow.
        if (!has_cells<d>(y)) return !cells;
        return sign_of_empty_sphere<d>(y) > 0;
    };
    for (const auto& s : all) HOLDS(holds(s.direction, inside * v.tolerance), x);
    HOLDS(holds(any_directions(nearest.direction, random), inside * v.tolerance), x);

    const auto beyond = moved<d>(x, nearest.direction, outside * v.tolerance);
    if (narrowest.half_width <= nearest.half_width) {
        // Where points are close together beside the width, a cell has turned over before.
        const bool occupied = sign_of_empty_sphere<d>(beyond) < 0;
        HOLDS(occupied || !has_cells<d>(beyond), x);
        tried.inverted += occupied ? 0 : 1;
        return;
    }
    // The tolerance of the cells is a lower bound of that of the sphere, attained by the cells.
    ++tried.by_cells;
    HOLDS(!has_cells<d>(beyond), x);
    if (sign_of_empty_sphere<d>(beyond) <= 0) {
        ++tried.turned;
        return;
    }
    const mpf_class share = narrowest.half_width / nearest.half_width;
    tried.further.push_back(share.get_d());
}

Corners<2, 3> corners(const Triangle& t) { return {t.a, t.b, t.c}; }
Corners<2, 4> corners(const Bicell& c) { return {c.a, c.b, c.p, c.q}; }
Corners<3, 4> corners(const Tetrahedron& t) { return {t.a, t.b, t.c, t.d}; }
Corners<3, 5> corners(const Bicell_3& c) { return {c.a, c.b, c.c, c.p, c.q}; }

// ---- Small configurations -----------------------------------------------------------------------------------------

/// All cells with empty spheres; none where some d + 2 points are cospherical or d + 1 on a hyperplane.
template <int d>
std::vector<std::array<Index, d + 1>> delaunay_cells(const std::vector<Coordinates<d>>& x) {
    std::vector<std::array<Index, d + 1>> cells;
    const auto n = static_cast<unsigned>(x.size());
    for (unsigned chosen = 0; chosen < (1U << n); ++chosen) {
        std::array<Index, d + 1> c{};
        std::size_t count = 0;
        for (unsigned i = 0; i < n; ++i)
            if ((chosen >> i & 1U) != 0 && count++ <= d) c[count - 1] = static_cast<Index>(i);
        if (count != d + 1) continue;
        const Corners<d, d + 1> none_moves{};
        int sign = sign_of_simplex<d>(moved<d>(points_of<d>(c, x), none_moves, 0));
        if (sign == 0) return {};
        if (sign < 0) std::swap(c[0], c[1]);
        bool empty = true;
        for (unsigned i = 0; i < n && empty; ++i) {
            if ((chosen >> i & 1U) != 0) continue;
            std::array<Index, d + 2> b{};  // {facet.., p, q}
            std::copy_n(c.begin(), d, b.begin());
            b[d] = static_cast<Index>(i);
            b[d + 1] = c[d];
            sign = sign_of_empty_sphere<d>(moved<d>(points_of<d>(b, x), Corners<d, d + 2>{}, 0));
            if (sign == 0) return {};
            empty = sign > 0;
        }
        if (empty) cells.push_back(c);
    }
    return cells;
}

template <int d>
void check_configuration(const std::vector<Coordinates<d>>& x, Random& random, Tried& tried) {
    const auto all = certificates_of<d>(delaunay_cells<d>(x));
    for (const auto& c : all.cells) check_simplex<d>(points_of<d>(c, x), random, tried);
    for (const auto& r : all.ridges) {
        const auto p = points_of<d>(r, x);
        HOLDS(orientation_exact(tuple<d, d + 1>(p)).sign > 0, x);
        check_simplex<d>(p, random, tried);
    }
    for (const auto& b : all.bicells) check_bicell<d>(points_of<d>(b, x), random, tried);
}

}  // namespace

TEST_CASE("The worst moves of orientations and empty circles, within 0.9999 of the tolerance and at 1.001",
          "[certificate]") {
    Tried tried;
    REQUIRE(for_all("of triangles and bi-cells of every family", [&tried](const Seed& seed) {
        Random random = seed.random();
        for_each_triangle(seed.random(), 1, [&](const Triangle& t) { check_simplex<2>(corners(t), random, tried); });
        for_each_delaunay_bicell(seed.random(), 1,
                                 [&](const Bicell& c) { check_bicell<2>(corners(c), random, tried); });
    }));
    tried.print("plane");
    CHECK(tried.simplices > repeats(100));
    CHECK(tried.bicells > repeats(100));
}

TEST_CASE("The worst moves of tetrahedra and empty spheres, within 0.9999 of the tolerance and at 1.001",
          "[certificate][space]") {
    Tried tried;
    REQUIRE(for_all("of tetrahedra and bi-cells of every family", [&tried](const Seed& seed) {
        Random random = seed.random();
        for (const Family_3 family : all_families_3) {
            if (random() % 2 == 0) continue;
            check_simplex<3>(corners(tetrahedron(family, random)), random, tried);
            check_bicell<3>(corners(delaunay_bicell(family, random)), random, tried);
        }
    }));
    tried.print("space");
    CHECK(tried.simplices > repeats(100));
    CHECK(tried.bicells > repeats(100));
    CHECK(tried.by_cells > 0);
}

TEST_CASE("The worst moves of every cell, bi-cell and hull ridge of small triangulations", "[certificate][space]") {
    std::array<Tried, 2> tried;
    REQUIRE(for_all("of five kinds in both dimensions", [&tried](const Seed& seed) {
        Random random = seed.random();
        const Small_set set = all_small_sets[random() % all_small_sets.size()];
        const double off = std::ldexp(1.0, -integer(random, 2, 50));
        check_configuration<2>(small_set<2>(set, 4 + random() % 4, off, random), random, tried[0]);
        check_configuration<3>(small_set<3>(set, 5 + random() % 2, off, random), random, tried[1]);
    }));
    tried[0].print("small configurations, plane");
    tried[1].print("small configurations, space");
    for (Tried& t : tried) {
        CHECK(t.simplices > repeats(100));
        CHECK(t.bicells > repeats(100));
    }
}
