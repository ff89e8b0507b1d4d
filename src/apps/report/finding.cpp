// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/finding.h>

#include <apps/report/axis_ticks.h>
#include <apps/report/box_change.h>
#include <apps/report/page.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace annulus::inline v1 {

namespace {

std::string count_of(std::uint64_t n, const char* one, const char* many) {
    return grouped(n) + " " + (n == 1 ? one : many);
}

/// "83.2 %"; a share below 1 is not shown as 100 %.
std::string percent(std::uint64_t part, std::uint64_t all) {
    const double share = 100 * static_cast<double>(part) / static_cast<double>(all);
    return (part != all && share >= 99.95 ? "more than 99.9" : readable(share)) + " %";
}

std::string from_to(double before, double after) {
    return readable(before) == readable(after)
               ? "stayed at " + readable(after)
               : (after > before ? "rose from " : "fell from ") + readable(before) + " to " + readable(after);
}

std::string from_to(std::uint64_t before, std::uint64_t after) {
    return before == after ? "stayed at " + grouped(after)
                           : (after > before ? "rose from " : "fell from ") + grouped(before) + " to " + grouped(after);
}

/// A sentence on the tetrahedra of the domain.
std::string on_mesh(const Mesh_step& before, const Mesh_step& after) {
    return "The least dihedral angle of the mesh " + from_to(before.dihedral_min, after.dihedral_min) +
           " degrees, and the number of slivers " + from_to(before.slivers, after.slivers) + ", of " +
           count_of(after.cells, "tetrahedron", "tetrahedra") + " at the end.";
}

/// The same where a finish followed the iterations, if there were any: they may lower the least angle, it raises it.
std::string on_finished_mesh(const Mesh_step& before, const Run_record& run) {
    const auto over_time = [&](auto value) {
        std::string text = value(before) + " at the start, ";
        const std::size_t iterations = run.steps.size() - 1;
        if (iterations > 0 && run.steps[iterations - 1].mesh)
            text += value(*run.steps[iterations - 1].mesh) + " after " + grouped(iterations, "iteration") + ", ";
        return text + value(*run.steps.back().mesh) + " after the finish";
    };
    bool first = true;
    const std::string angles = over_time(
        [&](const Mesh_step& m) { return readable(m.dihedral_min) + (std::exchange(first, false) ? " degrees" : ""); });
    return "The least dihedral angle of the mesh is " + angles + ". The number of slivers is " +
           over_time([](const Mesh_step& m) { return grouped(m.slivers); }) + ", of " +
           count_of(run.steps.back().mesh->cells, "tetrahedron", "tetrahedra") + " at the end.";
}

/// A sentence on the Voronoi neighbours of the inner vertices, of which there are some; `periodic`: all are inner.
std::string on_neighbours(const Plane_step& before, const Plane_step& after, bool periodic) {
    const std::string inner = periodic ? " " : " inner ";
    static constexpr std::array<const char*, 5> names{"four or fewer", "five", "six", "seven", "eight or more"};
    const auto& n = after.neighbours;
    const auto same = static_cast<std::size_t>(std::find(n.begin(), n.end(), after.inner) - n.begin());
    const std::size_t kind = same < n.size() ? same : 2;
    const std::string start = before.inner > 0 ? percent(before.neighbours[kind], before.inner) + " at the start" : "";
    if (kind == same) {
        const std::string all =
            after.inner == 1 ? "The" + inner + "vertex has " : "All " + grouped(after.inner) + inner + "vertices have ";
        return all + names[kind] + " neighbours at the end" + (start.empty() ? "" : " (" + start + ")") + ". ";
    }
    std::string text = grouped(n[2]) + " of the " + grouped(after.inner) + inner + "vertices " +
                       (n[2] == 1 ? "has" : "have") + " six neighbours at the end (" + percent(n[2], after.inner) +
                       (start.empty() ? "" : "; " + start) + "), " + grouped(n[1]) + " five, " + grouped(n[3]) +
                       " seven";
    if (n[0] > 0) text += ", " + grouped(n[0]) + " four or fewer";
    if (n[4] > 0) text += ", " + grouped(n[4]) + " eight or more";
    return text + ". ";
}

/// Sentences on the Voronoi cells and triangles of a 2D triangulation.
std::string on_plane(const Plane_step& before, const Plane_step& after, bool periodic) {
    std::string text;
    if (after.inner > 0) text = on_neighbours(before, after, periodic);
    if (after.angle_mean > 0)
        text += "The least angle of a triangle " +
                (before.angle_mean > 0 ? from_to(before.angle_mean, after.angle_mean)
                                       : "is " + readable(after.angle_mean)) +
                " degrees on average (60 if all are equilateral)";
    if (before.energy && after.energy && *before.energy > 0) {
        const double share = *after.energy / *before.energy;
        text += (after.angle_mean > 0 ? ", and the energy is " : "The energy is ") + readable(100 * share) +
                " % of that at the start";
    }
    return after.angle_mean > 0 || after.energy ? text + "." : text;
}

/// A sentence on the volumes of Voronoi cells.
std::string on_volumes(double before, double after) {
    return "The volumes of the Voronoi cells differ from their mean by " + readable(100 * after) +
           " % of it at the end (standard deviation), by " + readable(100 * before) + " % at the start.";
}

/// A sentence on the steps, and what they took.
std::string on_steps(const Run_record& run) {
    double sum = 0, most = 0;
    std::uint64_t flips = 0, built = 0;
    for (const Iteration_record& step : run.steps) {
        sum += step.displacement_mean;
        most = std::max(most, step.displacement_max);
        flips += step.flips;
        built += step.moves.rebuilt > 0 ? 1 : 0;
    }
    const auto steps = static_cast<double>(run.steps.size());
    const std::string word = step_word(run);
    // Of nodt --finish the last step is no iteration.
    const std::string one = run.finished ? "step" : word;
    const std::string each = run.steps.size() == 1 ? "" : (one == "iteration" ? " an " : " a ") + one;
    const auto counted_steps = [&](std::uint64_t n, bool with_last) {
        if (!run.finished || !with_last) return count_of(n, word.c_str(), (word + "s").c_str());
        return n == 1 ? "the finish" : count_of(n - 1, word.c_str(), (word + "s").c_str()) + " and the finish";
    };
    const std::string when = run.replayed
                                 ? "In the " + (run.steps.size() == 1 ? word : counted_steps(run.steps.size(), true)) +
                                       " after the first, points "
                                 : "In " + counted_steps(run.steps.size(), true) + " points ";
    const std::string relative = box_changes(run) ? " relative to the box" : "";
    std::string text =
        when + (only_box_moves(run)
                    ? "did not move" + relative + (most > 0 ? ", but for rounding." : ".")
                    : "moved by " + readable(sum / steps) + " mean spacings" + each + " on average, and by " +
                          readable(most) + " at most" + (relative.empty() ? "" : "," + relative) + ".");
    if (run.moves.asked == 0) return text;
    if (run.moves.rebuilt == run.moves.asked)
        return text + " The triangulation was rebuilt in " +
               (run.steps.size() > 1 ? "every " + one
                : run.finished       ? "the finish"
                                     : "this " + word) +
               ".";
    const Tested_moves tested = tested_moves(run);
    // What holds for less than half of the steps does not stand for the run.
    if (2 * tested.steps >= run.steps.size() && 10 * tested.within_tolerance >= tested.asked)
        text += " " + percent(tested.within_tolerance, tested.asked) + " of the moves" +
                (tested.steps == run.steps.size()
                     ? ""
                     : " in the " + grouped(tested.steps) + " of " + grouped(run.steps.size()) + " " +
                           (run.finished ? "steps, the finish included," : word + "s") + " that tested tolerances") +
                " stayed within their tolerance: nothing had to be computed for them.";
    if (flips > 0) text += " " + count_of(flips, "flip", "flips") + " kept the triangulation Delaunay.";
    if (built > 0)
        text += " The triangulation was rebuilt in " + counted_steps(built, run.steps.back().moves.rebuilt > 0) + ".";
    return text;
}

/// What is known of a run without steps: the start. Nothing where nothing was measured.
std::vector<std::string> at_start(const Run_record& run) {
    std::string text;
    if (run.mesh_before)
        text += " The least dihedral angle of the mesh is " + readable(run.mesh_before->dihedral_min) + " degrees; " +
                grouped(run.mesh_before->slivers) + " of its " +
                count_of(run.mesh_before->cells, "tetrahedron", "tetrahedra") +
                (run.mesh_before->slivers == 1 ? " is a sliver." : " are slivers.");
    if (const auto& plane = run.plane_before) {
        const std::uint64_t six = plane->neighbours[2];
        if (plane->inner > 0)
            text += " " + grouped(six) + " of the " + grouped(plane->inner) +
                    (run.input.box.empty() ? " inner vertices " : " vertices ") + (six == 1 ? "has" : "have") +
                    " six neighbours (" + percent(six, plane->inner) + ").";
        if (plane->angle_mean > 0)
            text += " The least angle of a triangle is " + readable(plane->angle_mean) + " degrees on average.";
    }
    if (run.volume_scatter_before)
        text += " The volumes of the Voronoi cells differ from their mean by " +
                readable(100 * *run.volume_scatter_before) + " % of it (standard deviation).";
    if (text.empty()) return {};
    return {(run.replayed ? "There is one frame." : "There was no iteration.") + text};
}

}  // namespace

