// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/files.h>

#include <apps/cli/counted_vertices.h>
#include <apps/cli/input.h>
#include <apps/cli/result_files.h>
#include <apps/cli/solid_mesh.h>

#include <apps/formats/input_error.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_json.h>
#include <apps/formats/write_mesh.h>
#include <apps/motion/dihedral.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/summary.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// The last mesh, with the fields of its points.
template <class Moving>
struct Final_mesh {
    std::vector<Coordinates<Moving::dimension_of_space>> points;
    std::vector<typename Run_page<Moving>::Cell> cells;  ///< of a flat set the simplices of lower dimension
    std::vector<Vtu_field> fields;
};

/// With tolerance and theta of every vertex, without free indices.
template <int d>
Final_mesh<Moving_mesh<d>> final_mesh(const Moving_mesh<d>& dt) {
    const Measures m = dt.measure();
    std::pair<std::vector<double>, std::vector<double>> fields;
    for (std::size_t i = 0; i < m.tolerance.size(); ++i) {
        const auto v = static_cast<Index>(i);
        if (!dt.is_vertex(v)) continue;
        fields.first.push_back(m.tolerance[i]);  // infinite if nothing can fail
        fields.second.push_back(dt.theta(v));
    }
    Audit_input<d> in = dt.audit_input();
    return {std::move(in.points),
            std::move(in.cells),
            {{"tolerance", std::move(fields.first)}, {"theta", std::move(fields.second)}}};
}

/// With images of points where cells are across the sides of the box, and the number of the point of each: of the
/// first ones the place in the order of ids, from 0.
template <int d>
Final_mesh<Boxed_mesh<d>> final_mesh(const Boxed_mesh<d>& dt) {
    Solid_mesh<d> mesh = solid_mesh(dt);
    std::vector<std::int64_t> number(mesh.vertex.begin(), mesh.vertex.end());
    return {std::move(mesh.points), std::move(mesh.cells), {{"vertex", std::move(number)}}};
}

/// The least dihedral angle of each cell, in degrees.
Vtu_field least_angles(const std::vector<Coordinates<3>>& points, const std::vector<std::array<Index, 4>>& cells) {
    std::vector<double> angles;
    for (const auto& cell : cells) {
        double most = -1;  // the largest cosine; a facet without area gives an angle of 0
        const auto x = [&](std::size_t i) { return points[static_cast<std::size_t>(cell[i])]; };
        for (const double cosine : dihedral_cosines(x(0), x(1), x(2), x(3)))
            most = std::max(most, std::isnan(cosine) ? 1.0 : std::min(cosine, 1.0));
        angles.push_back(std::acos(most) * 180 / std::numbers::pi);
    }
    return {"dihedral_min", std::move(angles)};
}

}  // namespace

std::string steps_of(const Run_record& run, const std::string& step) {
    const std::uint64_t n = run.iterations - (run.finished ? 1 : 0);
    return grouped(n) + " " + step + (n == 1 ? "" : "s") + (run.finished ? " and a finish" : "");
}

std::string title_of(const Run_record& run, const std::string& step, const std::string& names) {
    return grouped(run.vertices) + (run.vertices == 1 ? " vertex, " : " vertices, ") +
           (run.replayed ? grouped(run.iterations + 1, "frame") : steps_of(run, step)) + ": " + names;
}

template <class Moving>
void write_run(const Common_arguments& arguments, const Run_tracker<Moving>& tracker, Run_page<Moving> page) {
    constexpr int d = Moving::dimension_of_space;
    const Run_record& run = tracker.record();
    const Final_mesh<Moving> in = final_mesh(tracker.triangulation());
    if (page.cells.empty())
        std::copy_if(in.cells.begin(), in.cells.end(), std::back_inserter(page.cells),
                     [](const auto& c) { return c[d] != none; });
    std::vector<Vtu_field> point_fields = in.fields, cell_fields;
    if constexpr (d == 3) cell_fields.push_back(least_angles(in.points, page.cells));
    std::move(page.point_fields.begin(), page.point_fields.end(), std::back_inserter(point_fields));
    std::move(page.cell_fields.begin(), page.cell_fields.end(), std::back_inserter(cell_fields));

    Report report;
    report.title = title_of(run, page.step, "strategy " + run.strategy);
    report.run = run;
    report.before = std::move(page.before);
    report.after = std::move(page.after);
    report.film = std::move(page.film);
    report.voronoi = std::move(page.voronoi);
    report.drawings = std::move(page.drawings);
    report.figures = std::move(page.figures);
    report.annulus_widths = tracker.widths();
    report.notes = std::move(page.notes);

    Result_files out(arguments, is_result, run.interrupted);
    out.write("summary.json", write_json(summary_json(run)));
    out.write("iterations.csv", write_csv(iterations_table(run)));
    for (const auto& [name, content] : page.files) out.write(name, content);
    out.write("final.mesh", write_mesh<d>(in.points, page.cells.empty() ? in.cells : page.cells));
    out.write("final.vtu", write_vtu<d>(in.points, page.cells, point_fields, cell_fields));
    out.write("report.html", report_html(report));
    if (page.frames != nullptr) page.frames->write(out);
    out.commit();
}

