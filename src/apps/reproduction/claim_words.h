// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/formatted.h>
#include <apps/report/axis_ticks.h>
#include <apps/reproduction/benchmark_statistics.h>
#include <apps/reproduction/claim_rules.h>
#include <apps/reproduction/claims.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

// Numbers of claims as text.
namespace annulus::inline v1 {

[[nodiscard]] inline std::string percent(double share) {
    const double p = 100 * share;
    return formatted(p != 0 && std::fabs(p) < 0.1 ? "%.2g %%" : std::fabs(p) < 10 ? "%.1f %%" : "%.0f %%", p);
}
[[nodiscard]] inline std::string times(double x) {
    return x < 1000 ? formatted(x < 10 ? "%.2g" : "%.0f", x) : readable(x);
}
/// "2.1 to 3.4", or one number.
[[nodiscard]] inline std::string range(std::vector<double> x, std::string (*word)(double)) {
    if (x.empty()) return "–";
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    const std::string a = word(*low), b = word(*high);
    return a == b ? a : a + " to " + b;
}
[[nodiscard]] inline double least(const std::vector<double>& x) {
    return x.empty() ? 0 : *std::min_element(x.begin(), x.end());
}
[[nodiscard]] inline double most(const std::vector<double>& x) {
    return x.empty() ? 0 : *std::max_element(x.begin(), x.end());
}

/// Those of these benchmarks that were run.
[[nodiscard]] inline std::vector<const Benchmark_record*> present(const Reproduction& r,
                                                                  std::initializer_list<const char*> names) {
    std::vector<const Benchmark_record*> out;
    for (const char* name : names)
        if (const Benchmark_record* benchmark = r.benchmark(name)) out.push_back(benchmark);
    return out;
}
[[nodiscard]] inline std::vector<const Benchmark_record*> lloyds(const Reproduction& r) {
    return present(r, {"lloyd-one", "lloyd-x2+y2", "lloyd-x2", "lloyd-sin2"});
}
[[nodiscard]] inline std::vector<const Benchmark_record*> meshes(const Reproduction& r) {
    return present(r, {"nodt-sphere", "nodt-man", "nodt-bunny", "nodt-liver"});
}
/// One number for each.
template <class Value>
[[nodiscard]] std::vector<double> of_each(const std::vector<const Benchmark_record*>& benchmarks, Value value) {
    std::vector<double> out;
    for (const Benchmark_record* benchmark : benchmarks) out.push_back(value(*benchmark));
    return out;
}
/// "sphere 1.2, man 0.8".
template <class Value>
[[nodiscard]] std::string listed(const std::vector<const Benchmark_record*>& benchmarks, Value value,
                                 std::string (*word)(double)) {
    std::string out;
    for (const Benchmark_record* benchmark : benchmarks) {
        out += (out.empty() ? "" : ", ") + benchmark->name.substr(benchmark->name.find('-') + 1) + " " +
               word(value(*benchmark));
    }
    return out.empty() ? "–" : out;
}
/// An open claim.
[[nodiscard]] inline Claim claim(std::string figure, std::string statement, std::string paper) {
    return {std::move(figure), std::move(statement), std::move(paper), "", "", Claim_verdict::open, ""};
}
[[nodiscard]] inline double share(double part, double all) { return all > 0 ? part / all : 0; }
/// Some strategies' speed-up, "tolerances-each 2 to 3, auto 4 to 5".
[[nodiscard]] inline std::string speeds(const std::vector<const Benchmark_record*>& benchmarks, const char* slow,
                                        std::initializer_list<const char*> names) {
    std::string out;
    for (const char* name : names)
        out += (out.empty() ? "" : ", ") +
               (std::string(name) == "paper" ? "the paper's with all of 3.1" : std::string(name)) + " " +
               range(of_each(benchmarks, [&](const auto& x) { return speed_up(x, slow, name); }), times);
    return out;
}
/// The speed of the paper's algorithm as printed against the library's own rebuilding, which is faster than CGAL's.
[[nodiscard]] inline std::string against_own_rebuild(const std::vector<const Benchmark_record*>& benchmarks) {
    const auto gain = [](const auto& x) { return speed_up(x, "rebuild-own", "paper-printed"); };
    return "; against the library's own rebuilding " + range(of_each(benchmarks, gain), times);
}
/// The share of moves within tolerance from which on the paper's algorithm as printed pays; `claimed` is the paper's.
[[nodiscard]] Claim switch_claim(const std::vector<const Benchmark_record*>& benchmarks, const char* figure,
                                 const char* where, double claimed);
/// Why the paper's algorithm is as fast as it is.
[[nodiscard]] inline std::string few_fail(const std::vector<const Benchmark_record*>& benchmarks) {
    return "Of all moves " +
           range(of_each(benchmarks, [](const auto& x) { return failed_share(x, "paper-printed"); }), percent) +
           " failed, and only these are relocated.";
}

}  // namespace annulus::inline v1
