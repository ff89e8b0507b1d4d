# SPDX-License-Identifier: GPL-3.0-or-later
"""Where positions are in a `PeriodicDelaunay`: simplices, nearest vertices, interpolation."""

from __future__ import annotations

import typing

from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments, _core, _outputs
from ._periodic_arguments import plain
from ._queries import Indices


class PeriodicQueries:
    """The part of `PeriodicDelaunay` that takes positions, each in any image."""

    _mesh: _core.Periodic2 | _core.Periodic3

    def find_simplex(self, xi: ArrayLike) -> tuple[Indices, Indices]:
        """The simplices that contain points, decided exactly for the points as they would be rounded.

        Parameters
        ----------
        xi : array_like, shape (..., d)
            Inside the box or not.

        Returns
        -------
        simplices : ndarray of int32, shape (...)
            -1 for a point with a coordinate that is NaN, and without simplices.
        shifts : ndarray of int32, shape (..., d)
            Which image of the simplex it is: its corners are at ``points[simplices[s]] + (simplex_offsets[s] + shift)
            @ box``.

        Raises
        ------
        Error
            With the codes ``wrong_size``, ``not_finite`` for infinity, ``out_of_domain``.
        """
        return self._mesh.find_simplex(plain(xi, "xi"))

    def nearest_vertex(self, xi: ArrayLike) -> tuple[Indices, Indices]:
        """The vertices nearest to given positions, decided exactly for the positions as they would be rounded.

        Parameters
        ----------
        xi : array_like, shape (..., d)
            Inside the box or not.

        Returns
        -------
        vertices : ndarray of int32, shape (...)
            Those in whose Voronoi cells the positions are. Of several nearest ones, any of them.
        shifts : ndarray of int32, shape (..., d)
            Which image of the vertex is beside the position: it is at ``points[v] + S @ box``, so that this less `xi`
            is the shortest vector from the position to any image of any vertex.

        Raises
        ------
        Error
            With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, and ``too_few`` without vertices.

        Notes
        -----
        Costs what `find_simplex` costs: a few microseconds each in 2D, ten to thirty in 3D.
        """
        return self._mesh.nearest_vertex(plain(xi, "xi"))

    def interpolate(self, values: ArrayLike, xi: ArrayLike, *, out: NDArray[typing.Any] | None = None,
                    dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """Natural-neighbour interpolation of values at the points, by Laplace's weights, to a periodic function.

        Parameters
        ----------
        values : array_like, shape (npoints, ...)
            Numbers, or arrays of numbers, at the points and at all of their images. Those at free indices are not used.
        xi : array_like, shape (..., d)
            Where to interpolate, inside the box or not.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (..., ...)
            The shape of `xi` without its last axis, then that of a value. NaN where a coordinate is, and without
            vertices: there is no hull to be outside of.

        Raises
        ------
        Error
            With the codes ``wrong_size``, ``not_finite`` for infinity, ``out_of_domain``.

        Notes
        -----
        As `MovingDelaunay.interpolate`: if a position were inserted, with all of its images, its Voronoi cell would
        have facets with natural neighbours j. The weight of j is the area of this facet over the distance from j,
        divided by the sum of these. With few points a position is also beside images of its own. These facets do not
        count: as they come in opposite pairs, the weighted mean of the vectors to the neighbours is 0 without them,
        too, so that functions which are linear nearby are reproduced. At a point it is its own value. The interpolant
        is continuous. Some ten microseconds for each position in 2D, two hundred in 3D; with few points or in thin
        boxes a hundred and some thousands.
        """
        if out is None and dtype is None:
            return self._mesh.interpolate(values, plain(xi, "xi"))
        values, xi = _arguments.array_of(values, "values"), plain(xi, "xi")
        shape = xi.shape[:-1] + values.shape[1:]
        return _outputs.returned(lambda: self._mesh.interpolate(values, xi), lambda: shape, out, dtype, values, xi)
