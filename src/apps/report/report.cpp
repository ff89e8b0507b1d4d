// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/audit_words.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/comparison_html.h>
#include <apps/report/face_limits.h>
#include <apps/report/finding.h>
#include <apps/report/page.h>
#include <apps/report/report.h>
#include <apps/report/report_plots.h>
#include <apps/report/run_terms.h>
#include <apps/report/summary.h>

namespace annulus::inline v1 {

namespace {

std::string memory(std::uint64_t bytes) {
    if (bytes == 0) return "unknown";
    const double value = static_cast<double>(bytes);
    return value < 1e9 ? readable(value / 1e6) + " MB" : readable(value / 1e9) + " GB";
}

/// `of` is ": NAME" where a page is about several strategies, whose processor and memory are shared.
void append_numbers(std::string& out, const Run_record& run, const std::string& of) {
    out += "<h2>The run in numbers" + escaped(of) + "</h2>\n<div class=\"numbers\"><table>\n";
    append_row(out, "vertices", grouped(run.vertices) + " <small>in " + std::to_string(run.dimension) + "D</small>");
    if (!run.input.dimension.empty()) append_row(out, "in the plane since", escaped(run.input.dimension));
    for (const auto& [what, where] : run.input.columns) append_row(out, what + " from", escaped(where));
    append_box(out, run.input.box_from, run.input.box, " at the end");
    if (run.clip)
        append_row(out, "Voronoi cells clipped to", "<span class=\"long\">" + escaped(in_words(*run.clip)) + "</span>");
    if (run.replayed) append_row(out, "frames", grouped(run.iterations + 1));
    else
        append_row(out, "iterations",
                   grouped(run.iterations - (run.finished ? 1 : 0)) + (run.finished ? " and a finish" : ""));
    append_row(out, "strategy", escaped(run.strategy));
    append_row(out, "tolerance", escaped(run.tolerance));
    append_row(out, "threads", grouped(run.threads));
    append_row(out, "seed", std::to_string(run.seed));
    if (run.mean_spacing > 0) append_row(out, "mean spacing", readable(run.mean_spacing));
    out += "</table><table>\n";
    append_row(out, "construction time", duration(run.seconds.construction));
    append_row(out, "triangulation time", duration(run.seconds.triangulation));
    append_row(out, "motion time", duration(run.seconds.motion));
    const std::string all = of.empty() ? "" : " of all strategies";
    append_row(out, "total time" + all, duration(run.seconds.total));
    append_row(out, "peak memory" + all, memory(run.memory_peak_bytes));
    append_row(out, "audits", in_words(run.audit));
    if (counts_certificates(run)) {
        const std::uint64_t decisions = run.arithmetic.total();
        append_row(out, std::string("certificates ") + decided_word(run), grouped(decisions));
        append_row(out, "by the filter", with_share(run.arithmetic.filter, decisions));
        append_row(out, "by intervals", with_share(run.arithmetic.interval, decisions));
        append_row(out, "exactly", with_share(run.arithmetic.exact, decisions));
    }
    out += "</table><table>\n";
    const Moves_record& moves = run.moves;
    append_row(out, "moves asked for", grouped(moves.asked));
    const Tested_moves of_tested = tested_moves(run);
    const std::uint64_t tested = of_tested.steps;
    // Where tests were given up, those that had passed are counted, too.
    const bool given_up = has_tolerances(run) && moves.within_tolerance > of_tested.within_tolerance;
    if (!has_tolerances(run)) append_row(out, "at rest", with_share(moves.within_tolerance, moves.asked));
    else if (tested > 0 || moves.within_tolerance > 0)
        append_row(out,
                   !given_up     ? "within tolerance, or at rest"
                   : tested == 0 ? "within tolerance until tests were given up, or at rest"
                                 : "within tolerance, also where tests were then given up, or at rest",
                   with_share(moves.within_tolerance, moves.asked));
    append_row(out, "kept in place", with_share(moves.kept_in_place, moves.asked));
    append_row(out, "flipped", with_share(moves.flipped, moves.asked));
    append_row(out, "reinserted", with_share(moves.reinserted, moves.asked));
    append_row(out, "rebuilt", with_share(moves.rebuilt, moves.asked));
    if (has_tolerances(run) && !run.steps.empty())
        append_row(out,
                   std::string(step_word(run)) + (run.finished ? "s, or finish," : "s") + " that tested tolerances",
                   tested > 0 ? with_share(tested, run.steps.size())
                   : given_up ? "none completed"
                              : "none");
    out += "</table></div>\n";
}

/// A figure with one picture, and how much of it the window shows.
void append_picture(std::string& out, const Picture& picture, const Window& window, const std::string& what,
                    std::string (*counted)(std::size_t, Dots)) {
    std::string caption = what;
    if (caption[0] >= 'a' && caption[0] <= 'z') caption[0] = static_cast<char>(caption[0] - 'a' + 'A');
    if (!window.whole)
        caption += ": the " + counted(points_in(window, picture.points), picture.dots) +
                   " in a window in the middle, of " + grouped(picture.points.size());
    append_figure(out, "", svg_triangulation(picture, window), caption + ".");
}

/// All pictures show the same window, so that they can be compared. Faces are wholly in it, unless there are too many.
Window common_window(const std::vector<const Picture*>& pictures, std::size_t most, std::size_t within) {
    std::vector<Coordinates<2>> all;
    for (const Picture* picture : pictures) all.insert(all.end(), picture->points.begin(), picture->points.end());
    const Window window = window_of(all, most * pictures.size(), within * pictures.size());
    if (!window.whole) return window;
    for (const Picture* picture : pictures) {
        for (const Face& face : picture->faces) {
            all.insert(all.end(), face.corners.begin(), face.corners.end());
            for (const auto& outline : face.more) all.insert(all.end(), outline.begin(), outline.end());
        }
        for (const auto& ring : picture->outline) all.insert(all.end(), ring.begin(), ring.end());
    }
    return window_of(all, all.size(), all.size());
}

void append_pictures(std::string& out, const Report& report) {
    std::vector<const Picture*> pictures;
    if (report.before) pictures.push_back(&*report.before);
    if (report.after) pictures.push_back(&*report.after);
    if (pictures.empty()) return;
    const bool filled = !pictures.back()->faces.empty();
    out += filled ? "<h2>The mesh, cut open</h2>\n" : "<h2>The triangulation</h2>\n";
    if (filled) out += legend_of(pictures.back()->shading);
    out += "<div class=\"panels\">\n";
    const Window window = common_window(pictures, 12000, 5000);
    for (const Picture* picture : pictures) {
        const char* const fallback = picture == (report.before ? &*report.before : nullptr) ? "Before" : "After";
        append_picture(out, *picture, window, escaped(picture->caption.empty() ? fallback : picture->caption),
                       counted_dots);
    }
    out += "</div>\n";
}

void append_cells(std::string& out, const Report& report) {
    if (report.voronoi.empty()) return;
    out += "<h2>Voronoi cells by number of neighbours</h2>\n" +
           legend_of(Shading::neighbours, white_cells(report.run)) + "<div class=\"panels\">\n";
    std::vector<const Picture*> pictures;
    for (const Picture& picture : report.voronoi) pictures.push_back(&picture);
    const Window window = common_window(pictures, most_faces, faces_in_window);
    for (const Picture& picture : report.voronoi)
        append_picture(out, picture, window, escaped(picture.caption),
                       [](std::size_t n, Dots) { return grouped(n) + (n == 1 ? " cell" : " cells"); });
    out += "</div>\n";
    const std::string caption = cells_caption(report.run);
    if (!caption.empty()) out += "<figcaption>" + escaped(caption) + "</figcaption>\n";
}

std::string regularity_caption(const Run_record& run) {
    if (!run.plane_before) return "The cells of Lloyd's iterations: where all volumes are equal, the deviation is 0.";
    return std::string("Least angles: their mean, and the least of all; 60 degrees if all triangles are equilateral.") +
           (run.plane_before->energy ? " The energy is the integral of the density times the squared distance to the "
                                       "nearest point: what Lloyd's iterations make smaller."
                                     : "");
}

void append_drawings(std::string& out, const std::vector<Drawing>& drawings) {
    if (drawings.empty()) return;
    out += "<h2>The picture and its dots</h2>\n<div class=\"panels\">\n";
    for (const Drawing& drawing : drawings) append_figure(out, drawing.heading, drawing.svg, drawing.caption);
    out += "</div>\n";
}

}  // namespace

std::string report_html(const Report& report) {
    const Run_record& run = report.run;
    std::string out = page_head(report.title, run.command);
    append_warnings(out, run.input.warnings);
    if (run.interrupted)
        out += "<p class=\"verdict bad\">The run was interrupted after " + grouped(run.iterations) + " " +
               step_word(run) + (run.iterations == 1 ? "" : "s") + (run.replayed ? " after the first" : "") +
               "; this is what it had.</p>\n";
    if (run.audit.failed > 0)
        out += "<p class=\"verdict bad\">" + grouped(run.audit.failed) + " of " + grouped(run.audit.checked) +
               (run.audit.checked == 1 ? " audit" : " audits") + " failed: the triangulation was not Delaunay.</p>\n";
    if (report.comparison) append_comparison(out, *report.comparison);
    else append_findings(out, findings(run));
    append_drawings(out, report.drawings);
    append_cells(out, report);
    append_plots(out, "How regular it became", regularity_plots(run), regularity_caption(run));
    if (report.film.empty()) append_pictures(out, report);
    else out += "<h2>The triangulation</h2>\n" + report.film.html();
    append_plots(
        out, "The mesh", mesh_plots(run),
        "All six dihedral angles, those between two faces, of every cell of the domain. A sliver has one below 10 or "
        "above 170 degrees. Pictures show cells at the cut alone. In an iteration of natural ODT (optimal Delaunay "
        "triangulation) a vertex goes to a weighted mean of the circumcentres of its cells, one on the surface along "
        "it.");
    for (const Figure& figure : report.figures) append_plots(out, figure.heading, figure.panels, figure.caption);
    // Of several strategies the page shows the iterations of the last one.
    const std::string of = report.comparison && report.comparison->runs.size() > 1 ? ": " + run.strategy : "";
    const char* const course = run.replayed ? "Displacements and tolerances" : "Convergence";
    append_plots(out, course + of, convergence_plots(report),
                 "Lengths in mean spacings: " + mean_spacing_of(run) + ".");
    const Tested_moves tested = tested_moves(run);
    const std::string word = step_word(run);
    append_plots(out, "What " + std::string(run.replayed ? "a " : "an ") + word + " costs" + of, cost_plots(run),
                 std::string(times_processor(run)
                                 ? "Times are processor time, in which pauses of the machine do not count; only the "
                                   "total time, below, is of the wall clock."
                                 : "Times are of the wall clock, which counts pauses of the machine, too.") +
                     (tested.steps > 0 && tested.steps < run.steps.size()
                          ? " Of " + grouped(run.steps.size() - (run.finished ? 1 : 0)) + " " + word + "s " +
                                (run.finished ? "and the finish " : "") + grouped(tested.steps) +
                                " tested tolerances. The others evaluated the signs of all certificates or rebuilt: "
                                "how many moves were beyond tolerance is unknown there."
                          : ""));
    append_numbers(out, run, of);
    append_run_terms(out, report);
    append_notes(out, report.notes);
    return out + page_foot();
}

}  // namespace annulus::inline v1
