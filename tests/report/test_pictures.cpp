// SPDX-License-Identifier: GPL-3.0-or-later
// Filled pictures: Voronoi cells, cuts of meshes, grey pictures.
#include "page_text.h"

#include <formats/well_formed.h>

#include <apps/report/cut_picture.h>
#include <apps/report/frame_record.h>
#include <apps/report/joined_outlines.h>
#include <apps/report/quantile.h>
#include <apps/report/report.h>
#include <apps/report/svg_gray.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>

using namespace annulus;
using annulus_test::contains;
using annulus_test::grid;
using annulus_test::occurrences;
using annulus_test::well_formed;

namespace {

double area(const std::vector<Coordinates<2>>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto &a = p[i], &b = p[(i + 1) % p.size()];
        sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return std::fabs(sum);
}

}  // namespace

TEST_CASE("Faces are drawn below edges, one path for each shade", "[report]") {
    Picture picture = grid(3);
    picture.faces = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1},
                     {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, 1},
                     {{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 3},
                     {{{0, 0}, {1, 0}}, 4}};  // nothing to fill
    const std::string svg = svg_triangulation(picture, window_of(picture.points));
    CHECK(well_formed(svg));
    // The window is a square of 9,700 units around the points; y goes down.
    CHECK(contains(svg,
                   "<path class=\"face n1\" stroke-width=\"22\" d=\"M150 9850l4850 0 0-4850-4850 0z"
                   "M5000 5000l4850 0 0-4850-4850 0z\"/>"));
    CHECK(contains(svg, "class=\"face n3\""));
    CHECK(occurrences(svg, "class=\"face") == 2);
    CHECK(svg.find("class=\"face") < svg.find("class=\"edges"));
    CHECK(svg.find("class=\"face") < svg.find("class=\"halo"));  // dots are seen on faces of their own colour
    CHECK(svg.find("class=\"halo") < svg.find("class=\"dots"));
    picture.shading = Shading::angles;
    CHECK(contains(svg_triangulation(picture, window_of(picture.points)), "class=\"face q1\""));
}

