// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that failed once: output of fuzz/moves_2.cpp and the property tests, reduced.
#include <common/operation.h>

#include <support/catch.h>

using namespace annulus;
using namespace annulus::oracle;

namespace {

/// The same under every update strategy.
template <int d>
void holds_under_all(Program_of<d> program) {
    for (const Setting& setting : certified_settings) {
        program.setting = setting;
        INFO(as_code(program));
        CHECK(run(program) == "");
    }
}
void holds_everywhere(const Program& program) { holds_under_all(program); }
void holds_everywhere_in_space(const Program_3& program) { holds_under_all(program); }

}  // namespace

TEST_CASE("A vertex that crosses the hull does not leave a border that winds twice", "[finds]") {
    // Every triangle positive, every circle empty, every hull vertex convex, and yet the angle at one of them was
    // beyond 2 pi: the signs of theory 1 do not exclude a double cover after flips that jumped.
    holds_everywhere({{}, {{2, 8}, {1, 9}, {9, 7}, {15, 6}, {12, 0}}, {move(0, {15, 2})}});
    holds_everywhere({{}, {{0, 3}, {5, 15}, {15, 8}, {10, 13}, {10, 14}}, {recompute_tolerances(), move(1, {5, 8})}});
}

TEST_CASE("A duplicate point beyond the hull is noticed", "[finds]") {
    holds_everywhere({{}, {{14, 6}, {1, 9}, {10, 10}, {13, 14}, {9, 12}}, {move(3, {14, 6})}});
}

TEST_CASE("Ring positions permuted into a pentagram leave no star that winds twice", "[finds]") {
    // Nothing is flipped on the way: the five triangles at the apex stay positive, their circles empty.
    const std::vector<Position> ring{{100, 0}, {31, 95}, {-81, 59}, {-81, -59}, {31, -95}};
    std::vector<Position> points{ring[0], ring[1], ring[2], ring[3], ring[4], {0, 0}};
    const std::vector<Position> star{ring[0], ring[2], ring[4], ring[1], ring[3], {0, 0}};
    holds_everywhere({{}, points, {move_all(star), move_all(points), recompute_tolerances(), move_all(star)}});
    // The same inside a larger hull.
    const std::vector<Position> frame{{1000, 1000}, {-1000, 1000}, {-1000, -1000}, {1000, -1000}};
    std::vector<Position> framed_star = star;
    points.insert(points.end(), frame.begin(), frame.end());
    framed_star.insert(framed_star.end(), frame.begin(), frame.end());
    holds_everywhere({{}, points, {move_all(framed_star), move_all(points)}});
}

TEST_CASE("A time step refused by tolerances-each leaves fixed positions and tolerances", "[finds]") {
    holds_everywhere({{}, {{2, 3}, {1, 1}, {4, 3}}, {move_all({{0, 0}, {68, 1000}, {68, 1000}})}});
    holds_everywhere(
        {{},
         {{0, 0}, {9, 0}, {0, 9}, {9, 9}, {4, 5}},
         {recompute_tolerances(), move(4, {4.125, 5}), move_all({{0, 0}, {9, 0}, {0, 9}, {9, 0}, {4, 5}})}});
}

TEST_CASE("A time step refused after the points became collinear on the way leaves all as it was", "[finds]") {
    holds_everywhere({{}, {{0, 0}, {1, 0}, {0, 1}, {3, 0}}, {move_all({{0, 0}, {1, 0}, {2, 0}, {1, 0}})}});
}

TEST_CASE("The paper's filter and tolerances keep CGAL's object valid", "[finds]") {
    CHECK(run({{Strategy::paper, Tolerance_kind::paper},
               {{87, 86}, {90, 27}, {-23, 50}, {29, -25}, {97, -53}},
               {move(0, {28, 42})}}) == "");
}

TEST_CASE("With the paper's tolerances vertices come and go without crash or hang", "[finds]") {
    const Setting paper{Strategy::paper, Tolerance_kind::paper};
    CHECK(run({paper,
               {{12, 0}, {9, 7}, {5, 4}, {2, 13}, {11, 8}},
               {move_all({{12, 0}, {9, 7}, {5, 4}, {2, 13}, {5, 10}}), remove(0), insert({11, 0})}}) == "");
    CHECK(run({paper,
               {{10, 12}, {1, 12}, {15, 13}, {12, 12}, {6, 10}, {12, 3}},
               {remove(4), move(3, {10, 12}), insert({5, 7})}}) == "");
    CHECK(run({paper,
               {{4, 8}, {9, 5}, {15, 6}, {9, 11}, {15, 1}, {14, 3}, {5, 6}, {6, 14}},
               {move_all({{0, 0}, {9, 5}, {4, 2}, {9, 11}, {15, 1}, {10, 0}, {5, 6}, {11, 14}}), move(6, {11, 3}),
                move(3, {4, 7}), move(1, {3, 4}), remove(5)}}) == "");
}

