# SPDX-License-Identifier: GPL-3.0-or-later
"""What `analyze` returns: an `Analysis` with arrays, or an `AnalysisStream` of frames."""

from __future__ import annotations

import functools
import os
import typing
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from . import _tables
from ._frame_result import Computed, FrameResult
from ._queries import Floats, Indices


class Analysis(Computed):
    """What `analyze` finds in all frames. Quantities that `what` does not name are no attributes.

    It has a length, and is iterable: ``len(a)`` frames, ``a[k]`` the `FrameResult` of one. Arrays over all frames are
    put together at the first access, and kept.

    Attributes
    ----------
    what : tuple of str
        The quantities that were computed.
    """

    def __init__(self, what: tuple[str, ...], results: Iterable[FrameResult]) -> None:
        self.what = what
        self._results = list(results)

    def __len__(self) -> int:
        return len(self._results)

    def __getitem__(self, k: int) -> FrameResult:
        return self._results[k]

    def __iter__(self) -> Iterator[FrameResult]:
        return iter(self._results)

    def __repr__(self) -> str:
        return f"<Analysis: {len(self)} frames, {', '.join(self.what)}>"

    @property
    def frames(self) -> NDArray[np.int64]:
        """ndarray of int64, shape (frames,): the numbers of the frames in the source; of a table those in it."""
        return np.array([r.frame for r in self], dtype=np.int64)

    @property
    def times(self) -> Floats:
        """ndarray of float64, shape (frames,): the times of the frames; NaN if they have none."""
        return np.array([r.time for r in self])

    @property
    def boxes(self) -> Floats:
        """ndarray of float64, shape (frames, d, d): the vectors of the boxes as rows; NaN if boundaries are open."""
        return np.array([np.full((r.ndim, r.ndim), np.nan) if r.box is None else r.box for r in self])

    @property
    def npoints(self) -> NDArray[np.int64]:
        """ndarray of int64, shape (frames,): the number of points in each frame."""
        return np.array([r.npoints for r in self], dtype=np.int64)

    @property
    def ids(self) -> NDArray[typing.Any]:
        """ndarray of int64 or str, shape (n,): the ids of the points as a table has them (uint64 if one is 2**63 or
        more), in the order in which they appear; 0 to n - 1 of other sources."""
        return max(self._results, key=lambda r: r._size).ids

    @property
    def taken(self) -> dict[str, str]:
        """dict: what of a table was taken for what, ``{'frame': 'column 1 (t)', 'id': 'column 2 (particle)', ..}``,
        and under ``dimension`` why points with a z are in 2D. Empty for other sources."""
        return self._results[-1].taken

    @functools.cached_property
    def volumes(self) -> Floats:
        """ndarray of float64, shape (frames, n): areas (2D) or volumes (3D) of the Voronoi cells; ``inf`` for
        unbounded ones. NaN from the number of points of a frame on, if frames differ in it, and where a point of a
        table is absent."""
        return typing.cast(Floats, self._padded("volumes", np.nan))

    @functools.cached_property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (frames, n): the number of neighbours of each point; -1 where there is none."""
        return typing.cast(Indices, self._padded("neighbors", -1))

    @functools.cached_property
    def pairs(self) -> NDArray[np.void]:
        """structured ndarray: the pairs of all frames, as in `FrameResult`."""
        return np.concatenate([r.pairs for r in self])

    @functools.cached_property
    def events(self) -> NDArray[np.void]:
        """structured ndarray: the events of all frames, as in `FrameResult`."""
        return np.concatenate([r.events for r in self])

    @functools.cached_property
    def moves(self) -> NDArray[np.void]:
        """structured ndarray, shape (frames,): the counts of moves, as in `FrameResult`."""
        return np.concatenate([r.moves for r in self])

    def _padded(self, name: str, missing: float) -> typing.Any:
        rows = [getattr(r, name) for r in self]
        array = np.full((len(rows), max(map(len, rows))), missing, dtype=rows[0].dtype)
        for k, row in enumerate(rows):
            array[k, :len(row)] = row
        return array

    def to_pandas(self, table: str | None = None) -> typing.Any:
        """A table as a `pandas.DataFrame`.

        Parameters
        ----------
        table : str, optional
            ``points``: a row for each point of each frame, with ``frame``, ``time``, ``point``, of a table ``id``, and
            what was computed of ``volume`` and ``neighbors``; ``pairs``, ``events`` or ``moves``: the rows of these
            arrays, of a table with ``id_i`` and ``id_j``, the shift as ``shift_x``, ``shift_y``, ``shift_z``. By
            default the first of these that was computed.

        Returns
        -------
        pandas.DataFrame

        Raises
        ------
        ImportError
            If pandas is not installed.
        Error
            With the code ``usage`` for a table that was not computed.
        """
        return _tables.to_pandas(self, self.what, table)

    def to_hdf5(self, path: str | os.PathLike[str]) -> None:
        """Writes everything that was computed to an HDF5 file, as `AnalysisStream.to_hdf5` does."""
        _tables.to_hdf5(self, self.what, path)

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes a folder of Parquet files, as `AnalysisStream.to_parquet` does."""
        _tables.to_parquet(self, self.what, path)


class AnalysisStream:
    """The frames of `analyze` with ``stream=True``: an iterator of `FrameResult`, which keeps none of them.

    Frames are read and computed when they are requested. `to_hdf5` and `to_parquet` write all frames that have not
    been taken yet, one after the other; memory is that of one frame and of a buffer.

    Attributes
    ----------
    what : tuple of str
        The quantities that are computed.
    """

    what: tuple[str, ...]

    def __init__(self, what: tuple[str, ...], results: Iterator[FrameResult]) -> None:
        self.what = what
        self._results = results

    def __iter__(self) -> Iterator[FrameResult]:
        return self

    def __next__(self) -> FrameResult:
        return next(self._results)

    def __repr__(self) -> str:
        return f"<AnalysisStream: {', '.join(self.what)}>"

    def to_hdf5(self, path: str | os.PathLike[str]) -> None:
        """Writes everything that is computed to an HDF5 file.

        Parameters
        ----------
        path : str or os.PathLike
            A file of this name is overwritten.

        Raises
        ------
        ImportError
            If h5py is not installed.
        Error
            That of a frame. The file has all frames before it.

        Notes
        -----
        Datasets: ``frames``, ``times``, ``npoints``, ``boxes`` (NaN if boundaries are open), of a table ``ids``, and
        those of ``volumes``, ``neighbors``, ``pairs``, ``events``, ``moves`` that were computed, in the shapes and
        types of the attributes of `Analysis`. The attribute ``what`` has the names of the latter, ``annulus`` the
        version.
        """
        _tables.to_hdf5(self, self.what, path)

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes a folder of Parquet files: ``points.parquet``, ``pairs.parquet``, ``events.parquet`` and
        ``moves.parquet``, those that were computed, with the columns of `Analysis.to_pandas`.

        Parameters
        ----------
        path : str or os.PathLike
            A folder, which is created if there is none. Files of these names are overwritten.

        Raises
        ------
        ImportError
            If pyarrow is not installed.
        Error
            That of a frame. The files have all frames before it.
        """
        _tables.to_parquet(self, self.what, path)
