// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the place of a plot with one place, and what is said of curves that lie upon one another.
#include "page_text.h"

#include <formats/well_formed.h>

#include <apps/report/coinciding_curves.h>
#include <apps/report/frame_record.h>
#include <apps/report/page.h>
#include <apps/report/report_plots.h>

#include <support/catch.h>

#include <limits>

using namespace annulus;
using annulus_test::contains;
using annulus_test::occurrences;
using annulus_test::two_steps;
using annulus_test::well_formed;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Run_record of(const std::string& strategy, double first, double second) {
    Run_record run = two_steps();
    run.strategy = strategy;
    run.steps[0].seconds_cumulative = first;
    run.steps[1].seconds_cumulative = second;
    return run;
}

}  // namespace

TEST_CASE("A plot of one place is a sentence", "[report]") {
    Plot plot{"t", {"iteration"}, {"time <ms>"}, {{"a", {1}, {2.5}}, {"b", {1}, {1234}}}};
    CHECK(plot_html(plot) == "<p>Time &lt;ms&gt;, iteration 1: a 2.5, b 1,230.</p>");
    plot.x.label = "frames after the first";
    CHECK(contains(plot_html(plot), ", 1 frame after the first: a"));
    for (Series& s : plot.series) s.x = {12};
    CHECK(contains(plot_html(plot), ", 12 frames after the first: a"));
    plot.x.label = "iteration, the last: the finish";
    plot.series.resize(1);
    plot.series[0].name = "";
    CHECK(plot_html(plot) == "<p>Time &lt;ms&gt;, iteration 12: 2.5.</p>");
    plot.series[0] = {"", {1, 2, 3}, {not_a_number, 7, not_a_number}, false, {0, 2, 0}};  // measured once
    CHECK(contains(plot_html(plot), "iteration 2: 7 ± 2."));
    plot.series[0].y[2] = 7;
    CHECK(plot_html(plot) == svg_plot(plot));
    plot.series[0] = {"", {0, 1}, {100}, true};  // a histogram of one bin
    CHECK(plot_html(plot) == svg_plot(plot));
    plot.series[0] = {"", {}, {}};
    CHECK(plot_html(plot) == svg_plot(plot));
}

TEST_CASE("A run of one iteration has no plot with a dot", "[report]") {
    Report report;
    report.run = two_steps();
    report.run.steps.resize(1);
    report.comparison = Comparison_record{{report.run, report.run}, true, {}};
    const std::string html = report_html(report);
    CHECK(well_formed(html));
    CHECK(occurrences(html, "class=\"plot\"") == 0);
    CHECK(contains(html, "<p>Moves beyond tolerance (%), iteration 1: 40.</p>"));
    CHECK(!contains(html, "Cumulative time"));  // it is in the table
}

TEST_CASE("Curves that lie upon one another are named", "[report]") {
    Comparison_record comparison{{of("rebuild", 1, 2), of("auto", 1, 2.002), of("paper", 0.01, 0.02)}, true, {}};
    const auto said = [&](std::size_t plot) { return on_coinciding_curves(comparison_plots(comparison).at(plot)); };
    CHECK(said(0) == "The curves of rebuild and auto lie upon one another.");
    CHECK(said(1) == said(0));
    Report report;
    report.run = comparison.runs[0];
    report.comparison = comparison;
    CHECK(occurrences(report_html(report),
                      "<figcaption>The curves of rebuild and auto lie upon one another.</figcaption></figure>") == 2);
    comparison.runs[1].steps[0].seconds_cumulative = 1.1;
    CHECK((said(0).empty() && said(1).empty()));
    // Apart on a logarithmic scale alone.
    comparison.runs.push_back(of("tolerances", 0.012, 0.024));
    CHECK(said(0) == "The curves of paper and tolerances lie upon one another.");
    CHECK(said(1).empty());
    comparison.runs.push_back(of("relocate", 1.1, 2.002));
    CHECK(said(0) == "The curves of auto and relocate; of paper and tolerances lie upon one another.");
    CHECK(said(1) == "The curves of auto and relocate lie upon one another.");
    // On a logarithmic scale nothing of the first two is to be seen; names with commas are quoted.
    const Plot rows{
        "",
        {"x"},
        {"y", Scale::log10},
        {{"a", {1, 2}, {0, 0}}, {"b", {1, 2}, {0, 0}}, {"fcc, 1", {1, 2}, {3, 4}}, {"fcc, 2", {1, 2}, {3, 4}}}};
    CHECK(on_coinciding_curves(rows) == "The curves of \"fcc, 1\" and \"fcc, 2\" lie upon one another.");
}

TEST_CASE("Displacements of a replayed motion without tolerances are plotted once", "[report]") {
    Report report;
    report.run = two_steps();
    report.run.replayed = true;
    report.run.input.box = {{4, 0}, {0, 1}};
    report.figures = frame_figures({}, report.run, true);
    CHECK(occurrences(report_html(report),
                      "class=\"plot\" viewBox=\"0 0 520 360\" role=\"img\" "
                      "aria-label=\"How far points go in a frame\"") == 1);
    CHECK(!contains(report_html(report), "aria-label=\"Displacement"));
    report.figures.clear();  // on the page of compare
    CHECK(contains(report_html(report), "aria-label=\"Displacement\""));
    report.run.input.box.clear();
    report.figures = frame_figures({}, report.run, true);
    report.run.steps[0].tolerance_mean = report.run.steps[1].tolerance_mean = 0.1;
    CHECK(contains(report_html(report), "aria-label=\"Displacement, tolerance\""));
}

TEST_CASE("Widths are those of standard annuli in 2D alone", "[report]") {
    Report report;
    report.run = two_steps();
    Histogram widths = Histogram::linear(0, 1, 10);
    widths.add(0.5);
    report.annulus_widths.push_back({1, widths});
    CHECK(convergence_plots(report).back().title == "Distribution of standard annulus widths");
    report.run.dimension = 3;
    CHECK(convergence_plots(report).back().title == "Distribution of annulus widths");
}
