// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/solid_lloyd.h>

#include <annulus/error.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/voronoi.h>
#include <apps/cli/box_size.h>
#include <apps/cli/end_of_run.h>
#include <apps/cli/files.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/cli/volume_scatter.h>
#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>
#include <apps/formats/read_points.h>
#include <apps/motion/distinct_targets.h>
#include <apps/motion/generated_points.h>
#include <apps/motion/kept_cells_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

/// Points, distinct, in the box, and how the file was interpreted.
struct Solid_scene {
    Sized_box<3> box;
    std::vector<Coordinates<3>> points{};
    std::uint64_t merged = 0;
    Input_record input{};

    [[nodiscard]] double spacing() const { return std::cbrt(box.volume() / static_cast<double>(points.size())); }
};

std::vector<Coordinates<2>> section_of(const Sized_box<3>& box, const Cut_plane& plane) {
    const std::size_t right = plane.axis == 0 ? 1 : 0, up = plane.axis == 2 ? 1 : 2;
    const auto &low = box.lower, &high = box.upper;
    return {{low[right], low[up]}, {high[right], low[up]}, {high[right], high[up]}, {low[right], high[up]}};
}

bool is_in(const Sized_box<3>& box, const Coordinates<3>& p) {
    for (std::size_t k = 0; k < 3; ++k)
        if (!(p[k] >= box.lower[k] && p[k] <= box.upper[k])) return false;
    return true;
}

Solid_scene solid_scene(const Solid_lloyd_call& a) {
    Solid_scene scene{.box = box_of_size<3>(a.lloyd.size)};
    if (a.lloyd.input.empty()) {
        Portable_random dice(a.common.seed);
        scene.points.resize(static_cast<std::size_t>(a.lloyd.points));
        for (Coordinates<3>& p : scene.points)
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = scene.box.lower[k] + dice.unit() * (scene.box.upper[k] - scene.box.lower[k]);
        return scene;
    }
    const Point_file<3> file =
        read_points<3>(a.lloyd.input, {.format = a.lloyd.format, .box = {.ignored = a.lloyd.open}});
    for (std::size_t i = 0; i < file.points.size(); ++i)
        if (!is_in(scene.box, file.points[i]))
            throw file.fault(i, Error_code::out_of_domain, "point outside the domain", "points in the box of --size");
    scene.points = distinct_points(file, 1).x;
    scene.merged = file.points.size() - scene.points.size();
    scene.input = input_of(file);
    return scene;
}

/// Lloyd's iteration in a box: the same bit for bit for one triangulation, whatever its history.
class Solid_lloyd {
  public:
    explicit Solid_lloyd(const Sized_box<3>& box) : clip_{box.lower, box.upper, {}} {}

    /// Sets the targets. A vertex whose cell has no volume, beyond rounding, stays where it is.
    Displacement step(const Moving_mesh_3& dt, bool cells_changed, std::span<Coordinates<3>> target) {
        const std::span<const Coordinates<3>> position = dt.points();
        const Voronoi_diagram<3> diagram = diagram_of(dt, cells_changed);
        volume_scatter_ = scatter_of(diagram.volume);
        std::size_t kept = 0;
        for (std::size_t v = 0; v < target.size(); ++v) {
            target[v] = position[v];
            if (!(diagram.volume[v] > 0)) continue;
            for (std::size_t k = 0; k < 3; ++k)
                target[v][k] = std::clamp(diagram.cell_centroid[v][k], clip_.lower[k], clip_.upper[k]);
        }
        rest_where_equal(position, target, kept);
        Displacement way;
        for (std::size_t v = 0; v < target.size(); ++v) {
            const double far =
                std::hypot(target[v][0] - position[v][0], target[v][1] - position[v][1], target[v][2] - position[v][2]);
            way.mean += far / static_cast<double>(target.size());
            way.max = std::max(way.max, far);
        }
        return way;
    }

