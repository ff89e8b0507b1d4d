// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/step.h>
#include <annulus/types.h>

#include <vector>

namespace annulus::inline v1 {

/// Counts what became of the vertices that were to move, each once.
template <int d>
class Move_outcomes {
  public:
    void resize(std::size_t vertices) { grow(mark_, vertices); }
    /// After a step that was to move `asked` vertices. O(1 + what the step found).
    void count(const Step<d>& step, std::size_t asked, Move_counts& moves);

  private:
    std::vector<std::uint32_t> mark_;  // by vertex: stamp_ reinserted, stamp_ + 1 affected, in the present step
    std::uint32_t stamp_ = 0;
};

extern template class Move_outcomes<2>;
extern template class Move_outcomes<3>;

}  // namespace annulus::inline v1
