// SPDX-License-Identifier: GPL-3.0-or-later
// How verdicts on claims follow from numbers, and what pages say about them.
#include <apps/reproduction/claim_findings.h>
#include <apps/reproduction/claim_rules.h>

#include <support/catch.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace annulus;
using enum Claim_verdict;

Reproduction of(std::vector<Benchmark_record> benchmarks) {
    Reproduction r{"annulus reproduce", "here", {}, {}};
    for (Benchmark_record& benchmark : benchmarks) {
        std::string name = benchmark.name;
        r.benchmarks.emplace(std::move(name), std::move(benchmark));
    }
    return r;
}

Benchmark_record named(const std::string& name) {
    Benchmark_record r;
    r.name = name;
    r.steps = 1000;
    return r;
}

Claim starting(const Reproduction& r, const std::string& start) {
    for (const Claim& c : claims_of(r))
        if (c.statement.starts_with(start)) return c;
    FAIL("no claim starts with " << start);
    return {};
}

/// A run with so many slivers after 100 and after 1,000 iterations, and its hundredth of the angles below the middle of
/// the bin of 30 degrees, or of 35.
Benchmark_record optimised(const std::string& name, std::uint64_t early, std::uint64_t late, bool wider = true) {
    Benchmark_record r = named(name);
    for (const std::uint64_t step : {std::uint64_t{0}, std::uint64_t{100}, std::uint64_t{1000}}) {
        Quality_record q;
        q.step = step;
        q.slivers = step == 0 ? 500 : step == 100 ? early : late;
        q.vertices = 100;
        q.dihedral.assign(36, 0);
        q.dihedral[step == 1000 && wider ? 7 : 6] = step == 1000 && !wider ? 2000 : 1000;
        q.dihedral[12] = 1000;
        r.qualities.push_back(q);
    }
    return r;
}

}  // namespace

TEST_CASE("A claim agrees where the whole interval meets it, and is open where a part does") {
    CHECK(within({1, 2}, 1, 2) == agrees);
    CHECK(within({1, 2}, 0, 1.5) == open);
    CHECK(within({1, 2}, 1.5, 3) == open);
    CHECK(within({1, 2}, 1.2, 1.8) == open);
    CHECK(within({1, 2}, 2.5, 3) == differs);
    CHECK(within({1, 2}, 0, 0.5) == differs);
    CHECK(below({1, 2}, {3, 4}) == agrees);
    CHECK(below({1, 3}, {2, 4}) == open);
    CHECK(below({3, 4}, {1, 2}) == differs);
    CHECK(fewer(60, 42) == agrees);
    CHECK(fewer(17, 18) == open);
    CHECK(fewer(41, 36) == open);
    CHECK(fewer(20, 40) == differs);
    CHECK(both(agrees, agrees) == agrees);
    CHECK(both(agrees, differs) == open);
    CHECK(every({agrees, agrees}) == agrees);
    CHECK(every({agrees, open}) == open);
    CHECK(every({differs, open}) == differs);
    CHECK(every({}) == open);
    CHECK(above_one({1.03, 2}) == agrees);
    CHECK(above_one({1.02, 2}) == open);
    CHECK(above_one({0.98}) == open);
    CHECK(above_one({0.97, 1.02, 2}) == differs);
    const Measured x = scattered({1, 2, 3});
    CHECK(x.low == Approx(1));
    CHECK(x.high == Approx(3));
    CHECK(measured({2, 1, 3}).low == 1);
    CHECK(measured({2, 1, 3}).high == 3);
    CHECK(scattered({2}).low == scattered({2}).high);
}

