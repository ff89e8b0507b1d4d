// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_arguments.h>

#include <annulus/error.h>
#include <apps/cli/frame_clip.h>

#include <limits>

namespace annulus::inline v1::cli {

void add_frames(CLI::App& app, Frame_arguments& a) {
    app.add_option("--every", a.every,
                   "Write every N-th frame for ParaView, from the first: frames.pvd and frame-*.vtu")
        ->type_name("N")
        ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()));
    app.add_flag("--voronoi", a.voronoi,
                 "Write voronoi.csv: area or volume and neighbours of every Voronoi cell in every frame");
    app.add_flag("--neighbors", a.neighbors,
                 "Write pairs.csv: the pairs of neighbours of every frame, with the length or area of their facet");
    app.add_flag("--changes", a.changes,
                 "Write changes.csv: which points became neighbours, or no longer are, and when");
}

void add_clip(CLI::App& app, Frame_arguments& a) {
    app.add_option("--clip", a.clip,
                   "With --voronoi and --neighbors: clip Voronoi cells, so that all are bounded, to a box, its lower\n"
                   "and its upper corner, x,y,X,Y or x,y,z,X,Y,Z; to polygon:x,y,x,y,.., convex; or to\n"
                   "half-spaces:a,b,e,.., a x + b y + e <= 0 (a,b,c,e,.. in 3D)")
        ->type_name("CLIP");
}

void prepare(const Frame_arguments& frames, const Common_arguments& common, Options& options) {
    if (!frames.clip.empty()) {
        check_clip(frames.clip);
        if (!frames.voronoi && !frames.neighbors)
            throw Error(Error_code::usage,
                        "--clip is about the files of --voronoi and --neighbors: ask for one of them");
    }
    if (!frames.any()) return;
    if (common.output.empty())
        throw Error(Error_code::usage,
                    "--every, --voronoi, --neighbors and --changes write files: say where with --output DIR");
    if (frames.voronoi && options.tolerance != Tolerance_kind::certified)
        throw Error(Error_code::usage, "--voronoi needs Delaunay triangulations, that is, --tolerance certified");
    if (frames.neighbors && options.tolerance != Tolerance_kind::certified)
        throw Error(Error_code::usage, "--neighbors needs Delaunay triangulations, that is, --tolerance certified");
    options.report_changes = frames.changes;
}

}  // namespace annulus::inline v1::cli
