// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/least_tolerance.h>
#include <annulus/engine/mender.h>
#include <annulus/engine/move_report.h>
#include <annulus/engine/prices.h>
#include <annulus/mesh/certificates.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <span>
#include <vector>

namespace annulus {

/// Makes every suspected certificate hold at given positions: evaluates, mends what is violated (Mender), takes a vertex that moved alone
/// out and puts it back in; or says that it cannot, and the caller rebuilds.
///
/// A caller names the certificates that are not known to hold at the positions x (`suspect_*`), with all others proved
/// there. After `mend_all` or `mend_one` every certificate of the triangulation holds at x, hence it is Delaunay there (theory 1), and
/// `facets()` and `cells()` list every certificate that was evaluated or created, with its verdict at x. Nothing but
/// signs is trusted on the way: flips are a heuristic that either ends with every certificate positive, or not.
template <int d>
class Repair {
  public:
    /// One certificate under examination.
    template <class Id, class Points>
    struct Suspect {
        Id id;
        std::uint32_t next = 0;  ///< suspect of the same cell
        Points point{};     ///< its points, in the order of the determinant
        Facet_kind kind{};  ///< of a facet; a cell has `nothing` when it is infinite, else `empty_sphere`
        bool stale = true;  ///< verdict not computed for its present points
        Verdict verdict;
    };
    using Facet_suspect = Suspect<Corner_index, Facet_points<d>>;
    using Cell_suspect = Suspect<Cell_index, Cell_points<d>>;

    /// `trusted`: the triangulation is Delaunay at the old positions whenever mend_one() is called, so that a vertex may
    /// be taken out and put back in.
    Repair(Delaunay_mesh<d>& mesh, Tolerance_kind kind, bool trusted)
        : mesh_(mesh), mender_(mesh), kind_(kind), trusted_(trusted) {}

    /// For evaluations and signs. Verdicts and counters do not depend on it.
    void set_threads(int threads) {
        threads_ = threads;
        mender_.set_threads(threads);
    }

    /// Starts an examination at positions x (one for every vertex index). x must outlive it and change in mend_one() only. `many`: x
    /// differs from where the triangulation was Delaunay last in more than one vertex.
    void begin(std::span<const Coordinates<d>> x, bool many = true);
    void suspect_facet(Corner_index f);
    void suspect_cell(Cell_index c);

    /// Every certificate of the triangulation, and every one that contains v.
    void suspect_everything();
    void suspect_star(Index v);
    /// Every certificate of these cells and of their facets.
    void suspect_cells(std::span<const Cell_index> cells);

    /// Evaluates what is stale, in one batch. True when all suspects hold and the border winds once.
    ///
    /// Signs alone do not exclude a surface that winds several times (a pentagon permuted into a pentagram turns left
    /// everywhere). With all cells positive and the border locally convex, everything is embedded if and only if the
    /// border turns once (docs/theory.md 1.2). Cells and ridges proved by tolerances keep it turning once, and so does
    /// a single vertex that leaves its cells positive; so the border is walked, O(hull), only when many moved and a
    /// cell or ridge had to be evaluated, or when cells with infinity changed. In space a ridge, whatever the cells, and
    /// after flips only when they changed the border.
    [[nodiscard]] bool evaluate();

    /// When every certificate that contains v, the only vertex that moved, holds strictly: true, and `least` has noted their
    /// tolerances; they are not kept, so `facets()` and `cells()` lack them. Otherwise, and always for the kind `paper`,
    /// false, and nothing has been noted or counted: suspect_star(v) and evaluate() are to tell.
    [[nodiscard]] bool star_holds(Index v, Least_tolerance& least);

    /// The same for every certificate of the triangulation, none of which need be named, by signs alone: `facets()` and `cells()` stay
    /// empty. Gives up, with false, when that costs more than `most` (in cells looked at), or mending
    /// clearly would; it then refuses to mend.
    [[nodiscard]] bool evaluate_everything(double most);
    /// The same for every certificate that contains v, the only vertex that moved.
    [[nodiscard]] bool evaluate_star(Index v);

    /// Repairs after `evaluate` or one of its kind returned false. False: it would cost more than `most` (in cells looked at), or led
    /// nowhere; then the table is of no use any more, and all is to be rebuilt at x. `old` has the positions of before.
    [[nodiscard]] bool mend_all(std::span<const Coordinates<d>> old, double most);
    /// The same after v alone moved, from `old`. x is what begin() was given, and changes for a while. Throws
    /// Error(collision), with nothing changed but numbers of cells, when another vertex is where v goes. Where flips would
    /// be dearer, v is taken out and put back in.
    [[nodiscard]] bool mend_one(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& old, double most);

