// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>

namespace annulus::inline v1 {

/// The box in which the ways of vertices are measured, and how far the present one is from it (docs/theory.md 8.9).
///
///     place in the present box  --the map B, nearly L0 L^-1-->  co-moving place, in the reference box L0
///
/// Points that follow the box stay where they are as seen there. What they do not follow is a deviation from a
/// similarity: while the box goes from one shape to another it grows by ½ ln of the ratio of the greatest and the least
/// factor by which lengths change, and these add up. So a certificate whose points are within r of some point has the
/// tolerance s as long as, with all lengths as they are here,
///
///     |co-moving place - the one when it was evaluated| + deviation since then * r < s / path_factor - error_upper().
template <int d>
class Reference_box {
  public:
    using Vectors = typename Box<d>::Vectors;

    /// Lengths as seen here are those in the present box up to this factor, and what is squared in the theorem.
    static constexpr double path_factor = 1.1;
    /// What is measured here is at most this many times what it is in the present box.
    static constexpr double stretch_upper = 1.04;

    /// The present box is the reference from now on.
    void begin(const Lattice<d>& lattice);
    /// The present box is this one, whose basis is the one of the call before, deformed: vectors correspond. False
    /// where the box is another by more than a thirty-second, or deviates by more than a vertex can bear, or where B is
    /// computed with too large an error: then there is no reference until begin(). O(1).
    [[nodiscard]] bool follow(const Lattice<d>& lattice);

    /// The co-moving place, in doubles.
    [[nodiscard]] Coordinates<d> comoving(const Coordinates<d>& place) const {
        Coordinates<d> z;
        for (std::size_t i = 0; i < d; ++i) {
            z[i] = map_[i][0] * place[0];
            for (std::size_t k = 1; k < d; ++k) z[i] += map_[i][k] * place[k];
        }
        return z;
    }
    /// The same on a grid, on which vectors of the reference box are added without rounding.
    [[nodiscard]] Coordinates<d> anchor(const Coordinates<d>& place) const;
    /// An anchor when all offsets of its vertex have grown by this: exact.
    [[nodiscard]] Coordinates<d> relabelled(const Coordinates<d>& anchor, Offset<d> more) const;

    /// An upper bound of the deviation since begin(): a sum, so that differences are upper bounds, too.
    [[nodiscard]] double deviation_upper() const { return deviation_; }
    /// By how much two co-moving places of a site are off from what they should be, at most, as vectors, together.
    [[nodiscard]] double error_upper() const { return error_; }

  private:
    using Matrix = std::array<Coordinates<d>, static_cast<std::size_t>(d)>;

    [[nodiscard]] Matrix map_of(const Lattice<d>& lattice) const;
    [[nodiscard]] bool is_accurate(const Matrix& map, const Lattice<d>& lattice) const;

    Vectors reference_{};    // L0, by rows
    Coordinates<d> grid_{};  // of it
    Matrix map_{};           // B
    double deviation_ = 0, error_ = 0;
};

extern template class Reference_box<2>;
extern template class Reference_box<3>;

/// An upper bound of the deviation from a similarity: ½ ln of the ratio of the singular values of X, for every matrix X
/// whose entries are these, but for a matrix of norm `off`. Infinity where that is too large to be told.
template <int d>
[[nodiscard]] double deviation_upper(const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& x, double off);
/// Whether all singular values of this matrix are within a thirty-second of 1. May be false where they are nearly not.
template <int d>
[[nodiscard]] bool is_nearly_rigid(const std::array<Coordinates<d>, static_cast<std::size_t>(d)>& x);

extern template double deviation_upper<2>(const std::array<Coordinates<2>, 2>&, double);
extern template double deviation_upper<3>(const std::array<Coordinates<3>, 3>&, double);
extern template bool is_nearly_rigid<2>(const std::array<Coordinates<2>, 2>&);
extern template bool is_nearly_rigid<3>(const std::array<Coordinates<3>, 3>&);

}  // namespace annulus::inline v1
