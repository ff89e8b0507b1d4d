// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices of periodic boxes: offsets, reduced bases, the grid, representatives.
#include <annulus/error.h>
#include <annulus/space/lattice.h>
#include <annulus/space/selling.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus::testing;

namespace {

Error_code code_of(const Box<2>::Vectors& vectors) {
    try {
        (void)Box<2>(vectors);
    } catch (const Error& e) {
        return e.code();
    }
    return Error_code::bad_input;  // none of the constructor's
}

template <int d>
void expect_obtuse(const Box<d>& box) {
    const Superbase<d> base = obtuse_superbase<d>(box.vectors());
    std::array<std::array<mpq_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d + 1)> x;
    for (std::size_t k = 0; k <= d; ++k)
        for (std::size_t i = 0; i < d; ++i) {
            x[k][i] = 0;
            for (std::size_t j = 0; j < d; ++j)
                x[k][i] += mpq_class(static_cast<long>(base[k][j])) * mpq_class(box.vectors()[j][i]);
        }
    for (std::size_t k = 0; k <= d; ++k)
        for (std::size_t l = 0; l < k; ++l) {
            mpq_class dot = 0;
            for (std::size_t i = 0; i < d; ++i) dot += x[k][i] * x[l][i];
            CHECK(dot <= 0);
        }
    for (std::size_t i = 0; i < d; ++i) {
        mpq_class sum = 0;
        for (std::size_t k = 0; k <= d; ++k) sum += x[k][i];
        CHECK(sum == 0);
    }
}

/// Whether x is a multiple of the grid, and how often.
double units(double x, double grid) {
    const double u = x / grid;
    CHECK(u == std::floor(u));
    return u;
}

/// The place plus image . box is the point, up to half a unit; in rational numbers, by the box as it was given.
template <int d>
void expect_representative(const Lattice<d>& lattice, const Box<d>& given, const Coordinates<d>& p) {
    const Representative<d> r = lattice.representative(p, 0);
    for (const double f : lattice.in_basis(r.place)) CHECK((f >= -0.5 && f < 1.5));
    for (std::size_t i = 0; i < d; ++i) {
        (void)units(r.place[i], lattice.grid()[i]);
        mpq_class off = mpq_class(r.place[i]) - mpq_class(p[i]);
        for (std::size_t j = 0; j < d; ++j) off += r.image[j] * mpq_class(given.vectors()[j][i]);
        CHECK(abs(off) <= mpq_class(lattice.grid()[i] * (0.5 + 0x1p-40)));
    }
}

template <int d>
void look_at_lattices(std::uint64_t seed) {
    Periodic_cases cases(seed);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
        CAPTURE(seed, kind);
        const Box<d> box = cases.box<d>(kind);
        expect_obtuse<d>(box);
        const Lattice<d> lattice(box.vectors());
        CHECK(lattice.volume() > 0);
        CHECK(lattice.volume() == Approx(box.volume()));
        for (const double r : lattice.reach()) CHECK((r >= 1 && r <= 2.5 + 1e-5));
        for (std::size_t i = 0; i < d; ++i) {
            double extent = 0;
            for (std::size_t j = 0; j < d; ++j) {
                extent += std::fabs(lattice.basis()[j][i]);
                (void)units(lattice.basis()[j][i], lattice.grid()[i]);
                CHECK(std::fabs(lattice.box()[j][i] - box.vectors()[j][i]) <= lattice.grid()[i] / 2);
            }
            const double power = std::ldexp(lattice.grid()[i], 49);
            CHECK((extent < power && extent >= power / 2 * (1 - 1e-9)));
        }
        // The basis' vectors are those of the box that in_box names.
        for (std::size_t j = 0; j < d; ++j) {
            Shift<d> o{};
            o[j] = 1;
            const Shift<d> shift = lattice.in_box(Offset<d>(o));
            for (std::size_t i = 0; i < d; ++i) {
                mpq_class sum = 0;
                for (std::size_t k = 0; k < d; ++k) sum += shift[k] * mpq_class(lattice.box()[k][i]);
                CHECK(sum == mpq_class(lattice.basis()[j][i]));
            }
        }
        for (const double far : {0.5, 3.0, 1e3, 1e6}) expect_representative<d>(lattice, box, cases.point<d>(box, far));
        // Rounded once: the lattice of the rounded box is the same.
        const Lattice<d> again(lattice.box());
        CHECK(again.box() == lattice.box());
    }
}

