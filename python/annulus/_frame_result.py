# SPDX-License-Identifier: GPL-3.0-or-later
"""`FrameResult`: what `analyze` finds in one frame."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import NDArray

from ._queries import Floats, Indices
from ._tracking_tables import Tracked

QUANTITIES = ("volumes", "neighbors", "pairs", "events", "moves")
MOVES = ("asked", "within_tolerance", "kept_in_place", "flipped", "reinserted", "rebuilt")
EVENTS = np.dtype([("frame", np.int64), ("i", np.int32), ("j", np.int32), ("made", np.bool_)])
MOVE_COUNTS = np.dtype([("frame", np.int64), *((name, np.int64) for name in MOVES)])


def pair_type(ndim: int) -> np.dtype[typing.Any]:
    return np.dtype([("frame", np.int64), ("i", np.int32), ("j", np.int32), ("distance", np.float64),
                     ("area", np.float64), ("shift", np.int32, (ndim,))])


class Computed:
    """An object with some of the attributes of `QUANTITIES`: those that `what` names."""

    what: tuple[str, ...]

    def __getattr__(self, name: str) -> typing.Any:
        if name in QUANTITIES:
            raise AttributeError(f"{name} were not computed: what does not name them")
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")


class FrameResult(Computed):
    """What `analyze` finds in one frame. Quantities that `what` does not name are no attributes.

    Attributes
    ----------
    frame : int
        Its number in the source, from 0; of a table its number there.
    time : float
        Its time in the unit of the source; NaN if that has none.
    npoints, ndim : int
        The number n of points, and d. Of a table: the number of points that are present in this frame. There n counts
        all points of this frame and those before, and what concerns points has NaN or -1 where they are absent.
    box : ndarray of float64, shape (d, d), or None
        The vectors of its periodic box as rows; None if boundaries are open.
    volumes : ndarray of float64, shape (n,)
        Areas (2D) or volumes (3D) of the Voronoi cells; ``inf`` for unbounded ones.
    neighbors : ndarray of int32, shape (n,)
        The number of neighbours of each point.
    pairs : structured ndarray, shape (m,)
        Each pair of neighbours once, i <= j: ``frame``, ``i``, ``j``, ``distance``, ``area`` of the common facet
        (length in 2D) and, for periodic boxes, ``shift`` (d integers): j is at ``points[j] + shift @ box``. In small
        boxes two points are neighbours several times, and a point is one of itself.
    events : structured ndarray, shape (k,)
        The pairs that became neighbours (``made`` true) or ceased to be, ascending by ``i`` and ``j``, against the
        frame that was analysed before. The first frame has none.
    moves : structured ndarray, shape (1,)
        The counts of `MoveResult`: what the step from the frame before took. Zeros in frames that were built.
    """

    frame: int
    time: float
    npoints: int
    ndim: int
    box: Floats | None
    volumes: Floats
    neighbors: Indices
    pairs: NDArray[np.void]
    events: NDArray[np.void]
    moves: NDArray[np.void]

    def __init__(self, frame: int, time: float, npoints: int, ndim: int, box: Floats | None,
                 computed: dict[str, typing.Any], tracked: Tracked | None = None) -> None:
        self.frame, self.time, self.npoints, self.ndim, self.box = frame, time, npoints, ndim, box
        self.what = tuple(computed)
        self._tracked = tracked
        self.__dict__.update(computed)

    @property
    def _size(self) -> int:
        return self.npoints if self._tracked is None else self._tracked.size

    @property
    def ids(self) -> NDArray[typing.Any]:
        """ndarray of int64 or str, shape (n,): the ids of the points as a table has them (uint64 if one is 2**63 or
        more); 0 to n - 1 of other sources."""
        tracked = self._tracked
        return np.arange(self.npoints) if tracked is None else tracked.tracks.ids(tracked.size)

    @property
    def present(self) -> Indices:
        """ndarray of int32, shape (npoints,): which of the n points are in this frame, ascending."""
        return np.arange(self.npoints, dtype=np.int32) if self._tracked is None else self._tracked.rows

    @property
    def taken(self) -> dict[str, str]:
        """dict: what of a table was taken for what, as it has been read so far: ``{'id': 'column 2 (particle)', ..}``.
        Empty for other sources."""
        return {} if self._tracked is None else self._tracked.tracks.taken

    def __repr__(self) -> str:
        return f"<FrameResult: frame {self.frame}, {self.npoints} points in {self.ndim}D, {', '.join(self.what)}>"
