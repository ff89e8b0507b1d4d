# SPDX-License-Identifier: GPL-3.0-or-later
"""What calls have changed in a `PeriodicDelaunay`."""

from __future__ import annotations

from . import _core
from ._queries import Indices


class PeriodicChanges:
    """The part of `PeriodicDelaunay` that lists what the last call made, broke, created and removed."""

    _mesh: _core.Periodic2 | _core.Periodic3

    @property
    def pairs_made(self) -> tuple[Indices, Indices, Indices]:
        """tuple of ndarrays, i, j and S: the pairs of neighbours that the last call of `move`, `insert` or `remove`
        made, each once, i <= j, ascending: point j, moved by ``S @ box``, is a neighbour of point i since. Facets of
        the triangulation count, also those that are exactly empty. Points that are given as other images change
        nothing, nor does a box in another basis of its lattice. Raises an `Error` with the code ``usage`` without
        `report_changes`."""
        return self._mesh.pairs(True)

    @property
    def pairs_broken(self) -> tuple[Indices, Indices, Indices]:
        """tuple of ndarrays, i, j and S: the pairs that the same call broke, by points and box before it."""
        return self._mesh.pairs(False)

    @property
    def changed_simplices(self) -> tuple[Indices, Indices]:
        """tuple of ndarrays, vertices (k, d + 1) and offsets (k, d + 1, d), int32: the simplices that the last call of
        `move`, `insert` or `remove` created. They are positively oriented, as `simplices`, but each is written in one
        way only: corners ascend by (vertex, offset), the last two exchanged where that makes the simplex positive, and
        the least offset is 0 in each direction. Simplices ascend. Points that are given as other images change nothing,
        nor does a box in another basis of its lattice. Raises an `Error` with the code ``usage`` without
        `report_changes`."""
        return self._mesh.changed_cells(True)

    @property
    def removed_simplices(self) -> tuple[Indices, Indices]:
        """tuple of ndarrays, vertices and offsets: the simplices that the same call removed, by points and box before
        it. A simplex that was turned over is in both lists, with its vertices in another order."""
        return self._mesh.changed_cells(False)
