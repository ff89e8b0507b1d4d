// SPDX-License-Identifier: GPL-3.0-or-later
// Paper_strategy: the filtering algorithm (paper 3.2). The switch from rebuilding is in paper_switch.cpp, the rest in
// paper_strategy_state.cpp.
#include <annulus/published/paper_strategy.h>

#include <annulus/error.h>
#include <annulus/published/delimiter_side.h>

#include <limits>
#include <utility>

namespace annulus::inline v1 {

template <int d>
void Paper_strategy<d>::move(Index v, const Coordinates<d>& p, Move_result& report) {
    if (!has_switched()) return Rebuild_strategy<d>::move(v, p, report);
    const Coordinates<d> old = std::exchange(this->position_[at(v)], p);
    if (passes(v)) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    const auto moves = report.moves;  // a vertex that meets another one is moved again later
    bool begun = false;
    const auto rollback = [&] {
        report.moves = moves;
        this->position_[at(v)] = old;
        forget_queue();
    };
    try {
        process(v, report, true);
        begun = true;
        for (std::size_t i = 0; i < queue_.vertex.size(); ++i) process(queue_.vertex[i], report, false);
    } catch (const Error&) {
        rollback();
        if (begun) begin_again(report);
        throw;
    } catch (...) {
        rollback();
        throw;
    }
    queue_.vertex.clear();
}

/// Relocates h, the vertex that moves (`first`) or one from the queue, unless it is still in its safe region.
template <int d>
void Paper_strategy<d>::process(Index h, Move_result& report, bool first) {
    std::vector<Cell_index> changed;
    auto outcome = &Move_counts::rebuilt;
    const bool stays = safe_region_ && is_in_safe_region(h);
    if (stays) {
        outcome = &Move_counts::kept_in_place;
    } else {
        try {
            outcome = relocation_.move(state_.fixed, h, this->position_[at(h)], changed);
        } catch (const Error& e) {
            if (e.code() != Error_code::duplicate_point || is_taken(h)) throw;
            // h is at the fixed position of a vertex that has moved on.
        }
    }
    queue_.has[at(h)] = 0;
    const bool rebuilt = outcome == &Move_counts::rebuilt;
    if (rebuilt) rebuild();
    if (first) {
        ++report.moves.asked;
        ++(report.moves.*outcome);
    } else if (!stays) {
        ++report.statistics.requeued;
    }
    if (stays) return;
    if (rebuilt) return recompute_tolerances(this->position_, report);
    set_unlimited(h);
    const Corner_table<d>& table = this->mesh().table();
    table.for_each_corner(h, [&](Corner_index c) { changed.push_back(table.cell_of(c)); });
    tolerances_.note(changed, state_.fixed, least_, report);
    lower_points();
}

template <int d>
void Paper_strategy<d>::lower_points() {
    least_.take([this](Index w, double least) { lower(w, least); });
}

/// Notes that a certificate of v has this tolerance. The certificate may be new: then, with safe regions, a vertex
/// beyond its tolerance is queued even if the tolerance is not lowered, because it may have left its safe region.
template <int d>
void Paper_strategy<d>::lower(Index v, double tolerance) {
    const bool lowers = tolerance < state_.epsilon[at(v)];
    if (lowers) set_tolerance(v, tolerance);
    if (!(lowers || safe_region_) || queue_.has[at(v)] != 0 || passes(v)) return;
    queue_.vertex.push_back(v);
    queue_.has[at(v)] = 1;
}

template <int d>
void Paper_strategy<d>::set_tolerance(Index v, double tolerance) {
    state_.epsilon[at(v)] = tolerance;
    state_.threshold[at(v)] = squared_threshold_lower(tolerance);
}

/// v has no tolerance until its certificates are noted: until then only its fixed position passes.
template <int d>
void Paper_strategy<d>::set_unlimited(Index v) {
    state_.epsilon[at(v)] = std::numeric_limits<double>::infinity();
    state_.threshold[at(v)] = 0.0;
}

/// Whether the moving position of h is on its side of the standard delimiter of each of its bi-cells, at the fixed
/// positions.
template <int d>
bool Paper_strategy<d>::is_in_safe_region(Index h) const {
    bool holds = true;
    if constexpr (d == 2) {
        const Corner_table<2>& table = this->mesh().table();
        for_each_certificate(
            table, h, [](Corner_index) {},
            [&](Corner_index f) {
                holds =
                    holds && keeps_its_side(facet_certificate(table, f, true), state_.fixed, h, this->position_[at(h)]);
            });
    }
    return holds;
}

/// Whether another vertex is at the position of h. O(n).
template <int d>
bool Paper_strategy<d>::is_taken(Index h) const {
    const Coordinates<d>& p = this->position_[at(h)];
    for (Index w = 0; at(w) < this->position_.size(); ++w)
        if (w != h && this->mesh().has(w) && this->position_[at(w)] == p) return true;
    return false;
}

/// Rebuilds at the moving positions. Where two of them coincide, which tolerances that are not certified allow, the
/// previous cells are rebuilt.
template <int d>
void Paper_strategy<d>::rebuild() {
    try {
        this->mesh().rebuild(this->position_);
    } catch (const Error&) {
        this->mesh().rebuild(state_.fixed);
        throw;
    }
}

/// After a move that was interrupted and undone: rebuilds cells and tolerances at the moving positions, O(n).
template <int d>
void Paper_strategy<d>::begin_again(Move_result& report) {
    try {
        rebuild();
    } catch (const Error&) {  // two coincide
        return;
    }
    recompute_tolerances(this->position_, report);
}

template class Paper_strategy<2>;
template class Paper_strategy<3>;

}  // namespace annulus::inline v1
