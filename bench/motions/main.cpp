// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies and CGAL's rebuild on one motion, timed step by step in turn: nanoseconds per vertex and step, ratios of
// the same step.
#include "comparison.h"
#include "crowd.h"
#include "dynamics.h"
#include "families.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace {

using nlohmann::ordered_json;

struct Choice {
    int dimension = 3;
    std::string family = "uniform";
    std::string motion = "walk";
    std::size_t points = 8000;
    double spacings = 0.01;
    int every = 1;
    std::uint64_t seed = 1;
    bench::Comparison comparison;
};

template <int d>
std::unique_ptr<bench::Motion<d>> make(const Choice& c) {
    if (c.motion == "dynamics") {
        if constexpr (d == 3) return std::make_unique<bench::Dynamics>(c.points, c.every, c.seed);
    } else if (c.motion == "crowd") {
        if constexpr (d == 2) return std::make_unique<bench::Crowd>(c.points, c.every, c.seed);
    } else {
        return std::make_unique<bench::Scene<d>>(c.family, c.motion, c.points, c.spacings, c.seed);
    }
    throw std::invalid_argument(c.motion + " is not of dimension " + std::to_string(d));
}

template <int d>
int run(const Choice& c, const std::string& file) {
    const bool simulated = c.motion == "dynamics" || c.motion == "crowd";
    const auto motion = make<d>(c);
    ordered_json out{{"dimension", d}, {"family", simulated ? "" : c.family}, {"motion", c.motion}, {"seed", c.seed}};
    if (simulated) out["every"] = c.every;
    else out["spacings"] = c.spacings;
    char name[120];
    if (simulated) std::snprintf(name, sizeof name, "%dD %s n=%zu every %d", d, c.motion.c_str(), c.points, c.every);
    else
        std::snprintf(name, sizeof name, "%dD %-8s %-6s n=%zu s=%g", d, c.family.c_str(), c.motion.c_str(), c.points,
                      c.spacings);
    const int failed = bench::compare<d>(*motion, c.comparison, name, out);
    bench::append(file, out);
    return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    std::string json;
    CLI::App app{"Strategies and CGAL's rebuild on one motion of points, step by step in turn."};
    app.add_option("-d,--dimension", choice.dimension)->check(CLI::Range(2, 3));
    app.add_option("-f,--family", choice.family,
                   "uniform, sphere, slab, clusters, faces, lattice, ball; jittered, integers; outliers, hubs");
    app.add_option("-m,--motion", choice.motion,
                   "walk, drift, shear, few, burst; dynamics (in space) and crowd (in the plane), which have neither "
                   "family nor spacings");
    app.add_option("-n,--points", choice.points)->check(CLI::Range(10, 100000000));
    app.add_option("-s,--spacings", choice.spacings, "root mean square displacement a step, in spacings");
    app.add_option("--every", choice.every, "dynamics, crowd: steps of integration between time steps")
        ->check(CLI::Range(1, 100000));
    app.add_option("-k,--steps", choice.comparison.steps);
    app.add_option("-w,--warm", choice.comparison.warm, "steps before those that count");
    app.add_option("-t,--threads", choice.comparison.threads);
    app.add_option("--seed", choice.seed);
    app.add_option(
           "--strategies", choice.comparison.strategies,
           "of Moving_delaunay; STRATEGY:view calls its triangulation() at each step; STRATEGY:mesh: Moving_mesh")
        ->delimiter(',');
    app.add_flag("!--no-audit", choice.comparison.audit);
    app.add_flag("--audit-all", choice.comparison.audit_all, "after every step, not only the last");
    app.add_flag("--each-step", choice.comparison.each_step, "write the seconds of each step, too");
    app.add_option("--json", json, "file that a line is appended to");
    CLI11_PARSE(app, argc, argv);
    try {
        return choice.dimension == 2 ? run<2>(choice, json) : run<3>(choice, json);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-motions: %s\n", e.what());
        return 3;
    }
}
