# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicVoronoi`, the diagram that `PeriodicDelaunay.voronoi` returns, and the volumes of its cells."""

from __future__ import annotations

import functools
import operator
import typing

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _core, _outputs
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
        return [list(part) for part in self._by_cell[1]]

    @functools.cached_property
    def region_shifts(self) -> list[Indices]:
        """list of ndarray of int32, shape (k, d): which images the vertices in `regions` are."""
        return self._by_cell[2]

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
        return self._at(self._by_cell[0][self._index(i)])

    def faces(self, i: int) -> list[Floats]:
        """The sides of the cell of point i.

        Parameters
        ----------
        i : int

        Returns
        -------
        list of ndarray of float64, shape (k, d)
            The corners of each, beside ``points[i]``: in 3D counter-clockwise as seen from outside, in 2D with the cell
            on the left. Those of the ridges in which i is the first point, then of those in which it is the second; of
            a ridge between i and an image of i both sides.

        Raises
        ------
        Error
            With the code ``unknown_vertex`` if there is no such index.
        """
        i = self._index(i)
        out = [self.ridge_corners(int(r)) for r in np.flatnonzero(self.ridge_points[:, 0] == i)]
        for r in np.flatnonzero(self.ridge_points[:, 1] == i):
            corners = self._corners[self._begin[r]:self._begin[r + 1]][::-1].copy()
            corners[:, 1:] -= self.ridge_shifts[r]
            out.append(self._at(corners))
        return out

    @functools.cached_property
    def _by_cell(self) -> tuple[list[Indices], list[Indices], list[Indices]]:
        """By point rows [vertex, shift] of its cell, and their parts."""
        n = len(self.points)
        d = self.points.shape[1]
        if d == 2:  # each ridge begins at a corner; in the order of the directions of neighbours, which are exact
            cell = self.ridge_points.T.reshape(-1)
            corners = self._corners.reshape(-1, 2, 3)
            back = corners[:, 1] - np.column_stack([np.zeros(len(corners), np.int32), self.ridge_shifts])
            to = np.concatenate([self.vectors, -self.vectors])
            order = np.lexsort((np.arctan2(to[:, 1], to[:, 0]), cell))
            rows = np.concatenate([corners[:, 0], back])[order]
            cell = cell[order]
        else:
            ridge = np.repeat(np.arange(len(self.ridge_points)), np.diff(self._begin))
            here = np.column_stack([self.ridge_points[ridge, 0], self._corners])
            there = np.column_stack([self.ridge_points[ridge, 1], self._corners])
            there[:, 2:] -= self.ridge_shifts[ridge]
            rows = np.unique(np.concatenate([here, there]), axis=0)
            cell, rows = rows[:, 0], rows[:, 1:]
        parts = np.split(rows, np.searchsorted(cell, np.arange(1, n))) if n else []
        return parts, [p[:, 0] for p in parts], [p[:, 1:] for p in parts]

    def _at(self, corners: Indices) -> Floats:
        places: Floats = self.vertices[corners[:, 0]] + corners[:, 1:] @ self.box
        return places

    def _index(self, i: typing.SupportsIndex) -> int:
        i = operator.index(i)
        if not 0 <= i < len(self.points):
            raise Error(f"no point has the index {i}", "unknown_vertex", (i,))
        return i


class PeriodicDiagrams:
    """The part of `PeriodicDelaunay` that has Voronoi diagrams and volumes."""

    _mesh: _core.Periodic2 | _core.Periodic3

    def voronoi(self) -> PeriodicVoronoi:
        """The Voronoi diagram: cells, their common facets, corners, with shifts.

        Returns
        -------
        PeriodicVoronoi

        Notes
        -----
        O(n), some microseconds for each point, computed afresh by each call. Facets of nearly cospherical points, for
        which doubles are not accurate enough, are computed exactly, 20 microseconds each. There is no clip, as every
        cell is bounded.
        """
        return PeriodicVoronoi(self._mesh.voronoi())

    def voronoi_volumes(self, *, out: NDArray[typing.Any] | None = None,
                        dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The areas (2D) or volumes (3D) of the Voronoi cells, which add up to that of the box.

        Parameters
        ----------
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            Each with a relative error of at most 2**-33, 1.2e-10; NaN at free indices.
        """
        return _outputs.returned(self._mesh.voronoi_volumes, lambda: (self._mesh.index_bound,), out, dtype)
