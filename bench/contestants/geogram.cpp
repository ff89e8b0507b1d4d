// SPDX-License-Identifier: GPL-3.0-or-later
// geogram's Delaunay triangulation in space, as its pluggable software module `Delaunay_psm` (bench/peers --geogram).
#include "contestant.h"

#include <Delaunay_psm.h>

#include <limits>
#include <stdexcept>

namespace bench {

namespace {

static_assert(sizeof(annulus::Coordinates<3>) == 3 * sizeof(double), "geogram reads coordinates one after the other");

class Geogram final : public Contestant<3> {
  public:
    Geogram() {
        GEO::initialize();  // further calls have no effect
        GEO::Process::enable_multithreading(false);
        delaunay_ = GEO::Delaunay::create(3, "BDEL");
        if (delaunay_.get() == nullptr) throw std::runtime_error("geogram has no BDEL");
    }
    void rebuild(const Points<3>& x) override {
        if (x.size() > static_cast<std::size_t>(std::numeric_limits<GEO::signed_index_t>::max()))
            throw std::runtime_error("geogram: too many points");
        delaunay_->set_vertices(static_cast<GEO::index_t>(x.size()), x.front().data());
    }
    /// geogram drops infinite cells unless an option keeps them.
    [[nodiscard]] std::size_t cells() const override { return delaunay_->nb_cells(); }

  private:
    GEO::Delaunay_var delaunay_;
};

}  // namespace

std::unique_ptr<Contestant<3>> geogram() { return std::make_unique<Geogram>(); }

}  // namespace bench
