# SPDX-License-Identifier: GPL-3.0-or-later
"""`FrameAnalyzer`, which follows a trajectory frame by frame with one triangulation."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._error import Error
from ._frame_result import EVENTS, MOVE_COUNTS, MOVES, QUANTITIES, FrameResult, pair_type
from ._moving_delaunay import MovingDelaunay
from ._periodic import PeriodicDelaunay
from ._queries import Floats
from ._snapshots import Snapshot, naming
from ._tracking_tables import Tracked
from ._voronoi import clip_of


def what_of(what: object) -> tuple[str, ...]:
    """The names of quantities, each once, in the order of `QUANTITIES`."""
    names = (what,) if isinstance(what, str) else what
    if not isinstance(names, (tuple, list, set, frozenset)):
        raise TypeError(f"what must be names of quantities, not {_arguments.described(what)}")
    chosen = {_arguments.choice("what", name, QUANTITIES) for name in names}
    if not chosen:
        raise Error(f"what must name a quantity: {', '.join(QUANTITIES)}", "usage")
    return tuple(name for name in QUANTITIES if name in chosen)


class FrameAnalyzer:
    """Computes what `analyze` returns of a frame. The frames come one after the other."""

    def __init__(self, what: object, min_area: object, clip: ArrayLike | None, threads: object) -> None:
        self.what = what_of(what)
        self._min_area = _arguments.number("min_area", min_area)
        if not self._min_area >= 0:
            raise Error(f"min_area must be 0 or more, not {_arguments.described(min_area)}", "usage")
        self._clip = clip
        self._threads = _arguments.whole("threads", threads, 1, 2**31 - 1)
        self._dt: typing.Any = None
        self._rows: NDArray[np.int32] | None = None  # of its points in results, if a table says it
        self._before: NDArray[np.int64] | None = None  # keys of the pairs of the last frame, ascending

    def __call__(self, snapshot: Snapshot) -> FrameResult:
        with naming(snapshot.frame):
            return self._result(snapshot)

    def _result(self, snapshot: Snapshot) -> FrameResult:
        frame, time, points, box, tracked = snapshot
        self._require(snapshot)
        report = self._follow(snapshot)
        computed: dict[str, typing.Any] = {}
        if "volumes" in self.what:
            volumes = self._dt.voronoi_volumes() if self._clip is None else self._dt.voronoi_volumes(self._clip)
            computed["volumes"] = _by_row(volumes, tracked, np.nan)
        if {"neighbors", "pairs", "events"} & set(self.what):
            pairs = self._pairs(frame)
            ends = np.concatenate([pairs["i"], pairs["j"]])
            counts = np.bincount(ends, minlength=len(points)).astype(np.int32)
            computed["neighbors"] = _by_row(counts, tracked, -1)
            if tracked is not None:  # rows ascend, so that i <= j still
                pairs["i"], pairs["j"] = tracked.rows[pairs["i"]], tracked.rows[pairs["j"]]
            computed["pairs"] = pairs
        if "events" in self.what:
            computed["events"] = self._events(frame, computed["pairs"])
        if "moves" in self.what:
            computed["moves"] = np.array([(frame, *(getattr(report, name) if report else 0 for name in MOVES))],
                                         dtype=MOVE_COUNTS)
        return FrameResult(frame, time, len(points), points.shape[1], None if box is None else _rows_of(box),
                           {name: computed[name] for name in self.what}, tracked)

    def _require(self, snapshot: Snapshot) -> None:
        """That the frame has what was requested, beside the one before."""
        if snapshot.box is not None and self._clip is not None:
            raise Error("clip is for open boundaries, and there is a periodic box", "usage")
        n, d = snapshot.points.shape
        if self._clip is not None:
            clip_of(self._clip, d)
        if self._dt is None:
            return
        if d != self._dt.ndim:
            raise Error(f"points have {d} coordinates, those of the frame before {self._dt.ndim}", "wrong_size")
        if "events" in self.what and n != self._dt.npoints and snapshot.tracked is None:
            raise Error(f"there are {n} points, {self._dt.npoints} in the frame before: 'events' needs the same points "
                        "in every frame", "wrong_size")

    def _follow(self, snapshot: Snapshot) -> _core.MoveResult | None:
        """Moves the triangulation to the points, or makes one if these are others than before."""
        points, box, dt = snapshot.points, snapshot.box, self._dt
        rows = None if snapshot.tracked is None else snapshot.tracked.rows
        same = rows is None or self._rows is not None and np.array_equal(rows, self._rows)
        self._rows = rows
        if not same or dt is None or dt.npoints != len(points) or isinstance(dt, PeriodicDelaunay) != (box is not None):
            self._dt = None
            self._dt = (MovingDelaunay(points, threads=self._threads, report_changes=False) if box is None
                        else PeriodicDelaunay(points, box, self._threads))
            return None
        return typing.cast(_core.MoveResult, dt.move(points) if box is None else dt.move(points, box))

    def _pairs(self, frame: int) -> NDArray[np.void]:
        if isinstance(self._dt, PeriodicDelaunay):
            i, j, distance, shift, area = self._dt.neighbor_list("ijdSA")
            sign = np.sign(shift) @ (9 ** np.arange(shift.shape[1]))  # that of the last component that is not 0
            keep = (area > self._min_area) & ((i < j) | (i == j) & (sign > 0))
        else:
            parts = _core.voronoi(self._dt._mesh, *clip_of(self._clip, self._dt.ndim))
            (i, j), distance, area = parts["pairs"].T, parts["distances"], parts["areas"]
            shift = np.zeros((len(i), self._dt.ndim), dtype=np.int32)
            keep = ~parts["exactly_empty"] & ((area > self._min_area) | (self._min_area == 0 and self._clip is None))
        pairs = np.empty(np.count_nonzero(keep), dtype=pair_type(self._dt.ndim))
        pairs["frame"] = frame
        for name, column in (("i", i), ("j", j), ("distance", distance), ("area", area), ("shift", shift)):
            pairs[name] = column[keep]
        return pairs

    def _events(self, frame: int, pairs: NDArray[np.void]) -> NDArray[np.void]:
        """What has come and gone among the pairs of two different points, whatever their shifts."""
        other = pairs[pairs["i"] != pairs["j"]]
        now = np.unique((other["i"].astype(np.int64) << 32) + other["j"])
        before, self._before = self._before, now
        if before is None:
            return np.empty(0, dtype=EVENTS)
        keys = np.setxor1d(now, before, assume_unique=True)
        events = np.empty(len(keys), dtype=EVENTS)
        events["frame"], events["i"], events["j"] = frame, keys >> 32, keys & (2**32 - 1)
        events["made"] = np.isin(keys, now, assume_unique=True)
        return events


def _by_row(values: np.ndarray[typing.Any, typing.Any], tracked: Tracked | None,
            absent: float) -> np.ndarray[typing.Any, typing.Any]:
    """Values of the points of a frame by the rows of all points so far."""
    if tracked is None:
        return values
    out = np.full(tracked.size, absent, dtype=values.dtype)
    out[tracked.rows] = values
    return out


def _rows_of(box: np.ndarray[typing.Any, typing.Any]) -> Floats:
    """The vectors of a box as rows; of lengths those of an orthorhombic box."""
    rows: Floats = np.array(box, dtype=np.float64)
    return np.diag(rows) if rows.ndim == 1 else rows
