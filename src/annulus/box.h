// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// How many times each vector of a box is added to a position: it names one image of a point.
template <int d>
using Shift = std::array<std::int32_t, static_cast<std::size_t>(d)>;

/// A periodic box: d vectors, and with every point its translates by all integer combinations of them. The vectors may
/// be orthogonal or not (triclinic), in any orientation, left-handed too. Lengths are in the caller's unit.
///
/// Every direction is periodic. A triangulation that is periodic in some directions only has a hull, and is not
/// available.
template <int d>
class Box {
  public:
    using Vectors = std::array<Coordinates<d>, static_cast<std::size_t>(d)>;

    /// A box with these vectors. Throws Error: not_finite and out_of_domain for coordinates (no vector may extend
    /// beyond 2^150 along an axis, nor the box less than 2^-150); usage where the vectors span no volume, or after
    /// rounding to their grid none (docs/periodic.md); where the box is too skewed, that is a coordinate of a vector is
    /// more than eight times the extent of a reduced box of the same lattice along that axis, or a reduced box takes a
    /// vector more than 64 times; and where it is too thin in a direction that is not along an axis: between 1e-7 and
    /// 1e-9 of its length, for then the rounded vectors are those of another lattice. Along the axes it may be as thin
    /// as it likes. O(1), 7 microseconds in 2D and 20 in 3D.
    explicit Box(const Vectors& vectors);
    /// A box with edges of these lengths along the axes. Throws as the constructor does. A negative length is that of
    /// an edge in the other direction.
    [[nodiscard]] static Box orthorhombic(const Coordinates<d>& lengths) {
        Vectors vectors{};
        for (std::size_t i = 0; i < d; ++i) vectors[i][i] = lengths[i];
        return Box(vectors);
    }

    [[nodiscard]] const Vectors& vectors() const noexcept { return vectors_; }
    /// The area or volume: the determinant's absolute value, computed in doubles.
    [[nodiscard]] double volume() const noexcept;

    friend bool operator==(const Box&, const Box&) = default;

  private:
    /// What a box has been rounded to, which is not examined again: at the limits it may be beyond them.
    struct Rounded {
        Vectors vectors;
    };
    explicit Box(const Rounded& rounded) noexcept : vectors_(rounded.vectors) {}
    template <int>
    friend struct Periodic_state;

    Vectors vectors_;
};

/// The cells of a periodic triangulation, one of each set of translates, numbered 0, 1, 2 .., and their adjacency.
template <int d>
struct Periodic_cells {
    static constexpr std::size_t corners = d + 1;
    /// The vertices of each cell, positively oriented (Mesh_cells). A vertex may occur several times.
    std::vector<std::array<Index, corners>> vertices;
    /// Which image of the vertex a corner is: corner k of cell c is at points[vertices[c][k]] + offsets[c][k] . box.
    /// The least offset of a cell is 0 in each direction.
    std::vector<std::array<Shift<d>, corners>> offsets;
    /// The cell beyond the facet opposite to each corner, never the cell itself. Two cells may share several facets.
    std::vector<std::array<Index, corners>> neighbours;
    /// What to add to the offsets of that cell, so that the images of the common facet are the same.
    std::vector<std::array<Shift<d>, corners>> translations;
};

/// The Voronoi facets of points in a periodic box: an entry for each ordered pair of neighbouring images, in ascending
/// order of (first, second, shift). A pair is there in both directions; a point may be its own neighbour, and two
/// points neighbours several times, with different shifts.
template <int d>
struct Periodic_neighbours {
    std::vector<Index> first, second;
    /// Which image of the second point it is: vector = points[second] - points[first] + shift . box.
    std::vector<Shift<d>> shift;
    std::vector<Coordinates<d>> vector;  ///< exact
    std::vector<double> distance;        ///< its length, rounded
    /// The length (2D) or area (3D) of the common facet of the Voronoi cells, with a relative error of
    /// voronoi_diagram_error (voronoi.h). 0 where that is exactly empty, or a point, or in 3D an edge, and only there:
    /// as in a cubic crystal, whose cells touch in points and edges, too.
    std::vector<double> area;
};

/// A cell of a periodic mesh as the one that contains a point: corner k of cell c is then at
/// points[vertices[c][k]] + (offsets[c][k] + shift) . box.
template <int d>
struct Periodic_location {
    Index cell = -1;  ///< its number in Periodic_mesh::cells(); -1: none
    Shift<d> shift{};
};

/// An image of a vertex: the one at points()[vertex] + shift . box.
template <int d>
struct Periodic_image {
    Index vertex = -1;  ///< -1: none
    Shift<d> shift{};
};
/// Images of vertices with weights, for several points: those of point k are image[i] and weight[i] for i from begin[k]
/// to begin[k + 1] - 1.
template <int d>
struct Periodic_weights {
    std::vector<std::size_t> begin{0};
    std::vector<Periodic_image<d>> image;
    std::vector<double> weight;
};

extern template class Box<2>;
extern template class Box<3>;

}  // namespace annulus::inline v1
