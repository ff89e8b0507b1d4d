// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Seconds of a run: of the processor with one thread, else of the wall clock, which `total` always is.
/// `triangulation` is the sum over its steps of the time spent on updating the
/// triangulation and its tolerances, and nothing else: the first triangulation and its tolerances belong to no step,
/// but to `construction`.
struct Seconds_record {
    double triangulation = 0;
    double motion = 0;
    double total = 0;
    double construction = 0;
};

/// How the requested moves were made.
struct Moves_record {
    std::uint64_t asked = 0;
    std::uint64_t within_tolerance = 0;
    std::uint64_t kept_in_place = 0;
    std::uint64_t flipped = 0;
    std::uint64_t reinserted = 0;
    std::uint64_t rebuilt = 0;

    friend bool operator==(const Moves_record&, const Moves_record&) = default;
};

/// How often the triangulation was audited, and how often an audit failed.
struct Audit_record {
    std::uint64_t checked = 0;
    std::uint64_t failed = 0;
};

/// The mesh after one step of an optimisation in 3D: cells of the domain, and how many of their vertices moved.
struct Mesh_step {
    std::uint64_t vertices = 0;  ///< of cells of the domain
    std::uint64_t boundary = 0;  ///< of these, on its surface
    std::uint64_t locked = 0;    ///< of these, at rest in this step because their cells were good
    std::uint64_t kept = 0;      ///< of these, at rest in this step because their target was refused
    std::uint64_t cells = 0;
    std::uint64_t slivers = 0;
    double dihedral_min = 0;  ///< degrees
    double dihedral_max = 0;
    std::vector<std::uint64_t> dihedral;  ///< counts of angles, 5 degrees a bin from 0 to 180
};

/// A 2D triangulation and its Voronoi cells after a step.
struct Plane_step {
    std::uint64_t inner = 0;                    ///< vertices with cells that are not at the border: see plane_view.h
    std::array<std::uint64_t, 5> neighbours{};  ///< how many of these have up to 4, 5, 6, 7, from 8 on; see shades.h
    double angle_min = 0, angle_mean = 0;       ///< of the least angles of triangles (plane_view.h), degrees
    /// The integral over the domain of the density times the square of the distance to the nearest vertex.
    std::optional<double> energy{};
};

/// One of the worst cells of an optimised mesh.
struct Worst_cell {
    std::uint64_t cell = 0;                                 ///< its number among the tetrahedra of the domain, from 0
    double dihedral_min = 0, radius_ratio = 0, aspect = 0;  ///< see cell_quality.h
    Coordinates<3> at{};                                    ///< the mean of its corners
};

/// One step. Lengths are in mean spacings; an absent value was not measured in this step.
struct Iteration_record {
    std::uint64_t iteration = 0;  ///< from 1
    double seconds_triangulation = 0;
    double seconds_motion = 0;
    double seconds_cumulative = 0;  ///< seconds_triangulation of this step and all before it, without construction
    double displacement_mean = 0;
    double displacement_max = 0;
    std::optional<double> tolerance_mean;
    std::optional<double> annulus_width_mean;
    std::optional<double> theta_min;
    Moves_record moves;
    /// Whether vertices were tested against their tolerances. Where all signs were evaluated, or all was rebuilt,
    /// `moves.within_tolerance` counts vertices at rest alone, and the share within tolerance is unknown.
    bool tested_tolerances = false;
    Stage_counts arithmetic;
    std::uint64_t certificates_evaluated = 0;
    std::uint64_t flips = 0;
    std::optional<Mesh_step> mesh;
    std::optional<Plane_step> plane;
    /// The standard deviation of the volumes of the Voronoi cells over their mean, after the step.
    std::optional<double> volume_scatter{};
};

/// How an input file, if any, was read.
struct Input_record {
    std::vector<std::pair<std::string, std::string>> columns;  ///< "x" is "column 2 (xs)"
    std::string dimension;                   ///< why it is 2 where points have a z: "z is 0.5 everywhere"
    std::vector<std::string> ignored;        ///< content of the file that is ignored: "box"
    std::vector<std::string> warnings;       ///< the same as lines, and what may have another meaning
    std::string box_from{};                  ///< what gives the periodic box: "Lattice", "--box"; empty without one
    std::vector<std::vector<double>> box{};  ///< the vectors of that of the last frame
    std::vector<std::vector<double>> box_before{};  ///< those of the first, if the box is not the same in all frames
};

