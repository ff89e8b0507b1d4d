// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <thread>

namespace annulus::cgal_3 {

/// Whether a call has thrown in this thread.
inline bool& table_is_spoilt() {
    thread_local bool spoilt = false;
    return spoilt;
}

/// Makes `call`, in which CGAL inserts into a triangulation of space (to remove a vertex it does that too).
///
/// CGAL (5.5, Triangulation_data_structure_3::create_star_2) keeps the edges of a hole in a table of the thread and takes them out
/// one by one. When memory runs out in between they stay, and every later insertion in space of that thread, into
/// whatever triangulation, may take them for its own. So once a call has thrown, those of this thread are
/// made by others, each with a table of its own: slow, and right.
template <class Call>
void with_sound_table(Call call) {
    if (bool& spoilt = table_is_spoilt(); !spoilt) {
        spoilt = true;
        call();
        spoilt = false;
        return;
    }
    std::exception_ptr thrown;
    std::thread([&] {
        try {
            call();
        } catch (...) {
            thrown = std::current_exception();
        }
    }).join();
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace annulus::cgal_3
