// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/sign_evaluator.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/published/paper_choice.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The paper's relocation of one vertex, with its improvements for small displacements (3.1).
template <int d>
class Relocation {
  public:
    /// Reads `in_place` and `flips` of `choice` only.
    Relocation(Delaunay_mesh<d>& mesh, const Paper_choice& choice)
        : mesh_(mesh), in_place_(choice.in_place), flips_(choice.flips && d == 2), signs_(mesh.table()) {}

    /// What became of a vertex, as a pointer to the counter in Move_counts.
    using Outcome = std::uint64_t Move_counts::*;

    /// Sets x[v] = p and makes the mesh, which is Delaunay at x before, Delaunay there; `changed` receives the cells
    /// that were flipped or are new. If the other vertices lie in a hyperplane, the outcome is `rebuilt`: nothing has
    /// changed, and the caller must rebuild. Throws Error(duplicate_point), with nothing changed; after other
    /// exceptions x[v] may be p, unless another vertex is there. Expected O(degree of v) after locating p.
    [[nodiscard]] Outcome move(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& p,
                               std::vector<Cell_index>& changed);

  private:
    Delaunay_mesh<d>& mesh_;
    bool in_place_;
    bool flips_;
    Sign_evaluator<d> signs_;
};

extern template class Relocation<2>;
extern template class Relocation<3>;

}  // namespace annulus::inline v1
