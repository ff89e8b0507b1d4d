// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/move_report.h>
#include <annulus/mesh/audit.h>
#include <annulus/reproduction/certificate_survey.h>

#include <memory>
#include <span>

namespace annulus {

/// Which of the paper's dynamic algorithms.
struct Published_variant {
    /// 3.2: who stays within its tolerance is only written. Otherwise the relocation algorithm.
    bool tolerances = true;
    bool in_place = false;     ///< 3.1, the "weaker version": who fails is relocated only where cells have to change
    bool flips = false;        ///< 3.1, the plane: flips where no cell around a vertex inverts. Without tolerances only
    bool safe_region = false;  ///< 3.2: who fails and is within its safe region is only written. In 2D
};

/// The paper's algorithms as it prints them, on nothing but CGAL's triangulation: a vertex is relocated by CGAL's
/// insertion at its new position, from its old one, and CGAL's removal of the old one. There are no flips of our own,
/// no table, no filtered predicate; tolerances are in plain double, and in 3D they are unsound (docs/theory.md 3).
/// What it does does not depend on addresses.
///
/// Of three the work is cheaper than the text: squares are compared, a queue holds a vertex once, and a time step's
/// vertices follow each other in the order of their indices.
template <int d>
class Published_algorithm {
  public:
    /// Throws what Moving_delaunay does.
    Published_algorithm(std::span<const Coordinates<d>> points, const Published_variant& choice);
    ~Published_algorithm();

    /// Every tolerance, at the fixed positions; the constructor did so. O(n).
    void precompute();
    /// Each vertex in turn. Throws Error(duplicate_point), after which it is good for nothing, as where points come to
    /// lie in a plane.
    Move_report move_all(std::span<const Coordinates<d>> target);
    /// Those whose tolerance did not let the last move pass, each once.
    [[nodiscard]] std::span<const Index> failed() const;
    /// Recomputed from what is around it: what sampling one vertex of a triangulation without tolerances costs.
    [[nodiscard]] double tolerance(Index v) const;
    /// The exact audit of its cells at the moving positions.
    [[nodiscard]] Audit_result audit() const;

  private:
    class Work;
    std::unique_ptr<Work> work_;
};

extern template class Published_algorithm<2>;
extern template class Published_algorithm<3>;

}  // namespace annulus
