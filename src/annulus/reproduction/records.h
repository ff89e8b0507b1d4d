// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

// What runs of the reproduction measured, as values: stored as the parts of an unfinished reproduction, and all that
// its pages are made from. Lengths are in mean spacings, seconds those of one thread's processor.
namespace annulus {

/// One strategy along a race. The vectors have an entry for each step that was followed.
struct Contender_record {
    std::string name;
    double first_seconds = 0;         ///< construction with everything in it
    double precompute_seconds = 0;    ///< of these, the tolerances (measured once more by themselves)
    std::vector<std::uint64_t> step;  ///< from 1
    std::vector<double> seconds;
    std::vector<std::uint64_t> asked;
    std::vector<std::uint64_t> failed;     ///< moves that their tolerance did not let pass
    std::vector<std::uint64_t> requeued;   ///< other vertices that the paper's queue took up
    std::vector<std::uint64_t> changed;    ///< moves that changed the triangulation: flips, reinsertions, rebuilds
    std::vector<std::uint64_t> evaluated;  ///< certificates
    std::uint64_t audits = 0, audits_failed = 0;
    std::string first_fault;
    std::uint64_t switched_at = 0;  ///< hybrids: the first step that was not rebuilt; 0: none
    double sampling_seconds = 0;    ///< hybrids: of these seconds, looking at samples
    /// Vertices that failed at the last step and at the streak_lengths[k] - 1 before it. Of the paper's printed
    /// algorithm; else empty.
    std::vector<std::uint64_t> streaks;
};
inline constexpr std::uint64_t streak_lengths[] = {1, 2, 5, 10, 25, 50, 100};

/// What the paper's tolerances and ours were before a step, and how far it went.
struct Certificate_survey_record {
    std::uint64_t step = 0;
    double displacement = 0;                              ///< mean
    double width = 0, width_deviation = 0;                ///< of standard annuli: mean, standard deviation
    double paper_tolerance = 0, certified_tolerance = 0;  ///< means of those that are finite
    double bicells_a_vertex = 0;                          ///< those with infinite cells included
    double paper_inside = 0, certified_inside = 0;  ///< share of vertices that the step leaves within their tolerance
};

/// The distribution of the widths of standard annuli before a step.
struct Width_record {
    std::uint64_t step = 0;
    std::vector<double> edges;
    std::vector<std::uint64_t> counts;
    std::uint64_t total = 0;
};

/// How degenerate the triangulation was before a step; counts are exact.
struct Degeneracy_count_record {
    std::uint64_t step = 0;
    std::uint64_t vertices = 0, bicells = 0, certificates = 0;
    std::uint64_t non_convex = 0;      ///< bi-cells
    std::vector<std::uint64_t> below;  ///< bi-cells, by threshold
    std::vector<double> thresholds;    ///< in mean spacings of the hull
    std::uint64_t paper_above = 0, paper_unsound = 0, unsound_certificates = 0;
    double theta_hundredth = 0, theta_median = 0;  ///< quantiles, radians
};

/// What the adversary did before a step: see certificate_attack.h.
struct Attack_record {
    std::uint64_t step = 0;
    std::uint64_t certificates = 0;          ///< attacked: those below the paper's tolerance of all their points
    std::uint64_t broken = 0;                ///< of these, made false by moves below the paper's tolerances
    std::uint64_t accepted = 0;              ///< of these, let pass by the paper's algorithm
    std::uint64_t audited = 0, refuted = 0;  ///< of these, looked at by the exact audit; found not to be Delaunay
    std::string example;                     ///< the audit's words of the first
};

/// How far plain double is from the exact half widths of standard annuli before a step, by theta.
struct Stability_record {
    std::uint64_t step = 0;
    std::uint64_t bicells = 0, above = 0;  ///< finite ones; those whose number is above the exact one, by rounding
    std::vector<double> edges;             ///< of theta, radians
    std::vector<std::uint64_t> counts;
    std::vector<double> median, most;  ///< relative errors; 0 where there is no bi-cell
};

/// What CGAL takes for one vertex before a step, in seconds.
struct Operation_record {
    std::uint64_t step = 0;
    std::uint64_t vertices = 0;  ///< a tenth of them, taken out one after another and put back
    double removal = 0, insertion = 0;
};

struct Quality_record {
    std::uint64_t step = 0;  ///< after so many
    std::uint64_t vertices = 0, locked = 0, cells = 0, slivers = 0;
    double dihedral_min = 0, dihedral_max = 0;
    std::vector<std::uint64_t> dihedral;  ///< bins of 5 degrees
};

struct Picture_record {
    std::uint64_t step = 0;
    std::string caption, svg;
    std::vector<double> x, y;  ///< of the points, in 2D
};

/// One motion with all that followed it: a part of the reproduction.
struct Benchmark_record {
    std::string name, title;
    int dimension = 2;
    std::uint64_t vertices = 0, steps = 0;
    double spacing = 0;                ///< in the unit of the points
    double seconds = 0;                ///< by the clock, everything included
    double motion_seconds = 0;         ///< of all processors, that the motion alone took
    double load = 0;                   ///< processes that wanted a processor, the mean of a minute at the end
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

/// As text that `parse_race` reads back bit for bit.
[[nodiscard]] std::string race_text(const Benchmark_record& benchmark);
/// Throws Error(bad_input) for anything else.
[[nodiscard]] Benchmark_record parse_race(const std::string& text);

}  // namespace annulus
