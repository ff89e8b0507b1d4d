// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace annulus::inline v1 {

/// What a trace has: each event and what follows it.
struct Trace_events {
    enum Event : std::uint64_t {
        history = 1,  ///< dimension: another triangulation
        places,       ///< vertices with their positions: where they are going, or are
        gone,         ///< vertices that are none any more
        begin,        ///< everything is re-evaluated; `places` names all vertices
        recompute,    ///< the vertices with threshold and list: it has been
        test,         ///< 0 for all vertices or the mover + 1; the vertices that failed
        stamp,        ///< a step begins, with this stamp
        anchor,       ///< the vertices that failed with their bases
        examine,      ///< vertex; 0 or 1: whether there was a star walk; what it went round; pending certificates; list
        undo,         ///< the step is taken back
        replaced,     ///< certificates that are gone or have other points now; what follows is written down
        write,        ///< id, tolerance; its points with base and expiry
        finish,       ///< vertex; 0 or 1: whether it was rebased; what that went round; base, threshold, list
        over,         ///< how many certificates there are: the step is over
        place,        ///< vertex, position: it is new
        untracked,    ///< a step without tolerances
        failed,       ///< a call ended in an error (traces.cpp)
        requested,    ///< a call succeeded that was to bring these vertices to these positions (traces.cpp)
    };
    static constexpr std::uint64_t minus = (std::uint64_t{1} << 63) - 1;
};

}  // namespace annulus::inline v1
