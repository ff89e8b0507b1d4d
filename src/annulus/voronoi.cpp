// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/voronoi_cut.h>
#include <annulus/moving_mesh.h>

#include <limits>
#include <span>

namespace annulus::inline v1 {

namespace {

/// Of the only vertex: no cell names it.
template <int d>
void measure_all(Voronoi_diagram<d>& diagram, std::size_t v, const Voronoi_clip<d>* clip) {
    diagram.volume[v] = diagram.surface[v] = std::numeric_limits<double>::infinity();
    if (clip == nullptr) return;
    Coordinates<d> middle;
    for (std::size_t k = 0; k < d; ++k) middle[k] = 0.5 * clip->lower[k] + 0.5 * clip->upper[k];
    const Voronoi_cut<d> cut(std::span(&middle, 1), {}, *clip);
    const Cut_cell<d> cell = cut.cell(0);
    diagram.volume[v] = cut.measure(cell.content.volume, d);
    diagram.surface[v] = cut.measure(cell.surface, d - 1);
    diagram.cell_centroid[v] = cut.position(0, cell.content.centroid);
}

/// Completes the diagram of a mesh that has one vertex.
template <int d>
Voronoi_diagram<d> of_mesh(const Moving_mesh<d>& mesh, Voronoi_diagram<d> out, const Voronoi_clip<d>* clip) {
    if (mesh.number_of_vertices() != 1) return out;
    for (std::size_t v = 0; v < out.volume.size(); ++v)
        if (mesh.is_vertex(static_cast<Index>(v))) measure_all(out, v, clip);
    return out;
}

template <int d>
Voronoi_diagram<d> clipped(const Moving_mesh<d>& mesh, const Voronoi_clip<d>& clip) {
    return of_mesh<d>(mesh, voronoi_diagram<d>(mesh.points(), mesh.cell_lists()->cells, &clip), &clip);
}

}  // namespace

Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh) { return of_mesh<2>(mesh, mesh.voronoi_diagram(), nullptr); }
Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh) { return of_mesh<3>(mesh, mesh.voronoi_diagram(), nullptr); }
Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh, const Voronoi_clip<2>& clip) { return clipped<2>(mesh, clip); }
Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh, const Voronoi_clip<3>& clip) { return clipped<3>(mesh, clip); }

}  // namespace annulus::inline v1
