// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/reproduction.h>

#include <annulus/version.h>
#include <apps/formats/markup.h>
#include <apps/formats/write_json.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/page.h>
#include <apps/report/shades.h>
#include <apps/report/table.h>
#include <apps/reproduction/benchmark_statistics.h>
#include <apps/reproduction/claim_findings.h>
#include <apps/reproduction/claim_words.h>
#include <apps/reproduction/claims.h>
#include <apps/reproduction/figures.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

std::string link(const std::string& file, const std::string& words) {
    return "<a href=\"" + escaped(file) + "\">" + escaped(words) + "</a>";
}

/// What every page of a quick run says beside its first sentence.
std::string warning_of(const Reproduction_size& size) {
    return size.quick ? "<p class=\"verdict\">A quick run: few points, few iterations. Verdicts are of this run, and "
                        "mean little; the paper's runs have 1,000 iterations.</p>\n"
                      : "";
}

/// By what the pages were made, when and where. HTML.
std::string origin_of(const Reproduction& r) {
    return "annulus " ANNULUS_VERSION_STRING ", " + (r.date.empty() ? "" : escaped(r.date) + ", ") +
           escaped(r.machine) + ".";
}

std::string page_html(const Page_content& page, const std::vector<Claim>& claims, const Reproduction& r) {
    std::string out = page_head(page.title, "");
    append_findings(out, findings_of_page(page.name, claims));
    out += "<p>Made by " + origin_of(r) + "</p>\n" + warning_of(r.size);
    out += "<p>" + link("index.html", "All claims") + "</p>\n<p>" + escaped(page.about) + "</p>\n";
    if (page.sections.empty()) out += "<p class=\"verdict\">Nothing was run for it.</p>\n";
    for (const auto& [heading, panels] : page.sections) {
        out += "<h2>" + escaped(heading) + "</h2>\n";
        if (std::any_of(panels.begin(), panels.end(), [](const Panel& panel) { return panel.cut; }))
            out += legend_of(Shading::angles);
        out += "<div class=\"panels\">\n";
        for (const Panel& panel : panels) {
            std::string caption = escaped(panel.caption);
            for (const std::string& csv : panel.csv) caption += (caption.empty() ? "" : " ") + link(csv, csv);
            append_figure(out, panel.heading, panel.svg, caption);
        }
        out += "</div>\n";
    }
    if (page.name == "unsound")
        for (const auto& [name, table] : page.tables)
            if (name == "unsound.csv" && !table.rows.empty()) {
                out += "<h2>Every run</h2>\n";
                std::vector<Table_row> rows;
                for (const auto& cells : table.rows) {
                    Table_row row;
                    for (const Csv_cell& cell : cells) {
                        if (const auto* text = std::get_if<std::string>(&cell)) row.emplace_back(escaped(*text));
                        else if (const auto* n = std::get_if<std::uint64_t>(&cell))
                            row.emplace_back(grouped(*n), static_cast<double>(*n));
                        else row.emplace_back("–");
                    }
                    rows.push_back(std::move(row));
                }
                std::vector<std::string> header = table.header;
                for (std::string& h : header) std::replace(h.begin(), h.end(), '_', ' ');
                append_table(out, header, rows);
                out += "<p>" + link(name, name) + "</p>\n";
            }
    const bool any = std::any_of(claims.begin(), claims.end(), [&](const Claim& c) { return c.figure == page.name; });
    if (any) out += "<h2>Claims</h2>\n<ul>\n";
    for (const Claim& c : claims)
        if (c.figure == page.name)
            out += "<li>" + escaped(c.statement) + " <strong>" + name_of(c.verdict) + "</strong></li>\n";
    if (any) out += "</ul>\n";
    append_notes(out, page.notes);
    return out + page_foot();
}

