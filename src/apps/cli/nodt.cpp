// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/companion.h>
#include <apps/cli/domain_files.h>
#include <apps/cli/end_of_run.h>
#include <apps/cli/files.h>
#include <apps/cli/finishing.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/nodt_scene.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>
#include <apps/motion/nodt_3.h>

#include <cstdio>
#include <memory>

namespace annulus::inline v1::cli {

namespace {

struct Nodt_call {
    Common_arguments common;
    Tracking_arguments tracking;
    Nodt_arguments nodt;
    Frame_arguments frames;
    bool finish = false;
    std::vector<std::string> formats;  ///< of the domain, beside those that are always written
};

std::string filled(const Mesh_3& mesh, const Domain_3& domain) {
    double sum = 0;
    for (std::size_t c = 0; c < mesh.cells().vertices.size(); ++c)
        if (mesh.inside()[c] != 0) sum += mesh.kept().moments()[c].volume;
    return formatted("At the start the cells of the domain fill %.2f %% of it.", 100 * sum / domain.volume());
}

int run(const Nodt_call& a, const std::string& command) {
    const auto begin = Clock::now();
    Options options = options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    check_domain_formats(a.formats, a.common);
    const bool files = !a.common.output.empty();
    if (files) require_writable(a.common);
    Nodt_scene scene = make_scene(a.nodt, a.common.seed);
    const Domain_3& domain = *scene.domain;
    const std::uint64_t steps = a.nodt.iterations + (a.finish ? 1 : 0);
    Tracker_3 tracker(a.tracking.strategy, scene.points, options, scene.spacing(), steps, a.tracking.audit, files);
    Mesh_3 mesh;
    mesh.read(tracker.triangulation(), true, domain, a.common.threads);
    scene.require_cells(a.nodt, mesh.inside());
    scene.notes.push_back(filled(mesh, domain));
    tracker.mesh_before(measured(mesh, {}));
    Run_page<Moving_mesh_3> page{.step = "natural ODT iteration"};
    const Cut_plane cut = mesh.middle();
    if (files) page.before = mesh.cut(steps > 0 ? "before" : at_start(0), cut);
    Frame_files<Moving_mesh_3> frames(a.common, a.frames, tracker);
    if (a.frames.any()) frames.frame(0);

    const Nodt_3 nodt = scene.motion(a.nodt, a.common.threads);
    Nodt_memory memory;
    std::vector<Coordinates<3>> target(scene.points.size());
    std::optional<Interruption_guard> guard;
    if (files) guard.emplace();
    {
        Progress progress("nodt", a.nodt.iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= a.nodt.iterations && !Interruption_guard::interrupted(); ++i) {
            Stopwatch watch(a.common.threads);
            const Nodt_step step = nodt.step(mesh.kept(), mesh.points(), target, memory);
            tracker.step(target, watch.seconds(), step.mean_displacement, step.max_displacement);
            // Reading the mesh for the next step is part of the motion's time; measuring its quality is not.
            watch = Stopwatch(a.common.threads);
            mesh.read(tracker.triangulation(), tracker.cells_changed(), domain, a.common.threads);
            tracker.add_motion(watch.seconds());
            tracker.mesh_after(measured(mesh, step));
            if (a.frames.any()) frames.frame(i);
            progress.show(i, formatted("%.2f %% within tolerance, ", 100 * tracker.share_within()) +
                                 counted(tracker.record().steps.back().mesh->slivers, "sliver"));
        }
    }
    if (a.finish && !Interruption_guard::interrupted()) {
        Stopwatch watch(a.common.threads);
        const Finishing finishing(scene, tracker.triangulation(), a.common.quiet);
        if (!Interruption_guard::interrupted()) {  // else it is dropped: a step is done or it is not
            tracker.step(finishing.position(), watch.seconds(), finishing.mean_displacement(),
                         finishing.max_displacement());
            watch = Stopwatch(a.common.threads);
            mesh.read(tracker.triangulation(), tracker.cells_changed(), domain, a.common.threads);
            tracker.add_motion(watch.seconds());
            tracker.mesh_after(measured(mesh, {}));
            tracker.note_finish();
            if (a.frames.any()) frames.frame(steps);
            scene.notes.push_back(finishing.note());
        }
    }
    const Domain_files optimised(mesh);
    tracker.worst_cells(optimised.worst());
    tracker.finish(command, a.common.seed, since(begin));
    if (files) {
        optimised.add_to(page, tracker.record(), a.formats);
        if (tracker.record().iterations > 0)
            page.after = mesh.cut("after " + steps_of(tracker.record(), "iteration"), cut);
        page.notes = scene.notes;
        page.figures = frame_figures(frames.records(), tracker.record(), false, uncut_cells);
        page.frames = &frames;
        write_run(a.common, tracker, std::move(page));
    }
    return end_run(a.common, tracker, steps, [&] { print_worst(tracker.record()); });
}

}  // namespace

Run add_nodt_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("nodt", nodt_summary);
    const auto a = std::make_shared<Nodt_call>();
    add_nodt(*sub, a->nodt);
    add_finish(*sub, a->finish);
    add_domain_formats(*sub, a->formats);
    add_tracking(*sub, a->tracking);
    add_frames(*sub, a->frames);
    add_common(*sub, a->common,
               "summary.json, iterations.csv, final.mesh, final.vtu, domain.mesh, domain.vtu, quality.csv, "
               "dihedral.csv and report.html");
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
