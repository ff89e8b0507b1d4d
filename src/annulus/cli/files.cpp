// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/files.h>
#include <annulus/cli/result_files.h>

#include <annulus/formats/input_error.h>
#include <annulus/formats/write_csv.h>
#include <annulus/formats/write_json.h>
#include <annulus/formats/write_mesh.h>
#include <annulus/formats/write_vtu.h>
#include <annulus/motion/dihedral.h>
#include <annulus/report/axis_ticks.h>
#include <annulus/report/summary.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace annulus::cli {

namespace {

/// Solid cells only: a mesh of a flat set has none.
std::vector<std::array<Index, 3>> triangles(const Audit_input<2>& in) {
    std::vector<std::array<Index, 3>> cells;
    for (const auto& c : in.cells)
        if (c[2] != none) cells.push_back(c);
    return cells;
}

/// Tolerance and theta of every vertex there is.
template <class Moving>
std::pair<std::vector<double>, std::vector<double>> vertex_fields(const Moving& dt, const Measures& m) {
    std::pair<std::vector<double>, std::vector<double>> fields;
    for (std::size_t i = 0; i < m.tolerance.size(); ++i) {
        const auto v = dt.vertex(i);
        if (v == decltype(v)()) continue;
        fields.first.push_back(m.tolerance[i]);  // infinite where nothing can fail
        fields.second.push_back(dt.theta(v));
    }
    return fields;
}

}  // namespace

std::string title_of(const Run_record& run, const std::string& step, const std::string& names) {
    return grouped(run.vertices) + " vertices, " + grouped(run.iterations) + " " + step +
           (run.iterations == 1 ? ": " : "s: ") + names;
}

void write_run(const Common_arguments& arguments, const Tracker_2& tracker, const std::string& step,
               std::optional<Picture> before, std::vector<std::string> notes, const std::string& stipples) {
    const Run_record& run = tracker.record();
    const Audit_input<2> in = tracker.triangulation().audit_input();
    const auto cells = triangles(in);
    const Measures m = tracker.triangulation().measure();
    auto [tolerance, theta] = vertex_fields(tracker.triangulation(), m);
    const std::vector<Vtu_field> fields{{"tolerance", std::move(tolerance)}, {"theta", std::move(theta)}};

    Report report;
    report.title = title_of(run, step, run.strategy);
    report.run = run;
    report.before = std::move(before);
    report.after = picture_of(tracker.triangulation(), "After " + counted(run.iterations, "iteration"));
    report.annulus_widths = tracker.widths();
    report.notes = std::move(notes);

    Result_files out(arguments, is_result, run.interrupted);
    out.write("summary.json", write_json(summary_json(run)));
    out.write("iterations.csv", write_csv(iterations_table(run)));
    out.write("final.mesh", write_mesh<2>(in.points, in.cells));
    out.write("final.vtu", write_vtu<2>(in.points, cells, fields));
    if (!stipples.empty()) out.write("stipples.svg", stipples);
    out.write("report.html", report_html(report));
    out.commit();
}

