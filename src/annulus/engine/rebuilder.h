// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/upkeep.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <vector>

namespace annulus {

/// The strategy `rebuild`: positions, and a mesh that is rebuilt at every call. What changes the mesh in other ways
/// and keeps nothing but positions derives from it.
template <int d>
class Rebuilder : public Upkeep<d> {
  public:
    explicit Rebuilder(Delaunay_mesh<d>& mesh, Strategy strategy = Strategy::rebuild)
        : Upkeep<d>(strategy), mesh_(mesh) {}

    void begin(std::span<const Coordinates<d>> x, Move_report& report) override;
    void refresh_all(Move_report&) override {}
    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override { return position_[at(v)]; }
    [[nodiscard]] std::optional<double> tolerance(Index) const override { return std::nullopt; }
    [[nodiscard]] bool repairs() const override { return false; }
    [[nodiscard]] bool goes_in_turn() const override { return false; }

    /// O(n log n).
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

  protected:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Delaunay_mesh<d>& mesh() { return mesh_; }
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const { return mesh_; }

    std::vector<Coordinates<d>> position_;

  private:
    Delaunay_mesh<d>& mesh_;
    std::vector<Coordinates<d>> noted_;
};

extern template class Rebuilder<2>;
extern template class Rebuilder<3>;

}  // namespace annulus
