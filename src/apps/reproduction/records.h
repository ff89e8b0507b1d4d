// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Measurements of the reproduction as values: stored as the parts of an unfinished reproduction, and the only input of
// its pages. Lengths are in mean spacings, seconds are processor time of one thread.
namespace annulus::inline v1 {

/// One strategy along a benchmark. The vectors have an entry for each step that was followed.
struct Contender_record {
    std::string name;
    double first_seconds = 0;         ///< construction in total
    double precompute_seconds = 0;    ///< of these, the tolerances (measured separately)
    std::vector<std::uint64_t> step;  ///< from 1
    std::vector<double> seconds;
    std::vector<std::uint64_t> asked;
    std::vector<std::uint64_t> failed;     ///< moves that did not pass the step test
    std::vector<std::uint64_t> requeued;   ///< other vertices that entered the paper's queue
    std::vector<std::uint64_t> changed;    ///< moves that changed the triangulation: flips, reinsertions, rebuilds
    std::vector<std::uint64_t> evaluated;  ///< certificates
    std::uint64_t audits = 0, audits_failed = 0;
    std::string first_fault;
    std::uint64_t switched_at = 0;  ///< hybrids: the first step that was not rebuilt; 0: none
    double sampling_seconds = 0;    ///< hybrids: of these seconds, sampling
    /// Vertices that failed at the last step and at the streak_lengths[k] - 1 before it. Only for the paper's filtering
    /// algorithm (3.2), in any variant; else empty.
    std::vector<std::uint64_t> streaks;
};
inline constexpr std::uint64_t streak_lengths[] = {1, 2, 5, 10, 25, 50, 100};

/// The paper's tolerances and ours before a step, and the displacement of the step.
struct Certificate_survey_record {
    std::uint64_t step = 0;
    double displacement = 0;                              ///< mean
    double width = 0, width_deviation = 0;                ///< of standard annuli: mean, standard deviation
    double paper_tolerance = 0, certified_tolerance = 0;  ///< means of the finite ones
    double bicells_a_vertex = 0;                          ///< including those with infinite cells
    double paper_inside = 0, certified_inside = 0;        ///< share of vertices within their tolerance after the step
};

/// The distribution of the widths of standard annuli before a step.
struct Width_record {
    std::uint64_t step = 0;
    std::vector<double> edges;
    std::vector<std::uint64_t> counts;
    std::uint64_t total = 0;
};

/// Degeneracy of the triangulation before a step; counts are exact.
struct Degeneracy_count_record {
    std::uint64_t step = 0;
    std::uint64_t vertices = 0, bicells = 0, certificates = 0;
    std::uint64_t non_convex = 0;      ///< bi-cells
    std::vector<std::uint64_t> below;  ///< bi-cells, by threshold
    std::vector<double> thresholds;    ///< in mean spacings of the hull
    std::uint64_t paper_above = 0, paper_unsound = 0, unsound_certificates = 0;
    double theta_hundredth = 0, theta_median = 0;  ///< quantiles, radians
};

/// Results of the attacks before a step: see certificate_attack.h.
struct Attack_record {
    std::uint64_t step = 0;
    std::uint64_t certificates = 0;          ///< attacked: those below the paper's tolerance of all their points
    std::uint64_t broken = 0;                ///< of these, made false by moves below the paper's tolerances
    std::uint64_t accepted = 0;              ///< of these, accepted by the paper's algorithm
    std::uint64_t audited = 0, refuted = 0;  ///< of these, audited exactly; found not to be Delaunay
    std::string example;                     ///< the audit's message of the first
};

/// Errors of the half widths of standard annuli in plain double before a step, by theta.
struct Stability_record {
    std::uint64_t step = 0;
    std::uint64_t bicells = 0, above = 0;  ///< finite ones; those whose half width is above the exact one, by rounding
    std::vector<double> edges;             ///< of theta, radians
    std::vector<std::uint64_t> counts;
    std::vector<double> median, most;  ///< relative errors; 0 where there is no bi-cell
};

/// The time of CGAL for one vertex before a step, in seconds.
struct Operation_record {
    std::uint64_t step = 0;
    std::uint64_t vertices = 0;  ///< a tenth of them, removed one after another and inserted again
    double removal = 0, insertion = 0;
};

struct Quality_record {
    std::uint64_t step = 0;  ///< after this many steps
    std::uint64_t vertices = 0, locked = 0, cells = 0, slivers = 0;
    double dihedral_min = 0, dihedral_max = 0;
    std::vector<std::uint64_t> dihedral;  ///< bins of 5 degrees
};

struct Picture_record {
    std::uint64_t step = 0;
    std::string caption, svg;
    std::vector<double> x, y;  ///< of the points, in 2D
};

/// One motion with all its contenders: a part of the reproduction.
struct Benchmark_record {
    std::string name, title;
    int dimension = 2;
    std::uint64_t vertices = 0, steps = 0;
    double spacing = 0;                ///< in the unit of the points
    double seconds = 0;                ///< wall-clock time of everything
    double motion_seconds = 0;         ///< processor time of all threads for the motion alone
    double load = 0;                   ///< load average of the last minute, at the end
    std::vector<double> displacement;  ///< mean, by step
    std::vector<Contender_record> contenders;
    std::vector<Certificate_survey_record> surveys;
    std::vector<Width_record> widths;
    std::vector<Degeneracy_count_record> degeneracies;
    std::vector<Attack_record> adversaries;
    std::vector<Stability_record> stabilities;
    std::vector<Operation_record> operations;
    std::vector<Quality_record> qualities;
    std::vector<Picture_record> pictures;
    std::vector<std::string> notes;
};

/// As text that `parse_benchmark` reads back exactly, bit for bit.
[[nodiscard]] std::string benchmark_text(const Benchmark_record& benchmark);
/// Throws Error(bad_input) for anything else.
[[nodiscard]] Benchmark_record parse_benchmark(const std::string& text);

}  // namespace annulus::inline v1
