// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/displacement.h>
#include <annulus/engine/least_tolerance.h>
#include <annulus/engine/repair.h>
#include <annulus/engine/upkeep.h>

#include <span>
#include <vector>

namespace annulus {

/// The paper's filtering algorithm (its 3.2), one vertex at a time: `filter-each` with tolerances nobody proved. (Certified
/// ones are kept by Filter.)
///
/// Every vertex has a fixed position f, a moving position m, a tolerance eps and D = |m - f|. A vertex with D < eps is
/// only written. One that fails enters a queue; each vertex h taken from it gets f = m, D = 0, and the certificates
/// around it are evaluated again: in place first, flips and reinsertion only where one is violated. Their tolerances
/// lower the eps of their points, and whoever no longer has D < eps enters the queue. Every vertex enters at most once
/// a call (its D is 0 from then on), so the queue ends.
///
/// Certificates are evaluated at the fixed positions, where the triangulation is Delaunay at all times: a tolerance that is
/// too large gives a wrong answer at the moving positions but never breaks the triangulation.
template <int d>
class Paper_queue final : public Upkeep<d> {
  public:
    Paper_queue(Delaunay_mesh<d>& mesh, Tolerance_kind kind) : mesh_(mesh), repair_(mesh, kind, true) {}

    /// As in Filter.
    void settle(std::span<const Coordinates<d>> x, Move_report& report);
    void begin(std::span<const Coordinates<d>> x, Move_report& report) override { settle(x, report); }
    void refresh_all(Move_report& report) override { settle(position_, report); }
    void move(Index v, const Coordinates<d>& p, Move_report& report) override;
    /// One after another, in the order of their indices.
    void move_all(std::span<const Coordinates<d>> x, Move_report& report) override;
    void refresh(std::span<const Cell_index> cells, Move_report& report) override;
    void place(Index v, const Coordinates<d>& p) override;
    [[nodiscard]] std::span<Coordinates<d>> lend(std::size_t bound) override {
        position_.resize(bound);
        return position_;
    }
    void cut(std::size_t bound) override { position_.resize(bound); }
    void put_back(Index v, const Coordinates<d>& p) noexcept override { position_[at(v)] = p; }

    void begin_each(std::span<const Coordinates<d>>, Move_report&) override { noted_ = {position_, fixed_, epsilon_, threshold_}; }
    void end_each(Move_report&) override { noted_ = {}; }
    void take_back() noexcept override;
    void resume() override {}
    [[nodiscard]] std::span<const Coordinates<d>> standing() const override { return fixed_; }

    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override { return fixed_[at(v)]; }
    [[nodiscard]] std::optional<double> tolerance(Index v) const override { return std::max(0.0, epsilon_[at(v)]); }
    [[nodiscard]] bool repairs() const override { return true; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bool passes(Index v) const {
        const Coordinates<d>& p = position_[at(v)];
        return squared_distance<d>(p, fixed_[at(v)]) < threshold_[at(v)] || p == fixed_[at(v)];
    }
    void resize();
    void lower(Index v, double tolerance);
    void update();
    void lower_points();
    void process(Index h, Move_report& report, bool first);
    void rebuild(Index h, const Coordinates<d>& old_fixed);

    /// The state of every vertex, to be put back with the triangulation it belongs to.
    struct Snapshot {
        std::vector<Coordinates<d>> position, fixed;
        std::vector<double> epsilon, threshold;
    };

    Delaunay_mesh<d>& mesh_;
    Repair<d> repair_;
    Snapshot noted_;
    std::vector<Coordinates<d>> position_;
    std::vector<Coordinates<d>> fixed_;
    std::vector<double> epsilon_;
    std::vector<double> threshold_;
    std::vector<Index> queue_;
    std::vector<char> queued_;
    Least_tolerance least_;  // of what is being looked at
};

extern template class Paper_queue<2>;
extern template class Paper_queue<3>;

}  // namespace annulus
