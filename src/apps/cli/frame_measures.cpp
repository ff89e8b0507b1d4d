// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_measures.h>

#include <utility>

namespace annulus::inline v1::cli {

namespace {

template <int d>
std::vector<Facet_pair<d>> pairs_of(const Voronoi_diagram<d>& diagram) {
    std::vector<Facet_pair<d>> result;
    result.reserve(diagram.pair.size());
    for (std::size_t k = 0; k < diagram.pair.size(); ++k)
        result.push_back({diagram.pair[k][0], diagram.pair[k][1], {}, diagram.measure[k]});
    return result;
}

}  // namespace

template <int d>
Cell_measures cell_measures(const Moving_mesh<d>& dt) {
    const Mesh_cells<d> cells = dt.cells();
    return {voronoi_volumes<d>(dt.points(), cells), voronoi_neighbour_counts<d>(dt.index_bound(), cells)};
}

template <int d>
Cell_measures cell_measures(const Boxed_mesh<d>& dt) {
    return {dt.mesh().voronoi_volumes(), dt.mesh().neighbour_counts()};
}

template <int d>
std::vector<Facet_pair<d>> facet_pairs(const Moving_mesh<d>& dt) {
    return pairs_of(voronoi_diagram<d>(dt.points(), dt.cells()));
}

template <int d>
std::vector<Facet_pair<d>> facet_pairs(const Boxed_mesh<d>& dt) {
    const Periodic_neighbours<d> all = dt.mesh().neighbours();
    std::vector<Facet_pair<d>> result;
    result.reserve(all.first.size() / 2);
    for (std::size_t k = 0; k < all.first.size(); ++k)
        if (all.first[k] < all.second[k] || (all.first[k] == all.second[k] && all.shift[k] > Shift<d>{}))
            result.push_back({all.first[k], all.second[k], all.shift[k], all.area[k]});
    return result;
}

template <int d>
Frame_measures<d> clipped_measures(const Moving_mesh<d>& dt, const Voronoi_clip<d>& clip) {
    Voronoi_diagram<d> diagram = voronoi(dt, clip);
    Cell_measures cells = cell_measures(dt);
    cells.whole.resize(cells.volume.size());
    for (std::size_t v = 0; v < cells.volume.size(); ++v)
        cells.whole[v] = diagram.volume[v] >= (1 - 1e-9) * cells.volume[v];  // of an unbounded cell: never
    cells.volume = std::move(diagram.volume);
    return {std::move(cells), pairs_of(diagram)};
}

template Frame_measures<2> clipped_measures(const Moving_mesh<2>&, const Voronoi_clip<2>&);
template Frame_measures<3> clipped_measures(const Moving_mesh<3>&, const Voronoi_clip<3>&);
template Cell_measures cell_measures(const Moving_mesh<2>&);
template Cell_measures cell_measures(const Moving_mesh<3>&);
template Cell_measures cell_measures(const Boxed_mesh<2>&);
template Cell_measures cell_measures(const Boxed_mesh<3>&);
template std::vector<Facet_pair<2>> facet_pairs(const Moving_mesh<2>&);
template std::vector<Facet_pair<3>> facet_pairs(const Moving_mesh<3>&);
template std::vector<Facet_pair<2>> facet_pairs(const Boxed_mesh<2>&);
template std::vector<Facet_pair<3>> facet_pairs(const Boxed_mesh<3>&);

}  // namespace annulus::inline v1::cli