TEST_CASE("What is twice a bound goes further; any other number differs where far more is found") {
    const auto run = [](const std::string& name, std::initializer_list<std::pair<const char*, double>> strategies) {
        Benchmark_record r = named(name);
        for (const auto& [strategy, seconds] : strategies) {
            Contender_record x;
            x.name = strategy;
            x.step = {1000};
            x.seconds = {seconds};
            for (auto* list : {&x.asked, &x.failed, &x.requeued, &x.changed, &x.evaluated}) list->resize(1);
            r.contenders.push_back(x);
        }
        return of({r});
    };
    const auto flips = [&](double quicker) {
        return starting(run("lloyd-x2", {{"relocate", quicker}, {"relocate-flips", 1}}), "Flips in place of removal")
            .verdict;
    };
    CHECK(flips(2) == agrees);
    CHECK(flips(6.2) == differs);
    const auto hybrid = [&](double gain) {
        return starting(run("nodt-liver", {{"paper-printed", 1}, {"paper-printed-hybrid", 1 - gain}}),
                        "Rebuilding first, and filtering")
            .verdict;
    };
    CHECK(hybrid(0.1) == agrees);
    CHECK(hybrid(0.01) == differs);
    CHECK(hybrid(0.4) == differs);
    const auto relocation = [&](double quicker) {
        return starting(run("lloyd-x2", {{"relocate", quicker}, {"paper-printed", 1}}), "It is faster than relocation")
            .verdict;
    };
    CHECK(relocation(3.5) == differs);
    CHECK(relocation(3.7) == agrees);
    CHECK(relocation(7.9) == agrees);
    CHECK(relocation(8.1) == further);
    const auto slower = [&](double than_rebuilding) {
        return starting(run("lloyd-x2", {{"rebuild", 1}, {"relocate-cgal", than_rebuilding}}),
                        "When all points move, reloc")
            .verdict;
    };
    CHECK(slower(1.05) == agrees);
    CHECK(slower(1.01) == open);
    CHECK(slower(0.9) == differs);
    CHECK(std::string(claim_rules()).find("any other number differs where more is found") != std::string::npos);
}

TEST_CASE("The picture of four bodies is open where a body was not run") {
    const std::string start = "Optimised meshes of the four bodies";
    const auto body = [](const char* name, std::uint64_t late = 10) { return optimised(name, 60, late); };
    const Claim alone = starting(of({body("nodt-sphere")}), start);
    CHECK(alone.verdict == open);
    CHECK(alone.reason.find("Not run: man, bunny, liver, which need --surfaces.") != std::string::npos);
    const auto all = [&](std::uint64_t last) {
        return of({body("nodt-sphere"), body("nodt-man"), body("nodt-bunny"), body("nodt-liver", last)});
    };
    CHECK(starting(all(10), start).verdict == agrees);
    CHECK(starting(all(510), start).verdict == open);  // 500 at the start: within the scatter
    CHECK(starting(all(900), start).verdict == differs);
    CHECK(starting(of({body("nodt-sphere", 900)}), start).verdict == differs);
}

TEST_CASE("Half of the tolerances wrong by rounding is not seldom, though no audit fails") {
    Benchmark_record run = named("lloyd-x2");
    Stability_record s;
    s.bicells = 1000;
    s.above = 500;
    s.most = {1e-9};
    run.stabilities = {s};
    Contender_record paper;
    paper.name = "paper-printed";
    paper.audits = 40;
    run.contenders = {paper};
    const std::string rounding = "Tolerances in plain double are wrong", runs = "Runs with such tolerances stay right";
    CHECK(starting(of({run}), rounding).verdict == differs);
    CHECK(starting(of({run}), runs).verdict == agrees);
    run.stabilities[0].above = 20;
    run.contenders[0].audits_failed = 1;
    CHECK(starting(of({run}), rounding).verdict == agrees);
    CHECK(starting(of({run}), runs).verdict == differs);
}

