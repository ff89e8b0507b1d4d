// SPDX-License-Identifier: GPL-3.0-or-later
// Claims, pages and parts of the reproduction, from artificial records.
#include <annulus/error.h>
#include <apps/reproduction/benchmark_statistics.h>
#include <apps/reproduction/checkpoints.h>
#include <apps/reproduction/claims.h>
#include <apps/reproduction/figures.h>
#include <apps/reproduction/plan.h>

#include <support/catch.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace {

using namespace annulus;

Benchmark_record made_up() {
    Benchmark_record r;
    r.name = "lloyd-x2";
    r.title = "Lloyd";
    r.vertices = 10;
    r.steps = 4;
    r.spacing = 0.1;
    r.displacement = {0.4, 0.3, 0.2, 1.0 / 3};
    Contender_record rebuild, paper;
    rebuild.name = "rebuild";
    paper.name = "paper";
    rebuild.step = {2, 4};
    rebuild.seconds = {1, 1};
    paper.step = {1, 2, 3, 4};
    paper.seconds = {3, 2, 0.5, 0.5};
    paper.asked = {10, 10, 10, 10};
    paper.failed = {10, 8, 2, 1};
    paper.requeued = {0, 0, 5, 0};
    paper.precompute_seconds = 0.25;
    r.contenders = {rebuild, paper};
    for (Contender_record& x : r.contenders)
        for (auto list : {&Contender_record::asked, &Contender_record::failed, &Contender_record::requeued,
                          &Contender_record::changed, &Contender_record::evaluated})
            (x.*list).resize(x.step.size());
    return r;
}