double median_step(const Run_record& run) {
    if (run.steps.empty()) return 0;
    std::vector<double> seconds;
    for (const Iteration_record& step : run.steps) seconds.push_back(step.seconds_triangulation);
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return seconds.size() % 2 == 1 ? *middle : (*std::max_element(seconds.begin(), middle) + *middle) / 2;
}

std::vector<std::string> findings(const Run_record& run) {
    if (run.steps.empty()) return at_start(run);
    std::vector<std::string> all;
    const Iteration_record& last = run.steps.back();
    if (run.mesh_before && last.mesh)
        all.push_back(run.finished ? on_finished_mesh(*run.mesh_before, run) : on_mesh(*run.mesh_before, *last.mesh));
    if (run.plane_before && last.plane) all.push_back(on_plane(*run.plane_before, *last.plane, !run.input.box.empty()));
    if (run.volume_scatter_before && last.volume_scatter)
        all.push_back(on_volumes(*run.volume_scatter_before, *last.volume_scatter));
    all.push_back(on_box(run));
    std::erase(all, std::string());
    all.push_back(on_steps(run));
    return all;
}

std::vector<std::string> findings(const Comparison_record& comparison) {
    const auto& runs = comparison.runs;
    if (runs.size() < 2 || comparison.interrupted) return {};
    const auto [fastest, slowest] = std::minmax_element(
        runs.begin(), runs.end(), [](const auto& a, const auto& b) { return median_step(a) < median_step(b); });
    const double least = median_step(*fastest), most = median_step(*slowest);
    if (!(least > 0)) return {};
    const std::string word = step_word(*fastest), one = word == "iteration" ? "an iteration" : "a frame";
    const std::string steps = std::string(times_processor(*fastest) ? " of processor time" : " by the wall clock") +
                              " for keeping the triangulation in " + one + ", the median of " +
                              count_of(fastest->steps.size(), word.c_str(), (word + "s").c_str());
    if (readable(most / least) == "1")
        return {"The " + std::to_string(runs.size()) + " strategies took about as long: " + duration(least) + steps +
                "."};
    return {"The fastest of " + std::to_string(runs.size()) + " strategies was " + fastest->strategy + ": " +
            duration(least) + steps + ". The slowest, " + slowest->strategy + ", took " + readable(most / least) +
            " times as long."};
}

}  // namespace annulus::inline v1
