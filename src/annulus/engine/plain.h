// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/engine/options.h>
#include <annulus/engine/upkeep.h>

#include <vector>

namespace annulus {

/// The strategies that repair nothing and leave everything to the mesh: `rebuild` (and `hybrid` until it switches),
/// `relocate`, `relocate-flips`.
template <int d>
class Plain final : public Upkeep<d> {
  public:
    Plain(Delaunay_mesh<d>& mesh, Strategy strategy) : mesh_(mesh), strategy_(strategy) {}

    void begin(std::span<const Coordinates<d>> x, Move_report& report) override;
    void refresh_all(Move_report&) override {}
    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override { return position_[at(v)]; }
    [[nodiscard]] std::optional<double> tolerance(Index) const override { return std::nullopt; }
    [[nodiscard]] bool repairs() const override { return false; }

    /// By a rebuild. O(n log n).
    void move_all(std::span<const Coordinates<d>> x, Move_report& report) override;
    void move(Index v, const Coordinates<d>& p, Move_report& report) override;
    void place(Index v, const Coordinates<d>& p) override;
    void refresh(std::span<const Cell_index>, Move_report&) override {}
    [[nodiscard]] std::span<Coordinates<d>> lend(std::size_t bound) override {
        position_.resize(bound);
        return position_;
    }
    void cut(std::size_t bound) override { position_.resize(bound); }
    void put_back(Index v, const Coordinates<d>& p) noexcept override { position_[at(v)] = p; }

    void begin_each(std::span<const Coordinates<d>>, Move_report&) override { noted_ = position_; }
    void end_each(Move_report&) override { noted_.clear(); }
    void take_back() noexcept override { position_.swap(noted_); }
    void resume() override {}

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    Delaunay_mesh<d>& mesh_;
    Strategy strategy_;
    std::vector<Coordinates<d>> position_;
    std::vector<Coordinates<d>> noted_;
};

extern template class Plain<2>;
extern template class Plain<3>;

}  // namespace annulus
