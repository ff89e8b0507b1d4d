// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/neighbour_changes.h>
#include <annulus/measure/t1_transitions.h>
#include <annulus/types.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1::c {

/// The cells that came and went in the last call that changed a mesh, and the edges that it made and broke. A call may
/// change the mesh several times, as annulus_insert does. Const members may run concurrently.
class Changes_of_call {
  public:
    void clear() noexcept { assign({}, {}); }
    /// The lists of a call that changed the mesh once.
    void assign(std::vector<Index> came, std::vector<Index> gone) noexcept;
    /// Appends those of a further change. If memory runs out nothing is appended.
    void add(std::span<const Index> came, std::span<const Index> gone);

    /// d + 1 vertices for each cell, in the order of the changes.
    [[nodiscard]] const std::vector<Index>& came() const { return came_; }
    [[nodiscard]] const std::vector<Index>& gone() const { return gone_; }
    /// An edge that several changes made and broke counts as it is after the last one. The first request computes the
    /// edges, O(k log k) for k cells; they are kept until the lists change. Precondition: d is 2 or 3.
    [[nodiscard]] const Edge_changes& edges(int d) const;
    /// Those of the call as a whole, in 2D; computed and kept in the same way. Precondition: the mesh is in 2D.
    [[nodiscard]] const T1_transitions& t1() const;

  private:
    /// Where the lists of a change begin.
    struct Begin {
        std::size_t came = 0, gone = 0;
    };
    template <int d>
    [[nodiscard]] Edge_changes compute() const;

    std::vector<Index> came_, gone_;
    std::vector<Begin> begins_;  // of every change but the first one
    mutable std::mutex computing_;
    mutable std::optional<Edge_changes> edges_;
    mutable std::optional<T1_transitions> t1_;
};

}  // namespace annulus::inline v1::c
