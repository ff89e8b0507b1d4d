// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/compare.h>
#include <apps/cli/files.h>
#include <apps/cli/guided_box.h>
#include <apps/cli/guided_motion.h>
#include <apps/cli/print_comparison.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>
#include <apps/formats/input_error.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_json.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/summary.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

struct Compare_call {
    Common_arguments common;
    std::vector<std::string> strategies{"rebuild", "relocate", "auto"};
    bool chosen = false;  ///< --strategies
};

/// What follows a motion.
template <class Moving>
using Follower = std::conditional_t<Open_mesh<Moving>, Tracker<Moving>, Run_tracker<Moving>>;

/// Parses "tolerances" or "paper:floating": a strategy, and its kind of tolerance if that differs from the command's.
Tracking_arguments variant(Tracking_arguments t, const std::string& name) {
    const std::size_t colon = name.find(':');
    t.strategy = name.substr(0, colon);
    if (colon != std::string::npos) t.tolerance = name.substr(colon + 1);
    return t;
}

Options options_of(const Tracking_arguments& tracking, const Common_arguments& common, bool boxed) {
    return boxed ? boxed_options_of(tracking, common) : options_of(tracking, common);
}

template <int d>
void follow(Tracker<Moving_mesh<d>>& tracker, const Time_step<d>& s) {
    if (s.leave.empty() && s.arrive.empty()) tracker.step(s.x, s.seconds, s.way.mean, s.way.max);
    else (void)tracker.follow(s.leave, s.x, s.arrive, s.seconds, s.way.mean, s.way.max);
}
template <int d>
void follow(Run_tracker<Boxed_mesh<d>>& tracker, const Boxed_step<d>& s) {
    tracker.step([&](Boxed_mesh<d>& dt) { return dt.follow(s.id, s.x, *s.box); }, s.seconds, s.way);
}

template <class Moving>
void compare_ends(const std::deque<Follower<Moving>>& trackers, Comparison_record& out) {
    const auto cells = canonical_cells(trackers[0].triangulation());
    const bool degenerate = trackers[0].triangulation().audit().degenerate_facets > 0;
    for (std::size_t k = 0; k < trackers.size(); ++k) {
        const Audit_result audit = trackers[k].triangulation().audit();
        const std::string& name = trackers[k].record().strategy;
        if (!audit.delaunay()) out.disagreements.push_back(name + " is not Delaunay at the end: " + audit.first_fault);
        // If points are cocircular or cospherical, the triangulation is not unique, and only the audits count.
        if (!degenerate && canonical_cells(trackers[k].triangulation()) != cells)
            out.disagreements.push_back(name + " ends with other cells than " + trackers[0].record().strategy);
    }
    out.agree = out.disagreements.empty();
}

template <class Moving>
void write_comparison(const Common_arguments& arguments, const Guided_motion<Moving>& motion,
                      const std::deque<Follower<Moving>>& trackers, const Comparison_record& comparison,
                      std::optional<Picture> before) {
    Report report;
    const auto& shown = trackers.back();
    std::string names;
    for (const Run_record& run : comparison.runs) names += (names.empty() ? "" : ", ") + run.strategy;
    report.title = title_of(shown.record(), motion.step_name(),
                            (comparison.runs.size() == 1 ? "strategy " : "strategies ") + names);
    report.run = shown.record();
    report.before = std::move(before);
    if (const std::uint64_t n = shown.record().iterations; n > 0)
        report.after = motion.picture(shown.triangulation(),
                                      motion.replayed() ? "The last frame" : "After " + grouped(n, "iteration"));
    report.annulus_widths = shown.widths();
    report.comparison = comparison;
    Result_files out(arguments, is_result, comparison.interrupted);
    out.write("compare.json", write_json(compare_json(comparison)));
    for (const Run_record& run : comparison.runs) {
        std::string name = run.strategy;
        std::replace(name.begin(), name.end(), ':', '-');
        out.write("iterations-" + name + ".csv", write_csv(iterations_table(run)));
    }
    out.write("report.html", report_html(report));
    out.commit();
}

