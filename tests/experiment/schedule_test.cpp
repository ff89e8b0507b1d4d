// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/schedule.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <map>
#include <numeric>
#include <random>
#include <vector>

using namespace annulus;

TEST_CASE("A schedule hands out every trial once, and no machine has more than its memory unless one runs alone") {
    for (int seed = 1; seed <= repeats(300); ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(static_cast<unsigned>(seed));
        std::vector<Trial> trials(random() % 40);
        for (Trial& t : trials) {
            t.seconds = static_cast<double>(random() % 100) / 50;
            t.bytes = random() % 100;
        }
        std::vector<std::size_t> open(trials.size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        const int machines = 1 + static_cast<int>(random() % 3), threads = 1 + static_cast<int>(random() % 4);
        Schedule schedule(trials, open, threads, 120);
        std::vector<int> times(trials.size(), 0);
        std::vector<std::pair<std::size_t, int>> running;
        std::map<int, std::vector<std::size_t>> on;
        std::size_t stuck = 0;
        while (!schedule.empty() || !running.empty()) {
            REQUIRE(++stuck < 10'000);
            const int machine = static_cast<int>(random() % static_cast<unsigned>(machines));
            if (!running.empty() && random() % 2 == 0) {
                const auto at = static_cast<std::ptrdiff_t>(random() % running.size());
                const auto [trial, where] = running[static_cast<std::size_t>(at)];
                schedule.finish(trial, where);
                std::erase(on[where], trial);
                running.erase(running.begin() + at);
                continue;
            }
            std::vector<Schedule::Job> jobs;
            if (random() % 2 == 0) jobs = schedule.take(machine, 0.5, machines * threads);
            else if (const auto job = schedule.take(machine)) jobs.push_back(*job);
            for (const auto& job : jobs) {
                ++times[job.trial];
                running.emplace_back(job.trial, machine);
                on[machine].push_back(job.trial);
                CHECK((job.threads == 1 || job.threads == threads));
            }
            std::uint64_t bytes = 0;
            for (const std::size_t trial : on[machine]) bytes += trials[trial].bytes;
            REQUIRE((bytes <= 120 || on[machine].size() == 1));
            REQUIRE(schedule.running() == running.size());
            // An idle machine accepts any trial.
            if (jobs.empty() && on[machine].empty()) REQUIRE(schedule.empty());
        }
        REQUIRE(times == std::vector<int>(trials.size(), 1));
    }
}

TEST_CASE("A schedule begins with the most expensive, and lets threads help one that would run alone") {
    std::vector<Trial> trials(3);
    trials[0].seconds = 1;
    trials[1].seconds = 10;
    trials[2].seconds = 2;
    Schedule schedule(trials, {0, 1, 2}, 2, 100);
    const auto first = schedule.take(0), second = schedule.take(0), third = schedule.take(0);
    REQUIRE((first && second && third));
    CHECK(first->trial == 1);
    CHECK(first->threads == 2);
    CHECK(second->trial == 2);
    CHECK(third->trial == 0);
    CHECK_FALSE(schedule.take(0));
}