/// Many points at once are represented as each is by itself, bit for bit.
template <int d>
void expect_represented(const Lattice<d>& lattice, const std::vector<Coordinates<d>>& x) {
    std::vector<Coordinates<d>> place, given;
    std::vector<Shift<d>> image(3);
    lattice.represent(x, place, image, given);
    REQUIRE((place.size() == x.size() && image.size() == x.size() && given.size() == x.size()));
    const auto same = [](const Coordinates<d>& a, const Coordinates<d>& b) {
        bool is = true;
        for (std::size_t i = 0; i < d; ++i) is = is && a[i] == b[i] && std::signbit(a[i]) == std::signbit(b[i]);
        return is;
    };
    for (std::size_t v = 0; v < x.size(); ++v) {
        CAPTURE(v, x[v][0], x[v][1], x[v][d - 1]);
        const Representative<d> r = lattice.representative(x[v], 0);
        CHECK(same(place[v], r.place));
        CHECK(image[v] == r.image);
        CHECK(same(given[v], lattice.imaged(r)));
    }
}

/// Points of all parts of the box and around it, and at borders of boxes and of roundings.
template <int d>
std::vector<Coordinates<d>> points_to_represent(Periodic_cases& cases, const Lattice<d>& lattice, double far) {
    std::vector<Coordinates<d>> x;
    const std::size_t n = 16 * (1 + cases.below(6)) + cases.below(16);
    for (std::size_t k = 0; k < n; ++k) {
        Coordinates<d> p = cases.point<d>(Box<d>(lattice.given()), far);
        if (far == 0.5)
            for (std::size_t i = 0; i < d; ++i) p[i] += 0.5 * (lattice.given()[0][i] + lattice.given()[1][i]);
        for (std::size_t i = 0; i < d; ++i) {
            const double g = lattice.grid()[i];
            const std::size_t how = cases.below(24);
            if (how == 0) p[i] = (std::floor(p[i] / g) + 0.5) * g;
            if (how == 1) p[i] = std::floor(p[i] / g) * g;
            if (how == 2) p[i] = std::floor(p[i] / lattice.box()[i][i]) * lattice.box()[i][i];
            if (how == 3) p[i] = cases.below(2) == 0 ? -0.0 : -1e-300;
            if (how == 4) p[i] = std::nextafter((std::floor(p[i] / g) + 0.5) * g, 0.0);
        }
        x.push_back(p);
    }
    return x;
}

template <int d>
void represent_everywhere(std::uint64_t seed) {
    Periodic_cases cases(seed);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const double scale : {1.0, 3.615, 0x1p-140})
            for (const double far : {0.5, 1.5, 3.0, 8.0, 1e3, 1e7}) {
                CAPTURE(d, seed, kind, scale, far);
                auto vectors = cases.box<d>(kind).vectors();
                for (auto& v : vectors)
                    for (double& c : v) c *= scale;
                const Lattice<d> lattice(vectors);
                expect_represented<d>(lattice, points_to_represent<d>(cases, lattice, far));
            }
}

}  // namespace

TEST_CASE("Packed offsets are the integers they are made of, and add up as these do", "[space][periodic]") {
    const Shift<3> a{-511, 3, 511}, b{7, -5, -200};
    CHECK(Offset<3>(a).unpacked() == a);
    CHECK((Offset<3>(a) + Offset<3>(b)).unpacked() == Shift<3>{-504, -2, 311});
    CHECK((Offset<3>(b) - Offset<3>(Shift<3>{7, -6, 0})).unpacked() == Shift<3>{0, 1, -200});
    CHECK(Offset<2>(Shift<2>{-3, -4}).unpacked() == Shift<2>{-3, -4});
    CHECK(Offset<3>::fits(a));
    CHECK(!Offset<3>::fits(Shift<3>{512, 0, 0}));
    CHECK(Offset<2>::fraction(3 * std::int64_t{Offset<2>(Shift<2>{-7, 9}).packed()}, 3).unpacked() == Shift<2>{-7, 9});
}

