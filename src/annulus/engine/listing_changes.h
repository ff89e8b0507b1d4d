// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/cell_changes.h>
#include <annulus/engine/engine.h>
#include <annulus/engine/update_strategy.h>

#include <vector>

namespace annulus::inline v1 {

/// Makes a call and, if requested, lists the cells that it changed. `movers` are the vertices whose positions the
/// call writes. When there is no memory for the list, their positions are restored, and the caller rebuilds.
template <int d>
template <class Call>
void Engine<d>::listing_changes(Move_result& report, std::span<const Index> movers, Call call) {
    if (!change_log_) return call();
    std::vector<Point> source;
    source.reserve(movers.size());
    for (const Index i : movers) source.push_back(positions()[at(i)]);
    Cell_changes<d> changes(mesh_, delaunay_positions(), *change_log_);
    call();
    try {
        changes.list(delaunay_positions(), report);
    } catch (...) {
        for (std::size_t k = 0; k < movers.size(); ++k) strategy_->restore_position(movers[k], source[k]);
        throw;
    }
}

/// The same for calls that write every position. Strategies that repair whole time steps write them last: there they
/// are saved when the first cell changes, so that a time step in which none does costs what it costs without lists.
template <int d>
template <class Call>
void Engine<d>::listing_all_changes(Move_result& report, Call call) {
    if (!change_log_) return call();
    Cell_changes<d> changes(mesh_, delaunay_positions(), *change_log_);
    change_log_->save_positions(positions());
    if (!strategy_->repairs() || strategy_->is_sequential() || mesh_.dimension() != d) change_log_->save_now();
    call();
    try {
        changes.list(delaunay_positions(), report);
    } catch (...) {
        const auto saved = change_log_->saved_positions();
        for (std::size_t v = 0; v < saved.size(); ++v) strategy_->restore_position(static_cast<Index>(v), saved[v]);
        change_log_->forget_positions();
        throw;
    }
    change_log_->forget_positions();
}

}  // namespace annulus::inline v1
