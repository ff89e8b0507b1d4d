// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/files.h>
#include <apps/cli/frame_follower.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/plane_view.h>
#include <apps/cli/progress.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/formats/formatted.h>
#include <apps/report/axis_ticks.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

struct Replay_call {
    Common_arguments common;
    Tracking_arguments tracking;
    Replay_arguments replay;
    Frame_arguments frames;
};

/// The solid cells in an order that does not depend on the history of the triangulation.
template <class Moving>
std::vector<typename Run_page<Moving>::Cell> ordered_cells(const Moving&) {
    return {};
}
template <>
std::vector<Run_page<Moving_mesh_3>::Cell> ordered_cells(const Moving_mesh_3& dt) {
    Mesh_3 mesh;
    mesh.read(dt);
    return mesh.cells().vertices;
}

/// A triangulation that moves from frame to frame, and the data that is written for each frame.
template <class Moving>
class Replay {
  public:
    static constexpr int d = Moving::dimension_of_space;
    using Follows = typename Frame_follower<Moving>::Follows;

    Replay(const Replay_call& a, const Options& options, Replayed_frames<d>& frames)
        : frames_(frames),
          films_(!a.common.output.empty()),
          views_(films_ && options.tolerance == Tolerance_kind::certified),
          follower_(frames),
          tracker_(first_frame(a, options)),
          page_{.step = "frame"} {
        tracker_.note_replay();
        if (!films_) tracker_.forget_steps();
        else files_.emplace(a.common, a.frames, tracker_);
        if (files_) files_->write_ids_as(frames.reader().ids());
        follower_.begin(frame_, files());
        note_frame();
        if (auto first = view()) {
            tracker_.plane_before(first->measures);
            page_.voronoi.push_back(std::move(first->cells));
        }
        if (frames_.at_end()) tracker_.ends_after(0);
    }

    /// One step; false after the last.
    bool next() {
        if (!frames_.next(frame_)) return false;
        if (frames_.at_end()) tracker_.ends_after(tracker_.record().iterations + 1);
        follower_.step(tracker_, frame_, files(), traffic_);
        traffic_.merged += frame_.merged;
        note_frame();
        return true;
    }

    [[nodiscard]] Follows& tracker() { return tracker_; }
    [[nodiscard]] const Traffic& traffic() const { return traffic_; }

    void write(const Common_arguments& arguments, std::vector<std::string> notes) {
        if (films_)
            page_.film.add(tracker_.record().iterations, picture_of(tracker_.triangulation(), caption_, page_.cut),
                           true);
        if (auto last = tracker_.record().iterations > 0 ? view() : std::nullopt) {
            tracker_.plane_after(last->measures);
            page_.voronoi.push_back(std::move(last->cells));
        }
        page_.notes = std::move(notes);
        if (tracker_.record().clip && files_->records().back().voronoi) page_.notes.push_back(on_clip());
        page_.cells = ordered_cells(tracker_.triangulation());
        page_.figures = frame_figures(files_->records(), tracker_.record(), true);
        page_.frames = &*files_;
        write_run(arguments, tracker_, std::move(page_));
    }

  private:
    /// How many cells a clip leaves in the last frame, a sentence.
    [[nodiscard]] std::string on_clip() const {
        const Frame_record& last = files_->records().back();
        const std::uint64_t reach = last.voronoi->bounded;
        return "In the last frame " + none_or(reach) + " of " + grouped(last.points, "Voronoi cell") +
               (reach == 1 ? " reaches" : " reach") + " the clipping region, " + none_or(last.voronoi->whole) +
               (last.voronoi->whole == 1 ? " is" : " are") + " wholly inside.";
    }
    Follows first_frame(const Replay_call& a, const Options& options) {
        (void)frames_.next(frame_);
        traffic_.merged = frame_.merged;
        if (films_) require_writable(a.common);
        return {a.tracking.strategy,
                follower_.make(frame_, options),
                options,
                frames_.spacing(),
                unknown_iterations,
                a.tracking.audit,
                films_};
    }
    /// Only a Delaunay triangulation in 2D has Voronoi cells to show.
    [[nodiscard]] std::optional<Plane_view> view() const {
        if (!views_) return {};
        const std::optional<Clip_record>& clip = tracker_.record().clip;
        std::string caption = (clip ? "Clipped Voronoi cells, f" : "Voronoi cells, f") + caption_.substr(1);
        return plane_view(tracker_.triangulation(), clip, std::move(caption));
    }
    Frame_files<Moving>* files() { return files_ ? &*files_ : nullptr; }
    void note_frame() {
        if (!files_) return;
        files_->frame(frame_.number);
        caption_ = "Frame " + grouped(frame_.number);
        const std::uint64_t step = tracker_.record().iterations;
        if (page_.film.includes(step)) page_.film.add(step, picture_of(tracker_.triangulation(), caption_, page_.cut));
    }

