// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

// Section 3.2 and figure 4 of the paper: theta and rounding.
namespace annulus::inline v1 {

namespace {

double first_theta(const Benchmark_record& r) {
    return r.degeneracies.empty() ? 0 : r.degeneracies.front().theta_hundredth;
}
double last_theta(const Benchmark_record& r) {
    return r.degeneracies.empty() ? 0 : r.degeneracies.back().theta_hundredth;
}

/// Median errors by the middle of their bin, for bins with enough bi-cells.
struct Errors {
    std::vector<double> theta, median;
};
Errors errors_of(const std::vector<const Benchmark_record*>& benchmarks) {
    Errors e;
    for (const Benchmark_record* benchmark : benchmarks)
        for (const Stability_record& s : benchmark->stabilities)
            for (std::size_t k = 1; k < s.counts.size(); ++k) {
                if (s.counts[k] < 20 || !(s.median[k] > 0)) continue;
                e.theta.push_back(std::sqrt(s.edges[k] * s.edges[k + 1]));
                e.median.push_back(s.median[k]);
            }
    return e;
}
/// The slope by least squares, both axes logarithmic, less and more its standard error; 0 without two different thetas.
Measured slope(const Errors& e) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < e.theta.size(); ++k) {
        const double a = std::log(e.theta[k]), b = std::log(e.median[k]);
        n += 1;
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    const double det = n * xx - x * x;
    if (!(det > 1e-9)) return {};
    const double b = (n * xy - x * y) / det, a = (y - b * x) / n;
    double squares = 0;
    for (std::size_t k = 0; k < e.theta.size(); ++k) {
        const double rest = std::log(e.median[k]) - a - b * std::log(e.theta[k]);
        squares += rest * rest;
    }
    const double error = n > 2 ? std::sqrt(squares / (n - 2) * n / det) : 0;
    return {b - error, b + error};
}
std::string words(const Errors& e) {
    return "the median relative error goes from " + readable(least(e.median)) + " to " + readable(most(e.median)) +
           ", as theta to the power " + readable(std::round(50 * (slope(e).low + slope(e).high)) / 100) +
           " (least squares, standard error " + readable(std::round(50 * (slope(e).high - slope(e).low)) / 100) + ")";
}

void append_growth(const std::vector<const Benchmark_record*>& benchmarks, const char* where, std::vector<Claim>& out) {
    Claim c = claim(
        "unsound",
        std::string("Tolerances become numerically more stable along such runs: theta grows, ") + where + ".", "grows");
    if (!benchmarks.empty()) {
        const auto grown = [](const Benchmark_record& benchmark) {
            return last_theta(benchmark) > first_theta(benchmark);
        };
        const auto n = std::count_if(benchmarks.begin(), benchmarks.end(),
                                     [&](const auto* benchmark) { return grown(*benchmark); });
        c.theirs = "the hundredth of theta grew in " + grouped(static_cast<std::uint64_t>(n)) + " of " +
                   grouped(benchmarks.size()) + " runs: " + listed(benchmarks, first_theta, readable) +
                   " at the start, " + listed(benchmarks, last_theta, readable) + " at the end";
        c.ours = "the stages of arithmetic do not depend on it";
        c.verdict = agree_if(static_cast<std::size_t>(n) == benchmarks.size());
        if (c.verdict == Claim_verdict::differs)
            c.reason = "The motion keeps the surface of a body with thin features, and flat bi-cells along it.";
    }
    out.push_back(c);
}

}  // namespace

void append_stability_claims(const Reproduction& r, std::vector<Claim>& out) {
    const auto plane = lloyds(r), space = meshes(r);
    for (const auto& [benchmarks, where] : {std::pair(&plane, "in the plane"), std::pair(&space, "in space")}) {
        Claim c = claim("unsound", std::string("Numerical stability is proportional to theta, ") + where + ".",
                        "error like 1/theta");
        const Errors e = errors_of(*benchmarks);
        if (e.theta.size() > 1) {
            c.theirs = words(e);
            c.ours = "certified: the error is bounded, whatever theta is";
            c.verdict = within(slope(e), -1.5, -0.5);
            c.reason =
                "1/theta means a power between −0.5 and −1.5. Plain double against integers, all bi-cells at the start "
                "and at the end, two bins of theta a decade.";
            if (c.verdict == Claim_verdict::differs)
                c.reason +=
                    " The half width is a determinant over a sum of norms, and nothing there is divided by theta: its "
                    "error follows how small the determinant is.";
        }
        out.push_back(c);
    }
    append_growth(plane, "in the plane", out);
    append_growth(space, "in space", out);
}

}  // namespace annulus::inline v1
