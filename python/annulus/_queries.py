# SPDX-License-Identifier: GPL-3.0-or-later
"""The attributes and queries of `MovingDelaunay`."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]


class Fault(typing.NamedTuple):
    """A fault that `audit` lists: its kind, the points and the simplices concerned, by number, and a text.

    The kinds are ``unknown_vertex``, ``flat_cell``, ``overlap``, ``unused_vertex``, ``duplicate_point``,
    ``not_delaunay``, ``hull_not_convex``, ``hull_broken`` and ``not_flat``. `vertices` of an overlap are the common
    facet, then the opposite corner of each of the two simplices; of ``not_delaunay`` likewise.
    """

    kind: str
    vertices: tuple[int, ...]
    simplices: tuple[int, ...]
    text: str


class AuditResult(typing.NamedTuple):
    """The result of an audit: counts of faults, and the first fault found. True if Delaunay.

    `faults` has the faults that `audit` lists; `MovingDelaunay.audit` lists none. There, `inverted_cells` also counts
    simplices that are oriented negatively; in `audit` only flat ones.
    """

    delaunay: bool
    inverted_cells: int
    violated_facets: int
    concave_ridges: int
    topological_faults: int
    degenerate_facets: int
    first_fault: str
    faults: tuple[Fault, ...] = ()

    def __bool__(self) -> bool:
        return self.delaunay


def audit_result_of(values: tuple[bool, int, int, int, int, int, str,
                                  list[tuple[str, tuple[int, ...], tuple[int, ...], str]]]) -> AuditResult:
    """Creates an `AuditResult` from what the compiled module returns."""
    return AuditResult(*values[:-1], tuple(Fault(*fault) for fault in values[-1]))


def result_of(state: tuple[typing.Any, ...]) -> _core.MoveResult:
    """Creates a `MoveResult` from its pickled state."""
    return _core.result_of(state)


def statistics_of(state: dict[str, typing.Any]) -> _core.MoveStatistics:
    """Creates a `MoveStatistics` from its pickled state."""
    return _core.statistics_of(state)


class Queries:
    """The part of `MovingDelaunay` that changes nothing."""

    _mesh: _core.Mesh2 | _core.Mesh3
    _vertex_of_input: Indices

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (npoints, d): current positions by vertex index, NaN at free indices. Read-only,
        a snapshot."""
        return self._mesh.points

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented.

        Counter-clockwise in 2D; in 3D the determinant of the differences from the first vertex is positive. If the
        points do not span d dimensions there are none, shape (0, d + 1): see `flat_simplices`. The order of the
        rows has no meaning and may change.
        """
        return self._mesh.simplices

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each vertex; -1 outside
        the hull."""
        return self._mesh.neighbors

    @property
    def flat_simplices(self) -> Indices:
        """ndarray of int32, shape (m, k + 1): the triangles or edges of points that span only k < d dimensions;
        otherwise shape (0, d + 1)."""
        return self._mesh.flat_simplices

    @property
    def convex_hull(self) -> Indices:
        """ndarray of int32, shape (m, d): the facets of the convex hull.

        In 2D the triangulation is to their left; in 3D they are counter-clockwise seen from outside.
        """
        return self._mesh.convex_hull

    @property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """Two ndarrays of int32, (indptr, indices): the neighbours of vertex v are
        ``indices[indptr[v]:indptr[v + 1]]``, ascending."""
        return self._mesh.vertex_neighbor_vertices

    @property
    def vertex_to_simplex(self) -> Indices:
        """ndarray of int32, shape (npoints,): a simplex of each vertex; -1 at free indices and if there are no
        simplices."""
        return self._mesh.vertex_to_simplex

    @property
    def tolerances(self) -> Floats:
        """ndarray of float64, shape (npoints,): how far each vertex may be from its fixed position, in the unit of the
        points.

        The fixed position is where the vertex was when its tolerance was last measured. While every vertex is
        within its tolerance, the triangulation is Delaunay; with ``tolerance="certified"`` the tolerances are
        proved lower bounds. While no tolerances are kept (``auto`` decides when), the least tolerance of the
        certificates of each vertex. 0 if the points do not span d dimensions, NaN at free indices.
        """
        return self._mesh.tolerances

    @property
    def theta(self) -> Floats:
        """ndarray of float64, shape (npoints,): the least theta of the bi-cells of each vertex, in radians; pi/2 if
        it has none, NaN at free indices.

        It is small where two neighbouring simplices have nearly the same circumcircle or circumsphere.
        """
        return self._mesh.theta

    @property
    def displacements(self) -> Floats:
        """ndarray of float64, shape (npoints,): an upper bound of the distance of each vertex from its fixed position;
        NaN at free indices."""
        return self._mesh.displacements

    def find_simplex(self, xi: ArrayLike) -> Indices:
        """The simplices that contain points, decided exactly.

        Parameters
        ----------
        xi : array_like, shape (..., d)

        Returns
        -------
        ndarray of int32, shape (...)
            Rows of `simplices`; -1 outside the convex hull and for NaN. For a point on a facet, it is either of the
            simplices of that facet.
        """
        return self._mesh.find_simplex(xi)

    def audit(self) -> AuditResult:
        """Checks the whole triangulation in integer arithmetic, with code that it does not share with what it checks.
        O(n), microseconds per simplex.

        Returns
        -------
        AuditResult
            `first_fault` has the indices of vertices.

        Notes
        -----
        The result is that of one moment: other threads may move vertices during the audit. Signals (Ctrl-C) are
        handled from time to time during the audit.
        """
        return audit_result_of(self._mesh.audit())

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return 2 if isinstance(self._mesh, _core.Mesh2) else 3

    @property
    def affine_dimension(self) -> int:
        """int: the dimension that the points span; -1 without points."""
        return self._mesh.dimension

    @property
    def npoints(self) -> int:
        """int: rows of `points`, free indices included."""
        return self._mesh.npoints

    @property
    def nvertices(self) -> int:
        """int: number of vertices, without free indices."""
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
        """ndarray of int32, shape (n,): the vertex of each point given to the constructor: 0, 1, 2, .. unless duplicate
        points were merged."""
        return self._vertex_of_input

    @property
    def strategy(self) -> str:
        """str: the strategy in use: that of the options, except that ``paper-hybrid`` becomes ``paper`` when it
        switches."""
        return self._mesh.strategy