/// The region to which Voronoi cells are clipped: --clip.
struct Clip_record {
    std::string kind;                       ///< "box", "polygon" or "half-spaces"
    std::vector<std::vector<double>> rows;  ///< lower and upper corner; corners; a, b [, c], e of each half-space
};

/// One run of one strategy, as in the files that it writes.
struct Run_record {
    std::string command;
    Input_record input;
    std::optional<Clip_record> clip{};
    int dimension = 2;
    std::uint64_t vertices = 0;
    std::uint64_t iterations = 0;
    bool interrupted = false;  ///< before the last requested step
    bool finished = false;     ///< the last step is no iteration: nodt --finish
    bool replayed = false;     ///< the steps are from frame to frame of a file, and pages call them frames
    std::string strategy;
    std::string tolerance;  ///< kind of tolerance
    unsigned threads = 1;
    std::uint64_t seed = 0;
    Seconds_record seconds;
    Moves_record moves;
    Stage_counts arithmetic;
    Audit_record audit;
    std::uint64_t memory_peak_bytes = 0;  ///< 0 when unknown
    double mean_spacing = 0;              ///< the unit of length, in the caller's unit
    std::vector<Iteration_record> steps;
    std::optional<Mesh_step> mesh_before;    ///< before the first step
    std::optional<Plane_step> plane_before;  ///< before the first step
    std::optional<double> volume_scatter_before{};
    std::vector<Worst_cell> worst;  ///< the cells with the least dihedral angles at the end
};

/// What pages call a step of the run: "iteration", or of a replayed motion "frame", to which it leads.
[[nodiscard]] inline const char* step_word(const Run_record& run) { return run.replayed ? "frame" : "iteration"; }

/// Whether the seconds of a run, but the total, are those of the processor: with one thread, see stopwatch.h.
[[nodiscard]] inline bool times_processor(const Run_record& run) { return run.threads == 1; }

/// What pages write at an axis of steps: frames of a file have numbers of their own.
[[nodiscard]] inline const char* step_axis_label(const Run_record& run) {
    return run.replayed          ? "frames after the first"
           : !run.finished       ? "iteration"
           : run.iterations == 1 ? "finish"
                                 : "iteration, the last: the finish";
}

/// Whether the strategy of a run tests tolerances: not where it rebuilds, relocates or evaluates all signs.
/// "paper:floating" is `paper` with another kind of tolerance.
[[nodiscard]] inline bool has_tolerances(const Run_record& run) {
    const std::string_view name = std::string_view(run.strategy).substr(0, run.strategy.find(':'));
    return name == "auto" || name.starts_with("tolerances") || name.starts_with("paper");
}

/// Whether a run counts the certificates that it decides: in a periodic box those for tolerances alone.
[[nodiscard]] inline bool counts_certificates(const Run_record& run) {
    return run.input.box.empty() || has_tolerances(run);
}
/// What pages and the terminal call them.
[[nodiscard]] inline const char* decided_word(const Run_record& run) {
    return run.input.box.empty() ? "decided" : "decided for tolerances";
}

/// Whether flips of a run are counted: not those of the paper's algorithm, which it makes in 2D.
[[nodiscard]] inline bool counts_flips(const Run_record& run) {
    return run.dimension != 2 || !run.strategy.starts_with("paper");
}

/// The moves of those steps of a run that tested tolerances.
struct Tested_moves {
    std::uint64_t steps = 0, asked = 0, within_tolerance = 0;
};

[[nodiscard]] inline Tested_moves tested_moves(const Run_record& run) {
    Tested_moves sum;
    for (const Iteration_record& step : run.steps) {
        if (!step.tested_tolerances) continue;
        ++sum.steps;
        sum.asked += step.moves.asked;
        sum.within_tolerance += step.moves.within_tolerance;
    }
    return sum;
}

/// The same motion under several strategies, all treated alike.
struct Comparison_record {
    std::vector<Run_record> runs;
    bool agree = true;
    std::vector<std::string> disagreements;  ///< a line for each
    bool interrupted = false;                ///< then the runs have different numbers of steps, and there is no verdict
};

}  // namespace annulus::inline v1
