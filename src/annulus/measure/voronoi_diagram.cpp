// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/voronoi_cut.h>
#include <annulus/measure/voronoi_facets.h>
#include <annulus/measure/voronoi_kept_diagram.h>
#include <annulus/measure/voronoi_records.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

template <int d>
class Diagram {
  public:
    Diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, const Voronoi_clip<d>* clip)
        : facets_(points, cells),
          found_(points, facets_.exponent(), points.size() * (d == 2 ? 3 : 8)),
          is_cut_(points.size(), 0) {
        facets_.for_each([this](const Voronoi_facet<d>& f) { found_.add(f, f.ring); });
        sort_pairs();
        if (clip != nullptr) cut_ = std::make_unique<Voronoi_cut<d>>(points, out_.pair, *clip);
        list_vertices();
        write_facets();
        measure_cells();
    }
    Voronoi_diagram<d> take() { return std::move(out_); }
    /// What else was found; this object is of no use afterwards, except for take().
    Diagram_parts<d> take_parts() {
        return {facets_.take_centres(), facets_.exponent(), facets_.input().spans, std::move(cospherical_)};
    }

  private:
    [[nodiscard]] std::span<const Coordinates<d>> points() const { return facets_.input().points; }
    /// Ascending by (i, j).
    void sort_pairs() {
        const auto found = found_.records();
        order_ = found_.in_order([found](std::size_t a, std::size_t b) { return found[a].j < found[b].j; });
        const auto open = std::count_if(found.begin(), found.end(), [](const auto& f) { return !f.bounded; });
        reserve_facets(out_, found.size(), found_.length_of_rings() + static_cast<std::size_t>(open));
        for (const std::size_t k : order_) out_.pair.push_back({found[k].i, found[k].j});
    }

    void list_vertices() {
        if (!facets_.input().spans) return;
        const auto& cells = facets_.input().cells;
        const std::size_t n = cells.vertices.size();
        for (std::size_t c = 0; c < n; ++c)
            for (std::size_t k = 0; k <= d; ++k) {
                const Index here = static_cast<Index>(c);
                const Index beyond = cells.neighbours[c][k];
                if (beyond > here && facets_.is_cospherical(here, k)) cospherical_.push_back({here, beyond});
            }
        out_.vertex_of_cell = least_connected(n, cospherical_);
        out_.vertex.resize(n);
        for (std::size_t c = 0; c < n; ++c) {
            const Index first = out_.vertex_of_cell[c];
            out_.vertex[c] = at(first) == c ? facets_.vertex(first) : out_.vertex[at(first)];
        }
    }

    void write_facets() {
        out_.ring_begin.push_back(0);
        for (const std::size_t k : order_) {
            const Facet_record<d>& f = found_.records()[k];
            found_.write(f, out_);
            if (cut_ && !f.empty && !(f.bounded && all_inside(found_.ring_of(f))))
                is_cut_[at(f.i)] = is_cut_[at(f.j)] = 1;
        }
    }
    [[nodiscard]] bool all_inside(std::span<const Index> ring) const {
        return std::all_of(ring.begin(), ring.end(), [this](Index c) {
            const double error = std::ldexp(facets_.centres()[at(c)].error, facets_.exponent());
            return cut_->is_inside(out_.vertex[at(c)], error);
        });
    }

    void measure_cells() {
        const auto& where = facets_.input().where;
        out_.volume.resize(points().size());
        out_.surface.resize(points().size());
        out_.cell_centroid.resize(points().size());
        for (std::size_t v = 0; v < points().size(); ++v)
            if (is_cut_[v] != 0) measure_cut_cell(v);
            else found_.write_cell(v, where[v], out_);
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
            const Facet_record<d>& f = found_.records()[order_[k]];
            if (f.empty || (f.bounded && all_inside(found_.ring_of(f)))) continue;
            const Cell_side<d>& part = cell.facets[n];
            out_.measure[k] = cut_->measure(part.measure, d - 1);
            if (part.measure > 0) out_.centroid[k] = cut_->position(static_cast<Index>(v), part.centroid);
            else out_.centroid[k].fill(nowhere);
        }
    }

    Voronoi_facets<d> facets_;
    Facet_records<d> found_;
    std::vector<std::array<Index, 2>> cospherical_;
    std::vector<std::size_t> order_;
    std::unique_ptr<Voronoi_cut<d>> cut_;
    std::vector<char> is_cut_;  // by vertex: whether a part of its cell may be outside the clip
    Voronoi_diagram<d> out_;
};

}  // namespace

std::vector<Index> least_connected(std::size_t n, std::span<const std::array<Index, 2>> pairs) {
    std::vector<Index> first(n);
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&first](Index c) {
        while (first[at(c)] != c) c = first[at(c)] = first[at(first[at(c)])];
        return c;
    };
    for (const auto& [a, b] : pairs) {
        const Index here = root(a);
        const Index there = root(b);
        first[at(std::max(here, there))] = std::min(here, there);
    }
    for (std::size_t c = 0; c < n; ++c) first[c] = root(static_cast<Index>(c));
    return first;
}

template <int d>
Voronoi_diagram<d> fresh_diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                 const Voronoi_clip<d>* clip, Diagram_parts<d>* parts) {
    Diagram<d> diagram(points, cells, clip);
    if (parts != nullptr) *parts = diagram.take_parts();
    return diagram.take();
}

template <int d>
Voronoi_diagram<d> voronoi_diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                   const Voronoi_clip<d>* clip) {
    return fresh_diagram<d>(points, cells, clip, nullptr);
}

template Voronoi_diagram<2> fresh_diagram(std::span<const Coordinates<2>>, const Mesh_cells<2>&, const Voronoi_clip<2>*,
                                          Diagram_parts<2>*);
template Voronoi_diagram<3> fresh_diagram(std::span<const Coordinates<3>>, const Mesh_cells<3>&, const Voronoi_clip<3>*,
                                          Diagram_parts<3>*);
template Voronoi_diagram<2> voronoi_diagram<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                               const Voronoi_clip<2>*);
template Voronoi_diagram<3> voronoi_diagram<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                               const Voronoi_clip<3>*);

}  // namespace annulus::inline v1
