// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/rebuild_strategy.h>
#include <annulus/published/relocation.h>

namespace annulus::inline v1 {

/// The paper's relocation algorithm (3.1), one vertex at a time, without tolerances: the strategies `relocate`, which
/// removes and inserts every vertex, and `relocate-flips`, which does so only where one of its certificates does not
/// hold at its new position.
template <int d>
class Relocation_strategy final : public Rebuild_strategy<d> {
  public:
    /// Precondition: `choice` has no tolerances.
    Relocation_strategy(Delaunay_mesh<d>& mesh, const Paper_choice& choice)
        : Rebuild_strategy<d>(mesh, choice.strategy()), relocation_(mesh, choice) {}

    [[nodiscard]] bool is_sequential() const override { return true; }
    void move(Index v, const Coordinates<d>& p, Move_result& report) override;

  private:
    Relocation<d> relocation_;
};

extern template class Relocation_strategy<2>;
extern template class Relocation_strategy<3>;

}  // namespace annulus::inline v1
