// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/motion_survey.h>
#include <apps/cli/prefix_costs.h>
#include <apps/cli/print_advice.h>
#include <apps/cli/progress.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/formats/read_points.h>
#include <apps/formats/write_json.h>
#include <apps/report/advice.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

namespace annulus::inline v1::cli {

namespace {

struct Advise_call {
    Common_arguments common;
    Replay_arguments file;
    std::uint64_t steps = 100;
    bool json = false;
};

using Any_points = std::variant<Point_file<2>, Point_file<3>>;

Any_points open_points(const Replay_arguments& a) {
    const Read_options options{.ignore_z = a.dimension == 2,
                               .format = a.format,
                               .box = {.ignored = true},
                               .columns = parse_column_choice(a.columns)};
    if (a.dimension == 2) return read_points<2>(a.file, options);
    if (a.dimension == 3) return read_points<3>(a.file, options);
    return read_points_of_any_dimension(a.file, options);
}

/// A motion, or the points of a file that is none: a table without frames, a mesh. If it is neither, the error is that
/// of the reader that came further.
std::variant<Opened_motion, Any_points> open(const Replay_arguments& a) {
    const Format format = format_of(a.file, point_formats, a.format);
    if (std::find(frame_formats.begin(), frame_formats.end(), format) == frame_formats.end()) return open_points(a);
    if (is_standard_input(a.file) || !std::filesystem::is_regular_file(a.file)) return open_motion(a);  // read once
    try {
        return open_motion(a);
    } catch (const Input_error& as_motion) {
        std::optional<Input_error> as_points;
        try {
            return open_points(a);
        } catch (const Input_error& error) {
            if (error.line() >= as_motion.line()) as_points.emplace(error);
        }
        if (as_points) throw *as_points;
        throw;
    }
}

/// Adds the degeneracy of the first frame with points to the record.
template <int d>
void measure(const Moving_mesh<d>& mesh, const Frame_points<d>& frame, const Advise_call& a, Advice_record& record) {
    const auto begin = Clock::now();
    record.degeneracy_frame = frame.number;
    Degeneracy_options<d> options;
    options.threads = a.common.threads;
    if (mesh.dimension() == d) record.degeneracy = degeneracy(mesh, options);
    record.seconds_analysis = since(begin);
}

/// Looks at frames one after another.
template <int d>
class Examination {
  public:
    Examination(const Advise_call& a, Advice_record& record) : a_(a), record_(record) {}

    void add(const Frame& as_read, const Frame_points<d>& frame, const Point_ids& ids) {
        survey_.add(as_read, frame, ids);
        const auto begin = Clock::now();
        if (costs_) costs_->follow(frame);
        else if (!frame.x.empty()) costs_.emplace(frame, a_.steps, a_.common.threads);
        else return;
        record_.seconds_following += since(begin);
        if (!measured_) measure<d>(costs_->mesh(), frame, a_, record_);
        measured_ = true;
    }
    void finish() {
        record_.motion = survey_.record();
        if (costs_) record_.prefix = costs_->record();
    }

  private:
    const Advise_call& a_;
    Advice_record& record_;
    Motion_survey<d> survey_;
    std::optional<Prefix_costs<d>> costs_;
    bool measured_ = false;
};

template <int d>
void examine(const Advise_call& a, Opened_motion& motion, Advice_record& record) {
    Replay_arguments arguments = a.file;
    arguments.coincident = "merge";
    Replayed_frames<d> frames(motion, arguments);
    Examination<d> examination(a, record);
    Frame_points<d> frame;
    Progress progress("advise", 0, a.common.quiet);
    for (std::uint64_t i = 0; frames.next(frame); ++i) {
        examination.add(frames.as_read(), frame, frames.reader().ids());
        progress.show(i, "", frames.reader().share_read());
    }
    examination.finish();
    record.input = motion.input();
}

template <int d>
void examine(const Advise_call& a, const Point_file<d>& file, Advice_record& record) {
    Frame frame;
    for (std::size_t i = 0; i < file.points.size(); ++i) {
        frame.id.push_back(i);
        frame.position.push_back({});
        std::copy(file.points[i].begin(), file.points[i].end(), frame.position.back().begin());
    }
    frame.line = file.lines;
    const Point_ids ids;
    Examination<d> examination(a, record);
    examination.add(frame, points_of<d>(file.name, frame, Coincident::merge, ids), ids);
    examination.finish();
    record.input = input_of(file);
}

Advice_record examine(const Advise_call& a, const std::string& command) {
    const auto begin = Clock::now();
    Advice_record record{.command = command, .file = a.file.file};
    auto file = open(a.file);
    if (auto* motion = std::get_if<Opened_motion>(&file)) {
        record.file = motion->reader.name();
        record.dimension = motion->dimension;
        if (motion->dimension == 2) examine<2>(a, *motion, record);
        else examine<3>(a, *motion, record);
    } else {
        std::visit(
            [&]<int d>(const Point_file<d>& points) {
                record.file = points.name;
                record.dimension = d;
                examine<d>(a, points, record);
            },
            std::get<Any_points>(file));
    }
    record.seconds_reading = since(begin) - record.seconds_following - record.seconds_analysis;
    return record;
}

int run(const Advise_call& a, const std::string& command) {
    const auto is_advice = [](std::string_view name) { return name == "advise.json"; };
    if (!a.common.output.empty()) require_writable(a.common, is_advice);
    const Advice_record record = examine(a, command);
    a.common.say_notes(record.input.warnings);
    const std::string json = write_json(advice_json(record));
    if (!a.common.output.empty()) {
        Result_files out(a.common, is_advice);
        out.write("advise.json", json);
        out.commit();
    }
    if (a.common.quiet) return done;
    if (a.json) {
        std::printf("%s", json.c_str());
        return done;
    }
    print_advice(record);
    if (!a.common.output.empty()) std::printf("written to     %s\n", a.common.output.c_str());
    return done;
}

}  // namespace

Run add_advise_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand(
        "advise", "Which strategy a motion needs: displacements, duplicates, degeneracy, and what can be gained");
    const auto a = std::make_shared<Advise_call>();
    a->file.absent = "skip";
    a->file.open = true;
    sub->add_option(
           "FILE", a->file.file,
           "A motion, as replay reads it, or points, as degeneracy reads them; a pipe, such as - for standard\n"
           "input, is taken for a motion. A periodic box is ignored")
        ->required();
    add_format(*sub, a->file.format, point_formats);
    add_columns(*sub, a->file.columns);
    sub->add_option("--dim", a->file.dimension, "Dimension; 2 drops z. Without it, 3 if z is not the same everywhere")
        ->type_name("D")
        ->check(whole_number(2, 3));
    sub->add_option("--steps", a->steps,
                    "Count the work of N steps after the first, fewer where they move more than 20 million vertices;\n"
                    "0: of none")
        ->type_name("N")
        ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    sub->add_flag("--json", a->json, "Print JSON instead of text");
    add_common(*sub, a->common, "advise.json",
               {no_seed, "Threads that triangulate and look at certificates; results do not depend on them"});
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
