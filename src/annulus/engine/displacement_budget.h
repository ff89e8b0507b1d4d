// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_checker.h>
#include <annulus/engine/certificate_expiries.h>
#include <annulus/engine/displacement.h>
#include <annulus/engine/step.h>

#include <algorithm>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The displacement budget of every vertex: what is left of the tolerances of a mesh whose certificates were
/// evaluated at different times.
///
/// Every vertex has a path length base + |moving - fixed|, where `base` is an upper bound of the length of the path
/// of its fixed positions since `base` was 0. Let a certificate be evaluated when the path lengths of its points are
/// r_i, and let its tolerance be s. It holds while every path length stays below its expiry r_i + s, because a path
/// length bounds the distance travelled, hence the distance from where the point was when the certificate was
/// evaluated. Different certificates refer to different positions, which theory 1 allows: it only requires that each
/// holds now.
///
/// A vertex keeps the earliest expiries among its certificates (Expiry_list), so its step test compares |moving -
/// fixed|^2 with one number. When it fails, its fixed position becomes the moving one (it is anchored), and those of
/// its certificates that expired become pending. Once they have been evaluated (Repair), their points are anchored
/// too and get new expiries. Soundness: docs/theory.md 5.
///
/// While no budget is kept, all of it is void and its memory released.
template <int d>
class Displacement_budget {
  public:
    explicit Displacement_budget(const Corner_table<d>& table) : table_(table) {}

    [[nodiscard]] bool kept() const { return kept_; }
    /// Marks everything as void.
    void invalidate() noexcept { kept_ = false; }
    /// The same, and releases the memory.
    void drop() noexcept;

    /// Starts again at x: no certificate expires until commit_fresh() has written its expiry. O(n).
    void begin(std::span<const Coordinates<d>> x);
    /// Writes the expiries of what Certificate_checker evaluated there. Precondition: these certificates have none
    /// yet.
    void commit_fresh(const Certificate_checker<d>& checker);
    /// After this the step test may be used.
    void finish_beginning();

    /// Puts a vertex at p that is new, or none of whose old certificates exist any more.
    void add_vertex(Index v, const Coordinates<d>& p);
    /// Makes room for the vertices and cells of the table.
    void resize();

    /// The fixed position.
    [[nodiscard]] const Coordinates<d>& fixed(Index v) const { return vertex_[at(v)].fixed; }
    /// How far v may be from its fixed position (proofs/coq/float_displacement.v, passes_2_sound).
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
    /// unspecified, when a coordinate is outside the domain or not a number, even at a free index.
    [[nodiscard]] bool find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last,
                                   std::vector<Index>& failed) const;

    /// Anchors the vertices that failed, and adds their certificates that expired to the checker.
    void find_expired(Step<d>& step, Certificate_checker<d>& checker);
    /// Undoes find_expired().
    void undo(const Step<d>& step);
    /// Writes the expiries of what was evaluated or created; the mesh is Delaunay at step.x.
    void commit(Step<d>& step, const Certificate_checker<d>& checker);
    /// Begins a step without find_expired(): the caller names the certificates that are going to be evaluated.
    void begin_anchoring(Step<d>& step);

  private:
    friend struct Trace;  // trace.h
    using List = Vertex_expiries<d>;

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// An upper bound of the path length of v at x.
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
    void commit_points(const S& certificate, Certificate_id id, Expiry_of expiry_of, Step<d>* step);

    const Corner_table<d>& table_;
    bool kept_ = false;
    std::vector<Vertex_record<d>> vertex_;
    std::vector<List> list_;  // by vertex
    Certificate_expiries<d> expiries_;
    std::uint32_t stamp_ = 0;  // the present step, for Expiry_list::stamp
    struct Star_walk {
        std::vector<std::uint32_t> certificates;  // 2 half-facet, or 2 corner + 1
        std::vector<Expiry> listed;               // those not reached
        std::vector<Certificate_id> listed_id;
    } walk_;
};

extern template class Displacement_budget<2>;
extern template class Displacement_budget<3>;

}  // namespace annulus::inline v1
