// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/files.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/progress.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/stopwatch.h>
#include <annulus/cli/tracker.h>
#include <annulus/formats/frame_points.h>
#include <annulus/formats/read_motion.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <optional>
#include <span>

namespace annulus::cli {

namespace {

struct Replay_call {
    Common_arguments common;
    Tracking_arguments tracking;
    std::string file;
    int dimension = 0;  // 0: what the file has
    std::string coincident = "refuse";
    std::string absent = "refuse";

    [[nodiscard]] Coincident on_coincident() const {
        return coincident == "merge" ? Coincident::merge : Coincident::refuse;
    }
    [[nodiscard]] Absent_frames on_absent() const {
        return absent == "empty"  ? Absent_frames::empty
               : absent == "skip" ? Absent_frames::skip
                                  : Absent_frames::refuse;
    }
};

template <int d>
using Points = std::vector<Coordinates<d>>;

/// The unit of length: the d-th root of the volume of the points' box for each of them; for flat sets in fewer dimensions.
template <int d>
double spacing_of(const Points<d>& points) {
    if (points.empty()) return 1;
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

/// The points that are there: ids, ascending, and the index of each in the triangulation.
struct Present {
    std::vector<std::uint64_t> id;
    std::vector<Index> index;
};

/// What leads from the points that are there to a frame.
template <int d>
struct Change {
    std::vector<Index> leave;
    Points<d> x, arrive;
    std::vector<Index> index;  ///< of the frame's points; `none` for those that arrive
    double sum = 0, max = 0;
    std::size_t moved = 0;

    Change(const Present& present, std::span<const Coordinates<d>> now, const Frame_points<d>& frame)
        : x(now.begin(), now.end()) {
        std::size_t p = 0;
        for (std::size_t f = 0; f < frame.id.size(); ++f) {
            while (p < present.id.size() && present.id[p] < frame.id[f]) leave.push_back(present.index[p++]);
            if (p == present.id.size() || present.id[p] != frame.id[f]) {
                arrive.push_back(frame.x[f]);
                index.push_back(none);
                continue;
            }
            index.push_back(present.index[p++]);
            Coordinates<d>& at = x[static_cast<std::size_t>(index.back())];
            double way = 0;
            for (std::size_t k = 0; k < d; ++k) way = std::hypot(way, frame.x[f][k] - at[k]);
            sum += way;
            max = std::max(max, way);
            ++moved;
            at = frame.x[f];
        }
        leave.insert(leave.end(), present.index.begin() + static_cast<std::ptrdiff_t>(p), present.index.end());
    }

    [[nodiscard]] double mean() const { return moved > 0 ? sum / static_cast<double>(moved) : 0; }
};

std::optional<Picture> picture(const Moving_delaunay_2& dt, const std::string& caption) {
    return picture_of(dt, caption);
}
std::optional<Picture> picture(const Moving_delaunay_3& dt, const std::string& caption) {
    Mesh_3 mesh;
    mesh.read(dt);
    return mesh.cut(caption);
}

void write(const Common_arguments& arguments, const Tracker_2& tracker, std::optional<Picture> before,
           std::vector<std::string> notes) {
    write_run(arguments, tracker, "step", std::move(before), std::move(notes));
}
void write(const Common_arguments& arguments, const Tracker_3& tracker, std::optional<Picture> before,
           std::vector<std::string> notes) {
    Mesh_3 mesh;
    mesh.read(tracker.triangulation());
    write_run(arguments, tracker, "step", mesh, false, std::move(before), mesh.cut("after"), std::move(notes));
}

/// How many points came and went, and how many others stood for.
struct Traffic {
    std::uint64_t arrived = 0, left = 0, merged = 0;

    [[nodiscard]] std::string in_words() const {
        std::string text = counted(arrived, "point") + " appeared, " + std::to_string(left) + " disappeared";
        if (merged > 0) text += ", " + std::to_string(merged) + " merged with others at their place";
        return text + ".";
    }
};

template <class Moving>
int replay(const Replay_call& a, const std::string& command, const Recorded_motion& motion, Clock::time_point begin) {
    constexpr int d = Moving::dimension_of_space;
    const auto frame_at = [&](std::size_t i) { return points_of<d>(motion, motion.frames[i], a.on_coincident()); };
    Frame_points<d> frame = frame_at(0);
    Traffic traffic{.merged = frame.merged};
    const std::uint64_t iterations = motion.frames.size() - 1;
    const bool files = !a.common.output.empty();
    if (files) require_writable(a.common);
    const auto with_points = std::find_if(motion.frames.begin(), motion.frames.end(),
                                          [](const Frame& f) { return !f.id.empty(); });  // there is one
    const double spacing = spacing_of<d>(points_of<d>(motion, *with_points, Coincident::merge).x);
    Tracker<Moving> tracker(a.tracking.strategy, frame.x, options_of(a.tracking, a.common), spacing, iterations,
                            a.tracking.audit, files);
    std::optional<Picture> before;
    if (files) before = picture(tracker.triangulation(), "before");

    Present present{std::move(frame.id), std::vector<Index>(frame.x.size())};
    std::iota(present.index.begin(), present.index.end(), Index{0});
    std::optional<Interruption_guard> guard;
    if (files) guard.emplace();
    {
        Progress progress("replay", iterations, a.common.quiet);
        for (std::uint64_t i = 1; i <= iterations && !Interruption_guard::interrupted(); ++i) {
            frame = frame_at(i);
            Change<d> change(present, tracker.triangulation().positions(), frame);
            const auto indices = tracker.follow(change.leave, change.x, change.arrive, change.mean(), change.max);
            auto arrived = indices.begin();
            for (Index& index : change.index)
                if (index == none) index = *arrived++;
            present = {std::move(frame.id), std::move(change.index)};
            traffic.arrived += indices.size();
            traffic.left += change.leave.size();
            traffic.merged += frame.merged;
            char news[40];
            std::snprintf(news, sizeof news, "%.2f %% within tolerance", 100 * tracker.share_within());
            progress.show(i, news);
        }
    }
    tracker.finish(command, a.common.seed, since(begin));
    std::vector<std::string> notes = motion.notes;
    notes.insert(notes.begin(), traffic.in_words());
    if (files) write(a.common, tracker, std::move(before), notes);
    a.common.say_notes(motion.notes);
    if (tracker.record().interrupted) {
        say_interrupted(a.common, tracker.record().iterations, iterations);
        return done;
    }
    if (!a.common.quiet) {
        print_summary(tracker);
        std::printf("points         %s\n", notes.front().c_str());
        if (files) std::printf("written to     %s\n", a.common.output.c_str());
    }
    return tracker.record().audit.failed == 0 ? done : audit_failed;
}

/// 3 when there is a z and it is not the same everywhere.
int dimension_of(const Recorded_motion& motion) {
    std::optional<double> z;
    for (const Frame& frame : motion.frames)
        for (const auto& p : frame.position) {
            if (motion.has_z && z.value_or(p[2]) != p[2]) return 3;
            z = p[2];
        }
    return 2;
}

int run(const Replay_call& a, const std::string& command) {
    const auto begin = Clock::now();
    (void)options_of(a.tracking, a.common);  // wrong usage is told before a long file is read
    const Recorded_motion motion = read_motion(a.file, a.on_absent());
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
    sub->add_option("FILE", a->file,
                    "Frames: .xyz (extended XYZ) or .csv with columns frame, id, x, y [, z]; .gz after it unpacks")
        ->required();
    sub->add_option("--dim", a->dimension, "Dimension; 2 drops z. Without it, 3 where z is not the same everywhere")
        ->check(whole_number(2, 3));
    sub->add_option("--coincident", a->coincident,
                    "Points of a frame at one place: refuse them, or merge: the one with the least id stands for all")
        ->check(CLI::IsMember({"refuse", "merge"}))
        ->capture_default_str();
    sub->add_option(
           "--absent-frames", a->absent,
           "Gaps in the numbers of a .csv file's frames: refuse them, empty: all points disappear for one step\n"
           "and appear again, or skip: one step leads over the gap")
        ->check(CLI::IsMember({"refuse", "empty", "skip"}))
        ->capture_default_str();
    add_tracking(*sub, a->tracking);
    add_common(*sub, a->common, run_files);
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::cli
