// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/delimiter.h>
#include <annulus/engine/certificate_expiries.h>
#include <annulus/engine/chooser.h>
#include <annulus/engine/displacement.h>
#include <annulus/engine/expiry_list.h>
#include <annulus/engine/options.h>
#include <annulus/engine/repair.h>
#include <annulus/engine/upkeep.h>
#include <annulus/engine/vertex_record.h>

#include <limits>
#include <span>
#include <vector>

namespace annulus {

/// The strategy `filter`: a whole timestamp at a time, only certificates that expired are evaluated. And `filter-each`, one
/// vertex at a time (`move_one`), with certified tolerances.
///
/// Every vertex has an odometer: `base` is an upper bound of the length of the path of its fixed positions since the
/// last settling, and its reading is base + |moving - fixed|. A certificate evaluated when its points read r_i and
/// found to have tolerance s holds while every reading stays below its expiry r_i + s, because a reading bounds the
/// distance travelled, hence the distance from where the point was when the certificate was evaluated. Different
/// certificates have different references; nothing in theory 1 minds. A vertex keeps the earliest expiries among its
/// certificates (Expiry_list), so its step test compares |moving - fixed|^2 with one number. When it fails, its fixed
/// position becomes the moving one, those of its certificates that expired are evaluated at the moving positions, all
/// their points take their moving positions as fixed ones, and whatever is violated is mended (Repair). Soundness:
/// docs/theory.md.
///
/// While so many certificates expire at every step (the first steps of an optimisation) that the signs of all of them cost
/// less than the tolerances of these, tolerances are not kept at all (`tracks`); single moves then ask for the signs around
/// the vertex.
template <int d>
class Filter final : public Upkeep<d> {
  public:
    /// `automatic`: timestamps are rebuilt while that is the cheapest way, and then there is no mirror.
    Filter(Embedding<d>& embedding, Tolerance_kind kind, Second_look look, bool automatic = false)
        : automatic_(automatic),
          embedding_(embedding),
          table_(embedding.table()),
          repair_(embedding, kind, kind == Tolerance_kind::certified),
          look_(d == 2 ? look : Second_look::off) {}

    /// For the step test, evaluations and signs. Nothing that is found or counted depends on it.
    void set_threads(int threads) {
        threads_ = threads;
        repair_.set_threads(threads);
    }
    /// Whether reports list the cells that changed.
    void report_changes(bool on) { report_changes_ = on; }

    /// Takes the present triangulation and positions x as given and Delaunay; every certificate is evaluated afresh. When it
    /// throws (bad_alloc), no position was written. O(n).
    void settle(std::span<const Coordinates<d>> x, Move_report& report);
    /// The same; with `automatic` nothing is evaluated, nor mirrored: the first timestamps tell whether that pays.
    void begin(std::span<const Coordinates<d>> x, Move_report& report) override;
    void refresh_all(Move_report& report) override { settle(position_, report); }

    /// Moves every vertex to x. Throws Error, with everything as it was: not_finite, out_of_domain, or collision when two
    /// would coincide. Anything else that is thrown (bad_alloc, Error(too_large)) leaves positions() as they were and all else
    /// unspecified: build anew there and settle. Precondition: settled in dimension d.
    void move_all(std::span<const Coordinates<d>> x, Move_report& report) override;
    void move(Index v, const Coordinates<d>& p, Move_report& report) override;

    /// A timestamp of single moves, under `filter-each`: begin_each, move_one in any order, end_each. While so many vertices
    /// fail that the signs around a vertex cost less than its tolerances, without tolerances.
    void begin_each(std::span<const Coordinates<d>> x, Move_report& report) override {
        noted_ = position_;
        settle_if_it_pays(report);
        note_displacements(x);
    }
    void move_one(Index v, const Coordinates<d>& p, Move_report& report);
    void move_in_turn(Index v, const Coordinates<d>& p, Move_report& report) override { move_one(v, p, report); }
    void end_each(Move_report& report) override {
        noted_.clear();
        end_timestamp(true, report);
    }
    void take_back() noexcept override {
        position_.swap(noted_);
        tracks_ = false;
    }
    void resume() override {
        Move_report nobody_asked;
        settle(position_, nobody_asked);
    }

