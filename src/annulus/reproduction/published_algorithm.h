// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/move_report.h>
#include <annulus/mesh/audit.h>
#include <annulus/reproduction/certificate_survey.h>

#include <memory>
#include <span>

namespace annulus {

/// The variant of the paper's dynamic algorithms.
struct Published_variant {
    /// 3.2: of a vertex within its tolerance only the position is written. Otherwise the relocation algorithm.
    bool tolerances = true;
    bool in_place = false;     ///< 3.1, "weaker version": a vertex that fails is relocated only if cells change
    bool flips = false;        ///< 3.1, 2D: flips where no cell around a vertex inverts. Only without tolerances
    bool safe_region = false;  ///< 3.2, 2D: of a vertex that fails inside its safe region only the position is written
};

/// The paper's algorithms as printed, on CGAL's triangulation alone: a vertex is relocated by CGAL's insertion at its
/// new position, from its old one, and CGAL's removal of the old one. There are no flips of our own, no table, no
/// filtered predicate; tolerances are in plain double, and in 3D they are unsound (docs/theory.md 3). Its results do
/// not depend on addresses.
///
/// It is cheaper than the text in three respects: it compares squares, its queue holds a vertex once, and it processes
/// the vertices of a time step in the order of their indices.
template <int d>
class Published_algorithm {
  public:
    /// Throws as Moving_delaunay does.
    Published_algorithm(std::span<const Coordinates<d>> points, const Published_variant& choice);
    ~Published_algorithm();

    /// Computes every tolerance at the fixed positions, as the constructor does. O(n).
    void precompute();
    /// Moves each vertex in turn. Throws Error(duplicate_point). The object is unusable afterwards, and also after
    /// points have become flat.
    Move_report move_all(std::span<const Coordinates<d>> target);
    /// The vertices whose tolerance did not pass the last move, each once.
    [[nodiscard]] std::span<const Index> failed() const;
    /// Recomputes a tolerance from the facets around the vertex: the cost of sampling one vertex of a triangulation
    /// without tolerances.
    [[nodiscard]] double tolerance(Index v) const;
    /// Audits its cells exactly at the moving positions.
    [[nodiscard]] Audit_result audit() const;

  private:
    class Work;
    std::unique_ptr<Work> work_;
};

extern template class Published_algorithm<2>;
extern template class Published_algorithm<3>;

}  // namespace annulus
