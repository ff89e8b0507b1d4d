// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/certificate_terms.h>
#include <apps/report/cumulative_curve.h>
#include <apps/report/degeneracy_report.h>
#include <apps/report/page.h>
#include <apps/report/table.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Columns = std::vector<std::string>;  ///< headings, HTML

std::string relative_number(double x) { return x == 0 ? "0" : escaped(readable(x)); }

std::string threshold_head(const Threshold& t) {
    if (t.name != "ulp") return "&lt; " + escaped(t.name);
    return "&lt; 1 ulp <small>(" + relative_number(t.relative) + ")</small>";
}

/// On a logarithmic scale of percentages: from the share of one sample on.
Series cumulative(std::string name, const Distribution& d) {
    const Histogram& h = d.histogram;
    return cumulative_curve(std::move(name), {h.edges(), h.counts(), h.underflow(), h.total()}, d.quantiles,
                            100 / static_cast<double>(h.total()));
}

Plot cumulative_plot(std::string title, std::string x,
                     const std::vector<std::pair<std::string, const Distribution*>>& of) {
    Plot plot;
    plot.title = std::move(title);
    plot.x = {std::move(x), Scale::log10};
    plot.y = {"share below, percent", Scale::log10, {}, 100.};
    // What is all exactly 0 has no place on a logarithmic scale.
    for (const auto& [name, d] : of)
        if (d->histogram.total() > d->histogram.underflow()) plot.series.push_back(cumulative(name, *d));
    give_room(plot);
    return plot;
}

Plot histogram_plot(std::string title, std::string x, Scale scale,
                    const std::vector<std::pair<std::string, const Distribution*>>& of) {
    Plot plot;
    plot.title = std::move(title);
    plot.x = {std::move(x), scale};
    plot.y = {"share, percent"};
    for (const auto& [name, d] : of)
        if (d->histogram.total() > d->histogram.underflow())
            plot.series.push_back(histogram_series(name, d->histogram));
    return plot;
}

struct Certificate_names {
    const char* cell;
    const char* ridge;
    const char* bicell;
};
Certificate_names words(int dimension) {
    if (dimension == 2) return {"triangles", "hull vertices", "bi-cells (empty circles)"};
    return {"tetrahedra", "hull edges", "bi-cells (empty spheres)"};
}

void append_counts(std::string& out, const Degeneracy& d) {
    Columns head{"", "number", "exactly 0"};
    for (const Threshold& t : d.thresholds) head.push_back(threshold_head(t));
    std::vector<Table_row> rows;
    const auto add = [&](const std::string& name, std::uint64_t total, std::uint64_t zero,
                         const std::vector<std::uint64_t>& below) {
        rows.push_back({name, grouped(total), with_share(zero, total)});
        for (const std::uint64_t n : below) rows.back().push_back(with_share(n, total));
    };
    const auto add_widths = [&](const std::string& name, const Width_counts& c) {
        add(name, c.total, c.zero, c.below);
    };
    const Certificate_names w = words(d.dimension);
    add_widths(w.bicell, d.bicells.least);
    if (d.dimension == 3) add_widths("&nbsp; the standard annulus alone", d.standard);
    add_widths(w.cell, d.cells.least);
    if (!d.periodic) add_widths(w.ridge, d.ridges.least);
    add("vertices (tolerance)", d.vertices.total, d.vertices.zero, d.vertices.below);
    out += "<h2>Degenerate, exactly and nearly</h2>\n";
    append_table(out, head, rows);
    out +=
        "<figcaption>Widths of annuli and of slabs, in mean spacings; of a vertex the tolerance, which is half a "
        "width. ";
    out += d.dimension == 2 ? "" : "The width of a bi-cell is the least of its four annuli. ";
    out +=
        "Every count is certified: a width is compared as a real number, with integers where intervals do not tell. ";
    out += d.periodic ? "One ulp is the spacing of the box's grid, to which points are rounded"
                      : "One ulp is the distance of doubles at the largest coordinate";
    out += ": a width below it may be the work of rounding.";
    if (d.periodic)
        out +=
            " In a periodic box there is no hull. Where several images of a vertex are in a bi-cell or cell, they "
            "count as points that move apart from one another: 0 is 0, and other widths and tolerances are lower "
            "bounds.";
    out += "</figcaption>\n";
}

