// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/comparison_html.h>

#include <apps/formats/markup.h>
#include <apps/report/audit_words.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/finding.h>
#include <apps/report/page.h>
#include <apps/report/report_plots.h>
#include <apps/report/table.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

/// The share of moves within tolerance in the steps that tested tolerances, and how many these are.
Table_cell within_tolerance(const Run_record& run) {
    const Tested_moves tested = tested_moves(run);
    if (tested.asked == 0) return {"–"};
    std::string text = percentage(tested.within_tolerance, tested.asked);
    if (tested.steps < run.steps.size())
        text +=
            " <small>in " + grouped(tested.steps) + " " + step_word(run) + (tested.steps == 1 ? "" : "s") + "</small>";
    return {text, static_cast<double>(tested.within_tolerance) / static_cast<double>(tested.asked)};
}

}  // namespace

void append_comparison(std::string& out, const Comparison_record& comparison) {
    if (!comparison.interrupted)
        out += comparison.agree ? "<p class=\"verdict good\">All strategies agree: at the end each has a Delaunay "
                                  "triangulation of the points, the same where there is only one.</p>\n"
                                : "<p class=\"verdict bad\">The strategies disagree.</p>\n";
    for (const std::string& line : comparison.disagreements) out += "<p>" + escaped(line) + "</p>\n";
    if (comparison.runs.empty()) return;
    append_findings(out, findings(comparison));
    out += "<h2>Strategies compared</h2>\n";
    const auto fastest = std::min_element(comparison.runs.begin(), comparison.runs.end(),
                                          [](const auto& a, const auto& b) { return median_step(a) < median_step(b); });
    const Run_record& first = comparison.runs.front();
    std::vector<Table_row> rows;
    const auto ratio = [](double a, double b) {
        return b > 0 ? Table_cell(readable(a / b) + "×", a / b) : Table_cell("–");
    };
    for (const Run_record& run : comparison.runs) {
        const double seconds = run.seconds.triangulation, median = median_step(run);
        rows.push_back({escaped(run.strategy),
                        {duration(seconds), seconds},
                        {duration(median), median},
                        ratio(median, median_step(*fastest)),
                        ratio(median_step(first), median),
                        {duration(run.seconds.construction), run.seconds.construction},
                        within_tolerance(run),
                        {in_words(run.audit), static_cast<double>(run.audit.failed)}});
    }
    append_table(out,
                 {"strategy", std::string("all ") + step_word(first) + "s", std::string("median ") + step_word(first),
                  "its median over the least", "median of " + escaped(first.strategy) + " over its", "construction",
                  "within tolerance", "audits"},
                 rows, true);
    const bool any = std::any_of(comparison.runs.begin(), comparison.runs.end(),
                                 [](const Run_record& run) { return tested_moves(run).asked > 0; });
    const std::string word = step_word(first);
    out += "<figcaption>" +
           (times_processor(first)
                ? "Times are processor time, in which pauses of the machine do not count."
                : "Times are of the wall clock, which counts pauses of the machine, too: sums over all " + word +
                      "s have them; medians change little as long as fewer than half of the " + word + "s have one.") +
           " Ratios in this table are of medians, <code>ratios_of_medians</code> in "
           "compare.json; <code>ratios</code> there are of sums. " +
           (any ? "Within tolerance: the share of moves, in the " + word +
                      "s that tested tolerances; a dash where none did."
                : "No strategy completed a test of tolerances in any " + word + ".") +
           "</figcaption>\n";
    append_plots(out, "Cumulative time", comparison_plots(comparison),
                 "Time for keeping the triangulation and its tolerances right, without the motion and without the "
                 "construction of the first triangulation and its tolerances, summed" +
                     std::string(times_processor(first) ? ": processor time."
                                                        : " by the wall clock: a jump may be a pause of the machine.") +
                     " A curve that flattens belongs to a strategy that gains from small "
                     "displacements.");
}

}  // namespace annulus::inline v1
