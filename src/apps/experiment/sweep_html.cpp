// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sweep_files.h>

#include <apps/experiment/sweep_plots.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/certificate_terms.h>
#include <apps/report/page.h>
#include <apps/report/table.h>

#include <algorithm>
#include <map>

namespace annulus::inline v1 {

namespace {

/// A line for each file whose periodic box is ignored.
std::vector<std::string> ignored_boxes(const std::vector<Grid_point>& points) {
    std::vector<std::string> lines;
    for (const Grid_point& point : points) {
        if (!point.where.contains("ignored")) continue;
        std::string line = point.where["file"].get<std::string>() +
                           ": its periodic box is ignored: points are taken as they stand, with open boundaries";
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
    }
    return lines;
}

Table_cell share(std::uint64_t part, std::uint64_t all) {
    const double s = all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
    return {all == 0 ? "–" : part == 0 ? "0" : escaped(readable(100 * s)) + " %", s};
}

/// `open`: with columns of the paper's tolerance, which is not computed in periodic boxes.
Table_row row_of(const Grid_point& point, std::size_t number, bool open) {
    const Tally& t = point.tally;
    const std::uint64_t bicells = count(t, "bicells.total"), vertices = count(t, "vertices");
    const auto least = t.least.find("bicells.width");
    Table_row row{{std::to_string(number) + " &nbsp;" + escaped(label_of(point.where)), static_cast<double>(number)},
                  {grouped(count(t, "experiments")), static_cast<double>(count(t, "experiments"))}};
    const double each = vertices == 0 ? 0.0 : static_cast<double>(bicells) / static_cast<double>(vertices);
    row.push_back({escaped(readable(each)), each});
    for (const char* name : {"bicells.zero", "bicells.below.1e-9", "bicells.below.1e-3"})
        row.push_back(share(count(t, name), bicells));
    if (least == t.least.end()) row.push_back("–");
    else row.push_back({escaped(readable(least->second)), least->second});
    for (const char* name : {"bicells.stage.interval", "bicells.stage.exact", "bicells.not_convex"})
        row.push_back(share(count(t, name), bicells));
    if (open)
        for (const char* name : {"tolerance.paper_above_exact", "tolerance.paper_unsound"})
            row.push_back(share(count(t, name), t.counts.contains(name) ? vertices : 0));  // there is none in a box
    row.push_back({grouped(count(t, "flat")), static_cast<double>(count(t, "flat"))});
    return row;
}

/// Grid points are added by dimension, those in periodic boxes apart.
struct Space {
    int dimension = 2;
    bool periodic = false;
    [[nodiscard]] std::string words() const {
        return std::string(periodic ? "in periodic boxes " : "") + "in " + std::to_string(dimension) + "D";
    }
    friend auto operator<=>(const Space&, const Space&) = default;
};

/// What the placements of one space have.
std::string finding(const Space& space, const Tally& t) {
    const std::uint64_t zero = count(t, "bicells.zero"), narrow = count(t, "bicells.below.1e-9");
    std::string text = space.words() + " " + none_or(zero) + " of " + grouped(count(t, "bicells.total")) +
                       " bi-cells " + (zero <= 1 ? "is" : "are") + " exactly degenerate, and " + none_or(narrow) +
                       (zero > 0 ? ", these included," : "") + (narrow <= 1 ? " is" : " are") +
                       " narrower than a billionth of a mean spacing";
    if (const auto least = t.least.find("bicells.width"); least != t.least.end())
        text += " (the least width is " + readable(least->second) + ")";
    text[0] = 'I';
    text += ". Integers had to decide " + none_or(count(t, "bicells.stage.exact")) + " of the bi-cells.";
    if (space.periodic) return text;
    return text + " The paper's tolerance is unsound at " + none_or(count(t, "tolerance.paper_unsound")) + " of " +
           grouped(count(t, "vertices")) + " vertices.";
}

}  // namespace

std::string sweep_html(const Spec& spec, const std::vector<Grid_point>& points) {
    std::string out = page_head(spec.title, "");
    append_warnings(out, ignored_boxes(points));
    std::map<Space, std::vector<Sweep_row>> of;
    std::map<Space, Tally> sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Space space{points[i].where["dimension"].get<int>(), points[i].where.contains("box")};
        of[space].push_back({i + 1, &points[i]});
        sum[space] += points[i].tally;
    }
    for (const auto& [space, tally] : sum) append_findings(out, {finding(space, tally)});
    out += "<h2>What was found</h2>\n";
    const bool open = std::any_of(sum.begin(), sum.end(), [](const auto& s) { return !s.first.periodic; });
    std::vector<Table_row> rows;
    for (const Grid_point& point : points) rows.push_back(row_of(point, rows.size() + 1, open));
    std::vector<std::string> head{"grid point", "placements",  "bi-cells a vertex",    "exactly 0",   "width &lt; 1e-9",
                                  "&lt; 1e-3",  "least width", "decided by intervals", "by integers", "not convex"};
    if (open) head.insert(head.end(), {"paper above exact", "paper unsound"});
    head.emplace_back("flat");
    append_table(out, head, rows, true);
    out +=
        std::string(
            "<figcaption>Each row adds the placements that differ in their seed only. Widths in mean "
            "spacings. Shares are of bi-cells") +
        (open ? ", but in the two columns on the paper of vertices: where its tolerance is above the distance to the "
                "nearest placement at which a certificate is exactly 0, and where it is unsound."
              : ".") +
        " Flat: placements whose points do not span the space, of which nothing is counted.</figcaption>\n";
    Tally all;
    for (const auto& [space, tally] : sum) {
        const std::string where = sum.size() > 1 ? " " + space.words() : "";
        append_distributions(out, of[space], "Distributions" + where);
        append_stages(out, tally, "Which arithmetic decides" + where, space.periodic);
        all += tally;
    }
    out += "<h2>The sweep in numbers</h2>\n<div class=\"numbers\"><table>\n";
    append_row(out, "trials", grouped(spec.trials.size()));
    append_row(out, "placements, of which a trial with a motion or frames has several",
               grouped(count(all, "experiments")));
    append_row(out, "vertices", grouped(count(all, "vertices")));
    append_row(out, "bi-cells", grouped(count(all, "bicells.total")));
    append_row(out, "seed of the sweep, from which each trial has its own", std::to_string(spec.seed));
    out += "</table></div>\n";
    const auto has = [&sum](int dimension, bool periodic) { return sum.contains({dimension, periodic}); };
    append_degeneracy_terms(
        out, {has(2, false) || has(2, true), has(3, false) || has(3, true), open, has(2, true) || has(3, true)});
    return out + page_foot();
}

}  // namespace annulus::inline v1
