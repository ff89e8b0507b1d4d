// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

// Sections 2.2, 2.3 and 3.2 of the paper: soundness of tolerances.
namespace annulus::inline v1 {

namespace {

double part_of(std::uint64_t part, std::uint64_t all) {
    return share(static_cast<double>(part), static_cast<double>(all));
}
double last_of(const Benchmark_record& r, double (*value)(const Degeneracy_count_record&)) {
    return r.degeneracies.empty() ? 0 : value(r.degeneracies.back());
}
double first_of(const Benchmark_record& r, double (*value)(const Degeneracy_count_record&)) {
    return r.degeneracies.empty() ? 0 : value(r.degeneracies.front());
}
double unsound_share(const Degeneracy_count_record& g) { return part_of(g.paper_unsound, g.vertices); }
double above_share(const Degeneracy_count_record& g) { return part_of(g.paper_above, g.vertices); }
double non_convex_share(const Degeneracy_count_record& g) { return part_of(g.non_convex, g.bicells); }
/// Exact audits of runs with the paper's tolerances, and of certified ones.
struct Audits {
    std::uint64_t theirs = 0, theirs_failed = 0, ours = 0, ours_failed = 0;
};
Audits audits_of(const Reproduction& r) {
    Audits a;
    for (const auto& [name, benchmark] : r.benchmarks)
        for (const Contender_record& contender : benchmark.contenders) {
            const bool paper = contender.name.starts_with("paper");
            if (!paper && (contender.name.ends_with("floating") || contender.name.starts_with("re"))) continue;
            (paper ? a.theirs : a.ours) += contender.audits;
            (paper ? a.theirs_failed : a.ours_failed) += contender.audits_failed;
        }
    return a;
}

/// Over the bi-cells that were examined, of all runs.
struct Rounding {
    std::uint64_t bicells = 0, above = 0;
    double most = 0;
};
Rounding rounding_of(const Reproduction& r) {
    Rounding out;
    for (const auto& [name, benchmark] : r.benchmarks)
        for (const Stability_record& s : benchmark.stabilities) {
            out.bicells += s.bicells;
            out.above += s.above;
            out.most = std::max(out.most, most(s.most));
        }
    return out;
}

/// Tolerances that are wrong by rounding, and the runs with them.
void append_rounding(const Reproduction& r, const Audits& audits, std::vector<Claim>& out) {
    Claim c = claim("unsound", "Tolerances in plain double are wrong in special configurations only.", "seldom");
    if (const Rounding rounding = rounding_of(r); rounding.bicells > 0) {
        const double above = part_of(rounding.above, rounding.bicells);
        c.theirs = percent(above) + " of " + grouped(rounding.bicells) +
                   " half widths are above the exact ones by rounding alone, by " + readable(rounding.most) +
                   " of themselves at most";
        c.ours = "certified: none is above the exact one";
        c.verdict = within({above, above}, 0, 0.05);
        c.reason =
            "Seldom: 5 % at most. To be wrong by rounding is the rule; by how much is beside it, and by much was not "
            "met.";
    }
    out.push_back(c);

    c = claim("unsound", "Runs with such tolerances stay right.", "always");
    if (audits.theirs > 0) {
        c.theirs =
            grouped(audits.theirs_failed) + " of " + grouped(audits.theirs) + " exact audits along the runs failed";
        c.ours = grouped(audits.ours_failed) + " of " + grouped(audits.ours) + " audits failed";
        c.verdict = agree_if(audits.theirs_failed == 0);
        c.reason =
            "By the audits along these runs. That tolerances are unsound did not matter to them: these motions do not "
            "move five points against each other as an adversary does.";
    }
    out.push_back(c);
}

}  // namespace

void append_soundness_claims(const Reproduction& r, std::vector<Claim>& out) {
    const auto space = meshes(r), plane = lloyds(r);
    std::uint64_t attacked = 0, accepted = 0, audited = 0, refuted = 0;
    const Audits audits = audits_of(r);
    for (const Benchmark_record* benchmark : space)
        for (const Attack_record& a : benchmark->adversaries) {
            attacked += a.certificates;
            accepted += a.accepted;
            audited += a.audited;
            refuted += a.refuted;
        }
    Claim c{"unsound",
            "While vertices stay within their tolerances the triangulation stays Delaunay (Proposition 1, with "
            "standard delimiters), in space.",
            "always",
            "",
            "",
            Claim_verdict::open,
            ""};
    if (!space.empty()) {
        c.theirs = "an adversary made " + grouped(accepted) + " of " + grouped(attacked) +
                   " unsound certificates along these runs fail by moves that all stay within the paper's tolerances; "
                   "an exact audit of " +
                   grouped(audited) + " of the triangulations after such moves refuted " + grouped(refuted);
        c.ours = "proved; " + grouped(audits.ours_failed) + " of " + grouped(audits.ours) +
                 " audits of certified runs failed";
        c.verdict = accepted > 0 ? Claim_verdict::wrong : attacked > 0 ? Claim_verdict::agrees : Claim_verdict::open;
        c.reason =
            "Where the segment between the opposite vertices misses the facet, another partition of the five points "
            "has the thinner annulus.";
    }
    out.push_back(c);

    c = {"unsound", "The same in the plane.", "always", "", "", Claim_verdict::open, ""};
    if (!plane.empty()) {
        std::uint64_t unsound = 0;
        for (const Benchmark_record* benchmark : plane)
            for (const auto& g : benchmark->degeneracies) unsound += g.paper_unsound;
        c.theirs = grouped(unsound) + " vertices with too large a tolerance in " + grouped(plane.size()) +
                   (plane.size() == 1 ? " run" : " runs");
        c.ours = "proved";
        c.verdict = agree_if(unsound == 0);
    }
    out.push_back(c);

    c = {"unsound", "The standard annulus is usually the thinnest; otherwise the case is pathological.",
         "usually", "",
         "",        Claim_verdict::open,
         ""};
    if (!space.empty()) {
        c.theirs = "the segment misses the facet in " +
                   range(of_each(space, [](const auto& x) { return first_of(x, non_convex_share); }), percent) +
                   " of the bi-cells at the start, " +
                   range(of_each(space, [](const auto& x) { return last_of(x, non_convex_share); }), percent) +
                   " at the end; the tolerance is too large at " +
                   range(of_each(space, [](const auto& x) { return first_of(x, above_share); }), percent) +
                   " of the vertices, later " +
                   range(of_each(space, [](const auto& x) { return last_of(x, above_share); }), percent);
        c.ours = "all four annuli and the cells are looked at";
        auto shares = of_each(space, [](const auto& x) { return first_of(x, above_share); });
        for (const Benchmark_record* benchmark : space) shares.push_back(last_of(*benchmark, above_share));
        c.verdict = within(measured(shares), 0, 0.05);
        c.reason = "Usually: too large at 5 % of the vertices at most. Ordinary meshes are full of such bi-cells. At " +
                   range(of_each(space, [](const auto& x) { return last_of(x, unsound_share); }), percent) +
                   " of the vertices at the end all points of a certificate have too large a tolerance, so that it can "
                   "be made to fail.";
    }
    out.push_back(c);

    append_rounding(r, audits, out);
}

}  // namespace annulus::inline v1
