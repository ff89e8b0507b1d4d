// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_places.h>
#include <annulus/measure/periodic_voronoi.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/measure/voronoi_terms.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace annulus::inline v1 {

namespace {

/// The cells as for_each_inner_facet reads them: beyond a facet there is a cell in the same frame. Images with an
/// offset are points of their own, and a cell in another frame than its own is one more cell, of which a corner and the
/// circumcentre are read.
template <int d>
class Unfolded {
  public:
    Unfolded(const Periodic_table<d>& table, const Periodic_places<d>& places, std::span<const Coordinates<d>> place)
        : table_(table),
          places_(places),
          point_(place.begin(), place.end()),
          centre_(places.centres().begin(), places.centres().end()) {
        vertex_.resize(place.size());
        std::iota(vertex_.begin(), vertex_.end(), Index{0});
        corner_ = table.vertex;
        beyond_.resize(table.size());
        for (std::size_t c = 0; c < table.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                if (!table.offset[c][i].is_zero()) corner_[c][i] = new_point(table.image(c, i));
                look_beyond(c, i);
            }
    }

    [[nodiscard]] Index corner(Index c, std::size_t i) const { return corner_[at(c)][i]; }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const { return beyond_[at(c)][i]; }
    [[nodiscard]] static bool is_finite(Index) { return true; }
    [[nodiscard]] static bool owns(Index, Index n) { return n != not_owned; }
    [[nodiscard]] std::span<const Coordinates<d>> points() const { return point_; }
    [[nodiscard]] std::span<const Circumcentre<d>> centres() const { return centre_; }
    [[nodiscard]] Index vertex_of(std::size_t point) const { return vertex_[point]; }

  private:
    static constexpr Index not_owned = -1;

    Index new_point(Image<d> s) {
        point_.push_back(places_.at(s));
        vertex_.push_back(s.vertex);
        return static_cast<Index>(point_.size() - 1);
    }
    void look_beyond(std::size_t c, std::size_t i) {
        const std::size_t m = table_.cell_of(table_.twin[c][i]);
        const Offset<d> t = table_.translation(c, i);
        if (m < c || t.is_zero()) {
            beyond_[c][i] = m < c ? not_owned : static_cast<Index>(m);
            return;
        }
        beyond_[c][i] = static_cast<Index>(corner_.size());
        const Index base = new_point(table_.image(m, 0, t));
        corner_.emplace_back()[0] = base;
        centre_.push_back(centre_[m]);
    }

    const Periodic_table<d>& table_;
    const Periodic_places<d>& places_;
    std::vector<Coordinates<d>> point_;
    std::vector<Index> vertex_;  // by point
    std::vector<Circumcentre<d>> centre_;
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> corner_;
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> beyond_;
};

/// The Voronoi cell of a vertex in integers: the cells around its image at offset 0, as a mesh.
template <int d>
double exact_volume(const Periodic_table<d>& table, const Periodic_places<d>& places, Index v,
                    std::span<const Corner_index> around) {
    const Image<d> centre(v);
    std::vector<Coordinates<d>> points{places.at(centre)};
    Mesh_cells<d> star;
    const auto shift_of = [&](Corner_index h) {
        return centre.label - table.offset[table.cell_of(h)][table.slot_of(h)];
    };
    for (const Corner_index h : around) {
        const std::size_t c = table.cell_of(h);
        auto& vertices = star.vertices.emplace_back();
        auto& neighbours = star.neighbours.emplace_back();
        for (std::size_t i = 0; i <= d; ++i) {
            vertices[i] = 0;
            neighbours[i] = Mesh_cells<d>::outside;
            if (i == table.slot_of(h)) continue;
            vertices[i] = static_cast<Index>(points.size());
            points.push_back(places.at(table.image(c, i, shift_of(h))));
            const std::size_t m = table.cell_of(table.twin[c][i]);
            const Offset<d> shift = shift_of(h) + table.translation(c, i);
            const Corner_index there = table.corner(m, table.slot(m, centre, shift));
            neighbours[i] = static_cast<Index>(std::find(around.begin(), around.end(), there) - around.begin());
        }
    }
    std::vector<std::size_t> all(around.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return exact_voronoi_volume<d>(points, star, 0, all);
}

}  // namespace

template <int d>
std::vector<double> periodic_voronoi_volumes(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                             std::span<const Coordinates<d>> place) {
    const Periodic_places<d> places(table, lattice, place);
    const Unfolded<d> cells(table, places, place);
    std::vector<Voronoi_sum> sum(cells.points().size());
    const Voronoi_terms<d> terms(cells.points(), cells.centres(), places.scale(), sum);
    terms.add_facets(cells, all_cells(table.size()));
    for (std::size_t k = place.size(); k < sum.size(); ++k)
        sum[at(cells.vertex_of(k))].add(sum[k].volume, sum[k].error);
    const Volume_unit<d> unit(places.exponent());
    std::vector<double> volume(place.size());
    std::vector<char> poor(place.size(), 0);
    for (std::size_t v = 0; v < volume.size(); ++v) {
        if (!is_place<d>(place[v])) volume[v] = std::numeric_limits<double>::quiet_NaN();
        else if (sum[v].is_good()) volume[v] = unit.volume(sum[v]);
        else poor[v] = 1;
    }
    if (std::find(poor.begin(), poor.end(), 1) == poor.end()) return volume;
    std::vector<std::vector<Corner_index>> around(place.size());
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i)
            if (const std::size_t v = at(table.vertex[c][i]); poor[v] != 0) around[v].push_back(table.corner(c, i));
    for (std::size_t v = 0; v < volume.size(); ++v)
        if (poor[v] != 0) volume[v] = exact_volume(table, places, static_cast<Index>(v), around[v]);
    return volume;
}

template std::vector<double> periodic_voronoi_volumes(const Periodic_table<2>&, const Lattice<2>&,
                                                      std::span<const Coordinates<2>>);
template std::vector<double> periodic_voronoi_volumes(const Periodic_table<3>&, const Lattice<3>&,
                                                      std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
