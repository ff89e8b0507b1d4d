// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/engine.h>

#include <annulus/engine/naming_duplicates.h>
#include <annulus/engine/update_strategy.h>
#include <annulus/error.h>

#include <utility>

namespace annulus::inline v1 {

/// Makes a call that changes something. If it throws anything but an Error that is thrown before any change, the
/// triangulation is rebuilt at the previous positions. `fresh` is the index that the call inserts, if any.
template <int d>
template <class Call>
void Engine<d>::guarded(Call call, Index fresh) {
    require_whole();
    const std::size_t bound = index_bound();
    try {
        call();
    } catch (const Error& e) {
        if (e.code() == Error_code::too_large) recover(bound, fresh);
        throw;
    } catch (...) {
        recover(bound, fresh);
        throw;
    }
}

template <int d>
template <class Call>
void Engine<d>::guarded_moves(std::span<const Index> movers, std::span<const Point> targets, Call call) {
    try {
        guarded(call);
    } catch (const Error& e) {
        if (e.code() != Error_code::duplicate_point) throw;
        std::vector<Point> x(positions().begin(), positions().end());
        for (std::size_t k = 0; k < targets.size(); ++k) x[movers.empty() ? k : at(movers[k])] = targets[k];
        rethrow_with_vertices<d>(e, std::span<const Point>(x), [this](Index i) { return is_vertex(i); });
    }
}

}  // namespace annulus::inline v1
