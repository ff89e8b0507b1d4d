# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of `MovingDelaunay` about Voronoi cells and neighbours; its open boundaries."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments, _core, _outputs
from ._error import Error
from ._polytopes import VoronoiPolytopes
from ._queries import Floats, Indices, Queries
from ._voronoi import Voronoi, clip_of

QUANTITIES = "ijdDSA"


class VoronoiQueries(Queries):
    """Voronoi cells, neighbours and gradients."""

    def voronoi(self, clip: ArrayLike | None = None) -> Voronoi:
        """The Voronoi diagram: cells, their common facets, corners.

        Parameters
        ----------
        clip : array_like, optional
            What cells are intersected with, so that all are finite: a box, its lower and upper corner, shape (2, d);
            half-spaces ``A x + b <= 0``, rows ``[A, b]`` of shape (m, d + 1), as in
            `scipy.spatial.HalfspaceIntersection`; or in 2D the corners of a convex polygon in order, shape (m, 2), m
            > 2. Corners may be repeated, or on an edge: turns back of less than 1e-9, as rounding makes them, count as
            straight.

        Returns
        -------
        Voronoi

        Raises
        ------
        Error
            For a clip, with the codes ``wrong_size``, ``not_finite``, and ``bad_input`` if it has no interior or is
            unbounded.

        Notes
        -----
        O(n): about a microsecond per vertex in 2D, five in 3D. The result is kept, 1.5 kB per vertex in 3D (400 bytes
        in 2D): without a clip, a later call computes only the facets around points that moves and changes of cells
        affect, and copies the others, a quarter of the cost where one in a hundred moved. Facets with four (3D: five)
        cospherical corners are decided exactly, and take some microseconds each.
        """
        box, half_spaces = clip_of(clip, self.ndim)
        return Voronoi(_core.voronoi(self._mesh, box, half_spaces))

    def voronoi_polytopes(self, clip: ArrayLike) -> VoronoiPolytopes:
        """The Voronoi cells, intersected with a clip, as polygons or polyhedra.

        Parameters
        ----------
        clip : array_like
            As for `voronoi`.

        Returns
        -------
        VoronoiPolytopes

        Raises
        ------
        Error
            As `voronoi`, and with the code ``usage`` if the clip is None.

        Notes
        -----
        Computed afresh by each call, in doubles, O(n): every cell is cut out of the clip.
        """
        return VoronoiPolytopes(_core.voronoi_polytopes(self._mesh, *clip_of(clip, self.ndim)))

    def voronoi_volumes(self, clip: ArrayLike | None = None, *, out: NDArray[typing.Any] | None = None,
                        dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The areas (2D) or volumes (3D) of the Voronoi cells, in the unit of the points to the power of d.

        Parameters
        ----------
        clip : array_like, optional
            What cells are intersected with, as for `voronoi`.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            ``inf`` for unbounded cells, those of the vertices of the hull; NaN at free indices.

        Notes
        -----
        Each number has a relative error of at most 2**-33, 1.2e-10, for any points. Numbers saturate at the
        largest double; those below the smallest normal double, 2**-1022, have an additional absolute error of
        2**-1074. Volumes of cells that a clip cuts have an absolute error (`Voronoi`).

        Without a clip, volumes are kept from the first call on: later calls compute only those that are affected by
        moves and changes of simplices since then, with the same result to the last bit.
        """
        def compute() -> Floats:
            if clip is None:
                return self._mesh.voronoi_volumes()
            return _core.clipped_volumes(self._mesh, *clip_of(clip, self.ndim))

        return _outputs.returned(compute, lambda: (self.npoints,), out, dtype, clip)

    def voronoi_vjp(self, g: ArrayLike, *, out: NDArray[typing.Any] | None = None,
                    dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The gradient of ``sum(g * volumes)`` with respect to the points: what reverse-mode differentiation needs.

        Parameters
        ----------
        g : array_like, shape (npoints,)
            Entries at unbounded cells and free indices count as 0.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (npoints, d)

        Notes
        -----
        The derivative of volume i with respect to point j is ``A (x_j - c) / |x_i - x_j|``, with A and c the area and
        centroid of their common facet; with respect to point i it is minus the sum of the derivatives of volumes j.
        Volumes have continuous derivatives while no two points meet: an empty facet contributes 0, so that the
        gradient does not depend on how cocircular or cospherical points are triangulated. Second derivatives jump
        there. Infinite volumes have no derivative.
        """
        return _outputs.returned(lambda: _core.voronoi_gradient(self._mesh, g), lambda: (self.npoints, self.ndim), out,
                                 dtype, g)

    def voronoi_jacobian(self) -> tuple[Indices, Indices, Floats]:
        """The derivatives of all volumes as a sparse matrix, in compressed rows.

        Returns
        -------
        indptr, indices : ndarray of int32
        values : ndarray of float64, shape (nnz, d)
            The derivative of volume i with respect to point ``indices[k]`` is ``values[k]``, for k from ``indptr[i]``
            to ``indptr[i + 1] - 1``. Rows of unbounded cells and free indices are empty.

        Notes
        -----
        ``scipy.sparse.csr_matrix((values[:, a], indices, indptr), (npoints, npoints))`` is the matrix of the
        derivatives with respect to coordinate a.
        """
        return _core.voronoi_jacobian(self._mesh)

    @property
    def edges(self) -> Indices:
        """ndarray of int32, shape (k, 2): the pairs of neighbours, the smaller index first, ascending."""
        indptr, indices = self.vertex_neighbor_vertices
        i = np.repeat(np.arange(len(indptr) - 1, dtype=np.int32), np.diff(indptr))
        once = i < indices
        return np.column_stack([i[once], indices[once]])

    def neighbor_list(self, quantities: str, clip: ArrayLike | None = None) -> typing.Any:
        """Pairs of neighbours as arrays, with the letters of `ase.neighborlist.neighbor_list`.

        Parameters
        ----------
        quantities : str
            A letter for each array to be returned:

            * ``i``, ``j``: indices of the two points; each pair is there in both directions, ascending by i, then j;
            * ``d``: their distance, ``D``: the vector from i to j, shape (k, d);
            * ``S``: the shift of a periodic box, shape (k, d), zeros here;
            * ``A``: the area (3D) or length (2D) of their common facet. ``inf`` if it is unbounded, 0 if it is exactly
              empty: where d + 2 points or more are cospherical, some neighbours in the triangulation meet in less
              than a facet.
        clip : array_like, optional
            What facets are intersected with, as for `voronoi`.

        Returns
        -------
        ndarray, or tuple of ndarray if `quantities` has several letters

        Raises
        ------
        Error
            With the code ``usage`` for other letters.

        Notes
        -----
        Where all points are on a line, or in 3D in a plane, every facet is unbounded, exactly empty ones included.
        """
        if not isinstance(quantities, str):
            raise TypeError(f"quantities must be a str, not {_arguments.described(quantities)}")
        if not quantities or set(quantities) - set(QUANTITIES):
            raise Error(f"quantities must be letters of {QUANTITIES!r}, not {_arguments.described(quantities)}",
                        "usage")
        box, half_spaces = clip_of(clip, self.ndim)
        parts = _core.voronoi(self._mesh, box, half_spaces)
        pairs = parts["pairs"]
        order = np.lexsort((np.concatenate([pairs[:, 1], pairs[:, 0]]), np.concatenate([pairs[:, 0], pairs[:, 1]])))
        both: dict[str, typing.Callable[[], typing.Any]] = {
            "i": lambda: np.concatenate([pairs[:, 0], pairs[:, 1]])[order],
            "j": lambda: np.concatenate([pairs[:, 1], pairs[:, 0]])[order],
            "d": lambda: np.tile(parts["distances"], 2)[order],
            "D": lambda: np.concatenate([parts["vectors"], -parts["vectors"]])[order],
            "S": lambda: np.zeros((len(order), self.ndim), dtype=np.int32),
            "A": lambda: np.tile(parts["areas"], 2)[order],
        }
        out = tuple(both[letter]() for letter in quantities)
        return out if len(out) > 1 else out[0]

    def neighbor_counts(self, min_area: float = 0.0, strict: bool = True, clip: ArrayLike | None = None) -> Indices:
        """The number of neighbours of each point.

        Parameters
        ----------
        min_area : float, optional
            Count only neighbours whose common facet has a larger area (3D) or length (2D) than this.
        strict : bool, optional
            Do not count facets that are exactly empty: in a face-centred cubic lattice 12 neighbours count, in a
            square one 4. With False and ``min_area=0``, all neighbours in the triangulation count.
        clip : array_like, optional
            What facets are intersected with, as for `voronoi`. Facets outside it count if `min_area` is 0.

        Returns
        -------
        ndarray of int32, shape (npoints,)
            0 at free indices.

        Notes
        -----
        Where all points are on a line, or in 3D in a plane, no facet is found to be exactly empty: of a square lattice
        in 3D those diagonals count that the triangulation has.
        """
        least = _arguments.number("min_area", min_area)
        if not least >= 0:
            raise Error(f"min_area must be 0 or more, not {_arguments.described(min_area)}", "usage")
        strict = _arguments.truth("strict", strict)
        if not strict and least == 0:
            return np.diff(self.vertex_neighbor_vertices[0]).astype(np.int32)
        box, half_spaces = clip_of(clip, self.ndim)
        parts = _core.voronoi(self._mesh, box, half_spaces)
        counted = parts["pairs"]
        if strict:
            counted = counted[~parts["exactly_empty"] & ((parts["areas"] > least) | (least == 0))]
        else:
            counted = counted[parts["areas"] > least]
        return np.bincount(counted.reshape(-1), minlength=len(parts["volumes"])).astype(np.int32)

    def nearest_vertex(self, xi: ArrayLike) -> Indices:
        """The vertices nearest to given positions, decided exactly.

        Parameters
        ----------
        xi : array_like, shape (..., d)

        Returns
        -------
        ndarray of int32, shape (...)
            Indices of vertices: those in whose Voronoi cells the positions are. Of several nearest ones, any of them.

        Raises
        ------
        Error
            With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, and ``too_few`` without vertices.
        """
        return _core.nearest_vertex(self._mesh, xi)

    def interpolate(self, values: ArrayLike, xi: ArrayLike, *, out: NDArray[typing.Any] | None = None,
                    dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """Natural-neighbour interpolation of values at the points, by Laplace's weights.

        Parameters
        ----------
        values : array_like, shape (npoints, ...)
            Numbers, or arrays of numbers, at the points. Those at free indices are not used.
        xi : array_like, shape (..., d)
            Where to interpolate.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (..., ...)
            The shape of `xi` without its last axis, then that of a value. NaN at positions that are not in the interior
            of the convex hull.

        Raises
        ------
        Error
            With the code ``wrong_size``.

        Notes
        -----
        If a position were inserted as a point, its Voronoi cell would have facets with natural neighbours j. The
        weight of j is the area of this facet over the distance from j, divided by the sum of these (Belikov et al.
        1997; "non-Sibsonian"). Linear functions are reproduced, and at a point its own value. The interpolant is
        continuous in the interior of the hull. Some twenty microseconds for each position in 2D, a hundred in 3D.
        """
        if out is None and dtype is None:
            return _core.interpolate(self._mesh, values, xi)
        values, xi = _arguments.array_of(values, "values"), _arguments.array_of(xi, "xi")
        shape = xi.shape[:-1] + values.shape[1:]
        return _outputs.returned(lambda: _core.interpolate(self._mesh, values, xi), lambda: shape, out, dtype, values,
                                 xi)
