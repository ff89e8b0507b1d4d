// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/space/offset.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A point of a periodic box: its representative, and the image of it that the caller gave.
template <int d>
struct Representative {
    Coordinates<d> place;  ///< on the grid, with coordinates in the basis from -1/2 to 3/2
    Shift<d> image;        ///< the caller's point is at place + image . box, up to rounding
};

/// Whether there is a point. Arrays of places have NaN where there is none.
template <int d>
[[nodiscard]] inline bool is_place(const Coordinates<d>& p) {
    return !std::isnan(p[0]);
}

/// The lattice of a periodic box, on a grid on which all arithmetic of places is exact (docs/theory.md 8.2).
///
/// Let L be a basis of it that is reduced (docs/theory.md 8.2; the box's own vectors if they are nearly so), W_i the
/// sum of |L_j,i| and 2^e_i the least power of two above it. Vectors of the box and representatives are multiples of
/// the grid g_i = 2^(e_i - 49), rounded once, halves upward. So a place plus a combination of L by integers up to 8 is
/// a double, computed without rounding in any order.
template <int d>
class Lattice {
  public:
    using Vectors = typename Box<d>::Vectors;
    using Matrix = std::array<std::array<std::int64_t, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)>;

    /// Throws as the constructor of Box does.
    explicit Lattice(const Vectors& box);

    /// The box's vectors as they were given.
    [[nodiscard]] const Vectors& given() const { return given_; }
    /// The box's vectors, rounded to the grid.
    [[nodiscard]] const Vectors& box() const { return box_; }
    /// The basis L, right-handed, on the grid.
    [[nodiscard]] const Vectors& basis() const { return basis_; }
    /// The unit of the grid on each axis, a power of two.
    [[nodiscard]] const Coordinates<d>& grid() const { return grid_; }
    /// How far the neighbours of a point are, at most: the coordinates in the basis of an edge of any Delaunay
    /// triangulation with this lattice are at most these, with a margin of rounding() (docs/theory.md 8.5).
    [[nodiscard]] const Coordinates<d>& reach() const { return reach_; }
    /// det L, positive.
    [[nodiscard]] double volume() const;
    /// The distance of opposite facets of the basis' cell, by basis vector.
    [[nodiscard]] Coordinates<d> heights() const;

    /// How far in_basis is off, at most, for each coordinate of a place moved by an offset up to 4.
    [[nodiscard]] const Coordinates<d>& rounding() const { return rounding_; }

    /// Coordinates in the basis, in doubles: exact ones are not needed.
    [[nodiscard]] Coordinates<d> in_basis(const Coordinates<d>& p) const;
    /// The point at `place`, moved by an offset in the basis: exact.
    [[nodiscard]] Coordinates<d> place(const Coordinates<d>& place, Offset<d> offset) const;
    /// An offset as one by the vectors of the box.
    [[nodiscard]] Shift<d> in_box(Offset<d> offset) const;

    /// Brings a point into the basis' cell by the vectors of the box as they were given, and rounds it then: each
    /// coordinate is at most half a unit of the grid (and 2^-47 of it) from an image of the point, however far away it
    /// is. Needs rounding to nearest. Throws Error: not_finite; out_of_domain where the point is more than 2^29 boxes
    /// away. The error names i.
    [[nodiscard]] Representative<d> representative(const Coordinates<d>& p, std::int64_t i) const;
    /// Whether the place is on the grid and in the basis' cell, and the image at most 2^29 boxes away.
    [[nodiscard]] bool is_representative(const Representative<d>& r) const;
    /// The double nearest to place + image . box, coordinate by coordinate: exactly that up to eight boxes away.
    [[nodiscard]] Coordinates<d> imaged(const Representative<d>& r) const;
    /// representative() of many points, of which the error names the number, and imaged() of these: bit for bit the
    /// same, in a tenth of the time. The lists get the size of `points`. O(their number).
    void represent(std::span<const Coordinates<d>> points, std::vector<Coordinates<d>>& place,
                   std::vector<Shift<d>>& image, std::vector<Coordinates<d>>& given) const;

  private:
    [[noreturn]] static void throw_thin();
    void choose_grid();
    void require_combinations() const;
    void round_box();
    void choose_reach();

    Vectors given_;  // as it was given, unrounded
    Vectors box_;
    Vectors basis_;
    Vectors dual_;   // rows: coordinates in the basis
    Matrix to_box_;  // row j: basis vector j as a combination of the box's
    Coordinates<d> grid_;
    Coordinates<d> reach_;
    Coordinates<d> rounding_;
};

extern template class Lattice<2>;
extern template class Lattice<3>;

/// det of the rows of m, by the formula that is meant: in doubles, or exactly in integers.
template <class T>
[[nodiscard]] T determinant_of_rows(const std::array<std::array<T, 2>, 2>& m) {
    return T(m[0][0] * m[1][1] - m[0][1] * m[1][0]);
}
template <class T>
[[nodiscard]] T determinant_of_rows(const std::array<std::array<T, 3>, 3>& m) {
    return T(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

}  // namespace annulus::inline v1