void append_quantiles(std::string& out, const Degeneracy& d) {
    Columns head{""};
    for (const double p : Distribution::probabilities)
        head.push_back(p == 0 ? "least" : p == 1 ? "greatest" : p == 0.5 ? "median" : readable(100 * p) + " %");
    std::vector<Table_row> rows;
    const auto add = [&](const std::string& name, const Distribution& q) {
        if (q.quantiles.empty()) return;
        rows.push_back({name});
        for (const double x : q.quantiles) rows.back().push_back(relative_number(x));
    };
    const Certificate_names w = words(d.dimension);
    add(std::string("width of ") + w.bicell, d.bicells.least.width);
    if (d.dimension == 3) add("width of standard annuli", d.standard.width);
    add(std::string("width of ") + w.cell, d.cells.least.width);
    add(std::string("width at ") + w.ridge, d.ridges.least.width);
    add("certified tolerance", d.vertices.certified);
    add("the paper's tolerance", d.vertices.paper);
    add("theta, radians", d.theta);
    out += "<h2>Quantiles</h2>\n";
    append_table(out, head, rows);
    out += "<figcaption>Lengths in mean spacings.</figcaption>\n";
}

void append_stages(std::string& out, const Degeneracy& d) {
    std::vector<Table_row> rows;
    const auto add = [&](const std::string& name, const Stage_counts& s) {
        rows.push_back({name, grouped(s.total()), with_share(s.filter, s.total()), with_share(s.interval, s.total()),
                        with_share(s.exact, s.total())});
    };
    const Certificate_names w = words(d.dimension);
    add(w.bicell, d.bicells.arithmetic);
    add(w.cell, d.cells.arithmetic);
    if (!d.periodic) add(w.ridge, d.ridges.arithmetic);
    add("convexity of bi-cells", d.convexity);
    out += "<h2>What arithmetic decides</h2>\n";
    append_table(out, {"", "decisions", "filter", "intervals", "exact"}, rows);
    out +=
        "<figcaption>What decided the sign and the tolerance of each certificate, as in a run: doubles with a proved "
        "error bound (filter), intervals, or integers (exact).</figcaption>\n";
}

void append_convexity(std::string& out, const Degeneracy& d) {
    append_row(out, "bi-cells that are not convex", with_share(d.non_convex, d.bicells.least.total));
    append_row(out, d.dimension == 2 ? "bi-cells with three collinear points" : "bi-cells with four coplanar points",
               with_share(d.flat, d.bicells.least.total));
}

void append_paper(std::string& out, const Degeneracy& d) {
    if (d.periodic) {
        out += "<h2>Convexity</h2>\n<div class=\"numbers\"><table>\n";
        append_convexity(out, d);
        out += "</table></div>\n";
        return;
    }
    const Vertex_counts& v = d.vertices;
    out += "<h2>The paper's tolerance</h2>\n<div class=\"numbers\"><table>\n";
    append_row(out, "vertices at which it is unsound", with_share(v.paper_unsound, v.total));
    append_row(out, "vertices at which it is above the distance to degeneracy",
               with_share(v.paper_above_exact, v.total));
    append_row(out, "certificates that can fail within it", grouped(v.unsound_certificates));
    append_convexity(out, d);
    out += "</table></div>\n<figcaption>What unsound means is under Terms, at the end.";
    if (d.dimension == 2) out += " In 2D the paper's tolerance is right: the first and the third number are 0.";
    out += "</figcaption>\n";
}

void append_numbers(std::string& out, const Degeneracy_record& r) {
    out += "<h2>The points in numbers</h2>\n";
    if (!r.input.columns.empty()) out += "<p>" + escaped(listed(r.input.columns)) + ".</p>\n";
    out += "<div class=\"numbers\"><table>\n";
    append_row(out, "vertices", grouped(r.vertices) + " <small>in " + std::to_string(r.dimension) + "D</small>");
    append_row(out, "duplicates merged", grouped(r.points - r.vertices));
    append_row(out,
               r.affine_dimension == 3   ? "tetrahedra"
               : r.affine_dimension == 2 ? "triangles"
                                         : "edges",
               grouped(r.simplices));
    append_box(out, r.input.box_from, r.input.box, "");
    out += "</table><table>\n";
    if (r.measured) {
        append_row(out, "mean spacing", relative_number(r.measured->spacing));
        append_row(out, r.measured->periodic ? "grid of the box" : "ulp of the largest coordinate",
                   relative_number(r.measured->resolution));
    }
    append_row(out, "triangulation time", duration(r.seconds_triangulation));
    append_row(out, "analysis time", duration(r.seconds_analysis));
    out += "</table></div>\n";
}

/// Whether all have one width, to three digits, that is not 0: a histogram is a bar then.
bool one_width(const Width_counts& c) {
    const auto& q = c.width.quantiles;
    return !q.empty() && c.zero == 0 && readable(q.front()) == readable(q.back());
}