    /// Of the volumes of the Voronoi cells before the last step.
    [[nodiscard]] double volume_scatter() const { return volume_scatter_; }
    /// The same of a triangulation.
    [[nodiscard]] double volume_scatter(const Moving_mesh_3& dt, bool cells_changed) {
        return scatter_of(diagram_of(dt, cells_changed).volume);
    }

  private:
    Voronoi_diagram<3> diagram_of(const Moving_mesh_3& dt, bool cells_changed) {
        if (dt.mesh().dimension() != 3) return voronoi(dt, clip_);
        if (cells_changed) kept_.read(dt.mesh().table());
        return voronoi_diagram<3>(dt.points(), kept_.cells(), &clip_);
    }

    Voronoi_clip<3> clip_;
    Kept_cells_3 kept_;
    double volume_scatter_ = 0;
};

/// Throws Error(usage) for what there is in 2D only.
void require_options_of_2d_absent(const Lloyd_arguments& a) {
    const auto refuse = [](const char* what) { throw Error(Error_code::usage, what); };
    if (a.density != "one" || a.invert || a.dots != "equal")
        refuse("in a box in 3D the density is one: no other --density, no picture with --invert or --dots");
    if (a.radius != 0) refuse("--radius is for --domain disc or square; a box has --size");
    if (a.keep_boundary) refuse("--keep-boundary is for polygons, and --size has a box in 3D");
    if (a.ignore_z) refuse("--ignore-z is for 2D, and --size has a box in 3D");
    if (a.points == 0 && a.input.empty())
        refuse("say how many points with --points N, or name a file with --input FILE");
}

}  // namespace

int run_solid_lloyd(const Solid_lloyd_call& a, const std::string& command) {
    require_options_of_2d_absent(a.lloyd);
    Options options = options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    const auto begin = Clock::now();
    const bool files = !a.common.output.empty();
    const std::uint64_t iterations = a.lloyd.iterations;
    const Solid_scene scene = solid_scene(a);
    a.common.say_merged(a.lloyd.input, scene.merged);
    a.common.say_notes(scene.input.warnings);
    if (files) require_writable(a.common);
    Tracker_3 tracker(a.tracking.strategy, scene.points, options, scene.spacing(), iterations, a.tracking.audit, files);
    Run_page<Moving_mesh_3> page{.step = "Lloyd iteration"};
    page.cut = middle_of(scene.box.lower, scene.box.upper, scene.points);
    if (files) {
        page.before = picture_of(tracker.triangulation(), at_start(iterations), page.cut);
        page.before->outline.push_back(section_of(scene.box, *page.cut));
    }
    Frame_files<Moving_mesh_3> frames(a.common, a.frames, tracker);
    if (a.frames.any()) frames.frame(0);
    Solid_lloyd lloyd(scene.box);
    std::vector<Coordinates<3>> target(scene.points.size());
    std::optional<Interruption_guard> guard;  // with --output, an interrupted run writes its results so far
    if (files) guard.emplace();
    {
        Progress progress("lloyd", iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= iterations && !Interruption_guard::interrupted(); ++i) {
            const Stopwatch watch(a.common.threads);
            const Displacement way = lloyd.step(tracker.triangulation(), tracker.cells_changed(), target);
            const double seconds = watch.seconds();
            tracker.volume_scatter(lloyd.volume_scatter());
            tracker.step(target, seconds, way.mean, way.max);
            if (a.frames.any()) frames.frame(i);
            progress.show(i, formatted("%.2f %% within tolerance", 100 * tracker.share_within()));
        }
    }
    if (files) tracker.volume_scatter(lloyd.volume_scatter(tracker.triangulation(), tracker.cells_changed()));
    tracker.finish(command, a.common.seed, since(begin));
    tracker.input(scene.input);
    return end_lloyd(a.common, tracker, iterations, scene.merged, frames, uncut_cells, std::move(page));
}

}  // namespace annulus::inline v1::cli
