// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The costs of engine/cost_model.h, measured once.
#include "sign_costs.h"
#include "timing.h"
#include "workbench.h"

#include "../motions/cgal_rebuild.h"

#include <annulus/engine/sample.h>
#include <annulus/engine/sign_evaluator.h>
#include <annulus/mesh/evaluate.h>
#include <annulus/predicate/batch.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace bench {

using namespace annulus;
using nlohmann::ordered_json;

template <int d>
class Repetition {
  public:
    Repetition(std::size_t n, std::uint64_t seed)
        : n_(n), all_(static_cast<double>(n)), seed_(seed), w_("uniform", n, seed) {}

    ordered_json measure() {
        for (const auto part : {&Repetition::counts, &Repetition::building, &Repetition::recomputation,
                                &Repetition::steps_of_tolerances, &Repetition::steps_of_signs,
                                &Repetition::doubtful_signs, &Repetition::signs_by_stage, &Repetition::later_stages}) {
            find_unit();
            (this->*part)();
        }
        return out_;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// The time of testing a cell, over all cells in their order: measured again before each part, since the speed of a
    /// machine varies.
    void find_unit() {
        const auto& table = w_.mesh().table();
        Sign_evaluator<d> signs(table);
        Budget budget;
        const double s = least(5, [&] {
            budget = {};
            signs.begin(w_.points(), budget);
            signs.test_all_cells();
        });
        unit_ = s / budget.spent;
    }

    /// Counted work, and work around one vertex.
    void counts() {
        const auto& table = w_.mesh().table();
        std::size_t cells = 0;
        std::size_t certificates = 0;
        for (const Cell_index c : table.cells()) {
            ++cells;
            if (!table.is_infinite(c)) ++certificates;
        }
        for (const Corner_index f : table.facets())
            if (facet_kind(table, f) != Facet_kind::nothing) ++certificates;
        find_unit();
        out_["unit"] = 1e9 * unit_;
        out_["cells"] = static_cast<double>(cells) / all_;
        out_["certificates"] = static_cast<double>(certificates) / all_;
        // Around one vertex, which moves alone.
        Repair<d> repair(w_.mesh());
        const std::size_t some = 2000;
        bool held = true;
        const double star = least(3, [&] {
            for (std::size_t k = 0; k < some; ++k) {
                Step<d> step;
                step.x = w_.points();
                step.mover = static_cast<Index>(7919 * k % n_);
                step.scope = Scope::star;
                repair.begin(step);
                held &= repair.evaluate_star(step);
            }
        });
        if (!held) throw std::runtime_error("a star does not hold where it was built");
        out_["star"] = star / static_cast<double>(some) / unit_;
    }

    void building() {
        typename Workbench<d>::Mesh fresh;
        auto x = w_.points();
        fresh.build(x);
        std::vector<double> rebuild;
        std::vector<double> insertion;
        Random random(seed_);
        for (int k = 0; k < 5; ++k) {
            for (auto& p : x)
                for (double& c : p) c += 0.1 * w_.spacing() * random.normal();
            rebuild.push_back(seconds([&] { fresh.rebuild(x); }));
            insertion.push_back(cgal_rebuild<d>(x, Stopwatch()));
        }
        out_["rebuild"] = vertex(*std::min_element(rebuild.begin(), rebuild.end()));
        out_["insertion"] = vertex(*std::min_element(insertion.begin(), insertion.end()));
    }

    void recomputation() {
        out_["recomputation"] = vertex(least(3, [&] { w_.recompute_tolerances(); }));
        w_.walk(1e-9);
        (void)w_.step();
        pass_ = least(5, [&] { (void)w_.step(); });
    }

    /// Steps in which some tolerances fail and others do not. The numbers of failed vertices and evaluated certificates
    /// are proportional in every motion, so that no fit separates their costs: they keep their ratio.
    void steps_of_tolerances() {
        Factor factor;
        Factor expected;
        const double certificates = out_["certificates"].get<double>() * all_;
        const double scale = d == 2 ? 10.0 : 1.0;
        for (const double s : {1e-5, 3e-5, 1e-4}) {
            for (const std::size_t share : {std::size_t{1}, std::size_t{10}, std::size_t{100}}) {
                w_.recompute_tolerances();
                double sum = 0.0;
                double expiries = 0.0;
                int counted = 0;
                for (int k = 0; k < 10; ++k) {
                    const auto before = w_.points();
                    w_.walk(scale * s, share);
                    const double expiring = share == 1 && k >= 3 ? certificates * expiring_share(before) : 0.0;
                    Move_result report;
                    const double t = seconds([&] { report = w_.step(); });
                    if (report.statistics.tolerance_steps != 1 || report.statistics.tolerance_recomputations != 0 ||
                        report.moves.rebuilt != 0 || !w_.strategy().keeps_tolerances())
                        break;
                    if (k < 3) continue;  // nothing fails just after tolerances were recomputed
                    const auto failed = static_cast<double>(report.moves.asked - report.moves.within_tolerance);
                    factor.add(Cost_model<d>::failure * failed +
                                   Cost_model<d>::evaluation * static_cast<double>(report.statistics.evaluated),
                               (t - pass_) / unit_);
                    sum += t / unit_;
                    expiries += expiring;
                    ++counted;
                }
                if (share == 1 && counted == 7) expected.add(expiries, sum);
            }
        }
        out_["failure"] = factor.value() * Cost_model<d>::failure;
        out_["evaluation"] = factor.value() * Cost_model<d>::evaluation;
        out_["expected"] = expected.value();
    }

    /// The engine's estimate: the mean of displacement / tolerance over bi-cells, of a step that begins at `before`.
    double expiring_share(const Points<d>& before) {
        const auto& table = w_.mesh().table();
        const auto& x = w_.points();
        double sum = 0.0;
        std::size_t sampled = 0;
        const Index bound = table.facet_bound().value();
        for (Index i = 0; i < bound; i += 1 + bound / 512) {
            const Corner_index f(i);
            if (!table.is_facet(f) || facet_kind(table, f) != Facet_kind::empty_sphere) continue;
            const auto points = bicell_sites(table, f);
            std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)> p;
            double way = 0.0;
            for (std::size_t k = 0; k < points.size(); ++k) {
                p[k] = before[at(points[k].vertex)];
                way = std::max(way, std::sqrt(squared_distance<d>(x[at(points[k].vertex)], p[k])));
            }
            const double room = evaluate_facet(Facet_kind::empty_sphere, p).tolerance;
            sum += way < room ? way / room : way > 0.0 ? 1.0 : 0.0;
            ++sampled;
        }
        return sum / static_cast<double>(std::max<std::size_t>(sampled, 1));
    }

