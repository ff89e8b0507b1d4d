// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/plan.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

using Kind = Contender_plan::Kind;

Contender_plan ours(const char* name, Strategy strategy, std::uint64_t audit_every) {
    Options options;
    options.strategy = strategy;
    return {name, Kind::follower, options, 1, audit_every, std::nullopt};
}

Contender_plan papers(const char* name, const Paper_choice& choice, std::uint64_t audit_every,
                      Kind kind = Kind::follower, std::uint64_t every = 1) {
    return {name, kind, {}, every, audit_every, choice};
}

namespace choices {
/// The algorithm as printed (3.2): a vertex that fails is removed and inserted again.
constexpr Paper_choice printed{.in_place = false, .flips = false};
/// The same with the weaker version of relocation (3.1).
constexpr Paper_choice in_place{.flips = false};
constexpr Paper_choice safe_region{.in_place = false, .flips = false, .safe_region = true};
/// The relocation algorithm, its weaker version, and its flips.
constexpr Paper_choice relocate = Paper_choice::of(Strategy::relocate);
constexpr Paper_choice relocate_in_place = Paper_choice::of(Strategy::relocate_flips);
constexpr Paper_choice relocate_flips{.tolerances = false, .in_place = false};
}  // namespace choices

/// Rebuilding and relocation, the paper's algorithms, and ours. `cgal_every`, `copy_every`: contenders that are timed
/// only at some steps.
std::vector<Contender_plan> contenders(std::uint64_t cgal_every, std::uint64_t copy_every, std::uint64_t audit_every) {
    return {{"rebuild", Kind::cgal_rebuild, {}, cgal_every, 0},
            {"relocate-cgal", Kind::cgal_relocate, {}, copy_every, 0},
            papers("relocate", choices::relocate, 0, Kind::copy, copy_every),
            papers("relocate-in-place", choices::relocate_in_place, 0, Kind::copy, copy_every),
            papers("paper-printed", choices::printed, audit_every),
            papers("paper-in-place", choices::in_place, audit_every),
            papers("paper-printed-hybrid", choices::printed, 0, Kind::hybrid),
            papers("paper-in-place-hybrid", choices::in_place, 0, Kind::hybrid),
            ours("rebuild-own", Strategy::rebuild, 0),
            ours("tolerances-each", Strategy::tolerances_each, audit_every),
            ours("tolerances", Strategy::tolerances, 0),
            ours("auto", Strategy::automatic, audit_every)};
}

/// 1, 2, 3 .., then eight per decade.
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

bool selected(const Reproduction_size& size, std::initializer_list<const char*> topics) {
    return size.only.empty() || std::any_of(topics.begin(), topics.end(), [&](const char* t) {
               return std::find(size.only.begin(), size.only.end(), t) != size.only.end();
           });
}

std::uint64_t steps_of(const Reproduction_size& size, std::uint64_t quick) {
    return size.iterations > 0 ? size.iterations : size.quick ? quick : 1000;
}

/// At most every `every`-th step, but at least ten times.
std::uint64_t sampled(std::uint64_t steps, std::uint64_t every) {
    return std::max<std::uint64_t>(1, std::min(every, steps / 10));
}