    Replayed_frames<d>& frames_;
    bool films_, views_;
    Frame_points<d> frame_;
    Traffic traffic_;
    Frame_follower<Moving> follower_;
    Follows tracker_;
    Run_page<Moving> page_;
    std::optional<Frame_files<Moving>> files_;
    std::string caption_;  // of the last frame
};

template <class Moving>
int replay(const Replay_call& a, const Options& options, const std::string& command, Opened_motion& motion,
           Clock::time_point begin) {
    Replayed_frames<Moving::dimension_of_space> frames(motion, a.replay);
    Replay<Moving> run(a, options, frames);
    const Run_tracker<Moving>& tracker = run.tracker();
    const bool files = !a.common.output.empty();
    std::optional<Interruption_guard> guard;
    if (files) guard.emplace();
    std::optional<Input_error> fault;
    try {
        Progress progress("replay", 0, a.common.quiet);
        while (!Interruption_guard::interrupted() && run.next()) {
            progress.show(tracker.record().iterations,
                          formatted("%.2f %% within tolerance", 100 * tracker.share_within()),
                          motion.reader.share_read());
        }
    } catch (const Input_error& error) {
        // An interrupt from a terminal also ends a pipe, because the program at its other end gets the same signal.
        if (!files || (tracker.record().iterations == 0 && !Interruption_guard::interrupted())) throw;
        fault = error;
    }
    run.tracker().finish(command, a.common.seed, since(begin));
    run.tracker().input(frames.input(motion));
    const std::vector<std::string> notes{run.traffic().in_words()};
    if (files) run.write(a.common, notes);
    a.common.say_notes(motion.reader.notes());
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

/// Throws Error(usage) for wrong usage, where boundaries are open or in a periodic box.
Options options_of(const Replay_call& a, bool periodic) {
    static const std::string otherwise = ", or --open for open boundaries";
    if (periodic && !a.frames.clip.empty())
        throw Error(
            Error_code::usage,
            "in a periodic box every Voronoi cell is bounded, and the cells fill the box: no --clip" + otherwise);
    Options options = periodic ? boxed_options_of(a.tracking, a.common, otherwise) : options_of(a.tracking, a.common);
    prepare(a.frames, a.common, options);
    return options;
}

int run(const Replay_call& a, const std::string& command) {
    const auto begin = Clock::now();
    if (a.replay.open && !a.replay.box.empty()) throw Error(Error_code::usage, "--open and --box exclude each other");
    if (!a.replay.box.empty()) (void)parse_box(a.replay.box);
    // Before a file is opened: what is wrong usage whatever its box is.
    (void)options_of(a, !a.replay.box.empty() || (a.tracking.strategy == "signs" && !a.replay.open));
    Opened_motion motion = open_motion(a.replay);
    const Options options = options_of(a, motion.periodic);
    if (motion.periodic)
        return motion.dimension == 2 ? replay<Boxed_mesh<2>>(a, options, command, motion, begin)
                                     : replay<Boxed_mesh<3>>(a, options, command, motion, begin);
    return motion.dimension == 2 ? replay<Moving_mesh_2>(a, options, command, motion, begin)
                                 : replay<Moving_mesh_3>(a, options, command, motion, begin);
}

}  // namespace

Run add_replay_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("replay", "A recorded motion, the triangulation kept right throughout");
    const auto a = std::make_shared<Replay_call>();
    add_replay(*sub, a->replay);
    a->replay.boxed = true;
    add_box(*sub, a->replay.box);
    add_frames(*sub, a->frames);
    add_clip(*sub, a->frames);
    add_tracking(*sub, a->tracking, true);
    add_common(*sub, a->common, run_files);
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
