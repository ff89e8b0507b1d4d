// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/counted_vertices.h>
#include <apps/cli/input.h>
#include <apps/cli/print_advice.h>
#include <apps/formats/printable.h>
#include <apps/report/advice.h>
#include <apps/report/walk_ratios.h>

#include <algorithm>
#include <cstdio>

namespace annulus::inline v1::cli {

namespace {

unsigned long long count(std::uint64_t n) { return n; }

double percent(std::uint64_t part, std::uint64_t all) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(all, 1));
}

void print_head(const Advice_record& r) {
    const Motion_record& m = r.motion;
    std::printf("%s", counted_vertices(m.most_vertices).c_str());
    if (m.least_vertices != m.most_vertices) std::printf(" (%llu at least)", count(m.least_vertices));
    std::printf(" in %s, dimension %d\n", counted(m.frames, "frame").c_str(), r.dimension);
    print_input(r.input, r.dimension);
    std::printf("box            ");
    for (std::size_t k = 0; k < static_cast<std::size_t>(r.dimension); ++k)
        std::printf("%s[%.6g, %.6g]", k > 0 ? " x " : "", m.low[k], m.high[k]);
    std::printf(", of the points\n");
    if (!r.input.ignored.empty())
        std::printf("periodic box   ignored here, as by replay with --open; replay itself takes it\n");
    std::printf("mean spacing   %.6g\n", m.spacing);
    if (m.frames > 1 && m.least_distance != m.most_distance)
        std::printf("frames         their numbers are %llu to %llu apart: see --absent-frames of replay\n",
                    count(m.least_distance), count(m.most_distance));
}

void print_displacement(const Displacement_record& d) {
    if (d.total == 0) return;
    const auto& q = d.quantiles;
    std::printf(
        "displacement   per frame, in mean spacings: mean %.3g, median %.3g, 95 %% below %.3g, 99 %% below %.3g, "
        "largest %.3g; at rest %.3g %%\n",
        d.mean, q[2], q[4], q[5], q[6], percent(d.at_rest, d.total));
}

void print_events(const Motion_record& m) {
    const Id_events& twice = m.duplicates;
    if (twice.count == 0) std::printf("duplicates     none\n");
    else
        std::printf("duplicates     %s in %s, the first: id %s is where id %s is in frame %llu\n",
                    counted(twice.count, "point").c_str(), counted(twice.frames, "frame").c_str(),
                    printable(twice.first.front().id).c_str(), printable(twice.first.front().what).c_str(),
                    count(twice.first.front().frame));
    if (m.frames < 2) return;
    if (m.traffic.count == 0) std::printf("ids            the same in all frames\n");
    else
        std::printf("ids            %llu appear, %llu disappear, in %s, the first: id %s %s in frame %llu\n",
                    count(m.appeared), count(m.disappeared), counted(m.traffic.frames, "frame").c_str(),
                    printable(m.traffic.first.front().id).c_str(), m.traffic.first.front().what.c_str(),
                    count(m.traffic.first.front().frame));
    if (m.wrapped)
        std::printf(
            "wrapped        it seems so: %s by about the length of the box, left out above, the first: id %s "
            "along %s in frame %llu\n",
            counted(m.jumps.count, "jump").c_str(), printable(m.jumps.first.front().id).c_str(),
            m.jumps.first.front().what.c_str(), count(m.jumps.first.front().frame));
    else std::printf("wrapped        no\n");
}

void print_degeneracy(const Advice_record& r) {
    if (!r.degeneracy) {
        std::printf("flat           the points of the first frame span fewer dimensions\n");
        return;
    }
    const Degeneracy& d = *r.degeneracy;
    const Width_counts& w = d.bicells.least;
    std::printf("degeneracy     of frame %llu: %s, exactly %s %llu", count(r.degeneracy_frame),
                counted(w.total, "bi-cell").c_str(), d.dimension == 2 ? "cocircular" : "cospherical", count(w.zero));
    for (std::size_t i = 0; i < w.below.size(); ++i)
        std::printf(", < %s %llu", d.thresholds[i].name.c_str(), count(w.below[i]));
    Stage_counts all = d.bicells.arithmetic;
    all += d.cells.arithmetic;
    all += d.ridges.arithmetic;
    std::printf("\ncertificates   %llu decided: filter %llu, interval %llu, exact %llu\n", count(all.total()),
                count(all.filter), count(all.interval), count(all.exact));
    const auto& t = d.vertices.certified.quantiles;
    if (!t.empty()) std::printf("tolerances     in mean spacings: median %.3g, 5 %% below %.3g\n", t[5], t[2]);
}

void print_gain(const Advice_record& r) {
    const Motion_record& m = r.motion;
    if (m.displacement.total > 0) {
        const double s = walk_pace(r.dimension, m.displacement.mean);
        std::printf(
            "expected gain  of auto over rebuilding %.3g, over CGAL's insertion %.3g: an estimate, from random "
            "walks of s = %.3g\n",
            walk_gain(r.dimension, s), walk_ratio(r.dimension, s), s);
    }
    const Prefix_record& p = r.prefix;
    if (p.steps == 0) return;
    std::printf("counted cost   of a step, in rebuilds: auto %.3g, tolerances %.3g; in %s%s\n", p.automatic,
                p.tolerances, counted(p.steps, "step").c_str(), m.frames > 2 ? " after the first" : "");
    std::printf(
        "moves          within tolerance %.4g %%, kept in place %.4g %%, flipped %.4g %%, reinserted %.4g %%, "
        "rebuilt %.4g %%\n",
        percent(p.moves.within_tolerance, p.moves.asked), percent(p.moves.kept_in_place, p.moves.asked),
        percent(p.moves.flipped, p.moves.asked), percent(p.moves.reinserted, p.moves.asked),
        percent(p.moves.rebuilt, p.moves.asked));
}

}  // namespace

void print_advice(const Advice_record& r) {
    print_head(r);
    print_displacement(r.motion.displacement);
    print_events(r.motion);
    print_degeneracy(r);
    print_gain(r);
    std::printf("seconds        reading %.3f, following %.3f, degeneracy %.3f\n", r.seconds_reading,
                r.seconds_following, r.seconds_analysis);
    std::printf("advice         %s\n", advice_of(r).sentence.c_str());
}

}  // namespace annulus::inline v1::cli