TEST_CASE("Fewer slivers in the mean are open where 15 % and none are both within the scatter") {
    const std::string start = "With variable sizing";
    const auto spheres = [](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
        return of({optimised("graded-sphere", 100, a), optimised("graded-sphere-2", 100, b),
                   optimised("graded-sphere-3", 100, c)});
    };
    CHECK(starting(spheres(104, 92, 80), start).verdict == open);
    CHECK(starting(spheres(84, 85, 86), start).verdict == agrees);
    CHECK(starting(spheres(101, 100, 99), start).verdict == differs);
    CHECK(starting(spheres(50, 51, 49), start).verdict == differs);
}

TEST_CASE("A mesh that becomes better within the scatter of counts leaves the claim open") {
    const std::string start = "Going from 100 to 1,000";
    CHECK(starting(of({optimised("nodt-sphere", 60, 30)}), start).verdict == agrees);
    CHECK(starting(of({optimised("nodt-sphere", 17, 18)}), start).verdict == open);
    CHECK(starting(of({optimised("nodt-sphere", 17, 40)}), start).verdict == differs);
    CHECK(starting(of({optimised("nodt-sphere", 60, 30), optimised("nodt-man", 60, 30, false)}), start).verdict ==
          differs);
}

TEST_CASE("Locked vertices are a matter of the angle, and the claim is open where angles disagree") {
    const std::string start = "Vertices among good cells are locked";
    const auto run = [](const std::string& name, std::uint64_t locked) {
        Benchmark_record r = optimised(name, 10, 10);
        for (Quality_record& q : r.qualities) q.locked = locked;
        return r;
    };
    CHECK(starting(of({run("locked-sphere", 98)}), start).verdict == agrees);
    CHECK(starting(of({run("locked-sphere", 98), run("locked-sphere-25", 82)}), start).verdict == open);
    CHECK(starting(of({run("locked-sphere", 80), run("locked-sphere-25", 70)}), start).verdict == differs);
}

TEST_CASE("Points are spread evenly where the distances to their nearest ones hardly differ") {
    Picture_record before, after;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            before.x.push_back(i + 0.04 * ((7 * i + 3 * j) % 10));
            before.y.push_back(j + 0.04 * ((3 * i + 9 * j) % 10));
            after.x.push_back(i);
            after.y.push_back(j);
        }
    Benchmark_record one = named("points-one");
    one.pictures = {before, after};
    CHECK(starting(of({one, named("points-x2")}), "Lloyd iterations spread").verdict == agrees);
    one.pictures = {after, before};
    CHECK(starting(of({one, named("points-x2")}), "Lloyd iterations spread").verdict == differs);
    one.pictures.clear();
    CHECK(starting(of({one, named("points-x2")}), "Lloyd iterations spread").verdict == open);
}

TEST_CASE("A page begins with its claim, what was measured and the verdict") {
    Claim first, second;
    first.figure = second.figure = "figure-7";
    first.statement = "Flips pay.";
    first.paper = "2";
    first.theirs = "0.96 to 1";
    first.verdict = differs;
    second.statement = "Filtering Lloyd iterations is up to so many times faster than rebuilding.";
    second.paper = "up to 6";
    second.theirs = "3.1 to 6 after 1,000 iterations; " + std::string(300, 'x');
    second.verdict = agrees;
    CHECK(findings_of_page("figure-7", {first, second}) ==
          std::vector<std::string>{"The paper: Filtering Lloyd iterations is up to so many times faster than "
                                   "rebuilding (up to 6). Here: 3.1 to 6 after 1,000 iterations. The claim agrees with "
                                   "that.",
                                   "Of 2 claims of the paper on this page 1 agreed with what was measured here, 1 "
                                   "differed from it."});
    second.theirs.clear();
    second.verdict = open;
    CHECK(findings_of_page("figure-7", {first, second}).front() ==
          "The paper: Flips pay (2). Here: 0.96 to 1. The claim differs from that.");
    first.theirs.clear();
    CHECK(findings_of_page("figure-7", {first, second}).empty());
    CHECK(findings_of_page("figure-8", {first, second}).empty());
}