void say_interrupted(const Common_arguments& a, std::uint64_t done_steps, std::optional<std::uint64_t> steps) {
    const std::string after =
        steps ? std::to_string(done_steps) + " of " + counted(*steps, "step") : counted(done_steps, "step");
    std::fprintf(stderr, "annulus: interrupted after %s; what was done is in %s\n", after.c_str(),
                 partial(a.output).c_str());
}

template <class Moving>
void print_summary(const Run_tracker<Moving>& tracker) {
    const Run_record& r = tracker.record();
    const auto asked = static_cast<double>(r.moves.asked > 0 ? r.moves.asked : 1);
    const auto percent = [&](std::uint64_t n) { return 100.0 * static_cast<double>(n) / asked; };
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%s, %s, strategy %s, %s tolerances\n", counted_vertices(r.vertices).c_str(),
                steps_of(r, "iteration").c_str(), r.strategy.c_str(), r.tolerance.c_str());
    std::printf("triangulation  %.3f s (%.1f ns a vertex and step), construction %.3f s, motion %.3f s, total %.3f s\n",
                r.seconds.triangulation, r.moves.asked ? r.seconds.triangulation / asked * 1e9 : 0.0,
                r.seconds.construction, r.seconds.motion, r.seconds.total);
    std::printf(
        "moves          within tolerance %.3f %%, kept in place %.3f %%, flipped %.3f %%, reinserted %.4f %%, rebuilt "
        "%.3f %%\n",
        percent(r.moves.within_tolerance), percent(r.moves.kept_in_place), percent(r.moves.flipped),
        percent(r.moves.reinserted), percent(r.moves.rebuilt));
    print_input(r.input, r.dimension);
    if (r.clip) std::printf("cells          clipped to %s\n", in_words(*r.clip).c_str());
    if (r.mesh_before && !r.steps.empty() && r.steps.back().mesh) {
        const Mesh_step &a = *r.mesh_before, &b = *r.steps.back().mesh;
        std::printf(
            "mesh           cells %llu -> %llu, slivers %llu -> %llu, least dihedral angle %.2f -> %.2f degrees, "
            "%.1f %% locked\n",
            count(a.cells), count(b.cells), count(a.slivers), count(b.slivers), a.dihedral_min, b.dihedral_min,
            100.0 * static_cast<double>(b.locked) / static_cast<double>(std::max<std::uint64_t>(b.vertices, 1)));
    }
    if (counts_certificates(r))
        std::printf("certificates   %llu %s: filter %llu, interval %llu, exact %llu\n", count(r.arithmetic.total()),
                    decided_word(r), count(r.arithmetic.filter), count(r.arithmetic.interval),
                    count(r.arithmetic.exact));
    if (r.memory_peak_bytes == 0) std::printf("memory         unknown: the system does not say\n");
    else std::printf("memory         %.1f MB at the peak\n", static_cast<double>(r.memory_peak_bytes) / 1e6);
    if (r.audit.checked == 0) {
        std::printf("audit          none\n");
    } else if (r.audit.failed == 0) {
        std::printf("audit          %llu checked, all Delaunay\n", count(r.audit.checked));
    } else {
        std::printf("audit          %llu of %llu FAILED; first: %s\n", count(r.audit.failed), count(r.audit.checked),
                    tracker.first_fault().c_str());
    }
}

template void write_run(const Common_arguments&, const Run_tracker<Moving_mesh_2>&, Run_page<Moving_mesh_2>);
template void write_run(const Common_arguments&, const Run_tracker<Moving_mesh_3>&, Run_page<Moving_mesh_3>);
template void write_run(const Common_arguments&, const Run_tracker<Boxed_mesh<2>>&, Run_page<Boxed_mesh<2>>);
template void write_run(const Common_arguments&, const Run_tracker<Boxed_mesh<3>>&, Run_page<Boxed_mesh<3>>);
template void print_summary(const Run_tracker<Boxed_mesh<2>>&);
template void print_summary(const Run_tracker<Boxed_mesh<3>>&);
template void print_summary(const Run_tracker<Moving_mesh_2>&);
template void print_summary(const Run_tracker<Moving_mesh_3>&);

}  // namespace annulus::inline v1::cli
