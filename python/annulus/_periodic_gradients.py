# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives of Voronoi volumes in a periodic box."""

from __future__ import annotations

import typing

from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core, _outputs
from ._queries import Floats, Indices


class PeriodicGradients:
    """The part of `PeriodicDelaunay` that differentiates volumes, in a box that keeps its vectors."""

    _mesh: _core.Periodic2 | _core.Periodic3

    def voronoi_vjp(self, g: ArrayLike, *, out: NDArray[typing.Any] | None = None,
                    dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The gradient of ``sum(g * volumes)`` with respect to the points: what reverse-mode differentiation needs.

        Parameters
        ----------
        g : array_like, shape (npoints,)
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (npoints, d)

        Raises
        ------
        Error
            With the code ``wrong_size``.

        Notes
        -----
        As `MovingDelaunay.voronoi_vjp`: all images of a point move with it, and the box does not change. The gradient
        of the sum of all volumes, that of the box, is 0, and so are the derivatives of a point that is alone. O(n), and
        20 microseconds for each facet that is computed exactly.
        """
        return _outputs.returned(lambda: self._mesh.voronoi_gradient(g), lambda: self._mesh.points.shape, out, dtype, g)

    def voronoi_jacobian(self) -> tuple[Indices, Indices, Floats]:
        """The derivatives of all volumes as a sparse matrix, in compressed rows.

        Returns
        -------
        indptr, indices : ndarray of int32
        values : ndarray of float64, shape (nnz, d)
            The derivative of volume i with respect to point ``indices[k]`` is ``values[k]``, for k from ``indptr[i]``
            to ``indptr[i + 1] - 1``. A row has the point itself and its neighbours, ascending, with one entry for all
            images of a neighbour.

        Notes
        -----
        As `MovingDelaunay.voronoi_jacobian`. The entries of a row add up to 0, and so do those of a column.
        """
        return self._mesh.voronoi_jacobian()
