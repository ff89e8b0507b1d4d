// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <optional>
#include <span>

namespace annulus::inline v1 {

/// An update strategy: owns the positions of the vertices and keeps the triangulation right at them.
///
/// A call that throws leaves positions() as they were, unless its comment says otherwise. The triangulation and all
/// else is then unspecified, except after Error(duplicate_point), when it is right. Engine rebuilds after the other
/// exceptions.
template <int d>
class Update_strategy {
  public:
    explicit Update_strategy(Strategy strategy) : strategy_(strategy) {}
    virtual ~Update_strategy() = default;
    /// The strategy in force.
    [[nodiscard]] Strategy strategy() const { return strategy_; }
    /// Whether a time step moves one vertex after another (`move_sequentially`); otherwise it is `move_all`.
    [[nodiscard]] virtual bool is_sequential() const = 0;
    /// Whether the mesh is certainly Delaunay at positions(), so that a vertex may be inserted or removed there.
    [[nodiscard]] virtual bool trusted() const { return true; }

    /// Takes the present triangulation and positions x as they are, as Delaunay. When it throws, no position was
    /// written. O(n).
    virtual void begin(std::span<const Coordinates<d>> x, Move_result& report) = 0;
    /// Whether `begin` computes every tolerance.
    [[nodiscard]] virtual bool begins_with_tolerances() const { return false; }
    /// Recomputes every tolerance, if tolerances are kept. O(n).
    virtual void refresh_all(Move_result& report) = 0;
    /// To be called after other code has replaced all cells.
    virtual void refresh_rebuilt(Move_result& report) { refresh_all(report); }

    [[nodiscard]] virtual std::span<const Coordinates<d>> positions() const = 0;
    /// The fixed position, from which D is measured; for strategies without tolerances the position. Precondition:
    /// dimension d.
    [[nodiscard]] virtual const Coordinates<d>& fixed_position(Index v) const = 0;
    /// How far v may be from there while every other vertex is within its own tolerance; nullopt while none are kept.
    [[nodiscard]] virtual std::optional<double> tolerance(Index v) const = 0;
    /// Whether it repairs the mesh, which requires cells of dimension d; other strategies leave everything to the
    /// mesh.
    [[nodiscard]] virtual bool repairs() const = 0;

    /// A time step to x is about to begin.
    virtual void before_step(std::span<const Coordinates<d>> x, Move_result& report) {
        static_cast<void>(x);
        static_cast<void>(report);
    }
    /// Moves every vertex to x.
    virtual void move_all(std::span<const Coordinates<d>> x, Move_result& report) = 0;
    /// Moves one vertex. Precondition: p is in the coordinate domain.
    virtual void move(Index v, const Coordinates<d>& p, Move_result& report) = 0;

    /// The positions, for an insertion, resized to the bound.
    [[nodiscard]] virtual std::span<Coordinates<d>> resize_for_insertion(std::size_t bound) = 0;
    /// Vertex v has position p; it was not in the triangulation, and is now.
    virtual void add_vertex(Index v, const Coordinates<d>& p) = 0;
    /// To be called after other code has replaced these cells (insertion, removal) at the present positions.
    virtual void refresh(std::span<const Cell_index> cells, Move_result& report) = 0;
    /// truncate() drops the positions from this index on; restore_position() writes one position and nothing else.
    /// After either, a rebuild and `begin` must follow.
    virtual void truncate(std::size_t bound) = 0;
    virtual void restore_position(Index v, const Coordinates<d>& p) noexcept = 0;
    /// v is no vertex any more: from now on its position is NaN.
    virtual void clear_position(Index v) noexcept = 0;

    // A time step of single moves, which is undone as a whole when one of them is refused.
    /// Saves the present state. x are the targets of the vertices.
    virtual void begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) = 0;
    virtual void commit_transaction(Move_result& report) = 0;
    /// A single move of such a time step, without a check whether tolerances pay.
    virtual void move_sequentially(Index v, const Coordinates<d>& p, Move_result& report) { move(v, p, report); }
    /// Restores the positions, and what is kept with them, as saved.
    virtual void rollback() noexcept = 0;
    /// The positions at which the triangulation is Delaunay; after rollback(), those at which it is to be rebuilt
    /// before anything else.
    [[nodiscard]] virtual std::span<const Coordinates<d>> delaunay_positions() const { return positions(); }
    virtual void resume_after_rollback() = 0;
    /// To be called after the cells have been rebuilt at delaunay_positions(), because positions() coincide:
    /// recomputes what is kept of them. positions() stay.
    virtual void resume_at_delaunay_positions() {}

  protected:
    void set_strategy(Strategy strategy) noexcept { strategy_ = strategy; }

  private:
    Strategy strategy_;
};

}  // namespace annulus::inline v1
