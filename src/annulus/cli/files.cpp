// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/files.h>
#include <annulus/cli/result_files.h>

#include <annulus/io/axis_ticks.h>
#include <annulus/io/input_error.h>
#include <annulus/io/summary.h>
#include <annulus/io/write_csv.h>
#include <annulus/io/write_json.h>
#include <annulus/io/write_mesh.h>
#include <annulus/io/write_vtu.h>

#include <cmath>
#include <cstdio>

namespace annulus::cli {

namespace {

/// Solid cells only: a mesh of a flat set has none.
std::vector<std::array<Index, 3>> triangles(const Audit_input<2>& in) {
    std::vector<std::array<Index, 3>> cells;
    for (const auto& c : in.cells)
        if (c[2] != none) cells.push_back(c);
    return cells;
}

}  // namespace

std::string title_of(const Run_record& run, const std::string& names) {
    return grouped(run.vertices) + " vertices, " + grouped(run.iterations) + " Lloyd " +
           (run.iterations == 1 ? "iteration: " : "iterations: ") + names;
}

void write_run(const std::string& directory, const Tracker_2& tracker, std::optional<Picture> before,
               std::vector<std::string> notes) {
    const Run_record& run = tracker.record();
    const Audit_input<2> in = tracker.triangulation().audit_input();
    const auto cells = triangles(in);
    const Measures m = tracker.triangulation().measure();
    std::vector<double> tolerance;
    std::vector<double> theta;
    for (std::size_t i = 0; i < m.tolerance.size(); ++i) {
        const auto v = tracker.triangulation().vertex(i);
        if (v == decltype(v)()) continue;
        tolerance.push_back(std::isfinite(m.tolerance[i]) ? m.tolerance[i] : 0.0);
        theta.push_back(tracker.triangulation().theta(v));
    }
    const std::vector<Vtu_field> fields{{"tolerance", tolerance}, {"theta", theta}};

    Report report;
    report.title = title_of(run, run.strategy);
    report.run = run;
    report.before = std::move(before);
    report.after = picture_of(tracker.triangulation(), "After " + counted(run.iterations, "iteration"));
    report.annulus_widths = tracker.widths();
    report.notes = std::move(notes);

    Result_files out(directory);
    out.write("summary.json", write_json(summary_json(run)));
    out.write("iterations.csv", write_csv(iterations_table(run)));
    out.write("final.mesh", write_mesh<2>(in.points, in.cells));
    out.write("final.vtu", write_vtu<2>(in.points, cells, fields));
    out.write("report.html", report_html(report));
    out.commit();
}

void print_summary(const Tracker_2& tracker) {
    const Run_record& r = tracker.record();
    const auto asked = static_cast<double>(r.moves.asked > 0 ? r.moves.asked : 1);
    const auto percent = [&](std::uint64_t n) { return 100.0 * static_cast<double>(n) / asked; };
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%llu vertices, %llu iterations, strategy %s, %s tolerances\n", count(r.vertices), count(r.iterations),
                r.strategy.c_str(), r.tolerance.c_str());
    std::printf("triangulation  %.3f s (%.1f ns a vertex and step), motion %.3f s, total %.3f s\n",
                r.seconds.triangulation, r.moves.asked ? r.seconds.triangulation / asked * 1e9 : 0.0, r.seconds.motion,
                r.seconds.total);
    std::printf("moves          within tolerance %.3f %%, kept in place %.3f %%, flipped %.3f %%, reinserted %.4f %%, "
                "rebuilt %.3f %%\n",
                percent(r.moves.within_tolerance), percent(r.moves.kept_in_place), percent(r.moves.flipped),
                percent(r.moves.reinserted), percent(r.moves.rebuilt));
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

}  // namespace annulus::cli