void write_run(const Common_arguments& arguments, const Tracker_3& tracker, const std::string& step, const Mesh_3& mesh,
               bool domain, std::optional<Picture> before, std::optional<Picture> after,
               std::vector<std::string> notes) {
    const Run_record& run = tracker.record();
    const Moving_delaunay_3& dt = tracker.triangulation();
    const Audit_input<3> in = dt.audit_input();  // the simplices of a flat set, if it is one
    const auto& cell = mesh.cells().vertex;
    std::vector<std::array<Index, 4>> inside;
    std::vector<std::int64_t> flag;
    std::vector<double> least_angle;
    for (std::size_t c = 0; c < cell.size(); ++c) {
        flag.push_back(mesh.inside()[c] != 0 ? 1 : 0);
        if (mesh.inside()[c] != 0) inside.push_back(cell[c]);
        double most = -1;  // the largest cosine; a facet without area is an angle of 0
        const auto x = [&](std::size_t i) { return in.points[static_cast<std::size_t>(cell[c][i])]; };
        for (const double cosine : dihedral_cosines(x(0), x(1), x(2), x(3)))
            most = std::max(most, std::isnan(cosine) ? 1.0 : std::min(cosine, 1.0));
        least_angle.push_back(std::acos(most) * 180 / std::numbers::pi);
    }
    const Measures m = dt.measure();
    auto [tolerance, theta] = vertex_fields(dt, m);
    std::vector<Vtu_field> point_fields{{"tolerance", std::move(tolerance)}, {"theta", std::move(theta)}};
    std::vector<Vtu_field> cell_fields{{"dihedral_min", std::move(least_angle)}};
    const auto facets = domain ? surface_facets(mesh.cells(), mesh.inside()) : std::vector<std::array<Index, 3>>();
    if (domain) {
        std::vector<std::int64_t> boundary(in.points.size(), 0);
        for (const auto& facet : facets)
            for (const Index v : facet) boundary[static_cast<std::size_t>(v)] = 1;
        point_fields.push_back({"boundary", std::move(boundary)});
        cell_fields.push_back({"domain", std::move(flag)});
    }

    Report report;
    report.title = title_of(run, step, run.strategy);
    report.run = run;
    report.before = std::move(before);
    report.after = std::move(after);
    report.annulus_widths = tracker.widths();
    report.notes = std::move(notes);

    Result_files out(arguments, is_result, run.interrupted);
    out.write("summary.json", write_json(summary_json(run)));
    out.write("iterations.csv", write_csv(iterations_table(run)));
    if (domain) {
        out.write("dihedral.csv", write_csv(dihedral_table(run)));
        out.write("domain.mesh", write_part(in.points, inside, facets));
    }
    out.write("final.mesh", write_mesh<3>(in.points, cell.empty() ? in.cells : cell));
    out.write("final.vtu", write_vtu<3>(in.points, cell, point_fields, cell_fields));
    out.write("report.html", report_html(report));
    out.commit();
}

void say_interrupted(const Common_arguments& a, std::uint64_t done_steps, std::uint64_t steps) {
    std::fprintf(stderr, "annulus: interrupted after %llu of %llu steps; what was done is in %s\n",
                 static_cast<unsigned long long>(done_steps), static_cast<unsigned long long>(steps),
                 partial(a.output).c_str());
}

template <class Moving>
void print_summary(const Tracker<Moving>& tracker) {
    const Run_record& r = tracker.record();
    const auto asked = static_cast<double>(r.moves.asked > 0 ? r.moves.asked : 1);
    const auto percent = [&](std::uint64_t n) { return 100.0 * static_cast<double>(n) / asked; };
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%llu vertices, %llu iterations, strategy %s, %s tolerances\n", count(r.vertices), count(r.iterations),
                r.strategy.c_str(), r.tolerance.c_str());
    std::printf("triangulation  %.3f s (%.1f ns a vertex and step), motion %.3f s, total %.3f s\n",
                r.seconds.triangulation, r.moves.asked ? r.seconds.triangulation / asked * 1e9 : 0.0, r.seconds.motion,
                r.seconds.total);
    std::printf(
        "moves          within tolerance %.3f %%, kept in place %.3f %%, flipped %.3f %%, reinserted %.4f %%, "
        "rebuilt %.3f %%\n",
        percent(r.moves.within_tolerance), percent(r.moves.kept_in_place), percent(r.moves.flipped),
        percent(r.moves.reinserted), percent(r.moves.rebuilt));
    if (r.mesh_before && !r.steps.empty() && r.steps.back().mesh) {
        const Mesh_step &a = *r.mesh_before, &b = *r.steps.back().mesh;
        std::printf(
            "mesh           cells %llu -> %llu, slivers %llu -> %llu, least dihedral angle %.2f -> %.2f degrees, "
            "%.1f %% locked\n",
            count(a.cells), count(b.cells), count(a.slivers), count(b.slivers), a.dihedral_min, b.dihedral_min,
            100.0 * static_cast<double>(b.locked) / static_cast<double>(std::max<std::uint64_t>(b.vertices, 1)));
    }
    std::printf("certificates   %llu decided: filter %llu, interval %llu, exact %llu\n", count(r.arithmetic.total()),
                count(r.arithmetic.filter), count(r.arithmetic.interval), count(r.arithmetic.exact));
    std::printf("memory         %.1f MB at the peak\n", static_cast<double>(r.memory_peak_bytes) / 1e6);
    if (r.audit.checked == 0) {
        std::printf("audit          none\n");
    } else if (r.audit.failed == 0) {
        std::printf("audit          %llu checked, all Delaunay\n", count(r.audit.checked));
    } else {
        std::printf("audit          %llu of %llu FAILED; first: %s\n", count(r.audit.failed), count(r.audit.checked),
                    tracker.first_fault().c_str());
    }
}

template void print_summary(const Tracker_2&);
template void print_summary(const Tracker_3&);

}  // namespace annulus::cli