TEST_CASE("Positions given back to an object whose strategy changes meanwhile are still there", "[finds]") {
    // the hybrid passed them to `paper` first and read them afterwards.
    using Do = Calls<2>;
    holds_everywhere({{}, {{0, 0}, {9, 1}, {1, 8}, {7, 7}, {4, 3}}, {Do::stay(), Do::stay()}});
    using Do_3 = Calls<3>;
    holds_everywhere_in_space(
        {{}, {{0, 0, 0}, {9, 1, 0}, {1, 8, 1}, {0, 1, 9}, {7, 7, 8}, {4, 3, 2}}, {Do_3::stay(), Do_3::stay()}});
}

TEST_CASE("Cells that came while no tolerances were kept have records when tolerances are taken up again", "[finds]") {
    // They were written beyond the end of the records.
    holds_everywhere_in_space(
        {{},
         {{-0x1.7560c894b1fa6p-1, 0x1.ea924903790bap-1, 0x1.6dae031715b3ep-12},
          {-0x1.c6202ff9adb5p-4, -0x1.385f9db61dp-3, 0x1.f72a636e9343p-44},
          {0x1.4d6e0198227p-5, -0x1.c3786d475b10ep-1, -0x1.642d72e5111d8p-18},
          {0x1.06c7ad7ebe35ep-1, -0x1.0d8479e095a78p-2, -0x1.43665090b5a4p-17},
          {0x1.b17670e3aaea4p-2, 0x1.fa0e19aa76974p-2, 0x1.871c2127a823cp-31},
          {-0x1.ad21b265f8aecp-1, 0x1.261e499533abcp-1, -0x1.292931e29c81ap-12},
          {-0x1.7231eae345d6p-2, -0x1.a2b9bca62fa9cp-2, 0x1.025ce5b23e85ap-46},
          {-0x1.31bbb25d6d71p-3, -0x1.53d62c33c4cdep-1, -0x1.98b9a7693c9bcp-36},
          {0x1.9dc300c513f64p-2, -0x1.d4906fa52cc1p-4, 0x1.49f8ef22c6b44p-39},
          {-0x1.862577826abfp-2, 0x1.2d2bdfc9df44p-5, 0x1.dfc95066b6c5ep-31}},
         {Calls<3>::steady(Motion::breathing, 6, 0x1p-7, 51U),
          Calls<3>::move_some(4, {-0x1.ad21b265f8aecp-1, 0x1.261e499533abcp-1, -0x1.292931e29c81ap-12}),
          Calls<3>::steady(Motion::breathing, 5, 0x1p-7, 52U),
          Calls<3>::move_some(4, {-0x1.31bbb25d6d71p-3, -0x1.53d62c33c4cdep-1, -0x1.98b9a7693c9bcp-36}),
          Calls<3>::steady(Motion::breathing, 13, 0x1p-7, 81U), Calls<3>::steady(Motion::few, 4, 0x1p-7, 99U),
          Calls<3>::steady(Motion::breathing, 9, 0x1p-7, 5U),
          Calls<3>::move_some(7, {-0x1.7231eae345d6p-2, -0x1.a2b9bca62fa9cp-2, 0x1.025ce5b23e85ap-46}),
          Calls<3>::steady(Motion::breathing, 12, 0x1p-7, 61U), Calls<3>::stay(),
          Calls<3>::steady(Motion::breathing, 13, 0x1p-7, 36U)}});
}

TEST_CASE("Vertices whose squared distances underflow are held back all the same", "[finds]") {
    // No vertex seemed to have moved, so inverted cells were left to the last resort.
    const double u = 0x0.00000000001p-1022;
    holds_everywhere_in_space({{},
                               {{0, 0, 0}, {0, 0, 1}, {0, 0, 0.25 * u}, {0, 1, 0}, {u, -u, 0}},
                               {Calls<3>::move_most({{0, -u, 0},
                                                     {0x0.00001p-1022, 0, 0},
                                                     {0, 0, 0.25 * u},
                                                     {0, 0, 0.5 * u},
                                                     {0, 0, 0},
                                                     {0, 0, 0},
                                                     {0, 0, 0}})}});
    holds_everywhere({{},
                      {{0, 0},
                       {0, 1},
                       {0, 0x0.000000000002p-1022},
                       {0, 0x0.000000000007p-1022},
                       {0, -0x0.000000000007p-1022},
                       {0, 0x0.000000000006p-1022},
                       {0, 0x0.000000000004p-1022},
                       {1, 0},
                       {1, 1}},
                      {Calls<2>::move_all({{0x0.0000002p-1022, 0},
                                           {0x0.0000004p-1022, 0},
                                           {0, -0x0.0000002p-1022},
                                           {-0x0.00000038p-1022, 0},
                                           {0x0.00000018p-1022, 0},
                                           {0, 0x0.0000002p-1022},
                                           {0, 0x0.00000018p-1022},
                                           {0x0.00000014p-1022, -0x0.0000002p-1022},
                                           {0, 0}}),
                       Calls<2>::refused(Refusal::move_meets, 915)}});
}
