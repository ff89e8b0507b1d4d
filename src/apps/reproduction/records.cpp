// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/records.h>

#include <annulus/error.h>

#include <nlohmann/json.hpp>

#include <iterator>

namespace annulus::inline v1 {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Contender_record, name, first_seconds, precompute_seconds, step, seconds, asked,
                                   failed, requeued, changed, evaluated, audits, audits_failed, first_fault,
                                   switched_at, sampling_seconds, streaks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Certificate_survey_record, step, displacement, width, width_deviation,
                                   paper_tolerance, certified_tolerance, bicells_a_vertex, paper_inside,
                                   certified_inside)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Width_record, step, edges, counts, total)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Degeneracy_count_record, step, vertices, bicells, certificates, non_convex, below,
                                   thresholds, paper_above, paper_unsound, unsound_certificates, theta_hundredth,
                                   theta_median)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Attack_record, step, certificates, broken, accepted, audited, refuted, example)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Stability_record, step, bicells, above, edges, counts, median, most)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Operation_record, step, vertices, removal, insertion)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Quality_record, step, vertices, locked, cells, slivers, dihedral_min, dihedral_max,
                                   dihedral)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Picture_record, step, caption, svg, x, y)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Benchmark_record, name, title, dimension, vertices, steps, spacing, seconds,
                                   motion_seconds, load, displacement, contenders, surveys, widths, degeneracies,
                                   adversaries, stabilities, operations, qualities, pictures, notes)

namespace {

/// Readers of a record rely on lists of equal length.
bool is_sound(const Benchmark_record& benchmark) {
    for (const Contender_record& r : benchmark.contenders)
        for (const std::size_t n : {r.seconds.size(), r.asked.size(), r.failed.size(), r.requeued.size(),
                                    r.changed.size(), r.evaluated.size()})
            if (n != r.step.size()) return false;
    for (const Contender_record& r : benchmark.contenders)
        if (!r.streaks.empty() && r.streaks.size() != std::size(streak_lengths)) return false;
    for (const Stability_record& s : benchmark.stabilities)
        for (const std::size_t n : {s.edges.size() - 1, s.median.size(), s.most.size()})
            if (n != s.counts.size()) return false;
    for (const Width_record& w : benchmark.widths)
        if (w.edges.size() != w.counts.size() + 1) return false;
    for (const Degeneracy_count_record& g : benchmark.degeneracies)
        if (g.below.size() != g.thresholds.size()) return false;
    for (const Picture_record& p : benchmark.pictures)
        if (p.x.size() != p.y.size()) return false;
    return true;
}

}  // namespace

std::string benchmark_text(const Benchmark_record& benchmark) { return nlohmann::json(benchmark).dump() + "\n"; }

Benchmark_record parse_benchmark(const std::string& text) {
    try {
        Benchmark_record benchmark = nlohmann::json::parse(text).get<Benchmark_record>();
        if (!is_sound(benchmark))
            throw Error(Error_code::bad_input, "no part of a reproduction: lists of unequal length");
        return benchmark;
    } catch (const nlohmann::json::exception& e) {
        throw Error(Error_code::bad_input, std::string("no part of a reproduction: ") + e.what());
    }
}

}  // namespace annulus::inline v1
