// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/commands.h>
#include <annulus/cli/files.h>
#include <annulus/cli/lloyd_scene.h>
#include <annulus/cli/progress.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/stopwatch.h>
#include <annulus/cli/tracker.h>
#include <annulus/io/input_error.h>
#include <annulus/io/summary.h>
#include <annulus/io/write_csv.h>
#include <annulus/io/write_json.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <memory>

namespace annulus::cli {

namespace {

struct Compare_call {
    Common_arguments common;
    std::vector<std::string> strategies{"rebuild", "relocate", "filter"};
};

/// Positions of some consecutive timestamps, recorded so that each strategy follows them without the others (and
/// the motion) using up its caches between two steps.
struct Recording {
    std::vector<Coordinates<2>> positions;
    std::vector<Lloyd_step> steps;
    std::vector<double> seconds;
};

/// "filter", "filter:floating", "filter:unequal": a strategy, then what differs from the rest of the command.
Tracking_arguments variant(Tracking_arguments t, const std::string& name) {
    std::size_t from = name.find(':');
    t.strategy = name.substr(0, from);
    while (from != std::string::npos) {
        const std::size_t to = name.find(':', from + 1);
        const std::string word = name.substr(from + 1, to == std::string::npos ? to : to - from - 1);
        (second_look_named(word) ? t.second_look : t.tolerance) = word;
        from = to;
    }
    return t;
}

void compare_ends(const std::deque<Tracker_2>& trackers, Comparison_record& out) {
    const auto cells = trackers[0].canonical_cells();
    const bool degenerate = trackers[0].triangulation().audit().degenerate_facets > 0;
    for (std::size_t k = 0; k < trackers.size(); ++k) {
        const Audit_result audit = trackers[k].triangulation().audit();
        const std::string& name = trackers[k].record().strategy;
        if (!audit.delaunay()) out.disagreements.push_back(name + " is not Delaunay at the end: " + audit.first_fault);
        // Where points are cocircular the triangulation is not unique, and the audits decide.
        if (!degenerate && trackers[k].canonical_cells() != cells)
            out.disagreements.push_back(name + " ends with other cells than " + trackers[0].record().strategy);
    }
    out.agree = out.disagreements.empty();
}

void write_comparison(const std::string& directory, const std::deque<Tracker_2>& trackers,
                      const Comparison_record& comparison, std::optional<Picture> before) {
    Report report;
    const Tracker_2& shown = trackers.back();
    std::string names;
    for (const Run_record& run : comparison.runs) names += (names.empty() ? "" : ", ") + run.strategy;
    report.title = title_of(shown.record(), names);
    report.run = shown.record();
    report.before = std::move(before);
    report.after = picture_of(shown.triangulation(), "After " + counted(shown.record().iterations, "iteration"));
    report.annulus_widths = shown.widths();
    report.comparison = comparison;
    Result_files out(directory);
    out.write("compare.json", write_json(compare_json(comparison)));
    for (const Run_record& run : comparison.runs) {
        std::string name = run.strategy;
        std::replace(name.begin(), name.end(), ':', '-');
        out.write("iterations-" + name + ".csv", write_csv(iterations_table(run)));
    }
    out.write("report.html", report_html(report));
    out.commit();
}

void print(const Comparison_record& c) {
    std::printf("%-24s %14s %12s %12s %10s\n", "strategy", "triangulation", "ns/vertex", "within tol.", "audits");
    for (const Run_record& r : c.runs) {
        const auto asked = static_cast<double>(r.moves.asked > 0 ? r.moves.asked : 1);
        std::printf("%-24s %12.3f s %12.1f %10.2f %% %6llu/%llu\n", r.strategy.c_str(), r.seconds.triangulation,
                    r.seconds.triangulation / asked * 1e9,
                    100.0 * static_cast<double>(r.moves.within_tolerance) / asked,
                    static_cast<unsigned long long>(r.audit.checked - r.audit.failed),
                    static_cast<unsigned long long>(r.audit.checked));
    }
    for (const Run_record& a : c.runs)
        for (const Run_record& b : c.runs)
            if (&a != &b && b.seconds.triangulation > 0 && a.seconds.triangulation >= b.seconds.triangulation)
                std::printf("%s/%s %.2f\n", a.strategy.c_str(), b.strategy.c_str(),
                            a.seconds.triangulation / b.seconds.triangulation);
    if (c.agree) std::printf("all strategies agree\n");
    for (const std::string& line : c.disagreements) std::printf("DISAGREE: %s\n", line.c_str());
}

int run(const Compare_call& a, const Invocation& invocation) {
    // The inner command is parsed by the same rules as when it stands alone.
    CLI::App inner("the motion to compare on", "annulus compare --");
    auto* sub = inner.add_subcommand("lloyd", "Lloyd iterations in the plane");
    Common_arguments common;
    Tracking_arguments tracking;
    Lloyd_arguments lloyd_arguments;
    add_lloyd(*sub, lloyd_arguments);
    add_tracking(*sub, tracking);
    add_common(*sub, common, run_files);
    inner.require_subcommand(1);
    std::vector<std::string> reversed(invocation.inner.rbegin(), invocation.inner.rend());
    try {
        inner.parse(reversed);
    } catch (const CLI::Success& e) {  // --help
        return inner.exit(e);
    }
    if (!common.output.empty())
        throw CLI::ValidationError("--output", "belongs before --: compare writes one report for all strategies");

    const auto begin = Clock::now();
    if (sub->count("--seed") == 0) common.seed = a.common.seed;
    if (sub->count("--threads") == 0) common.threads = a.common.threads;
    const Lloyd_scene scene = make_scene(lloyd_arguments, common.seed);
    if (scene.merged > 0 && !a.common.quiet)
        std::fprintf(stderr, "annulus: %s: merged %s\n", lloyd_arguments.input.c_str(),
                     counted(scene.merged, "duplicate point").c_str());
    const std::uint64_t iterations = lloyd_arguments.iterations;
    const std::size_t n = scene.points.size();
    if (!a.common.output.empty()) require_writable(a.common.output);
    std::deque<Tracker_2> trackers;
    for (const std::string& name : a.strategies) {
        const Options options = options_of(variant(tracking, name), common);
        const bool measure = name == a.strategies.back() && !a.common.output.empty();
        trackers.emplace_back(name, scene.points, options, scene.spacing(), iterations, tracking.audit, measure);
    }
    std::optional<Picture> before;
    if (!a.common.output.empty()) before = picture_of(trackers[0].triangulation(), "Before");

    // The motion needs a triangulation of its own, kept by certified tolerances, timed for nobody.
    Moving_delaunay_2 guide(scene.points);
    const Lloyd_2 lloyd(scene.domain, scene.density, common.threads);
    Neighbours_2 neighbours;
    bool cells_changed = true;
    constexpr std::size_t recording_bytes = std::size_t{256} << 20;
    const std::size_t block = std::max<std::size_t>(1, recording_bytes / (n * sizeof(Coordinates<2>)));
    Recording rec;
    Progress progress("compare", iterations * trackers.size(), a.common.quiet);
    for (std::uint64_t done_steps = 0; done_steps < iterations;) {
        const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(block, iterations - done_steps));
        rec.positions.resize(now * n);
        rec.steps.resize(now);
        rec.seconds.resize(now);
        for (std::size_t k = 0; k < now; ++k) {
            const auto start = Clock::now();
            const std::span<Coordinates<2>> target(rec.positions.data() + k * n, n);
            if (cells_changed) guide.embedding().neighbours(neighbours);
            rec.steps[k] = lloyd.step(neighbours, guide.positions(), target);
            rec.seconds[k] = since(start);
            const Move_report moved = guide.move_all(std::span<const Coordinates<2>>(target));
            cells_changed = moved.flips + moved.moves.reinserted + moved.moves.rebuilt + moved.moves.flipped > 0;
        }
        for (std::size_t t = 0; t < trackers.size(); ++t)
            for (std::size_t k = 0; k < now; ++k) {
                const std::span<const Coordinates<2>> x(rec.positions.data() + k * n, n);
                trackers[t].step(x, rec.seconds[k], rec.steps[k].mean_displacement, rec.steps[k].max_displacement);
                progress.show(done_steps * trackers.size() + t * now + k + 1, a.strategies[t]);
            }
        done_steps += now;
    }
    Comparison_record comparison;
    for (Tracker_2& t : trackers) {
        t.finish(command_line(invocation.words), common.seed, since(begin));
        comparison.runs.push_back(t.record());
    }
    compare_ends(trackers, comparison);
    if (!a.common.output.empty()) write_comparison(a.common.output, trackers, comparison, std::move(before));
    if (!a.common.quiet) print(comparison);
    const bool audits = std::all_of(comparison.runs.begin(), comparison.runs.end(),
                                    [](const Run_record& r) { return r.audit.failed == 0; });
    return comparison.agree && audits ? done : audit_failed;
}

}  // namespace

Run add_compare_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand(
        "compare", "The same motion under several strategies: annulus compare --strategies a,b -- lloyd ...");
    const auto a = std::make_shared<Compare_call>();
    sub->add_option("--strategies", a->strategies,
                    "Strategies, separated by commas; NAME:KIND changes the tolerance (filter:floating) or the second "
                    "look (filter:unequal) of one")
        ->delimiter(',')
        ->capture_default_str();
    add_common(*sub, a->common, "compare.json, report.html and a table for each strategy");
    return [a, &invocation] {
        if (invocation.inner.empty())
            throw CLI::ValidationError("compare", "say what to compare on: annulus compare ... -- lloyd --points 1000");
        for (std::size_t i = 0; i < a->strategies.size(); ++i)
            if (std::find(a->strategies.begin(), a->strategies.begin() + static_cast<std::ptrdiff_t>(i),
                          a->strategies[i]) != a->strategies.begin() + static_cast<std::ptrdiff_t>(i))
                throw CLI::ValidationError("--strategies", "'" + a->strategies[i] + "' is named twice");
        return run(*a, invocation);
    };
}

}  // namespace annulus::cli
