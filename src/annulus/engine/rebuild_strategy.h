// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/update_strategy.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <limits>
#include <vector>

namespace annulus::inline v1 {

/// The strategy `rebuild`: keeps positions, and rebuilds the mesh at every call. Base of the strategies that change
/// the mesh in other ways and keep nothing but positions.
template <int d>
class Rebuild_strategy : public Update_strategy<d> {
  public:
    explicit Rebuild_strategy(Delaunay_mesh<d>& mesh, Strategy strategy = Strategy::rebuild)
        : Update_strategy<d>(strategy), mesh_(mesh) {}

    void begin(std::span<const Coordinates<d>> x, Move_result& report) override;
    void refresh_all(Move_result&) override {}
    [[nodiscard]] std::span<const Coordinates<d>> positions() const override { return position_; }
    [[nodiscard]] const Coordinates<d>& fixed_position(Index v) const override { return position_[at(v)]; }
    [[nodiscard]] std::optional<double> tolerance(Index) const override { return std::nullopt; }
    [[nodiscard]] bool repairs() const override { return false; }
    [[nodiscard]] bool is_sequential() const override { return false; }

    /// O(n log n).
    void move_all(std::span<const Coordinates<d>> x, Move_result& report) override;
    void move(Index v, const Coordinates<d>& p, Move_result& report) override;
    void add_vertex(Index v, const Coordinates<d>& p) override;
    void refresh(std::span<const Cell_index>, Move_result&) override {}
    [[nodiscard]] std::span<Coordinates<d>> resize_for_insertion(std::size_t bound) override {
        position_.resize(bound);
        return position_;
    }
    void truncate(std::size_t bound) override { position_.resize(bound); }
    void restore_position(Index v, const Coordinates<d>& p) noexcept override { position_[at(v)] = p; }
    void clear_position(Index v) noexcept override { position_[at(v)].fill(std::numeric_limits<double>::quiet_NaN()); }

    void begin_transaction(std::span<const Coordinates<d>>, Move_result&) override { saved_ = position_; }
    void commit_transaction(Move_result&) override { saved_.clear(); }
    void rollback() noexcept override { position_.swap(saved_); }
    void resume_after_rollback() override {}

  protected:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Delaunay_mesh<d>& mesh() { return mesh_; }
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const { return mesh_; }

    std::vector<Coordinates<d>> position_;

  private:
    Delaunay_mesh<d>& mesh_;
    std::vector<Coordinates<d>> saved_;
};

extern template class Rebuild_strategy<2>;
extern template class Rebuild_strategy<3>;

}  // namespace annulus::inline v1
