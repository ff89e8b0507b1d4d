// SPDX-License-Identifier: GPL-3.0-or-later
// How `tolerances` and `auto` evaluate the tolerances of everything: at once, or in slices.
#include <annulus/engine/tolerance_strategy.h>

#include <algorithm>

namespace annulus::inline v1 {

/// In blocks that stay in the cache from evaluation to writing; several threads need larger ones. The order is the
/// same.
template <int d>
Stage_counts Tolerance_strategy<d>::evaluate_slice(std::span<const Coordinates<d>> x, std::size_t facets,
                                                   std::pair<std::size_t, std::size_t> slice, Move_result& report) {
    Certificate_checker<d>& checker = repair_.checker();
    Stage_counts all;
    const bool changes = slices_.has_changes();
    const auto changed = [&](Cell_index c) { return changes && slices_.has_changed(c); };
    const auto in_blocks = [&](std::size_t first, std::size_t last, auto add) {
        const std::size_t block = threads_ > 1 ? 1 << 16 : 1024;
        while (first < last) {
            const std::size_t end = std::min(last, (first / block + 1) * block);
            checker.begin(x);
            for (; first < end; ++first) add(static_cast<Index>(first));
            const Stage_counts counts = checker.evaluate();
            displacement_budget_.commit_fresh(checker);
            all += counts;
        }
    };
    in_blocks(std::min(slice.first, facets), std::min(slice.second, facets), [&](Index i) {
        const Corner_index f(i);
        if (!table_.is_facet(f)) return;
        if (changes && (changed(table_.cell_of(f)) || changed(table_.cell_of(table_.twin(f))))) return;
        checker.add_new_facet(f);
    });
    in_blocks(std::max(slice.first, facets) - facets, std::max(slice.second, facets) - facets, [&](Index i) {
        const Cell_index c(i);
        if (table_.is_cell(c) && !changed(c)) checker.add_new_cell(c);
    });
    report.statistics.evaluated += all.total();
    report.statistics.arithmetic += all;
    return all;
}

/// As much of it as this time step may still cost, when tolerances would last or this has begun before. Tolerances are
/// kept once all are there and what has expired meanwhile was evaluated. If that costs too much, it is left to the
/// next time step, and given up where that cannot afford it either.
template <int d>
void Tolerance_strategy<d>::recompute_slice(Move_result& report) {
    const auto n = static_cast<double>(mesh_.vertices());
    if (!slices_.begun()) {
        if (!tolerance_policy_.take_recomputation()) return;
        slices_.begin(table_, position_);
        displacement_budget_.begin(position_);
    }
    const double most = Rebuild_policy<d>::step_limit(mesh_.vertices());
    const bool was_complete = slices_.complete();
    // Later stages may cost fifty times as much as the filter, which is not known beforehand. So it is made in parts,
    // each of which costs a quarter of a rebuild even if all of it is decided exactly, and as many of the next one as
    // there is room for if they cost what the most expensive part has cost.
    const double part = Rebuild_policy<d>::rebuild_cost(mesh_.vertices()) / (4.0 * exact_evaluation_cost);
    const double place = Cost_model<d>::recomputation * n / static_cast<double>(slices_.all());
    double most_each = place;
    for (double& cost = report.statistics.cost; !slices_.complete() && cost + most_each <= most;) {
        const auto slice = slices_.take(std::clamp((most - cost) / most_each, 1.0, std::max(part, 1.0)));
        const Stage_counts counts = evaluate_slice(slices_.positions(), slices_.facets(), slice, report);
        const auto taken = static_cast<double>(slice.second - slice.first);
        const double paid = place * taken + Certificate_checker<d>::later_cost(counts);
        cost += paid;
        most_each = std::max(most_each, paid / taken);
    }
    if (!slices_.complete()) return;
    if (finish_slices(most - report.statistics.cost, report)) slices_.end();
    else if (was_complete) drop_tolerances();
}

/// The step from where the slices began to the present positions, at which every certificate holds. False, with
/// nothing kept, when it would cost more than there is room for.
template <int d>
bool Tolerance_strategy<d>::finish_slices(double room, Move_result& report) {
    displacement_budget_.resize();  // steps meanwhile have made cells
    displacement_budget_.finish_beginning();
    Step<d> step = new_step(position_, none, Scope::expired);
    (void)find_failed(step);
    const double failures = Cost_model<d>::failure * static_cast<double>(step.failed.size());
    bool finished = false;
    if (failures <= room) {
        step.budget.charge(failures);
        Certificate_checker<d>& checker = repair_.checker();
        checker.begin(position_);
        displacement_budget_.find_expired(step, checker);
        std::vector<Cell_index> changed;
        for (const Cell_index c : table_.cells())
            if (slices_.has_changed(c)) changed.push_back(c);
        checker.add_cells(changed);
        finished = repair_.can_evaluate(step, room);
        if (finished) {
            const Stage_counts counts = checker.evaluate();
            step.count(counts);
            step.budget.charge(checker.cost(counts));
            displacement_budget_.commit(step, checker);
        } else {
            displacement_budget_.undo(step);
        }
        report += step.report;
        report.statistics.cost += step.budget.spent;
    }
    previous_ = std::move(step);
    if (!finished) {
        displacement_budget_.invalidate();
        return false;
    }
    tolerance_policy_.note_recomputed();
    ++report.statistics.tolerance_recomputations;
    return true;
}

template class Tolerance_strategy<2>;
template class Tolerance_strategy<3>;

}  // namespace annulus::inline v1
