// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/commands.h>
#include <apps/cli/files.h>
#include <apps/cli/mesh_3.h>
#include <apps/report/axis_ticks.h>

#include <cstdio>
#include <string>
#include <utility>

// How runs end that have iterations: their files, the line about an interruption or the summary, the exit code.
namespace annulus::inline v1::cli {

/// After the files: prints that the run was interrupted, or its summary, then what `more` prints, and where the files
/// are. Returns the exit code. `iterations` were requested.
template <class Moving, class More>
int end_run(const Common_arguments& common, const Run_tracker<Moving>& tracker, std::uint64_t iterations, More more) {
    const Run_record& record = tracker.record();
    if (record.interrupted) {
        say_interrupted(common, record.iterations, iterations);
        return done;
    }
    if (!common.quiet) {
        print_summary(tracker);
        more();
        if (!common.output.empty()) std::printf("written to     %s\n", common.output.c_str());
    }
    return record.audit.failed == 0 ? done : audit_failed;
}

/// The picture of the triangulation at the end, where there was an iteration, with the outline of the first one.
template <class Moving>
void picture_end(const Run_tracker<Moving>& tracker, Run_page<Moving>& page) {
    const std::uint64_t n = tracker.record().iterations;
    if (n == 0) return;
    page.after = picture_of(tracker.triangulation(), "After " + grouped(n, "iteration"), page.cut);
    if (page.before) page.after->outline = page.before->outline;
}

/// Lloyd's iterations in any domain: writes the files, if there is --output, and ends the run. `merged` points of the
/// input were duplicates; `cells_note` is below the curves of Voronoi cells.
template <class Moving>
int end_lloyd(const Common_arguments& common, const Run_tracker<Moving>& tracker, std::uint64_t iterations,
              std::uint64_t merged, Frame_files<Moving>& frames, const std::string& cells_note, Run_page<Moving> page) {
    if (!common.output.empty()) {
        picture_end(tracker, page);
        if (merged > 0) page.notes.push_back(grouped(merged, "duplicate point") + " of the input merged.");
        page.figures = frame_figures(frames.records(), tracker.record(), false, cells_note);
        page.frames = &frames;
        write_run(common, tracker, std::move(page));
    }
    return end_run(common, tracker, iterations, [] {});
}

}  // namespace annulus::inline v1::cli
