// SPDX-License-Identifier: GPL-3.0-or-later
// What a page says that the run found, and that it begins with this.
#include "page_text.h"

#include <formats/well_formed.h>

#include <apps/report/finding.h>
#include <apps/report/page.h>
#include <apps/report/report.h>
#include <apps/report/report_plots.h>

#include <support/catch.h>

#include <cmath>

using namespace annulus;
using annulus_test::contains;
using annulus_test::grid;
using annulus_test::joined;
using annulus_test::occurrences;
using annulus_test::two_steps;
using annulus_test::well_formed;

TEST_CASE("A finding says how far points moved, and what that took", "[report]") {
    Run_record run = two_steps();
    CHECK(joined(findings(run)) ==
          "In 2 iterations points moved by 0.375 mean spacings an iteration on average, and by 2 at most. 75 % of the "
          "moves stayed "
          "within their tolerance: nothing had to be computed for them. 3 flips kept the triangulation Delaunay.\n");
    run.moves = {.asked = 200, .rebuilt = 200};
    CHECK(contains(joined(findings(run)), "2 at most. The triangulation was rebuilt in every iteration."));
    run.moves = {.asked = 200, .within_tolerance = 19, .rebuilt = 100};
    run.steps[0].moves = {.asked = 100, .rebuilt = 100};
    run.steps[1].moves.within_tolerance = 19;
    CHECK(contains(
        joined(findings(run)),
        "by 2 at most. 3 flips kept the triangulation Delaunay. The triangulation was rebuilt in 1 iteration.\n"));
    run.steps.clear();
    CHECK(findings(run).empty());
    run.plane_before = Plane_step{60, {5, 15, 20, 15, 5}, 1, 30, 2.0};
    CHECK(joined(findings(run)) ==
          "There was no iteration. 20 of the 60 inner vertices have six neighbours (33.3 %). The least angle of a "
          "triangle is 30 degrees on average.\n");
}

TEST_CASE("Moves are within tolerance or beyond it only where that was tested", "[report]") {
    Run_record run = two_steps();
    run.tolerance = "certified";
    run.steps[0].tested_tolerances = false;
    run.steps[0].moves.within_tolerance = 5;  // at rest
    CHECK(
        contains(joined(findings(run)),
                 " 90 % of the moves in the 1 of 2 iterations that tested tolerances stayed within their tolerance: "));
    Run_record longer = run;  // one step of three does not stand for all
    longer.steps.push_back(run.steps[0]);
    CHECK(!contains(joined(findings(longer)), "their tolerance"));
    const std::vector<Plot> plots = cost_plots(run);
    REQUIRE(plots.size() == 2);
    CHECK(plots[0].title == "Moves beyond their tolerance");
    CHECK(std::isnan(plots[0].series[0].y[0]));
    CHECK(std::fabs(plots[0].series[0].y[1] - 10) < 1e-9);
    CHECK(plots[0].x.lower == 2.);
    CHECK(plots[0].x.scale == Scale::linear);
    CHECK(cost_plots(two_steps())[0].x.scale == Scale::log10);
    Report report;
    report.run = run;
    CHECK(contains(report_html(report), "Of 2 iterations 1 tested tolerances."));
    CHECK(contains(report_html(report), "that tested tolerances</th><td>1 <small>(50 %)"));
    report.comparison = Comparison_record{{run, two_steps()}, true, {}};
    CHECK(contains(report_html(report), ">90 % <small>in 1 iteration</small></td>"));
    CHECK(contains(report_html(report), ">75 %</td>"));
    run.steps[1].tested_tolerances = false;
    CHECK(!contains(joined(findings(run)), "their tolerance"));
    CHECK(cost_plots(run).size() == 1);
}