    /// Without tolerances: when all certificates hold, and by the estimate from a sample of all cells. The numbers of
    /// violated facets and inverted cells are proportional, too.
    void steps_of_signs() {
        w_.drop_tolerances();
        double hold = 1e9;
        for (int k = 0; k < 6; ++k) {  // the eighth step tests whether tolerances would pay
            w_.walk(1e-9);
            Move_result report;
            const double t = seconds([&] { report = w_.step(); });
            if (report.statistics.sign_steps == 1 && report.statistics.tolerance_recomputations == 0)
                hold = std::min(hold, t);
        }
        out_["signs"] = vertex(hold);
        Factor factor;
        for (int k = 0; k < 8; ++k)
            for (const double s : {0.003, 0.01, 0.02, 0.03, 0.05}) {
                w_.walk(d == 2 ? 2.0 * s : s);
                const Sample sample =
                    annulus::sample_cells<d>(w_.mesh().table(), w_.points(), static_cast<std::size_t>(10.0 * all_));
                Move_result report;
                const double t = seconds([&] { report = w_.step(); });
                if (report.statistics.sign_steps != 1 || report.statistics.tolerance_recomputations != 0 ||
                    report.moves.rebuilt != 0)
                    continue;
                const double scale =
                    out_["cells"].get<double>() * all_ / static_cast<double>(std::max<std::size_t>(sample.cells, 1));
                factor.add(scale * (Cost_model<d>::violated * 0.5 * static_cast<double>(sample.violated) +
                                    Cost_model<d>::inverted * static_cast<double>(sample.inverted)),
                           (t - hold) / unit_);
            }
        out_["violated"] = factor.value() * Cost_model<d>::violated;
        out_["inverted"] = factor.value() * Cost_model<d>::inverted;
    }

