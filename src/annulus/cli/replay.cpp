// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/files.h>
#include <annulus/cli/frame_change.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/progress.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/stopwatch.h>
#include <annulus/cli/tracker.h>
#include <annulus/formats/frame_points.h>
#include <annulus/formats/motion_reader.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

namespace annulus::cli {

namespace {

struct Replay_call {
    Common_arguments common;
    Tracking_arguments tracking;
    std::string file;
    int dimension = 0;  // 0: what the file has
    std::string coincident = "refuse";
    std::string absent = "refuse";
    Motion_options motion;

    [[nodiscard]] Coincident on_coincident() const {
        return coincident == "merge" ? Coincident::merge : Coincident::refuse;
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

/// The frames of a file as a motion of dimension d. The first one with points has been read to learn what they are.
template <int d>
class Replayed_frames {
  public:
    Replayed_frames(Motion_reader& reader, Frame&& first, std::uint64_t empty_before, const Replay_call& call)
        : reader_(reader),
          frame_(std::move(first)),
          empty_before_(empty_before),
          coincident_(call.on_coincident()),
          first_(points_of<d>(reader.name(), frame_, coincident_)) {
        if (d == 2 && call.dimension == 0 && reader.has_z()) z_ = frame_.position.front()[2];
        require_flat();
    }

    [[nodiscard]] double spacing() const { return spacing_of<d>(first_.x); }
    [[nodiscard]] bool at_end() { return empty_before_ == 0 && !first_waits_ && reader_.at_end(); }

    bool next(Frame_points<d>& frame) {
        if (empty_before_ > 0) {
            --empty_before_;
            frame = {};
        } else if (std::exchange(first_waits_, false)) {
            frame = std::exchange(first_, {});
        } else {
            if (!reader_.next(frame_)) return false;
            require_flat();
            frame = points_of<d>(reader_.name(), frame_, coincident_);
        }
        return true;
    }

  private:
    /// What cannot be read twice was taken for a motion of the plane by its first points.
    void require_flat() const {
        for (std::size_t i = 0; z_ && i < frame_.position.size(); ++i)
            if (frame_.position[i][2] != *z_)
                throw Input_error(Error_code::bad_input, reader_.name(), frame_.line[i],
                                  "z is not that of all points before", "--dim 3, or --dim 2 to drop z");
    }

    Motion_reader& reader_;
    Frame frame_;
    std::uint64_t empty_before_;
    bool first_waits_ = true;
    Coincident coincident_;
    Frame_points<d> first_;
    std::optional<double> z_;
};

template <class Moving>
int replay(const Replay_call& a, const std::string& command, Motion_reader& reader, Frame&& first,
           std::uint64_t empty_before, Clock::time_point begin) {
    constexpr int d = Moving::dimension_of_space;
    Replayed_frames<d> frames(reader, std::move(first), empty_before, a);
    const double spacing = frames.spacing();
    Frame_points<d> frame;
    (void)frames.next(frame);
    Traffic traffic{.merged = frame.merged};
    const bool files = !a.common.output.empty();
    if (files) require_writable(a.common);
    Tracker<Moving> tracker(a.tracking.strategy, frame.x, options_of(a.tracking, a.common), spacing, unknown_iterations,
                            a.tracking.audit, files);
    if (!files) tracker.forget_steps();
    std::optional<Picture> before;
    if (files) before = picture(tracker.triangulation(), "before");

    Present present{std::move(frame.id), std::vector<Index>(frame.x.size())};
    std::iota(present.index.begin(), present.index.end(), Index{0});
    const auto step = [&] {
        Frame_change<d> change(present, tracker.triangulation().positions(), frame);
        const auto indices = tracker.follow(change.leave, change.x, change.arrive, change.mean(), change.max);
        auto arrived = indices.begin();
        for (Index& index : change.index)
            if (index == none) index = *arrived++;
        present = {std::move(frame.id), std::move(change.index)};
        traffic.arrived += indices.size();
        traffic.left += change.leave.size();
        traffic.merged += frame.merged;
    };
    std::optional<Interruption_guard> guard;
    if (files) guard.emplace();
    std::optional<Input_error> fault;
    try {
        Progress progress("replay", 0, a.common.quiet);
        if (frames.at_end()) tracker.ends_after(0);
        while (!Interruption_guard::interrupted() && frames.next(frame)) {
            if (frames.at_end()) tracker.ends_after(tracker.record().iterations + 1);
            step();
            char news[40];
            std::snprintf(news, sizeof news, "%.2f %% within tolerance", 100 * tracker.share_within());
            progress.show(tracker.record().iterations, news, reader.share_read());
        }
    } catch (const Input_error& error) {
        // Whoever is interrupted on a terminal gets the end of a pipe, too: its other end has had the same signal.
        if (!files || (tracker.record().iterations == 0 && !Interruption_guard::interrupted())) throw;
        fault = error;
    }
    tracker.finish(command, a.common.seed, since(begin));
    std::vector<std::string> notes = reader.notes();
    notes.insert(notes.begin(), traffic.in_words());
    if (files) write(a.common, tracker, std::move(before), notes);
    a.common.say_notes(reader.notes());
    if (fault && !Interruption_guard::interrupted())
        throw Input_error(fault->code(), fault->file(), fault->line(), fault->fault(),
                          fault->expected() + "; what was done before is in " + partial(a.common.output));
    if (tracker.record().interrupted) {
        say_interrupted(a.common, tracker.record().iterations);
        return done;
    }
    if (!a.common.quiet) {
        print_summary(tracker);
        std::printf("points         %s\n", notes.front().c_str());
        if (files) std::printf("written to     %s\n", a.common.output.c_str());
    }
    return tracker.record().audit.failed == 0 ? done : audit_failed;
}

/// Of the plane where z is the same everywhere; where the file cannot be read twice, in its first frame with points.
int dimension_of(const Replay_call& a, const Motion_reader& reader, const Frame& first) {
    if (!reader.has_z()) return 2;
    std::error_code ignored;
    if (!is_standard_input(a.file) && std::filesystem::is_regular_file(a.file, ignored))
        return is_flat(a.file, a.motion) ? 2 : 3;
    return std::all_of(first.position.begin(), first.position.end(),
                       [&](const auto& p) { return p[2] == first.position.front()[2]; })
               ? 2
               : 3;
}

int run(const Replay_call& a, const std::string& command) {
    const auto begin = Clock::now();
    (void)options_of(a.tracking, a.common);  // wrong usage is told before a file is opened
    Motion_reader reader(a.file, a.motion);
    Frame first;
    std::uint64_t empty_before = 0;
    while (reader.next(first) && first.id.empty()) ++empty_before;
    if (a.dimension == 3 && !reader.has_z())
        throw Input_error(Error_code::bad_input, reader.name(), 0, "points have no z",
                          "a third coordinate for --dim 3");
    return (a.dimension != 0 ? a.dimension : dimension_of(a, reader, first)) == 2
               ? replay<Moving_delaunay_2>(a, command, reader, std::move(first), empty_before, begin)
               : replay<Moving_delaunay_3>(a, command, reader, std::move(first), empty_before, begin);
}

}  // namespace

Run add_replay_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("replay", "A recorded motion, the triangulation kept right throughout");
    const auto a = std::make_shared<Replay_call>();
    sub->add_option("FILE", a->file,
                    "Frames: .xyz (extended XYZ), .lammpstrj (LAMMPS dump) or .csv with columns frame, id, x, y [, z];\n"
                    ".gz after it unpacks; - is standard input")
        ->required();
    add_format(*sub, a->motion.format, frame_formats);
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
    return [a, command = command_line(invocation.words)] {
        a->motion.absent = a->absent == "empty"  ? Absent_frames::empty
                           : a->absent == "skip" ? Absent_frames::skip
                                                 : Absent_frames::refuse;
        return run(*a, command);
    };
}

}  // namespace annulus::cli
