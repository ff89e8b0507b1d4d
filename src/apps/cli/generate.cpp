// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/frame_box.h>
#include <apps/cli/interruption.h>
#include <apps/cli/progress.h>
#include <apps/formats/input_error.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_frames.h>
#include <apps/motion/boxed_points.h>
#include <apps/motion/crystal.h>
#include <apps/motion/generated_motion.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

template <class Families>
std::vector<std::string> words_of(const Families& families) {
    std::vector<std::string> words;
    for (const auto& family : families) words.emplace_back(family.first);
    return words;
}

struct Generate_call {
    std::string kind;
    std::string from = "uniform";
    std::uint64_t points = 0;
    int dimension = 0;  // 0: that of the box, else 2
    std::string box;    // empty: open boundaries
    double vibration = 0;
    std::uint64_t steps = 100;
    double pace = 0.01;
    std::string output = "-";
    std::string format;
    bool force = false;
    std::uint64_t seed = 1;
    int threads = 1;
    bool quiet = false;

    [[nodiscard]] std::optional<Motion_family> motion() const { return family_named(motion_families, kind); }
    /// The points, or those that a motion begins with.
    [[nodiscard]] const std::string& of_points() const { return motion() ? from : kind; }
    [[nodiscard]] std::optional<Crystal> crystal() const { return family_named(crystals, of_points()); }
};

/// The refusal of a number of points that no whole unit cells have.
template <int d>
Error not_whole(const Generate_call& a, const Box<d>& box, Crystal crystal) {
    std::string fitting;
    for (const std::size_t n : numbers_that_fit<d>(box, crystal, static_cast<std::size_t>(a.points)))
        fitting += (fitting.empty() ? "" : " or ") + std::to_string(n);
    return {Error_code::usage, "--points " + std::to_string(a.points) + ": unit cells of " + a.of_points() + ", " +
                                   counted(points_of_unit_cell(crystal), "point") +
                                   " each, fill this box with edges as equal as can be" +
                                   (fitting.empty() ? " with another number of points" : " with " + fitting)};
}

template <int d>
std::vector<Coordinates<d>> points_in(const Generate_call& a, const Box<d>& box) {
    const auto n = static_cast<std::size_t>(a.points);
    const std::optional<Crystal> crystal = a.crystal();
    if (!crystal) return generate_in<d>(box, *family_named(point_families, a.of_points()), n, a.seed);
    const auto cells = unit_cells<d>(box, *crystal, n);
    if (!cells) throw not_whole(a, box, *crystal);
    std::vector<Coordinates<d>> points = crystal_in<d>(box, *crystal, *cells);
    if (a.vibration > 0) vibrate<d>(points, a.vibration * spacing_in<d>(box, n), a.seed);
    return points;
}

template <int d>
Generated_motion<d> motion_of(const Generate_call& a) {
    const Motion_family family = a.motion().value_or(Motion_family::walk);
    if (a.box.empty())
        return Generated_motion<d>(
            generate<d>(*family_named(point_families, a.of_points()), static_cast<std::size_t>(a.points), a.seed),
            family, a.pace, a.seed);
    const Box<d> box = box_of<d>(parse_box(a.box));
    return Generated_motion<d>(box, points_in<d>(a, box), family, a.pace, a.seed);
}

template <int d>
int write_motion(const Generate_call& a, Format format) {
    const std::uint64_t steps = a.motion() ? a.steps : 0;
    Generated_motion<d> motion = motion_of<d>(a);
    const Interruption_guard guard;  // before the file, which is removed if it is incomplete
    Text_output out(a.output);
    std::string text;
    Progress progress("generate", steps, a.quiet);
    for (std::uint64_t i = 0;; ++i) {
        if (Interruption_guard::interrupted()) return done;
        text.clear();
        append_frame<d>(text, format, i, motion.points(), motion.box());
        out.write(text);
        progress.show(i, counted(text.size(), "byte") + " a frame");
        if (i == steps) break;
        motion.step();
    }
    out.commit();
    return done;
}

Format format_of_output(const Generate_call& a) {
    if (a.output == "-" && a.format.empty()) return Format::xyz;
    try {
        const Format format = format_of(a.output, written_formats, a.format);
        if (format == Format::csv && a.format.empty() && !has_usual_extension_of(a.output, format))
            throw Error(Error_code::usage,
                        a.output + ": a table that is written is called .csv; --format csv writes it");
        return format;
    } catch (const Input_error& error) {  // the file is not an input here
        throw Error(Error_code::usage, error.what());
    }
}

