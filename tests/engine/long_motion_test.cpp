// SPDX-License-Identifier: GPL-3.0-or-later
// Long motions. A mechanism with a counter was once right for six thousand steps and wrong from then on: short tests do
// not find such faults. tests/soak runs all motions, for any number of steps.
#include <support/catch.h>
#include <support/motions.h>
#include <support/repeats.h>
#include <support/viewed_mesh.h>

#include <bit>
#include <memory>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Moving_d = testing::Viewed_mesh<d>;

/// Uniform in a box of side 100.
template <int d>
std::vector<Coordinates<d>> uniform(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    std::vector<Coordinates<d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0, 100);
    return x;
}

/// x += rate * y, audited every hundred steps. Empty, or the first fault.
template <int d>
std::string shear(Strategy strategy, std::size_t n, std::uint64_t seed, double rate, int steps) {
    auto x = uniform<d>(n, seed);
    Moving_d<d> dt(x, Options{.strategy = strategy});
    for (int step = 1; step <= steps; ++step) {
        for (auto& p : x) p[0] += rate * p[1];
        (void)dt.move_all(x);
        if (step % 100 != 0) continue;
        const Audit_result audit = dt.audit();
        if (!audit.delaunay()) return "step " + std::to_string(step) + ": " + audit.first_fault;
    }
    return {};
}

/// The results of a run in 3D, with differently fragmented memory for every `mess`.
std::vector<std::uint64_t> diary(Strategy strategy, std::uint64_t mess) {
    Random sizes(mess);
    std::vector<std::unique_ptr<char[]>> holes;
    for (int i = 0; i < 300; ++i) holes.push_back(std::make_unique<char[]>(64 + sizes() % 4000));
    for (std::size_t i = 0; i < holes.size(); ++i)
        if (sizes() % 2 == 0) holes[i].reset();

    Random random(8);
    Long_motion<3> motion(Motion_kind::walk_middle, 60, random);
    Moving_d<3> dt(motion.positions(), Options{.strategy = strategy});
    std::vector<std::uint64_t> said;
    for (int step = 0; step < 40; ++step) {
        const Move_result report = dt.move_all(motion.advance());
        for (const std::uint64_t x :
             {report.statistics.evaluated, report.statistics.flips, report.moves.within_tolerance,
              report.moves.kept_in_place, report.moves.flipped, report.moves.reinserted})
            said.push_back(x);
    }
    for (Index i = 0; i < static_cast<Index>(dt.index_bound()); ++i)
        said.push_back(std::bit_cast<std::uint64_t>(dt.tolerance(i)));
    return said;
}

}  // namespace

TEST_CASE("A shear of eight thousand steps stays right", "[deep][long]") {
    for (const Strategy strategy :
         {Strategy::tolerances, Strategy::paper, Strategy::automatic, Strategy::tolerances_each}) {
        CAPTURE(name_of(strategy));
        CHECK(shear<2>(strategy, 400, 1, 6e-5, repeats(8000)) == "");
        CHECK(shear<3>(strategy, 60, 2, 8e-5, repeats(8000)) == "");
    }
}

TEST_CASE("What a run does and says does not depend on where its memory is", "[long][space]") {
    for (const Strategy strategy : {Strategy::rebuild, Strategy::tolerances, Strategy::tolerances_each}) {
        CAPTURE(name_of(strategy));
        const auto first = diary(strategy, 1);
        for (std::uint64_t mess = 2; mess < 8; ++mess) CHECK((diary(strategy, mess) == first));
    }
}
