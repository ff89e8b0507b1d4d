# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of vertices, simplices, neighbours and edges of a `PeriodicDelaunay`, as arrays."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._error import Error
from ._periodic_arguments import refuse_clip
from ._queries import Indices

QUANTITIES = "ijdDSA"


class PeriodicLists:
    """The part of `PeriodicDelaunay` that counts, and lists simplices and pairs."""

    _mesh: _core.Periodic2 | _core.Periodic3

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return 2 if isinstance(self._mesh, _core.Periodic2) else 3

    @property
    def affine_dimension(self) -> int:
        """int: d, as every point spans d dimensions with its images; -1 without points."""
        return self.ndim if self._mesh.vertices else -1

    @property
    def npoints(self) -> int:
        """int: rows of `points`, free indices included."""
        return self._mesh.index_bound

    @property
    def nvertices(self) -> int:
        """int: how many vertices there are."""
        return self._mesh.vertices

    @property
    def is_vertex(self) -> NDArray[np.bool_]:
        """ndarray of bool, shape (npoints,): False at free indices."""
        return self._mesh.is_vertex

    @property
    def nsimplex(self) -> int:
        """int: rows of `simplices`."""
        return self._mesh.cells

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented, one simplex of
        each set of translates. A vertex may occur several times in one."""
        return self._mesh.simplices

    @property
    def simplex_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): which image of its vertex each corner is. It is at
        ``points[simplices] + simplex_offsets @ box``. The least offset of a simplex is 0 in each direction. Raises an
        `Error` with the code ``too_large`` where one is above 127, as may be where neighbours were given 127 boxes
        apart or more."""
        return self._mesh.simplex_offsets

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each corner."""
        return self._mesh.neighbors

    @property
    def neighbor_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): what to add to the offsets of that simplex, so that the corners
        of the common facet have the same ones. Raises an `Error` with the code ``too_large`` where one is not from
        -128 to 127."""
        return self._mesh.neighbor_offsets

    def neighbor_list(self, quantities: str = "ijdDSA", clip: None = None) -> typing.Any:
        """Pairs of Voronoi cells that touch, with the facet between them, sorted by i, j and S.

        Parameters
        ----------
        quantities : str, optional
            What to return, as for `ase.neighborlist.neighbor_list`: ``i`` and ``j``, the points; ``d``, the distance;
            ``D``, the vector ``points[j] - points[i] + S @ box``; ``S``, the shift; and ``A``, the length (2D) or area
            (3D) of the facet, with a relative error of 2.4e-10 at most: 0 where it is exactly empty, and only there.
        clip : None, optional
            Every facet is bounded: anything else raises a `NotAvailableError`.

        Returns
        -------
        tuple of ndarrays, or one ndarray
            In the order of `quantities`, with a row for each pair in each direction. A point may be its own neighbour,
            and two points may be neighbours several times, with different S.
        """
        refuse_clip(clip)
        if not isinstance(quantities, str):
            raise TypeError(f"quantities must be a str, not {_arguments.described(quantities)}")
        if not quantities or set(quantities) - set(QUANTITIES):
            raise Error(f"quantities must be letters of {QUANTITIES!r}, not {_arguments.described(quantities)}",
                        "usage")
        arrays = dict(zip(QUANTITIES, self._mesh.neighbours()))
        return arrays[quantities] if len(quantities) == 1 else tuple(arrays[q] for q in quantities)

    def neighbor_counts(self, min_area: float = 0.0, strict: bool = True, clip: None = None) -> Indices:
        """The number of neighbours of each point.

        Parameters
        ----------
        min_area : float, optional
            Only neighbours are counted whose facet has a greater length or area, or with ``strict=False`` at least
            this one.
        strict : bool, optional
            With 0 and True, the default, facets that are exactly empty are not counted, and all others are: 12 in fcc
            crystals, 14 in bcc, as long as their coordinates are not rounded.
        clip : None, optional
            As for `neighbor_list`.

        Returns
        -------
        ndarray of int32, shape (npoints,)
            0 at free indices.
        """
        refuse_clip(clip)
        least = _arguments.number("min_area", min_area)
        if least < 0:
            raise Error(f"min_area must be 0 or more, not {_arguments.described(min_area)}", "usage")
        return self._mesh.neighbour_counts(least, _arguments.truth("strict", strict))

    @property
    def vertex_to_simplex(self) -> Indices:
        """ndarray of int32, shape (npoints,): a simplex of each vertex; -1 at free indices."""
        return self._mesh.vertex_to_simplex

    @property
    def flat_simplices(self) -> Indices:
        """ndarray of int32, shape (0, d + 1): there are none, as every point spans d dimensions with its images."""
        return np.empty((0, self.ndim + 1), dtype=np.int32)

    @property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """Two ndarrays of int32, (indptr, indices): the neighbours of vertex v are
        ``indices[indptr[v]:indptr[v + 1]]``, ascending. A vertex is there once for each of its images that is a
        neighbour, also v itself; `vertex_neighbor_shifts` says which images they are."""
        return self._mesh.vertex_neighbours()

    @property
    def vertex_neighbor_shifts(self) -> Indices:
        """ndarray of int32, shape (k, d): a row for each of the `indices` of `vertex_neighbor_vertices`. With ``w`` and
        ``S`` in one row, the neighbour of v is at ``points[w] + S @ box``. Those are the rows of `neighbor_list`."""
        return self._pairs()[2]

    @property
    def edges(self) -> Indices:
        """ndarray of int32, shape (k, 2): the pairs of neighbours i <= j, ascending; a pair is there once for each
        `edge_shifts` with which it is one. Facets that are exactly empty (`neighbor_list`) count."""
        i, j, shifts = self._pairs()
        once = _is_first_of_pair(i, j, shifts)
        return np.column_stack([i[once], j[once]])

    @property
    def edge_shifts(self) -> Indices:
        """ndarray of int32, shape (k, d): which images the edges lead to, in the order of `edges`: edge ``[i, j]``
        leads from ``points[i]`` to ``points[j] + S @ box``. It stands for ``[j, i]`` with ``-S``, too, which is not
        listed; of a point and an image of its own the greater one of the two shifts is."""
        i, j, shifts = self._pairs()
        return shifts[_is_first_of_pair(i, j, shifts)]

    def _pairs(self) -> tuple[Indices, Indices, Indices]:
        """Of `neighbor_list` i, j and S."""
        i, j, _, _, shifts, _ = self._mesh.neighbours()
        return i, j, shifts


def _is_first_of_pair(i: Indices, j: Indices, shifts: Indices) -> NDArray[np.bool_]:
    """Which of (i, j, S) and (j, i, -S) is listed; both of one point: the greater shift."""
    rows = np.arange(len(shifts))
    first = shifts[rows, (shifts != 0).argmax(axis=1)]  # the first one that is not 0
    once: NDArray[np.bool_] = (i < j) | (i == j) & (first > 0)
    return once
