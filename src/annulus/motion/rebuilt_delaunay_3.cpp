// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/rebuilt_delaunay_3.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/error.h>
#include <annulus/motion/cells_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <utility>

namespace annulus {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Index, K>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<K>>;
using Triangulation = CGAL::Delaunay_triangulation_3<K, Tds>;

K::Point_3 cgal(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }

}  // namespace

Rebuilt_delaunay_3::Rebuilt_delaunay_3(std::span<const Coordinates<3>> points, const Options& options) {
    if (options.strategy != Strategy::rebuild)
        throw Error(Error_code::usage, "in space this version has the strategy rebuild only");
    points_.assign(points.begin(), points.end());
    build();
}

void Rebuilt_delaunay_3::build() {
    if (points_.size() < 4) throw Error(Error_code::too_few, "a triangulation of space needs at least 4 points");
    std::vector<std::pair<K::Point_3, Index>> input;
    input.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        for (const double x : points_[i])
            if (!std::isfinite(x)) throw Error(Error_code::not_finite, "a coordinate is not finite");
        if (!in_domain(points_[i])) throw Error(Error_code::out_of_domain, "a coordinate is out of domain");
        input.emplace_back(cgal(points_[i]), static_cast<Index>(i));
    }
    const Triangulation dt(input.begin(), input.end());
    if (dt.number_of_vertices() != points_.size()) throw Error(Error_code::collision, "two vertices share a position");
    cells_.clear();
    if (dt.dimension() < 3) return;
    cells_.reserve(dt.number_of_finite_cells());
    for (const auto c : dt.finite_cell_handles())
        cells_.push_back({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
}

Move_report Rebuilt_delaunay_3::move_all(std::span<const Coordinates<3>> points) {
    if (points.size() != points_.size()) throw Error(Error_code::wrong_size, "move_all needs a point for every vertex");
    std::vector<Coordinates<3>> before(points.begin(), points.end());
    before.swap(points_);
    try {
        build();
    } catch (...) {
        before.swap(points_);
        throw;
    }
    Move_report report;
    report.moves.asked = report.moves.rebuilt = points.size();
    return report;
}

Audit_result Rebuilt_delaunay_3::audit() const {
    Audit_result r;
    const Cells_3 cells = linked(cells_, points_.size());
    const auto x = [&](Index i) { return cgal(points_[static_cast<std::size_t>(i)]); };
    std::vector<char> used(points_.size(), 0), on_hull(points_.size(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i)
            for (const std::size_t k : facet_corners[i])
                if (cells.adjacent[c][i] == none) on_hull[static_cast<std::size_t>(cells.vertex[c][k])] = 1;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto& v = cells.vertex[c];
        for (const Index i : v) used[static_cast<std::size_t>(i)] = 1;
        if (CGAL::orientation(x(v[0]), x(v[1]), x(v[2]), x(v[3])) != CGAL::POSITIVE) ++r.inverted_cells;
        for (std::size_t i = 0; i < 4; ++i) {
            const Index beyond = cells.adjacent[c][i];
            if (beyond == none) {
                const auto& f = facet_corners[i];
                for (std::size_t u = 0; u < points_.size(); ++u)
                    if (on_hull[u] != 0 &&
                        CGAL::orientation(x(v[f[0]]), x(v[f[1]]), x(v[f[2]]), cgal(points_[u])) == CGAL::POSITIVE) {
                        ++r.concave_ridges;
                        break;
                    }
                continue;
            }
            for (const Index w : cells.vertex[static_cast<std::size_t>(beyond)]) {
                if (w == v[0] || w == v[1] || w == v[2] || w == v[3]) continue;
                const auto side = CGAL::side_of_oriented_sphere(x(v[0]), x(v[1]), x(v[2]), x(v[3]), x(w));
                r.violated_facets += side == CGAL::ON_POSITIVE_SIDE;
                r.degenerate_facets += side == CGAL::ON_ORIENTED_BOUNDARY && static_cast<std::size_t>(beyond) < c;
            }
        }
    }
    for (const char u : used) r.topological_faults += u == 0;
    if (!r.delaunay()) r.first_fault = "refused by CGAL's predicates";
    return r;
}

}  // namespace annulus
