// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/plan.h>

#include <algorithm>
#include <cmath>

namespace annulus {

namespace {

Options options_of(Strategy strategy, Tolerance_kind kind = Tolerance_kind::certified,
                   Second_look look = Second_look::off) {
    Options o;
    o.strategy = strategy;
    o.tolerance = kind;
    o.second_look = look;
    return o;
}

/// What everybody is compared with, the paper's algorithm, and ours. `cgal_every`, `copy_every`: what is timed at some steps only.
std::vector<Racer_plan> racers(std::uint64_t cgal_every, std::uint64_t copy_every) {
    using Kind = Racer_plan::Kind;
    return {{"rebuild", Kind::cgal, {}, cgal_every, 0},
            {"relocate", Kind::copy, options_of(Strategy::relocate), copy_every, 0},
            {"paper", Kind::follower, options_of(Strategy::filter_each, Tolerance_kind::paper), 1, 10},
            {"paper-hybrid", Kind::paper_hybrid, options_of(Strategy::filter_each, Tolerance_kind::paper), 1, 0},
            {"filter-each", Kind::follower, options_of(Strategy::filter_each), 1, 0},
            {"filter", Kind::follower, options_of(Strategy::filter), 1, 0},
            {"filter:floating", Kind::follower, options_of(Strategy::filter, Tolerance_kind::floating), 1, 0},
            {"auto", Kind::follower, options_of(Strategy::automatic), 1, 0}};
}

/// 1, 2, 3 .., then eight a decade.
std::set<std::uint64_t> spread(std::uint64_t steps) {
    std::set<std::uint64_t> out{steps, steps + 1};
    for (double x = 1; x <= static_cast<double>(steps); x *= std::pow(10.0, 0.125))
        out.insert(static_cast<std::uint64_t>(std::lround(x)));
    return out;
}

std::set<std::uint64_t> decades(std::uint64_t steps, bool after) {
    std::set<std::uint64_t> out;
    for (std::uint64_t k = 1; k <= steps; k *= 10) out.insert(k);
    if (after) out.insert(steps + 1);
    return out;
}

bool asked(const Reproduction_size& size, std::initializer_list<const char*> topics) {
    return size.only.empty() || std::any_of(topics.begin(), topics.end(), [&](const char* t) {
               return std::find(size.only.begin(), size.only.end(), t) != size.only.end();
           });
}

std::uint64_t steps_of(const Reproduction_size& size, std::uint64_t quick) {
    return size.iterations > 0 ? size.iterations : size.quick ? quick : 1000;
}

/// At most every `every`-th, and ten times at least.
std::uint64_t sampled(std::uint64_t steps, std::uint64_t every) {
    return std::max<std::uint64_t>(1, std::min(every, steps / 10));
}

void add_lloyd(const Reproduction_size& size, std::vector<Part_plan>& out) {
    using Kind = Racer_plan::Kind;
    const std::uint64_t steps = steps_of(size, 100);
    for (const char* density : {"one", "x2"}) {
        if (!asked(size, {"fig5"})) continue;
        Part_plan p;
        p.motion = {.dimension = 2, .vertices = size.quick ? 500U : 1000U, .density = density};
        p.race = {.name = std::string("points-") + density,
                  .title = std::string("Lloyd, density ") + density,
                  .steps = steps,
                  .pictures = {0, steps}};
        out.push_back(p);
    }
    for (const char* density : {"one", "x2+y2", "x2", "sin2"}) {
        const bool x2 = std::string(density) == "x2";
        if (!asked(size, {"fig7"}) && !(x2 && asked(size, {"fig6", "fig11"}))) continue;
        Part_plan p;
        p.motion = {.dimension = 2, .vertices = size.quick ? 2000U : 10'000U, .density = density};
        p.race = {.name = std::string("lloyd-") + density,
                  .title = std::string("Lloyd, density ") + density,
                  .steps = steps,
                  .racers = racers(1, sampled(steps, 10))};
        p.race.racers.push_back(
            {"relocate-flips", Kind::copy, options_of(Strategy::relocate_flips), sampled(steps, 10), 0});
        p.race.racers.push_back({"filter:safe-region", Kind::follower,
                                 options_of(Strategy::filter, Tolerance_kind::certified, Second_look::safe_region), 1,
                                 0});
        p.race.surveys = x2 ? spread(steps) : decades(steps, true);
        p.race.distributions = decades(steps, false);
        p.race.degeneracies = decades(steps, true);
        out.push_back(p);
    }
}

struct Body {
    const char *name, *title, *surface;
    bool crossing;
    std::uint64_t vertices, quick;
};
/// In place of the paper's heart, an organ that everybody can have: CGAL's liver.
constexpr Body bodies[] = {{"sphere", "sphere", "", false, 13'000, 1500},
                           {"man", "man", "man.off", true, 8000, 1000},
                           {"bunny", "bunny", "bunny00.off", false, 13'000, 1500},
                           {"heart", "liver, in place of the heart", "liver.inr.gz", false, 10'000, 1200}};

Part_plan body_part(const Reproduction_size& size, const Body& b) {
    Part_plan p;
    p.motion = {
        .dimension = 3, .vertices = size.quick ? b.quick : b.vertices, .surface = b.surface, .crossing = b.crossing};
    p.race.steps = steps_of(size, 60);
    p.race.quality_every = 10;
    p.race.seed = size.seed;
    return p;
}

void add_bodies(const Reproduction_size& size, std::vector<Part_plan>& out) {
    for (const Body& b : bodies) {
        const std::string name = b.name;
        if (name != "sphere" && !size.surfaces) continue;
        const bool wanted = asked(size, {"fig8", "fig12"}) || (name == "sphere" && asked(size, {"fig10", "fig11"})) ||
                            (name == "bunny" && asked(size, {"fig11"})) || (name == "man" && asked(size, {"fig9"}));
        if (!wanted) continue;
        Part_plan p = body_part(size, b);
        const std::uint64_t steps = p.race.steps;
        p.race.name = "nodt-" + name;
        p.race.title = std::string("Natural ODT, ") + b.title;
        p.race.racers = racers(sampled(steps, 4), sampled(steps, 50));
        p.race.surveys = spread(steps);
        p.race.distributions = decades(steps, false);
        p.race.degeneracies = p.race.adversaries = decades(steps, true);
        p.race.attacks = size.quick ? 200 : 2000;
        p.race.pictures = {0, std::min<std::uint64_t>(100, steps), steps};
        out.push_back(p);
    }
}

/// Motions that nobody races on: what the mesh becomes.
void add_qualities(const Reproduction_size& size, std::vector<Part_plan>& out) {
    for (const Body& b : bodies) {
        const std::string name = b.name;
        if (name != "sphere" && (name != "bunny" || !size.surfaces)) continue;
        for (const bool locked : {false, true}) {
            if (!asked(size, {locked ? "locked" : "slivers"})) continue;
            Part_plan p = body_part(size, b);
            p.race.name = (locked ? "locked-" : "graded-") + name;
            p.race.title =
                std::string(locked ? "Natural ODT with locks, " : "Natural ODT, variable sizing, ") + b.title;
            p.motion.graded = !locked;
            if (!locked && name != "sphere")
                p.motion.vertices = std::min<std::uint64_t>(p.motion.vertices,
                                                            4000);  // a ball is cheaper to ask how deep a vertex lies
            p.motion.lock_degrees = locked ? 15 : 0;
            out.push_back(p);
        }
    }
}

}  // namespace

const std::vector<std::string>& reproduction_topics() {
    static const std::vector<std::string> topics{"fig5",  "fig6",  "fig7",  "fig8",    "fig9",
                                                 "fig10", "fig11", "fig12", "slivers", "locked"};
    return topics;
}

std::vector<Part_plan> reproduction_parts(const Reproduction_size& size) {
    std::vector<Part_plan> out;
    add_lloyd(size, out);
    add_bodies(size, out);
    add_qualities(size, out);
    for (Part_plan& p : out) p.race.seed = size.seed;
    return out;
}

}  // namespace annulus
