// SPDX-License-Identifier: GPL-3.0-or-later
// The figures and claims of the paper, reproduced by runs on this machine.
#include <annulus/error.h>
#include <annulus/version.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/companion.h>
#include <apps/cli/interruption.h>
#include <apps/cli/progress.h>
#include <apps/cli/reproduction_scenes.h>
#include <apps/cli/result_files.h>
#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>
#include <apps/report/processor.h>
#include <apps/reproduction/checkpoints.h>
#include <apps/reproduction/plan.h>
#include <apps/reproduction/reproduction.h>

#include <zlib.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

struct Reproduce_call {
    Common_arguments common;
    Reproduction_size size;
    std::string surfaces;
};

/// The files with the bodies of the paper, in a directory that tools/meshes fills.
constexpr const char* surface_files[] = {"man.off", "bunny00.off", "liver.inr.gz"};

std::string machine() {
#if defined(__clang__)
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    return processor_name() + ", " + counted(std::thread::hardware_concurrency(), "processor") + ", " + compiler;
}

/// Today's, in UTC: "29 November 2026".
std::string date() {
    static constexpr std::array<const char*, 12> months{"January",   "February", "March",    "April",
                                                        "May",       "June",     "July",     "August",
                                                        "September", "October",  "November", "December"};
    const auto now = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
    const std::chrono::year_month_day day(now);
    return std::to_string(static_cast<unsigned>(day.day())) + " " + months.at(static_cast<unsigned>(day.month()) - 1) +
           " " + std::to_string(static_cast<int>(day.year()));
}

/// The CRC-32 of all surface files.
std::string fingerprint(const std::string& surfaces) {
    uLong sum = ::crc32_z(0, nullptr, 0);
    for (const char* file : surface_files) {
        std::ifstream in(std::filesystem::path(surfaces) / file, std::ios::binary);
        std::array<char, 1 << 16> block{};
        while (in.read(block.data(), block.size()) || in.gcount() > 0)
            sum = ::crc32_z(sum, reinterpret_cast<const unsigned char*>(block.data()),
                            static_cast<std::size_t>(in.gcount()));
    }
    return formatted("%08lx", sum);
}

/// Everything that the results depend on, except the machine.
std::string description(const Reproduce_call& a) {
    std::string only;
    for (const std::string& topic : a.size.only) only += (only.empty() ? "" : ",") + topic;
    return std::string("annulus " ANNULUS_VERSION_STRING) + (a.size.quick ? " quick" : " whole") +
           " iterations=" + std::to_string(a.size.iterations) + " seed=" + std::to_string(a.size.seed) +
           " only=" + only + " surfaces=" + (a.surfaces.empty() ? "no" : fingerprint(a.surfaces));
}

Benchmark_record run_part(const Part_plan& part, const Reproduce_call& a, Progress& progress, std::uint64_t before) {
    const Benchmark_listener listener = [&](std::uint64_t step, const std::string& news) {
        progress.show(before + step, part.benchmark.name + ": " + news);
        return !Interruption_guard::interrupted();
    };
    Common_arguments common = a.common;
    common.quiet = true;  // the pages have the notes
    common.seed += part.motion.draw;
    if (part.motion.dimension == 2) return benchmark<2>(*plane_scene(part.motion, common), part.benchmark, listener);
    return benchmark<3>(*space_scene(part.motion, a.surfaces, common), part.benchmark, listener);
}

int run(Reproduce_call a, const std::string& command) {
    if (a.common.output.empty()) throw Error(Error_code::usage, "reproduce writes pages: say where with --output DIR");
    a.size.seed = a.common.seed;
    a.size.surfaces = !a.surfaces.empty();
    for (const char* file : surface_files) {
        std::error_code ignored;
        if (a.size.surfaces && !std::filesystem::is_regular_file(std::filesystem::path(a.surfaces) / file, ignored))
            throw Input_error(Error_code::bad_input, (std::filesystem::path(a.surfaces) / file).string(), 0,
                              "cannot be read", "man.off, bunny00.off and liver.inr.gz, which tools/meshes unpacks");
    }
    require_writable(a.common);
    const std::vector<Part_plan> plans = reproduction_parts(a.size);
    const Checkpoints parts(partial(a.common.output), description(a));
    Reproduction reproduction{command, machine(), a.size, {}, date()};
    const Interruption_guard guard;
    std::uint64_t steps = 0, before = 0;
    for (const Part_plan& p : plans) steps += p.benchmark.steps;
    std::optional<Progress> progress(std::in_place, "reproduce", steps, a.common.quiet);
    for (const Part_plan& plan : plans) {
        std::optional<Benchmark_record> record = parts.find(plan.benchmark.name);
        if (!record) {
            try {
                record = run_part(plan, a, *progress, before);
            } catch (const Benchmark_stopped&) {
                progress.reset();
                if (!a.common.quiet)
                    std::fprintf(
                        stderr, "annulus: interrupted; %zu of %s in %s: start again with the same arguments to go on\n",
                        reproduction.benchmarks.size(),
                        plans.size() == 1 ? "1 part is" : (std::to_string(plans.size()) + " parts are").c_str(),
                        partial(a.common.output).c_str());
                return done;
            }
            parts.keep(*record);
        }
        before += plan.benchmark.steps;
        reproduction.benchmarks.emplace(plan.benchmark.name, std::move(*record));
    }
    progress.reset();
    Result_files out(a.common);
    for (const Result_file& file : reproduction_files(reproduction)) out.write(file.name, file.content);
    out.commit();
    parts.remove();
    if (!a.common.quiet) std::printf("written to     %s/index.html\n", a.common.output.c_str());
    return done;
}

}  // namespace

Run add_reproduce_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand("reproduce", reproduce_summary);
    const auto a = std::make_shared<Reproduce_call>();
    sub->add_flag("--quick", a->size.quick, "Fewer points and iterations: two minutes, and no figures to quote");
    sub->add_option("--only", a->size.only,
                    "What to make, separated by commas: fig5 to fig12, slivers, locked, movers (all)")
        ->delimiter(',')
        ->type_name("LIST")
        ->check(CLI::IsMember(reproduction_topics()));
    sub->add_option("--surfaces", a->surfaces,
                    "Directory with man.off, bunny00.off and liver.inr.gz of CGAL's data; without it\n"
                    "the sphere is the only body")
        ->type_name("DIR");
    sub->add_option("-i,--iterations", a->size.iterations,
                    "Iterations of every motion (1000; with --quick 100 in 2D, 60 in 3D)")
        ->type_name("N")
        ->check(whole_number(1, 100'000));
    add_common(*sub, a->common, "index.html, a page for each figure, tables and reproduction.json",
               {.threads = "Threads for the motion, not for what is timed; results do not depend on them"});
    return [a, command = command_line(invocation.words)] { return run(*a, command); };
}

}  // namespace annulus::inline v1::cli
