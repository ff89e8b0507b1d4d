// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/delaunay_mesh.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/input.h>
#include <apps/cli/print_degeneracy.h>
#include <apps/cli/progress.h>
#include <apps/cli/raw_file.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/formats/distinct.h>
#include <apps/formats/read_points.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_json.h>
#include <apps/report/degeneracy_series.h>

#include <algorithm>
#include <charconv>
#include <cmath>
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
    std::string columns;                 // of a table
    std::optional<std::uint64_t> frame;  // the number of the frame to study, if the file is a motion
    std::uint64_t every = 0;             // study every N-th frame of a motion; 0: a point set, or `frame`
    std::vector<std::string> thresholds;
    std::string raw;

    [[nodiscard]] bool of_motion() const { return frame || every > 0; }
};

/// Each threshold as text, for example "1e-4", and as a number.
std::vector<std::pair<std::string, double>> thresholds_of(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, double>> thresholds;
    for (const std::string& word : words) {
        double value = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error != std::errc() || stop != end || !(value > 0) || !std::isfinite(value))
            throw Error(Error_code::usage, "--thresholds: '" + word + "' is not a positive number");
        for (const auto& [name, other] : thresholds)
            if (other == value) throw Error(Error_code::usage, "--thresholds: " + word + " is named twice");
        thresholds.emplace_back(word, value);
    }
    if (thresholds.size() > Degeneracy_options<2>::most_thresholds)
        throw Error(Error_code::usage,
                    "--thresholds takes " + std::to_string(Degeneracy_options<2>::most_thresholds) + " at most");
    return thresholds;
}

/// Precondition: the points x are distinct. `id` has their ids, which are written as `ids`.
template <int d>
Degeneracy_record study_points(const Degeneracy_call& a, std::string file, const std::vector<Coordinates<d>>& x,
                               std::span<const std::uint64_t> id, const Point_ids& ids) {
    Degeneracy_record r;
    r.file = std::move(file);
    r.dimension = d;
    r.vertices = x.size();
    const auto begin = Clock::now();
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    r.seconds_triangulation = since(begin);
    const auto built = Clock::now();
    r.affine_dimension = mesh.dimension();
    std::vector<Index> corners;
    mesh.list_cells(x, corners);
    r.simplices = corners.size() / (d + 1);
    std::optional<Raw_file<d>> raw;
    if (!a.raw.empty()) raw.emplace(a.raw, id, ids);
    if (r.affine_dimension == d) {
        Degeneracy_options<d> options;
        options.threads = a.common.threads;
        if (!a.thresholds.empty()) options.thresholds = thresholds_of(a.thresholds);
        if (raw) options.raw = [&raw](const Raw_certificate<d>& c) { (*raw)(c); };
        r.measured = degeneracy(mesh.table(), x, options);
    }
    if (raw) raw->commit();
    r.seconds_analysis = since(built);
    return r;
}

template <int d>
Degeneracy_record study(const Degeneracy_call& a, const Point_file<d>& file) {
    const std::vector<Coordinates<d>> x = distinct_points(file, 2);
    std::vector<std::uint64_t> place;  // for each distinct point, its index in the file
    const auto first = first_at_place<d>(file.points);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] == i) place.push_back(i);
    Degeneracy_record r = study_points<d>(a, file.name, x, place, {});
    r.points = file.points.size();
    r.input = input_of(file);
    return r;
}

template <int d>
Degeneracy_record study(const Degeneracy_call& a, const Motion_reader& reader, const Frame_points<d>& frame) {
    Degeneracy_record r = study_points<d>(a, reader.name(), frame.x, frame.id, reader.ids());
    r.points = frame.x.size() + frame.merged;
    r.input = input_of(reader, d);
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
void study_motion(const Degeneracy_call& a, const std::string& command, Replayed_frames<d>& frames) {
    Degeneracy_series series{command, frames.reader().name(), d, a.thresholds, {}, {}};
    if (series.thresholds.empty())
        for (const auto& threshold : Degeneracy_options<d>().thresholds) series.thresholds.push_back(threshold.first);
    series.thresholds.emplace_back("ulp");
    if (!a.common.quiet) print_degeneracy_head(series);
    Frame_points<d> frame;
    std::optional<Progress> progress(std::in_place, "degeneracy", 0, a.common.quiet);
    for (std::uint64_t i = 0; frames.next(frame); ++i) {
        if (i % a.every != 0) continue;
        series.rows.push_back(degeneracy_row(frame.number, study<d>(a, frames.reader(), frame)));
        progress->show(i, "", frames.reader().share_read());
        if (!a.common.quiet) print_degeneracy(series.rows.back());
    }
    progress.reset();
    series.input = input_of(frames.reader(), d);
    a.common.say_notes(series.input.warnings);
    if (!a.common.quiet) print_input(series.input, d);
    const Csv_table table = degeneracy_table(series);
    write(a, series, &table);
}

template <int d>
void study_frame(const Degeneracy_call& a, const std::string& command, Replayed_frames<d>& frames) {
    Frame_points<d> frame;
    while (frames.next(frame))
        if (frame.number == *a.frame) {
            if (frame.x.size() < 2)
                throw Input_error(Error_code::too_few, frames.reader().name(), 0,
                                  "frame " + std::to_string(frame.number) + " has " + counted(frame.x.size(), "point"),
                                  "two at least");
            return finish(a, study<d>(a, frames.reader(), frame), command);
        }
    throw Input_error(Error_code::bad_input, frames.reader().name(), 0, "has no frame " + std::to_string(*a.frame),
                      "a number that the file has (in .xyz frames are counted from 0)");
}

void run_motion(const Degeneracy_call& a, const std::string& command) {
    Replay_arguments replay{a.file, a.ignore_z ? 2 : a.dimension, "merge", "skip", a.format, a.open, a.columns};
    Opened_motion motion = open_motion(replay);
    const auto with = [&]<int d>(std::integral_constant<int, d>) {
        Replayed_frames<d> frames(motion, replay);
        if (a.frame) study_frame<d>(a, command, frames);
        else study_motion<d>(a, command, frames);
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
        const Read_options options{.ignore_z = a.ignore_z,
                                   .format = a.format,
                                   .box = {.ignored = a.open},
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
        return run(*a, command);
    };
}

}  // namespace annulus::inline v1::cli
