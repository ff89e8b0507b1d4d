// SPDX-License-Identifier: GPL-3.0-or-later
// What pages say that their words mean: units, tolerances, inner vertices.
#include "page_text.h"

#include <formats/well_formed.h>

#include <apps/report/certificate_terms.h>
#include <apps/report/run_terms.h>
#include <apps/report/terms.h>

#include <support/catch.h>

using namespace annulus;
using annulus_test::contains;
using annulus_test::two_steps;
using annulus_test::well_formed;

namespace {

std::string terms(const Report& report) {
    std::string out;
    append_run_terms(out, report);
    CHECK(well_formed("<div>" + out + "</div>"));
    return out;
}

Report with_tolerances(const std::string& strategy, const std::string& kind) {
    Report report;
    report.run = two_steps();
    report.run.strategy = strategy;
    report.run.tolerance = kind;
    return report;
}

}  // namespace

TEST_CASE("The mean spacing is that of the domain, of the box or of the first frame", "[report]") {
    Run_record run = two_steps();
    CHECK(mean_spacing_of(run) == "the square root of the area of the domain per vertex");
    run.dimension = 3;
    CHECK(mean_spacing_of(run) == "the cube root of the volume of the domain per vertex");
    run.input.box = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(mean_spacing_of(run) == "the cube root of the volume of the periodic box per vertex");
    run.replayed = true;
    CHECK(mean_spacing_of(run) == "the cube root of the volume of the periodic box in the first frame, per point");
    run.input.box.clear();
    run.dimension = 2;
    CHECK(mean_spacing_of(run) ==
          "the square root of the area of the bounding box of the points in the first frame, per point");
    Report report;
    report.run = run;
    CHECK(contains(report_html(report), "Lengths in mean spacings: the square root of the area of the bounding box"));
}

TEST_CASE("Terms are a list of words with what they mean", "[report]") {
    std::string out;
    append_terms(out, {{"n < m", "fewer & fewer"}, {"Last", "the end"}});
    CHECK(well_formed("<div>" + out + "</div>"));
    CHECK(contains(out, "<dt>n &lt; m</dt><dd>fewer &amp; fewer</dd>\n<dt>Last</dt><dd>the end</dd>\n</dl>"));
}

TEST_CASE("The terms of a page are those of its dimension and of its tolerances", "[report]") {
    Report report = with_tolerances("auto", "certified");
    const std::string plane = terms(report);
    for (const char* part :
         {"<dt>Bi-cell</dt><dd>Two triangles that share an edge.</dd>",
          "with the points of a bi-cell on them; the standard one has those of the shared edge on one of them",
          "Certified: it is a lower bound", "An iteration tested tolerances where they decided", "the other diagonal",
          "<dt>Mean spacing</dt><dd>The unit of lengths: the square root"})
        CHECK(contains(plane, part));
    report.run.dimension = 3;
    report.run.replayed = true;
    const std::string space = terms(report);
    for (const char* part : {"Two tetrahedra that share a triangle.", "concentric spheres", "A frame tested"})
        CHECK(contains(space, part));
    CHECK(!contains(space, "triangles"));
    CHECK(contains(terms(with_tolerances("rebuild", "certified")), "The strategy rebuild tests no tolerances."));
    CHECK(!contains(terms(with_tolerances("rebuild", "certified")), "Within tolerance"));
    CHECK(contains(terms(with_tolerances("paper:floating", "floating")), "Of the kind floating: in plain double"));
    report.comparison = Comparison_record{{with_tolerances("paper", "paper").run, report.run}, true, {}};
    report.run.strategy = "rebuild";
    const std::string both = terms(report);
    for (const char* part : {"Of the kind paper", "Certified:", "<dt>Within tolerance</dt>"})
        CHECK(contains(both, part));
    report.comparison = Comparison_record{{with_tolerances("rebuild", "certified").run, report.run}, true, {}};
    CHECK(contains(terms(report), "These strategies test no tolerances."));
    CHECK(contains(terms(report), "hull"));
    CHECK(!contains(terms(report), "relative to the box"));
    report = with_tolerances("auto", "certified");
    report.run.input.box = {{1, 0}, {0, 1}};
    CHECK(!contains(terms(report), "hull"));
    CHECK(contains(terms(report), "Ways are relative to the box"));
    CHECK(contains(terms(report), "<dt>Within tolerance</dt>"));
}

