# SPDX-License-Identifier: GPL-3.0-or-later
"""What is read off a `MovingDelaunay`: its attributes."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]


class AuditResult(typing.NamedTuple):
    """The verdict of `MovingDelaunay.audit`, and the first fault found. True where the triangulation is Delaunay."""

    delaunay: bool
    inverted_cells: int
    violated_facets: int
    concave_ridges: int
    topological_faults: int
    degenerate_facets: int
    first_fault: str

    def __bool__(self) -> bool:
        return self.delaunay


def report_of(state: tuple[dict[str, typing.Any], int, Indices | None]) -> _core.MoveReport:
    """What a pickled `MoveReport` is made again by."""
    return _core.report_of(state)


class Queries:
    """The part of `MovingDelaunay` that changes nothing."""

    _mesh: _core.Mesh2 | _core.Mesh3
    _index_of_input: Indices

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (npoints, d): positions by vertex index, NaN at free indices. Read-only, as of
        now."""
        return self._mesh.points

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented.

        Counter-clockwise in the plane; in space the determinant of the differences from the first vertex is
        positive. None, shape (0, d + 1), where the points do not span the plane or space: see
        `flat_simplices`. Their order has no meaning and changes.
        """
        return self._mesh.simplices

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each vertex; -1
        outside."""
        return self._mesh.neighbors

    @property
    def flat_simplices(self) -> Indices:
        """ndarray of int32, shape (m, k + 1): where the points span only k < d dimensions, their triangles or edges;
        else (0, d + 1)."""
        return self._mesh.flat_simplices

    @property
    def convex_hull(self) -> Indices:
        """ndarray of int32, shape (m, d): the facets with nothing beyond them.

        In the plane with the triangulation to their left, in space counter-clockwise as seen from outside.
        """
        return self._mesh.convex_hull

    @property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """Two ndarrays of int32, (indptr, indices): the neighbours of vertex v are
        ``indices[indptr[v]:indptr[v + 1]]``, ascending."""
        return self._mesh.vertex_neighbor_vertices

    @property
    def vertex_to_simplex(self) -> Indices:
        """ndarray of int32, shape (npoints,): a simplex of each vertex; -1 at free indices and where there are no
        simplices."""
        return self._mesh.vertex_to_simplex

    @property
    def tolerances(self) -> Floats:
        """ndarray of float64, shape (npoints,): how far each vertex may be from where its tolerance is measured, in
        the unit of the points.

        While every vertex is within its own, the triangulation is Delaunay; with ``tolerance="certified"``
        these are proved lower bounds. While no tolerances are kept (``auto`` decides when), the least
        tolerance of the certificates of each vertex. 0 where the points do not span the space, NaN at free
        indices.
        """
        return self._mesh.tolerances

    @property
    def theta(self) -> Floats:
        """ndarray of float64, shape (npoints,): the least theta of the bi-cells of each vertex, in radians; pi/2
        without one, NaN if free.

        It is small where two neighbouring simplices have nearly the same circumscribed circle or sphere.
        """
        return self._mesh.theta

    @property
    def displacements(self) -> Floats:
        """ndarray of float64, shape (npoints,): an upper bound of how far each vertex is from where its tolerance is
        measured; NaN if free."""
        return self._mesh.displacements

    def voronoi_volumes(self) -> Floats:
        """The areas (in the plane) or volumes of the Voronoi cells, in the unit of the points to the power of d.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            ``inf`` for unbounded cells, at the vertices of the hull; NaN at free indices.

        Notes
        -----
        Each number has a relative error of at most 2**-33, 1.2e-10, whatever the points. A number above the
        largest double is that one; one below the smallest normal double, 2**-1022, has an absolute error of
        2**-1074 besides.

        Volumes are kept from the first call on: later ones compute those that moves and changes of simplices
        since then concern, with the same result to the last bit.
        """
        return self._mesh.voronoi_volumes()

    def find_simplex(self, xi: ArrayLike) -> Indices:
        """The simplices that contain points, decided exactly.

        Parameters
        ----------
        xi : array_like, shape (..., d)

        Returns
        -------
        ndarray of int32, shape (...)
            Rows of `simplices`; -1 outside of the convex hull and for NaN. A point on a facet is in either of
            its simplices.
        """
        return self._mesh.find_simplex(xi)

    def audit(self) -> AuditResult:
        """Looks at all of it with integer arithmetic, which shares no code with what it audits. O(n), microseconds a
        simplex.

        Returns
        -------
        AuditResult
            Vertices in `first_fault` are named by their indices.

        Notes
        -----
        It is of one moment: other threads may move the triangulation on meanwhile. Signals (Ctrl-C) are seen
        now and then while it looks.
        """
        return AuditResult(*self._mesh.audit())

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return 2 if isinstance(self._mesh, _core.Mesh2) else 3

    @property
    def affine_dimension(self) -> int:
        """int: that which the points span; -1 without points."""
        return self._mesh.dimension

    @property
    def npoints(self) -> int:
        """int: rows of `points`, free indices included."""
        return self._mesh.npoints

    @property
    def nvertices(self) -> int:
        """int: vertices, free indices not counted."""
        return self._mesh.vertices

    @property
    def nsimplex(self) -> int:
        """int: rows of `simplices`."""
        return len(self._mesh.simplices)

    @property
    def is_vertex(self) -> NDArray[np.bool_]:
        """ndarray of bool, shape (npoints,): False at free indices."""
        return self._mesh.is_vertex

    @property
    def vertex_of_input(self) -> Indices:
        """ndarray of int32, shape (n,): the vertex that each point became in the beginning; not 0, 1, 2 .. only where
        some were merged."""
        return self._index_of_input

    @property
    def strategy(self) -> str:
        """str: the strategy in force: that of the options, but that ``paper-hybrid`` becomes ``paper`` when it
        switches."""
        return self._mesh.strategy