TEST_CASE("A finding says how cells and triangles have changed", "[report]") {
    Run_record run = two_steps();
    run.plane_before = Plane_step{60, {5, 15, 20, 15, 5}, 1, 30, 2.0};
    CHECK(findings(run).size() == 1);  // not measured at the end
    run.steps[1].plane = Plane_step{60, {0, 8, 45, 7, 0}, 35, 50, 1.5};
    CHECK(findings(run)[0] ==
          "45 of the 60 inner vertices have six neighbours at the end (75 %; 33.3 % at the start), 8 five, 7 seven. "
          "The least angle of a triangle rose from 30 to 50 degrees on average (60 if all are equilateral), and "
          "the energy is 75 % of that at the start.");
    run.plane_before = run.steps[1].plane = Plane_step{};  // three points
    CHECK(findings(run).size() == 1);
    run.plane_before = run.steps[1].plane = Plane_step{1, {0, 0, 1, 0, 0}, 59, 60, {}};
    CHECK(findings(run)[0] ==
          "The inner vertex has six neighbours at the end (100 % at the start). "
          "The least angle of a triangle stayed at 60 degrees on average (60 if all are equilateral).");
}

TEST_CASE("A finding says what all vertices have, and names the rare ones", "[report]") {
    Run_record run = two_steps();
    run.plane_before = Plane_step{16, {16, 0, 0, 0, 0}, 45, 45, {}};
    run.steps[1].plane = Plane_step{16, {16, 0, 0, 0, 0}, 45, 45.001, {}};
    CHECK(findings(run)[0] ==
          "All 16 inner vertices have four or fewer neighbours at the end (100 % at the start). The least angle of a "
          "triangle stayed at 45 degrees on average (60 if all are equilateral).");
    run.steps[1].plane = Plane_step{16, {2, 4, 5, 4, 1}, 45, 44.9, {}};
    CHECK(findings(run)[0] ==
          "5 of the 16 inner vertices have six neighbours at the end (31.2 %; 0 % at the start), 4 five, 4 seven, 2 "
          "four or fewer, 1 eight or more. The least angle of a triangle fell from 45 to 44.9 degrees on average (60 "
          "if all are equilateral).");
}

TEST_CASE("A finding says how the mesh has changed", "[report]") {
    Run_record run = two_steps();
    run.mesh_before = Mesh_step{.cells = 90, .slivers = 12, .dihedral_min = 0.5, .dihedral = {}};
    run.steps[1].mesh = Mesh_step{.cells = 88, .slivers = 3, .dihedral_min = 8.25, .dihedral = {}};
    CHECK(
        findings(run)[0] ==
        "The least dihedral angle of the mesh rose from 0.5 to 8.25 degrees, and the number of slivers fell from 12 to "
        "3, of 88 tetrahedra at the end.");
    run.finished = true;
    run.steps[0].mesh = Mesh_step{.cells = 89, .slivers = 14, .dihedral_min = 0.25, .dihedral = {}};
    CHECK(findings(run)[0] ==
          "The least dihedral angle of the mesh is 0.5 degrees at the start, 0.25 after 1 iteration, 8.25 after the "
          "finish. The number of slivers is 12 at the start, 14 after 1 iteration, 3 after the finish, of 88 "
          "tetrahedra at the end.");
    Run_record only_finish = run;
    only_finish.steps.erase(only_finish.steps.begin());
    CHECK(
        findings(only_finish)[0].starts_with("The least dihedral angle of the mesh is 0.5 degrees at the start, "
                                             "8.25 after the finish. The number"));
    run.steps[0].mesh = run.steps[1].mesh;
    const Plot slivers = mesh_plots(run)[1];
    CHECK(slivers.title == "Slivers");
    CHECK(slivers.series[0].x == std::vector<double>{0, 1, 2});
    CHECK(std::fabs(slivers.series[0].y.front() - 100 * 12. / 90) < 1e-9);
}

