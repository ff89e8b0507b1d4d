// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/rebuild_strategy.h>

namespace annulus {

/// The strategies `relocate` and `relocate-flips`: each vertex is removed and inserted again, always, or only where
/// one of its certificates does not hold at its new position (paper 3.1). No tolerances.
template <int d>
class Relocation_strategy final : public Rebuild_strategy<d> {
  public:
    /// Precondition: one of these two.
    Relocation_strategy(Delaunay_mesh<d>& mesh, Strategy strategy) : Rebuild_strategy<d>(mesh, strategy) {}

    [[nodiscard]] bool is_sequential() const override { return true; }
    void move(Index v, const Coordinates<d>& p, Move_report& report) override;
};

extern template class Relocation_strategy<2>;
extern template class Relocation_strategy<3>;

}  // namespace annulus
