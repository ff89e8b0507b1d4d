// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

// Section 4.2 of the paper: the quality of meshes.
namespace annulus::inline v1 {

namespace {

double slivers(const Quality_record* q) { return q ? static_cast<double>(q->slivers) : 0; }
double resting(const Benchmark_record& benchmark) {
    const Quality_record* q = benchmark.qualities.empty() ? nullptr : &benchmark.qualities.back();
    return q ? share(static_cast<double>(q->locked), static_cast<double>(q->vertices)) : 0;
}

/// Measures for all figures: slivers, and the angle below which a hundredth of the angles are. The least angle is
/// noise.
void append_improvement(const Reproduction& r, std::vector<Claim>& out) {
    const auto space = meshes(r);
    Claim c = claim("figure-9", "Going from 100 to 1,000 iterations makes the mesh better.", "yes");
    if (!space.empty() && space.front()->steps > 100) {
        std::string fewer, wider;
        std::size_t better = 0;
        for (const Benchmark_record* benchmark : space) {
            const Quality_record *a = quality_at(*benchmark, 100), *z = quality_at(*benchmark, benchmark->steps);
            if (!a || !z) continue;
            const std::string name = benchmark->name.substr(5);
            fewer += (fewer.empty() ? "" : ", ") + name + " " + grouped(a->slivers) + " to " + grouped(z->slivers);
            wider += (wider.empty() ? "" : ", ") + name + " " + readable(small_angle(*a)) + " to " +
                     readable(small_angle(*z));
            better += z->slivers < a->slivers && small_angle(*z) >= small_angle(*a) ? 1U : 0U;
        }
        c.theirs = "slivers: " + fewer + "; a hundredth of the dihedral angles are below, in degrees: " + wider;
        c.ours = "the same motion";
        c.verdict = agree_if(better == space.size());
        c.reason = "Both became better in " + grouped(better) + " of " + grouped(space.size()) +
                   ". What is left after 100 iterations is little, and sits at the surface.";
        c.of_long_runs = true;
    }
    out.push_back(c);
}

void append_slivers(const Reproduction& r, std::vector<Claim>& out) {
    Claim c = claim("slivers", "With variable sizing that leaves so many slivers less.", "15 %");
    const auto spheres = present(
                   r, {"graded-sphere", "graded-sphere-2", "graded-sphere-3", "graded-sphere-4", "graded-sphere-5"}),
               bunny = present(r, {"graded-bunny"});
    const auto early = [](const Benchmark_record& benchmark) { return slivers(quality_at(benchmark, 100)); };
    const auto late = [](const Benchmark_record& benchmark) { return slivers(quality_at(benchmark, benchmark.steps)); };
    const auto gain = [&](const Benchmark_record& benchmark) {
        return early(benchmark) > 0 ? 1 - late(benchmark) / early(benchmark) : 0;
    };
    if (!spheres.empty() && spheres.front()->steps > 100) {
        double before = 0, after = 0, mean = 0, squares = 0;
        const auto x = of_each(spheres, gain);
        for (const Benchmark_record* benchmark : spheres) {
            before += early(*benchmark);
            after += late(*benchmark);
        }
        const auto n = static_cast<double>(x.size());
        for (const double y : x) mean += y / n;
        for (const double y : x) squares += (y - mean) * (y - mean);
        const double deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
        c.theirs = grouped(x.size()) + " spheres: " + grouped(static_cast<std::uint64_t>(before)) + " slivers to " +
                   grouped(static_cast<std::uint64_t>(after)) + " in all, " + range(x, percent) +
                   " less, in the mean " + percent(mean) + " with a standard deviation of " + percent(deviation);
        if (!bunny.empty())
            c.theirs += "; bunny " + grouped(static_cast<std::uint64_t>(early(*bunny.front()))) + " to " +
                        grouped(static_cast<std::uint64_t>(late(*bunny.front())));
        c.ours = "the same motion";
        c.verdict = agree_if(mean + deviation >= 0.15);
        c.of_long_runs = true;
        c.reason =
            "A sliver has a dihedral angle below 10 or above 170 degrees. So few are left after 100 iterations that "
            "one more or less is " +
            percent(share(n, before)) + " of a sphere's: too few to tell 15 % from none.";
    }
    out.push_back(c);
}

void append_locks(const Reproduction& r, std::vector<Claim>& out) {
    Claim c = claim("locked", "Vertices among good cells are locked: in the end so many.", "95 %");
    const auto locked = present(r, {"locked-sphere", "locked-bunny"});
    const auto others = present(r, {"locked-sphere-5", "locked-sphere-10", "locked-sphere-20", "locked-sphere-25"});
    if (!locked.empty()) {
        std::string more;
        for (const Benchmark_record* benchmark : others)
            more += (more.empty() ? "" : ", ") + benchmark->name.substr(benchmark->name.rfind('-') + 1) + " degrees " +
                    percent(resting(*benchmark));
        c.theirs = "locks of 15 degrees: " + listed(locked, resting, percent) +
                   (more.empty() ? "" : "; sphere with others: " + more);
        c.ours = "the same motion";
        c.verdict = agree_if(most(of_each(locked, resting)) >= 0.9);
        c.of_long_runs = true;
        c.reason =
            "Locked where the dihedral angles of all cells are between so many degrees and 180 less them. The paper "
            "does not say which angles it takes, and on that the share depends; it refines meanwhile, which we do not.";
    }
    out.push_back(c);
}

}  // namespace

void append_quality_claims(const Reproduction& r, std::vector<Claim>& out) {
    append_improvement(r, out);
    append_slivers(r, out);
    append_locks(r, out);
    Claim c = claim("figure-8", "Optimised meshes of the four bodies.", "pictures");
    if (const auto space = meshes(r); !space.empty()) {
        c.theirs = c.ours = "pictures of " + grouped(space.size()) + (space.size() == 1 ? " body" : " bodies");
        c.verdict = Claim_verdict::agrees;
        c.reason =
            space.size() < 4 ? "The others need --surfaces." : "CGAL's liver in place of the heart, and CGAL's man.";
    }
    out.push_back(c);
}

}  // namespace annulus::inline v1
