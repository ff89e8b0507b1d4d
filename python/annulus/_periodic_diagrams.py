# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams, cells and volumes of a `PeriodicDelaunay`."""

from __future__ import annotations

import typing

from numpy.typing import DTypeLike, NDArray

from . import _core, _outputs
from ._periodic_arguments import refuse_clip
from ._periodic_polytopes import PeriodicPolytopes, polytopes_of
from ._periodic_voronoi import PeriodicVoronoi


class PeriodicDiagrams:
    """The part of `PeriodicDelaunay` that has Voronoi diagrams and volumes."""

    _mesh: _core.Periodic2 | _core.Periodic3

    def voronoi(self, clip: None = None) -> PeriodicVoronoi:
        """The Voronoi diagram: cells, their common facets, corners, with shifts.

        Parameters
        ----------
        clip : None, optional
            Every cell is bounded: anything else raises a `NotAvailableError`.

        Returns
        -------
        PeriodicVoronoi

        Notes
        -----
        O(n), some microseconds for each point, computed afresh by each call. Facets of nearly cospherical points, for
        which doubles are not accurate enough, are computed exactly, 20 microseconds each.
        """
        refuse_clip(clip)
        return PeriodicVoronoi(self._mesh.voronoi())

    def voronoi_polytopes(self, clip: None = None) -> PeriodicPolytopes:
        """The Voronoi cells as polygons or polyhedra, each around its point.

        Parameters
        ----------
        clip : None, optional
            As for `voronoi`.

        Returns
        -------
        PeriodicPolytopes

        Notes
        -----
        The cells of `voronoi`, with corners of their own. O(n log n), some microseconds for each point more.
        """
        return polytopes_of(self.voronoi(clip))

    def voronoi_volumes(self, clip: None = None, *, out: NDArray[typing.Any] | None = None,
                        dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The areas (2D) or volumes (3D) of the Voronoi cells, which add up to that of the box.

        Parameters
        ----------
        clip : None, optional
            As for `voronoi`.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            Each with a relative error of at most 2**-33, 1.2e-10; NaN at free indices.
        """
        refuse_clip(clip)
        return _outputs.returned(self._mesh.voronoi_volumes, lambda: (self._mesh.index_bound,), out, dtype)
