// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/domain.h>
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/files.h>
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
    int dimension = 2;
};

using Points = std::vector<Coordinates<2>>;

/// The points of a frame in the plane, no two equal.
Points points_of(const Recorded_motion& motion, const Frame& frame) {
    Points points;
    std::map<Coordinates<2>, std::size_t> seen;
    for (std::size_t i = 0; i < frame.position.size(); ++i) {
        const Coordinates<2> p{frame.position[i][0] + 0.0, frame.position[i][1] + 0.0};  // -0 equals 0
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

/// The unit of length: the square root of the area of the first frame's box for each of its points.
double spacing_of(const Points& points) {
    double side[2] = {0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                     [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        side[k] = (*high)[k] - (*low)[k];
    }
    const double n = static_cast<double>(points.size());
    const double spacing = std::sqrt(side[0]) * std::sqrt(side[1]) / std::sqrt(n);
    if (spacing > 0) return spacing;
    const double longest = std::max(side[0], side[1]);
    return longest > 0 ? longest / n : 1;
}

/// What leads from the points that are there to a frame.
struct Change {
    std::vector<Index> leave;
    Points x, arrive;
    std::vector<std::uint64_t> arriving;
    double sum = 0, max = 0;
    std::size_t moved = 0;

    Change(const std::map<std::uint64_t, Index>& present, std::span<const Coordinates<2>> now, const Frame& frame,
           const Points& points)
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
            Coordinates<2>& p = x[static_cast<std::size_t>(index)];
            const double way = std::hypot(points[f][0] - p[0], points[f][1] - p[1]);
            sum += way;
            max = std::max(max, way);
            ++moved;
            p = points[f++];
        }
        arrives_before(true, 0);
    }
};

int run(const Replay_call& a, const std::string& command) {
    const auto begin = Clock::now();
    if (a.dimension != 2) throw Error(Error_code::usage, "--dim 3 is not in this version; z is dropped with --dim 2");
    const Options options = options_of(a.tracking, a.common);
    const Recorded_motion motion = read_motion(a.file);
    const Points first = points_of(motion, motion.frames[0]);
    const std::uint64_t iterations = motion.frames.size() - 1;
    const bool files = !a.common.output.empty();
    if (files) require_writable(a.common.output);
    Tracker_2 tracker(a.tracking.strategy, first, options, spacing_of(first), iterations, a.tracking.audit, files);
    std::optional<Picture> before;
    if (files) before = picture_of(tracker.triangulation(), "before");

    std::map<std::uint64_t, Index> present;
    for (std::size_t i = 0; i < first.size(); ++i) present[motion.frames[0].id[i]] = static_cast<Index>(i);
    std::uint64_t arrived = 0, left = 0;
    {
        Progress progress("replay", iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= iterations; ++i) {
            const Frame& frame = motion.frames[i];
            const Change change(present, tracker.triangulation().positions(), frame, points_of(motion, frame));
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
    if (files) write_run(a.common.output, tracker, std::move(before), {note});
    if (!a.common.quiet) {
        print_summary(tracker);
        std::printf("points         %s\n", note.c_str());
        if (files) std::printf("written to     %s\n", a.common.output.c_str());
    }
    return tracker.record().audit.failed == 0 ? done : audit_failed;
}

}  // namespace

Run add_replay_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("replay", "A recorded motion, the triangulation kept right throughout");
    const auto a = std::make_shared<Replay_call>();
    sub->add_option("FILE", a->file, "Frames: .xyz (extended XYZ) or .csv with columns frame, id, x, y [, z]")
        ->required();
    sub->add_option("--dim", a->dimension, "Dimension; 2 drops z")->check(CLI::IsMember({2, 3}))->capture_default_str();
    add_tracking(*sub, a->tracking);
    add_common(*sub, a->common, run_files);
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::cli
