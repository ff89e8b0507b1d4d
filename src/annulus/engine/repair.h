// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_checker.h>
#include <annulus/engine/flip_repair.h>
#include <annulus/engine/sign_evaluator.h>
#include <annulus/engine/step.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <span>

namespace annulus::inline v1 {

/// Makes every certificate hold at the targets of a step: it evaluates, repairs what is violated (Flip_repair), and
/// reinserts a vertex that moved alone. Or it reports that it cannot, and the caller rebuilds. What it finds and
/// spends is in the step.
///
/// The caller adds the certificates that are not known to hold there to `checker()`; all others are proved. After
/// `repair_all` or `repair_one` succeeded, every certificate of the mesh holds, hence it is Delaunay (theory 1), and
/// `checker()` lists every certificate that was evaluated or created, with its value. Only signs are trusted on the
/// way: flips are a heuristic, which either ends with every certificate positive or fails.
template <int d>
class Repair {
  public:
    explicit Repair(Delaunay_mesh<d>& mesh)
        : mesh_(mesh), checker_(mesh.table()), signs_(mesh.table()), flip_repair_(mesh, signs_) {}

    /// For evaluations and signs. Values and counters do not depend on the number of threads.
    void set_threads(int threads) {
        checker_.set_threads(threads);
        signs_.set_threads(threads);
    }
    [[nodiscard]] Certificate_checker<d>& checker() { return checker_; }
    [[nodiscard]] const Certificate_checker<d>& checker() const { return checker_; }

    /// Starts an examination at step.x: nothing is pending and nothing is found yet. The step must outlive it.
    void begin(Step<d>& step);

    /// Evaluates what is pending, in one batch. True when all of it holds and the border winds once. False, with
    /// nothing evaluated but signs of cells, for a single mover that goes so far that it is going to be reinserted.
    ///
    /// Signs alone do not exclude a surface that winds several times (a pentagon permuted into a pentagram turns left
    /// everywhere). With all cells positive and the border locally convex, everything is embedded if and only if the
    /// border turns once (docs/theory.md 1.2). Cells and ridges proved by tolerances keep it turning once, and so
    /// does a single vertex that leaves its cells positive. So the border is walked, O(hull), only when many vertices
    /// moved and a cell or ridge had to be evaluated, or when cells with infinity changed. In 3D only an evaluated
    /// ridge counts, not a cell, and after flips only if these changed the border.
    [[nodiscard]] bool evaluate(Step<d>& step);
    /// Whether the step has cost no more than `most` after that, judging by how many there are and, once a few of them
    /// have been evaluated, by what the stages after the filter cost.
    [[nodiscard]] bool can_evaluate(Step<d>& step, double most);
    /// The same as evaluate() for all certificates of the mesh, by signs alone: the checker stays empty. Gives up, with
    /// false, when the cost exceeds the budget or repair clearly would; then it refuses to repair.
    [[nodiscard]] bool evaluate_everything(Step<d>& step);
    /// The same for every certificate that contains the mover of the step, regardless of the budget.
    [[nodiscard]] bool evaluate_star(Step<d>& step);

    /// Repairs after `evaluate` or one of its variants returned false. False: it exceeded the budget or led nowhere;
    /// then the table is of no use any more, and everything is to be rebuilt at the targets. `old` are the previous
    /// positions.
    [[nodiscard]] bool repair_all(Step<d>& step, std::span<const Coordinates<d>> old);
    /// The same after the mover of the step moved from step.source. x is step.x, and changes meanwhile. Throws
    /// Error(duplicate_point), with nothing changed but numbers of cells (step.renumbered), when another vertex is at
    /// its target. Where flips would be more expensive, it is removed and inserted again.
    [[nodiscard]] bool repair_one(Step<d>& step, std::span<Coordinates<d>> x);

    /// The cells that repair made or changed since begin(), each once; some may be gone again. Not those of a vertex
    /// that was reinserted.
    [[nodiscard]] std::span<const Cell_index> touched() const { return flip_repair_.result().touched; }

  private:
    void collect_violated(Step<d>& step);
    [[nodiscard]] bool signs_hold(Step<d>& step, double most);
    /// `by_signs`: certificates were tested that the checker does not list.
    [[nodiscard]] bool border_holds(Step<d>& step, bool many, bool by_signs);
    [[nodiscard]] bool repair(Step<d>& step, const Motion_path<d>& path);
    [[nodiscard]] bool holds_after_flips(Step<d>& step, const Repair_result& result);
    [[nodiscard]] bool reinsert(Step<d>& step, std::span<Coordinates<d>> x, const Coordinates<d>& target, double cost);
    [[nodiscard]] bool is_occupied(Step<d>& step);
    [[nodiscard]] bool goes_far(Index mover) const;
    void count(Step<d>& step, const Stage_counts& evaluated);

    Delaunay_mesh<d>& mesh_;
    Certificate_checker<d> checker_;
    Sign_evaluator<d> signs_;
    Flip_repair<d> flip_repair_;
};

extern template class Repair<2>;
extern template class Repair<3>;

}  // namespace annulus::inline v1