template <class Moving>
int compare(const Compare_call& a, const Invocation& invocation, Guided_motion<Moving>& motion,
            std::uint64_t iterations, const Tracking_arguments& tracking, const Common_arguments& common,
            Clock::time_point begin, const std::function<Input_record()>& input) {
    const bool files = !a.common.output.empty();
    std::deque<Follower<Moving>> trackers;
    for (const std::string& name : a.strategies) {
        const Options options = options_of(variant(tracking, name), common, !Open_mesh<Moving>);
        trackers.emplace_back(
            name, [&] { return motion.start(options); }, options, motion.spacing(), iterations, tracking.audit,
            files && name == a.strategies.back());
        if (motion.replayed()) trackers.back().note_replay();
    }
    std::optional<Picture> before;
    if (files) before = motion.picture(trackers[0].triangulation(), motion.replayed() ? "The first frame" : "Before");

    // Blocks of consecutive time steps are recorded. Each strategy follows a whole block, so that the other strategies
    // and the motion do not replace its data in the caches between two steps.
    constexpr std::size_t recording_bytes = std::size_t{256} << 20;
    std::vector<typename Guided_motion<Moving>::Step> block;
    std::optional<Interruption_guard> guard;
    if (files) guard.emplace();
    bool stopped = false, ended = motion.at_end();
    if (ended)
        for (auto& t : trackers) t.ends_after(0);
    const std::uint64_t strategies = trackers.size();
    std::optional<Progress> progress(std::in_place, "compare",
                                     iterations == unknown_iterations ? 0 : iterations * strategies, a.common.quiet);
    for (std::uint64_t done_steps = 0; done_steps < iterations && !stopped && !ended;) {
        std::size_t now = 0;
        for (std::size_t bytes = 0; !stopped && !ended && bytes < recording_bytes && done_steps + now < iterations;) {
            if (now == block.size()) block.emplace_back();
            if (!motion.next(block[now])) break;
            bytes += std::max<std::size_t>(block[now++].bytes(), 1);
            ended = motion.at_end();
            stopped = Interruption_guard::interrupted();
        }
        for (std::size_t t = 0; t < trackers.size(); ++t) {
            if (ended) trackers[t].ends_after(done_steps + now);
            for (std::size_t k = 0; k < now && !stopped; ++k) {
                follow(trackers[t], block[k]);
                progress->show(done_steps * strategies + t * now + k + 1, a.strategies[t]);
                stopped = Interruption_guard::interrupted();
            }
        }
        done_steps += now;
    }
    progress.reset();
    Comparison_record comparison;
    for (auto& t : trackers) {
        t.finish(command_line(invocation.words), common.seed, since(begin));
        t.input(input());
        comparison.runs.push_back(t.record());
        comparison.interrupted = comparison.interrupted || t.record().interrupted;
    }
    if (!comparison.interrupted) compare_ends<Moving>(trackers, comparison);
    if (files) write_comparison(a.common, motion, trackers, comparison, std::move(before));
    if (comparison.interrupted) {
        say_interrupted(a.common, comparison.runs.front().iterations,
                        iterations == unknown_iterations ? std::nullopt : std::optional(iterations));
        return done;
    }
    if (!a.common.quiet) print_comparison(comparison);
    const bool audits = std::all_of(comparison.runs.begin(), comparison.runs.end(),
                                    [](const Run_record& r) { return r.audit.failed == 0; });
    return comparison.agree && audits ? done : audit_failed;
}

