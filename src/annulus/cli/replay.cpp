// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/domain.h>
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/files.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/progress.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/stopwatch.h>
#include <annulus/cli/tracker.h>
#include <annulus/io/read_motion.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

namespace annulus::cli {

namespace {

struct Replay_call {
    Common_arguments common;
    Tracking_arguments tracking;
    std::string file;
    int dimension = 0;  // 0: what the file has
};

template <int d>
using Points = std::vector<Coordinates<d>>;

/// The points of a frame, no two equal; in the plane without their z.
template <int d>
Points<d> points_of(const Recorded_motion& motion, const Frame& frame) {
    Points<d> points;
    std::map<Coordinates<d>, std::size_t> seen;
    for (std::size_t i = 0; i < frame.position.size(); ++i) {
        Coordinates<d> p;
        for (std::size_t k = 0; k < p.size(); ++k) p[k] = frame.position[i][k] + 0.0;  // -0 equals 0
        const auto fail = [&](Error_code code, std::string what, std::string expected) {
            throw Input_error(code, motion.name, frame.line[i], std::move(what), std::move(expected));
        };
        if (!in_domain(p)) fail(Error_code::out_of_domain, "coordinate out of domain", "magnitudes of at most 2^500");
        const auto [at, is_new] = seen.emplace(p, i);
        if (!is_new)
            fail(Error_code::collision,
                 "is where the point of line " + std::to_string(frame.line[at->second]) + " is in the same frame",
                 "points that differ");
        points.push_back(p);
    }
    return points;
}

/// The unit of length: the d-th root of the volume of the first frame's box for each of its points; for flat sets in fewer
/// dimensions.
template <int d>
double spacing_of(const Points<d>& points) {
    double logarithms = 0;  // no overflow
    int dimension = 0;
    for (std::size_t k = 0; k < d; ++k) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                     [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        const double side = (*high)[k] - (*low)[k];
        if (!(side > 0)) continue;
        logarithms += std::log(side);
        ++dimension;
    }
    if (dimension == 0) return 1;
    return std::exp((logarithms - std::log(static_cast<double>(points.size()))) / dimension);
}

/// What leads from the points that are there to a frame.
template <int d>
struct Change {
    std::vector<Index> leave;
    Points<d> x, arrive;
    std::vector<std::uint64_t> arriving;
    double sum = 0, max = 0;
    std::size_t moved = 0;

