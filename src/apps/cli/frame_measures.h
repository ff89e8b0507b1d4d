// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <apps/cli/boxed_mesh.h>

#include <vector>

namespace annulus::inline v1::cli {

/// The Voronoi cells of a frame, by vertex index.
struct Cell_measures {
    std::vector<double> volume;     ///< infinite where the cell is unbounded
    std::vector<Index> neighbours;  ///< open: of the triangulation; periodic: with facets that are not exactly empty
    std::vector<char> whole{};      ///< whether the clip takes nothing of the cell; empty without a clip
};
template <int d>
[[nodiscard]] Cell_measures cell_measures(const Moving_mesh<d>& dt);
template <int d>
[[nodiscard]] Cell_measures cell_measures(const Boxed_mesh<d>& dt);

/// Two Voronoi cells that the triangulation makes neighbours: once, the first index not above the second; of a point
/// and its own image the shift whose first component other than 0 is positive.
template <int d>
struct Facet_pair {
    Index first = 0, second = 0;
    Shift<d> shift{};    ///< of the second point, by vectors of the box; 0 in an open mesh
    double measure = 0;  ///< of the facet: its length or area; 0 only where it is exactly empty, infinite if unbounded
};
/// Ascending.
template <int d>
[[nodiscard]] std::vector<Facet_pair<d>> facet_pairs(const Moving_mesh<d>& dt);
template <int d>
[[nodiscard]] std::vector<Facet_pair<d>> facet_pairs(const Boxed_mesh<d>& dt);

/// What is measured in a frame, as far as it is asked for.
template <int d>
struct Frame_measures {
    Cell_measures cells;
    std::vector<Facet_pair<d>> pairs;
};
/// Of cells and facets that are intersected with a clip, so that all are finite: 0 also for those outside it.
template <int d>
[[nodiscard]] Frame_measures<d> clipped_measures(const Moving_mesh<d>& dt, const Voronoi_clip<d>& clip);

extern template Frame_measures<2> clipped_measures(const Moving_mesh<2>&, const Voronoi_clip<2>&);
extern template Frame_measures<3> clipped_measures(const Moving_mesh<3>&, const Voronoi_clip<3>&);
extern template Cell_measures cell_measures(const Moving_mesh<2>&);
extern template Cell_measures cell_measures(const Moving_mesh<3>&);
extern template Cell_measures cell_measures(const Boxed_mesh<2>&);
extern template Cell_measures cell_measures(const Boxed_mesh<3>&);
extern template std::vector<Facet_pair<2>> facet_pairs(const Moving_mesh<2>&);
extern template std::vector<Facet_pair<3>> facet_pairs(const Moving_mesh<3>&);
extern template std::vector<Facet_pair<2>> facet_pairs(const Boxed_mesh<2>&);
extern template std::vector<Facet_pair<3>> facet_pairs(const Boxed_mesh<3>&);

}  // namespace annulus::inline v1::cli
