// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/voronoi_cut.h>
#include <annulus/measure/voronoi_facets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// The largest double for what is larger.
double as_double(long double x) {
    return static_cast<double>(std::min(x, static_cast<long double>(std::numeric_limits<double>::max())));
}

/// Sums over the facets of one Voronoi cell. long double, because of its range: no volume overflows or underflows.
template <int d>
struct Cell_sums {
    long double volume = 0, surface = 0;
    std::array<long double, static_cast<std::size_t>(d)> moment{};

    /// A pyramid over a facet with the vertex as apex; the centroid of the facet relative to it.
    void add(long double measure, long double height, const std::array<long double, static_cast<std::size_t>(d)>& to) {
        const long double pyramid = measure * height / d;
        surface += measure;
        volume += pyramid;
        for (std::size_t k = 0; k < d; ++k) moment[k] += pyramid * to[k] * d / (d + 1);
    }
};

template <int d>
class Diagram {
  public:
    Diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, const Voronoi_clip<d>* clip)
        : facets_(points, cells), sums_(points.size()), is_cut_(points.size(), 0) {
        list_facets();
        sort_pairs();
        if (clip != nullptr) cut_ = std::make_unique<Voronoi_cut<d>>(points, out_.pair, *clip);
        list_vertices();
        measure_facets();
        measure_cells();
    }
    Voronoi_diagram<d> take() { return std::move(out_); }

  private:
    [[nodiscard]] std::span<const Coordinates<d>> points() const { return facets_.input().points; }
    /// A facet as it was visited.
    struct Found {
        Voronoi_facet<d> facet;
        std::size_t ring_begin, ring_size;
    };

    void list_facets() {
        found_.reserve(points().size() * (d == 2 ? 3 : 8));
        facets_.for_each([this](const Voronoi_facet<d>& f) {
            found_.push_back({f, rings_.size(), f.ring.size()});
            rings_.insert(rings_.end(), f.ring.begin(), f.ring.end());
        });
    }

    /// Ascending by (i, j): counted by i, then sorted by j, a few each.
    void sort_pairs() {
        std::vector<std::size_t> begin(points().size() + 1, 0);
        for (const Found& f : found_) ++begin[at(f.facet.i) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        order_.resize(found_.size());
        std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
        for (std::size_t k = 0; k < found_.size(); ++k) order_[end[at(found_[k].facet.i)]++] = k;
        for (std::size_t v = 0; v < points().size(); ++v)
            std::sort(order_.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                      order_.begin() + static_cast<std::ptrdiff_t>(end[v]),
                      [this](std::size_t a, std::size_t b) { return found_[a].facet.j < found_[b].facet.j; });
        out_.pair.reserve(order_.size());
        for (const std::size_t k : order_) out_.pair.push_back({found_[k].facet.i, found_[k].facet.j});
    }

    void list_vertices() {
        if (!facets_.input().spans) return;
        const auto& cells = facets_.input().cells;
        const std::size_t n = cells.vertices.size();
        auto& first = out_.vertex_of_cell;
        first.resize(n);
        std::iota(first.begin(), first.end(), 0);
        const auto root = [&first](Index c) {
            while (first[at(c)] != c) c = first[at(c)] = first[at(first[at(c)])];
            return c;
        };
        for (std::size_t c = 0; c < n; ++c)
            for (std::size_t k = 0; k <= d; ++k) {
                const Index beyond = cells.neighbours[c][k];
                if (beyond < static_cast<Index>(c) || !facets_.is_cospherical(static_cast<Index>(c), k)) continue;
                const Index here = root(static_cast<Index>(c));
                const Index there = root(beyond);
                first[at(std::max(here, there))] = std::min(here, there);
            }
        out_.vertex.resize(n);
        for (std::size_t c = 0; c < n; ++c) {
            first[c] = root(static_cast<Index>(c));
            out_.vertex[c] = at(first[c]) == c ? facets_.vertex(static_cast<Index>(c)) : out_.vertex[at(first[c])];
        }
    }

    void measure_facets() {
        out_.ring_begin.push_back(0);
        for (const std::size_t k : order_) {
            const auto& [facet, begin, size] = found_[k];
            out_.distance.push_back(facet.distance);
            out_.vector.push_back(facet.vector);
            out_.exactly_empty.push_back(facet.empty ? 1 : 0);
            if (!facet.bounded && size > 0) out_.ring.push_back(-1);
            const std::span<const Index> ring(rings_.data() + begin, size);
            out_.ring.insert(out_.ring.end(), ring.begin(), ring.end());
            out_.ring_begin.push_back(static_cast<Index>(out_.ring.size()));
            if (cut_ && !facet.empty && !(facet.bounded && all_inside(ring)))
                is_cut_[at(facet.i)] = is_cut_[at(facet.j)] = 1;
            add(facet);
        }
    }
    [[nodiscard]] bool all_inside(std::span<const Index> ring) const {
        return std::all_of(ring.begin(), ring.end(), [this](Index c) {
            const double error = std::ldexp(facets_.centres()[at(c)].error, facets_.exponent());
            return cut_->is_inside(out_.vertex[at(c)], error);
        });
    }

    void add(const Voronoi_facet<d>& facet) {
        const bool finite = facet.measure < unbounded;
        const long double unit = std::ldexp(1.0L, facet.exponent);
        const long double measure = d == 2 ? facet.measure * unit : facet.measure * unit * unit;
        out_.measure.push_back(finite ? as_double(measure) : unbounded);
        std::array<long double, static_cast<std::size_t>(d)> from_i{};
        std::array<long double, static_cast<std::size_t>(d)> from_j{};
        auto& centroid = out_.centroid.emplace_back();
        for (std::size_t k = 0; k < d; ++k) {
            from_i[k] = facet.centroid[k] * unit;
            from_j[k] = from_i[k] - facet.vector[k];
            centroid[k] = points()[at(facet.i)][k] + static_cast<double>(from_i[k]);
        }
        if (facet.empty || !finite) return;
        const long double height = static_cast<long double>(facet.distance) / 2;
        sums_[at(facet.i)].add(measure, height, from_i);
        sums_[at(facet.j)].add(measure, height, from_j);
    }

    void measure_cells() {
        const auto& where = facets_.input().where;
        out_.volume.assign(points().size(), nowhere);
        out_.surface.assign(points().size(), nowhere);
        out_.cell_centroid.resize(points().size());
        for (std::size_t v = 0; v < points().size(); ++v) {
            out_.cell_centroid[v].fill(nowhere);
            if (where[v] == Vertex_location::nowhere) continue;
            if (is_cut_[v] != 0) measure_cut_cell(v);
            else if (where[v] == Vertex_location::hull) out_.volume[v] = out_.surface[v] = unbounded;
            else {
                const Cell_sums<d>& sums = sums_[v];
                out_.volume[v] = as_double(sums.volume);
                out_.surface[v] = as_double(sums.surface);
                for (std::size_t k = 0; k < d; ++k)
                    out_.cell_centroid[v][k] = static_cast<double>(points()[v][k] + sums.moment[k] / sums.volume);
            }
        }
    }

    /// Also the facets of this cell, if they are in the clip in part: with the larger of two neighbours.
    void measure_cut_cell(std::size_t v) {
        const Cut_cell<d> cell = cut_->cell(static_cast<Index>(v));
        out_.volume[v] = cut_->measure(cell.content.volume, d);
        out_.surface[v] = cut_->measure(cell.surface, d - 1);
        out_.cell_centroid[v] = cut_->position(static_cast<Index>(v), cell.content.centroid);
        const auto others = cut_->neighbours(static_cast<Index>(v));
        for (std::size_t n = 0; n < others.size(); ++n) {
            if (at(others[n]) < v) continue;
            const std::array<Index, 2> pair{static_cast<Index>(v), others[n]};
            const auto k = static_cast<std::size_t>(std::lower_bound(out_.pair.begin(), out_.pair.end(), pair) -
                                                    out_.pair.begin());
            const auto& [facet, begin, size] = found_[order_[k]];
            if (facet.empty || (facet.bounded && all_inside({rings_.data() + begin, size}))) continue;
            const Cell_side<d>& part = cell.facets[n];
            out_.measure[k] = cut_->measure(part.measure, d - 1);
            if (part.measure > 0) out_.centroid[k] = cut_->position(static_cast<Index>(v), part.centroid);
            else out_.centroid[k].fill(nowhere);
        }
    }

    Voronoi_facets<d> facets_;
    std::vector<Found> found_;
    std::vector<Index> rings_;
    std::vector<std::size_t> order_;
    std::vector<Cell_sums<d>> sums_;
    std::unique_ptr<Voronoi_cut<d>> cut_;
    std::vector<char> is_cut_;  // by vertex: whether a part of its cell may be outside the clip
    Voronoi_diagram<d> out_;
};

}  // namespace

template <int d>
Voronoi_diagram<d> voronoi_diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                   const Voronoi_clip<d>* clip) {
    return Diagram<d>(points, cells, clip).take();
}

template Voronoi_diagram<2> voronoi_diagram<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                               const Voronoi_clip<2>*);
template Voronoi_diagram<3> voronoi_diagram<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                               const Voronoi_clip<3>*);

}  // namespace annulus::inline v1