TEST_CASE("Bases are reduced, places are on the grid and within half a unit, however far points are",
          "[space][periodic]") {
    for (int k = 0; k < repeats(10); ++k) {
        look_at_lattices<2>(static_cast<std::uint64_t>(k));
        look_at_lattices<3>(static_cast<std::uint64_t>(k));
    }
}

TEST_CASE("Places are rounded with halves upward, and images do not change that", "[space][periodic]") {
    const Lattice<2> lattice(Box<2>::orthorhombic({1, 1}).vectors());
    const double g = lattice.grid()[0];
    CHECK(g == 0x1p-48);  // the power of two above 1 is 2
    for (const double at : {0.0, 3.0, -2.0}) {
        CHECK(lattice.representative({at + 0.25, 0.5 * g}, 0).place[1] == g);
        CHECK(lattice.representative({at + 0.25, 1.5 * g}, 0).place[1] == 2 * g);
        CHECK(lattice.representative({at + 0.25, 0.25 * g}, 0).place[1] == 0);
        CHECK(lattice.representative({at + 0.25, 0.5}, 0).place == Coordinates<2>{0.25, 0.5});
        CHECK(lattice.representative({at + 0.25, 0.5}, 0).image == Shift<2>{static_cast<int>(at), 0});
    }
    CHECK(lattice.imaged({{0.25, 0.5}, {-7, 3}}) == Coordinates<2>{-6.75, 3.5});
}

TEST_CASE("Boxes without volume, with bad numbers, too skewed or too large are refused", "[space][periodic]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(code_of({{{1, 0}, {2, 0}}}) == Error_code::usage);
    CHECK(code_of({{{0, 0}, {0, 1}}}) == Error_code::usage);
    CHECK(code_of({{{0.1, 0.3}, {0.1, 0.3}}}) == Error_code::usage);
    CHECK(code_of({{{1, 1}, {1, 1 + 0x1p-51}}}) == Error_code::usage);  // none on the grid
    CHECK(code_of({{{nan, 0}, {0, 1}}}) == Error_code::not_finite);
    CHECK(code_of({{{1, 0}, {0, std::numeric_limits<double>::infinity()}}}) == Error_code::not_finite);
    CHECK(code_of({{{0x1p151, 0}, {0, 1}}}) == Error_code::out_of_domain);
    CHECK(code_of({{{0x1p-152, 0}, {0, 1}}}) == Error_code::out_of_domain);
    CHECK(code_of({{{1, 0}, {40, 1}}}) == Error_code::usage);
    CHECK(code_of({{{1, 0}, {1e6, 1}}}) == Error_code::usage);
    CHECK(code_of({{{1, 0}, {8, 1}}}) == Error_code::bad_input);  // accepted
    CHECK(code_of({{{0, 1}, {1, 0}}}) == Error_code::bad_input);  // left-handed: accepted
    const Lattice<2> lattice(Box<2>::orthorhombic({1, 1}).vectors());
    CHECK_THROWS_AS(lattice.representative({1e12, 0}, 7), Error);
    try {
        (void)lattice.representative({0, nan}, 7);
        FAIL("a NaN was accepted");
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::not_finite);
        CHECK((e.vertices().size() == 1 && e.vertices()[0] == 7));
    }
}

TEST_CASE("Many points are represented as each is by itself, bit for bit", "[space][periodic]") {
    for (int k = 0; k < repeats(4); ++k) {
        represent_everywhere<2>(static_cast<std::uint64_t>(k));
        represent_everywhere<3>(static_cast<std::uint64_t>(k));
    }
}

TEST_CASE("Of many points the first that has no representative is named", "[space][periodic]") {
    const Lattice<3> lattice(Box<3>::orthorhombic({1, 2, 3}).vectors());
    for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300})
        for (const std::size_t v : {0U, 17U, 63U, 70U}) {
            std::vector<Coordinates<3>> x(75, {0.5, 0.25, 0.125}), place, given;
            std::vector<Shift<3>> image;
            x[v][v % 3] = wrong;
            x[74][1] = wrong;
            try {
                lattice.represent(x, place, image, given);
                CHECK(false);
            } catch (const Error& e) {
                CHECK(e.code() == (wrong == 1e300 ? Error_code::out_of_domain : Error_code::not_finite));
                REQUIRE(e.vertices().size() == 1);
                CHECK(e.vertices()[0] == static_cast<std::int64_t>(v));
            }
        }
}
