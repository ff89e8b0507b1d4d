// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

#include <limits>

// Section 4.2 of the paper: tolerances and failures along the optimisation of meshes.
namespace annulus::inline v1 {

namespace {

double widths_per_tolerance(const Benchmark_record& r) {
    const Certificate_survey_record* s = survey_at(r, r.steps);
    return s && s->paper_tolerance > 0 ? s->width / s->paper_tolerance : 0;
}
double widths_per_certified(const Benchmark_record& r) {
    const Certificate_survey_record* s = survey_at(r, r.steps);
    return s && s->certified_tolerance > 0 ? s->width / s->certified_tolerance : 0;
}
double relative_deviation(const Benchmark_record& r) {
    const Certificate_survey_record* s = survey_at(r, r.steps);
    return s && s->width > 0 ? s->width_deviation / s->width : 0;
}

}  // namespace

void append_mesh_claims(const Reproduction& r, std::vector<Claim>& out) {
    const Benchmark_record *x2 = r.benchmark("lloyd-x2"), *sphere = r.benchmark("nodt-sphere"),
                           *bunny = r.benchmark("nodt-bunny");
    const auto space = meshes(r);
    Claim c{"figure-10", "A vertex in space is in so many bi-cells.", "more than 60", "", "", Claim_verdict::open, ""};
    if (!space.empty()) {
        const auto count = [](const Certificate_survey_record* s) { return s ? s->bicells_a_vertex : 0; };
        const auto first = [&](const Benchmark_record& benchmark) { return count(survey_at(benchmark, 1)); };
        const auto last = [&](const Benchmark_record& benchmark) {
            return count(survey_at(benchmark, benchmark.steps + 1));
        };
        c.theirs = "at the start " + listed(space, first, readable) + "; at the end " + listed(space, last, readable);
        c.ours = "the same";
        auto counts = of_each(space, first);
        for (const Benchmark_record* benchmark : space) counts.push_back(last(*benchmark));
        c.verdict = within(measured(counts), 60, std::numeric_limits<double>::infinity());
        c.reason =
            "Random points without a border have some 13.5 facets a vertex, and so 68; regular cells and a border have "
            "fewer.";
    }
    out.push_back(c);

    c = {"figure-10", "Widths and tolerances converge in space too.", "yes", "", "", Claim_verdict::open, ""};
    if (sphere && survey_at(*sphere, sphere->steps)) {
        const Certificate_survey_record &a = sphere->surveys.front(), &z = *survey_at(*sphere, sphere->steps);
        c.theirs = "sphere: width " + readable(a.width) + " to " + readable(z.width) + ", tolerance " +
                   readable(a.paper_tolerance) + " to " + readable(z.paper_tolerance) + " spacings";
        c.ours = "tolerance " + readable(a.certified_tolerance) + " to " + readable(z.certified_tolerance);
        const Certificate_survey_record* middle = nullptr;  // the last one in two thirds of the iterations
        for (const Certificate_survey_record& s : sphere->surveys)
            if (3 * s.step <= 2 * sphere->steps) middle = &s;
        const auto converged = [&](double Certificate_survey_record::*what) {
            return middle && z.*what > a.*what && std::fabs(z.*what - middle->*what) < 0.05 * (z.*what - a.*what);
        };
        c.verdict = agree_if(converged(&Certificate_survey_record::width) &&
                             converged(&Certificate_survey_record::paper_tolerance));
        c.of_long_runs = true;
        c.reason = "Converged: the last third of the iterations makes less than a twentieth of the change.";
    }
    out.push_back(c);

    c = {"figure-10", "Beside the width the tolerance is smaller in space than in the plane.",
         "smaller",   "",
         "",          Claim_verdict::open,
         ""};
    if (x2 && sphere) {
        c.theirs = "widths a tolerance at the end: " + readable(widths_per_tolerance(*x2)) +
                   " in the plane (x squared), " + readable(widths_per_tolerance(*sphere)) + " in space (sphere)";
        c.ours = "by certified tolerances " + readable(widths_per_certified(*x2)) + " and " +
                 readable(widths_per_certified(*sphere));
        c.verdict = agree_if(widths_per_tolerance(*sphere) > widths_per_tolerance(*x2));
    }
    out.push_back(c);

    c = {"figure-10", "Widths scatter more in space than in the plane.", "more", "", "", Claim_verdict::open, ""};
    if (x2 && sphere) {
        const auto one = [&](const Benchmark_record& benchmark) { return readable(relative_deviation(benchmark)); };
        const Benchmark_record* uniform = r.benchmark("lloyd-one");
        c.theirs = "standard deviation over mean at the end: " + one(*sphere) + " on the sphere, " + one(*x2) +
                   " in the plane with x squared" + (uniform ? ", " + one(*uniform) + " with density 1" : "");
        c.ours = "the same";
        std::vector<double> plane{relative_deviation(*x2)};
        if (uniform) plane.push_back(relative_deviation(*uniform));
        const double space_deviation = relative_deviation(*sphere);
        c.verdict = below(measured(plane), {space_deviation, space_deviation});
        c.reason =
            "More than with each density. With a density that varies cells are of many sizes, which scatters widths in "
            "mean spacings; with density "
            "1 they scatter less than on the sphere.";
    }
    out.push_back(c);

    const auto failing = [&](const char* name, const Benchmark_record* benchmark, const char* claimed, double value) {
        Claim f = claim("figure-11", std::string("Share of moves that fail at the 1,000th iteration: ") + name + ".",
                        claimed);
        if (benchmark) {
            const double x = failures_at(*benchmark, "paper-printed", benchmark->steps);
            f.theirs = percent(x) + " over iterations " + grouped(benchmark->steps - benchmark->steps / 10) + " to " +
                       grouped(benchmark->steps);
            f.ours = percent(failures_at(*benchmark, "tolerances-each", benchmark->steps)) + " (tolerances-each)";
            f.of_long_runs = true;
            f.verdict = within({x, x}, value / 1.5, 1.5 * value);
            if (const auto step = first_step_below(*benchmark, "paper-printed", value))
                f.reason = std::string(claimed) + " means " + percent(value / 1.5) + " to " + percent(1.5 * value) +
                           ". Our motion has the paper's share at iteration " + grouped(*step) +
                           " already: it comes to rest sooner. At the last one points go " +
                           readable(benchmark->displacement.back()) + " spacings in the mean.";
            else f.reason = "Our motion does not come to rest so far.";
        }
        out.push_back(f);
    };
    failing("bunny", bunny, "25 %", 0.25);
    failing("sphere", sphere, "16 %", 0.16);

    c = {"figure-11",
         "More moves fail for the bunny than for the sphere, and a failure costs more in space than in the plane.",
         "yes",
         "",
         "",
         Claim_verdict::open,
         ""};
    if (bunny && sphere && x2) {
        const auto updates = [](const Benchmark_record& benchmark) {
            return updates_at(benchmark, "paper-printed", benchmark.steps);
        };
        c.theirs = "failures " + percent(failures_at(*bunny, "paper-printed", bunny->steps)) + " and " +
                   percent(failures_at(*sphere, "paper-printed", sphere->steps)) + "; updates a failure " +
                   readable(updates(*bunny)) + ", " + readable(updates(*sphere)) + ", in the plane " +
                   readable(updates(*x2));
        c.ours = "updates a failure " + readable(updates_at(*bunny, "tolerances-each", bunny->steps)) + ", " +
                 readable(updates_at(*sphere, "tolerances-each", sphere->steps)) + ", " +
                 readable(updates_at(*x2, "tolerances-each", x2->steps));
        c.verdict = agree_if(failures_at(*bunny, "paper-printed", bunny->steps) >
                                 failures_at(*sphere, "paper-printed", sphere->steps) &&
                             std::min(updates(*bunny), updates(*sphere)) > updates(*x2));
        c.reason = "Ours evaluates the certificates that expired, not all around a vertex.";
    }
    out.push_back(c);

    c = claim(
        "figure-11",
        "Some cases stay nearly degenerate and fail many times in a row, but their amount is rather small, in space.",
        "small");
    const auto in_a_row = [](const Benchmark_record& benchmark, std::size_t k) {
        const Contender_record* x = contender_of(benchmark, "paper-printed");
        return x && k < x->streaks.size()
                   ? share(static_cast<double>(x->streaks[k]), static_cast<double>(benchmark.vertices))
                   : 0;
    };
    if (!space.empty()) {
        std::string words;
        for (const std::size_t k : {2U, 3U, 5U, 6U})
            words += (words.empty() ? "" : ", ") + grouped(streak_lengths[k]) + " times " +
                     range(of_each(space, [&](const auto& benchmark) { return in_a_row(benchmark, k); }), percent);
        c.theirs = "vertices that failed at the last step and before it, so often in a row: " + words;
        c.ours = "failures are evaluated in place; few are relocated";
        c.verdict = agree_if(most(of_each(space, [&](const auto& benchmark) { return in_a_row(benchmark, 3); })) < 0.1);
        c.of_long_runs = true;
        c.reason = "Small: below a tenth of the vertices, ten times in a row.";
    }
    out.push_back(c);
}

}  // namespace annulus::inline v1
