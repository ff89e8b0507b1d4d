// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_checker.h>
#include <annulus/engine/certificate_expiries.h>
#include <annulus/engine/displacement.h>
#include <annulus/engine/step.h>

#include <algorithm>
#include <span>
#include <vector>

namespace annulus {

/// Remaining displacement budget of each vertex: the tolerances of a mesh whose certificates were evaluated at
/// different times.
///
/// Every vertex has a path length: `base` is an upper bound of the length of the path of its fixed positions since it
/// was at 0, and its path length is base + |moving - fixed|. A certificate evaluated when its points read r_i and found
/// to have tolerance s holds while every path length stays below its expiry r_i + s, because a path length bounds the
/// distance travelled, hence the distance from where the point was when the certificate was evaluated. Different
/// certificates have different references, which theory 1 allows: it asks that each holds now. A vertex keeps the
/// earliest expiries among its certificates (Expiry_list), so its step test compares |moving - fixed|^2 with one
/// number. When it fails its fixed position becomes the moving one (it is anchored), those of its certificates that
/// expired are suspected, and once they have been evaluated (Repair) their points are anchored too and get new
/// expiries. Soundness: docs/theory.md 5.
///
/// While none are kept all of it is void, and its memory given back.
template <int d>
class Displacement_budget {
  public:
    explicit Displacement_budget(const Corner_table<d>& table) : table_(table) {}

    [[nodiscard]] bool kept() const { return kept_; }
    /// They are not to be trusted any more.
    void invalidate() noexcept { kept_ = false; }
    /// And their memory is given back.
    void drop() noexcept;

    /// Starts afresh at x: no certificate expires, until commit_fresh() has been told of it. O(n).
    void begin(std::span<const Coordinates<d>> x);
    /// What Certificate_checker evaluated there; no certificate that it names has an expiry.
    void commit_fresh(const Certificate_checker<d>& checker);
    /// Then the step test may be asked.
    void finish_beginning();

    /// A vertex that was not there, or none of whose certificates there are any more, is at p.
    void add_vertex(Index v, const Coordinates<d>& p);
    /// Room for the vertices and cells that there are.
    void resize();

    /// The fixed position.
    [[nodiscard]] const Coordinates<d>& fixed(Index v) const { return vertex_[at(v)].fixed; }
    /// How far v may be from there (proofs/coq/float_displacement.v, passes_2_sound).
    [[nodiscard]] double slack(Index v) const {
        const List& list = list_[at(v)];
        return (list.earliest().path_length() - list.base) * (1.0 - 0x1p-50);
    }
    /// The step test of one vertex.
    [[nodiscard]] bool passes(Index v, const Coordinates<d>& p) const {
        const Vertex_record<d>& r = vertex_[at(v)];
        return squared_distance<d>(p, r.fixed) < r.threshold.value() || p == r.fixed;
    }
    /// The step test of vertices [first, last): appends those that left their tolerances. False, with the list
    /// unspecified, when a coordinate is outside the domain, or is none at all, be it at a free index.
    [[nodiscard]] bool find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last,
                                   std::vector<Index>& failed) const;

    /// Takes what is due: anchors those that failed, and names their certificates that expired to Certificate_checker.
    void find_expired(Step<d>& step, Certificate_checker<d>& checker);
    /// Takes that back.
    void undo(const Step<d>& step);
    /// Writes down what was evaluated or created; the mesh is Delaunay at step.x.
    void commit(Step<d>& step, const Certificate_checker<d>& checker);
    /// Before what find_expired() is not called for: certificates that others name are about to be evaluated.
    void begin_anchoring(Step<d>& step);

  private:
    friend struct Trace;  // trace.h
    using List = Vertex_expiries<d>;

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// Path length of v at x: an upper bound.
    [[nodiscard]] double path_length(Index v, const Coordinates<d>& x) const {
        return sum_upper(list_[at(v)].base, distance_upper<d>(x, vertex_[at(v)].fixed));
    }
    void set_threshold(Index v) {
        vertex_[at(v)].threshold = Truncated_double::lower(squared_threshold_lower(slack(v)));
    }
    void anchor(Index v, Step<d>& step);
    void check_expiry(Certificate_id id, Index v, Certificate_checker<d>& checker);
    void visit_star(Index v, Step<d>& step, Certificate_checker<d>& checker);
    void rebase(Index v);
    template <class Points>
    void prefetch(const Points& points) const;
    /// `fresh`: no certificate in question is on any list, and no vertex is anchored.
    template <bool fresh>
    void commit_evaluated(const Certificate_checker<d>& checker, Step<d>* step);
    template <bool fresh, class S, class Expiry_of>
    void commit_points(const S& suspect, Certificate_id id, Expiry_of expiry_of, Step<d>* step);

    const Corner_table<d>& table_;
    bool kept_ = false;
    std::vector<Vertex_record<d>> vertex_;
    std::vector<List> list_;  // by vertex
    Certificate_expiries<d> expiries_;
    std::uint32_t stamp_ = 0;  // of Expiry_list::stamp
    struct Tour {
        std::vector<std::uint32_t> certificates;  // 2 half-facet, or 2 corner + 1
        std::vector<Expiry> listed;               // not reached
        std::vector<Certificate_id> listed_id;
    } tour_;
};

extern template class Displacement_budget<2>;
extern template class Displacement_budget<3>;

}  // namespace annulus
