// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/collision.h>
#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/error.h>

#include <cstddef>
#include <exception>
#include <span>

namespace annulus {

/// Inserts x[i] into a triangulation of CGAL's for every i of the order, each near the last one, and calls
/// assign(vertex, i). For points in a hyperplane, which the kernel does not build. Throws Error(collision) naming two
/// points of one position.
template <class Traits, class Assign>
void insert_in_order(typename Traits::Triangulation& tr, std::span<const Coordinates<Traits::dimension>> x,
                     std::span<const Index> order, Assign assign) {
    std::exception_ptr collision;  // thrown outside, where the thread's table is known to be sound
    Traits::edit([&] {
        typename Traits::Vertex_handle last;
        std::size_t count = 0;
        for (const Index i : order) {
            last = Traits::insert(tr, Traits::point(x[static_cast<std::size_t>(i)]), last);
            if (tr.number_of_vertices() == count) {
                collision = std::make_exception_ptr(collision_of("points", "have", last->index(), i));
                return;
            }
            ++count;
            assign(last, i);
        }
    });
    if (collision) std::rethrow_exception(collision);
}

}  // namespace annulus