    /// What this examination cost without evaluations, in cells looked at.
    [[nodiscard]] double price() const { return mender_.price() + aside_; }
    /// What evaluations cost, or will of what is suspected as yet, the later stages of those that have been made included.
    [[nodiscard]] double evaluation_price() const {
        return Prices<d>::evaluation * static_cast<double>(facets_.size() + cells_.size()) +
               interval_evaluation_price * static_cast<double>(report_.arithmetic.interval - counted_.interval) +
               exact_evaluation_price * static_cast<double>(report_.arithmetic.exact - counted_.exact);
    }
    [[nodiscard]] std::span<const Facet_suspect> facets() const { return facets_; }
    [[nodiscard]] std::span<const Cell_suspect> cells() const { return cells_; }
    /// Vertices of certificates that were found violated, and those around which cells were built anew, of this examination.
    [[nodiscard]] std::span<const Index> disturbed() const { return disturbed_; }
    [[nodiscard]] std::span<const Index> reinserted() const { return reinserted_; }
    /// Cells that were made or changed, some perhaps gone again.
    [[nodiscard]] std::span<const Cell_index> changed_cells() const { return changed_; }
    /// Cells whose numbers, and those of their facets, are others than before a collision was found, though they are the same cells.
    [[nodiscard]] std::span<const Cell_index> renumbered() const { return renumbered_; }
    /// Counters of this examination.
    [[nodiscard]] const Move_report& report() const { return report_; }

    /// False for an entry whose facet or cell did not survive the repair.
    [[nodiscard]] bool exists(const Facet_suspect& s) const { return !mending_ || mesh_.table().is_facet(s.id); }
    [[nodiscard]] bool exists(const Cell_suspect& s) const { return !mending_ || mesh_.table().is_cell(s.id); }
    [[nodiscard]] Tolerance_kind kind() const { return kind_; }

  private:
    /// Where a suspect is: 1 + twice its place among facets, or 2 + twice that among cells. 0: nowhere.
    using Place = std::uint32_t;
    [[nodiscard]] static Place facet_place(std::size_t i) { return 2 * static_cast<Place>(i) + 1; }
    [[nodiscard]] static Place cell_place(std::size_t i) { return 2 * static_cast<Place>(i) + 2; }
    [[nodiscard]] static bool is_facet_place(Place p) { return (p & 1U) != 0; }
    [[nodiscard]] static std::size_t place(Place p) { return (p - 1) / 2; }
    [[nodiscard]] Place next(Place p) const { return is_facet_place(p) ? facets_[place(p)].next : cells_[place(p)].next; }
    template <class S>
    void enter(S& s, Cell_index cell, Place place);
    [[nodiscard]] Facet_suspect& suspected_facet(Corner_index f);
    [[nodiscard]] Cell_suspect& suspected_cell(Cell_index c);
    void describe(Facet_suspect& s, Corner_index f) const;
    void describe(Cell_suspect& s, Cell_index c) const;
    void assign_places();
    [[nodiscard]] double paper_tolerance(const Facet_suspect& s) const;
    template <class S>
    [[nodiscard]] Stage_counts evaluate_run(std::span<S> suspects) const;
    template <class S>
    void evaluate_stale(std::span<S> suspects);
    /// The certificate does not hold. A degenerate sphere is decided by the perturbation, once its cells are positive.
    [[nodiscard]] bool violated(const Facet_suspect& s) const;
    [[nodiscard]] bool violated(const Cell_suspect& s) const { return s.verdict.sign <= 0; }
    [[nodiscard]] bool certified() const { return kind_ == Tolerance_kind::certified; }
    [[nodiscard]] Mode mode() const { return certified() ? Mode::fast : Mode::floating; }
    void collect_violated();
    void note_disturbed(const Facet_points<d>& points);
    [[nodiscard]] bool signs_hold(double most);
    [[nodiscard]] bool border_in_doubt() const;
    [[nodiscard]] bool border_holds();
    [[nodiscard]] bool mend(const Course<d>& course, double most);
    [[nodiscard]] bool holds_after_mending(double most);
    [[nodiscard]] bool reinsert(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& goal, double price);
    void forget();
    [[nodiscard]] bool collides(Index v, const Coordinates<d>& home);
    [[nodiscard]] double reinsertion_price(Index v) const;
    void count_signs();

    Delaunay_mesh<d>& mesh_;
    Mender<d> mender_;
    Tolerance_kind kind_;
    bool trusted_;
    int threads_ = 1;
    bool many_ = true;    // vertices moved
    bool signs_ = false;  // are examined: evaluate_everything, evaluate_star
    bool hopeless_ = false;  // it would cost more than it may, by a sample
    double aside_ = 0.0;     // of the price, what mender_ does not know: the border, collisions, reinsertion
    Stage_counts counted_;  // of what mender_ asked
    std::span<const Coordinates<d>> x_;
    std::vector<Facet_suspect> facets_;
    std::vector<Cell_suspect> cells_;
    By_cell<Place> suspects_of_;  // the first of itself and its facets, which lead to the others
    bool placed_ = true;    // false: these are still to be filled in; a star has no certificate twice
    std::vector<Index> reinserted_;
    std::vector<Cell_index> changed_;
    std::vector<Cell_index> renumbered_;
    bool mending_ = false;  // the triangulation may differ from what it was at the beginning
    std::vector<Index> disturbed_;
    struct Star {
        std::vector<Cell_points<d>> simplex;
        std::vector<Tuple<d, d + 1>> orientation;
        std::vector<Facet_points<d>> bicell;
        std::vector<Tuple<d, d + 2>> empty_sphere;
        void clear() {
            simplex.clear();
            orientation.clear();
            bicell.clear();
            empty_sphere.clear();
        }
    };
    Star star_;
    std::vector<Verdict> verdict_;
    Move_report report_;
};

extern template class Repair<2>;
extern template class Repair<3>;

}  // namespace annulus
