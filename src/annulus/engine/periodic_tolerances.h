// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_expiries.h>
#include <annulus/engine/periodic_certificates.h>
#include <annulus/engine/periodic_motion.h>
#include <annulus/engine/reference_box.h>
#include <annulus/engine/step.h>
#include <annulus/mesh/periodic_star.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// What is left of the tolerances of a periodic table whose certificates were evaluated at different times and in
/// different boxes: Displacement_budget for cells with offsets, in a box that moves (docs/theory.md 8.9).
///
/// Every vertex has a reading,
///
///     length of the path of its anchors + |co-moving place - anchor| + reach * deviation of the box (Reference_box),
///
/// and a certificate holds while the reading of each of its points is below its expiry. A vertex whose reading may have
/// passed one fails: it is anchored where it is, and those of its certificates that have expired are evaluated.
///
///     begin_step -- failed -- find_expired -- evaluated -- all hold --------------------------> commit, relabel
///         |                                       |
///     no tolerances: signs of all              some do not: flips -- relabel -- evaluate what changed -- commit
///
/// From begin_step() to commit() no tolerances are kept, so whatever ends a step in between leaves none.
template <int d>
class Periodic_tolerances {
  public:
    using Evaluated = Evaluated_certificate<d>;

    /// Of evaluations. Results do not depend on it.
    void set_threads(int threads) { threads_ = threads; }
    [[nodiscard]] bool kept() const { return kept_; }
    void invalidate() noexcept { kept_ = false; }
    /// The same, and releases the memory.
    void drop() noexcept;

    /// Evaluates every certificate; the triangulation is right. `spacing` is a length: certificates that are larger
    /// than it lose more when the box is deformed. Throws bad_alloc, without tolerances. O(n).
    Stage_counts recompute(const Periodic_view<d>& view, double spacing);

    /// A step of this motion begins, in this box: which vertices fail. False where nothing is kept, the box is too far
    /// from the reference or has another basis, or more than `most` fail. Throws bad_alloc.
    [[nodiscard]] bool begin_step(Periodic_motion<d>& motion, const Lattice<d>& lattice, std::size_t most);
    [[nodiscard]] std::span<const Index> failed() const { return step_.failed; }
    /// Anchors what failed, and evaluates what has expired, at the goals: evaluated() has it. Throws bad_alloc.
    Stage_counts find_expired(const Periodic_view<d>& at_goals, Periodic_star<d>& star);
    [[nodiscard]] std::span<const Evaluated> evaluated() const { return step_.evaluated; }
    /// How many stars were walked.
    [[nodiscard]] std::uint64_t star_walks() const { return step_.star_walks; }
    /// Of vertices that have left the box, whose offsets have grown. No certificate has to be evaluated for it.
    void relabel(const Periodic_motion<d>& motion);
    /// After flips: evaluates what was evaluated and is still there, and all certificates of these cells.
    Stage_counts evaluate_again(const Periodic_view<d>& view, std::span<const std::size_t> changed);
    /// Writes the expiries of what was evaluated, at these places: tolerances are kept from now on, unless paths have
    /// become too long for them. Precondition: all of it holds.
    void commit(const Periodic_view<d>& view);

    /// A lower bound of how far each vertex may be from its place while the box stays and every other vertex is as
    /// near, by what is left of its tolerances. NaN where there is none. Precondition: kept().
    [[nodiscard]] std::vector<double> left(const Periodic_view<d>& view) const;
    /// The same by evaluating all certificates.
    [[nodiscard]] static std::vector<double> evaluate(const Periodic_view<d>& view, int threads);

    /// Which part of the certificates would expire in a step like this motion, which was made, by a sample of facets.
    [[nodiscard]] static double expected_share(const Periodic_view<d>& view, Periodic_motion<d>& motion,
                                               const Lattice<d>& before, double spacing, Move_statistics& statistics);

  private:
    struct Record {
        Coordinates<d> anchor{};
        double until = 0;  // the earliest expiry less the length of the path
    };
    struct Step {
        std::vector<Index> failed, anchored;
        std::vector<Certificate_id> ids;
        std::vector<Evaluated> evaluated;
        std::uint64_t star_walks = 0;
    };
    /// By vertex, and by certificate.
    struct Kept {
        std::vector<Record> vertex;
        std::vector<Vertex_expiries<d>> list;
        Certificate_expiries<d> expiries;
        std::uint32_t stamp = 0;  // of the present step, for Expiry_list::stamp
    };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] double gone_upper() const { return reach_ * box_.deviation_upper() * (1 + 0x1p-51); }
    [[nodiscard]] double gone_lower() const { return reach_ * box_.deviation_upper() * (1 - 0x1p-51); }
    void find_failed(Periodic_motion<d>& motion, bool same_box);
    void begin_anchoring();
    void anchor(Index v, const Coordinates<d>& place);
    [[nodiscard]] Expiry expiry_of(const Periodic_table<d>& table, Certificate_id id, Index v) const;
    void check(const Periodic_table<d>& table, Certificate_id id, Index v);
    void walk(const Periodic_table<d>& table, Periodic_star<d>& star, Index v);
    void resize(const Periodic_view<d>& view);
    void write(const Periodic_table<d>& table, const Evaluated& e);
    void set_until(Index v);

    Reference_box<d> box_;
    Kept of_;
    Step step_;
    double reach_ = 0;
    int threads_ = 1;
    bool kept_ = false;
};

extern template class Periodic_tolerances<2>;
extern template class Periodic_tolerances<3>;

}  // namespace annulus::inline v1