/// That of the box, else of the option, which agree with each other and with the crystal.
int dimension_of(const Generate_call& a) {
    const std::optional<Crystal> crystal = a.crystal();
    if (a.box.empty() && crystal)
        throw Error(Error_code::usage, a.of_points() + " is a crystal, which fills a periodic box: --box LIST");
    if (a.box.empty()) return a.dimension == 0 ? 2 : a.dimension;
    const int dimension = dimension_of_box(parse_box(a.box));
    if (a.dimension != 0 && a.dimension != dimension)
        throw Error(Error_code::usage,
                    "--dim " + std::to_string(a.dimension) + ", and --box is in " + std::to_string(dimension) + "D");
    if (crystal && dimension_of(*crystal) != dimension)
        throw Error(Error_code::usage, a.of_points() + " is a crystal in " + std::to_string(dimension_of(*crystal)) +
                                           "D, and --box is in " + std::to_string(dimension) + "D");
    return dimension;
}

int run(const Generate_call& a) {
    if (!(a.pace >= 0 && a.pace <= 1000)) throw Error(Error_code::usage, "--pace is not a number from 0 to 1000");
    if (!(a.vibration >= 0 && a.vibration <= 1000))
        throw Error(Error_code::usage, "--vibration is not a number from 0 to 1000");
    const int dimension = dimension_of(a);
    const Format format = format_of_output(a);
    if (!a.box.empty() && format == Format::csv)
        throw Error(Error_code::usage, "a table has no place for a periodic box: with --box write .xyz or .lammpstrj");
    require_replaceable(a.output);
    std::error_code ignored;
    if (a.output != "-" && !a.force && std::filesystem::exists(std::filesystem::symlink_status(a.output, ignored)))
        throw Error(Error_code::usage, a.output + " already exists; --force replaces it");
    return dimension == 2 ? write_motion<2>(a, format) : write_motion<3>(a, format);
}

}  // namespace

Run add_generate_command(CLI::App& app, const Invocation&) {
    auto* sub = app.add_subcommand("generate", "Point sets and motions by name, for tests, benchmarks and sweeps");
    const auto a = std::make_shared<Generate_call>();
    std::vector<std::string> points = words_of(point_families);
    for (const std::string& crystal : words_of(crystals)) points.push_back(crystal);
    std::vector<std::string> kinds = points;
    for (const std::string& motion : words_of(motion_families)) kinds.push_back(motion);
    sub->add_option("KIND", a->kind,
                    "Points of the unit square or cube, or of --box: uniform, grid, jittered, cospherical, clusters,\n"
                    "surface; crystals in --box: square, triangular (2D), sc, bcc, fcc, diamond (3D);\n"
                    "or a motion of such points: walk, shear, orbit")
        ->required()
        ->check(CLI::IsMember(kinds));
    sub->add_option("-n,--points", a->points, "How many points")
        ->required()
        ->type_name("N")
        ->check(whole_number(1, 100'000'000));
    sub->add_option("--dim", a->dimension, "Dimension; default: that of --box, else 2")
        ->type_name("D")
        ->check(whole_number(2, 3));
    sub->add_option("--box", a->box,
                    "Periodic box, written with the points: the lengths of its edges, Lx,Ly or Lx,Ly,Lz, or its\n"
                    "vectors, 4 or 9 numbers, one vector after the other")
        ->type_name("LIST");
    auto* vibration =
        sub->add_option("--vibration", a->vibration,
                        "Standard deviation of each coordinate from its place in a crystal, in mean spacings")
            ->type_name("S");
    std::vector<CLI::Option*> of_motions;
    of_motions.push_back(sub->add_option("--from", a->from, "The initial points of a motion")
                             ->check(CLI::IsMember(points))
                             ->capture_default_str());
    of_motions.push_back(sub->add_option("--steps", a->steps, "Steps of a motion; it has one more frame")
                             ->type_name("N")
                             ->check(whole_number(0, 1'000'000'000))
                             ->capture_default_str());
    of_motions.push_back(
        sub->add_option("--pace", a->pace, "How far points move in a step, in spacings of a grid of as many points")
            ->capture_default_str());
    sub->add_option("-o,--output", a->output, "Write to this file; .gz compresses it; -: standard output")
        ->type_name("FILE")
        ->capture_default_str();
    add_format(*sub, a->format, written_formats);
    sub->get_option("--format")
        ->description("What to write, whatever the extension says; standard output has none: xyz without this");
    sub->add_flag("--force", a->force, "Replace the file");
    sub->add_option("--seed", a->seed, "Seed of everything random")
        ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    sub->add_option("--threads", a->threads, no_threads)->check(whole_number(1, 1024))->capture_default_str();
    sub->add_flag("-q,--quiet", a->quiet, "No progress, only errors and the exit status");
    return [a, of_motions, vibration] {
        for (const CLI::Option* option : of_motions)
            if (option->count() > 0 && !family_named(motion_families, a->kind))
                throw Error(Error_code::usage, option->get_name() + " is for motions: walk, shear, orbit");
        if (vibration->count() > 0 && !a->crystal())
            throw Error(Error_code::usage, "--vibration is for crystals: square, triangular, sc, bcc, fcc, diamond");
        return run(*a);
    };
}

}  // namespace annulus::inline v1::cli