int run(Compare_call a, const Invocation& invocation, Make_nodt make_nodt) {
    // The inner command is parsed by the same rules as a command of its own.
    CLI::App inner("the motion to compare on", "annulus compare --");
    Common_arguments common;
    Tracking_arguments tracking;
    Lloyd_arguments lloyd;
    Nodt_arguments nodt;
    Replay_arguments replay;
    replay.boxed = true;
    std::string box;  // of lloyd
    auto* lloyd_command = inner.add_subcommand("lloyd", "Lloyd iterations in 2D");
    auto* nodt_command = inner.add_subcommand("nodt", "Natural-ODT optimisation of a tetrahedral mesh");
    auto* replay_command = inner.add_subcommand("replay", "A recorded motion");
    add_lloyd(*lloyd_command, lloyd);
    add_nodt(*nodt_command, nodt);
    add_replay(*replay_command, replay);
    add_lloyd_box(*lloyd_command, box);
    add_box(*replay_command, replay.box);
    for (auto* command : {lloyd_command, nodt_command, replay_command}) {
        add_tracking(*command, tracking);
        add_common(*command, common, run_files);
        refuse_empty_values(*command);
    }
    inner.require_subcommand(1);
    std::vector<std::string> reversed(invocation.inner.rbegin(), invocation.inner.rend());
    try {
        inner.parse(reversed);
    } catch (const CLI::Success& e) {  // --help
        return inner.exit(e);
    }
    if (!common.output.empty() || common.force)
        throw CLI::ValidationError(common.force ? "--force" : "--output",
                                   "belongs before --: compare writes one report for all strategies");

    const auto begin = Clock::now();
    const CLI::App& chosen = *inner.get_subcommands().front();
    if (chosen.count("--seed") == 0) common.seed = a.common.seed;
    if (chosen.count("--threads") == 0) common.threads = a.common.threads;
    common.quiet = common.quiet || a.common.quiet;
    const auto require_strategies = [&](bool boxed) {
        if (boxed && !a.chosen) a.strategies = {"rebuild", "signs", "auto"};
        for (const std::string& name : a.strategies) (void)options_of(variant(tracking, name), common, boxed);
    };
    // Reports wrong usage before anything is read; whether there is a box, a file says.
    if (replay.open && !replay.box.empty()) throw Error(Error_code::usage, "--open and --box exclude each other");
    const bool boxed = !box.empty() || !replay.box.empty();
    const bool names_signs = std::find(a.strategies.begin(), a.strategies.end(), "signs") != a.strategies.end();
    require_strategies(boxed || (&chosen == replay_command && names_signs && !replay.open));
    if (boxed) (void)parse_box(box.empty() ? replay.box : box);
    if (!box.empty()) require_boxed(lloyd);
    if (!a.common.output.empty()) require_writable(a.common);
    if (!box.empty()) {
        const auto follow_in = [&]<int d>(std::integral_constant<int, d>) {
            Guided_boxed_lloyd<d> motion(lloyd, box, common);
            return compare(a, invocation, motion, lloyd.iterations, tracking, common, begin,
                           [&] { return motion.input(); });
        };
        return dimension_of_box(parse_box(box)) == 2 ? follow_in(std::integral_constant<int, 2>())
                                                     : follow_in(std::integral_constant<int, 3>());
    }
    if (&chosen == lloyd_command) {
        Guided_lloyd motion(lloyd, common);
        return compare(a, invocation, motion, lloyd.iterations, tracking, common, begin,
                       [&] { return motion.input(); });
    }
    if (&chosen == nodt_command) {
        const auto motion = make_nodt(nodt, common);
        return compare(a, invocation, *motion, nodt.iterations, tracking, common, begin, [] { return Input_record(); });
    }
    Opened_motion motion = open_motion(replay);
    require_strategies(motion.periodic);
    const auto follow_in = [&]<class Guided>(std::in_place_type_t<Guided>) {
        Replayed_frames<Guided::d> frames(motion, replay);
        Guided guided(frames);
        const int status = compare<typename Guided::Moving>(a, invocation, guided, unknown_iterations, tracking, common,
                                                            begin, [&] { return frames.input(motion); });
        common.say_notes(motion.reader.notes());
        return status;
    };
    if (motion.periodic)
        return motion.dimension == 2 ? follow_in(std::in_place_type<Guided_boxed_replay<2>>)
                                     : follow_in(std::in_place_type<Guided_boxed_replay<3>>);
    return motion.dimension == 2 ? follow_in(std::in_place_type<Guided_replay<Moving_mesh_2>>)
                                 : follow_in(std::in_place_type<Guided_replay<Moving_mesh_3>>);
}

}  // namespace

Run add_compare(CLI::App& app, const Invocation& invocation, Make_nodt make_nodt) {
    auto* sub = app.add_subcommand(
        "compare",
        "The same motion under several strategies: annulus compare --strategies a,b -- lloyd|nodt|replay ...");
    const auto a = std::make_shared<Compare_call>();
    sub->add_option("--strategies", a->strategies,
                    "Strategies, separated by commas; NAME:KIND changes the tolerance of one (paper:floating). In a\n"
                    "periodic box those of replay there; default rebuild,signs,auto")
        ->delimiter(',')
        ->capture_default_str();
    add_common(*sub, a->common, "compare.json, report.html and a table for each strategy");
    return [a, sub, &invocation, make_nodt] {
        a->chosen = sub->count("--strategies") > 0;
        if (invocation.inner.empty())
            throw CLI::ValidationError("compare", "say what to compare on: annulus compare ... -- lloyd --points 1000");
        for (std::size_t i = 0; i < a->strategies.size(); ++i)
            if (std::find(a->strategies.begin(), a->strategies.begin() + static_cast<std::ptrdiff_t>(i),
                          a->strategies[i]) != a->strategies.begin() + static_cast<std::ptrdiff_t>(i))
                throw CLI::ValidationError("--strategies", "'" + a->strategies[i] + "' is named twice");
        return run(*a, invocation, make_nodt);
    };
}

}  // namespace annulus::inline v1::cli
