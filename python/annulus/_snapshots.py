# SPDX-License-Identifier: GPL-3.0-or-later
"""Where trajectories come from: the frames of arrays, of objects of MDAnalysis and ASE, of pairs and of files."""

from __future__ import annotations

import contextlib
import os
import sys
import typing
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments
from ._error import Error, NotAvailableError
from ._tracking_tables import TableFrame, TableOptions, Tracked, table_options_of, tracked_of
from ._trajectory_files import opened

_EXPECTED = ("an array of shape (frames, n, d) or (n, d), the name of a file, a Universe or AtomGroup of MDAnalysis, "
             "Atoms of ASE, a pair (box, points), or an iterable of such Atoms, of arrays (n, d) or of such pairs")


class Snapshot(typing.NamedTuple):
    """A frame: its number in the source, its time (NaN if it has none), points (n, d); box (d,) or (d, d), or None;
    which rows of results the points are, if the source says it."""

    frame: int
    time: float
    points: np.ndarray[typing.Any, typing.Any]
    box: np.ndarray[typing.Any, typing.Any] | None
    tracked: Tracked | None = None


class Selection(typing.NamedTuple):
    """The frames to be taken, the box that the source is given: an array, ``open``, or None for its own; and how a
    table is read."""

    start: int | None
    stop: int | None
    step: int | None
    box: typing.Any
    table: TableOptions


def selection_of(start: object, stop: object, step: object, box: ArrayLike | str | None, columns: object = None,
                 absent_frames: object = "refuse") -> Selection:
    most = 2**63 - 1
    if isinstance(box, str) and box != "open":
        raise Error(f"box must be an array, 'open' or None, not {_arguments.described(box)}", "usage")
    first, end, stride = (None if value is None else _arguments.whole(name, value, least, most) for name, value, least
                          in (("start", start, -most), ("stop", stop, -most), ("step", step, 1)))
    return Selection(first, end, stride, box, table_options_of(columns, absent_frames))


@contextlib.contextmanager
def naming(frame: int) -> Iterator[None]:
    """Exceptions of annulus get the number of the frame in front of their message."""
    try:
        yield
    except Error as e:
        raise type(e)(f"frame {frame}: {e}", e.code, e.vertices) from e
    except TypeError as e:
        raise TypeError(f"frame {frame}: {e}") from e


def snapshots(source: typing.Any, selection: Selection) -> Iterator[Snapshot]:
    """The chosen frames of a source, one after the other. Nothing of a frame is kept after the next one is taken."""
    for frame, item in _numbered(_items_of(source, selection.table), selection):
        yield snapshot_of(item.number if isinstance(item, TableFrame) else frame, item, selection.box)


def snapshot_of(frame: int, item: typing.Any, box: typing.Any) -> Snapshot:
    """An element of a source as a frame, with the box of `Selection`."""
    with naming(frame):
        return _snapshot(frame, item, box)


# ---- Sources -------------------------------------------------------------------------------------------------------

class _Atoms:
    """Some atoms of MDAnalysis at a Timestep, with what is used of one."""

    def __init__(self, atoms: typing.Any, step: typing.Any) -> None:
        self.positions, self.dimensions, self.time = atoms.positions, step.dimensions, step.time
        self._step = step

    @property
    def triclinic_dimensions(self) -> typing.Any:
        return self._step.triclinic_dimensions


def atoms_at(atoms: typing.Any, step: typing.Any) -> typing.Any:
    """The positions of an AtomGroup at the present step of its trajectory."""
    return _Atoms(atoms, step)


class _Trajectory:
    """The frames of an AtomGroup or Universe of MDAnalysis."""

    def __init__(self, atoms: typing.Any, trajectory: typing.Any) -> None:
        self._atoms, self._trajectory = atoms, trajectory

    def __len__(self) -> int:
        return len(self._trajectory)

    def __getitem__(self, frame: int) -> typing.Any:
        step = self._trajectory[frame]  # before positions are read
        return atoms_at(self._atoms, step)


def _items_of(source: typing.Any, table: TableOptions) -> typing.Any:
    """The frames of a source: something with a length and indices, or an iterable."""
    if isinstance(source, (str, os.PathLike)):
        source = opened(source, table)
    elif table.given:
        raise Error("columns and absent_frames are for tables in files", "usage")
    if hasattr(source, "trajectory") and hasattr(source, "atoms"):
        return _Trajectory(source.atoms, source.trajectory)
    if hasattr(source, "universe") and hasattr(source, "positions"):
        return _Trajectory(source, source.universe.trajectory)
    if _is_snapshot(source):
        return [source]
    shape = getattr(source, "shape", None)
    if isinstance(shape, tuple):  # NumPy's, and what is read piece by piece, as h5py's
        if len(shape) not in (2, 3):
            raise Error(f"source must have shape (frames, n, d) or (n, d), not {tuple(shape)}", "wrong_size")
        return [source] if len(shape) == 2 else source
    if isinstance(source, (bytes, dict)) or not hasattr(source, "__iter__") and not hasattr(source, "__getitem__"):
        raise TypeError(f"source must be {_EXPECTED}; not {_arguments.described(source)}")
    return source


