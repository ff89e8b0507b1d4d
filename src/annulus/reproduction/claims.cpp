// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/claim_words.h>

namespace annulus {

std::string name_of(Claim_verdict verdict) {
    switch (verdict) {
        case Claim_verdict::agrees: return "agrees";
        case Claim_verdict::further: return "goes further";
        case Claim_verdict::differs: return "differs";
        case Claim_verdict::wrong: return "is wrong";
        case Claim_verdict::open: return "open";
    }
    return "";
}

std::vector<Claim> claims_of(const Reproduction& reproduction) {
    std::vector<Claim> out;
    append_theory_claims(reproduction, out);
    append_lloyd_claims(reproduction, out);
    append_mesh_claims(reproduction, out);
    const bool brief = std::any_of(reproduction.races.begin(), reproduction.races.end(),
                                   [](const auto& entry) { return entry.second.steps < 1000; });
    for (Claim& c : out) {
        if (c.theirs.empty() && c.reason.empty()) c.reason = "Not run.";
        if (!brief || !c.of_long_runs || c.theirs.empty()) continue;
        c.verdict = Claim_verdict::open;
        c.reason = "The paper says it of 1,000 iterations.";
    }
    return out;
}

namespace {

using Degeneracies = std::vector<Degeneracy_count_record>;

double share(std::uint64_t part, std::uint64_t all) {
    return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0;
}
double last_of(const Race_record& r, double (*value)(const Degeneracy_count_record&)) {
    return r.degeneracies.empty() ? 0 : value(r.degeneracies.back());
}
double first_of(const Race_record& r, double (*value)(const Degeneracy_count_record&)) {
    return r.degeneracies.empty() ? 0 : value(r.degeneracies.front());
}
double unsound_share(const Degeneracy_count_record& g) { return share(g.paper_unsound, g.vertices); }
double above_share(const Degeneracy_count_record& g) { return share(g.paper_above, g.vertices); }
double non_convex_share(const Degeneracy_count_record& g) { return share(g.non_convex, g.bicells); }
double theta_hundredth(const Degeneracy_count_record& g) { return g.theta_hundredth; }

void append_soundness(const Reproduction& r, std::vector<Claim>& out) {
    const auto space = meshes(r), plane = lloyds(r);
    std::uint64_t attacked = 0, accepted = 0, audited = 0, refuted = 0, audits = 0, failed = 0, certified = 0,
                  certified_failed = 0;
    for (const auto& [name, race] : r.races)
        for (const Racer_record& racer : race.racers) {
            const bool theirs = racer.name == "paper" || racer.name == "paper-hybrid",
                       none = racer.name.ends_with("floating") || racer.name.starts_with("re");
            if (none) continue;
            (theirs ? audits : certified) += racer.audits;
            (theirs ? failed : certified_failed) += racer.audits_failed;
        }
    for (const Race_record* race : space)
        for (const Adversary_record& a : race->adversaries) {
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
                   "the exact audit refuted " +
                   grouped(refuted) + " of the " + grouped(audited) + " of them it was shown";
        c.ours =
            "proved; " + grouped(certified_failed) + " of " + grouped(certified) + " audits of certified runs failed";
        c.verdict = accepted > 0 ? Claim_verdict::wrong : Claim_verdict::agrees;
        c.reason =
            "Where the segment between the opposite vertices misses the facet, another partition of the five points "
            "has the thinner annulus.";
    }
    out.push_back(c);

    c = {"unsound", "The same in the plane.", "always", "", "", Claim_verdict::open, ""};
    if (!plane.empty()) {
        std::uint64_t unsound = 0;
        for (const Race_record* race : plane)
            for (const auto& g : race->degeneracies) unsound += g.paper_unsound;
        c.theirs = grouped(unsound) + " vertices with too large a tolerance in " + grouped(plane.size()) + " runs";
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
        c.verdict = agree_if(most(of_each(space, [](const auto& x) { return first_of(x, above_share); })) < 0.05);
        c.reason = "Ordinary meshes are full of such bi-cells. At " +
                   range(of_each(space, [](const auto& x) { return last_of(x, unsound_share); }), percent) +
                   " of the vertices at the end all points of a certificate have too large a tolerance, so that it can "
                   "be made to fail.";
    }
    out.push_back(c);

    c = {"unsound", "Tolerances in plain double are wrong in special configurations only, and such runs stay right.",
         "seldom",  "",
         "",        Claim_verdict::open,
         ""};
    if (audits > 0) {
        c.theirs = grouped(failed) + " of " + grouped(audits) + " exact audits along the runs failed";
        c.ours = grouped(certified_failed) + " of " + grouped(certified);
        c.verdict = agree_if(failed * 100 <= audits);
        if (failed == 0)
            c.reason =
                "Neither rounding nor unsound tolerances did harm: these motions do not move five points against each "
                "other as an adversary does.";
    }
    out.push_back(c);
}

}  // namespace

void append_theory_claims(const Reproduction& r, std::vector<Claim>& out) {
    append_soundness(r, out);
    const auto plane = lloyds(r), space = meshes(r);
    auto all = plane;
    all.insert(all.end(), space.begin(), space.end());

    Claim c{"figure-7", "Flips in place of removal make relocation twice as fast in the plane.",
            "2",        "",
            "",         Claim_verdict::open,
            ""};
    if (!plane.empty()) {
        const auto x = of_each(plane, [](const auto& race) { return speed_up(race, "relocate", "relocate-flips"); });
        c.theirs = range(x, times);
        c.ours =
            range(of_each(plane, [](const auto& race) { return speed_up(race, "relocate", "filter-each"); }), times) +
            " (filter-each)";
        c.verdict = agree_if(least(x) >= 1.6 && most(x) <= 3);
        c.reason = "Timed at some steps, on copies. The paper's CGAL was 3.3.";
    }
    out.push_back(c);

    c = {"figure-11",
         "If all points move, a timestamp relocates 2n vertices at most.",
         "at most 2n",
         "",
         "",
         Claim_verdict::open,
         ""};
    if (!all.empty()) {
        const auto x = of_each(all, [](const auto& race) { return most_renewals(race, "paper"); });
        c.theirs = "at most " + times(most(x)) + " n";
        c.ours = "a timestamp costs at most one and a half rebuilds (auto)";
        c.verdict = agree_if(most(x) <= 2);
    }
    out.push_back(c);

    c = {"figure-7", "Testing the safe region saves no time over the tolerance alone.",
         "none",     "",
         "",         Claim_verdict::open,
         ""};
    if (!plane.empty()) {
        const auto x = of_each(plane, [](const auto& race) { return speed_up(race, "filter:safe-region", "filter"); });
        c.theirs = "–";
        c.ours = "with the test " + range(x, times) + " times as long (filter, plane)";
        c.verdict = agree_if(least(x) >= 0.97);
        c.reason = "Ours is a second look at certificates whose tolerance has expired.";
    }
    out.push_back(c);

    c = {"unsound", "Tolerances become numerically more stable along such runs: theta grows.",
         "grows",   "",
         "",        Claim_verdict::open,
         ""};
    if (!all.empty()) {
        std::size_t grown = 0;
        for (const Race_record* race : all)
            grown += last_of(*race, theta_hundredth) > first_of(*race, theta_hundredth) ? 1U : 0U;
        c.theirs =
            "the hundredth of theta grew in " + grouped(grown) + " of " + grouped(all.size()) +
            " runs: " + range(of_each(all, [](const auto& x) { return first_of(x, theta_hundredth); }), readable) +
            " at the start, " +
            range(of_each(all, [](const auto& x) { return last_of(x, theta_hundredth); }), readable) + " at the end";
        c.ours = "the ladder of arithmetic does not depend on it";
        c.verdict = agree_if(2 * grown > all.size());
        c.reason = "In bodies with thin features it hardly grows.";
    }
    out.push_back(c);

    c = {"figure-12",
         "Computing tolerances at the start takes next to nothing.",
         "< 0.13 % of the time",
         "",
         "",
         Claim_verdict::open,
         ""};
    if (!all.empty()) {
        const auto first = [](const char* name) {
            return [name](const Race_record& race) {
                const Racer_record* x = racer_of(race, name);
                const double total = total_seconds(race, name);
                return x && total > 0 ? x->precompute_seconds / total : 0;
            };
        };
        const auto x = of_each(all, first("paper"));
        c.theirs = range(x, percent);
        c.ours = range(of_each(all, first("filter")), percent) + " (filter)";
        c.verdict = agree_if(most(x) < 0.0013);
        c.of_long_runs = true;
        c.reason =
            "Of the time of the triangulation alone; the paper's runs took longer, and may count the motion. The "
            "faster the steps, the larger the share of the same beginning.";
    }
    out.push_back(c);

    c = {"figure-12", "When all points move, relocating them is slower than rebuilding.",
         "slower",    "",
         "",          Claim_verdict::open,
         ""};
    if (!all.empty()) {
        const auto slower = [](const Race_record& race) { return speed_up(race, "relocate", "rebuild"); };
        c.theirs = "relocation takes " + range(of_each(plane, slower), times) + " rebuilds in the plane, " +
                   range(of_each(space, slower), times) + " in space";
        c.ours = "–";
        c.verdict = agree_if(least(of_each(all, slower)) > 1);
    }
    out.push_back(c);
}

}  // namespace annulus