std::string claim_table(const std::vector<Claim>& claims) {
    std::string out =
        "<div class=\"scroll\"><table class=\"claims\">\n<thead><tr><th>The paper</th><th>Its number</th><th>Here, "
        "under its algorithm</th><th>Here, under ours</th><th>Verdict</th></tr></thead>\n<tbody>\n";
    for (const Claim& c : claims) {
        const char* mark = c.verdict == Claim_verdict::wrong || c.verdict == Claim_verdict::differs ? "bad"
                           : c.verdict == Claim_verdict::open                                       ? ""
                                                                                                    : "good";
        out += "<tr><th scope=\"row\">" + escaped(c.statement) + " <small>" + link(c.figure + ".html", c.figure) +
               "</small></th><td>" + escaped(c.paper) + "</td><td>" + escaped(c.theirs) + "</td><td>" +
               escaped(c.ours) + "</td><td><span class=\"" + mark + "\">" + name_of(c.verdict) + "</span> <small>" +
               escaped(c.reason) + "</small></td></tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string index_html(const Reproduction& r, const std::vector<Claim>& claims,
                       const std::vector<Page_content>& pages) {
    std::string out = page_head("Filtering Relocations on a Delaunay Triangulation, reproduced", r.command);
    append_findings(out, {counts_of_verdicts(claims)});
    out += warning_of(r.size);
    out +=
        "<p>The figures and claims of the paper of that name by P. M. M. de Castro, J. Tournois, P. Alliez and O. "
        "Devillers (2009), from runs made here: under the paper's algorithm and tolerances, and under ours.</p>\n";
    double seconds = 0, least_load = 1e9, most_load = 0;
    for (const auto& [name, benchmark] : r.benchmarks) {
        seconds += benchmark.seconds;
        least_load = std::min(least_load, benchmark.load);
        most_load = std::max(most_load, benchmark.load);
    }
    out += "<p>" + origin_of(r) + " " + grouped(r.benchmarks.size()) +
           (r.benchmarks.size() == 1 ? " run, " : " runs, ") + duration(seconds) + " by the clock; ";
    out += "load of the machine at the end of each " + range({least_load, most_load}, readable) +
           ". Seconds on these pages are those of one thread's processor, and strategies take turns, so that others "
           "delay all alike; such times still vary from run to run. Verdicts about speed rest on them, no other "
           "does.</p>\n";
    if (!r.size.surfaces)
        out +=
            "<p class=\"verdict\">Without --surfaces the sphere is the only body: man, bunny and organ are left "
            "out.</p>\n";
    if (!r.size.only.empty()) {
        std::string only;
        for (const std::string& topic : r.size.only)
            only += (only.empty() ? "" : &topic == &r.size.only.back() ? " and " : ", ") + topic;
        out += "<p class=\"verdict\">Only " + escaped(only) + (r.size.only.size() == 1 ? " was" : " were") +
               " requested.</p>\n";
    }
    out +=
        "<h2>Claims</h2>\n<p>" + escaped(claim_rules()) + "</p>\n" + claim_table(claims) + "<h2>Figures</h2>\n<ul>\n";
    for (const Page_content& page : pages)
        out += "<li>" + link(page.name + ".html", page.title) + (page.sections.empty() ? " (not run)" : "") + "</li>\n";
    out += "</ul>\n<p>Numbers: " + link("reproduction.json", "reproduction.json") + ", " +
           link("claims.csv", "claims.csv") + ", and a table beside each figure.</p>\n";
    out += "<h2>Runs</h2>\n";
    std::vector<Table_row> rows;
    for (const auto& [name, benchmark] : r.benchmarks)
        rows.push_back({escaped(benchmark.title),
                        {grouped(benchmark.vertices), static_cast<double>(benchmark.vertices)},
                        {grouped(benchmark.steps), static_cast<double>(benchmark.steps)},
                        {duration(benchmark.seconds), benchmark.seconds},
                        {readable(benchmark.load), benchmark.load}});
    append_table(out, {"run", "vertices", "iterations", "took", "load"}, rows);
    return out + page_foot();
}

nlohmann::ordered_json json_of(const Reproduction& r, const std::vector<Claim>& claims) {
    nlohmann::ordered_json out{{"command", r.command},  {"version", ANNULUS_VERSION_STRING},
                               {"machine", r.machine},  {"date", r.date},
                               {"quick", r.size.quick}, {"seed", r.size.seed}};
    for (const Claim& c : claims)
        out["claims"].push_back({{"figure", c.figure},
                                 {"statement", c.statement},
                                 {"paper", c.paper},
                                 {"paper_algorithm", c.theirs},
                                 {"annulus", c.ours},
                                 {"verdict", name_of(c.verdict)},
                                 {"reason", c.reason}});
    out["runs"] = nlohmann::ordered_json::object();
    for (const auto& [name, benchmark] : r.benchmarks) {
        nlohmann::ordered_json run{{"title", benchmark.title},
                                   {"dimension", benchmark.dimension},
                                   {"vertices", benchmark.vertices},
                                   {"iterations", benchmark.steps},
                                   {"spacing", benchmark.spacing},
                                   {"load", benchmark.load},
                                   {"motion_seconds", benchmark.motion_seconds}};
        for (const Contender_record& x : benchmark.contenders) {
            std::uint64_t asked = 0, failed = 0;
            for (const std::uint64_t n : x.asked) asked += n;
            for (const std::uint64_t n : x.failed) failed += n;
            run["strategies"][x.name] = {{"seconds", total_seconds(benchmark, x.name)},
                                         {"steps_timed", x.step.size()},
                                         {"precompute_seconds", x.precompute_seconds},
                                         {"moves", asked},
                                         {"failed", failed},
                                         {"audits", x.audits},
                                         {"audits_failed", x.audits_failed},
                                         {"switched_at", x.switched_at},
                                         {"sampling_seconds", x.sampling_seconds}};
            if (!x.streaks.empty()) run["strategies"][x.name]["failed_in_a_row"] = x.streaks;
        }
        for (const auto& s : benchmark.stabilities)
            run["rounding"].push_back({{"before_step", s.step},
                                       {"bicells", s.bicells},
                                       {"above_exact", s.above},
                                       {"theta_edges", s.edges},
                                       {"counts", s.counts},
                                       {"median_relative_error", s.median},
                                       {"largest_relative_error", s.most}});
        for (const auto& o : benchmark.operations)
            run["operations"].push_back({{"before_step", o.step},
                                         {"vertices", o.vertices},
                                         {"removal_seconds", o.removal},
                                         {"insertion_seconds", o.insertion}});
        for (const auto& g : benchmark.degeneracies)
            run["degeneracy"].push_back({{"before_step", g.step},
                                         {"bicells", g.bicells},
                                         {"non_convex", g.non_convex},
                                         {"thresholds", g.thresholds},
                                         {"below", g.below},
                                         {"paper_above_exact", g.paper_above},
                                         {"paper_unsound", g.paper_unsound},
                                         {"unsound_certificates", g.unsound_certificates},
                                         {"theta_hundredth", g.theta_hundredth},
                                         {"theta_median", g.theta_median}});
        for (const auto& a : benchmark.adversaries)
            run["adversary"].push_back({{"before_step", a.step},
                                        {"attacked", a.certificates},
                                        {"broken", a.broken},
                                        {"accepted", a.accepted},
                                        {"audited", a.audited},
                                        {"refuted", a.refuted}});
        out["runs"][name] = std::move(run);
    }
    return out;
}

}  // namespace

std::vector<Result_file> reproduction_files(const Reproduction& r) {
    const std::vector<Claim> claims = claims_of(r);
    const std::vector<Page_content> pages = reproduction_pages(r);
    std::vector<Result_file> out{{"reproduction.json", write_json(json_of(r, claims))},
                                 {"index.html", index_html(r, claims, pages)}};
    Csv_table table{{"figure", "claim", "paper", "paper_algorithm", "annulus", "verdict", "reason"}, {}};
    for (const Claim& c : claims)
        table.rows.push_back({c.figure, c.statement, c.paper, c.theirs, c.ours, name_of(c.verdict), c.reason});
    out.push_back({"claims.csv", write_csv(table)});
    for (const Page_content& page : pages) {
        out.push_back({page.name + ".html", page_html(page, claims, r)});
        for (const auto& [name, content] : page.tables) out.push_back({name, write_csv(content)});
    }
    return out;
}

}  // namespace annulus::inline v1