    /// Certificates that the filter stage cannot decide: a lattice with noise of an ulp.
    void doubtful_signs() {
        Workbench<d> lattice("lattice", n_ / 2, seed_);
        const Sample sample = annulus::sample_cells<d>(lattice.mesh().table(), lattice.points(), 10 * n_);
        const auto& table = lattice.mesh().table();
        Sign_evaluator<d> signs(table);
        std::size_t cells = 0;
        for ([[maybe_unused]] const Cell_index c : table.cells()) ++cells;
        std::size_t broken = 0;
        const double s = least(2, [&] {
            Budget budget;
            signs.begin(lattice.points(), budget);
            signs.test_all_cells();
            const auto inverted = signs.inverted();
            for (const Cell_index c : inverted) broken += signs.is_inverted(c) ? 1U : 0U;
            const auto facets = signs.violated();
            for (const Corner_index f : facets) broken += signs.is_violated(f) ? 1U : 0U;
        });
        if (sample.cells == 0 || sample.unclear == 0) return;
        const double unclear =
            static_cast<double>(sample.unclear) * static_cast<double>(cells) / static_cast<double>(sample.cells);
        out_["unclear"] = (s / unit_ - static_cast<double>(cells)) / unclear;
    }

    void signs_by_stage() {
        Sign_costs<d> costs(seed_);
        out_["integers"] = costs.integers() / unit_;
        out_["interval"] = costs.interval() / unit_;
        out_["exact"] = costs.exact() / unit_;
    }

    /// Tolerances of bi-cells near a sphere, compared with those of the filter stage: with points so far off that
    /// intervals decide most, and so near that they decide none.
    void later_stages() {
        const auto filter = bicells(1e-3);
        const auto middle = bicells(d == 2 ? 1e-12 : 1e-10);
        const auto near = bicells(1e-17);
        // Two equations.
        const auto above = [&](const auto& b) {
            return b.seconds / unit_ - filter.seconds / unit_ * b.count / filter.count;
        };
        const double determinant = middle.interval * near.exact - near.interval * middle.exact;
        out_["interval_evaluation_cost"] = (above(middle) * near.exact - above(near) * middle.exact) / determinant;
        out_["exact_evaluation_cost"] = (middle.interval * above(near) - near.interval * above(middle)) / determinant;
    }

    struct Bicells {
        double seconds, count, interval, exact;
    };
    /// All bi-cells of points at this distance from the unit sphere, and the number decided by each stage.
    Bicells bicells(double noise) {
        Random random(seed_);
        auto x = Scene<d>("sphere", "walk", 400, 0.0, seed_).points();
        for (auto& p : x) {
            const double off = 1.0 + noise * random.normal();
            for (double& c : p) c *= off;
        }
        typename Workbench<d>::Mesh mesh;
        mesh.build(x);
        const auto& table = mesh.table();
        std::vector<Tuple<d, d + 2>> tuples;
        for (const Corner_index f : table.facets())
            if (facet_kind(table, f) == Facet_kind::empty_sphere)
                tuples.push_back(tuple<d, d + 2>(bicell_sites(table, f), std::span<const Coordinates<d>>(x)));
        std::vector<Certificate_value> verdict(tuples.size());
        Stage_counts by;
        const double s = least(3, [&] { by = evaluate(tuples, Tolerance_precision::lower_bound, verdict); });
        return {s, static_cast<double>(tuples.size()), static_cast<double>(by.interval), static_cast<double>(by.exact)};
    }

    [[nodiscard]] double vertex(double s) const { return s / all_ / unit_; }

    std::size_t n_;
    double all_;
    std::uint64_t seed_;
    Workbench<d> w_;
    double unit_ = 0.0;
    double pass_ = 0.0;
    ordered_json out_;
};

}  // namespace bench
