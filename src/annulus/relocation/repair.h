// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/relocation/least_tolerance.h>
#include <annulus/relocation/move_report.h>
#include <annulus/triangulation/certificates.h>
#include <annulus/triangulation/embedding.h>
#include <annulus/triangulation/flips_3.h>

#include <span>
#include <vector>

namespace annulus {

/// A flip, as far as it takes to undo it: in the plane the two cells, which it keeps; in space the vertices of the cells that
/// went and of those that came.
template <int d>
struct Flip_record;
template <>
struct Flip_record<2> {
    Index one, other;
};
template <>
struct Flip_record<3> {
    std::vector<Cell_points<3>> gone, came;
};

/// Makes every suspected certificate hold at given positions: evaluates, flips what is violated, takes out and puts
/// back what flips cannot reach, rebuilds as the last resort.
///
/// A caller names the certificates that are not known to hold at the positions x (`suspect_*`), with all others proved
/// there. After `mend` every certificate of the triangulation holds at x, hence it is Delaunay there (theory 1), and
/// `facets()` and `cells()` list every certificate that was evaluated or created, with its verdict at x. Nothing but
/// signs is trusted on the way: flips are a heuristic that either ends with every certificate positive or is undone.
template <int d>
class Repair {
  public:
    /// One certificate under examination.
    template <class Points>
    struct Suspect {
        Index id = none;    ///< facet or cell
        Points point{};     ///< its points, in the order of the determinant
        Facet_kind kind{};  ///< of a facet; a cell has `border` when it is infinite, else `empty_sphere`
        bool stale = true;  ///< verdict not computed for its present points
        Verdict verdict;
    };
    using Facet_suspect = Suspect<Facet_points<d>>;
    using Cell_suspect = Suspect<Cell_points<d>>;

    /// `trusted`: CGAL's object is Delaunay at its points whenever mend() is called, so that CGAL may remove and insert.
    Repair(Embedding<d>& embedding, Tolerance_kind kind, bool trusted)
        : embedding_(embedding), kind_(kind), trusted_(trusted) {}

    /// Starts an examination at positions x (one for every vertex index). x must outlive it and not change. `many`: x
    /// differs from where the triangulation was Delaunay last in more than one vertex.
    void begin(std::span<const Coordinates<d>> x, bool many = true);
    void suspect_facet(Index f);
    void suspect_cell(Index c);
    /// The same for a facet whose points and kind the caller has at hand.
    void suspect_facet(Index f, Facet_kind kind, const Facet_points<d>& points);

    /// Every certificate of the triangulation, and every one that contains v.
    void suspect_everything();
    void suspect_star(Index v);
    /// Every certificate of these cells and of their facets.
    void suspect_cells(std::span<const Index> cells);

    /// Evaluates what is stale, in one batch. True when all suspects hold and the border winds once.
    ///
    /// Signs alone do not exclude a surface that winds several times (a pentagon permuted into a pentagram turns left
    /// everywhere). With all cells positive and the border locally convex, everything is embedded if and only if the
    /// border turns once (docs/theory.md 1.2). Cells and ridges proved by tolerances keep it turning once, and so does
    /// a single vertex that leaves its cells positive; so the border is walked, O(hull), only when many moved and a
    /// cell or ridge had to be evaluated, or when inverted cells were unfolded. In space a ridge, whatever the cells, and
    /// after flips only when they changed the border.
    [[nodiscard]] bool evaluate();

    /// When every certificate that contains v, the only vertex that moved, holds strictly: true, and `least` has noted their
    /// tolerances; they are not kept, so `facets()` and `cells()` lack them. Otherwise, and always for the kind `paper`,
    /// false, and nothing has been noted or counted: suspect_star(v) and evaluate() are to tell.
    [[nodiscard]] bool star_holds(Index v, Least_tolerance& least);

    /// The same for every certificate of the triangulation, none of which need be named: those that clearly hold are
    /// not kept, so `facets()` and `cells()` lack them.
    [[nodiscard]] bool evaluate_everything();
    /// The same for every certificate that contains v, the only vertex that moved.
    [[nodiscard]] bool evaluate_star(Index v);

    /// Whether flips reached a triangulation all of whose certificates hold.
    enum class Progress { done, stuck };

    /// What `mend` came to.
    enum class Outcome { flipped, reinserted, rebuilt };

    /// Repairs after `evaluate` returned false. `old` has the positions where CGAL's object is Delaunay now;
    /// `movers` the vertices where x differs from it (empty: any). On return CGAL's points are x if anything was
    /// reinserted or rebuilt, else still `old`. Throws Error(collision), with the triangulation as it was, when two
    /// vertices share a position in x.
    Outcome mend(std::span<const Coordinates<d>> old, std::span<const Index> movers);

    [[nodiscard]] std::span<const Facet_suspect> facets() const { return facets_; }
    [[nodiscard]] std::span<const Cell_suspect> cells() const { return cells_; }
    /// Vertices of certificates that were found violated, and those taken out and put back, of this examination.
    [[nodiscard]] std::span<const Index> disturbed() const { return disturbed_; }
    [[nodiscard]] std::span<const Index> reinserted() const { return detached_; }
    /// Cells that flips, removal or insertion created or changed, some perhaps gone again; void after a rebuild.
    [[nodiscard]] std::span<const Index> changed_cells() const { return changed_; }
    /// Appends the vertices of the cells that flips, removal or insertion created or changed, and that there still are, to
    /// report.changed; of every cell after a rebuild.
    void list_changes(Move_report& report) const;
    /// Counters of this examination.
    [[nodiscard]] const Move_report& report() const { return report_; }