void add_lloyd(const Reproduction_size& size, std::vector<Part_plan>& out) {
    const std::uint64_t steps = steps_of(size, 100);
    for (const char* density : {"one", "x2"}) {
        if (!selected(size, {"fig5"})) continue;
        Part_plan p;
        p.motion = {.dimension = 2, .vertices = size.quick ? 500U : 1000U, .density = density};
        p.benchmark = {.name = std::string("points-") + density,
                       .title = std::string("Lloyd, density ") + density,
                       .steps = steps,
                       .pictures = {0, steps}};
        out.push_back(p);
    }
    for (const char* density : {"one", "x2+y2", "x2", "sin2"}) {
        const bool x2 = std::string(density) == "x2";
        if (!selected(size, {"fig7"}) && !(x2 && selected(size, {"fig6", "fig11"}))) continue;
        Part_plan p;
        p.motion = {.dimension = 2, .vertices = size.quick ? 2000U : 10'000U, .density = density};
        p.benchmark = {.name = std::string("lloyd-") + density,
                       .title = std::string("Lloyd, density ") + density,
                       .steps = steps,
                       .contenders = contenders(1, sampled(steps, 10), 10)};
        p.benchmark.contenders.push_back(
            papers("relocate-flips", choices::relocate_flips, 0, Kind::copy, sampled(steps, 10)));
        p.benchmark.contenders.push_back(papers("paper", {}, 10));
        p.benchmark.contenders.push_back(papers("paper-safe-region", choices::safe_region, 10));
        p.benchmark.surveys = x2 ? spread(steps) : decades(steps, true);
        p.benchmark.distributions = decades(steps, false);
        p.benchmark.degeneracies = decades(steps, true);
        p.benchmark.stabilities = p.benchmark.operations = {1, steps + 1};
        out.push_back(p);
    }
}

struct Body {
    const char *name, *title, *surface;
    bool crossing;
    std::uint64_t vertices, quick;
};
/// A publicly available organ in place of the paper's heart: CGAL's liver.
constexpr Body bodies[] = {{"sphere", "sphere", "", false, 13'000, 1500},
                           {"man", "man", "man.off", true, 8000, 1000},
                           {"bunny", "bunny", "bunny00.off", false, 13'000, 1500},
                           {"liver", "liver, in place of the heart", "liver.inr.gz", false, 10'000, 1200}};

Part_plan body_part(const Reproduction_size& size, const Body& b) {
    Part_plan p;
    p.motion = {
        .dimension = 3, .vertices = size.quick ? b.quick : b.vertices, .surface = b.surface, .crossing = b.crossing};
    p.benchmark.steps = steps_of(size, 60);
    p.benchmark.quality_every = 10;
    p.benchmark.seed = size.seed;
    return p;
}

void add_bodies(const Reproduction_size& size, std::vector<Part_plan>& out) {
    for (const Body& b : bodies) {
        const std::string name = b.name;
        if (name != "sphere" && !size.surfaces) continue;
        const bool wanted =
            selected(size, {"fig8", "fig12"}) || (name == "sphere" && selected(size, {"fig10", "fig11"})) ||
            (name == "bunny" && selected(size, {"fig11"})) || (name == "man" && selected(size, {"fig9"}));
        if (!wanted) continue;
        Part_plan p = body_part(size, b);
        const std::uint64_t steps = p.benchmark.steps;
        p.benchmark.name = "nodt-" + name;
        p.benchmark.title = std::string("Natural ODT, ") + b.title;
        p.benchmark.contenders = contenders(sampled(steps, 4), sampled(steps, 50), 20);
        p.benchmark.surveys = spread(steps);
        p.benchmark.distributions = decades(steps, false);
        p.benchmark.degeneracies = p.benchmark.adversaries = decades(steps, true);
        p.benchmark.stabilities = p.benchmark.operations = {1, steps + 1};
        p.benchmark.attacks = size.quick ? 200 : 2000;
        p.benchmark.pictures = {0, std::min<std::uint64_t>(100, steps), steps};
        out.push_back(p);
    }
}

/// Motions that are not timed, for the quality of the mesh. Several of the sphere, which is cheap to sample: other
/// first meshes, other locks.
void add_qualities(const Reproduction_size& size, std::vector<Part_plan>& out) {
    for (const Body& b : bodies) {
        const std::string name = b.name;
        const bool sphere = name == "sphere";
        if (!sphere && (name != "bunny" || !size.surfaces)) continue;
        for (std::uint64_t draw = 0; selected(size, {"slivers"}) && draw < (sphere ? 5U : 1U); ++draw) {
            Part_plan p = body_part(size, b);
            p.benchmark.name = "graded-" + name + (draw > 0 ? "-" + std::to_string(draw + 1) : "");
            p.benchmark.title = std::string("Natural ODT, variable sizing, ") + b.title +
                                (draw > 0 ? ", first mesh " + std::to_string(draw + 1) : "");
            p.motion.graded = true;
            p.motion.draw = draw;
            if (!sphere)  // the depth of a vertex is cheaper to compute in a ball
                p.motion.vertices = std::min<std::uint64_t>(p.motion.vertices, 4000);
            out.push_back(p);
        }
        for (const int degrees : {15, 5, 10, 20, 25}) {
            if (!selected(size, {"locked"}) || (!sphere && degrees != 15)) continue;
            Part_plan p = body_part(size, b);
            p.benchmark.name = "locked-" + name + (degrees != 15 ? "-" + std::to_string(degrees) : "");
            p.benchmark.title = "Natural ODT with locks of " + std::to_string(degrees) + " degrees, " + b.title;
            p.motion.lock_degrees = degrees;
            out.push_back(p);
        }
    }
}

/// Uniform points of which some move by a twentieth of a spacing at a time: most of these leave their tolerance.
template <int d>
void add_movers(const Reproduction_size& size, std::vector<Part_plan>& out) {
    for (const int percent : {1, 10, 100}) {
        if (!selected(size, {"movers"})) continue;
        Part_plan p;
        p.motion = {.dimension = d, .vertices = size.quick ? 2000U : 10'000U, .movers = percent / 100.0, .pace = 0.05};
        p.benchmark.name = std::string(d == 2 ? "movers-plane-" : "movers-space-") + std::to_string(percent);
        p.benchmark.title = std::to_string(percent) + " % of random points move, " + (d == 2 ? "plane" : "space");
        p.benchmark.steps = std::min<std::uint64_t>(size.quick ? 5 : 20, steps_of(size, 5));
        p.benchmark.contenders = {
            {"rebuild", Kind::cgal_rebuild, {}, 1, 0},     {"relocate-cgal", Kind::cgal_relocate, {}, 1, 0},
            papers("relocate", choices::relocate, 0),      papers("relocate-in-place", choices::relocate_in_place, 0),
            papers("paper-printed", choices::printed, 10), papers("paper-in-place", choices::in_place, 0),
            ours("rebuild-own", Strategy::rebuild, 0),     ours("tolerances-each", Strategy::tolerances_each, 10),
            ours("auto", Strategy::automatic, 10)};
        out.push_back(p);
    }
}

}  // namespace

const std::vector<std::string>& reproduction_topics() {
    static const std::vector<std::string> topics{"fig5",  "fig6",  "fig7",    "fig8",   "fig9",  "fig10",
                                                 "fig11", "fig12", "slivers", "locked", "movers"};
    return topics;
}

std::vector<Part_plan> reproduction_parts(const Reproduction_size& size) {
    std::vector<Part_plan> out;
    add_lloyd(size, out);
    add_bodies(size, out);
    add_qualities(size, out);
    add_movers<2>(size, out);
    add_movers<3>(size, out);
    for (Part_plan& p : out) p.benchmark.seed = size.seed;
    return out;
}

}  // namespace annulus::inline v1
