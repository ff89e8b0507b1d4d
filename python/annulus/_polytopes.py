# SPDX-License-Identifier: GPL-3.0-or-later
"""`VoronoiPolytopes`, clipped Voronoi cells as polygons or polyhedra."""

from __future__ import annotations

import operator
import typing

import numpy as np

from ._error import Error
from ._queries import Floats, Indices


class VoronoiPolytopes:
    """The Voronoi cells of a `MovingDelaunay` at one moment, intersected with a clip: polygons in 2D, polyhedra in 3D.

    Each cell has corners of its own, so that it is closed: corners of neighbours agree up to rounding. Where two cells
    meet in less than a facet, a side with a measure of 0, or nearly so, may be there or not: `Voronoi` decides that
    exactly. Volumes are off by at most 2**-44 L**d, with L the diameter of clip and points.

    Attributes
    ----------
    corners : ndarray of float64, shape (ncorners, d)
        The corners of all cells.
    side_indptr : ndarray of int32, shape (npoints + 1,)
        The sides of the cell of point i have the numbers ``side_indptr[i]`` to ``side_indptr[i + 1] - 1``: none at a
        free index, and where the cell is outside the clip.
    side_neighbors : ndarray of int32, shape (nsides,)
        The point whose cell is beyond each side; -1 for the border of the clip.
    corner_indptr, side_corners : ndarray of int32
        The corners of side s are the rows ``side_corners[corner_indptr[s]:corner_indptr[s + 1]]`` of `corners`: in 3D
        counter-clockwise seen from outside; in 2D two, and the sides of a cell follow each other counter-clockwise.
    """

    corners: Floats
    side_indptr: Indices
    side_neighbors: Indices
    corner_indptr: Indices
    side_corners: Indices

    def __init__(self, parts: tuple[Floats, Indices, Indices, Indices, Indices]) -> None:
        self.corners, self.side_indptr, self.side_neighbors, self.corner_indptr, self.side_corners = parts

    def polygon(self, i: int) -> Floats:
        """The polygon of the cell of point i, in 2D.

        Parameters
        ----------
        i : int

        Returns
        -------
        ndarray of float64, shape (k, 2)
            Its corners, counter-clockwise; side k to k + 1 is side ``side_indptr[i] + k``. Shape (0, 2) if it is
            outside the clip.

        Raises
        ------
        Error
            With the code ``usage`` in 3D, where cells have `faces`; ``unknown_vertex`` if there is no such index.
        """
        if self.corners.shape[1] != 2:
            raise Error("the cells are polyhedra, and have faces", "usage")
        sides = self._sides(i)
        begin, end = self.corner_indptr[sides.start], self.corner_indptr[sides.stop]
        polygon: Floats = self.corners[self.side_corners[begin:end:2]]
        return polygon

    def faces(self, i: int) -> list[Floats]:
        """The sides of the cell of point i.

        Parameters
        ----------
        i : int

        Returns
        -------
        list of ndarray of float64, shape (k, d)
            The corners of each, in the order of ``side_neighbors[side_indptr[i]:side_indptr[i + 1]]``.

        Raises
        ------
        Error
            With the code ``unknown_vertex`` if there is no such index.
        """
        begin = self.corner_indptr
        return [self.corners[self.side_corners[begin[s]:begin[s + 1]]] for s in self._sides(i)]

    def _sides(self, i: typing.SupportsIndex) -> range:
        i = operator.index(i)
        if not 0 <= i < len(self):
            raise Error(f"no point has the index {i}", "unknown_vertex", (i,))
        return range(int(self.side_indptr[i]), int(self.side_indptr[i + 1]))

    def __len__(self) -> int:
        return len(self.side_indptr) - 1

    def __repr__(self) -> str:
        cells = np.count_nonzero(np.diff(self.side_indptr))  # without free indices and empty cells
        return (f"<{type(self).__name__}: {cells} cells, {len(self.side_neighbors)} sides in "
                f"{self.corners.shape[1]}D>")
