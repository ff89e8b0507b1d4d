// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/boxed_lloyd.h>

#include <apps/cli/boxed_scene.h>
#include <apps/cli/end_of_run.h>
#include <apps/cli/files.h>
#include <apps/cli/frame_box.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/plane_view.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/cli/volume_scatter.h>
#include <apps/formats/formatted.h>
#include <apps/report/axis_ticks.h>

#include <optional>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

/// One iteration.
template <int d>
void boxed_step(Run_tracker<Boxed_mesh<d>>& tracker, std::span<const std::uint64_t> id, const Box<d>& box) {
    const Stopwatch watch(tracker.threads());
    std::vector<Coordinates<d>> target;
    const Displacement way = find_centroids<d>(tracker.triangulation().mesh(), target);
    tracker.step([&](Boxed_mesh<d>& dt) { return dt.follow(id, target, box); }, watch.seconds(), way);
}

/// The density is one.
std::optional<Plane_view> view_of(const Boxed_mesh<2>& dt, std::string caption) {
    const Density_2 one = Density::one;
    return plane_view(dt, &one, std::move(caption));
}
std::optional<Plane_view> view_of(const Boxed_mesh<3>&, const std::string&) { return {}; }

/// In 2D the page has a view of the cells.
template <int d>
void measure_volumes(Run_tracker<Boxed_mesh<d>>& tracker) {
    if constexpr (d == 3) tracker.volume_scatter(scatter_of(tracker.triangulation().mesh().voronoi_volumes()));
}

template <int d>
int run_boxed(const Boxed_lloyd_call& a, const Options& options, const std::string& command) {
    const auto begin = Clock::now();
    const bool files = !a.common.output.empty();
    const std::uint64_t iterations = a.lloyd.iterations;
    const auto scene = Boxed_scene<d>::made_of(a.lloyd, a.box, a.common.seed);
    a.common.say_merged(a.lloyd.input, scene.merged);
    if (scene.file) a.common.say_notes(scene.file->notes);
    if (files) require_writable(a.common);
    const std::vector<std::uint64_t> id = scene.ids();
    Run_tracker<Boxed_mesh<d>> tracker(
        a.tracking.strategy, [&] { return scene.mesh(options); }, options, scene.spacing(), iterations,
        a.tracking.audit, files);
    Run_page<Boxed_mesh<d>> page{.step = "Lloyd iteration"};
    const auto view = [&](const std::string& when) {
        return view_of(tracker.triangulation(), "Voronoi cells " + when);
    };
    if (auto first = files ? view(iterations > 0 ? "before" : "at the start") : std::nullopt) {
        tracker.plane_before(first->measures);
        page.voronoi.push_back(std::move(first->cells));
    }
    if (files) page.before = picture_of(tracker.triangulation(), at_start(iterations), page.cut);
    if (files) measure_volumes<d>(tracker);
    Frame_files<Boxed_mesh<d>> frames(a.common, a.frames, tracker);
    if (a.frames.any()) frames.frame(0);
    std::optional<Interruption_guard> guard;  // with --output, an interrupted run writes its results so far
    if (files) guard.emplace();
    {
        Progress progress("lloyd", iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= iterations && !Interruption_guard::interrupted(); ++i) {
            boxed_step<d>(tracker, id, scene.box);
            if (files && is_viewed(i, iterations)) {
                if (const auto now = view("")) tracker.plane_after(now->measures);
                measure_volumes<d>(tracker);
            }
            if (a.frames.any()) frames.frame(i);
            progress.show(i, formatted("%.4f spacings at most", tracker.record().steps.back().displacement_max));
        }
    }
    if (files && tracker.record().iterations > 0) measure_volumes<d>(tracker);
    tracker.finish(command, a.common.seed, since(begin));
    tracker.input(scene.input());
    const Run_record& record = tracker.record();
    if (auto last =
            files && record.iterations > 0 ? view("after " + grouped(record.iterations, "iteration")) : std::nullopt) {
        tracker.plane_after(last->measures);
        page.voronoi.push_back(std::move(last->cells));
    }
    return end_lloyd(a.common, tracker, iterations, scene.merged, frames, "", std::move(page));
}

}  // namespace

int run_boxed_lloyd(const Boxed_lloyd_call& a, const std::string& command) {
    require_boxed(a.lloyd);
    const int dimension = dimension_of_box(parse_box(a.box));
    Options options = boxed_options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    return dimension == 2 ? run_boxed<2>(a, options, command) : run_boxed<3>(a, options, command);
}

}  // namespace annulus::inline v1::cli
