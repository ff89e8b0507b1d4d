// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_mesh, CGAL and other libraries on the same points in turn: nanoseconds a point, ratios of the same points,
// first use of memory, numbers of cells.
#include "../motions/families.h"
#include "../motions/result_line.h"
#include "contestant.h"
#include "first_use.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

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
    int dimension = 3;
    std::size_t points = 10000;
    int repeat = 9;
    std::uint64_t seed = 1;
    std::vector<std::string> families;
    std::vector<std::string> orders{"random", "local"};
    std::vector<std::string> names;
    int first = 1;
    std::string json;
};

/// Points of a family: along a space-filling curve, or shuffled.
template <int d>
Points<d> points(const std::string& family, const std::string& order, std::size_t n, std::uint64_t seed) {
    Points<d> x = bench::Scene<d>(family, "walk", n, 0.0, seed).points();
    if (order == "local") return x;
    bench::Random random(seed + 1000);
    for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[random.bits() % i]);
    return x;
}

template <int d>
struct Runner {
    std::string name;
    bench::Make_contestant<d> make;
    std::unique_ptr<bench::Contestant<d>> contestant;
    std::vector<double> bytes;          // of first uses
    std::vector<double> first_seconds;  // of them
    std::vector<double> seconds;
    std::size_t cells = 0;
    std::string failure;
};

/// One repetition of one contestant. A library that fails takes no further part in the row.
template <int d>
void run(Runner<d>& r, const Points<d>& x, bool counts) {
    if (!r.failure.empty()) return;
    try {
        if (!r.contestant) r.contestant = r.make();
        r.contestant->forget();
        const double begin = bench::processor_seconds();
        r.contestant->rebuild(x);
        const double s = bench::processor_seconds() - begin;
        if (counts) r.seconds.push_back(s);
        r.cells = r.contestant->cells();
    } catch (const std::exception& e) {
        r.failure = e.what();
    }
}

/// First uses, each with other points: bytes a point, seconds.
template <int d>
void use_first(const Choice& c, const std::string& family, const std::string& order, std::vector<Runner<d>>& runners) {
    for (int k = 0; k < c.first; ++k) {
        const Points<d> x = points<d>(family, order, c.points, c.seed + static_cast<std::uint64_t>(k));
        for (Runner<d>& r : runners) {
            const auto [bytes, seconds] = bench::first_use<d>(r.make, x);
            r.bytes.push_back(bytes / static_cast<double>(c.points));
            r.first_seconds.push_back(seconds);
        }
    }
}

std::vector<double> ratios(const std::vector<double>& of, const std::vector<double>& to) {
    std::vector<double> all;
    for (std::size_t k = 0; k < of.size(); ++k) all.push_back(of[k] / to[k]);
    return all;
}

template <int d>
ordered_json result(const Choice& c, const Runner<d>& r, const Runner<d>& reference) {
    const auto ns = [&](const std::vector<double>& s) {
        return 1e9 * bench::quantile(s, 0.5) / static_cast<double>(c.points);
    };
    const std::vector<double> ratio = ratios(r.seconds, reference.seconds);
    ordered_json out{{"ns", ns(r.seconds)},
                     {"ratio", bench::quantile(ratio, 0.5)},
                     {"ratio_low", bench::quantile(ratio, 0.1)},
                     {"ratio_high", bench::quantile(ratio, 0.9)},
                     {"cells", r.cells}};
    std::printf(" | %s %.0f ns, ratio %.2f (%.2f to %.2f), %zu cells", r.name.c_str(), out["ns"].template get<double>(),
                bench::quantile(ratio, 0.5), bench::quantile(ratio, 0.1), bench::quantile(ratio, 0.9), r.cells);
    if (c.first == 0) return out;
    out["bytes"] = bench::quantile(r.bytes, 0.5);
    out["first_ns"] = ns(r.first_seconds);
    out["first_ratio"] = bench::quantile(ratios(r.first_seconds, reference.first_seconds), 0.5);
    std::printf(", %.0f bytes, first %.0f ns", bench::quantile(r.bytes, 0.5), ns(r.first_seconds));
    return out;
}

/// All on the same points, each of them first at every so many repetitions. The first repetition does not count, since
/// there libraries allocate the arrays that they keep.
template <int d>
void row(const Choice& c, const std::string& family, const std::string& order) {
    std::vector<Runner<d>> runners;
    for (const auto& [name, make] : bench::contestants<d>())
        if (c.names.empty() || std::find(c.names.begin(), c.names.end(), name) != c.names.end())
            runners.push_back({std::string(name), make, nullptr, {}, {}, {}, 0, {}});
    if (runners.empty()) throw std::invalid_argument("no contestants");
    use_first<d>(c, family, order, runners);
    for (int k = 0; k <= c.repeat; ++k) {
        const Points<d> x = points<d>(family, order, c.points, c.seed + static_cast<std::uint64_t>(k));
        for (std::size_t j = 0; j < runners.size(); ++j)
            run<d>(runners[(j + static_cast<std::size_t>(k)) % runners.size()], x, k > 0);
    }
    if (!runners.front().failure.empty()) throw std::runtime_error(runners.front().failure);
    ordered_json out{
        {"dimension", d}, {"family", family}, {"order", order}, {"points", c.points}, {"repeat", c.repeat}};
    std::printf("%dD %-9s %-6s n=%zu", d, family.c_str(), order.c_str(), c.points);
    for (const Runner<d>& r : runners) {
        if (r.failure.empty()) {
            out[r.name] = result<d>(c, r, runners.front());
            continue;
        }
        std::printf(" | %s: %s", r.name.c_str(), r.failure.c_str());
        out[r.name] = {{"failure", r.failure}};
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
    CLI::App app{"Libraries on the same points in turn, by processor time: above 1 the first one is faster."};
    app.add_option("-d,--dimension", choice.dimension)->check(CLI::Range(2, 3));
    app.add_option("-n,--points", choice.points)->check(CLI::Range(100, 100000000));
    app.add_option("--repeat", choice.repeat)->check(CLI::Range(1, 1000));
    app.add_option("--seed", choice.seed);
    app.add_option("-f,--families", choice.families)->delimiter(',');
    app.add_option("--orders", choice.orders, "random; local, along a space-filling curve")
        ->delimiter(',')
        ->check(CLI::IsMember({"random", "local"}));
    app.add_option("--contestants", choice.names, "fewer than were compiled in")->delimiter(',');
    app.add_option("--first", choice.first,
                   "so often in a process of its own: peak memory, and time in memory that is new")
        ->check(CLI::Range(0, 1000));
    app.add_option("--json", choice.json, "file that a line is appended to for each row");
    CLI11_PARSE(app, argc, argv);
    try {
        for (const std::string& family : choice.families)
            for (const std::string& order : choice.orders) {
                if (choice.dimension == 2) row<2>(choice, family, order);
                else row<3>(choice, family, order);
            }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-peers: %s\n", e.what());
        return 3;
    }
}
