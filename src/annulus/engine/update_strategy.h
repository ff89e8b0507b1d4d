// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/engine/move_report.h>
#include <annulus/engine/options.h>
#include <annulus/mesh/index.h>

#include <optional>
#include <span>

namespace annulus {

/// A strategy at work: owns the positions of the vertices and keeps the triangulation right at them.
///
/// What throws leaves positions() as they were, unless it says otherwise; the triangulation and all else is then
/// unspecified but after Error(duplicate_point), after which it is right. Engine rebuilds after the others.
template <int d>
class Update_strategy {
  public:
    explicit Update_strategy(Strategy strategy) : strategy_(strategy) {}
    virtual ~Update_strategy() = default;
    /// The one in force.
    [[nodiscard]] Strategy strategy() const { return strategy_; }
    /// Whether a time step is a move of one vertex after another (`move_sequentially`); else it is `move_all`.
    [[nodiscard]] virtual bool is_sequential() const = 0;
    /// Whether the mesh is Delaunay at positions() for certain, so that a vertex may be inserted or removed there.
    [[nodiscard]] virtual bool trusted() const { return true; }

    /// Takes the present triangulation and positions x as given and Delaunay. When it throws, no position was
    /// written. O(n).
    virtual void begin(std::span<const Coordinates<d>> x, Move_report& report) = 0;
    /// Makes every tolerance fresh, where any are kept. O(n).
    virtual void refresh_all(Move_report& report) = 0;
    /// After all cells were replaced by other hands.
    virtual void refresh_rebuilt(Move_report& report) { refresh_all(report); }

    [[nodiscard]] virtual std::span<const Coordinates<d>> positions() const = 0;
    /// Where D is measured from; the position for strategies without tolerances. Precondition: dimension d.
    [[nodiscard]] virtual const Coordinates<d>& fixed_position(Index v) const = 0;
    /// How far v may be from there while every other vertex is within its own tolerance; nothing while none are kept.
    [[nodiscard]] virtual std::optional<double> tolerance(Index v) const = 0;
    /// Whether it repairs the mesh, for which there have to be cells of dimension d; others leave everything to the
    /// mesh.
    [[nodiscard]] virtual bool repairs() const = 0;

    /// A time step to x is about to begin.
    virtual void before_step(std::span<const Coordinates<d>> x, Move_report& report) {
        static_cast<void>(x);
        static_cast<void>(report);
    }
    /// Moves every vertex to x.
    virtual void move_all(std::span<const Coordinates<d>> x, Move_report& report) = 0;
    /// Moves one vertex. Precondition: p is in the coordinate domain.
    virtual void move(Index v, const Coordinates<d>& p, Move_report& report) = 0;

    /// The positions, for an insertion, with room for indices below the bound, and no more.
    [[nodiscard]] virtual std::span<Coordinates<d>> resize_for_insertion(std::size_t bound) = 0;
    /// The vertex takes position p; it was not in the triangulation, and is now.
    virtual void add_vertex(Index v, const Coordinates<d>& p) = 0;
    /// After these cells were replaced by other hands (insertion, removal) at the present positions.
    virtual void refresh(std::span<const Cell_index> cells, Move_report& report) = 0;
    /// Forgets what is at indices from this one on, or writes a position and nothing else; a rebuild and `begin` have
    /// to follow.
    virtual void truncate(std::size_t bound) = 0;
    virtual void restore_position(Index v, const Coordinates<d>& p) noexcept = 0;

    // A time step of single moves, which is taken back as a whole when one of them is refused.
    /// Notes the present state. x are where vertices are going to be.
    virtual void begin_transaction(std::span<const Coordinates<d>> x, Move_report& report) = 0;
    virtual void commit_transaction(Move_report& report) = 0;
    /// Single moves of it, which do not look whether tolerances pay.
    virtual void move_sequentially(Index v, const Coordinates<d>& p, Move_report& report) { move(v, p, report); }
    /// Positions, and what is kept with them, as noted.
    virtual void rollback() noexcept = 0;
    /// The positions at which the triangulation is Delaunay; after rollback(), at which it is to be rebuilt, before
    /// the rest.
    [[nodiscard]] virtual std::span<const Coordinates<d>> delaunay_positions() const { return positions(); }
    virtual void resume_after_rollback() = 0;

  protected:
    void set_strategy(Strategy strategy) noexcept { strategy_ = strategy; }

  private:
    Strategy strategy_;
};

}  // namespace annulus
