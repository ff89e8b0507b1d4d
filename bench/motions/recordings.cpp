// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies and CGAL's rebuild on recorded motions, timed step by step in turn.
#include "comparison.h"
#include "recording.h"

#include <apps/formats/read_motion.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

/// 3 if there is a z that is not the same everywhere.
int dimension_of(const annulus::Recorded_motion& motion) {
    const double* z = nullptr;
    for (const annulus::Frame& frame : motion.frames)
        for (const auto& p : frame.position) {
            if (motion.has_z && z && *z != p[2]) return 3;
            z = &p[2];
        }
    return 2;
}

template <int d>
int run(const annulus::Recorded_motion& recorded, const bench::Comparison& comparison, const std::string& name,
        const std::string& json) {
    // If there are more frames than requested, those around the fullest one: persons enter the picture one by one.
    const std::size_t all = recorded.frames.size();
    const auto wanted = std::min(all, static_cast<std::size_t>(comparison.warm + comparison.steps) + 1);
    const std::size_t peak = bench::fullest(recorded);
    bench::Recording<d> motion(recorded, std::min(peak - std::min(peak, wanted / 2), all - wanted));
    nlohmann::ordered_json out{{"file", name}, {"dimension", d}, {"frames", recorded.frames.size()}};
    const int failed = bench::compare<d>(motion, comparison, name, out);
    bench::append(json, out);
    return failed;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> files;
    std::string json;
    bench::Comparison comparison;
    comparison.steps = 200;
    CLI::App app{"Strategies and CGAL's rebuild on recorded motions, step by step in turn."};
    app.add_option("FILES", files, "what `annulus replay` reads")->required()->check(CLI::ExistingFile);
    app.add_option("-k,--steps", comparison.steps,
                   "that count, around the fullest frame; a file that has fewer is followed from its begin to its end")
        ->check(CLI::Range(1, 1000000));
    app.add_option("-w,--warm", comparison.warm, "steps before those that count")->check(CLI::Range(0, 1000000));
    app.add_option("--strategies", comparison.strategies)->delimiter(',');
    app.add_flag("--audit-all", comparison.audit_all, "after every step, not only the last");
    app.add_option("--json", json, "file that a line is appended to for each");
    CLI11_PARSE(app, argc, argv);
    int failed = 0;
    for (const std::string& file : files) {
        try {
            const annulus::Recorded_motion recorded =
                annulus::read_motion(file, {.absent = annulus::Absent_frames::skip, .box = {.ignored = true}});
            const std::string name = std::filesystem::path(file).filename().string();
            failed += dimension_of(recorded) == 2 ? run<2>(recorded, comparison, name, json)
                                                  : run<3>(recorded, comparison, name, json);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "annulus-recordings: %s\n", e.what());
            return 3;
        }
    }
    return failed == 0 ? 0 : 1;
}
