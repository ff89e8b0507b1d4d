// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_text.h"

#include <formats/temporary_directory.h>
#include <formats/well_formed.h>

#include <annulus/error.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/report.h>
#include <apps/report/summary.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace annulus;
using annulus::testing::for_all;
using annulus_test::contains;
using annulus_test::grid;
using annulus_test::occurrences;
using annulus_test::Temporary_directory;
using annulus_test::well_formed;

namespace {

Report full_report() {
    Report report;
    report.title = "A <title> & \"more\"";
    report.run.command = "annulus lloyd --input '<script>alert(1)</script>'";
    report.run.strategy = "tolerances";
    report.run.tolerance = "certified";
    report.run.vertices = 12345;
    report.run.iterations = 3;
    report.run.moves = {30, 29, 1, 0, 0, 0};
    report.run.arithmetic = {1000, 0, 1};
    report.run.audit = {2, 0};
    report.run.seconds = {0.5, 1, 1.5};
    for (std::uint64_t i = 1; i <= 3; ++i) {
        Iteration_record step;
        step.iteration = i;
        step.displacement_mean = 1. / static_cast<double>(i);
        step.tolerance_mean = 0.1;
        step.seconds_triangulation = 0.1;
        step.seconds_cumulative = 0.1 * static_cast<double>(i);
        step.moves.asked = 10;
        step.moves.within_tolerance = 9;
        step.tested_tolerances = true;
        report.run.steps.push_back(step);
    }
    report.before = grid(4);
    report.after = grid(4);
    Histogram widths = Histogram::linear(0, 1, 10);
    widths.add(0.5);
    report.annulus_widths.push_back({10, widths});
    report.comparison = Comparison_record{{report.run, report.run}, false, {"step 2: <cells> differ"}};
    report.comparison->runs[1].strategy = "rebuild & co";
    report.figures.push_back({"Figure <8>", {{"t", {"x"}, {"y"}, {{"<s>", {1, 2}, {3, 4}, false}}}}, "caption &"});
    report.notes = {"a note with <b> & 'quotes'"};
    return report;
}

}  // namespace

