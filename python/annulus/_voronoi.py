# SPDX-License-Identifier: GPL-3.0-or-later
"""`Voronoi`, the diagram that `MovingDelaunay.voronoi` returns, and regions to which cells are clipped."""

from __future__ import annotations

import functools
import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._diagram import Diagram
from ._error import Error
from ._queries import Floats, Indices


class Voronoi(Diagram):
    """The Voronoi diagram of a `MovingDelaunay` at one moment, with the names of `scipy.spatial.Voronoi`.

    Ridges are the facets that two cells have in common. Facets that are exactly empty (see `neighbor_list` of
    `MovingDelaunay`) are not among them. Arrays by ridge are in the order of `ridge_points`; arrays by cell have a row
    for each point, NaN at free indices. `scipy.spatial.voronoi_plot_2d` draws it.

    Attributes
    ----------
    points : ndarray of float64, shape (npoints, d)
    ridge_points : ndarray of int32, shape (nridges, 2)
        The two points of each ridge, the smaller index first, ascending.
    areas : ndarray of float64, shape (nridges,)
        The length (2D) or area (3D) of each ridge; ``inf`` if it is unbounded.
    ridge_centroids : ndarray of float64, shape (nridges, d)
        NaN for unbounded ridges.
    distances : ndarray of float64, shape (nridges,)
        The distance of the two points.
    vectors : ndarray of float64, shape (nridges, d)
        From the first of the two points to the second.
    volumes : ndarray of float64, shape (npoints,)
        The area (2D) or volume (3D) of each cell; ``inf`` if it is unbounded.
    centroids : ndarray of float64, shape (npoints, d)
        Of the cells; NaN for unbounded ones.
    surfaces : ndarray of float64, shape (npoints,)
        The perimeter (2D) or area (3D) of the border of each cell.
    vertices : ndarray of float64, shape (nvertices, d)
        The corners of the cells: the circumcentres of the simplices, one for all simplices of cospherical points.
        They, and the lists of them, do not depend on a clip: `MovingDelaunay.voronoi_polytopes` has the corners of
        clipped cells.

    Notes
    -----
    Without a clip each finite area, volume and surface has a relative error of at most 2**-32. With a clip, the
    ridges and cells that it cuts have absolute errors. With L the diameter of clip and points, and of the origin if
    there are half-spaces, a volume is off by at most 2**-44 L**d, and an area by at most 2**-46 L**(d-1) / s. There s
    is the sine of the smallest angle between the ridge and another side of its two cells, or the border of the clip: of
    two points that are 1e-11 apart the cells have sides that nearly coincide, and areas are off by as much as 1e-5. A
    ridge outside the clip has the area 0.

    Where all points are on a line, or in 3D in a plane, every ridge is unbounded, and none is found to be exactly
    empty.
    """

    furthest_site = False

    def __init__(self, parts: dict[str, typing.Any]) -> None:
        super().__init__(parts, parts["ring"][:, None])

    @functools.cached_property
    def ridge_dict(self) -> dict[tuple[int, int], list[int]]:
        """dict: the vertices of each ridge by its two points."""
        return {(int(i), int(j)): ring for (i, j), ring in zip(self.ridge_points, self.ridge_vertices)}

    @functools.cached_property
    def regions(self) -> list[list[int]]:
        """list of lists of int: the vertices of each cell; -1, which comes first, if the cell is unbounded. In 2D
        counter-clockwise."""
        begin, index = self._begin, self._corners[:, 0]
        ridge = np.repeat(np.arange(len(begin) - 1), np.diff(begin))
        cell = self.ridge_points[ridge].reshape(-1)
        pairs = np.unique(np.column_stack([cell, np.repeat(index, 2)]), axis=0)
        if self.points.shape[1] == 2:
            pairs = self._in_order(pairs)
        if not len(self.points):
            return []
        split = np.searchsorted(pairs[:, 0], np.arange(1, len(self.points)))
        return [region.tolist() for region in np.split(pairs[:, 1], split)]

    def _in_order(self, pairs: NDArray[np.int32]) -> NDArray[np.int32]:
        """Sorted by cell, -1 first, then by angle around the point; of unbounded cells from the vertex on at which the
        ray towards the next hull vertex begins."""
        to = self.vertices[pairs[:, 1]] - self.points[pairs[:, 0]] if len(self.vertices) else np.empty((len(pairs), 2))
        angle = np.where(pairs[:, 1] < 0, -np.inf, np.arctan2(to[:, 1], to[:, 0]))
        order = np.lexsort((angle, pairs[:, 0]))
        pairs, angle = pairs[order], angle[order]
        first = self._first_of_unbounded()
        for k in np.flatnonzero(pairs[:, 1] < 0):
            end = np.searchsorted(pairs[:, 0], pairs[k, 0], side="right")
            if end - k > 2:
                begin = int(np.flatnonzero(pairs[k + 1:end, 1] == first[int(pairs[k, 0])])[0])
                pairs[k + 1:end] = np.roll(pairs[k + 1:end], -begin, axis=0)
        return pairs

    def _first_of_unbounded(self) -> dict[int, int]:
        """In 2D: of each cell with two unbounded ridges the vertex of that towards the next point, counter-clockwise,
        of the hull."""
        rays: dict[int, list[tuple[int, int]]] = {}
        others: dict[int, int] = {}
        for (i, j), ends in self.ridge_dict.items():
            for cell, neighbour in ((i, j), (j, i)):
                if -1 in ends:
                    rays.setdefault(cell, []).append((neighbour, max(ends)))
                else:
                    others[cell] = neighbour
        out = {}
        for cell, (one, other) in ((c, r) for c, r in rays.items() if len(r) == 2 and c in others):
            # The hull turns left at the cell's point, or does not turn, and has every other point on its left.
            rows = self.points[[[one[0], cell, other[0]], [one[0], other[0], others[cell]]]]
            turn, side = _core.orient_2d(rows)["sign"].tolist()
            out[cell] = (other if (turn or side) > 0 else one)[1]
        return out


