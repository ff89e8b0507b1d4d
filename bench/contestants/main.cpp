// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_mesh<3>, CGAL and other libraries on the same points in turn: nanoseconds a point, ratios of the same points,
// peak memory, numbers of cells.
#include "../motions/families.h"
#include "../motions/result_line.h"
#include "contestant.h"
#include "peak_memory.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using bench::Points;
using nlohmann::ordered_json;

struct Choice {
    std::size_t points = 10000;
    int repeat = 9;
    std::uint64_t seed = 1;
    std::vector<std::string> families;
    std::vector<std::string> orders{"random", "local"};
    std::vector<std::string> names;
    bool memory = true;
    std::string json;
};

/// Of all threads of this process, in case a library starts some.
double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Points of a family: along a space-filling curve, or shuffled.
Points<3> points(const std::string& family, const std::string& order, std::size_t n, std::uint64_t seed) {
    Points<3> x = bench::Scene<3>(family, "walk", n, 0.0, seed).points();
    if (order == "local") return x;
    bench::Random random(seed + 1000);
    for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[random.bits() % i]);
    return x;
}

struct Runner {
    std::string name;
    bench::Make_contestant make;
    std::unique_ptr<bench::Contestant> contestant;
    double bytes = 0.0;
    std::vector<double> seconds;
    std::size_t cells = 0;
    std::string failure;
};

/// One repetition of one contestant. A library that fails takes no further part in the row.
void run(Runner& r, const Points<3>& x, bool counts) {
    if (!r.failure.empty()) return;
    try {
        if (!r.contestant) r.contestant = r.make();
        r.contestant->forget();
        const double begin = processor_seconds();
        r.contestant->rebuild(x);
        const double s = processor_seconds() - begin;
        if (counts) r.seconds.push_back(s);
        r.cells = r.contestant->cells();
    } catch (const std::exception& e) {
        r.failure = e.what();
    }
}

/// All on the same points, each of them first at every so many repetitions. The first repetition does not count, since
/// there libraries allocate the arrays that they keep.
void row(const Choice& c, const std::string& family, const std::string& order) {
    std::vector<Runner> runners;
    for (const auto& [name, make] : bench::contestants())
        if (c.names.empty() || std::find(c.names.begin(), c.names.end(), name) != c.names.end())
            runners.push_back({std::string(name), make, nullptr, 0.0, {}, 0, {}});
    if (runners.empty()) throw std::invalid_argument("no contestants");
    Points<3> x = points(family, order, c.points, c.seed);
    if (c.memory)
        for (Runner& r : runners) r.bytes = bench::peak_memory(r.make, x) / static_cast<double>(c.points);
    for (int k = 0; k <= c.repeat; ++k) {
        x = points(family, order, c.points, c.seed + static_cast<std::uint64_t>(k));
        for (std::size_t j = 0; j < runners.size(); ++j)
            run(runners[(j + static_cast<std::size_t>(k)) % runners.size()], x, k > 0);
    }
    if (!runners.front().failure.empty()) throw std::runtime_error(runners.front().failure);
    ordered_json out{{"family", family}, {"order", order}, {"points", c.points}, {"repeat", c.repeat}};
    std::printf("%-9s %-6s n=%zu", family.c_str(), order.c_str(), c.points);
    for (const Runner& r : runners) {
        if (!r.failure.empty()) {
            std::printf(" | %s: %s", r.name.c_str(), r.failure.c_str());
            out[r.name] = {{"failure", r.failure}};
            continue;
        }
        std::vector<double> ns;
        std::vector<double> ratio;
        for (std::size_t k = 0; k < r.seconds.size(); ++k) {
            ns.push_back(1e9 * r.seconds[k] / static_cast<double>(c.points));
            ratio.push_back(r.seconds[k] / runners.front().seconds[k]);
        }
        ordered_json one{{"ns", bench::quantile(ns, 0.5)},
                         {"ratio", bench::quantile(ratio, 0.5)},
                         {"ratio_low", bench::quantile(ratio, 0.1)},
                         {"ratio_high", bench::quantile(ratio, 0.9)},
                         {"cells", r.cells}};
        if (c.memory) one["bytes"] = r.bytes;
        std::printf(" | %s %.0f ns, ratio %.2f (%.2f to %.2f), %zu cells", r.name.c_str(), bench::quantile(ns, 0.5),
                    bench::quantile(ratio, 0.5), bench::quantile(ratio, 0.1), bench::quantile(ratio, 0.9), r.cells);
        if (c.memory) std::printf(", %.0f bytes", r.bytes);
        out[r.name] = std::move(one);
    }
    std::printf("\n");
    std::fflush(stdout);
    bench::append(c.json, out);
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    for (const std::string_view f : bench::families) choice.families.emplace_back(f);
    for (const std::string_view f : bench::lattices) choice.families.emplace_back(f);
    CLI::App app{"Libraries on the same points of space in turn, by processor time: above 1 the first one is faster."};
    app.add_option("-n,--points", choice.points)->check(CLI::Range(100, 100000000));
    app.add_option("--repeat", choice.repeat)->check(CLI::Range(1, 1000));
    app.add_option("--seed", choice.seed);
    app.add_option("-f,--families", choice.families)->delimiter(',');
    app.add_option("--orders", choice.orders, "random; local, along a space-filling curve")
        ->delimiter(',')
        ->check(CLI::IsMember({"random", "local"}));
    app.add_option("--contestants", choice.names, "fewer than were compiled in")->delimiter(',');
    app.add_flag("!--no-memory", choice.memory, "peak memory is not measured");
    app.add_option("--json", choice.json, "file that a line is appended to for each row");
    CLI11_PARSE(app, argc, argv);
    try {
        for (const std::string& family : choice.families)
            for (const std::string& order : choice.orders) row(choice, family, order);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-peers: %s\n", e.what());
        return 3;
    }
}
