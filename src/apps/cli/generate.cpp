// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/interruption.h>
#include <apps/cli/progress.h>
#include <apps/formats/input_error.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_frames.h>
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
    int dimension = 2;
    std::uint64_t steps = 100;
    double pace = 0.01;
    std::string output = "-";
    std::string format;
    bool force = false;
    std::uint64_t seed = 1;
    int threads = 1;
    bool quiet = false;
};

template <int d>
int write_motion(const Generate_call& a, Format format) {
    const std::optional<Motion_family> family = family_named(motion_families, a.kind);
    const std::uint64_t steps = family ? a.steps : 0;
    Generated_motion<d> motion(generate<d>(*family_named(point_families, family ? a.from : a.kind),
                                           static_cast<std::size_t>(a.points), a.seed),
                               family.value_or(Motion_family::walk), a.pace, a.seed);
    const Interruption_guard guard;  // before the file, which is removed if it is incomplete
    Text_output out(a.output);
    std::string text;
    Progress progress("generate", steps, a.quiet);
    for (std::uint64_t i = 0;; ++i) {
        if (Interruption_guard::interrupted()) return done;
        text.clear();
        append_frame<d>(text, format, i, motion.points());
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

int run(const Generate_call& a) {
    if (!(a.pace >= 0 && a.pace <= 1000)) throw Error(Error_code::usage, "--pace is not a number from 0 to 1000");
    const Format format = format_of_output(a);
    require_replaceable(a.output);
    std::error_code ignored;
    if (a.output != "-" && !a.force && std::filesystem::exists(std::filesystem::symlink_status(a.output, ignored)))
        throw Error(Error_code::usage, a.output + " already exists; --force replaces it");
    return a.dimension == 2 ? write_motion<2>(a, format) : write_motion<3>(a, format);
}

}  // namespace

Run add_generate_command(CLI::App& app, const Invocation&) {
    auto* sub = app.add_subcommand("generate", "Point sets and motions by name, for tests, benchmarks and sweeps");
    const auto a = std::make_shared<Generate_call>();
    std::vector<std::string> kinds = words_of(point_families);
    for (const std::string& motion : words_of(motion_families)) kinds.push_back(motion);
    sub->add_option("KIND", a->kind,
                    "Points of the unit square or cube: uniform, grid, jittered, cospherical, clusters, surface;\n"
                    "or a motion of such points: walk, shear, orbit")
        ->required()
        ->check(CLI::IsMember(kinds));
    sub->add_option("-n,--points", a->points, "How many points")
        ->required()
        ->type_name("N")
        ->check(whole_number(1, 100'000'000));
    sub->add_option("--dim", a->dimension, "Dimension")->check(whole_number(2, 3))->capture_default_str();
    std::vector<CLI::Option*> of_motions;
    of_motions.push_back(sub->add_option("--from", a->from, "The initial points of a motion")
                             ->check(CLI::IsMember(words_of(point_families)))
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
    return [a, of_motions] {
        for (const CLI::Option* option : of_motions)
            if (option->count() > 0 && !family_named(motion_families, a->kind))
                throw Error(Error_code::usage, option->get_name() + " is for motions: walk, shear, orbit");
        return run(*a);
    };
}

}  // namespace annulus::inline v1::cli