/// What the histogram of bi-cells has no place for, or why there is none; text.
std::string on_histogram(const Width_counts& c) {
    if (one_width(c))
        return (c.total == 1 ? std::string(" The bi-cell has") : " All " + grouped(c.total) + " bi-cells have") +
               " the width " + readable(c.width.quantiles.front()) + ", which needs no histogram.";
    if (c.zero == 0 || c.zero == c.total) return {};
    return " The histogram of widths leaves out " + grouped(c.zero) + " of the " + grouped(c.total) +
           " bi-cells: their width is exactly 0. Shares are of all.";
}

/// How many bi-cells are degenerate, how large most tolerances are, and where that of the paper is unsound.
std::vector<std::string> findings(const Degeneracy& d) {
    const Width_counts& c = d.bicells.least;
    if (c.total == 0) return {};
    std::string first = (c.zero == 0 ? "None" : grouped(c.zero)) + " of the " + grouped(c.total) + " bi-cells" +
                        (c.zero <= 1 ? " is exactly degenerate" : " are exactly degenerate");
    if (c.total == 1) first = std::string("The only bi-cell is ") + (c.zero == 1 ? "" : "not ") + "exactly degenerate";
    const auto& widths = d.bicells.least.width.quantiles;
    if (c.zero == 0 && !widths.empty())
        first += ": the narrowest annulus is " + readable(widths.front()) + " mean spacings wide";
    const auto& tolerances = d.vertices.certified.quantiles;
    const auto half = static_cast<std::size_t>(
        std::find(Distribution::probabilities.begin(), Distribution::probabilities.end(), 0.5) -
        Distribution::probabilities.begin());
    if (half < tolerances.size())
        first += d.vertices.zero == d.vertices.total ? ". All vertices have a certified tolerance of 0"
                 : tolerances[half] == 0             ? ". Half of the vertices or more have a certified tolerance of 0"
                                                     : ". Half of the vertices have a certified tolerance of " +
                                               readable(tolerances[half]) + " mean spacings or more";
    if (d.periodic) return {first + "."};
    const std::uint64_t unsound = d.vertices.paper_unsound;
    return {first + (unsound == 0 ? ". The paper's tolerance is sound at all vertices."
                                  : ". The paper's tolerance is unsound at " + grouped(unsound) +
                                        (unsound == 1 ? " vertex." : " vertices."))};
}

}  // namespace

std::string degeneracy_html(const Degeneracy_record& r) {
    const std::string name = r.file.substr(r.file.find_last_of('/') + 1);
    std::string out = page_head(
        "Degeneracy of " + grouped(r.vertices) + (r.vertices == 1 ? " point: " : " points: ") + name, r.command);
    append_warnings(out, r.input.warnings);
    if (!r.measured) {
        out += "<p class=\"verdict\">All points lie ";
        out += r.affine_dimension == 2 ? "in a plane" : "on a line";
        out += ": there are no cells of dimension " + std::to_string(r.dimension) + ", and nothing to measure.</p>\n";
        append_numbers(out, r);
        return out + page_foot();
    }
    const Degeneracy& d = *r.measured;
    append_findings(out, findings(d));
    append_counts(out, d);
    append_paper(out, d);
    const Certificate_names w = words(d.dimension);
    std::vector<std::pair<std::string, const Distribution*>> widths{{"bi-cells", &d.bicells.least.width}};
    if (d.dimension == 3) widths.emplace_back("standard annuli", &d.standard.width);
    widths.emplace_back(w.cell, &d.cells.least.width);
    widths.emplace_back(w.ridge, &d.ridges.least.width);
    const std::vector<std::pair<std::string, const Distribution*>> tolerances{{"certified", &d.vertices.certified},
                                                                              {"paper", &d.vertices.paper}};
    std::vector<Plot> plots{cumulative_plot("Widths", "width (mean spacings)", widths),
                            cumulative_plot("Tolerances of vertices", "tolerance (mean spacings)", tolerances)};
    if (!one_width(d.bicells.least))
        plots.push_back(histogram_plot("Widths of bi-cells", "width (mean spacings)", Scale::log10, {widths.front()}));
    plots.push_back(histogram_plot("Theta", "theta (radians)", Scale::linear, {{"bi-cells", &d.theta}}));
    std::erase_if(plots, [](const Plot& plot) { return plot.series.empty(); });
    append_plots(out, "Distributions", plots,
                 "A cumulative curve begins where the samples on its scale begin, at the share of what is narrower or "
                 "exactly 0; there is none where all are exactly 0." +
                     on_histogram(d.bicells.least));
    append_quantiles(out, d);
    append_stages(out, d);
    append_numbers(out, r);
    append_degeneracy_terms(out, {d.dimension == 2, d.dimension == 3, !d.periodic, d.periodic});
    return out + page_foot();
}

}  // namespace annulus::inline v1
