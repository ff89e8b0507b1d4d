# SPDX-License-Identifier: GPL-3.0-or-later
"""Tracking tables, trajectories in CSV and other text: read by the compiled module, as the tool reads them."""

from __future__ import annotations

import os
import sys
import typing
import warnings
from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._error import Error, TableWarning

_COLUMNS = ("frame", "id", "x", "y", "z")
_ABSENT = ("refuse", "empty", "skip")
_PACKAGE = os.path.dirname(__file__)


class TableOptions(typing.NamedTuple):
    """Which columns are taken, by `_COLUMNS`, empty where the table says it; and what gaps in its frames are."""

    columns: tuple[str, ...]
    absent: str

    @property
    def given(self) -> bool:
        return self != TableOptions(("",) * 5, "refuse")


def table_options_of(columns: object, absent_frames: object) -> TableOptions:
    return TableOptions(_columns_of(columns), _arguments.choice("absent_frames", absent_frames, _ABSENT))


def _columns_of(columns: object) -> tuple[str, ...]:
    if columns is None:
        return ("",) * 5
    if not isinstance(columns, Mapping):
        raise TypeError(f"columns must be a dict, as {{'id': 'particle'}}, not {_arguments.described(columns)}")
    chosen = {_arguments.choice("a key of columns", key, _COLUMNS): _column(key, name) for key, name in columns.items()}
    if ("x" in chosen) != ("y" in chosen) or "z" in chosen and "x" not in chosen:
        raise Error("columns must have x and y together, and z only with them", "usage")
    return tuple(chosen.get(key, "") for key in _COLUMNS)


def _column(key: str, name: object) -> str:
    """A name in the header, or a number from 1."""
    if not isinstance(name, str):
        return str(_arguments.whole(f"columns[{key!r}]", name, 1, 2**31 - 1))
    if not name:
        raise Error(f"columns[{key!r}] must be a name or a number of a column, not ''", "usage")
    return name


class Tracks:
    """The ids of the frames of a table that were taken, in the order of their first appearance, and within a frame in
    that of the ids: rows of results. What was taken for what."""

    def __init__(self, reader: _core.Table) -> None:
        self._reader: _core.Table | None = reader
        self._parts: list[NDArray[np.uint64]] = []  # numbers of ids by row
        self._numbers = np.empty(0, dtype=np.uint64)  # ascending
        self._rows = np.empty(0, dtype=np.int32)  # of these
        self._ids: NDArray[typing.Any] = np.empty(0, dtype=np.int64)
        self._taken: dict[str, str] = {}

    def __len__(self) -> int:
        return len(self._numbers)

    def __getstate__(self) -> dict[str, typing.Any]:
        self.ids(len(self))
        return {**self.__dict__, "_taken": self.taken, "_reader": None}

    def rows_of(self, numbers: NDArray[np.uint64]) -> NDArray[np.int32]:
        """The rows of ids of a frame, ascending, by their numbers. New ones get the next rows. O(N + n log N) for N
        ids."""
        at = np.searchsorted(self._numbers, numbers)
        new = np.ones(len(numbers), dtype=bool)
        inside = at < len(self)
        new[inside] = self._numbers[at[inside]] != numbers[inside]
        if new.any():
            fresh = np.arange(len(self), len(self) + np.count_nonzero(new), dtype=np.int32)
            self._parts.append(numbers[new])
            self._rows = np.insert(self._rows, at[new], fresh)
            self._numbers = np.insert(self._numbers, at[new], numbers[new])
            at = np.searchsorted(self._numbers, numbers)
        return self._rows[at]

    def ids(self, count: int) -> NDArray[typing.Any]:
        """The ids of the first rows, as the table writes them."""
        reader = self._reader  # another thread may close it
        if len(self._ids) < count and reader is not None:
            numbers = np.concatenate(self._parts)
            words = reader.words()
            if words is not None:
                ids = np.array(words)[numbers]
            else:
                ids = numbers.view(np.int64) if reader.signs() or int(numbers.max()) < 2**63 else numbers
            ids.flags.writeable = False
            self._ids = ids
        return self._ids[:count]

    @property
    def taken(self) -> dict[str, str]:
        reader = self._reader
        return dict(self._taken if reader is None else reader.taken())

    def close(self) -> None:
        self.ids(len(self))
        self._taken, self._reader = self.taken, None


class TableFrame(typing.NamedTuple):
    """A frame as it is in the table, its points in the order of the numbers of their ids."""

    number: int
    time: float
    points: NDArray[np.float64]
    numbers: NDArray[np.uint64]
    tracks: Tracks


class Tracked(typing.NamedTuple):
    """Which of the rows so far the points of a frame are, ascending."""

    rows: NDArray[np.int32]
    size: int
    tracks: Tracks


def tracked_of(frame: TableFrame) -> tuple[NDArray[np.float64], Tracked]:
    """The points in the order of their rows, and these."""
    rows = frame.tracks.rows_of(frame.numbers)
    order = np.argsort(rows)
    return frame.points[order], Tracked(rows[order], len(frame.tracks), frame.tracks)


def frames_of_table(name: str, options: TableOptions) -> Iterator[TableFrame]:
    """The frames of a table, read when they are taken, but for a first look at all of it."""
    reader = _core.Table.open(os.fsencode(os.path.join(".", name) if name == "-" else name), options.columns,
                              options.absent)
    tracks = Tracks(reader)
    try:
        while True:
            item = reader.next()
            for note in reader.notes():
                warnings.warn(note, TableWarning, stacklevel=_outside())
            if item is None:
                return
            number, time, numbers, points = item
            yield TableFrame(number, time, points, numbers, tracks)
    finally:
        tracks.close()


def _outside() -> int:
    """The `stacklevel` of the code that calls the package, for a warning of the function that calls this one."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == _PACKAGE:
        level, frame = level + 1, frame.f_back
    return level
