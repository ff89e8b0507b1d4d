// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate does not depend on the order in which a mesh names its points: six orders make the same bi-cell in 3D.
#include <support/cases.h>
#include <support/catch.h>

#include <annulus/predicate/filtered.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Five = std::array<Coordinates<3>, 5>;

/// The orders of a, b, c, p, q with positive cells.
constexpr std::array<std::array<std::size_t, 5>, 6> orders{
    {{0, 1, 2, 3, 4}, {1, 2, 0, 3, 4}, {2, 0, 1, 3, 4}, {1, 0, 2, 4, 3}, {0, 2, 1, 4, 3}, {2, 1, 0, 4, 3}}};

Tuple<3, 5> in_order(const Five& x, const std::array<std::size_t, 5>& order) {
    Tuple<3, 5> t{};
    for (std::size_t i = 0; i < 5; ++i) t[i] = &x[order[i]];
    return t;
}

bool is_bicell(const Tuple<3, 5>& x) {
    return orientation_exact({x[0], x[1], x[2], x[4]}).sign > 0 && orientation_exact({x[1], x[0], x[2], x[3]}).sign > 0;
}

/// Whether the tolerances of the six orders are equal up to rounding, whichever stages they come from.
bool agree(const Five& x, Cell_widths cells) {
    double least = HUGE_VAL;
    double greatest = 0.0;
    int positive = 0;
    for (const auto& order : orders) {
        const Certificate_value v = evaluate_empty_sphere(in_order(x, order), true, cells);
        positive += v.sign > 0 ? 1 : 0;
        least = std::min(least, v.tolerance);
        greatest = std::max({greatest, v.tolerance, empty_sphere_exact(in_order(x, order), cells).tolerance});
    }
    CHECK((positive == 0 || positive == 6));
    return greatest - least <= 0x1p-9 * greatest + 0x1p-1070;
}

}  // namespace

TEST_CASE("The order of its points changes a bi-cell's tolerance by rounding alone", "[certificate][space][deep]") {
    // One of the sums of lambda is 0 but for the last bits, and a cell is nearly flat. The first two stages cannot
    // decide here in four of the six orders whether its width is in the minimum, and the first one cannot in all cases
    // below.
    const Five doubtful{{{0x1.fffffffffffffp+1, 0x1.8000000000001p+1, 0x1.fffffffffffffp-1},
                         {0x1.fffffffffffffp+0, 0x1.0000000000001p+1, 0x1p+0},
                         {0x1.fffffffffffffp+1, 0x1.0000000000001p+0, 0x1p+0},
                         {0x1.0000000000001p+1, 0x1.0000000000001p+0, 0x1p+0},
                         {0x0p+0, 0x1.8000000000001p+1, 0x1p+1}}};
    const Five doubtful_to_filter{{{0x1p+1, 0x1.fffffffcp+0, -0x1p-30},
                                   {0x1.fffffffp-1, 0x1.fffffffbfffffp+0, 0x1.00000004p+0},
                                   {0x1.fffffffp-1, -0x1.fffffffffffffp-30, 0x1.00000003fffffp+0},
                                   {0x0p+0, 0x1p-29, 0x1p+0},
                                   {0x1p-30, -0x1p-29, 0x1.00000002p+1}}};
    for (const Five& x : {doubtful, doubtful_to_filter}) {
        REQUIRE(is_bicell(in_order(x, orders[0])));
        CHECK(empty_sphere_exact(in_order(x, orders[0])).wrong_side == 0);
        CHECK(agree(x, Cell_widths::where_needed));
    }

    int bicells = 0;
    for_each_seed(40, [&](Random& random) {
        for (int k = 0; k < 400; ++k) {
            Five x{};
            for (auto& p : x)
                for (double& c : p) {
                    c = static_cast<double>(random() % 3);
                    if (k % 2 == 0) c += std::ldexp(static_cast<double>(random() % 5) - 2, -10 - k % 30);
                    if (random() % 2 == 0) c = std::nextafter(c, random() % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
                }
            if (!is_bicell(in_order(x, orders[0]))) continue;
            ++bicells;
            for (const Cell_widths cells : {Cell_widths::never, Cell_widths::where_needed, Cell_widths::always})
                CHECK(agree(x, cells));
        }
    });
    CHECK(bicells > 100);
}
