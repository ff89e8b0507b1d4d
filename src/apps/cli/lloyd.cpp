// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/box_size.h>
#include <apps/cli/boxed_lloyd.h>
#include <apps/cli/boxed_scene.h>
#include <apps/cli/commands.h>
#include <apps/cli/end_of_run.h>
#include <apps/cli/files.h>
#include <apps/cli/lloyd_scene.h>
#include <apps/cli/plane_view.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/cli/solid_lloyd.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>
#include <apps/report/axis_ticks.h>

#include <cstdio>
#include <memory>
#include <string>

namespace annulus::inline v1::cli {

namespace {

struct Lloyd_call {
    Common_arguments common;
    Tracking_arguments tracking;
    Lloyd_arguments lloyd;
    Frame_arguments frames;
    std::string box;
};

int run(const Lloyd_call& a, const std::string& command) {
    if (!a.box.empty()) return run_boxed_lloyd({a.common, a.tracking, a.lloyd, a.frames, a.box}, command);
    if (a.lloyd.domain == "box" && dimension_of_size(a.lloyd.size) == 3)
        return run_solid_lloyd({a.common, a.tracking, a.lloyd, a.frames}, command);
    const auto begin = Clock::now();
    Options options = options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    const Lloyd_scene scene = make_scene(a.lloyd, a.common.seed);
    a.common.say_merged(a.lloyd.input, scene.merged);
    a.common.say_notes(scene.input.warnings);
    if (!a.common.output.empty()) require_writable(a.common);
    Tracker_2 tracker(a.tracking.strategy, scene.points, options, scene.spacing(), a.lloyd.iterations, a.tracking.audit,
                      !a.common.output.empty());
    Run_page<Moving_mesh_2> page{.step = "Lloyd iteration"};
    // Only a Delaunay triangulation has Voronoi cells.
    const bool viewed = !a.common.output.empty() && options.tolerance == Tolerance_kind::certified;
    const auto view = [&](const std::string& when) {
        return plane_view(tracker.triangulation(), scene.domain, &scene.density, "Voronoi cells " + when);
    };
    if (viewed) {
        Plane_view first = view(a.lloyd.iterations > 0 ? "before" : "at the start");
        tracker.plane_before(first.measures);
        page.voronoi.push_back(std::move(first.cells));
    }
    if (!a.common.output.empty()) {
        page.before = picture_of(tracker.triangulation(), at_start(a.lloyd.iterations));
        page.before->outline = border_of(scene.domain);
    }
    Frame_files<Moving_mesh_2> frames(a.common, a.frames, tracker);
    if (a.frames.any()) frames.frame(0);

    const Lloyd_2 lloyd(scene.domain, scene.density, a.common.threads, scene.border);
    Stars_2 stars;
    Lloyd_memory memory;
    std::vector<Coordinates<2>> target(scene.points.size());
    std::optional<Interruption_guard> guard;  // with --output, an interrupted run writes its results so far
    if (!a.common.output.empty()) guard.emplace();
    {
        Progress progress("lloyd", a.lloyd.iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= a.lloyd.iterations && !Interruption_guard::interrupted(); ++i) {
            const Stopwatch watch(a.common.threads);
            const Moving_mesh_2& dt = tracker.triangulation();
            if (tracker.cells_changed()) read_stars(dt, stars);
            const Lloyd_step step = lloyd.step(stars, dt.points(), target, memory);
            tracker.step(target, watch.seconds(), step.mean_displacement, step.max_displacement);
            if (viewed && is_viewed(i, a.lloyd.iterations)) tracker.plane_after(view("").measures);
            if (a.frames.any()) frames.frame(i);
            progress.show(i, formatted("%.2f %% within tolerance", 100 * tracker.share_within()));
        }
    }
    tracker.finish(command, a.common.seed, since(begin));
    tracker.input(scene.input);
    if (viewed && tracker.record().iterations > 0) {
        Plane_view last = view("after " + grouped(tracker.record().iterations, "iteration"));
        tracker.plane_after(last.measures);
        page.voronoi.push_back(std::move(last.cells));
    }
    if (!a.common.output.empty() && scene.stippling) {
        page.files.emplace_back("stipples.svg", stipples_of(a.lloyd, scene, tracker.triangulation()));
        page.drawings = drawings_of(scene, page.files.back().second);
    }
    return end_lloyd(a.common, tracker, a.lloyd.iterations, scene.merged, frames, uncut_cells, std::move(page));
}

}  // namespace

Run add_lloyd_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand(
        "lloyd", "Lloyd iterations in 2D, or in a box in 2D or 3D, with the triangulation kept right throughout");
    const auto a = std::make_shared<Lloyd_call>();
    add_lloyd(*sub, a->lloyd);
    add_lloyd_box(*sub, a->box);
    add_tracking(*sub, a->tracking, true);
    add_frames(*sub, a->frames);
    add_common(*sub, a->common, run_files);
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
