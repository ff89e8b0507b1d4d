// SPDX-License-Identifier: GPL-3.0-or-later
// HXT, gmsh's contrib/hxt (bench/peers --hxt).
#include "contestant.h"

#include <hxt_mesh.h>
#include <hxt_tetDelaunay.h>
#include <hxt_tools.h>

#include <stdexcept>
#include <string>

namespace bench {

namespace {

void check(HXTStatus status, const char* what) {
    if (status < 0) throw std::runtime_error(std::string("HXT: ") + what + ": status " + std::to_string(status));
}

class Hxt final : public Contestant<3> {
  public:
    explicit Hxt(bool reorders) : reorders_(reorders) { check(hxtMeshCreate(&mesh_), "hxtMeshCreate"); }
    Hxt(const Hxt&) = delete;
    Hxt& operator=(const Hxt&) = delete;
    ~Hxt() override { (void)hxtMeshDelete(&mesh_); }

    /// The arrays of cells are kept from call to call.
    void rebuild(const Points<3>& x) override {
        auto& vertices = mesh_->vertices;
        const auto n = static_cast<std::uint32_t>(x.size());
        if (vertices.size < n) {
            check(hxtAlignedFree(&vertices.coord), "hxtAlignedFree");
            check(hxtAlignedMalloc(&vertices.coord, x.size() * 4 * sizeof(double)), "hxtAlignedMalloc");
            vertices.size = n;
        }
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) vertices.coord[4 * i + k] = x[i][k];
        vertices.num = n;
        mesh_->tetrahedra.num = 0;
        HXTDelaunayOptions options{};
        options.perfectDelaunay = 1;
        options.delaunayThreads = 1;
        if (reorders_) {
            check(hxtDelaunay(mesh_, &options), "hxtDelaunay");
        } else {
            nodes_.resize(x.size());
            for (std::uint32_t i = 0; i < n; ++i) nodes_[i] = {0, i, HXT_STATUS_TRYAGAIN};
            check(hxtDelaunaySteadyVertices(mesh_, &options, nodes_.data(), n), "hxtDelaunaySteadyVertices");
        }
        if (options.numVerticesInMesh != n) throw std::runtime_error("HXT: vertices are missing");
    }
    [[nodiscard]] std::size_t cells() const override {
        std::size_t finite = 0;
        for (std::uint64_t t = 0; t < mesh_->tetrahedra.num; ++t)
            finite += mesh_->tetrahedra.node[4 * t + 3] != HXT_GHOST_VERTEX ? 1U : 0U;
        return finite;
    }

  private:
    bool reorders_;
    HXTMesh* mesh_ = nullptr;
    std::vector<HXTNodeInfo> nodes_;
};

}  // namespace

std::unique_ptr<Contestant<3>> hxt() { return std::make_unique<Hxt>(false); }
std::unique_ptr<Contestant<3>> hxt_reordering() { return std::make_unique<Hxt>(true); }

}  // namespace bench
