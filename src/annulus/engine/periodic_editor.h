// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_state.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/kernel/periodic_inserter.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Inserts points into a Periodic_state and removes or moves vertices: near them where that is possible
/// (Periodic_inserter), by a build otherwise. A call that throws leaves the state as it was. One call at a time.
template <int d>
class Periodic_editor {
  public:
    /// Builds with this object, and as many threads; it has to outlive the editor.
    Periodic_editor(Periodic_builder<d>& builder, int threads) : builder_(builder), threads_(threads) {}

    /// Throws what Periodic_mesh::insert throws, but for environment.
    std::vector<Index> insert(Periodic_state<d>& state, std::span<const Coordinates<d>> points);
    /// Throws what Periodic_mesh::remove throws, but for environment.
    void remove(Periodic_state<d>& state, std::span<const Index> indices);
    /// Moves some vertices, each named once, all or none: all are removed, and then inserted where they go, so that one
    /// may go where another one was. Only cells near the places where they were, and are, change. False, with nothing
    /// changed, where that is not possible. Throws duplicate_point, too_large and bad_alloc. O(what changes) memory.
    [[nodiscard]] bool move(Periodic_state<d>& state, std::span<const Vertex_move<d>> moves);

  private:
    [[nodiscard]] Index insert_one(Periodic_state<d>& state, const Representative<d>& r);
    [[nodiscard]] std::vector<Index> insert_at_once(Periodic_state<d>& state,
                                                    std::span<const Representative<d>> points);
    void remove_one(Periodic_state<d>& state, Index i);
    [[nodiscard]] bool reinsert(Periodic_state<d>& state, std::span<const Vertex_move<d>> moves);
    void build(Periodic_state<d>& state);

    Periodic_builder<d>& builder_;
    int threads_;
    Periodic_inserter<d> inserter_;
    Periodic_journal<d> journal_;  // of a move
};

extern template class Periodic_editor<2>;
extern template class Periodic_editor<3>;

}  // namespace annulus::inline v1
