// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/finishing.h>

#include <annulus/error.h>
#include <apps/cli/interruption.h>
#include <apps/cli/progress.h>
#include <apps/formats/input_error.h>
#include <apps/motion/vectors_3.h>
#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <optional>

namespace annulus::inline v1::cli {

namespace {

std::vector<Finish_3::Cell> finite_cells(const std::vector<Index>& vertices) {
    std::vector<Finish_3::Cell> cells;
    for (std::size_t i = 0; i + 4 <= vertices.size(); i += 4) {
        const Finish_3::Cell c{vertices[i], vertices[i + 1], vertices[i + 2], vertices[i + 3]};
        if (*std::min_element(c.begin(), c.end()) >= 0) cells.push_back(c);
    }
    return cells;
}

}  // namespace

void add_finish(CLI::App& app, bool& finish) {
    app.add_flag("--finish", finish,
                 "After the iterations, move corners of the worst cells by small steps as long as the least dihedral "
                 "angle rises: one more step, after which the mesh is Delaunay, too");
}

Finishing::Finishing(const Nodt_scene& scene, const Moving_mesh_3& optimised, bool quiet) {
    const std::vector<Coordinates<3>> begin(optimised.points().begin(), optimised.points().end());
    Options options;
    options.report_changes = true;
    Moving_mesh_3 dt(begin, options);
    const auto move = [&dt](Index v, const Coordinates<3>& p) -> std::optional<Finish_3::Changes> {
        try {
            const Move_result report = dt.move(v, p);
            return Finish_3::Changes{finite_cells(report.changed), finite_cells(report.gone)};
        } catch (const Error& e) {
            if (e.code() == Error_code::duplicate_point) return std::nullopt;
            throw;
        }
    };
    std::vector<char> held(begin.size(), 0);
    if (scene.features) {
        const auto places = scene.features->places(scene.points, rounding_of(*scene.domain));
        for (std::size_t v = 0; v < held.size(); ++v) held[v] = places[v] != Feature_curves::Place::off;
    }
    Finish_3 finish(*scene.domain, {begin, scene.on_surface, std::move(held)}, dt.cells().vertices, move);
    {
        Progress progress("finish", 0, quiet);
        for (std::uint64_t i = 1; !Interruption_guard::interrupted() && finish.step(); ++i)
            progress.show(i, counted(finish.counts().kept, "move"));
    }
    position_ = finish.position();
    counts_ = finish.counts();
    for (std::size_t v = 0; v < begin.size(); ++v) {
        const double way = distance(begin[v], position_[v]);
        mean_ += way / static_cast<double>(begin.size());
        max_ = std::max(max_, way);
    }
}

std::string Finishing::note() const {
    return "The last step is --finish: " + grouped(counts_.kept, "move") + " of corners of the worst cells, of " +
           grouped(counts_.tried, "move") + " tried.";
}

}  // namespace annulus::inline v1::cli