TEST_CASE("The parts of a face have one outline, holes the other way", "[report]") {
    using Outlines = std::vector<std::vector<Coordinates<2>>>;
    const auto square = [](double x, double y) {
        return std::vector<Coordinates<2>>{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    };
    CHECK(joined_outlines({square(0, 0)}) == Outlines{square(0, 0)});
    // An L; a corner is off by rounding, and another is there twice.
    Outlines l{square(0, 0), square(1, 0), square(0, 1)};
    l[1][0][1] += 1e-15;
    l[2].push_back(l[2].back());
    const Outlines joined = joined_outlines(l);
    REQUIRE(joined.size() == 1);
    CHECK(joined[0].size() == 8);
    CHECK(std::fabs(area(joined[0]) - 3) < 1e-14);
    Outlines ring;
    for (double x = 0; x < 3; ++x)
        for (double y = 0; y < 3; ++y)
            if (x != 1 || y != 1) ring.push_back(square(x, y));
    const Outlines around = joined_outlines(ring);
    REQUIRE(around.size() == 2);
    CHECK(area(around[0]) == 9);
    CHECK(area(around[1]) == 1);
    CHECK(joined_outlines({square(0, 0), square(5, 0)}) == Outlines{square(0, 0), square(5, 0)});
    // One path, filled where it winds: the hole is not.
    Picture picture = grid(4);
    picture.faces = {{around[0], 2, {around[1]}}};
    const std::string svg = svg_triangulation(picture, window_of(picture.points));
    CHECK(occurrences(svg.substr(0, svg.find("class=\"edges")), "M") == 2);
    CHECK(occurrences(svg, "class=\"face") == 1);
}

TEST_CASE("Of faces those in the window are drawn", "[report]") {
    Picture picture = grid(30);
    for (double x = 0; x < 29; ++x)
        for (double y = 0; y < 29; ++y) picture.faces.push_back({{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, 0});
    const Window window = window_of(picture.points, 100, 100);
    const std::string svg = svg_triangulation(picture, window);
    const std::size_t drawn = occurrences(svg.substr(0, svg.find("class=\"edges")), "M");
    CHECK(drawn >= 81);
    CHECK(drawn <= 169);
}

TEST_CASE("A page shows cells that reach beyond their points as a whole", "[report]") {
    Report report;
    report.voronoi = {grid(3)};
    report.voronoi[0].faces = {{{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}}, 2}};
    CHECK(contains(report_html(report), " d=\"M150 9850l9700 0 0-9700-9700 0z\"/>"));
}

TEST_CASE("Shades say what they mean", "[report]") {
    CHECK(shade_of_neighbours(0) == 0);
    CHECK(shade_of_neighbours(4) == 0);
    CHECK(shade_of_neighbours(5) == 1);
    CHECK(shade_of_neighbours(7) == 3);
    CHECK(shade_of_neighbours(8) == 4);
    CHECK(shade_of_neighbours(40) == 4);
    CHECK(shade_of_angle(9.99) == 0);
    CHECK(shade_of_angle(10) == 1);
    CHECK(shade_of_angle(49.9) == 4);
    CHECK(shade_of_angle(70.6) == 5);
    for (const auto& [shading, name] :
         {std::pair{Shading::neighbours, "8 or more"}, {Shading::angles, "50° or more"}}) {
        const std::string legend = legend_of(shading);
        CHECK(well_formed(legend));
        CHECK(occurrences(legend, "class=\"face") == 6);
        CHECK(contains(legend, name));
    }
    CHECK(contains(legend_of(Shading::neighbours), "at the border"));
    CHECK(!contains(legend_of(Shading::neighbours, ""), "at the border"));
}

TEST_CASE("A filled cut covers the section, with the shade of each cell", "[report]") {
    // A cube as six tetrahedra around a diagonal, of which one is left out.
    std::vector<Coordinates<3>> x;
    for (int i = 0; i < 8; ++i)
        x.push_back({static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
    Mesh_cells<3> cells;
    cells.vertices = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    std::vector<char> inside(6, 1);
    const auto filled = [&] {
        double sum = 0;
        for (const Face& face : cut_picture(cells, inside, x, 2, 0.25, "", true).faces) {
            CHECK(face.corners.size() >= 3);
            CHECK(face.corners.size() <= 4);
            CHECK(face.shade == shade_of_angle(45));  // Kuhn's tetrahedra
            sum += area(face.corners);
        }
        return sum;
    };
    CHECK(std::fabs(filled() - 1) < 1e-12);
    inside[0] = 0;
    const double rest = filled();
    CHECK(rest < 0.99);
    CHECK(rest > 0.4);
    CHECK(cut_picture(cells, inside, x, 2, 0.25, "").faces.empty());
    // Its points are no vertices: they are not drawn, and not counted as such.
    inside[0] = 1;
    const Picture cut = cut_picture(cells, inside, x, 2, 0.25, "");
    CHECK(cut.points.size() == 9);  // 4 edges of the cube, 4 diagonals of sides, 1 of the cube
    CHECK(!contains(svg_triangulation(cut, window_of(cut.points)), "class=\"dots\""));
    CHECK(!contains(svg_triangulation(cut, window_of(cut.points)), "class=\"halo\""));
    Film film;
    film.add(0, cut, true);
    CHECK(contains(film.html(), ", 9 cut edges</figcaption>"));
    CHECK(counted_dots(1, Dots::vertices) == "1 vertex");
    CHECK(counted_dots(2200, Dots::images) == "2,200 vertices and images");
}

TEST_CASE("A grey picture has sixteen levels, and few blocks", "[report]") {
    Gray_image image{4, 2, 255, {0, 0, 255, 255, 17, 17, 16, 255}};
    const std::string svg = svg_gray(image, "a & b");
    CHECK(well_formed(svg));
    CHECK(contains(svg, "aria-label=\"a &amp; b\""));
    CHECK(contains(svg, "viewBox=\"0 0 4.000 2.000\""));
    CHECK(contains(svg, "<path fill=\"#000\" d=\"M0 0h2v1h-2z\"/>"));
    CHECK(contains(svg, "<path fill=\"#111\" d=\"M0 1h3v1h-3z\"/>"));
    CHECK(occurrences(svg, "<path") == 2);  // white is the paper
    Gray_image large{1000, 500, 255, std::vector<std::uint16_t>(500'000)};
    for (std::size_t i = 0; i < large.value.size(); ++i) large.value[i] = i % 18 < 9 ? 0 : 255;  // blocks are nine wide
    const std::string coarse = svg_gray(large, "");
    CHECK(well_formed(coarse));
    CHECK(occurrences(coarse, "M") <= 120 * 60);
}

TEST_CASE("Curves that span much have a logarithmic scale, and others begin at 0", "[report]") {
    Run_record run;
    run.steps.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
        run.steps[i].iteration = i + 1;
        run.steps[i].displacement_mean = 0.01;
        run.steps[i].displacement_max = 0.02;
    }
    run.moves.rebuilt = 1;
    CHECK(frame_figures({}, run, true)[0].panels[0].y.scale == Scale::linear);
    CHECK(frame_figures({}, run, true)[0].panels[0].y.lower == 0.);
    run.steps[1].displacement_max = 3;
    CHECK(frame_figures({}, run, true)[0].panels[0].y.scale == Scale::log10);
    CHECK(!frame_figures({}, run, true)[0].panels[0].y.lower);
    run.steps[0].displacement_mean = 0;  // there is no place for it on such a scale
    CHECK(frame_figures({}, run, true)[0].panels[0].y.scale == Scale::linear);
}

TEST_CASE("Pairs of neighbours have two curves where they differ", "[report]") {
    std::vector<Frame_record> frames(2);
    frames[0].pairs = frames[1].pairs = Frame_record::Neighbour_pairs{3, 3};
    const auto changes = [&] { return frame_figures(frames, {}, false)[0].panels.back(); };
    CHECK(changes().series.size() == 1);
    CHECK(changes().y.label == "pairs made, and as many broken");
    CHECK(contains(frame_figures(frames, {}, false)[0].caption, "flips may be more"));
    Run_record run;
    run.steps.resize(2);
    run.replayed = true;
    const auto caption = [&](bool steps) { return frame_figures(frames, run, steps)[0].caption; };
    CHECK(contains(caption(true), "is not counted. So flips may be more."));
    run.moves.reinserted = 1;
    CHECK(contains(caption(true),
                   "is not counted. Points that are inserted or removed change neighbours, too, without "
                   "flips."));
    run.moves.rebuilt = 1;
    CHECK(contains(caption(true),
                   "is not counted. A frame that was rebuilt has such changes, and no flips: so flips "
                   "are counted, but not charted."));
    CHECK(contains(caption(false), "A frame that was rebuilt has such changes, and no flips."));
    run.moves.rebuilt = run.moves.reinserted = 0;
    run.strategy = "paper:floating";
    CHECK(contains(caption(true), "is not counted. The strategy paper:floating counts no flips."));
    CHECK(frame_figures(frames, run, true)[0].panels.size() == 2);
    run.strategy = "auto";
    CHECK(frame_figures(frames, run, true)[0].panels.size() == 3);
    run.moves.rebuilt = 1;
    frames[0].pairs.reset();
    frames[1].pairs.reset();
    CHECK(caption(true) == "A frame that was rebuilt has no flips: so flips are counted, but not charted.");
    frames[0].pairs = frames[1].pairs = Frame_record::Neighbour_pairs{3, 3};
    frames[1].pairs->broken = 2;
    REQUIRE(changes().series.size() == 2);
    CHECK(changes().series[1].name == "broken");
}

TEST_CASE("Quantiles of few values are between them", "[report]") {
    std::vector<double> two{3, 1};
    CHECK(quantile(two, 0) == 1);
    CHECK(quantile(two, 0.5) == 2);
    CHECK(quantile(two, 0.75) == 2.5);
    CHECK(quantile(two, 1) == 3);
    std::vector<double> one{7};
    CHECK(quantile(one, 0.95) == 7);
    std::vector<double> five{5, 3, 1, 4, 2};
    CHECK(quantile(five, 0.25) == 2);
    CHECK(std::fabs(quantile(five, 0.95) - 4.8) < 1e-15);
}

TEST_CASE("Volumes have no curves where no cell has one", "[report]") {
    std::vector<Frame_record> frames(2);
    frames[0].voronoi = frames[1].voronoi = Frame_record::Voronoi{.unbounded = 3};
    const auto figure = [&] { return frame_figures(frames, {}, false).back(); };
    REQUIRE(figure().panels.size() == 1);
    CHECK(figure().panels[0].title == "Unbounded cells");
    frames[1].number = 1;
    frames[1].voronoi->volume_low = frames[1].voronoi->volume_high = 0.5;
    REQUIRE(figure().panels.size() == 2);
    CHECK(figure().panels[0].series.size() == 2);
    CHECK(figure().panels[0].series[0].x == std::vector<double>{1});
}

TEST_CASE("A share of cells is in percent, as in the finding", "[report]") {
    std::vector<Frame_record> frames(1);
    frames[0].voronoi = Frame_record::Voronoi{};
    frames[0].voronoi->hexagons = 0.25;
    const std::vector<Plot> panels = frame_figures(frames, {}, false).back().panels;
    const auto plot = std::find_if(panels.begin(), panels.end(), [](const Plot& p) {
        return p.title == "Cells with six neighbours, of all bounded cells";
    });
    REQUIRE(plot != panels.end());
    CHECK(plot->series[0].y == std::vector<double>{25});
}
