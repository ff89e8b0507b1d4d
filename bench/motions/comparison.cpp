// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.h"

#include "cgal_rebuild.h"
#include "follower.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>

namespace bench {

namespace {

using namespace annulus;
using nlohmann::ordered_json;

template <int d>
struct Runner {
    std::string name;
    std::unique_ptr<Follower<d>> follower;
    double construction = 0.0;
    std::vector<double> seconds;
    Move_result report;
    int failed_audits = 0;
};

template <int d>
Runner<d> runner(const std::string& name, const Comparison& comparison, const Points<d>& x, Stopwatch watch) {
    const double begin = watch.seconds();
    Runner<d> r{name, follower<d>(name, comparison.threads, x), 0.0, {}, {}, 0};
    r.construction = watch.seconds() - begin;
    return r;
}

}  // namespace

template <int d>
int compare(Motion<d>& motion, const Comparison& comparison, const std::string& name, ordered_json& out) {
    const Stopwatch watch(comparison.threads);
    std::vector<Runner<d>> runners;
    for (const std::string& s : comparison.strategies)
        runners.push_back(runner<d>(s, comparison, motion.points(), watch));
    std::vector<double> cgal;
    std::vector<double> nanoseconds;  // of CGAL, per vertex
    std::vector<double> displacement;
    std::vector<double> count;
    std::size_t moves = 0;  // including insertions and removals
    const std::size_t turns = runners.size() + 1;
    for (int step = 0; step < comparison.warm + comparison.steps && motion.step(); ++step) {
        const bool counts = step >= comparison.warm;
        const Points<d> present = motion.present();
        if (counts) {
            displacement.push_back(motion.mean_displacement());
            count.push_back(static_cast<double>(present.size()));
            moves += motion.leave().size() + motion.arrive().size();
        }
        for (std::size_t k = 0; k < turns; ++k) {
            const std::size_t turn = (k + static_cast<std::size_t>(step)) % turns;
            if (turn == runners.size()) {
                const double s = cgal_rebuild<d>(present, watch);
                if (!counts) continue;
                cgal.push_back(s);
                nanoseconds.push_back(1e9 * s / std::max(count.back(), 1.0));
                continue;
            }
            Runner<d>& r = runners[turn];
            Move_result report;
            const double s = r.follower->follow(motion, watch, report);
            if (!counts) continue;
            r.seconds.push_back(s);
            r.report += report;
            if (comparison.audit_all && !r.follower->is_delaunay()) ++r.failed_audits;
        }
    }
    const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
    out["points"] = static_cast<std::size_t>(quantile(count, 0.5));
    out["steps"] = cgal.size();
    out["threads"] = comparison.threads;
    out["displacement"] = quantile(displacement, 0.5);
    out["came_and_went"] = moves;
    out["cgal_ns"] = quantile(nanoseconds, 0.5);
    std::printf("%s: %.3g spacings a step, cgal %.0f ns", name.c_str(), quantile(displacement, 0.5),
                quantile(nanoseconds, 0.5));
    int failed = 0;
    for (Runner<d>& r : runners) {
        std::vector<double> ratio;
        std::vector<double> cost;  // in rebuilds
        std::vector<double> ns;
        for (std::size_t i = 0; i < cgal.size(); ++i) {
            ratio.push_back(cgal[i] / r.seconds[i]);
            cost.push_back(r.seconds[i] / cgal[i]);
            ns.push_back(1e9 * r.seconds[i] / std::max(count[i], 1.0));
        }
        if (comparison.audit && !r.follower->is_delaunay()) ++r.failed_audits;
        failed += r.failed_audits;
        const double asked = static_cast<double>(std::max<std::uint64_t>(r.report.moves.asked, 1));
        const auto share = [&](std::uint64_t k) { return static_cast<double>(k) / asked; };
        const double whole = r.seconds.empty() ? 0.0 : sum(cgal) / sum(r.seconds);
        std::printf(" | %s %.0f ns, ratio %.2f, of sums %.2f, most expensive %.2f%s", r.name.c_str(), quantile(ns, 0.5),
                    quantile(ratio, 0.5), whole, quantile(cost, 1.0), r.failed_audits != 0 ? " AUDIT FAILED" : "");
        if (share(r.report.moves.rebuilt) > 0.0) std::printf(", rebuilt %.2f", share(r.report.moves.rebuilt));
        std::printf(", flips %.3f, again %.4f", share(r.report.statistics.flips), share(r.report.moves.reinserted));
        out[r.name] = {{"ns", quantile(ns, 0.5)},
                       {"ratio", quantile(ratio, 0.5)},
                       {"whole", whole},
                       {"ratio_low", quantile(ratio, 0.1)},
                       {"ratio_high", quantile(ratio, 0.9)},
                       {"most expensive", quantile(cost, 1.0)},
                       {"construction_ns", 1e9 * r.construction / quantile(count, 0.5)},
                       {"rebuilt", share(r.report.moves.rebuilt)},
                       {"within_tolerance", share(r.report.moves.within_tolerance)},
                       {"flips", share(r.report.statistics.flips)},
                       {"evaluated", share(r.report.statistics.evaluated)},
                       {"exact", share(r.report.statistics.arithmetic.exact)},
                       {"reinserted", share(r.report.moves.reinserted)},
                       {"audit", r.failed_audits == 0}};
        if (comparison.each_step) out[r.name]["each"] = r.seconds;
    }
    std::printf("\n");
    std::fflush(stdout);
    return failed;
}

template int compare<2>(Motion<2>&, const Comparison&, const std::string&, ordered_json&);
template int compare<3>(Motion<3>&, const Comparison&, const std::string&, ordered_json&);

}  // namespace bench
