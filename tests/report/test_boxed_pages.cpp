// SPDX-License-Identifier: GPL-3.0-or-later
// What pages say of runs in a periodic box, of their tolerances, and of a box that changes.
#include "page_text.h"

#include <apps/report/finding.h>
#include <apps/report/frame_record.h>
#include <apps/report/report_plots.h>
#include <apps/report/summary.h>

#include <support/catch.h>

using namespace annulus;
using annulus_test::contains;
using annulus_test::joined;
using annulus_test::two_steps;

TEST_CASE("Displacements in a box that changes are relative to it", "[report]") {
    Run_record run = two_steps();
    run.replayed = true;
    run.input.box = {{4, 0}, {0, 1}};
    CHECK(!contains(joined(findings(run)), "box"));  // it is the same in all frames
    run.input.box_before = {{4, 0}, {0, 1}};
    CHECK(contains(joined(findings(run)), "The box changed: its area is 4 at the end, as at the start.\n"));
    run.input.box = {{4, 0}, {1, 1}};
    CHECK(joined(findings(run))
              .starts_with("The box changed: its area is 4 at the end, as at the start, the lengths of its vectors "
                           "from 4 and 1 to 4 and "
                           "1.41, the angle between its vectors from 90 to 45 degrees.\nIn the 2 frames after the "
                           "first, points moved by "
                           "0.375 mean spacings a frame on average, and by 2 at most, relative to the box."));
    Report report;
    report.run = run;
    CHECK(contains(report_html(report), "Displacement, relative to the box"));
    for (Iteration_record& step : run.steps) step.displacement_mean = step.displacement_max = 2e-16;
    CHECK(contains(joined(findings(run)),
                   "In the 2 frames after the first, points did not move relative to the box, "
                   "but for rounding."));
    Run_record still = run;
    for (Iteration_record& step : still.steps) step.displacement_mean = step.displacement_max = 0;
    CHECK(contains(joined(findings(still)), "points did not move relative to the box."));
    report.run = run;
    CHECK(!contains(report_html(report), "isplacement"));
    CHECK(frame_figures({}, run, true).front().panels.front().title == "Flips");
    run.steps[1].displacement_max = 1e-11;
    CHECK(frame_figures({}, run, true).front().panels.front().y.label ==
          "displacement (mean spacings, relative to the box)");
    run.input.box_before = {{2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    run.input.box = {{2, 0, 0}, {0, 1, 0}, {0, 1, 1.5}};
    CHECK(joined(findings(run))
              .starts_with("The box changed: its volume went from 2 to 3, the lengths of its vectors from 2, 1 and 1 "
                           "to 2, 1 and 1.8, the "
                           "angle between its vectors 2 and 3 from 90 to 56.3 degrees.\n"));
}

TEST_CASE("In a periodic box certificates are counted where tolerances are tested", "[report]") {
    Report report;
    report.run = two_steps();
    report.run.tolerance = "certified";
    report.run.arithmetic.filter = 7;
    CHECK(contains(report_html(report), "<th scope=\"row\">certificates decided</th>"));
    report.run.input.box = {{4, 0}, {0, 1}};
    const std::string with = report_html(report);
    CHECK(contains(with, "<th scope=\"row\">tolerance</th><td>certified</td>"));
    CHECK(contains(with, "<th scope=\"row\">certificates decided for tolerances</th>"));
    CHECK(contains(with, "within tolerance, or at rest"));
    CHECK(contains(with, "Within tolerance"));
    CHECK(summary_json(report.run).at("tolerance") == "certified");
    report.run.strategy = "signs";
    for (Iteration_record& step : report.run.steps) step.tested_tolerances = false;
    const std::string without = report_html(report);
    CHECK(!contains(without, "ertificates decided"));
    CHECK(!contains(without, "ithin tolerance"));
    CHECK(contains(without, "The strategy signs tests no tolerances."));
    CHECK(contains(without, "<th scope=\"row\">at rest</th>"));
    CHECK(convergence_plots(report).front().title == "Displacement");
    report.run.steps[0].annulus_width_mean = 0.5;
    CHECK(convergence_plots(report).front().title == "Displacement, annulus width");
}

TEST_CASE("In a periodic box all cells are bounded", "[report]") {
    Run_record run = two_steps();
    std::vector<Frame_record> frames(2);
    frames[0].voronoi = frames[1].voronoi = Frame_record::Voronoi{.bounded = 5, .volume_median = 1, .hexagons = 0.25};
    const auto titles = [&] {
        std::string all;
        const std::vector<Figure> figures = frame_figures(frames, run, false);
        for (const Plot& plot : figures.back().panels) all += plot.title + "; ";
        return all;
    };
    CHECK(titles() == "The area of bounded cells; Cells with six neighbours, of all bounded cells; Unbounded cells; ");
    run.input.box = {{4, 0}, {0, 1}};
    CHECK(titles() == "The area of cells; Cells with six neighbours, of all cells; ");
}
