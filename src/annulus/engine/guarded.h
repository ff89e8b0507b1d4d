// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/engine.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/upkeep.h>

#include <utility>

namespace annulus {

/// Makes a call that changes something. Whatever it throws but an Error that is thrown before any change, the triangulation
/// is built anew at the positions of before; `fresh` is the index that the call inserts, if any.
template <int d>
template <class Call>
void Engine<d>::guarded(Call call, Index fresh) {
    require_whole();
    const std::size_t bound = index_bound();
    const Strategy strategy = strategy_;
    const auto switch_back = [&] {
        if (!before_) return;
        strategy_ = strategy;  // hybrid
        upkeep_ = std::move(before_);
        embedding_.drop_mirror();
    };
    try {
        call();
        before_.reset();  // not before: its positions may be what was asked for
    } catch (const Error& e) {
        switch_back();
        if (e.code() == Error_code::too_large) recover(bound, fresh);
        throw;
    } catch (...) {
        switch_back();
        recover(bound, fresh);
        throw;
    }
}

}  // namespace annulus
