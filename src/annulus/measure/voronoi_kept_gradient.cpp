// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_kept_gradient.h>

#include <annulus/measure/cells_of_table.h>
#include <annulus/measure/inner_facets.h>
#include <annulus/measure/voronoi_facet_exact.h>
#include <annulus/measure/voronoi_input.h>
#include <annulus/mesh/at.h>
#include <annulus/mesh/list_cells.h>

#include <cmath>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Adds the terms of Voronoi edges to the gradient, from circumcentres that are there already. The same terms as in
/// voronoi_gradient.cpp, and the same errors: with D from one circumcentre to the other, off by g, and e from i to j,
/// which is perpendicular to D, A / |e| is |D x e| / e^2, off by g |e| / e^2 and some units of u.
///
/// D is the difference of O = B + R and L, where L and R are the circumcentres, relative to first corners, and B leads
/// from the one corner to the other. So g is at most the errors of L and R and u (|B| + |O|), with 16 u |D| for what is
/// left out, where |O| <= |L| + |D| and |B| <= |O| + |R|. u |L| and u |R| are at most half of the errors of L and R
/// (circumcentre.h). Hence twice these errors and 20 u |D| are enough.
class Edge_terms {
  public:
    /// By vertex: positions, and weights, 0 unless the cell is bounded. By cell: circumcentres, in the unit 2^exponent.
    Edge_terms(const Corner_table<2>& table, std::span<const Coordinates<2>> x, std::vector<double> weights,
               std::span<const Circumcentre<2>> centre, int exponent)
        : table_(table),
          x_(x),
          weights_(std::move(weights)),
          centre_(centre),
          exponent_(exponent),
          scale_(std::ldexp(1.0, -exponent)),
          gradient_(x.size()) {}

    void add(const Inner_facet<2>& f) {
        const auto [p, q] = f.corners;
        const double difference = weights_[at(p)] - weights_[at(q)];
        if (difference == 0) return;
        const Circumcentre<2>& left = centre_[at(f.cell)];
        const Circumcentre<2>& right = centre_[at(f.beyond)];
        const Coordinates<2> base = to(f.first, f.first_beyond);
        const Coordinates<2> other{base[0] + right.offset[0], base[1] + right.offset[1]};
        const Coordinates<2> dual{other[0] - left.offset[0], other[1] - left.offset[1]};
        const Coordinates<2> e = to(p, q);
        const Coordinates<2> from_p = to(p, f.first);
        const double area = std::fabs(dual[0] * e[1] - dual[1] * e[0]);
        const double square = e[0] * e[0] + e[1] * e[1];
        const double moved = 2 * (left.error + right.error) + 20 * u * size(dual);
        if (square > 0x1p-800 && size(e) * moved + lost < 0x1p-35 * area)
            add(p, q, difference * (area / square),
                {0.5 * (left.offset[0] + other[0]) + from_p[0], 0.5 * (left.offset[1] + other[1]) + from_p[1]}, e);
        else add_exactly(Cell_index(f.cell), Cell_index(f.beyond), p, q, difference);
    }
    std::vector<Coordinates<2>> take() {
        const double unit = std::ldexp(1.0, exponent_);
        for (auto& v : gradient_)
            for (double& k : v) k *= unit;
        return std::move(gradient_);
    }

  private:
    static constexpr double u = bounds::u;
    static constexpr double lost = 0x1p-900;

    static double size(const Coordinates<2>& x) { return std::fabs(x[0]) + std::fabs(x[1]); }
    [[nodiscard]] Coordinates<2> to(Index a, Index b) const {
        return Euclidean<2>::difference(x_[at(b)], x_[at(a)], [this](double p, double q) { return (p - q) * scale_; });
    }
    void add(Index p, Index q, double factor, const Coordinates<2>& centroid, const Coordinates<2>& e) {
        for (std::size_t k = 0; k < 2; ++k) {
            gradient_[at(p)][k] += factor * centroid[k];
            gradient_[at(q)][k] -= factor * (centroid[k] - e[k]);
        }
    }
    [[gnu::noinline]] void add_exactly(Cell_index c, Cell_index n, Index p, Index q, double difference) {
        Mesh_cells<2> both;
        Corners<2> corners;
        for (const Cell_index cell : {c, n}) {
            auto& v = both.vertices.emplace_back();
            for (int i = 0; i < 3; ++i) v[static_cast<std::size_t>(i)] = table_.vertex(table_.corner(cell, i));
        }
        for (std::size_t i = 0; i < 3; ++i) corners[i] = x_[at(both.vertices[0][i])];
        for (const Index v : both.vertices[1])
            if (v != p && v != q && is_on_circumsphere<2>(corners, x_[at(v)])) return;
        const std::array<Index, 2> ring{0, 1};
        const Facet_measure<2> edge = exact_facet<2>(x_, both, p, q, ring);
        const Coordinates<2> e = to(p, q);
        const double length = std::hypot(x_[at(q)][0] - x_[at(p)][0], x_[at(q)][1] - x_[at(p)][1]);
        const double ratio = static_cast<double>(std::ldexp(edge.measure, edge.exponent) / length);
        Coordinates<2> centroid;
        for (std::size_t k = 0; k < 2; ++k) centroid[k] = std::ldexp(edge.centroid[k], edge.exponent - exponent_);
        add(p, q, difference * ratio, centroid, e);
    }

    const Corner_table<2>& table_;
    std::span<const Coordinates<2>> x_;
    std::vector<double> weights_;
    std::span<const Circumcentre<2>> centre_;
    int exponent_;
    double scale_;
    std::vector<Coordinates<2>> gradient_;
};

}  // namespace

std::vector<Coordinates<2>> edge_gradient(Kept_voronoi_volumes<2>& kept, std::span<const Coordinates<2>> x,
                                          std::span<const double> weights) {
    require_weights(weights.size(), x.size());
    const std::span<const double> volume = kept.update(x);
    const Corner_table<2>& table = kept.table();
    if (kept.centres().empty()) return voronoi_gradient<2>(x, mesh_cells<2>(table), weights);
    std::vector<double> of_bounded(weights.begin(), weights.end());
    for (std::size_t v = 0; v < of_bounded.size(); ++v)
        if (!std::isfinite(volume[v])) of_bounded[v] = 0;
    Edge_terms terms(table, x, std::move(of_bounded), kept.centres(), kept.exponent());
    for_each_inner_facet<2>(Cells_of_table<2>{table}, table.cells(), [&](const Inner_facet<2>& f) { terms.add(f); });
    return terms.take();
}

}  // namespace annulus::inline v1