TEST_CASE("A finding names the fastest strategy", "[report]") {
    Comparison_record comparison{{two_steps(), two_steps()}, true, {}};
    CHECK(findings(comparison).empty());  // no time
    for (Run_record& run : comparison.runs) run.steps.resize(3);
    const auto time = [&](std::size_t run, double first, double second, double third) {
        comparison.runs[run].steps[0].seconds_triangulation = first;
        comparison.runs[run].steps[1].seconds_triangulation = second;
        comparison.runs[run].steps[2].seconds_triangulation = third;
    };
    time(0, 0.5, 0.625, 0.4);
    time(1, 0.125, 0.1, 7);  // a pause
    comparison.runs[0].strategy = "rebuild";
    CHECK(joined(findings(comparison)) ==
          "The fastest of 2 strategies was auto: 125 ms of processor time for keeping the triangulation in an "
          "iteration, the median of 3 iterations. The slowest, rebuild, took 4 times as long.\n");
    Report report;
    report.comparison = comparison;
    CHECK(contains(report_html(report), "<td data-key=\"0.125\">125 ms</td><td data-key=\"1\">1×</td>"));
    for (const char* part :
         {"Ratios in this table are of medians", "All strategies agree: at the end each has a Delaunay",
          "median of rebuild over its", "summed: processor time.", "Times are processor time"})
        CHECK(contains(report_html(report), part));
    report.run.threads = 2;
    for (Run_record& run : comparison.runs) run.threads = 2;
    report.comparison = comparison;
    for (const char* part :
         {"medians change little as long as fewer than half of the iterations have one", "Times are of the wall clock",
          "a jump may be a pause of the machine", "125 ms by the wall clock for keeping the triangulation"})
        CHECK(contains(report_html(report), part));
    CHECK(!contains(report_html(report), "rocessor time"));
    time(0, 0.125, 0.1, 0.12505);
    CHECK(joined(findings(comparison)) ==
          "The 2 strategies took about as long: 125 ms by the wall clock for keeping the triangulation in an "
          "iteration, the median of 3 iterations.\n");
    CHECK(median_step(comparison.runs[0]) == 0.125);
    comparison.runs[0].steps.pop_back();
    CHECK(median_step(comparison.runs[0]) == 0.1125);
    comparison.runs[0].steps.clear();
    CHECK(median_step(comparison.runs[0]) == 0);
    comparison.interrupted = true;
    CHECK(findings(comparison).empty());
}

TEST_CASE("A page of several strategies says of which its steps are", "[report]") {
    Report report;
    report.run = two_steps();
    report.comparison = Comparison_record{{two_steps(), two_steps()}, true, {}};
    report.comparison->runs[0].strategy = "rebuild";
    std::string html = report_html(report);
    for (const char* part : {"<h2>Convergence: auto</h2>", "<h2>What an iteration costs: auto</h2>",
                             "<h2>The run in numbers: auto</h2>", ">total time of all strategies<"})
        CHECK(contains(html, part));
    report.comparison.reset();
    html = report_html(report);
    for (const char* part : {"<h2>Convergence</h2>", "<h2>The run in numbers</h2>", ">total time<"})
        CHECK(contains(html, part));
}

TEST_CASE("A page begins with what the run found, and ends with its numbers", "[report]") {
    Report report;
    report.run = two_steps();
    report.run.plane_before = report.run.steps[0].plane = report.run.steps[1].plane =
        Plane_step{60, {0, 8, 45, 7, 0}, 35, 50, 1.5};
    report.before = report.after = grid(4);
    report.drawings.push_back({"", "<svg class=\"gray\"></svg>", "a <b>picture</b>"});
    Picture cells = grid(4);
    cells.caption = "Voronoi cells & more";
    cells.faces = {{{{0, 0}, {1, 0}, {1, 1}}, 2}, {{{2, 2}, {3, 2}, {3, 3}}, border_shade}};
    report.voronoi = {cells};
    const std::string html = report_html(report);
    CHECK(well_formed(html));
    const char* const order[] = {
        "class=\"finding\"", "The picture and its dots",         "a <b>picture</b>",      "Voronoi cells by number",
        "class=\"keys\"",    "aria-label=\"Voronoi cells &amp;", "aria-label=\"Energy\"", "<h2>The triangulation",
        "<h2>Convergence",   "<h2>What an iteration costs</h2>", "<h2>The run in numbers"};
    std::size_t at = 0;
    for (const char* part : order) {
        INFO(part);
        const std::size_t next = html.find(part, at);
        CHECK(next != std::string::npos);
        at = std::min(next, html.size());
    }
    CHECK(occurrences(html, "class=\"finding\"") == 2);
}