TEST_CASE("text is escaped, and what is no character is replaced") {
    CHECK(escaped("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
    CHECK(escaped("é ρ 𝔻 \t\n") == "é ρ 𝔻 \t\n");
    const std::string bad = "\xef\xbf\xbd";
    CHECK(escaped(std::string_view("\0\x1b\x7f", 3)) == bad + bad + bad);
    CHECK(escaped("\xff\xc3") == bad + bad);
    CHECK(escaped("\xc0\xaf") == bad + bad);                      // overlong
    CHECK(escaped("\xed\xa0\x80") == bad + bad + bad);            // a surrogate
    CHECK(escaped("\xf4\x90\x80\x80") == bad + bad + bad + bad);  // beyond the last character
    CHECK(for_all("escaped text is always well formed", [] {
        const auto text =
            *rc::gen::container<std::string>(rc::gen::elementOf(std::string("<>&\"'\xc3\xa9\xff\x01 ab")));
        RC_ASSERT(well_formed("<p t=\"" + escaped(text) + "\">" + escaped(text) + "</p>"));
    }));
}

TEST_CASE("the report is well formed, complete and alone") {
    const std::string html = report_html(full_report());
    CHECK(well_formed(html));
    CHECK(html.starts_with("<!DOCTYPE html>\n"));
    CHECK(contains(html, "<h1>A &lt;title&gt; &amp; &quot;more&quot;</h1>"));
    CHECK(occurrences(html, "<script") == 1);  // our own, which sorts tables
    CHECK(contains(html, "&lt;script&gt;alert(1)"));
    for (const char* part : {"12,345", "certified", "rebuild &amp; co", "step 2: &lt;cells&gt; differ",
                             "The strategies disagree", "iteration 10", "Figure &lt;8&gt;", "caption &amp;",
                             "a note with &lt;b&gt;", "prefers-color-scheme:dark", "2 checked, "})
        CHECK(contains(html, part));
    // Nothing is fetched from anywhere.
    for (const char* part : {"http", "src=", "href=", "@import", "url("}) CHECK(!contains(html, part));
    CHECK(occurrences(html, "class=\"mesh\"") == 2);
    // Convergence 2, cost 2, comparison 2, the caller's 1.
    CHECK(occurrences(html, "class=\"plot\"") == 7);
    CHECK(occurrences(html, "nan") == occurrences(html, "determinant"));
}

TEST_CASE("an empty report and a failed audit are visible") {
    Report report;
    CHECK(well_formed(report_html(report)));
    report.run.audit = {5, 2};
    CHECK(contains(report_html(report), "2 of 5 audits failed"));
    report.run.moves = {1000000, 999999, 1, 0, 0, 0};
    CHECK(contains(report_html(report), "&gt; 99.9 %"));
    CHECK(contains(report_html(report), "&lt; 0.01 %"));
}

TEST_CASE("memory that the system does not tell is null, and no number") {
    Run_record run;
    CHECK(summary_json(run).at("memory").at("peak_bytes").is_null());
    run.memory_peak_bytes = 5'000'000;
    CHECK(summary_json(run).at("memory").at("peak_bytes") == 5'000'000);
}

TEST_CASE("a large triangulation is shown in a window, and the page says so") {
    Report report;
    report.before = grid(120);
    report.after = grid(120);
    const std::string html = report_html(report);
    CHECK(well_formed(html));
    // The square that holds the nearest 5,000 of a grid holds 70 by 70 or 72 by 72 of it.
    CHECK(occurrences(html, "5,184 vertices in a window in the middle, of 14,400") == 2);
    report.before = grid(100);
    report.after = std::nullopt;
    CHECK(!contains(report_html(report), "window in the middle"));
}

TEST_CASE("every edge of a picture is drawn once") {
    CHECK(for_all("trails cover the edges", [] {
        Picture picture;
        const auto n = *rc::gen::inRange<Index>(2, 12);
        for (Index i = 0; i < n; ++i)  // on a curve without three points in a line, so that segments differ
            picture.points.push_back({static_cast<double>(i), static_cast<double>(i) * i});
        std::vector<std::pair<Index, Index>> wanted;
        for (Index i = 0; i < n; ++i)
            for (Index j = i + 1; j < n; ++j)
                if (*rc::gen::arbitrary<bool>()) {
                    picture.edges.push_back({j, i});
                    wanted.emplace_back(i, j);
                }
        const std::string svg = svg_triangulation(picture, window_of(picture.points));
        const std::size_t at = svg.find(" d=\"") + 4;
        const std::string path = svg.substr(at, svg.find('"', at) - at);
        // Reads the path back: M x y l dx dy dx dy ...
        std::vector<std::pair<long, long>> corners;
        std::vector<std::pair<std::pair<long, long>, std::pair<long, long>>> drawn;
        const char* s = path.c_str();
        bool relative = false;
        std::pair<long, long> pen;
        while (*s != '\0') {
            if (*s == 'M' || *s == 'l') relative = *s++ == 'l';
            char* end = nullptr;
            const long x = std::strtol(s, &end, 10);
            const long y = std::strtol(end, &end, 10);
            s = end;
            const auto next = relative ? std::pair{pen.first + x, pen.second + y} : std::pair{x, y};
            if (relative) drawn.push_back(std::minmax(pen, next));
            pen = next;
        }
        RC_ASSERT(drawn.size() == wanted.size());
        std::sort(drawn.begin(), drawn.end());
        RC_ASSERT(std::adjacent_find(drawn.begin(), drawn.end()) == drawn.end());
    }));
    Picture bad = grid(2);
    bad.edges.push_back({0, 4});
    CHECK_THROWS_AS(svg_triangulation(bad, window_of(bad.points)), Error);
}

TEST_CASE("plots take any values") {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(for_all("svg_plot is well formed and finite", [&] {
        const auto value = rc::gen::element(0., -0., 1., -1., 1e-300, 1e300, 5e-324, 3., inf, -inf, nan, 1e-5, 7e4);
        const auto scale = rc::gen::element(Scale::linear, Scale::log10);
        Plot plot{"t", {"x", *scale}, {"y", *scale}, {}};
        for (int i = 0; i < 3; ++i)
            plot.series.push_back({"s", *rc::gen::container<std::vector<double>>(value),
                                   *rc::gen::container<std::vector<double>>(value), *rc::gen::arbitrary<bool>(),
                                   *rc::gen::container<std::vector<double>>(value)});
        const std::string svg = svg_plot(plot);
        RC_ASSERT(well_formed(svg));
        RC_ASSERT(!contains(svg, "nan"));
        RC_ASSERT(!contains(svg, "inf"));
        RC_ASSERT(svg.size() < 100000);
    }));
}

TEST_CASE("fourteen curves have different styles") {
    Plot plot{"t", {"x"}, {"y"}, {}};
    for (int i = 0; i < 14; ++i) plot.series.push_back({"s", {0, 1}, {0, static_cast<double>(i)}, false});
    const std::string svg = svg_plot(plot);
    std::set<std::string> styles;
    for (std::size_t at = 0; (at = svg.find("class=\"curve ", at)) != std::string::npos; ++at)
        styles.insert(svg.substr(at, svg.find('"', at + 7) - at));
    CHECK(styles.size() == 14);
}

TEST_CASE("errors are drawn as bars, within the frame") {
    const Plot plot{"t",
                    {"x"},
                    {"y"},
                    {{"s", {0, 1, 2, 3}, {4, 4, 4, 4}, false, {2, 0, std::numeric_limits<double>::quiet_NaN()}}}};
    const std::string svg = svg_plot(plot);
    CHECK(contains(svg, "class=\"bar c0\""));
    const auto bars = svg.substr(svg.find("class=\"bar c0\""));
    CHECK(std::count(bars.begin(), bars.begin() + static_cast<std::ptrdiff_t>(bars.find("/>")), 'M') == 1);
    const Plot logarithmic{"t", {"x"}, {"y", Scale::log10}, {{"s", {0, 1}, {4, 40}, false, {5, 5}}}};
    CHECK(contains(svg_plot(logarithmic), "class=\"bar c0\""));
    const Plot without{"t", {"x"}, {"y"}, {{"s", {0, 1}, {4, 4}}}};
    CHECK(!contains(svg_plot(without), "class=\"bar"));
}

TEST_CASE("a plot of many points stays small") {
    Plot plot{"t", {"x"}, {"y"}, {{"s", {}, {}, false}}};
    for (int i = 0; i < 200000; ++i) {
        plot.series[0].x.push_back(i);
        plot.series[0].y.push_back(std::sin(i * 0.7));
    }
    CHECK(svg_plot(plot).size() < 80000);
}

TEST_CASE("numbers are readable") {
    CHECK(readable(0) == "0");
    CHECK(readable(12345) == "12,300");
    CHECK(readable(0.012345) == "0.0123");
    CHECK(readable(999.9) == "1,000");
    CHECK(readable(-2.5) == "−2.5");
    CHECK(readable(1e-7) == "10⁻⁷");
    CHECK(readable(1.5e12) == "1.5·10¹²");
    CHECK(readable(1e7) == "10⁷");
    CHECK(readable(9990000) == "9,990,000");
    CHECK(readable(100) == "100");
    CHECK(grouped(1234567) == "1,234,567");
    CHECK(grouped(999) == "999");
}

TEST_CASE("a linear axis has ticks at steps of one, two or five") {
    const auto labels = [](double upper) {
        std::string all;
        const Axis_range range({"", Scale::linear}, {0, upper});
        for (const Tick& t : range.ticks()) all += t.label + " ";
        return all;
    };
    CHECK(labels(5) == "0 1 2 3 4 5 ");
    CHECK(labels(10) == "0 2 4 6 8 10 ");
    CHECK(labels(22) == "0 5 10 15 20 25 ");
    CHECK(labels(40) == "0 10 20 30 40 ");
    const Axis_range none_at_all({"", Scale::linear, 0.}, {0, 0, 0});  // counts
    CHECK(none_at_all.ticks().front().label == "0");
    CHECK(none_at_all.ticks().back().label == "1.0");
}

TEST_CASE("a logarithmic axis has two labels or more, all different") {
    const auto check = [](double from, double to) {
        INFO(from << " to " << to);
        const Axis_range axis({"x", Scale::log10}, {from, to});
        std::vector<std::string> labels;
        for (const Tick& tick : axis.ticks()) {
            CHECK(axis.place(tick.value) > -1e-6);
            CHECK(axis.place(tick.value) < 1 + 1e-6);
            if (!tick.label.empty()) labels.push_back(tick.label);
        }
        CHECK(labels.size() >= 2);
        std::sort(labels.begin(), labels.end());
        CHECK(std::adjacent_find(labels.begin(), labels.end()) == labels.end());
    };
    check(0.057, 0.065);
    check(0.00713, 0.00761);
    for (double from = 1e-12; from < 1e12; from *= 1.7)
        for (const double ratio : {1., 1 + 1e-12, 1.001, 1.04, 1.1, 1.3, 2., 3.3, 9., 20., 99., 101., 1e4, 1e9})
            check(from, from * ratio);
}

TEST_CASE("numbers for people do not follow the locale of the host", "[io][report][deep]") {
    const Temporary_directory directory;
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) {  // few machines have it, so it is generated
        const std::string made = (directory.path() / "de_DE.UTF-8").string();
        if (std::system(("localedef -i de_DE -f UTF-8 " + made + " >/dev/null 2>&1").c_str()) == 0) {
            ::setenv("LOCPATH", directory.path().c_str(), 1);
            (void)std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
            ::unsetenv("LOCPATH");
        }
    }
    const std::string word = readable(0.0125), large = readable(1.25e9), ticks = report_html(full_report());
    const double half = 0.5;
    char text[8];
    std::snprintf(text, sizeof text, "%.1f", half);
    std::setlocale(LC_NUMERIC, before.c_str());
    if (std::string(text) != "0,5") {
        WARN("no locale with a decimal comma here");
        return;
    }
    CHECK(word == readable(0.0125));
    CHECK(word == "0.0125");
    CHECK(large == readable(1.25e9));
    CHECK(ticks == report_html(full_report()));
}

TEST_CASE("A page with a film has a slider, and fetches nothing", "[report]") {
    Report report = full_report();
    CHECK_FALSE(contains(report_html(report), "type=\"range\""));
    report.film.add(0, grid(3));
    report.film.add(1, grid(4), true);
    const std::string html = report_html(report);
    CHECK(contains(html, "type=\"range\""));
    for (const char* what : {"http:", "https:", "src=", "href=", "import ", "url("}) CHECK_FALSE(contains(html, what));
}
