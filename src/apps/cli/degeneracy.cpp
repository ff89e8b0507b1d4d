// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/degeneracy_study.h>
#include <apps/cli/input.h>
#include <apps/cli/print_degeneracy.h>
#include <apps/cli/progress.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/result_files.h>
#include <apps/formats/read_points.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_json.h>
#include <apps/report/degeneracy_series.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

struct Degeneracy_call {
    Common_arguments common;
    std::string file;
    int dimension = 0;  // 0: that of the file
    bool ignore_z = false;
    std::string format;
    bool open = false;                   // a periodic box is ignored
    std::string box;                     // in place of that of the file
    std::string columns;                 // of a table
    std::optional<std::uint64_t> frame;  // the number of the frame to study, if the file is a motion
    std::uint64_t every = 0;             // study every N-th frame of a motion; 0: a point set, or `frame`
    std::vector<std::string> thresholds;
    std::string raw;

    [[nodiscard]] bool of_motion() const { return frame || every > 0; }
    [[nodiscard]] Study_options study() const { return {common.threads, thresholds, raw}; }
};

/// The box of --box, else that of the file, if it is periodic in all directions, and what says so.
template <int d>
std::pair<std::optional<Box<d>>, std::string> box_of_points(const Degeneracy_call& a, const Point_file<d>& file) {
    if (!a.box.empty()) return {box_of<d>(parse_box(a.box)), "--box"};
    if (!file.box || !is_periodic(*file.box, d, file.name)) return {};
    return {box_of<d>(*file.box, file.name), file.box->what};
}

template <int d>
Degeneracy_record study(const Degeneracy_call& a, const Point_file<d>& file) {
    const auto [box, box_from] = box_of_points<d>(a, file);
    const auto [x, index] = distinct_points(file, box ? 1 : 2, box ? &*box : nullptr);
    Degeneracy_record r = study_points<d>({file.name, x, index, {}, box}, a.study());
    r.points = file.points.size();
    r.input = input_of(file);
    r.input.box_from = box_from;
    if (box)
        for (const auto& vector : box->vectors()) r.input.box.emplace_back(vector.begin(), vector.end());
    return r;
}

template <int d>
Degeneracy_record study(const Degeneracy_call& a, const Opened_motion& motion, const Replayed_frames<d>& frames,
                        const Frame_points<d>& frame) {
    std::optional<Box<d>> box;
    if (motion.periodic) box = frames.box();
    Degeneracy_record r =
        study_points<d>({motion.reader.name(), frame.x, frame.id, motion.reader.ids(), box}, a.study());
    r.points = frame.x.size() + frame.merged;
    r.input = frames.input(motion);
    return r;
}

bool is_degeneracy(std::string_view name) {
    return name == "degeneracy.json" || name == "degeneracy.html" || name == "degeneracy.csv";
}

template <class Content>
void write(const Degeneracy_call& a, const Content& content, const Csv_table* table) {
    if (a.common.output.empty()) return;
    Result_files out(a.common, is_degeneracy);
    out.write("degeneracy.json", write_json(degeneracy_json(content)));
    if (table != nullptr) out.write("degeneracy.csv", write_csv(*table));
    out.write("degeneracy.html", degeneracy_html(content));
    out.commit();
}

void finish(const Degeneracy_call& a, Degeneracy_record r, const std::string& command) {
    r.command = command;
    a.common.say_merged(r.file, r.points - r.vertices);
    a.common.say_notes(r.input.warnings);
    write(a, r, nullptr);
    if (!a.common.quiet) print_degeneracy(r);
}

/// Studies every N-th frame, for curves.
template <int d>
void study_motion(const Degeneracy_call& a, const std::string& command, const Opened_motion& motion,
                  Replayed_frames<d>& frames) {
    Degeneracy_series series{command, frames.reader().name(), d, a.thresholds, {}, {}};
    if (series.thresholds.empty())
        for (const auto& threshold : Degeneracy_options<d>().thresholds) series.thresholds.push_back(threshold.first);
    series.thresholds.emplace_back("ulp");
    if (!a.common.quiet) print_degeneracy_head(series);
    Frame_points<d> frame;
    std::optional<Progress> progress(std::in_place, "degeneracy", 0, a.common.quiet);
    for (std::uint64_t i = 0; frames.next(frame); ++i) {
        if (i % a.every != 0) continue;
        series.rows.push_back(degeneracy_row(frame.number, study<d>(a, motion, frames, frame)));
        progress->show(i, "", frames.reader().share_read());
        if (!a.common.quiet) print_degeneracy(series.rows.back());
    }
    progress.reset();
    series.input = frames.input(motion);
    a.common.say_notes(series.input.warnings);
    if (!a.common.quiet) print_input(series.input, d);
    const Csv_table table = degeneracy_table(series);
    write(a, series, &table);
}

