// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A program of moves, insertions and removals in 2D or in 3D, run against the library and a model that predicts the
// result of every call. Shared by the fuzz targets (which decode bytes into programs) and the property tests. Code that
// only runs programs needs only operation.h, without CGAL.

#include "mesh_twin.h"
#include "motion.h"
#include "operation.h"
#include "oracle.h"
#include "oracle_3.h"

#include <annulus/arithmetic/limits.h>

namespace annulus::oracle {

/// The strategies that keep tolerances; others compute one from cells and points for each query, which is slow in 3D.
template <class Moving>
[[nodiscard]] bool keeps_tolerances(const Moving& dt) {
    return dt.strategy() == Strategy::tolerances || dt.strategy() == Strategy::tolerances_each ||
           dt.strategy() == Strategy::paper;
}

/// All that a caller can observe of an object.
template <int d>
struct State_of {
    std::vector<Coordinates<d>> positions;
    std::vector<Coordinates<d>> fixed;
    std::vector<Coordinates<d>> cgal_points;
    std::vector<double> tolerances;  ///< where they are kept
    std::vector<typename Space<d>::Moving::Vertex_handle> handles;
    Cells_of<d> cells;
    std::size_t vertices = 0;
};

/// The library's object and a model of its required state.
template <int d>
class Session_of {
  public:
    using Moving = typename Space<d>::Moving;
    using Kind = Operation_kind;

    explicit Session_of(const Program_of<d>& program);
    Session_of(Strategy strategy, const std::vector<Coordinates<d>>& points)
        : Session_of(Program_of<d>{strategy, points, {}}) {}

    using Fault = Session_fault;

    [[nodiscard]] Moving& dt() { return *dt_; }
    [[nodiscard]] const Sites_of<d>& sites() const { return sites_; }
    [[nodiscard]] const Move_result& last() const { return last_; }  ///< of the last call
    [[nodiscard]] const Coverage& coverage() const { return coverage_; }

    /// Makes the call and compares it with the model; a steady motion is many calls, checked after some of them.
    /// Throws Fault.
    void apply(const Operation_of<d>& o);
    /// Checks the invariants between calls. Throws Fault.
    void check() const;
    /// To be called after recompute_tolerances(): tolerances against the exact ones. Throws Fault.
    void check_recomputed_tolerances() const;

    [[nodiscard]] bool certified() const { return setting_.tolerance == Tolerance_kind::certified; }
    /// The last call was refused and changed nothing: there is nothing new to check.
    [[nodiscard]] bool refused() const { return refused_; }
    /// A duplicate point occurred under a kind of tolerance without guarantee: the model is no longer valid.
    [[nodiscard]] bool wrecked() const { return wrecked_; }

  private:
    [[nodiscard]] bool live(Index v) const {
        return v >= 0 && static_cast<std::size_t>(v) < sites_.size() && sites_[static_cast<std::size_t>(v)];
    }
    [[nodiscard]] std::vector<Index> living() const;
    [[nodiscard]] std::vector<Coordinates<d>> present() const;
    [[nodiscard]] Operation_of<d> resolved(const Operation_of<d>& o) const;
    [[nodiscard]] Operation_of<d> refusal_of(Refusal why, std::size_t v) const;
    [[nodiscard]] std::optional<Error_code> expected_refusal(const Operation_of<d>& o) const;
    [[nodiscard]] bool renews_tolerances(Kind kind, Error_code code) const;
    void make(const Operation_of<d>& o);
    void go_on(const Operation_of<d>& o);
    void call(const Operation_of<d>& o);
    void follow(const Operation_of<d>& o);

    Setting setting_;
    std::optional<Moving> dt_;
    std::optional<Mesh_twin<d>> twin_;
    Sites_of<d> sites_;
    std::vector<typename Moving::Vertex_handle> handles_;
    std::vector<Index> free_indices_;
    typename Moving::Vertex_handle inserted_;
    Move_result last_;
    Coverage coverage_;
    bool refused_ = false;
    bool wrecked_ = false;
};

using Session = Session_of<2>;
using Session_3 = Session_of<3>;

extern template class Session_of<2>;
extern template class Session_of<3>;

}  // namespace annulus::oracle
