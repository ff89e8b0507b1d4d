// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

#include <limits>

// Section 4.1 of the paper: Lloyd iterations in 2D.
namespace annulus::inline v1 {

namespace {

std::string ours(const std::vector<const Benchmark_record*>& benchmarks, const char* slow) {
    return speeds(benchmarks, slow, {"paper", "tolerances-each", "auto"});
}

/// The standard deviation of the distances between each point and the nearest one, over their mean.
double scatter_of_distances(const Picture_record& p) {
    std::vector<double> nearest(p.x.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < p.x.size(); ++i)
        for (std::size_t j = 0; j < p.x.size(); ++j)
            if (i != j) nearest[i] = std::min(nearest[i], std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j]));
    if (nearest.size() < 2) return 0;
    const Measured x = scattered(nearest);
    return x.high + x.low > 0 ? (x.high - x.low) / (x.high + x.low) : 0;
}

const Certificate_survey_record* first(const Benchmark_record& r) {
    return r.surveys.empty() ? nullptr : &r.surveys.front();
}
/// The last one before a step.
const Certificate_survey_record* last(const Benchmark_record& r) { return survey_at(r, r.steps); }

void append_speed(const Reproduction& r, std::vector<Claim>& out) {
    const auto plane = lloyds(r);
    const auto theirs = [](const Benchmark_record& benchmark) {
        return speed_up(benchmark, "rebuild", "paper-printed");
    };
    Claim c = claim("figure-7", "Filtering Lloyd iterations is up to so many times faster than rebuilding.", "up to 6");
    if (!plane.empty()) {
        const auto x = of_each(plane, theirs);
        c.theirs =
            range(x, times) + " after " + grouped(plane.front()->steps) + " iterations; at the last tenth of them " +
            range(of_each(plane,
                          [](const auto& benchmark) {
                              return speed_up_between(benchmark, "rebuild", "paper-printed",
                                                      benchmark.steps - benchmark.steps / 10, benchmark.steps);
                          }),
                  times) +
            "; with a test in place (3.1) before relocation " +
            range(
                of_each(plane, [](const auto& benchmark) { return speed_up(benchmark, "rebuild", "paper-in-place"); }),
                times) +
            against_own_rebuild(plane);
        c.ours = ours(plane, "rebuild");
        c.verdict = at_least(most(x), 6);
        c.of_long_runs = true;
        c.reason = "Up to 6: 5.4 at least in one run. " + few_fail(plane);
    }
    out.push_back(c);

    c = claim("figure-7", "It outperforms rebuilding for every density.", "always");
    if (!plane.empty()) {
        c.theirs = listed(plane, theirs, times);
        c.ours = listed(
                     plane, [](const auto& benchmark) { return speed_up(benchmark, "rebuild", "auto"); }, times) +
                 " (auto)";
        c.verdict = above_one(of_each(plane, theirs));
        c.of_long_runs = true;
    }
    out.push_back(c);

    c = claim("figure-7", "It is faster than relocation by at least so much, in the plane.", "4");
    if (!plane.empty()) {
        const auto x =
            of_each(plane, [](const auto& benchmark) { return speed_up(benchmark, "relocate", "paper-printed"); });
        c.theirs = range(x, times);
        c.ours = ours(plane, "relocate");
        c.verdict = at_least(least(x), 4);
        c.of_long_runs = true;
        c.reason = "At least 4: 3.6 or more in every run. " + few_fail(plane) +
                   " Relocation is timed at some steps, on copies.";
    }
    out.push_back(c);

    c = claim("figure-7", "A step of the filter becomes cheaper as the iterations go on.", "yes");
    if (!plane.empty()) {
        const auto x = of_each(plane, [](const auto& benchmark) { return acceleration(benchmark, "paper-printed"); });
        c.theirs = "a step of the first tenth takes " + range(x, times) + " of the last tenth";
        c.ours = range(of_each(plane, [](const auto& benchmark) { return acceleration(benchmark, "auto"); }), times) +
                 " (auto)";
        c.verdict = above_one(x);
    }
    out.push_back(c);
    out.push_back(switch_claim(plane, "figure-7", "in the plane", 0.75));
}

}  // namespace

void append_lloyd_claims(const Reproduction& r, std::vector<Claim>& out) {
    append_speed(r, out);
    const Benchmark_record* x2 = r.benchmark("lloyd-x2");
    const Certificate_survey_record *begin = x2 ? first(*x2) : nullptr, *end = x2 ? last(*x2) : nullptr;

    Claim c{"figure-6", "Widths and tolerances grow until convergence, displacements shrink (x squared).",
            "yes",      "",
            "",         Claim_verdict::open,
            ""};
    if (begin && end) {
        const auto change = [&](double Certificate_survey_record::*what) {
            return readable(begin->*what) + " to " + readable(end->*what);
        };
        c.theirs = "displacement " + change(&Certificate_survey_record::displacement) + ", width " +
                   change(&Certificate_survey_record::width) + ", tolerance " +
                   change(&Certificate_survey_record::paper_tolerance) + " spacings";
        c.ours = "tolerance " + change(&Certificate_survey_record::certified_tolerance);
        c.verdict = agree_if(end->displacement < begin->displacement && end->width > begin->width &&
                             end->paper_tolerance > begin->paper_tolerance);
        c.reason = "The mean width settles early, tolerances go on growing.";
    }
    out.push_back(c);

    c = {"figure-6", "Nearly degenerate cases become fewer.", "fewer", "", "", Claim_verdict::open, ""};
    const auto all = lloyds(r);
    if (!all.empty()) {
        double before = 0, after = 0;
        for (const Benchmark_record* benchmark : all) {
            if (benchmark->degeneracies.empty()) continue;
            before += static_cast<double>(benchmark->degeneracies.front().below.front());
            after += static_cast<double>(benchmark->degeneracies.back().below.front());
        }
        c.theirs = "bi-cells narrower than a thousandth of a spacing: " + readable(before) + " at the start, " +
                   readable(after) + " at the end, of all densities";
        c.ours = "the same: counted exactly";
        c.verdict = agree_if(after < before);
    }
    out.push_back(c);

    c = {"figure-6", "A vertex of the plane is in so many bi-cells.", "12", "", "", Claim_verdict::open, ""};
    if (begin && end) {
        c.theirs =
            readable(begin->bicells_a_vertex) + " at the start, " + readable(end->bicells_a_vertex) + " at the end";
        c.ours = "the same";
        c.verdict = within(measured({begin->bicells_a_vertex, end->bicells_a_vertex}), 11.5, 12.5);
        c.reason = "12 means 11.5 to 12.5. By Euler's formula, less what the border lacks.";
    }
    out.push_back(c);

    c = {"figure-5", "Lloyd iterations spread points evenly with the density.", "pictures", "", "", Claim_verdict::open,
         ""};
    if (r.benchmark("points-one") && r.benchmark("points-x2")) {
        const auto& pictures = r.benchmark("points-one")->pictures;
        if (pictures.size() > 1) {
            const double before = scatter_of_distances(pictures.front()), after = scatter_of_distances(pictures.back());
            c.theirs = "distances from a point to the nearest one deviate from their mean by " + percent(before) +
                       " of it at the start, by " + percent(after) + " at the end, with density 1";
            c.ours = "the same motion";
            c.verdict = agree_if(2 * after < before);
            c.reason =
                "Evenly: the deviation falls below half. It is of density 1; for the others there are pictures only.";
        }
    }
    out.push_back(c);
}

}  // namespace annulus::inline v1
