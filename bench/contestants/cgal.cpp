// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <optional>
#include <utility>

namespace bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int d>
struct Types;
template <>
struct Types<2> {
    using Point = Kernel::Point_2;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
    using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
    static Point point(const annulus::Coordinates<2>& p) { return {p[0], p[1]}; }
    static std::size_t cells(const Triangulation& tr) { return tr.number_of_faces(); }
};
template <>
struct Types<3> {
    using Point = Kernel::Point_3;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
    using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
    using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
    static Point point(const annulus::Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
    static std::size_t cells(const Triangulation& tr) { return tr.number_of_finite_cells(); }
};

template <int d>
class Cgal final : public Contestant<d> {
  public:
    void rebuild(const Points<d>& x) override {
        points_.clear();
        points_.reserve(x.size());
        for (const auto& p : x) points_.emplace_back(Types<d>::point(p), static_cast<Index>(points_.size()));
        tr_.emplace(points_.begin(), points_.end());
    }
    [[nodiscard]] std::size_t cells() const override { return Types<d>::cells(*tr_); }
    void forget() override { tr_.reset(); }

  private:
    std::vector<std::pair<typename Types<d>::Point, Index>> points_;
    std::optional<typename Types<d>::Triangulation> tr_;
};

}  // namespace

template <int d>
std::unique_ptr<Contestant<d>> cgal() {
    return std::make_unique<Cgal<d>>();
}

template std::unique_ptr<Contestant<2>> cgal<2>();
template std::unique_ptr<Contestant<3>> cgal<3>();

}  // namespace bench