    Change(const std::map<std::uint64_t, Index>& present, std::span<const Coordinates<d>> now, const Frame& frame,
           const Points<d>& points)
        : x(now.begin(), now.end()) {
        std::size_t f = 0;
        const auto arrives_before = [&](bool last, std::uint64_t id) {
            for (; f < frame.id.size() && (last || frame.id[f] < id); ++f) {
                arrive.push_back(points[f]);
                arriving.push_back(frame.id[f]);
            }
        };
        for (const auto& [id, index] : present) {
            arrives_before(false, id);
            if (f == frame.id.size() || frame.id[f] != id) {
                leave.push_back(index);
                continue;
            }
            Coordinates<d>& p = x[static_cast<std::size_t>(index)];
            double way = 0;
            for (std::size_t k = 0; k < d; ++k) way = std::hypot(way, points[f][k] - p[k]);
            sum += way;
            max = std::max(max, way);
            ++moved;
            p = points[f++];
        }
        arrives_before(true, 0);
    }
};

std::optional<Picture> picture(const Moving_delaunay_2& dt, const std::string& caption) {
    return picture_of(dt, caption);
}
std::optional<Picture> picture(const Moving_delaunay_3& dt, const std::string& caption) {
    Mesh_3 mesh;
    mesh.read(dt);
    return mesh.cut(caption);
}

void write(const std::string& directory, const Tracker_2& tracker, std::optional<Picture> before,
           const std::string& note) {
    write_run(directory, tracker, std::move(before), {note});
}
void write(const std::string& directory, const Tracker_3& tracker, std::optional<Picture> before,
           const std::string& note) {
    Mesh_3 mesh;
    mesh.read(tracker.triangulation());
    write_run(directory, tracker, mesh, false, std::move(before), mesh.cut("after"), {note});
}

template <class Moving>
int replay(const Replay_call& a, const std::string& command, const Recorded_motion& motion, Clock::time_point begin) {
    constexpr int d = Moving::dimension_of_space;
    const Points<d> first = points_of<d>(motion, motion.frames[0]);
    const std::uint64_t iterations = motion.frames.size() - 1;
    const bool files = !a.common.output.empty();
    if (files) require_writable(a.common.output);
    Tracker<Moving> tracker(a.tracking.strategy, first, options_of(a.tracking, a.common), spacing_of<d>(first),
                            iterations, a.tracking.audit, files);
    std::optional<Picture> before;
    if (files) before = picture(tracker.triangulation(), "before");

    std::map<std::uint64_t, Index> present;
    for (std::size_t i = 0; i < first.size(); ++i) present[motion.frames[0].id[i]] = static_cast<Index>(i);
    std::uint64_t arrived = 0, left = 0;
    {
        Progress progress("replay", iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= iterations; ++i) {
            const Frame& frame = motion.frames[i];
            const Change<d> change(present, tracker.triangulation().positions(), frame, points_of<d>(motion, frame));
            std::erase_if(
                present, [&](const auto& p) { return !std::binary_search(frame.id.begin(), frame.id.end(), p.first); });
            const auto indices =
                tracker.follow(change.leave, change.x, change.arrive,
                               change.moved > 0 ? change.sum / static_cast<double>(change.moved) : 0, change.max);
            for (std::size_t k = 0; k < indices.size(); ++k) present[change.arriving[k]] = indices[k];
            arrived += indices.size();
            left += change.leave.size();
            char news[40];
            std::snprintf(news, sizeof news, "%.2f %% within tolerance", 100 * tracker.share_within());
            progress.show(i, news);
        }
    }
    tracker.finish(command, a.common.seed, since(begin));
    const std::string note = counted(arrived, "point") + " appeared, " + std::to_string(left) + " disappeared.";
    if (files) write(a.common.output, tracker, std::move(before), note);
    if (!a.common.quiet) {
        print_summary(tracker);
        std::printf("points         %s\n", note.c_str());
        if (files) std::printf("written to     %s\n", a.common.output.c_str());
    }
    return tracker.record().audit.failed == 0 ? done : audit_failed;
}

/// 3 when there is a z and it is not the same everywhere.
int dimension_of(const Recorded_motion& motion) {
    for (const Frame& frame : motion.frames)
        for (const auto& p : frame.position)
            if (motion.has_z && p[2] != motion.frames[0].position[0][2]) return 3;
    return 2;
}

int run(const Replay_call& a, const std::string& command) {
    const auto begin = Clock::now();
    (void)options_of(a.tracking, a.common);  // wrong usage is told before a long file is read
    const Recorded_motion motion = read_motion(a.file);
    if (a.dimension == 3 && !motion.has_z)
        throw Input_error(Error_code::bad_input, a.file, 0, "points have no z", "a third coordinate for --dim 3");
    return (a.dimension != 0 ? a.dimension : dimension_of(motion)) == 2
               ? replay<Moving_delaunay_2>(a, command, motion, begin)
               : replay<Moving_delaunay_3>(a, command, motion, begin);
}

}  // namespace

Run add_replay_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("replay", "A recorded motion, the triangulation kept right throughout");
    const auto a = std::make_shared<Replay_call>();
    sub->add_option("FILE", a->file, "Frames: .xyz (extended XYZ) or .csv with columns frame, id, x, y [, z]")
        ->required();
    sub->add_option("--dim", a->dimension, "Dimension; 2 drops z. Without it, 3 where z is not the same everywhere")
        ->check(CLI::IsMember({2, 3}));
    add_tracking(*sub, a->tracking);
    add_common(*sub, a->common, run_files);
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::cli