struct Scratch {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("annulus-parts-" + std::to_string(getpid()));
    Scratch() { std::filesystem::remove_all(path); }
    ~Scratch() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("Every figure of the paper has a page and a claim, whatever was run") {
    const Reproduction nothing{"annulus reproduce", "here", {}, {}};
    const auto claims = claims_of(nothing);
    std::set<std::string> pages, claimed;
    for (const Page_content& page : reproduction_pages(nothing)) pages.insert(page.name);
    for (const Claim& c : claims) {
        claimed.insert(c.figure);
        CHECK(c.verdict == Claim_verdict::open);
        CHECK_FALSE(c.paper.empty());
        CHECK_FALSE(c.reason.empty());
        CHECK(pages.contains(c.figure));
    }
    for (int k = 5; k <= 12; ++k) {
        CHECK(pages.contains("figure-" + std::to_string(k)));
        CHECK(claimed.contains("figure-" + std::to_string(k)));
    }
    CHECK(reproduction_files(nothing).front().name == "reproduction.json");
}

TEST_CASE("A step that was not followed counts as the next one that was") {
    const Benchmark_record r = made_up();
    const auto rebuild = cumulated(r.contenders[0]);
    CHECK(rebuild.back() == std::pair<std::uint64_t, double>(4, 4.0));
    CHECK(total_seconds(r, "paper") == 6.25);
    CHECK(speed_up(r, "rebuild", "paper") == 4.0 / 6.25);
    CHECK(speed_up(r, "rebuild", "absent") == 0);
    // From 2 s at 20 % within to 0.5 s at 80 %: 1 s at 60 %.
    REQUIRE(switch_point(r, "paper"));
    CHECK(*switch_point(r, "paper") == Approx(0.6));
    CHECK(acceleration(r, "paper") == 6);
    CHECK(longest_step(r, "paper") == 3);
    CHECK(longest_step(r, "paper", 0.25) == 2);
    CHECK(slower_steps(r, "paper") == 0.5);
    CHECK(failed_share(r, "paper") == Approx(21.0 / 40));
    CHECK(first_step_below(r, "paper", 0.2) == 3U);
    CHECK_FALSE(first_step_below(r, "paper", 0.01));
    CHECK(failures_at(r, "paper", 4) == Approx(0.1));
    CHECK(most_renewals(r, "paper") == 1);  // the first step: ten of ten
}

TEST_CASE("The angle that a hundredth of the angles are below is read off its bin") {
    Quality_record q;
    q.dihedral.assign(36, 0);
    CHECK(small_angle(q) == 0);
    q.dihedral[2] = 5;
    q.dihedral[10] = 995;
    CHECK(small_angle(q) == Approx(50 + 5.0 * 5 / 995));
    q.dihedral[2] = 20;
    q.dihedral[10] = 980;
    CHECK(small_angle(q) == Approx(12.5));
}

TEST_CASE("Verdicts follow the numbers") {
    const auto verdict = [](const Reproduction& r, const std::string& start) {
        for (const Claim& c : claims_of(r))
            if (c.statement.starts_with(start)) return c.verdict;
        FAIL("no claim starts with " << start);
        return Claim_verdict::open;
    };
    const auto with = [](Benchmark_record benchmark) {
        Reproduction r{"annulus reproduce", "here", {}, {}};
        r.benchmarks.emplace(benchmark.name, std::move(benchmark));
        return r;
    };
    Benchmark_record benchmark = made_up();
    benchmark.steps = 1000;  // the four that were followed count for all
    benchmark.contenders[1].name = "paper-printed";
    CHECK(verdict(with(benchmark), "It outperforms rebuilding for every") == Claim_verdict::differs);
    for (double& s : benchmark.contenders[1].seconds) s /= 10;
    CHECK(verdict(with(benchmark), "It outperforms rebuilding for every") == Claim_verdict::agrees);
    Reproduction whole = with(benchmark);
    Benchmark_record movers = made_up();
    movers.name = "movers-plane-1";  // twenty steps, whatever the length of the others
    whole.benchmarks.emplace(movers.name, movers);
    CHECK(verdict(whole, "It outperforms rebuilding for every") == Claim_verdict::agrees);
    movers.name = "nodt-sphere";
    whole.benchmarks.emplace(movers.name, movers);
    CHECK(verdict(whole, "It outperforms rebuilding for every") == Claim_verdict::open);
    CHECK(verdict(with(benchmark), "If all points move") == Claim_verdict::agrees);
    benchmark.contenders[1].requeued = {15, 0, 0, 0};
    CHECK(verdict(with(benchmark), "If all points move") == Claim_verdict::differs);

    Degeneracy_count_record first, last;
    first.below = last.below = {1};
    first.theta_hundredth = 0.1;
    last.theta_hundredth = 0.2;
    benchmark.degeneracies = {first, last};
    CHECK(verdict(with(benchmark), "Tolerances become numerically more stable") == Claim_verdict::agrees);
    benchmark.degeneracies = {last, first};
    CHECK(verdict(with(benchmark), "Tolerances become numerically more stable") == Claim_verdict::differs);

    Stability_record e;
    e.bicells = 100;
    e.edges = {0, 0.01, 0.1, 1};
    e.counts = {0, 50, 50};
    e.most = {0, 1e-14, 1e-14};
    e.median = {0, 1e-15, 1e-16};
    benchmark.stabilities = {e};
    CHECK(verdict(with(benchmark), "Numerical stability is proportional to theta") == Claim_verdict::agrees);
    benchmark.stabilities[0].median = {0, 1e-16, 1e-16};
    CHECK(verdict(with(benchmark), "Numerical stability is proportional to theta") == Claim_verdict::differs);
}

TEST_CASE("Checkpoints are found again bit for bit, by the same reproduction only") {
    const Scratch scratch;
    const Benchmark_record r = made_up();
    {
        const Checkpoints parts(scratch.path, "annulus 1 whole");
        CHECK_FALSE(parts.find(r.name));
        parts.keep(r);
    }
    CHECK_THROWS_AS(Checkpoints(scratch.path, "annulus 1 quick"), Error);
    const Checkpoints again(scratch.path, "annulus 1 whole");
    const auto found = again.find(r.name);
    REQUIRE(found);
    CHECK(found->displacement == r.displacement);
    CHECK(benchmark_text(*found) == benchmark_text(r));
    CHECK_THROWS_AS(Checkpoints(scratch.path, "annulus 1 whole"), Error);  // one at a time
    std::ofstream(scratch.path / "lloyd-x2.json") << benchmark_text(r).substr(0, 50);
    CHECK_FALSE(again.find(r.name));  // it is made again
    again.remove();
    CHECK_FALSE(std::filesystem::exists(scratch.path));
    std::filesystem::create_directory(scratch.path);
    std::ofstream(scratch.path / "mine.txt") << "mine";
    CHECK_THROWS_AS(Checkpoints(scratch.path, "annulus 1 whole"), Error);
    CHECK(std::filesystem::exists(scratch.path / "mine.txt"));
}

TEST_CASE("What is requested is run, and nothing else") {
    const auto names = [](Reproduction_size size) {
        std::set<std::string> out;
        for (const Part_plan& p : reproduction_parts(size)) CHECK(out.insert(p.benchmark.name).second);
        return out;
    };
    Reproduction_size size;
    CHECK(names(size).contains("nodt-sphere"));
    CHECK_FALSE(names(size).contains("nodt-man"));
    size.surfaces = true;
    CHECK(names(size).size() == 28);
    size.only = {"fig6"};
    CHECK(names(size) == std::set<std::string>{"lloyd-x2"});
    size.only = {"fig11"};
    CHECK(names(size) == std::set<std::string>{"lloyd-x2", "nodt-sphere", "nodt-bunny"});
    size.only = {"fig5", "locked"};
    CHECK(names(size) == std::set<std::string>{"points-one", "points-x2", "locked-sphere", "locked-sphere-5",
                                               "locked-sphere-10", "locked-sphere-20", "locked-sphere-25",
                                               "locked-bunny"});
    size.only = {"movers"};
    CHECK(names(size).size() == 6);
}
