// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/frame_record.h>

#include <apps/report/box_change.h>

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <class Record, class X, class Y>
Series series(std::string name, const std::vector<Record>& records, X x, Y y) {
    Series s{std::move(name), {}, {}};
    for (const Record& r : records) {
        const auto value = y(r);
        if (!value) continue;
        s.x.push_back(static_cast<double>(x(r)));
        s.y.push_back(static_cast<double>(*value));
    }
    return s;
}

/// Whether some curve would be flat on a linear scale: all values are positive, and one is thirty times another.
bool needs_logarithm(const std::vector<Series>& curves) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Series& s : curves)
        for (const double y : s.y) {
            least = std::min(least, y);
            most = std::max(most, y);
        }
    return least > 0 && most > 30 * least;
}

Plot plot(std::string title, std::string x, std::string y, std::vector<Series> curves) {
    std::erase_if(curves, [](const Series& s) { return s.x.empty(); });
    const bool logarithmic = needs_logarithm(curves);
    return {std::move(title),
            {std::move(x), Scale::linear, {}, {}, true},
            {std::move(y),
             logarithmic ? Scale::log10 : Scale::linear,
             logarithmic ? std::nullopt : std::optional(0.),
             {},
             false},
            std::move(curves)};
}

/// How flips and changes of neighbours go together, and of a replayed motion why there is no chart of flips.
std::string on_flips(const Run_record& run, bool charted, bool changes, bool points_change) {
    if (run.moves.rebuilt > 0)
        return std::string(run.replayed ? " A frame" : " An iteration") + " that was rebuilt has " +
               (changes ? "such changes, and no flips" : "no flips") +
               (charted ? ": so flips are counted, but not charted." : ".");
    if (!counts_flips(run)) return charted ? " The strategy " + run.strategy + " counts no flips." : "";
    if (!changes) return {};
    if (run.moves.reinserted > 0 || points_change)
        return " Points that are inserted or removed change neighbours, too, without flips.";
    return " So flips may be more.";
}

}  // namespace

std::vector<Figure> frame_figures(const std::vector<Frame_record>& frames, const Run_record& run, bool steps,
                                  std::string note) {
    const auto over_frames = [&](std::string name, auto value) {
        return series(
            std::move(name), frames, [](const Frame_record& f) { return f.number; }, value);
    };
    const auto over_steps = [&](std::string name, auto value) {
        return series(
            std::move(name), run.steps, [](const Iteration_record& s) { return s.iteration; }, value);
    };
    const auto voronoi = [&](std::string name, auto member) {
        return over_frames(std::move(name), [member](const Frame_record& f) {
            using Value = std::decay_t<decltype(std::optional((*f.voronoi).*member))>;
            return f.voronoi ? Value((*f.voronoi).*member) : Value();
        });
    };
    using Voronoi = Frame_record::Voronoi;
    const std::string word = step_word(run);
    Figure motion{"Over time", {}, ""}, cells{"Voronoi cells over time", {}, std::move(note)};
    if (steps) {
        const std::string length =
            std::string("displacement (mean spacings") + (box_changes(run) ? ", relative to the box)" : ")");
        if (!only_box_moves(run))
            motion.panels.push_back(
                plot("How far points go in a frame", step_axis_label(run), length,
                     {over_steps("mean", [](const auto& s) { return std::optional(s.displacement_mean); }),
                      over_steps("largest", [](const auto& s) { return std::optional(s.displacement_max); })}));
        if (run.moves.rebuilt == 0 && counts_flips(run))  // a rebuild has none
            motion.panels.push_back(plot("Flips", step_axis_label(run), "flips in a frame",
                                         {over_steps("", [](const auto& s) { return std::optional(s.flips); })}));
    }
    const bool points_change =
        std::any_of(frames.begin(), frames.end(), [&](const auto& f) { return f.points != frames.front().points; });
    if (points_change)
        motion.panels.push_back(
            plot("Points", word, "points", {over_frames("", [](const auto& f) { return std::optional(f.points); })}));
    const auto pairs = [&](std::string name, auto member) {
        return over_frames(std::move(name), [member](const Frame_record& f) {
            return f.pairs ? std::optional((*f.pairs).*member) : std::nullopt;
        });
    };
    using Pairs = Frame_record::Neighbour_pairs;
    std::vector<Series> changes{pairs("made", &Pairs::made), pairs("broken", &Pairs::broken)};
    const bool alike = changes[0].y == changes[1].y;  // a flip in 2D makes one and breaks one
    if (alike) changes = {pairs("", &Pairs::made)};
    if (!changes[0].x.empty())
        motion.caption = "Pairs of neighbours at the end of a " + word +
                         " that were none at the end of the one before, or the reverse: what is made and broken again "
                         "in between is not counted.";
    motion.caption += on_flips(run, steps, !changes[0].x.empty(), points_change);
    if (motion.caption.starts_with(' ')) motion.caption.erase(0, 1);
    motion.panels.push_back(plot("Neighbours that change", word,
                                 alike ? "pairs made, and as many broken" : "pairs since the " + word + " before",
                                 std::move(changes)));
    const char* const volume = run.dimension == 2 ? "area" : "volume";
    const std::string bounded = run.input.box.empty() ? "bounded cells" : "cells";  // in a periodic box all are
    const std::string counted = run.clip ? "cells wholly inside" : bounded;
    if (run.clip)
        cells.caption += std::string("The ") + volume +
                         " is that of the part in the clipping region, of all cells that "
                         "reach it. Neighbours are counted of cells wholly inside.";
    cells.panels.push_back(plot(
        std::string("The ") + volume + " of " + (run.clip ? "cells cut to the clipping region" : bounded), word, volume,
        {voronoi("5 %", &Voronoi::volume_low), voronoi("median", &Voronoi::volume_median),
         voronoi("95 %", &Voronoi::volume_high)}));
    Series hexagons = voronoi("", &Voronoi::hexagons);
    for (double& share : hexagons.y) share *= 100;
    if (run.dimension == 2)
        cells.panels.push_back(
            plot("Cells with six neighbours, of all " + counted, word, "share of the " + counted + " (%)", {hexagons}));
    else
        cells.panels.push_back(
            plot("Neighbours of a cell", word, "mean over the " + counted, {voronoi("", &Voronoi::neighbours_mean)}));
    if (run.input.box.empty() && !run.clip)  // in a periodic box, and where they are clipped, all are bounded
        cells.panels.push_back(plot("Unbounded cells", word, "cells", {voronoi("", &Voronoi::unbounded)}));
    std::vector<Figure> figures;
    for (Figure* figure : {&motion, &cells}) {
        std::erase_if(figure->panels, [](const Plot& p) { return p.series.empty(); });
        if (!figure->panels.empty()) figures.push_back(std::move(*figure));
    }
    return figures;
}

}  // namespace annulus::inline v1
