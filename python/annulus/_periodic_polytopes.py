# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicPolytopes`, Voronoi cells in a periodic box as polygons or polyhedra."""

from __future__ import annotations

import numpy as np

from ._periodic_voronoi import PeriodicVoronoi
from ._polytopes import VoronoiPolytopes
from ._queries import Floats, Indices


class PeriodicPolytopes(VoronoiPolytopes):
    """The Voronoi cells of a `PeriodicDelaunay` at one moment: polygons in 2D, polyhedra in 3D, with the attributes of
    `VoronoiPolytopes`, and shifts. No clip is needed, as each cell is bounded; together they fill the box.

    Each cell has corners of its own, around its point, so that it is closed: corners of neighbours agree up to
    rounding, and the shift. Sides are the ridges of `PeriodicVoronoi`, so none is exactly empty.

    Attributes
    ----------
    corners : ndarray of float64, shape (ncorners, d)
        The corners of all cells: those of the cell of point i are around ``points[i]``.
    side_indptr : ndarray of int32, shape (npoints + 1,)
        The sides of the cell of point i have the numbers ``side_indptr[i]`` to ``side_indptr[i + 1] - 1``: none at a
        free index.
    side_neighbors : ndarray of int32, shape (nsides,)
        The point j whose cell is beyond each side; i itself where that is the cell of an image of it.
    side_shifts : ndarray of int32, shape (nsides, d)
        Which image of j it is: the cell is that of ``points[j] + S @ box``.
    corner_indptr, side_corners : ndarray of int32
        As in `VoronoiPolytopes`.
    """

    side_shifts: Indices

    def __init__(self, parts: tuple[Floats, Indices, Indices, Indices, Indices], shifts: Indices) -> None:
        super().__init__(parts)
        self.side_shifts = shifts


def polytopes_of(v: PeriodicVoronoi) -> PeriodicPolytopes:
    """The cells of a diagram, each with corners of its own."""
    begin, sides = v._sides
    count = max(len(v.ridge_points), 1)
    ridge, second = sides % count, sides // count
    one, other = v.ridge_points[ridge, second], v.ridge_points[ridge, 1 - second]
    shifts = np.where(second[:, None] == 1, -v.ridge_shifts[ridge], v.ridge_shifts[ridge])
    # Corners side by side. The second point sees those of its ridge in the other order, moved.
    size = np.diff(v._begin)[ridge]
    corner_begin = np.concatenate([[0], np.cumsum(size)])
    step = np.arange(corner_begin[-1]) - np.repeat(corner_begin[:-1], size)
    first = np.repeat(v._begin[ridge], size)
    back = np.repeat(second == 1, size)
    corners = v._corners[np.where(back, first + np.repeat(size, size) - 1 - step, first + step)]
    corners[back, 1:] += np.repeat(shifts, size, axis=0)[back]
    # Each corner of a cell once.
    rows = np.column_stack([np.repeat(one, size), corners])
    order = np.lexsort(rows.T[::-1])
    new = np.ones(len(rows), dtype=bool)
    new[1:] = np.any(rows[order[1:]] != rows[order[:-1]], axis=1)
    number = np.empty(len(rows), dtype=np.int32)
    number[order] = np.cumsum(new) - 1
    parts = (v._at(rows[order[new], 1:]), begin.astype(np.int32), other.astype(np.int32),
             corner_begin.astype(np.int32), number)
    return PeriodicPolytopes(parts, shifts.astype(np.int32))
