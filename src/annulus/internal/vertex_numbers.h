// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/traits.h>
#include <annulus/types.h>

#include <unordered_map>

namespace annulus::inline v1 {

/// The index of each vertex of CGAL's object: in the vertex, where its base has a place for it (Has_number), otherwise
/// in a hash table. O(1).
template <class Vertex, class Vertex_handle>
class Vertex_numbers {
  public:
    /// Prepares for set(). Throws bad_alloc.
    void add(Vertex_handle v) { table_[&*v] = none; }
    void set(Vertex_handle v, Index i) noexcept { table_.find(&*v)->second = i; }
    void forget(Vertex_handle v) noexcept { table_.erase(&*v); }
    /// `none` for a vertex of another object.
    [[nodiscard]] Index of(Vertex_handle v) const {
        const auto it = table_.find(&*v);
        return it == table_.end() ? none : it->second;
    }

  private:
    std::unordered_map<const Vertex*, Index> table_;
};

template <Has_number Vertex, class Vertex_handle>
class Vertex_numbers<Vertex, Vertex_handle> {
  public:
    void add(Vertex_handle) noexcept {}
    void set(Vertex_handle v, Index i) noexcept { v->set_index(i); }
    void forget(Vertex_handle) noexcept {}
    [[nodiscard]] Index of(Vertex_handle v) const { return v->index(); }
};

}  // namespace annulus::inline v1
