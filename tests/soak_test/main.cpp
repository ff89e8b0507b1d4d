// SPDX-License-Identifier: GPL-3.0-or-later
// The soak test: every kind of motion under every strategy for tens of thousands of steps, audited. tests/soak runs it.
#include <soak_test/run.h>
#include <support/same_addresses.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>

using namespace annulus;
using namespace annulus::soak;

namespace {

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const testing::Motion_kind motion : testing::all_motions)
        for (const Setting& setting : all_settings)
            for (const int d : {2, 3}) cases.push_back({.motion = motion, .setting = setting, .dimension = d});
    return cases;
}

/// Empty parts of MOTION/STRATEGY/DIM select all.
bool matches(const Case& c, const std::string& pattern) {
    const std::size_t first = pattern.find('/');
    const std::size_t second = first == std::string::npos ? first : pattern.find('/', first + 1);
    const auto part = [&](std::size_t begin, std::size_t end) {
        return begin == std::string::npos ? std::string()
                                          : pattern.substr(begin, end == std::string::npos ? end : end - begin);
    };
    const auto after = [](std::size_t i) { return i == std::string::npos ? i : i + 1; };
    const auto fits = [](const std::string& wanted, std::string_view name) {
        return wanted.empty() || wanted == "*" || wanted == name;
    };
    return fits(part(0, first), testing::name_of(c.motion)) && fits(part(after(first), second), c.setting.name) &&
           fits(part(after(second), std::string::npos), std::to_string(c.dimension));
}

std::string repeat_line(const std::string& program, const Case& c) {
    return program + " --seed " + std::to_string(c.seed) + " --only " + c.name() + " --steps " +
           std::to_string(c.steps) + " --points " + std::to_string(c.points) + (c.calls ? " --calls" : "");
}

bool report(const std::string& program, const Case& c, const Outcome& o, double seconds) {
    const double within = o.asked == 0 ? 100.0 : 100.0 * static_cast<double>(o.within) / static_cast<double>(o.asked);
    std::printf(
        "%s seed=%llu %s%s points=%zu steps=%llu audits=%llu degenerate=%llu refused=%llu within=%.1f%% "
        "flips=%llu %.1fs failures=%d\n",
        o.fault.empty() ? "passed" : "FAILED", static_cast<unsigned long long>(c.seed), c.name().c_str(),
        c.calls ? " calls" : "", c.points, static_cast<unsigned long long>(o.steps),
        static_cast<unsigned long long>(o.audits), static_cast<unsigned long long>(o.degenerate),
        static_cast<unsigned long long>(o.refused), within, static_cast<unsigned long long>(o.flips), seconds,
        o.fault.empty() ? 0 : 1);
    if (!o.fault.empty()) std::printf("  %s\n  repeat: %s\n", o.fault.c_str(), repeat_line(program, c).c_str());
    std::fflush(stdout);
    return o.fault.empty();
}

// Not CLI11, which would take longer to compile than all of this.
struct Arguments {
    std::string only;
    std::uint64_t seed = 1;
    std::uint64_t steps = 0;
    std::uint64_t points = 0;
    std::uint64_t audits = 50;
    bool calls = false;
    bool list = false;
};

constexpr std::string_view usage =
    "usage: annulus-soak [--only MOTION/STRATEGY/DIM] [--seed N] [--steps N] [--points N] [--audits N] [--calls] "
    "[--list]\n"
    "  --only    an empty part or * stands for all\n"
    "  --seed    (1) the motion, its size and the calls in between\n"
    "  --steps   instead of as many as cost about the same\n"
    "  --points  instead of 40 to 400; at least 8\n"
    "  --audits  (50) how often a run is looked at, about; changes nothing in it\n"
    "  --calls   insertions, removals, single moves, recompute_tolerances and refused calls in between\n"
    "  --list    print the combinations and stop\n";

/// False for combinations that make no sense.
bool parse(int argc, char* argv[], Arguments& a) {
    const auto number = [](const char* text, std::uint64_t least, std::uint64_t& value) {
        const char* const end = text + std::strlen(text);
        const auto [stop, error] = std::from_chars(text, end, value);
        return error == std::errc() && stop == end && value >= least;
    };
    for (int i = 1; i < argc; ++i) {
        const std::string_view option = argv[i];
        if (option == "--calls") a.calls = true;
        else if (option == "--list") a.list = true;
        else if (i + 1 == argc) return false;
        else if (option == "--only") a.only = argv[++i];
        else if (option == "--seed" && number(argv[++i], 0, a.seed)) continue;
        else if (option == "--steps" && number(argv[++i], 1, a.steps)) continue;
        else if (option == "--points" && number(argv[++i], 8, a.points)) continue;
        else if (option == "--audits" && number(argv[++i], 1, a.audits)) continue;
        else return false;
    }
    return true;
}

}  // namespace

int main(int argc, char* argv[]) {
    annulus::testing::same_addresses_every_time(argv);
    Arguments arguments;
    if (!parse(argc, argv, arguments)) {
        std::cerr << usage;
        return 2;
    }
    int passed = 0;
    int failed = 0;
    for (Case c : all_cases()) {
        if (!matches(c, arguments.only)) continue;
        if (arguments.list) {
            std::cout << c.name() << '\n';
            ++passed;
            continue;
        }
        c.seed = arguments.seed;
        c.steps = arguments.steps;
        c.points = arguments.points;
        c.audits = arguments.audits;
        c.calls = arguments.calls;
        choose_size(c);
        const auto begin = std::chrono::steady_clock::now();
        const Outcome o = run(c);
        ++(report(argv[0], c, o, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())
               ? passed
               : failed);
    }
    if (passed + failed == 0) {
        std::cerr << "annulus-soak: no combination is called " << arguments.only << '\n';
        return 2;
    }
    if (!arguments.list) std::cout << passed << " passed, " << failed << " failed\n";
    return failed == 0 ? 0 : 1;
}