TEST_CASE("The course of cells and angles needs two measured steps", "[report]") {
    Report report;
    report.run = two_steps();
    report.run.plane_before = report.run.steps[1].plane = Plane_step{60, {0, 8, 45, 7, 0}, 35, 50, 1.5};
    CHECK(!contains(report_html(report), "How regular it became"));
    report.run.steps[0].plane = report.run.plane_before;
    const std::string html = report_html(report);
    for (const char* part : {"How regular it became", "aria-label=\"Numbers of neighbours\"",
                             "aria-label=\"Least angles of triangles\"", "aria-label=\"Energy\""})
        CHECK(contains(html, part));
    report.run.steps[0].plane->energy.reset();
    CHECK(!contains(report_html(report), "aria-label=\"Energy\""));  // one value is no curve
}

TEST_CASE("A replayed motion has frames, and a finish is no iteration", "[report]") {
    Run_record run = two_steps();
    run.replayed = true;
    run.moves.rebuilt = 100;
    run.steps[0].moves.rebuilt = 100;
    const std::string said = joined(findings(run));
    CHECK(contains(said, "In the 2 frames after the first, points moved by 0.375 mean spacings a frame on average"));
    CHECK(contains(said, "The triangulation was rebuilt in 1 frame.\n"));
    CHECK(!contains(said, "iteration"));
    CHECK(cost_plots(run).back().x.label == "frames after the first");
    Report report;
    report.run = run;
    CHECK(contains(report_html(report), "<th scope=\"row\">frames</th><td>3</td>"));
    run.replayed = false;
    run.finished = true;
    run.steps[0].tested_tolerances = false;
    CHECK(contains(joined(findings(run)), "In 1 iteration and the finish points moved by"));
    CHECK(contains(joined(findings(run)), "of the moves in the 1 of 2 steps, the finish included, that tested"));
    CHECK(cost_plots(run).back().x.label == "iteration, the last: the finish");
    CHECK(contains(joined(findings(run)), " mean spacings a step on average, and by"));
    run.moves = {.asked = 200, .rebuilt = 200};
    CHECK(contains(joined(findings(run)), "The triangulation was rebuilt in every step."));
    // Nothing but the finish.
    run.steps.resize(1);
    run.iterations = 1;
    CHECK(contains(joined(findings(run)), "In the finish points moved by "));
    CHECK(contains(joined(findings(run)), " mean spacings on average, and by"));
    CHECK(contains(joined(findings(run)), "The triangulation was rebuilt in the finish."));
    CHECK(contains(plot_html(cost_plots(run).back()), ", the finish: "));
    run.finished = false;
    CHECK(contains(joined(findings(run)), "The triangulation was rebuilt in this iteration."));
}

TEST_CASE("In 3D the volumes of Voronoi cells say how regular points are", "[report]") {
    Run_record run = two_steps();
    run.dimension = 3;
    run.volume_scatter_before = 0.4;
    CHECK(!contains(joined(findings(run)), "volumes"));
    run.steps[0].volume_scatter = 0.25;
    run.steps[1].volume_scatter = 0.125;
    CHECK(contains(joined(findings(run)),
                   "The volumes of the Voronoi cells differ from their mean by 12.5 % of it at the end (standard "
                   "deviation), by 40 % at the start.\n"));
    const std::vector<Plot> plots = regularity_plots(run);
    REQUIRE(plots.size() == 1);
    CHECK(plots[0].series[0].x == std::vector<double>{0, 1, 2});
    CHECK(plots[0].series[0].y == std::vector<double>{40, 25, 12.5});
    run.steps.resize(60, run.steps.back());  // of many steps the axis is logarithmic
    const Plot long_run = regularity_plots(run).front();
    CHECK(long_run.x.label == "1 + iteration");
    CHECK((long_run.x.scale == Scale::log10 && long_run.series[0].x.front() == 1));
}
