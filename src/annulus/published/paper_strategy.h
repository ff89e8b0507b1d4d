// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/displacement.h>
#include <annulus/engine/rebuild_strategy.h>
#include <annulus/published/least_tolerance.h>
#include <annulus/published/paper_tolerances.h>
#include <annulus/published/relocation.h>

#include <random>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The paper's filtering algorithm (its 3.2), one vertex at a time: the strategy `paper`; and `paper-hybrid`, which
/// rebuilds until the motion is slow enough for it (4.2).
///
/// Every vertex has a fixed position f, a moving position m, a tolerance eps and D = |m - f|. For a vertex with D <
/// eps only the position is written. Any other vertex enters a queue. Each vertex h taken from the queue is relocated
/// (3.1), so that f = m and D = 0. The certificates that it then has lower the eps of their points, and points that no
/// longer have D < eps enter the queue. A vertex is relocated at most once per call (its D is 0 from then on), so the
/// queue ends.
///
/// With safe regions a vertex taken from the queue is not relocated if m is on its side of the delimiter of each of
/// its bi-cells. It is tested again when it moves, or when one of its bi-cells is new.
///
/// The mesh is Delaunay at the fixed positions at all times. It is Delaunay at the moving ones if tolerances are
/// certified and there are no safe regions, which are in plain double. A tolerance that is too large gives a wrong
/// answer at the moving positions, but never breaks the mesh. In 3D tolerances of the kind `paper` are too large
/// (docs/theory.md 3).
template <int d>
class Paper_strategy : public Rebuild_strategy<d> {
  public:
    /// Precondition: `choice` has tolerances. `seed` is for the samples when `choice` rebuilds first.
    Paper_strategy(Delaunay_mesh<d>& mesh, const Paper_choice& choice, Tolerance_kind kind, std::uint64_t seed)
        : Rebuild_strategy<d>(mesh, choice.strategy()),
          relocation_(mesh, choice),
          tolerances_(mesh.table(), kind),
          safe_region_(choice.safe_region && d == 2),
          random_(seed) {}

    void move(Index v, const Coordinates<d>& p, Move_result& report) override;
    /// Recomputes every tolerance, with x as fixed and moving positions. When it throws, no position was written.
    /// O(n).
    void recompute_tolerances(std::span<const Coordinates<d>> x, Move_result& report);
    void begin(std::span<const Coordinates<d>> x, Move_result& report) override;
    void refresh_all(Move_result& report) override { begin(this->position_, report); }
    /// Whether, of 40 random vertices, 75 % (55 % in 3D) have a tolerance above their displacement to x (paper 4.2).
    /// Preconditions: it still rebuilds, and the mesh has cells.
    [[nodiscard]] bool sample_stays(std::span<const Coordinates<d>> x, Move_result& report);
    /// Switches to tolerances if sample_stays(x). Checks at every fourth time step (paper 4.2).
    void before_step(std::span<const Coordinates<d>> x, Move_result& report) override;
    void refresh(std::span<const Cell_index> cells, Move_result& report) override;
    void add_vertex(Index v, const Coordinates<d>& p) override;

    void begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) override;
    void commit_transaction(Move_result& report) override;
    void rollback() noexcept override;
    void resume_at_delaunay_positions() override;
    void clear_position(Index v) noexcept override;
    [[nodiscard]] std::span<const Coordinates<d>> delaunay_positions() const override {
        const bool at_fixed = has_switched() && (safe_region_ || tolerances_.kind() != Tolerance_kind::certified);
        return at_fixed ? std::span<const Coordinates<d>>(state_.fixed) : this->positions();
    }

    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override {
        return has_switched() ? state_.fixed[at(v)] : this->position_[at(v)];
    }
    [[nodiscard]] std::optional<double> tolerance(Index v) const override {
        return has_switched() ? std::optional(std::max(0.0, state_.epsilon[at(v)])) : std::nullopt;
    }
    [[nodiscard]] bool repairs() const override { return has_switched(); }
    [[nodiscard]] bool is_sequential() const override { return has_switched(); }
    /// A vertex that is inserted at the moving positions would have cells that need not be Delaunay at the fixed
    /// ones.
    [[nodiscard]] bool trusted() const override { return !has_switched(); }

  private:
    using Rebuild_strategy<d>::at;
    [[nodiscard]] bool has_switched() const { return this->strategy() == Strategy::paper; }
    [[nodiscard]] bool passes(Index v) const {
        const Coordinates<d>& p = this->position_[at(v)];
        return squared_distance<d>(p, state_.fixed[at(v)]) < state_.threshold[at(v)] || p == state_.fixed[at(v)];
    }
    void resize();
    void forget_queue() noexcept;
    void compute_tolerances(Move_result& report);
    void set_tolerance(Index v, double tolerance);
    void set_unlimited(Index v);
    void lower(Index v, double tolerance);
    void lower_points();
    void process(Index h, Move_result& report, bool first);
    [[nodiscard]] bool is_in_safe_region(Index h) const;
    [[nodiscard]] bool stays(std::span<const Coordinates<d>> x, Index v, Move_result& report);
    [[nodiscard]] bool is_taken(Index h) const;
    void rebuild();
    void begin_again(Move_result& report);

    /// Indexed by vertex.
    struct State {
        std::vector<Coordinates<d>> fixed;
        std::vector<double> epsilon;
        std::vector<double> threshold;  // epsilon squared, rounded down
    };
    struct Queue {
        std::vector<Index> vertex;
        std::vector<char> has;  // by vertex
    };
    struct Switch {
        std::uint64_t steps = 0;
        bool fresh = false;  // switched to tolerances in a time step that has not ended
    };

    Relocation<d> relocation_;
    Paper_tolerances<d> tolerances_;
    bool safe_region_;
    State state_;
    State saved_;  // before the time step
    Queue queue_;
    Least_tolerance least_;  // of the certificates being evaluated
    Switch switch_;
    std::mt19937_64 random_;
};

extern template class Paper_strategy<2>;
extern template class Paper_strategy<3>;

}  // namespace annulus::inline v1
