// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

#include <annulus/moving_mesh.h>

#include <optional>
#include <span>

namespace bench {

namespace {

using namespace annulus;

template <int d>
class Mesh final : public Contestant<d> {
  public:
    explicit Mesh(bool anew) : anew_(anew) { options_.strategy = Strategy::rebuild; }

    void rebuild(const Points<d>& x) override {
        if (mesh_ && mesh_->number_of_vertices() == x.size()) (void)mesh_->move_all(std::span<const Coordinates<d>>(x));
        else mesh_.emplace(std::span<const Coordinates<d>>(x), options_);
    }
    [[nodiscard]] std::size_t cells() const override { return mesh_->cells().vertices.size(); }
    void forget() override {
        if (anew_) mesh_.reset();
    }

  private:
    bool anew_;
    Options options_;
    std::optional<Moving_mesh<d>> mesh_;
};

}  // namespace

template <int d>
std::unique_ptr<Contestant<d>> moving_mesh() {
    return std::make_unique<Mesh<d>>(false);
}
template <int d>
std::unique_ptr<Contestant<d>> moving_mesh_anew() {
    return std::make_unique<Mesh<d>>(true);
}

template std::unique_ptr<Contestant<2>> moving_mesh<2>();
template std::unique_ptr<Contestant<3>> moving_mesh<3>();
template std::unique_ptr<Contestant<2>> moving_mesh_anew<2>();
template std::unique_ptr<Contestant<3>> moving_mesh_anew<3>();

}  // namespace bench
