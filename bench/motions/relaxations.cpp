// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies, CGAL's rebuild and the motion itself on Lloyd iterations and natural ODT, as the tool computes them.
// Blocks of time steps are computed first, and each strategy follows a block alone, so that neither the other
// strategies nor the motion displace its caches, and yet all are timed within the same seconds.
#include "cgal_rebuild.h"
#include "relaxation.h"
#include "result_line.h"

#include <apps/cli/arguments.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

using namespace annulus;
using nlohmann::ordered_json;

/// Time steps per block. At the first of a block caches are cold: with 20, Lloyd's cheapest steps cost half as much
/// again.
constexpr std::uint64_t block_size = 100;

struct Choice {
    std::vector<std::string> strategies{"cgal@20", "rebuild", "auto"};
    std::uint64_t seed = 1;
    std::string json;
};

/// NAME[:KIND][@K]: KIND is a kind of tolerance; with K it follows only each K-th time step, and its seconds count K
/// times.
struct Word {
    std::string name;  // without @K
    bool cgal = false;
    Options options;
    std::uint64_t every = 1;

    explicit Word(const std::string& word) {
        const std::size_t at = word.find('@');
        name = word.substr(0, at);
        if (at != std::string::npos) every = std::stoull(word.substr(at + 1));
        if (every == 0) throw std::invalid_argument(word + ": each 0th time step");
        cgal = name == "cgal";
        if (cgal) return;
        const std::size_t colon = name.find(':');
        cli::Tracking_arguments tracking;
        tracking.strategy = name.substr(0, colon);
        if (colon != std::string::npos) tracking.tolerance = name.substr(colon + 1);
        options = cli::options_of(tracking, {});
    }
};

template <class Moving>
struct Follower {
    Word word;
    std::unique_ptr<Moving> dt;
    double seconds = 0.0;  // of the time steps that were followed
    std::uint64_t followed = 0;
    Move_result report;
};

/// Each cell's vertices in order, the cells in order: equal for equal triangulations.
template <class Moving>
auto canonical(const Moving& dt) {
    auto cells = dt.audit_input().cells;
    for (auto& c : cells) std::sort(c.begin(), c.end());
    std::sort(cells.begin(), cells.end());
    return cells;
}

template <class Motion>
int run(Motion& motion, std::uint64_t iterations, const Choice& choice, ordered_json out) {
    constexpr int d = Motion::dimension;
    using Moving = typename Motion::Moving;
    const bench::Stopwatch watch;
    std::vector<Follower<Moving>> followers;
    for (const std::string& word : choice.strategies) {
        followers.push_back({Word(word), nullptr, 0.0, 0, {}});
        auto& f = followers.back();
        if (iterations % f.word.every != 0)
            throw std::invalid_argument(word + ": the last of " + std::to_string(iterations) + " would be left out");
        if (!f.word.cgal)
            f.dt = std::make_unique<Moving>(std::span<const Coordinates<d>>(motion.points()), f.word.options);
    }
    double motion_seconds = 0.0;
    double displacement = 0.0;
    std::vector<bench::Points<d>> block;
    for (std::uint64_t first = 0; first < iterations; first += block.size()) {
        block.assign(static_cast<std::size_t>(std::min<std::uint64_t>(block_size, iterations - first)),
                     bench::Points<d>(motion.points().size()));
        for (auto& x : block) {
            const auto [taken, way] = motion.next(x);
            motion_seconds += taken;
            displacement += way;
        }
        for (std::size_t k = 0; k < followers.size(); ++k) {
            auto& f = followers[(k + first / block_size) % followers.size()];
            for (std::size_t i = 0; i < block.size(); ++i) {
                if ((first + i + 1) % f.word.every != 0) continue;
                ++f.followed;
                if (f.word.cgal) {
                    f.seconds += bench::cgal_rebuild<d>(block[i], watch);
                    continue;
                }
                const double begin = watch.seconds();
                const Move_result report = f.dt->move_all(std::span<const Coordinates<d>>(block[i]));
                f.seconds += watch.seconds() - begin;
                f.report += report;
            }
        }
    }
    const double steps = static_cast<double>(iterations);
    const double n = static_cast<double>(motion.points().size());
    out.update({{"dimension", d},
                {"points", motion.points().size()},
                {"iterations", iterations},
                {"displacement", displacement / steps},
                {"motion", motion_seconds}});
    std::printf("%zu points, %.3g spacings a step, motion %.2f s", motion.points().size(), displacement / steps,
                motion_seconds);
    int failed = 0;
    const Follower<Moving>* reference = nullptr;
    decltype(canonical(*followers[0].dt)) cells;
    bool agree = true;
    for (const auto& f : followers) {
        const double seconds = f.seconds * static_cast<double>(f.word.every);
        ordered_json one{{"seconds", seconds}, {"ns", 1e9 * seconds / steps / n}, {"followed", f.followed}};
        std::printf(" | %s %.3f s", f.word.name.c_str(), seconds);
        if (!f.word.cgal) {
            const auto asked = static_cast<double>(std::max<std::uint64_t>(f.report.moves.asked, 1));
            const Audit_result audit = f.dt->audit();
            if (!audit.delaunay()) ++failed;
            one["rebuilt"] = static_cast<double>(f.report.moves.rebuilt) / asked;
            one["within_tolerance"] = static_cast<double>(f.report.moves.within_tolerance) / asked;
            one["audit"] = audit.delaunay();
            // Where points are cospherical the triangulation is not unique, and the audits decide.
            if (!reference) {
                reference = &f;
                cells = canonical(*f.dt);
            } else if (audit.degenerate_facets == 0 && canonical(*f.dt) != cells) {
                agree = false;
            }
            if (!audit.delaunay()) std::printf(" AUDIT FAILED");
        }
        out[f.word.name] = one;
    }
    out["agree"] = agree;
    std::printf("%s\n", agree ? "" : " | THEY DISAGREE");
    bench::append(choice.json, out);
    return failed == 0 && agree ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Choice choice;
    cli::Lloyd_arguments lloyd;
    cli::Nodt_arguments nodt;
    CLI::App app{"Strategies, CGAL's rebuild and the motion itself on the tool's motions: seconds in all."};
    app.add_option("--strategies", choice.strategies,
                   "NAME[:KIND][@K] or cgal[@K]; with @K each Kth time step only, which counts K times")
        ->delimiter(',');
    app.add_option("--seed", choice.seed);
    app.add_option("--json", choice.json, "file that a line is appended to");
    auto* plane = app.add_subcommand("lloyd", "with the options of `annulus lloyd` that say which");
    cli::add_lloyd(*plane, lloyd);
    auto* space = app.add_subcommand("nodt", "with the options of `annulus nodt` that say which");
    cli::add_nodt(*space, nodt);
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    try {
        if (plane->parsed()) {
            bench::Lloyd motion(cli::make_scene(lloyd, choice.seed));
            return run(motion, lloyd.iterations, choice, {{"scene", lloyd.density}});
        }
        const cli::Nodt_scene scene = cli::make_scene(nodt, choice.seed);
        bench::Nodt motion(scene, nodt);
        return run(motion, nodt.iterations, choice,
                   {{"scene", nodt.sphere         ? "sphere"
                              : nodt.mesh.empty() ? nodt.surface
                                                  : nodt.mesh}});
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-relaxations: %s\n", e.what());
        return 3;
    }
}