def _is_snapshot(source: typing.Any) -> bool:
    """Whether it is one frame: Atoms, a Timestep, or a pair of a box, or None, and points.

    Of two arrays (d, d), which might be two frames, the first is not taken for a box."""
    if hasattr(source, "positions"):
        return True
    if not _is_pair(source):
        return False
    box, points = source[0], getattr(source[1], "positions", source[1])
    d = np.shape(points)[-1]
    return box is None or _ndim(box) == 1 or np.shape(box) == (d, d) != np.shape(points)


_END = object()


def _numbered(items: typing.Any, selection: Selection) -> Iterator[tuple[int, typing.Any]]:
    start, stop, step = selection[:3]
    if hasattr(items, "__len__") and hasattr(items, "__getitem__"):
        for frame in range(*slice(start, stop, step).indices(len(items))):
            with _reading(frame):
                item = items[frame]
            yield frame, item
        return
    if (start or 0) < 0 or (stop or 0) < 0:
        raise Error("start and stop must be 0 or more, since this source does not say how many frames it has", "usage")
    numbers = range(start or 0, sys.maxsize if stop is None else stop, step or 1)
    rest, past = iter(items), 0
    for frame in numbers:
        for before in range(past, frame + 1):
            with _reading(before):
                item = next(rest, _END)
            if item is _END:
                return
        past = frame + 1
        yield frame, item


@contextlib.contextmanager
def _reading(frame: int) -> Iterator[None]:
    """What a reader raises becomes an `Error` with the number of the frame."""
    try:
        yield
    except (MemoryError, Error, Warning):
        raise
    except Exception as e:
        raise Error(f"frame {frame} cannot be read: {type(e).__name__}: {e}", "bad_input") from e


# ---- Frames --------------------------------------------------------------------------------------------------------

def _is_pair(item: typing.Any) -> bool:
    """A tuple of a box and points; a tuple of two points is points."""
    return isinstance(item, tuple) and len(item) == 2 and (hasattr(item[1], "positions") or _ndim(item[1]) == 2)


def _ndim(value: typing.Any) -> int:
    try:
        return np.ndim(value)
    except ValueError:  # lists of several lengths
        return -1


def _snapshot(frame: int, item: typing.Any, given: typing.Any) -> Snapshot:
    time = getattr(item, "time", None)
    box = tracked = None
    if isinstance(item, TableFrame):
        item, tracked = tracked_of(item)
    elif _is_pair(item):
        box, item = item[0], getattr(item[1], "positions", item[1])
    elif hasattr(item, "pbc") and hasattr(item, "cell"):
        box, item = _box_of_ase(item, given), item.positions
    elif hasattr(item, "dimensions") and hasattr(item, "positions"):
        box, item = _box_of_mdanalysis(item), item.positions
    elif given is not None and hasattr(item, "positions"):
        item = item.positions  # `array_of` would say that its box is ignored
    if given is not None:
        box = None if isinstance(given, str) else given
    points = item if type(item) is np.ndarray else _arguments.array_of(item, "points")
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        hint = "; an iterable has a frame for each element" if points.ndim == 1 else ""
        raise Error(f"points must have shape (n, 2) or (n, 3), not {points.shape}{hint}", "wrong_size")
    known = isinstance(time, (int, float, np.number))
    return Snapshot(frame, float(typing.cast(float, time)) if known else np.nan, points,
                    None if box is None else _arguments.array_of(box, "box"), tracked)


def _box_of_ase(atoms: typing.Any, given: typing.Any) -> typing.Any:
    periodic = np.asarray(atoms.pbc, dtype=bool)
    if given is not None or not periodic.any():
        return None
    if not periodic.all():
        raise NotAvailableError(f"pbc is {periodic.tolist()}, and boxes that are periodic in some directions only are "
                                "not available: box='open' takes the positions without the box")
    return np.asarray(atoms.cell)


def _box_of_mdanalysis(step: typing.Any) -> typing.Any:
    """Lengths, or vectors where an angle is not right; None if there is no box, or one without any length."""
    if step.dimensions is None:
        return None
    dimensions = np.asarray(step.dimensions)
    if not np.any(dimensions[:3]):
        return None
    return dimensions[:3] if np.all(dimensions[3:] == 90) else step.triclinic_dimensions
