// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/boxed_lloyd.h>

#include <annulus/error.h>
#include <apps/cli/boxed_mesh.h>
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
#include <apps/formats/input_error.h>
#include <apps/motion/boxed_points.h>
#include <apps/motion/periodic_lloyd.h>
#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

/// Points, distinct as they are given, and how the file was interpreted.
template <int d>
struct Boxed_scene {
    Box<d> box;
    std::vector<Coordinates<d>> points{};
    std::uint64_t merged = 0;
    std::optional<Point_file<d>> file{};
};

template <int d>
Boxed_scene<d> boxed_scene(const Boxed_lloyd_call& a) {
    Boxed_scene<d> scene{.box = box_of<d>(parse_box(a.box))};
    if (a.lloyd.input.empty()) {
        scene.points =
            generate_in<d>(scene.box, Point_family::uniform, static_cast<std::size_t>(a.lloyd.points), a.common.seed);
        return scene;
    }
    scene.file = read_points<d>(a.lloyd.input,
                                {.ignore_z = a.lloyd.ignore_z, .format = a.lloyd.format, .box = {.replaced = true}});
    scene.points = distinct_points(*scene.file, 1);
    scene.merged = scene.file->points.size() - scene.points.size();
    return scene;
}

/// The triangulation of the initial points; its errors name points of the file.
template <int d>
Boxed_mesh<d> boxed_mesh_of(const Boxed_scene<d>& scene, std::span<const std::uint64_t> id, const Options& options) {
    try {
        return Boxed_mesh<d>(id, scene.points, scene.box, options);
    } catch (const Error& error) {
        if (error.vertices().empty() || !scene.file) throw;
        throw fault_in_box<d>(error, *scene.file, scene.points);
    }
}

template <int d>
Input_record boxed_input(const Boxed_scene<d>& scene) {
    Input_record input;
    if (scene.file) input = input_of(*scene.file);
    input.box_from = "--box";
    for (const auto& vector : scene.box.vectors()) input.box.emplace_back(vector.begin(), vector.end());
    return input;
}

/// One iteration.
template <int d>
void boxed_step(Run_tracker<Boxed_mesh<d>>& tracker, std::span<const std::uint64_t> id, const Box<d>& box) {
    const Stopwatch watch(tracker.threads());
    const Periodic_mesh<d>& mesh = tracker.triangulation().mesh();
    const std::vector<Coordinates<d>> offset = periodic_centroid_offsets<d>(mesh.audit_input());
    std::vector<Coordinates<d>> target(mesh.points().begin(), mesh.points().end());
    Displacement way;
    for (std::size_t v = 0; v < target.size(); ++v) {
        double square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            target[v][k] += offset[v][k];
            square += offset[v][k] * offset[v][k];
        }
        way.mean += std::sqrt(square) / static_cast<double>(target.size());
        way.max = std::max(way.max, std::sqrt(square));
    }
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
    const Boxed_scene<d> scene = boxed_scene<d>(a);
    a.common.say_merged(a.lloyd.input, scene.merged);
    if (scene.file) a.common.say_notes(scene.file->notes);
    if (files) require_writable(a.common);
    std::vector<std::uint64_t> id(scene.points.size());
    std::iota(id.begin(), id.end(), std::uint64_t{0});
    const double spacing = std::pow(scene.box.volume() / static_cast<double>(id.size()), 1.0 / d);
    Run_tracker<Boxed_mesh<d>> tracker(
        a.tracking.strategy, [&] { return boxed_mesh_of<d>(scene, id, options); }, options, spacing, iterations,
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
    tracker.input(boxed_input<d>(scene));
    const Run_record& record = tracker.record();
    if (auto last =
            files && record.iterations > 0 ? view("after " + grouped(record.iterations, "iteration")) : std::nullopt) {
        tracker.plane_after(last->measures);
        page.voronoi.push_back(std::move(last->cells));
    }
    return end_lloyd(a.common, tracker, iterations, scene.merged, frames, "", std::move(page));
}

/// Throws Error(usage) for what there is with open boundaries only.
void require_open_options_absent(const Boxed_lloyd_call& a) {
    const auto refuse = [](const char* what) { throw Error(Error_code::usage, what); };
    if (a.lloyd.open) refuse("--open and --box exclude each other");
    if (!a.lloyd.domain.empty() || a.lloyd.radius != 0 || !a.lloyd.size.empty())
        refuse("with --box the domain is the periodic box: no --domain, --radius or --size");
    if (a.lloyd.keep_boundary) refuse("--keep-boundary is for polygons: a periodic box has no boundary");
    if (a.lloyd.density != "one" || a.lloyd.invert || a.lloyd.dots != "equal")
        refuse("in a periodic box the density is one: no other --density, no picture with --invert or --dots");
    if (a.lloyd.points == 0 && a.lloyd.input.empty())
        refuse("say how many points with --points N, or name a file with --input FILE");
}

}  // namespace

void add_lloyd_box(CLI::App& app, std::string& box) {
    app.add_option("--box", box,
                   "Periodic box, 2D or 3D, in place of a domain and of that of the input: the lengths of its edges,\n"
                   "Lx,Ly or Lx,Ly,Lz, or its vectors, 4 or 9 numbers, one vector after the other")
        ->type_name("LIST");
}

int run_boxed_lloyd(const Boxed_lloyd_call& a, const std::string& command) {
    require_open_options_absent(a);
    const int dimension = dimension_of_box(parse_box(a.box));
    Options options = boxed_options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    return dimension == 2 ? run_boxed<2>(a, options, command) : run_boxed<3>(a, options, command);
}

}  // namespace annulus::inline v1::cli
