// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/report/shades.h>

#include <array>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A filled polygon of a picture: a Voronoi cell, the section of a tetrahedron.
struct Face {
    std::vector<Coordinates<2>> corners;
    unsigned char shade = 0;                          ///< see shades.h
    std::vector<std::vector<Coordinates<2>>> more{};  ///< its other pieces, and its holes, in the other direction
};

/// What the points of a picture are: of a periodic box also images of its vertices; of a cut in 3D no vertices, but
/// where the plane crosses an edge.
enum class Dots { vertices, images, crossings };
/// "1 vertex", "229 vertices and images", "220 cut edges".
[[nodiscard]] std::string counted_dots(std::size_t n, Dots dots);

/// Points and edges to draw, already in 2D: of a 3D triangulation a projection or a cut. Faces are below them.
struct Picture {
    std::vector<Coordinates<2>> points;
    std::vector<std::array<Index, 2>> edges;
    std::string caption;
    std::vector<Face> faces{};
    Shading shading = Shading::neighbours;  ///< of the faces
    Dots dots = Dots::vertices;
    std::vector<std::vector<Coordinates<2>>> outline{};  ///< closed lines: the domain, the periodic box
};

/// The square that a picture shows.
struct Window {
    Coordinates<2> centre{};
    double half_side = 1;
    bool whole = true;  ///< false when vertices lie outside
};

/// A square around all points, or, when there are more than `most`, the square in the middle of their bounding box that
/// holds about `within`. Linear.
[[nodiscard]] Window window_of(const std::vector<Coordinates<2>>& points, std::size_t most = 12000,
                               std::size_t within = 5000);

/// Number of points in the window.
[[nodiscard]] std::size_t points_in(const Window& window, const std::vector<Coordinates<2>>& points);

/// The picture as one SVG element, as large as its container; y goes up. Edges are thin, and vertices are dots when
/// there are few enough to tell apart; crossings are not drawn. The outline is above edges and faces. Of faces those
/// with a corner in the window are drawn. Throws Error(unknown_vertex) for an edge that names no point. Linear.
[[nodiscard]] std::string svg_triangulation(const Picture& picture, const Window& window);

}  // namespace annulus::inline v1