template <int d>
void study_frame(const Degeneracy_call& a, const std::string& command, const Opened_motion& motion,
                 Replayed_frames<d>& frames) {
    Frame_points<d> frame;
    while (frames.next(frame))
        if (frame.number == *a.frame) {
            const std::size_t least = motion.periodic ? 1 : 2;
            if (frame.x.size() < least)
                throw Input_error(Error_code::too_few, frames.reader().name(), 0,
                                  "frame " + std::to_string(frame.number) + " has " + counted(frame.x.size(), "point"),
                                  least == 1 ? "one at least" : "two at least");
            return finish(a, study<d>(a, motion, frames, frame), command);
        }
    throw Input_error(Error_code::bad_input, frames.reader().name(), 0, "has no frame " + std::to_string(*a.frame),
                      "a number that the file has (in .xyz frames are counted from 0)");
}

void run_motion(const Degeneracy_call& a, const std::string& command) {
    Replay_arguments replay{a.file, a.ignore_z ? 2 : a.dimension, "merge", "skip", a.format, a.open, a.columns, true,
                            a.box};
    Opened_motion motion = open_motion(replay);
    const auto with = [&]<int d>(std::integral_constant<int, d>) {
        Replayed_frames<d> frames(motion, replay);
        if (a.frame) study_frame<d>(a, command, motion, frames);
        else study_motion<d>(a, command, motion, frames);
    };
    if (motion.dimension == 2) with(std::integral_constant<int, 2>());
    else with(std::integral_constant<int, 3>());
}

int run(const Degeneracy_call& a, const std::string& command) {
    (void)thresholds_of(a.thresholds);
    if (!a.raw.empty()) require_replaceable(a.raw);
    std::error_code ignored;
    if (!a.raw.empty() && !a.common.force && std::filesystem::exists(std::filesystem::symlink_status(a.raw, ignored)))
        throw Error(Error_code::usage, a.raw + " already exists; --force replaces it");
    if (!a.common.output.empty()) require_writable(a.common, is_degeneracy);
    if (a.of_motion()) {
        run_motion(a, command);
    } else {
        const Read_options options{
            .ignore_z = a.ignore_z,
            .format = a.format,
            .box = {.taken = !a.open && a.box.empty(), .replaced = !a.box.empty(), .ignored = a.open},
            .columns = parse_column_choice(a.columns)};
        std::variant<Point_file<2>, Point_file<3>> file;
        if (a.dimension == 2) file = read_points<2>(a.file, options);
        else if (a.dimension == 3) file = read_points<3>(a.file, options);
        else file = read_points_of_any_dimension(a.file, options);
        std::visit([&]<int d>(const Point_file<d>& points) { finish(a, study<d>(a, points), command); }, file);
    }
    if (!a.common.quiet && !a.common.output.empty()) std::printf("written to     %s\n", a.common.output.c_str());
    return done;
}

}  // namespace

Run add_degeneracy_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand(
        "degeneracy", "How degenerate points are: certified counts and distributions of their Delaunay triangulation");
    const auto a = std::make_shared<Degeneracy_call>();
    sub->add_option(
           "FILE", a->file,
           "Points, .xyz, .csv, .lammpstrj, .npy, .off, .ply or .mesh, or a motion with --frame or --every; - is "
           "standard input")
        ->required();
    add_format(*sub, a->format, point_formats);
    add_columns(*sub, a->columns);
    auto* dimension = sub->add_option("--dim", a->dimension, "2 or 3; default: that of the file")
                          ->type_name("D")
                          ->check(whole_number(2, 3));
    sub->add_flag("--ignore-z", a->ignore_z, "Drop the z coordinate of the file");
    add_open(*sub, a->open);
    add_box(*sub, a->box);
    auto* frame =
        sub->add_option("--frame", a->frame, "The frame of a motion with number N in the file (.xyz: counted from 0)")
            ->type_name("N")
            ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
    auto* every =
        sub->add_option("--every", a->every, "Every N-th frame of a motion, from the first: degeneracy.csv, and curves")
            ->type_name("N")
            ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
            ->excludes(frame);
    sub->add_option("--thresholds", a->thresholds,
                    "Widths to count below, in mean spacings, separated by commas (1e-3,1e-6,1e-9,1e-12)")
        ->delimiter(',')
        ->type_name("LIST");
    sub->add_option("--raw", a->raw, "Write every certificate to this file, one line of CSV each; .gz compresses it")
        ->type_name("FILE")
        ->excludes(every);
    add_common(*sub, a->common, "degeneracy.json and degeneracy.html",
               {no_seed, "Threads that look at certificates together; results do not depend on them"});
    return [a, dimension, command = command_line(invocation.words)] {
        if (a->ignore_z && dimension->count() > 0 && a->dimension == 3)
            throw Error(Error_code::usage, "--ignore-z and --dim 3 exclude each other");
        if (a->open && !a->box.empty()) throw Error(Error_code::usage, "--open and --box exclude each other");
        if (!a->box.empty()) (void)dimension_of_box(parse_box(a->box));
        return run(*a, command);
    };
}

}  // namespace annulus::inline v1::cli