    /// Evaluates the certificates of these cells.
    void refresh(std::span<const Cell_index> cells, Move_report& report) override;
    /// The vertex takes position p as moving and fixed position.
    void place(Index v, const Coordinates<d>& p) override;
    void put_back(Index v, const Coordinates<d>& p) noexcept override {
        position_[at(v)] = p;
        tracks_ = false;
    }
    void cut(std::size_t bound) override {
        position_.resize(bound);
        tracks_ = false;
    }

    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override {
        return !tracks_ ? position_[at(v)] : vertex_[at(v)].fixed;
    }
    [[nodiscard]] bool filters() const override { return true; }
    /// False while the motion is so fast that tolerances would not last a step and are not kept.
    [[nodiscard]] bool tracks() const { return tracks_; }
    /// Lower bound of the distance v may be from its fixed position while every other vertex is within its own; while tracks().
    [[nodiscard]] std::optional<double> tolerance(Index v) const override {
        return tracks_ ? std::optional(std::max(0.0, slack(v))) : std::nullopt;
    }

  private:
    /// One or two cache lines: around a vertex are 12 certificates in the plane, 80 in space.
    using List = Expiry_list<Horizons::listed(d)>;
    struct Failed {
        Vertex_record<d> record;
        List list;
    };
    struct Renewal {
        Corner_index facet;
        std::array<double, static_cast<std::size_t>(d + 2)> expiry;
    };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] static bool within(const Coordinates<d>& p, double limit) {
        bool near = true;
        for (const double c : p) near &= std::fabs(c) <= limit;  // no branch: this runs over all positions
        return near;
    }
    [[nodiscard]] bool passes(Index v, const Coordinates<d>& p) const {
        const Vertex_record<d>& r = vertex_[at(v)];
        return squared_distance<d>(p, r.fixed) < r.threshold.value() || p == r.fixed;
    }
    /// Odometer reading of v at x: an upper bound.
    [[nodiscard]] double reading(Index v, const Coordinates<d>& x) const {
        return sum_upper(list_[at(v)].base, distance_upper<d>(x, vertex_[at(v)].fixed));
    }
    /// False when a coordinate is beyond the domain, or is none.
    [[nodiscard]] bool find_failed(std::span<const Coordinates<d>> x);
    [[nodiscard]] bool find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last, std::vector<Index>& failed) const;
    void require_domain(std::span<const Coordinates<d>> x) const;
    /// Decides whether to keep tolerances again.
    void reconsider(bool each, Move_report& report);
    /// The share of the certificates that would expire at a step like this one.
    [[nodiscard]] double outlook(Move_report& report);
    [[nodiscard]] bool too_dear() const;
    [[nodiscard]] bool too_many_failed() const;
    void note_expenses(bool each);
    void note_displacements(std::span<const Coordinates<d>> x);
    void end_timestamp(bool each, Move_report& report);
    void take_up(std::span<const Coordinates<d>> x, Move_report& report);
    void evaluate_all(std::span<const Coordinates<d>> x, Move_report& report);
    void stop_tracking();
    void resize();
    /// Which certificates are evaluated: those that expired; without tolerances all those of the vertex that moved, or all.
    enum class Scope : std::uint8_t { expired, star, everything };
    void process(std::span<const Coordinates<d>> x, Scope scope, Move_report& report);
    void process_one(Index v, const Coordinates<d>& old, Scope scope, Move_report& report);
    [[nodiscard]] bool examine(std::span<const Coordinates<d>> x, Index mover, Scope& scope);
    [[nodiscard]] double dearer() const;
    void finish(std::span<const Coordinates<d>> x, Index mover, Scope scope, bool rebuilt, Move_report& report);
    [[nodiscard]] double most_repair() const { return Chooser<d>::most_repair(embedding_.vertices()); }
    void rebuild(std::span<const Coordinates<d>> x);
    void settle_if_it_pays(Move_report& report);
    void settle_afterwards(Move_report& report);
    [[nodiscard]] bool next_is_mended(std::span<const Coordinates<d>> x);
    void rebuild_all(std::span<const Coordinates<d>> x, bool mirrors, Move_report& report);
    void find_expired(std::span<const Coordinates<d>> x);
    void commit(std::span<const Coordinates<d>> x);
    void anchor(Index v, std::span<const Coordinates<d>> x);
    void begin_anchoring();
    void undo_anchoring();
    [[nodiscard]] bool second_look(Corner_index f, std::span<const Coordinates<d>> x);
    [[nodiscard]] bool unequal_moves(Corner_index f, std::span<const Coordinates<d>> x);
    [[nodiscard]] bool safe_region(Corner_index f, std::span<const Coordinates<d>> x);
    void keep_delimiter(Corner_index f, const Facet_points<d>& point, std::span<const Coordinates<d>> x);
    /// Looks at one certificate of v: expired at this reading, or else back on the list.
    void look_at(Certificate_id id, Index v, double reading, List& list, std::span<const Coordinates<d>> x);
    void tour(Index v, double reading, List& list, std::span<const Coordinates<d>> x);
    void rebase(Index v);
    template <class Points>
    void prefetch(const Points& points) const;
    void commit_renewals(std::span<const Coordinates<d>> x);
    /// `fresh`: no certificate in question is on any list.
    template <bool fresh>
    void commit_evaluated(std::span<const Coordinates<d>> x);
    template <bool fresh, class S, class Expiry_of>
    void commit_points(const S& suspect, Certificate_id id, Expiry_of expiry_of, std::span<const Coordinates<d>> x);
    void set_threshold(Index v) { vertex_[at(v)].threshold = Upper_half::lower(squared_threshold_lower(slack(v))); }
    /// How far v may be from its fixed position (proofs/coq/float_displacement.v, passes_2_sound).
    [[nodiscard]] double slack(Index v) const {
        const List& list = list_[at(v)];
        return (list.earliest().reading() - list.base) * (1.0 - 0x1p-50);
    }
    void renew_renumbered();
    void require_mirror();
    [[nodiscard]] bool lives(std::size_t v) const { return embedding_.has(static_cast<Index>(v)); }
    void count(Index mover, bool rebuilt, Move_report& report);

    bool automatic_;
    int threads_ = 1;
    Embedding<d>& embedding_;
    const Cell_table<d>& table_;
    Repair<d> repair_;
    Chooser<d> chooser_;
    bool renumbered_ = false;  // cells are, by a call that failed
    bool settles_next_ = false;  // tolerances would last, as the last timestamp was
    double prepared_ = 0.0;    // price of looking for what expired, of this timestamp
    bool report_changes_ = false;
    Second_look look_;
    bool tracks_ = true;                        // tolerances; if not, records and lists are void
    std::vector<Coordinates<d>> displacement_;  // of this step, while it is considered whether tolerances would last
    std::uint64_t failures_ = 0;                // with tolerances, of this timestamp
    std::uint64_t evaluated_ = 0;               // certificates, for these
    double overdraft_ = 0.0;       // failures, by which tracking cost more than signs alone since the last settling
    std::uint64_t untracked_ = 0;  // steps since tolerances were given up
    std::uint64_t single_moves_ = 0;  // since then
    std::vector<Coordinates<d>> position_;
    std::vector<Coordinates<d>> noted_;  // position_ before a timestamp of single moves
    std::vector<Vertex_record<d>> vertex_;
    std::vector<List> list_;  // by vertex
    Certificate_expiries<d> expiries_;
    By_corner<double> tolerance_;       // of facets, when there are second looks; 0: no second look
    By_corner<Delimiter_2> delimiter_;  // of facets, for the second look that needs it
    // Of one step:
    std::vector<Index> failed_;
    std::vector<Failed> before_;               // of failed_, what they were before the step
    std::vector<std::uint32_t> certificates_;  // of one vertex: 2 half-facet, or 2 corner + 1
    std::vector<Expiry> listed_;               // of these, not reached
    std::vector<Certificate_id> listed_id_;
    std::vector<Index> anchored_;
    std::vector<Renewal> renewals_;
    std::vector<std::uint32_t> disturbed_stamp_;
    std::uint32_t step_ = 0;   // of disturbed_stamp_
    std::uint32_t stamp_ = 0;  // of Expiry_list::stamp
    std::uint64_t tours_ = 0;
};

extern template class Filter<2>;
extern template class Filter<3>;

}  // namespace annulus
