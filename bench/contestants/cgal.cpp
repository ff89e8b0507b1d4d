// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <optional>
#include <utility>

namespace bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

class Cgal final : public Contestant {
  public:
    void rebuild(const Points<3>& x) override {
        points_.clear();
        points_.reserve(x.size());
        for (const auto& p : x)
            points_.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), static_cast<Index>(points_.size()));
        tr_.emplace(points_.begin(), points_.end());
    }
    [[nodiscard]] std::size_t cells() const override { return tr_->number_of_finite_cells(); }
    void forget() override { tr_.reset(); }

  private:
    std::vector<std::pair<Kernel::Point_3, Index>> points_;
    std::optional<Triangulation> tr_;
};

}  // namespace

std::unique_ptr<Contestant> cgal() { return std::make_unique<Cgal>(); }

}  // namespace bench
