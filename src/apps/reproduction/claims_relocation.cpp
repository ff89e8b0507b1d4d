// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

#include <limits>

// Sections 1 and 3 of the paper: the cost of relocating a vertex, and when it is worth while.
namespace annulus::inline v1 {

namespace {

double microseconds(const Benchmark_record& benchmark, double Operation_record::*what) {
    return benchmark.operations.empty() ? 0 : 1e6 * benchmark.operations.back().*what;
}
double removal(const Benchmark_record& benchmark) { return microseconds(benchmark, &Operation_record::removal); }
double insertion(const Benchmark_record& benchmark) { return microseconds(benchmark, &Operation_record::insertion); }

double late_gain(const Benchmark_record& benchmark, const char* slow, const char* quick) {
    return speed_up_between(benchmark, slow, quick, benchmark.steps - std::max<std::uint64_t>(1, benchmark.steps / 10),
                            benchmark.steps);
}
double early_gain(const Benchmark_record& benchmark, const char* slow, const char* quick) {
    return speed_up_between(benchmark, slow, quick, 0, std::max<std::uint64_t>(1, benchmark.steps / 10));
}

/// The weaker version of 3.1, alone and with tolerances.
void append_in_place(const Reproduction& r, std::vector<Claim>& out) {
    const auto plane = lloyds(r), space = meshes(r);
    Claim c = claim(
        "figure-7",
        "Relocating only where cells have to change, and else writing the new place, pays where moves are small, in "
        "the plane and in space.",
        "pays off");
    Claim f = claim("figure-12", "Together with the filter that is definitely a good option.", "yes");
    if (!plane.empty() && !space.empty()) {
        const auto early = [](const Benchmark_record& benchmark) {
            return early_gain(benchmark, "relocate", "relocate-in-place");
        };
        const auto late = [](const Benchmark_record& benchmark) {
            return late_gain(benchmark, "relocate", "relocate-in-place");
        };
        c.theirs = "times as fast as relocation, in the first tenth of the steps and in the last: " +
                   range(of_each(plane, early), times) + " and " + range(of_each(plane, late), times) +
                   " in the plane, " + range(of_each(space, early), times) + " and " +
                   range(of_each(space, late), times) + " in space";
        c.ours = "every strategy tests in place first";
        c.verdict = every({above_one(of_each(plane, late)), above_one(of_each(space, late))});
        c.reason = "Relocation is timed at some steps, on copies.";
        const auto both = [](const Benchmark_record& benchmark) {
            return speed_up(benchmark, "paper-printed", "paper-in-place");
        };
        f.theirs = "the filter with it is " + range(of_each(plane, both), times) +
                   " times as fast as without in the plane, " + range(of_each(space, both), times) + " times in space";
        f.ours = "as above";
        f.verdict = every({above_one(of_each(plane, both)), above_one(of_each(space, both))});
        f.reason = "Of the moves whose tolerance failed most change no cell.";
    }
    out.push_back(c);
    out.push_back(f);
}

/// When only some points move.
void append_movers(const Reproduction& r, std::vector<Claim>& out) {
    Claim c =
        claim("movers", "When only a fraction of the points moves, rebuilding is not the best: relocating costs O(m).",
              "m < n");
    const auto some = present(r, {"movers-plane-1", "movers-space-1"}),
               more = present(r, {"movers-plane-10", "movers-space-10"}),
               all = present(r, {"movers-plane-100", "movers-space-100"});
    if (some.size() == 2 && more.size() == 2 && all.size() == 2) {
        const auto cost = [](const char* name) {
            return [name](const Benchmark_record& benchmark) { return share(1, speed_up(benchmark, "rebuild", name)); };
        };
        const auto words = [&](const char* name) {
            const auto at = [&](std::size_t k) {
                std::string text;
                for (const auto* benchmarks : {&some, &more, &all})
                    text += (text.empty() ? "" : ", ") + times(cost(name)(*(*benchmarks)[k]));
                return text;
            };
            return at(0) + " rebuilds in the plane and " + at(1) + " in space";
        };
        c.theirs = "with 1, 10 and 100 % moving, CGAL's relocation takes " + words("relocate-cgal") +
                   "; the library's " + words("relocate") + "; the filter " + words("paper-printed");
        c.ours = "tolerances-each " + words("tolerances-each") + "; auto " + words("auto");
        const auto gain = [](const Benchmark_record& x) { return speed_up(x, "rebuild", "relocate-cgal"); };
        c.verdict = every({above_one(of_each(some, gain)), above_one(of_each(all, cost("relocate-cgal")))});
        c.reason = "Random points, moves of a twentieth of a spacing, so that most of them leave their tolerance.";
    }
    out.push_back(c);
}

void append_removal(const Reproduction& r, std::vector<Claim>& out) {
    const auto plane = lloyds(r), space = meshes(r);
    Claim c =
        claim("figure-12", "Removal is dramatically slower in space, and a vertex is in five times as many bi-cells.",
              "slower; 5 times");
    if (!plane.empty() && !space.empty()) {
        const auto cells = [](const Benchmark_record& benchmark) {
            const Certificate_survey_record* s = survey_at(benchmark, 1);
            return s ? s->bicells_a_vertex : 0;
        };
        const double ratio = share(least(of_each(space, cells)), most(of_each(plane, cells)));
        c.theirs = "a removal takes " + range(of_each(plane, removal), times) + " µs in the plane and " +
                   range(of_each(space, removal), times) + " µs in space, an insertion " +
                   range(of_each(plane, insertion), times) + " and " + range(of_each(space, insertion), times) +
                   " µs; bi-cells " + times(ratio) + " times as many at least";
        c.ours = "flips and tests in place stand in for nearly all removals";
        c.verdict =
            agree_if(least(of_each(space, removal)) > 5 * most(of_each(plane, removal)) && ratio > 4.5 && ratio < 6);
        c.reason =
            "Dramatically: five times; 5 times as many means 4.5 to 6. CGAL's, a tenth of the vertices one after "
            "another, at the end of each run.";
    }
    out.push_back(c);
}

}  // namespace

void append_relocation_claims(const Reproduction& r, std::vector<Claim>& out) {
    append_movers(r, out);
    const auto plane = lloyds(r), space = meshes(r);
    auto all = plane;
    all.insert(all.end(), space.begin(), space.end());

    Claim c = claim("figure-12", "When all points move, relocating them is slower than rebuilding.", "slower");
    if (!all.empty()) {
        const auto slower = [](const Benchmark_record& benchmark) {
            return speed_up(benchmark, "relocate-cgal", "rebuild");
        };
        c.theirs = "CGAL's relocation takes ";
        if (!plane.empty()) c.theirs += range(of_each(plane, slower), times) + " rebuilds in the plane";
        if (!plane.empty() && !space.empty()) c.theirs += ", ";
        if (!space.empty())
            c.theirs += range(of_each(space, slower), times) + (plane.empty() ? " rebuilds in space" : " in space");
        c.ours = "auto takes " +
                 range(of_each(all, [](const auto& x) { return share(1, speed_up(x, "rebuild", "auto")); }), times) +
                 " rebuilds";
        c.verdict = above_one(of_each(all, slower));
    }
    out.push_back(c);

    c = claim("figure-7", "Flips in place of removal make relocation twice as fast in the plane.", "2");
    if (!plane.empty()) {
        const auto x =
            of_each(plane, [](const auto& benchmark) { return speed_up(benchmark, "relocate", "relocate-flips"); });
        c.theirs = range(x, times);
        c.ours = speeds(plane, "relocate", {"tolerances-each"});
        c.verdict = within(measured(x), 1.6, 3);
        c.reason =
            "2 means 1.6 to 3. Both on the library's mesh, timed at some steps, on copies. What flips save depends on "
            "what a removal "
            "costs. One of CGAL's takes " +
            range(of_each(plane, removal), times) + " µs here, an insertion " +
            range(of_each(plane, insertion), times) + " µs; the paper's CGAL was 3.3.";
    }
    out.push_back(c);
    append_in_place(r, out);

    c = claim("figure-11", "If all points move, a time step relocates 2n vertices at most.", "at most 2n");
    if (!all.empty()) {
        const auto x = of_each(all, [](const auto& benchmark) { return most_renewals(benchmark, "paper-printed"); });
        c.theirs = "at most " + times(most(x)) + " n";
        c.ours =
            "the longest time step of auto takes " +
            range(of_each(all, [](const auto& benchmark) { return longest_step(benchmark, "auto"); }), times) +
            " rebuilds by the processor's clock, but for the longest hundredth of the steps " +
            range(of_each(all, [](const auto& benchmark) { return longest_step(benchmark, "auto", 0.01); }), times);
        c.verdict = agree_if(most(x) <= 2);
        c.reason = "The bound of auto, one and a half rebuilds, is one of counted costs and not of the clock.";
    }
    out.push_back(c);

    c = claim("figure-7", "Testing the safe region when the tolerance failed saves no time.", "none");
    if (!plane.empty()) {
        const auto x = of_each(
            plane, [](const auto& benchmark) { return speed_up(benchmark, "paper-safe-region", "paper-printed"); });
        c.theirs = "with the test " + range(x, times) + " times as long in the plane";
        c.verdict = within(measured(x), 0.97, std::numeric_limits<double>::infinity());
        c.reason = std::string("None: 0.97 times as long at least. ") +
                   (c.verdict == Claim_verdict::agrees
                        ? "A vertex beyond its tolerance and within its safe region keeps its reference, "
                          "and is tested again at each further step."
                        : "It spares relocations, which are expensive beside the test of some twelve circles; "
                          "tests in place spare more.");
    }
    out.push_back(c);
    append_removal(r, out);
}

}  // namespace annulus::inline v1
