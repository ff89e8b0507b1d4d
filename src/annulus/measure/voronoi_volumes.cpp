// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/measure/voronoi_input.h>
#include <annulus/measure/voronoi_terms.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Mesh_cells as for_each_inner_facet reads them.
template <int d>
struct Listed_cells {
    const Mesh_cells<d>& cells;

    [[nodiscard]] Index corner(Index c, std::size_t i) const { return cells.vertices[at(c)][i]; }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const { return cells.neighbours[at(c)][i]; }
    [[nodiscard]] static bool is_finite(Index) { return true; }
    [[nodiscard]] static bool owns(Index c, Index n) { return n != Mesh_cells<d>::outside && n < c; }
};

template <int d>
class Fresh_volumes {
  public:
    Fresh_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells)
        : x_(points), cells_(cells), input_(points, cells) {}

    std::vector<double> operator()(Voronoi_counts& counts) {
        sum_.assign(x_.size(), {0, unbounded});  // where nothing is added, integers compute the whole sum
        // If every coordinate is subnormal, there is no such unit.
        if (const double scale = std::ldexp(1.0, -input_.exponent); input_.spans && std::isnormal(scale)) {
            centre_ = input_.circumcentres(scale);
            add_facets(scale);
        }
        return finish(counts);
    }

  private:
    using Cell = std::array<Index, static_cast<std::size_t>(d + 1)>;

    void add_facets(double scale) {
        std::fill(sum_.begin(), sum_.end(), Voronoi_sum{});
        const Voronoi_terms<d> terms(x_, centre_, scale, sum_);
        const Listed_cells<d> cells{cells_};
        terms.add_facets(cells, all_cells(cells_.vertices.size()));
    }

    /// Scales a sum back to the caller's unit where it is accurate enough, computes the others from exact
    /// circumcentres, and writes infinity or NaN for unbounded cells and free indices.
    std::vector<double> finish(Voronoi_counts& counts) {
        const Volume_unit<d> unit(input_.exponent);
        std::vector<double> volume(x_.size());
        std::vector<Index> poor;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (input_.where[v] != Vertex_location::inside) {
                volume[v] =
                    input_.where[v] == Vertex_location::hull ? unbounded : std::numeric_limits<double>::quiet_NaN();
                continue;
            }
            ++counts.bounded;
            if (sum_[v].is_good()) volume[v] = unit.volume(sum_[v]);
            else poor.push_back(static_cast<Index>(v));
        }
        counts.exact = poor.size();
        if (!poor.empty()) compute_exactly(poor, volume);
        return volume;
    }

    void compute_exactly(std::span<const Index> poor, std::vector<double>& volume) const {
        // The end of the cells around each of these vertices, in one array; afterwards the beginning.
        std::vector<std::size_t> end(x_.size(), 0);
        std::vector<char> wanted(x_.size(), 0);
        for (const Index v : poor) wanted[at(v)] = 1;
        for (const Cell& cell : cells_.vertices)
            for (const Index v : cell) end[at(v)] += static_cast<std::size_t>(wanted[at(v)]);
        std::size_t total = 0;
        for (const Index v : poor) end[at(v)] = total += end[at(v)];
        std::vector<std::size_t> around(total);
        for (std::size_t c = cells_.vertices.size(); c-- > 0;)
            for (const Index v : cells_.vertices[c])
                if (wanted[at(v)] != 0) around[--end[at(v)]] = c;
        for (std::size_t k = 0; k < poor.size(); ++k) {
            const std::size_t begin = end[at(poor[k])];
            const std::size_t next = k + 1 < poor.size() ? end[at(poor[k + 1])] : total;
            volume[at(poor[k])] = exact_voronoi_volume<d>(
                x_, cells_, poor[k], std::span<const std::size_t>(around).subspan(begin, next - begin));
        }
    }

    std::span<const Coordinates<d>> x_;
    const Mesh_cells<d>& cells_;
    const Voronoi_input<d> input_;
    std::vector<Circumcentre<d>> centre_;
    std::vector<Voronoi_sum> sum_;
};

}  // namespace

template <int d>
std::vector<double> voronoi_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                    Voronoi_counts* counts) {
    require_sound_environment();
    Voronoi_counts counted;
    std::vector<double> volumes = Fresh_volumes<d>(points, cells)(counted);
    if (counts != nullptr) *counts = counted;
    return volumes;
}

template std::vector<double> voronoi_volumes<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Voronoi_counts*);
template std::vector<double> voronoi_volumes<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Voronoi_counts*);

}  // namespace annulus::inline v1
