// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

#include <annulus/moving_mesh.h>

#include <optional>
#include <span>

namespace bench {

namespace {

using namespace annulus;

class Mesh final : public Contestant {
  public:
    explicit Mesh(bool anew) : anew_(anew) { options_.strategy = Strategy::rebuild; }

    void rebuild(const Points<3>& x) override {
        if (mesh_ && mesh_->number_of_vertices() == x.size()) (void)mesh_->move_all(std::span<const Coordinates<3>>(x));
        else mesh_.emplace(std::span<const Coordinates<3>>(x), options_);
    }
    [[nodiscard]] std::size_t cells() const override { return mesh_->cells().vertices.size(); }
    void forget() override {
        if (anew_) mesh_.reset();
    }

  private:
    bool anew_;
    Options options_;
    std::optional<Moving_mesh<3>> mesh_;
};

}  // namespace

std::unique_ptr<Contestant> moving_mesh() { return std::make_unique<Mesh>(false); }
std::unique_ptr<Contestant> moving_mesh_anew() { return std::make_unique<Mesh>(true); }

}  // namespace bench
