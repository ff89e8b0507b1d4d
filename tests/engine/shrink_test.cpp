// SPDX-License-Identifier: GPL-3.0-or-later
// The shrinker on artificial faults, and the decoder of the fuzz targets: its programs are mostly legal, and seeds are
// what their names say.
#include <common/decode.h>
#include <common/shrink.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <utility>

using namespace annulus;
using namespace annulus::oracle;
using annulus::testing::between;
using annulus::testing::Random;

namespace {

template <int d>
Coordinates<d> some_place(Random& random) {
    Coordinates<d> p;
    for (double& c : p) c = between(random, -9.0, 9.0);
    return p;
}

/// Thirty operations of all kinds on twenty points.
template <int d>
Program_of<d> long_program(Random& random) {
    Program_of<d> program{Strategy::paper_hybrid, {}, {}};
    for (int i = 0; i < 20; ++i) program.points.push_back(some_place<d>(random));
    for (int i = 0; i < 30; ++i) {
        const auto v = static_cast<Index>(random() % 20);
        switch (random() % 6) {
            case 0: program.operations.push_back(Calls<d>::move(v, some_place<d>(random))); break;
            case 1: program.operations.push_back(Calls<d>::move_all(program.points)); break;
            case 2: program.operations.push_back(Calls<d>::insert(some_place<d>(random))); break;
            case 3: program.operations.push_back(Calls<d>::remove_some(v)); break;
            case 4: program.operations.push_back(Calls<d>::refused(Refusal::insert_meets, v)); break;
            default: program.operations.push_back(Calls<d>::steady(Motion::shear, 97, 0.013, random() % 1000)); break;
        }
    }
    return program;
}

/// Limited by the number of runs alone: what is reached in ten seconds depends on the machine and its load.
template <class Some_program, class Fails>
Some_program shrunk_by_runs(const Some_program& program, Fails fails, int runs = 3000) {
    return shrunk(program, std::move(fails), runs, std::chrono::hours(10'000));
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A program that fails is shrunk to what makes it fail, dimension", "[shrink]", ((int d), d), 2,
                       3) {
    using Small_program = Program_of<d>;
    using Small_operation = Operation_of<d>;
    const auto for_each_program = [](auto check) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            Small_program program = long_program<d>(random);
            program.operations.push_back(Calls<d>::steady(Motion::shear, 97, 0.013, 999));
            program.operations.push_back(Calls<d>::insert(some_place<d>(random)));
            check(program);
        }
    };
    SECTION("a long shear, after it an insertion, three points") {
        const auto fails = [&](const Small_program& p) {
            bool sheared = false;
            for (const Small_operation& o : p.operations) {
                sheared |= o.kind == Operation_kind::steady && o.times >= 50;
                if (sheared && o.kind == Operation_kind::insert && o.points[0][0] > -20.0) return p.points.size() >= 3;
            }
            return false;
        };
        for_each_program([&](const Small_program& program) {
            REQUIRE(fails(program));
            const Small_program small = shrunk_by_runs(program, fails);
            INFO(as_code(small));
            CHECK(fails(small));
            REQUIRE(small.operations.size() == 2);
            CHECK(small.operations[0].times == 50);
            CHECK(small.operations[1].points[0] == Coordinates<d>{});
            CHECK(small.points == std::vector<Coordinates<d>>(3));
            CHECK(small.setting == program.setting);
        });
    }
    SECTION("a coordinate above 3 that is not a multiple of 1/4") {
        const auto fails = [](const Small_program& p) {
            return std::any_of(p.points.begin(), p.points.end(),
                               [](const auto& x) { return x[1] > 3.0 && 4.0 * x[1] != std::nearbyint(4.0 * x[1]); });
        };
        for_each_program([&](const Small_program& program) {
            REQUIRE(fails(program));
            const Small_program small = shrunk_by_runs(program, fails);
            INFO(as_code(small));
            CHECK(fails(small));
            CHECK(small.operations.empty());
            REQUIRE(small.points.size() == 1);
            CHECK(small.points[0][0] == 0.0);
            CHECK(complexity(small.points[0][1]) < 50);  // such a number has some 150
        });
    }
    SECTION("a vertex with a place in the list keeps it when others go") {
        for_each_program([&](Small_program program) {
            program.operations.push_back(Calls<d>::move(17, program.points[4]));
            const auto mark = program.points[17];
            const auto fails = [&](const Small_program& p) {
                return std::any_of(p.operations.begin(), p.operations.end(), [&](const Small_operation& o) {
                    return o.kind == Operation_kind::move && o.vertex >= 0 &&
                           static_cast<std::size_t>(o.vertex) < p.points.size() &&
                           p.points[static_cast<std::size_t>(o.vertex)] == mark;
                });
            };
            REQUIRE(fails(program));
            const Small_program small = shrunk_by_runs(program, fails);
            INFO(as_code(small));
            CHECK(fails(small));
            CHECK(small.operations.size() == 1);
            CHECK(small.points.size() == 1);
        });
    }
}

TEST_CASE("Shrinking ends when nothing may go, and after as many runs as it is given", "[shrink]") {
    Random random(1);
    const Program program = long_program<2>(random);
    int runs = 0;
    (void)shrunk_by_runs(program, [&](const Program&) { return ++runs < 0; });
    CHECK(runs > 0);
    CHECK(runs <= 3000);
    runs = 0;
    (void)shrunk_by_runs(
        program, [&](const Program&) { return ++runs < 0; }, 17);
    CHECK(runs == 17);
    runs = 0;
    const Program nothing = shrunk_by_runs(program, [&](const Program&) { return ++runs > 0; });
    CHECK(nothing.points.empty());
    CHECK(nothing.operations.empty());
}

TEMPLATE_TEST_CASE_SIG("Any bytes are a program, legal for the most part, and every setting has its bytes, dimension",
                       "[fuzz]", ((int d), d), 2, 3) {
    Random random(run_seed());
    Coverage coverage;
    std::set<std::string> settings;
    const auto runs = std::max(16U, static_cast<unsigned>(repeats(d == 2 ? 192 : 64)));
    for (unsigned run = 0; run < runs; ++run) {
        std::vector<std::uint8_t> bytes(1 + random() % 200);
        for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
        bytes[0] = static_cast<std::uint8_t>((bytes[0] & 0xf0U) | run % 16);  // every setting
        const Program_of<d> program = Decoder(bytes).program<d>();
        settings.insert(name_of(program.setting));
        const std::string fault = run_and_shrink(program, 1, &coverage);
        INFO(fault);
        REQUIRE(fault.empty());
    }
    for (const Setting& s : certified_settings) CHECK(settings.count(name_of(s)) == 1);
    for (const Setting& s : uncertified_settings) CHECK(settings.count(name_of(s)) == 1);
    std::cout << "dimension " << d << ", random bytes: " << coverage.operations << " operations, "
              << std::lround(100.0 * coverage.legal_share()) << " % legal\n";
    CHECK(coverage.legal_share() >= 0.8);
}

TEMPLATE_TEST_CASE_SIG("Seeds of the fuzz targets are what they are called, and pass, dimension", "[fuzz]",
                       ((int d), d), 2, 3) {
    std::size_t count = 0;
    Coverage coverage;
    for (const auto& entry : std::filesystem::directory_iterator(ANNULUS_FUZZ_CORPUS "/moves_" + std::to_string(d))) {
        const std::string name = entry.path().filename().string();
        CAPTURE(name);
        const auto bytes = bytes_of(entry.path());
        REQUIRE(bytes.size() > 2);
        const Program_of<d> program = Decoder(bytes).program<d>();
        // SETTING.NUMBERS.WHAT
        const std::string start =
            name_of(program.setting) + "." + std::string(name_of(Decoder::numbers(bytes[0] >> 4))) + ".";
        CHECK(name.substr(0, start.size()) == start);
        const std::string what = name.substr(start.size());
        CHECK(!program.operations.empty());
        if (what == "written" || what == "refused") {
            const Operation_kind kind = what == "written" ? Operation_kind::move_all : Operation_kind::refused;
            CHECK(std::any_of(program.operations.begin(), program.operations.end(),
                              [kind](const auto& o) { return o.kind == kind; }));
        } else {
            CHECK(std::any_of(program.operations.begin(), program.operations.end(), [&](const auto& o) {
                return o.kind == Operation_kind::steady && name_of(o.motion) == what;
            }));
        }
        const std::string fault = run_and_shrink(program, 1, &coverage);
        INFO(fault);
        CHECK(fault.empty());
        ++count;
    }
    CHECK(count >= 20);
    CHECK(coverage.legal_share() >= 0.8);
}