    /// False for an entry whose facet or cell did not survive the repair.
    [[nodiscard]] bool exists(const Facet_suspect& s) const { return !mending_ || embedding_.table().is_facet(s.id); }
    [[nodiscard]] bool exists(const Cell_suspect& s) const { return !mending_ || embedding_.table().is_cell(s.id); }
    [[nodiscard]] Tolerance_kind kind() const { return kind_; }

  private:
    template <class Suspects>
    [[nodiscard]] typename Suspects::value_type& suspected(Suspects& suspects, std::vector<Index>& places, Index id);
    void describe(Facet_suspect& s, Index f, Index h) const;
    void describe(Cell_suspect& s, Index c) const;
    void assign_places();
    [[nodiscard]] const Facet_suspect& examine_facet(Index f);
    [[nodiscard]] const Cell_suspect& examine_cell(Index c);
    /// Filter stage; false when the next stage must be asked. Flattened: what is instantiated in other files too may come
    /// from one that is compiled for less speed.
    [[nodiscard, gnu::flatten]] bool filter(Facet_suspect& s) const;
    [[nodiscard, gnu::flatten]] bool filter(Cell_suspect& s) const;
    [[nodiscard]] bool interval(Facet_suspect& s) const;
    [[nodiscard]] bool interval(Cell_suspect& s) const;
    void exact(Facet_suspect& s) const;
    void exact(Cell_suspect& s) const;
    template <class S>
    void evaluate_stale(std::vector<S>& suspects);
    template <class S>
    void decide(S& s);
    [[nodiscard]] std::uint64_t ask_signs(Index c);
    void count_clear(std::uint64_t halves);
    /// The certificate does not hold. A degenerate sphere is decided by the perturbation, once its cells are positive.
    [[nodiscard]] bool violated(const Facet_suspect& s) const;
    [[nodiscard]] bool violated(const Cell_suspect& s) const { return s.verdict.sign <= 0; }
    [[nodiscard]] bool certified() const { return kind_ == Tolerance_kind::certified; }
    void suspect_around(std::span<const Index> cells);
    void collect_violated();
    void forget();
    Progress run_flips();
    bool unfold(Index c);
    [[nodiscard]] bool border_winds_once() const;
    bool flip_is_simplicial(Index h) const;
    void flip(Index h);
    /// In space: makes the flip; `created` receives its new cells. The new cells may be inverted.
    void flip(const Flip_3& flip, std::vector<Index>& created);
    /// Makes a flip that mends the violated facet at half-facet h, if there is one that leaves all its cells positive.
    [[nodiscard]] bool mend_facet(Index h);
    /// The number of these cells that are not positive; infinite ones are.
    [[nodiscard]] std::size_t inverted_among(std::span<const Cell_points<d>> cells) const;
    /// Takes all flips of the log back, the last one first.
    void take_back_flips();
    void undo_flips();
    [[nodiscard]] bool reinsert(std::span<const Coordinates<d>> old, std::span<const Index> movers);
    [[nodiscard]] Index vertex_to_detach(std::span<const Index> points, std::span<const Coordinates<d>> old,
                                         std::span<const Index> movers) const;
    [[nodiscard]] bool take_out(Index v, std::size_t most);
    void suspect_unfolding();
    [[nodiscard]] bool take_out_stuck(std::span<const Coordinates<d>> old, std::span<const Index> movers,
                                      std::size_t most);
    void require_distinct(std::span<const Index> movers) const;

    Embedding<d>& embedding_;
    Tolerance_kind kind_;
    bool trusted_;
    bool many_ = true;         // vertices moved
    bool everything_ = false;  // is examined: evaluate_everything
    std::span<const Coordinates<d>> x_;
    std::vector<Facet_suspect> facets_;
    std::vector<Cell_suspect> cells_;
    std::vector<Index> place_of_facet_;  // facet -> 1 + place in facets_, 0 when absent
    std::vector<Index> place_of_cell_;
    bool placed_ = true;    // false: these are still to be filled in; a star has no certificate twice
    bool mending_ = false;  // the triangulation may differ from what it was at the beginning
    std::vector<Index> disturbed_;
    std::vector<Index> detached_;
    std::vector<Index> changed_;  // cells, some perhaps gone again; not kept up once all are rebuilt
    bool rebuilt_ = false;
    std::vector<Index> queue_;            // facets to look at
    std::vector<Index> inverted_;         // cells to unfold
    std::vector<Facet_points<d>> stuck_;  // points of the facets that no flip could mend
    std::vector<Flip_record<d>> log_;     // every flip, in order
    std::vector<Index> unresolved_;
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

// Flips are what the dimensions do not share: repair_2.cpp, repair_3.cpp.
template <>
bool Repair<2>::flip_is_simplicial(Index h) const;
template <>
bool Repair<2>::unfold(Index c);
template <>
Repair<2>::Progress Repair<2>::run_flips();
template <>
bool Repair<2>::border_winds_once() const;
template <>
void Repair<2>::flip(Index h);
template <>
void Repair<2>::take_back_flips();

template <>
bool Repair<3>::unfold(Index c);
template <>
void Repair<3>::flip(const Flip_3& flip, std::vector<Index>& created);
template <>
bool Repair<3>::mend_facet(Index h);
template <>
std::size_t Repair<3>::inverted_among(std::span<const Cell_points<3>> cells) const;
template <>
Repair<3>::Progress Repair<3>::run_flips();
template <>
bool Repair<3>::border_winds_once() const;
template <>
void Repair<3>::take_back_flips();

extern template class Repair<2>;
extern template class Repair<3>;

}  // namespace annulus
