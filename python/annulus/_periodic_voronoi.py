# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicVoronoi`, the diagram that `PeriodicDelaunay.voronoi` returns."""

from __future__ import annotations

import functools
import operator
import typing

import numpy as np
from numpy.typing import NDArray

from ._diagram import Diagram
from ._error import Error
from ._queries import Floats, Indices


class PeriodicVoronoi(Diagram):
    """The Voronoi diagram of a `PeriodicDelaunay` at one moment: the names of `Voronoi`, with shifts, which say by how
    many vectors of the box a point or a vertex is moved. Every cell and every ridge is bounded.

    Ridges are the facets that two cells have in common. Facets that are exactly empty (see `neighbor_list` of
    `PeriodicDelaunay`) are not among them. Arrays by ridge are in the order of `ridge_points`; arrays by cell have a
    row for each point, NaN at free indices.

    Attributes
    ----------
    points : ndarray of float64, shape (npoints, d)
    box : ndarray of float64, shape (d, d)
        The vectors as rows.
    ridge_points : ndarray of int32, shape (nridges, 2)
        The two points of each ridge: i <= j.
    ridge_shifts : ndarray of int32, shape (nridges, d)
        Which image of the second point it is: the ridge is between the cells of ``points[i]`` and of ``points[j] + S @
        box``. Each ridge is there once, of a point and an image of its own with the greater of the two shifts.
        Ascending by i, j and S.
    areas : ndarray of float64, shape (nridges,)
        The length (2D) or area (3D) of each ridge.
    ridge_centroids : ndarray of float64, shape (nridges, d)
        Beside ``points[i]``.
    distances : ndarray of float64, shape (nridges,)
        The distance of the two.
    vectors : ndarray of float64, shape (nridges, d)
        ``points[j] - points[i] + S @ box``.
    volumes : ndarray of float64, shape (npoints,)
        The area (2D) or volume (3D) of each cell. They add up to that of the box.
    centroids : ndarray of float64, shape (npoints, d)
        Of the cells around `points`.
    surfaces : ndarray of float64, shape (npoints,)
        The perimeter (2D) or area (3D) of the border of each cell.
    vertices : ndarray of float64, shape (nvertices, d)
        The corners of the cells, one of each set of translates: the circumcentres of the simplices, with
        `PeriodicDelaunay.simplex_offsets`, one for all simplices of cospherical points. In any place: not all are in
        the box.

    Notes
    -----
    Each area, volume and surface has a relative error of at most 2**-32. A cell may have several images of a vertex
    as corners, and two cells several ridges.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> v = annulus.MovingDelaunay(np.array([[0.5, 0.25]]), box=[2, 1]).voronoi()
    >>> v.ridge_points, v.ridge_shifts, v.areas
    (array([[0, 0],
           [0, 0]], dtype=int32), array([[0, 1],
           [1, 0]], dtype=int32), array([2., 1.]))
    >>> v.polygon(0)
    array([[-0.5 ,  0.75],
           [-0.5 , -0.25],
           [ 1.5 , -0.25],
           [ 1.5 ,  0.75]])
    """

    box: Floats
    ridge_shifts: Indices

    def __init__(self, parts: dict[str, typing.Any]) -> None:
        super().__init__(parts, np.column_stack([parts["ring"], parts["ring_shifts"]]))
        self.box = parts["box"]
        self.ridge_shifts = parts["shifts"][~parts["exactly_empty"]]

    @functools.cached_property
    def ridge_vertex_shifts(self) -> list[Indices]:
        """list of ndarray of int32, shape (k, d): which images the vertices in `ridge_vertices` are. Corner k of ridge
        r is at ``vertices[ridge_vertices[r][k]] + ridge_vertex_shifts[r][k] @ box``: in 3D counter-clockwise as seen
        from the second point, in 2D with the cell of the first one on the left."""
        return self._by_ridge(self._corners[:, 1:])

    @functools.cached_property
    def regions(self) -> list[list[int]]:
        """list of lists of int: the vertices of the cell of each point, in 2D counter-clockwise. A vertex is there
        several times, if several of its images are corners."""
        begin, corners = self._cells
        return [part.tolist() for part in np.split(corners[:, 0], begin[1:-1])] if len(begin) > 1 else []

    @functools.cached_property
    def region_shifts(self) -> list[Indices]:
        """list of ndarray of int32, shape (k, d): which images the vertices in `regions` are."""
        begin, corners = self._cells
        return np.split(corners[:, 1:], begin[1:-1]) if len(begin) > 1 else []

    def ridge_corners(self, ridge: int) -> Floats:
        """The polygon of a ridge in 3D, its two ends in 2D.

        Parameters
        ----------
        ridge : int
            A row of `ridge_points`.

        Returns
        -------
        ndarray of float64, shape (k, d)
            Its corners in the order of `ridge_vertices`, beside ``points[i]`` for the first of its two points.

        Raises
        ------
        Error
            With the code ``usage`` if there is no such ridge.
        """
        r = operator.index(ridge)
        if not 0 <= r < len(self.ridge_points):
            raise Error(f"there are {len(self.ridge_points)} ridges, and none has the number {r}", "usage")
        return self._at(self._corners[self._begin[r]:self._begin[r + 1]])

    def polygon(self, i: int) -> Floats:
        """The polygon of the cell of point i, in 2D.

        Parameters
        ----------
        i : int

        Returns
        -------
        ndarray of float64, shape (k, 2)
            Its corners, counter-clockwise, around ``points[i]``. Shape (0, 2) at a free index.

        Raises
        ------
        Error
            With the code ``usage`` in 3D, where cells have `faces`; ``unknown_vertex`` if there is no such index.
        """
        if self.points.shape[1] != 2:
            raise Error("the cells are polyhedra, and have faces", "usage")
        i = self._index(i)
        begin, corners = self._cells
        return self._at(corners[begin[i]:begin[i + 1]])

    def faces(self, i: int) -> list[Floats]:
        """The sides of the cell of point i.

        Parameters
        ----------
        i : int

        Returns
        -------
        list of ndarray of float64, shape (k, d)
            The corners of each, beside ``points[i]``: in 3D counter-clockwise as seen from outside, in 2D with the cell
            on the left, and one after the other, counter-clockwise. In 3D those of the ridges in which i is the first
            point, then of those in which it is the second; of a ridge between i and an image of i both sides.

        Raises
        ------
        Error
            With the code ``unknown_vertex`` if there is no such index.
        """
        i = self._index(i)
        begin, sides = self._sides
        out = []
        for side in sides[begin[i]:begin[i + 1]]:
            r = side % len(self.ridge_points)
            corners = self._corners[self._begin[r]:self._begin[r + 1]]
            if side != r:  # as the second point sees it
                corners = self._moved(corners[::-1], self.ridge_shifts[r])
            out.append(self._at(corners))
        return out

    @functools.cached_property
    def _sides(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Of point i sides[begin[i]:begin[i + 1]]: ridge r for its first point, r + nridges for its second; in 2D
        counter-clockwise."""
        ends = self.ridge_points.T.reshape(-1)
        if self.points.shape[1] == 2:
            to = np.concatenate([self.vectors, -self.vectors])
            # Of a box that is thin along an axis: scaled, which keeps the order, directions are not alike.
            to = np.ldexp(to, -np.frexp(np.abs(to).max(axis=0, initial=0.0))[1])
            sides = np.lexsort((np.arctan2(to[:, 1], to[:, 0]), ends))
        else:
            sides = np.argsort(ends, kind="stable")
        return np.searchsorted(ends[sides], np.arange(len(self.points) + 1)), sides

    @functools.cached_property
    def _cells(self) -> tuple[NDArray[np.intp], Indices]:
        """Of the cell of point i corners[begin[i]:begin[i + 1]], rows [vertex, shift]; in 2D counter-clockwise."""
        size = np.diff(self._begin)
        if self.points.shape[1] == 2:  # each side begins at a corner; neighbours are in the order of directions
            here, there = self._corners.reshape(-1, 2, 3).transpose(1, 0, 2)
            cell = self.ridge_points.T.reshape(-1)
            rows = np.concatenate([here, self._moved(there, self.ridge_shifts)])
            order = self._sides[1]
        else:
            cell = np.repeat(self.ridge_points, size, axis=0).T.reshape(-1)
            shifts = np.repeat(self.ridge_shifts, size, axis=0)
            rows = np.concatenate([self._corners, self._moved(self._corners, shifts)])
            order = np.lexsort((*rows.T[::-1], cell))
        cell, rows = cell[order], rows[order]
        if self.points.shape[1] == 3:  # a corner is in several sides
            new = np.ones(len(cell), dtype=bool)
            new[1:] = (cell[1:] != cell[:-1]) | np.any(rows[1:] != rows[:-1], axis=1)
            cell, rows = cell[new], rows[new]
        return np.searchsorted(cell, np.arange(len(self.points) + 1)), rows

    @staticmethod
    def _moved(corners: Indices, shifts: Indices) -> Indices:
        """Corners as the second points of their ridges see them."""
        out = corners.copy()
        out[:, 1:] -= shifts
        return out

    def _at(self, corners: Indices) -> Floats:
        places: Floats = self.vertices[corners[:, 0]] + corners[:, 1:] @ self.box
        return places

    def _index(self, i: typing.SupportsIndex) -> int:
        i = operator.index(i)
        if not 0 <= i < len(self.points):
            raise Error(f"no point has the index {i}", "unknown_vertex", (i,))
        return i