def clip_of(clip: ArrayLike | None, ndim: int) -> tuple[Floats | None, Floats | None]:
    """The box and the half-spaces of a clip, as the compiled module takes them."""
    if clip is None:
        return None, None
    rows = _core.clip_numbers(clip)
    if ndim == 2 and rows.shape == (2, 3):
        raise Error("clip has the shape (2, 3): a box in 3D, where the points are in 2D, or two half-planes, which do "
                    "not bound it", "bad_input")
    if rows.ndim == 2 and rows.shape == (2, ndim):
        return rows, None
    if rows.ndim == 2 and rows.shape[1] == ndim + 1:
        return None, rows
    if rows.ndim == 2 and ndim == 2 and rows.shape[1] == 2 and len(rows) > 2:
        return _polygon(rows)
    polygon = ", or a convex polygon, shape (m, 2)" if ndim == 2 else ""
    raise Error(f"clip must be a box, shape (2, {ndim}), or half-spaces, shape (m, {ndim + 1}){polygon}; not "
                f"{_arguments.described(rows)}", "wrong_size")


def _polygon(corners: Floats) -> tuple[Floats, Floats]:
    """The box and the half-planes of a convex polygon; corners may lie on edges, up to rounding."""
    if not np.isfinite(corners).all():
        raise Error("clip has a corner that is not finite", "not_finite")
    corners = corners[np.any(np.roll(corners, -1, axis=0) != corners, axis=1)]
    if len(corners) < 3:
        raise Error("clip must be a convex polygon", "bad_input")
    box = np.array([corners.min(axis=0), corners.max(axis=0)])
    exponent = min(max(int(np.frexp(np.abs(box).max())[1]), -1000), 1000)
    corners = np.ldexp(corners, -exponent)
    edges = np.roll(corners, -1, axis=0) - corners
    edges = np.ldexp(edges, -np.frexp(np.abs(edges).max(axis=1))[1][:, None])
    edges /= np.hypot(edges[:, 0], edges[:, 1])[:, None]
    after = np.roll(edges, -1, axis=0)
    turns = np.arctan2(edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0], np.sum(edges * after, axis=1))
    sign = np.sign(turns.sum())
    # Once around, never back; a spike turns by pi.
    if np.any(sign * turns < -1e-9) or np.any(np.abs(turns) > np.pi - 1e-9) or abs(abs(turns.sum()) - 2 * np.pi) > 1e-6:
        raise Error("clip must be a convex polygon", "bad_input")
    normals = np.column_stack([edges[:, 1], -edges[:, 0]]) * sign
    return box, np.column_stack([np.ldexp(normals, -exponent), -np.sum(normals * corners, axis=1)])


def t1(report: _core.MoveResult) -> Indices:
    """The T1 transitions of a step in 2D: where two cells lost their contact, and two others came into contact.

    Parameters
    ----------
    report : MoveResult
        Of a `MovingDelaunay` in 2D with ``report_changes=True``.

    Returns
    -------
    ndarray of int32, shape (m, 4)
        Rows (i, j, k, l): i and j were neighbours before the step, k and l are neighbours since, i < j, k < l; the
        triangles i j k and i j l became k l i and k l j. Ascending.

    Raises
    ------
    Error
        With the code ``usage`` for a report in 3D or without changes.

    Notes
    -----
    Where flips follow one another in one place within a step there is no such quadrilateral: these pairs are in
    `MoveResult.edges_broken` and `edges_made`, and not here. A point that passes through the hull makes or breaks a
    pair by itself. Cocircular points may change their diagonal, which is a transition between empty facets.
    """
    if not isinstance(report, _core.MoveResult):
        raise TypeError(f"report must be a MoveResult, not {_arguments.described(report)}")
    if report.removed_simplices.shape[1] != 3:
        raise Error("report must be that of a move in 2D", "usage")
    return _core.t1(report)
