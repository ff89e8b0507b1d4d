// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/measure/circumcentre.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/measure/voronoi_terms.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Mesh_cells as Voronoi_terms reads them.
template <int d>
struct Listed_cells {
    const Mesh_cells<d>& cells;

    [[nodiscard]] Index corner(Index c, std::size_t i) const { return cells.vertices[at(c)][i]; }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const { return cells.neighbours[at(c)][i]; }
    [[nodiscard]] static bool is_finite(Index) { return true; }
};

template <int d>
class Fresh_volumes {
  public:
    Fresh_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells) : x_(points), cells_(cells) {}

    std::vector<double> operator()(Voronoi_counts& counts) {
        const bool spans = find_hull();
        sum_.assign(x_.size(), {0, unbounded});  // where nothing is added, integers compute the whole sum
        if (spans) {
            find_circumcentres();
            if (!centre_.empty()) add_facets();
        }
        return finish(counts);
    }

  private:
    using Cell = std::array<Index, static_cast<std::size_t>(d + 1)>;
    enum class Vertex_location : char { nowhere, hull, inside };

    void require_whole(const Cell& neighbours) const {
        for (const Index n : neighbours)
            if (n != cells_.outside && (n < 0 || at(n) >= cells_.vertices.size()))
                throw Error(Error_code::bad_input,
                            "there is no cell " + std::to_string(n) + " that could be a neighbour");
    }

    /// Finds the kind of each vertex, and the unit. False where no cell has d + 1 corners.
    bool find_hull() {
        if (cells_.neighbours.size() != cells_.vertices.size())
            throw Error(Error_code::wrong_size, "there are neighbours of " + std::to_string(cells_.neighbours.size()) +
                                                    " cells for " + std::to_string(cells_.vertices.size()) + " cells");
        where_.assign(x_.size(), Vertex_location::nowhere);
        double largest = 0;
        bool flat = false;
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c) {
            const Cell& cell = cells_.vertices[c];
            require_whole(cells_.neighbours[c]);
            const bool padded = cell[d] == none;
            flat = flat || padded;
            for (const Index v : cell) {
                if (padded && v == none) continue;
                if (v < 0 || at(v) >= x_.size())
                    throw Error(Error_code::unknown_vertex,
                                "a cell names vertex " + std::to_string(v) + " of " + std::to_string(x_.size()), {v});
                if (where_[at(v)] != Vertex_location::nowhere) continue;
                require_in_domain(x_[at(v)], "vertex", v);
                for (const double k : x_[at(v)]) largest = std::max(largest, std::fabs(k));
                where_[at(v)] = Vertex_location::inside;
            }
            for (std::size_t i = 0; i <= d; ++i) {
                if (!padded && cells_.neighbours[c][i] != cells_.outside) continue;
                for (std::size_t k = 0; k <= d; ++k)
                    if (cell[k] != none && (padded || k != i)) where_[at(cell[k])] = Vertex_location::hull;
            }
        }
        if (flat) std::replace(where_.begin(), where_.end(), Vertex_location::inside, Vertex_location::hull);
        exponent_ = largest == 0 ? 0 : std::ilogb(largest) + 1;
        return !flat;
    }

    void find_circumcentres() {
        const double scale = std::ldexp(1.0, -exponent_);
        if (!std::isnormal(scale)) return;  // every coordinate is subnormal
        centre_.resize(cells_.vertices.size());
        for (std::size_t c = 0; c < centre_.size(); ++c) {
            Corners<d> corners;
            for (std::size_t i = 0; i <= d; ++i) corners[i] = x_[at(cells_.vertices[c][i])];
            centre_[c] = circumcentre_of<d>(cells_.vertices[c], corners, scale);
        }
    }

    void add_facets() {
        std::fill(sum_.begin(), sum_.end(), Voronoi_sum{});
        const Voronoi_terms<d> terms(x_, centre_, std::ldexp(1.0, -exponent_), sum_);
        const Listed_cells<d> cells{cells_};
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c) terms.add_facets(cells, static_cast<Index>(c));
    }

    /// Scales a sum back to the caller's unit where it is accurate enough, computes the others from exact
    /// circumcentres, and writes infinity or NaN for unbounded cells and free indices.
    std::vector<double> finish(Voronoi_counts& counts) {
        std::vector<double> volume(x_.size());
        std::vector<Index> poor;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (where_[v] != Vertex_location::inside) {
                volume[v] = where_[v] == Vertex_location::hull ? unbounded : std::numeric_limits<double>::quiet_NaN();
                continue;
            }
            ++counts.bounded;
            if (sum_[v].is_good()) volume[v] = voronoi_volume<d>(sum_[v], exponent_);
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
    int exponent_ = 0;  // of the unit: every coordinate is below 2^exponent
    std::vector<Vertex_location> where_;
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
