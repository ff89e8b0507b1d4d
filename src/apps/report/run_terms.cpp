// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/run_terms.h>

#include <apps/report/certificate_terms.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

bool in_box(const Run_record& run) { return !run.input.box.empty(); }
/// Open boundaries without a domain: then cells are unbounded along the hull.
bool has_hull(const Run_record& run) { return run.replayed && !in_box(run) && !run.clip; }

/// What a kind of tolerance is.
std::string on_kind(const std::string& kind) {
    if (kind == "certified") return " Certified: it is a lower bound, proved in spite of rounding.";
    if (kind == "paper")
        return " Of the kind paper: from standard annuli and what keeps the hull convex alone, in plain double, not "
               "certified.";
    return " Of the kind " + kind + ": in plain double, not certified.";
}

/// Certificates and their tolerances, of which kinds, and how the runs test them.
void append_tolerances(Terms& terms, bool plane, const std::vector<Run_record>& runs) {
    const bool boxed = in_box(runs.front());
    for (Term& term : certificate_terms({plane, !plane, !boxed})) terms.push_back(std::move(term));
    std::string& tolerance = terms.back().meaning;
    std::set<std::string> kinds;
    for (const Run_record& run : runs)
        if (kinds.insert(run.tolerance).second) tolerance += on_kind(run.tolerance);
    if (boxed)
        tolerance += " Ways are relative to the box; where its shape changes, a certificate loses what it is deformed.";
    if (std::none_of(runs.begin(), runs.end(), has_tolerances)) {
        tolerance += runs.size() == 1 ? " The strategy " + runs.front().strategy + " tests no tolerances."
                                      : " These strategies test no tolerances.";
        return;
    }
    const std::string step = step_word(runs.front());
    terms.push_back({"Within tolerance",
                     "One comparison of the way of a vertex with its tolerance passed, and nothing else is computed "
                     "for the vertex. " +
                         std::string(step == "frame" ? "A " : "An ") + step +
                         " tested tolerances where they decided: not where so many moves failed that the signs of all "
                         "certificates were evaluated instead, nor where all was rebuilt."});
}

}  // namespace

std::string mean_spacing_of(const Run_record& run) {
    const bool plane = run.dimension == 2;
    return std::string(plane ? "the square root of the area" : "the cube root of the volume") + " of the " +
           (in_box(run)    ? "periodic box"
            : run.replayed ? "bounding box of the points"
                           : "domain") +
           (run.replayed ? " in the first frame, per point" : " per vertex");
}

const char* white_cells(const Run_record& run) {
    return in_box(run) ? "" : run.clip ? "cut by the clipping region" : run.replayed ? "unbounded" : "at the border";
}

std::string cells_caption(const Run_record& run) {
    if (!run.plane_before) return {};
    const std::string angle = "The least angle is that of ";
    if (in_box(run)) return "The neighbours of all vertices are counted. " + angle + "each triangle.";
    if (has_hull(run))
        return "Inner vertices are those that are not on the convex hull: their Voronoi cells are bounded. Only their "
               "neighbours are counted. " +
               angle + "each triangle, those along the hull included.";
    const std::string what = run.clip ? "clipping region" : "domain";
    return std::string("Inner vertices are those whose Voronoi cells ") +
           (run.clip ? "are wholly in the " + what : "are bounded and not cut by the border of the " + what) +
           ". Only their neighbours are counted. " + angle +
           "each triangle whose circumcentre, where three cells meet, is in the " + what + ".";
}

void append_run_terms(std::string& out, const Report& report) {
    const Run_record& run = report.run;
    const bool plane = run.dimension == 2;
    Terms terms{{"Mean spacing", "The unit of lengths: " + mean_spacing_of(run) + "."}};
    append_tolerances(
        terms, plane,
        report.comparison && !report.comparison->runs.empty() ? report.comparison->runs : std::vector{run});
    if (std::any_of(run.steps.begin(), run.steps.end(), [](const auto& s) { return s.mesh && s.mesh->locked > 0; }))
        terms.push_back({"Locked",
                         "A vertex that rests in an iteration, because all dihedral angles of its cells are between "
                         "the angle of --lock and 180 degrees minus it."});
    terms.push_back(
        {"Flip",
         plane ? "The edge that two triangles share is replaced by the other diagonal of their quadrilateral."
               : "Two tetrahedra that share a triangle are replaced by three around an edge, or the reverse, or four "
                 "around an edge by four around another."});
    terms.push_back({"Kept in place", "A vertex that had to be checked, and around which no cell changed."});
    terms.push_back({"Flipped", "A vertex around which flips were made."});
    terms.push_back({"Reinserted", "A vertex that was removed and inserted again."});
    terms.push_back({"Rebuilt", "A vertex of a triangulation that was built again from all points."});
    append_terms(out, terms);
}

}  // namespace annulus::inline v1