TEST_CASE("Certificates and spacings are those of open sets, of boxes, or of both", "[report]") {
    const auto of = [](bool open, bool boxes) {
        std::string out;
        append_degeneracy_terms(out, {true, false, open, boxes});
        return out;
    };
    CHECK(contains(of(true, false), "the area of the hull that one vertex has"));
    CHECK(contains(of(false, true), "the area of the box that one vertex has"));
    CHECK(contains(of(true, true), "the area of the hull, or of the box, that one vertex has"));
    CHECK(contains(of(true, true), "that the hull is convex there (in a periodic box there is none)."));
    CHECK(!contains(of(false, true), "hull"));
    CHECK(!contains(of(false, true), "Unsound"));
}

TEST_CASE("Locked vertices are explained where there are some", "[report]") {
    Report report = with_tolerances("auto", "certified");
    report.run.dimension = 3;
    CHECK(!contains(terms(report), "Locked"));
    report.run.steps[1].mesh.emplace();
    CHECK(!contains(terms(report), "Locked"));
    report.run.steps[1].mesh->locked = 1;
    CHECK(contains(terms(report), "<dt>Locked</dt><dd>A vertex that rests in an iteration, because"));
}

TEST_CASE("Inner vertices and measured triangles are those that the page counts", "[report]") {
    Run_record run = two_steps();
    CHECK(cells_caption(run).empty());
    run.plane_before = Plane_step{60, {5, 15, 20, 15, 5}, 1, 30, 2.0};
    CHECK(contains(cells_caption(run), "bounded and not cut by the border of the domain."));
    CHECK(contains(cells_caption(run), "whose circumcentre, where three cells meet, is in the domain."));
    CHECK(std::string(white_cells(run)) == "at the border");
    run.replayed = true;
    CHECK(contains(cells_caption(run), "those that are not on the convex hull: their Voronoi cells are bounded."));
    CHECK(contains(cells_caption(run), "each triangle, those along the hull included."));
    CHECK(std::string(white_cells(run)) == "unbounded");
    run.clip = Clip_record{"box", {}};
    CHECK(contains(cells_caption(run), "whose Voronoi cells are wholly in the clipping region."));
    CHECK(contains(cells_caption(run), "is in the clipping region."));
    CHECK(std::string(white_cells(run)) == "cut by the clipping region");
    run.clip.reset();
    run.input.box = {{1, 0}, {0, 1}};
    CHECK(cells_caption(run) ==
          "The neighbours of all vertices are counted. The least angle is that of each triangle.");
    CHECK(std::string(white_cells(run)).empty());
}

TEST_CASE("A page speaks of moves within tolerance only where a step tested some", "[report]") {
    Report report = with_tolerances("auto", "certified");
    for (Iteration_record& step : report.run.steps) {
        step.tested_tolerances = false;
        step.moves.within_tolerance = 0;
    }
    report.run.moves = {.asked = 200, .kept_in_place = 200};
    std::string html = report_html(report);
    CHECK(contains(html, "<th scope=\"row\">iterations that tested tolerances</th><td>none</td>"));
    for (const char* part : {"<th scope=\"row\">within tolerance", "<th scope=\"row\">at rest"})
        CHECK(!contains(html, part));
    // Those passed before so many failed that all signs were evaluated.
    report.run.moves = {.asked = 200, .within_tolerance = 30, .kept_in_place = 170};
    html = report_html(report);
    for (const char* part :
         {"<th scope=\"row\">within tolerance until tests were given up, or at rest</th><td>30 <small>(15 %)",
          "<th scope=\"row\">iterations that tested tolerances</th><td>none completed</td>"})
        CHECK(contains(html, part));
    report.run.steps[1].tested_tolerances = true;  // one step was tested, another one in part
    report.run.steps[1].moves.within_tolerance = 20;
    CHECK(contains(report_html(report),
                   "<th scope=\"row\">within tolerance, also where tests were then given up, or at rest</th><td>30 "));
    report.run.moves.within_tolerance = 20;
    CHECK(contains(report_html(report), "<th scope=\"row\">within tolerance, or at rest</th><td>20 "));
    report.run.moves.within_tolerance = 30;
    report.run.steps[1].tested_tolerances = false;
    report.run.strategy = "rebuild";
    html = report_html(report);
    CHECK(contains(html, "<th scope=\"row\">at rest</th><td>30 <small>(15 %)"));
    CHECK(!contains(html, "that tested tolerances</th>"));
    report.comparison = Comparison_record{{report.run, report.run}, true, {}};
    CHECK(contains(report_html(report), "No strategy completed a test of tolerances in any iteration."));
}
