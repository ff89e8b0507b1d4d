// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A corner of a 2D cell, as an offset (unit: length) from the cell's origin, and the kind of edge to the next corner.
struct Corner_2 {
    Coordinates<2> offset{};
    /// False: a straight edge. True: the counter-clockwise arc of the circle around (0, 0) (in absolute coordinates,
    /// not the cell's) through this corner and the next. An arc spans less than a full turn.
    bool arc = false;
};

/// The line { u : normal . u = bound } in offsets from a cell's origin; the cell is on the side normal . u <= bound.
struct Half_plane_2 {
    Coordinates<2> normal{};
    double bound = 0;
};

/// A convex 2D region bounded by straight edges and by arcs around (0, 0), counter-clockwise.
///
/// Corners are offsets from `origin`, a point in or near the region, because a small cell far from (0, 0) would lose
/// its shape in absolute coordinates. No corners: the empty region.
struct Cell_2 {
    Coordinates<2> origin{};
    std::vector<Corner_2> corners;
};

/// Signed angle in radians from p to p + d as seen from (0, 0), in (-pi, pi]. Accurate for d much shorter than p.
[[nodiscard]] double angle_spanned(const Coordinates<2>& p, const Coordinates<2>& d);

/// The angle in [0, 2 pi) that the arc from `from` to `to` (offsets from `origin`) spans counter-clockwise. A span
/// that rounding made negative, down to -1e-9, counts as 0: a real arc that nearly closes must come in two pieces.
[[nodiscard]] double arc_span(const Coordinates<2>& origin, const Coordinates<2>& from, const Coordinates<2>& to);

/// The disc of `radius` around (0, 0) as four quarter arcs, seen from `origin`. Precondition: radius > 0.
void assign_disc(const Coordinates<2>& origin, double radius, std::vector<Corner_2>& corners);

/// Cuts a straight-edged convex cell to the disc of `radius` around (0, 0). O(corners). Replaces `cell.corners`;
/// `scratch` is work space. A corner on the circle is off it by a few roundings of the radius.
void clip_to_disc(Cell_2& cell, double radius, std::vector<Corner_2>& scratch);

/// A convex polygon under clipping that remembers for every edge the line it lies on.
///
/// Clipping a large polygon down to a small one leaves corners with the rounding of the large one. `write_corners`
/// computes every corner afresh from the two lines that meet there, so that the error is that of the small one.
/// Holds its buffers between uses: no allocation after warming up.
class Clipper_2 {
  public:
    /// Starts from a polygon: corner i is followed by the edge on line i. Same length, at least 3.
    void start(std::span<const Coordinates<2>> corners, std::span<const Half_plane_2> lines);
    /// Intersects with a half-plane. O(corners). Precondition: normal is not zero.
    void clip(const Half_plane_2& half_plane);
    /// True when nothing is left.
    [[nodiscard]] bool empty() const { return corner_.size() < 3; }
    /// Replaces `corners` by the polygon's.
    void write_corners(std::vector<Corner_2>& corners) const;

  private:
    struct Tagged {
        Coordinates<2> offset;
        std::size_t line;   ///< line of the edge to the next corner
        double height = 0;  ///< signed distance (scaled) to the line being clipped by
    };
    std::vector<Half_plane_2> line_;
    std::vector<Tagged> corner_, next_;
};

}  // namespace annulus::inline v1
