// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/convex_cell.h>
#include <annulus/moving_mesh.h>

#include <limits>

namespace annulus::inline v1 {

namespace {

/// Of the only vertex: no cell names it.
template <int d>
void measure_all(Voronoi_diagram<d>& diagram, std::size_t v, const Voronoi_clip<d>* clip) {
    diagram.volume[v] = diagram.surface[v] = std::numeric_limits<double>::infinity();
    if (clip == nullptr) return;
    Convex_cell<d> cell(clip->lower, clip->upper, -1);
    for (const auto& [normal, offset] : clip->half_spaces) cell.cut(normal, offset, -1);
    const Cell_content<d> content = cell.content();
    diagram.volume[v] = content.volume;
    diagram.cell_centroid[v] = content.centroid;
    diagram.surface[v] = 0;
    for (const auto& side : cell.sides()) diagram.surface[v] += side.measure;
}

template <int d>
Voronoi_diagram<d> of_mesh(const Moving_mesh<d>& mesh, const Voronoi_clip<d>* clip) {
    Voronoi_diagram<d> out = voronoi_diagram<d>(mesh.points(), mesh.cell_lists()->cells, clip);
    if (mesh.number_of_vertices() != 1) return out;
    for (std::size_t v = 0; v < out.volume.size(); ++v)
        if (mesh.is_vertex(static_cast<Index>(v))) measure_all(out, v, clip);
    return out;
}

}  // namespace

Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh) { return of_mesh<2>(mesh, nullptr); }
Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh) { return of_mesh<3>(mesh, nullptr); }
Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh, const Voronoi_clip<2>& clip) { return of_mesh<2>(mesh, &clip); }
Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh, const Voronoi_clip<3>& clip) { return of_mesh<3>(mesh, &clip); }

}  // namespace annulus::inline v1
