# SPDX-License-Identifier: GPL-3.0-or-later
"""`analyze`: one call for a trajectory."""

from __future__ import annotations

import typing
from collections.abc import Collection, Iterator, Mapping

from numpy.typing import ArrayLike

from . import _arguments
from ._analysis import Analysis, AnalysisStream
from ._error import Error
from ._frame_analyzer import FrameAnalyzer
from ._frame_result import FrameResult
from ._snapshots import Selection, selection_of, snapshots


def _results(source: object, selection: Selection, analyzer: FrameAnalyzer) -> Iterator[FrameResult]:
    number = 0
    for snapshot in snapshots(source, selection):
        number += 1
        yield analyzer(snapshot)
    if number == 0:
        raise Error("source has no frame between start and stop", "bad_input")


@typing.overload
def analyze(source: typing.Any, what: str | Collection[str] = ..., *, start: int | None = ..., stop: int | None = ...,
            step: int | None = ..., box: ArrayLike | str | None = ..., clip: ArrayLike | None = ...,
            min_area: float = ..., threads: int = ..., columns: Mapping[str, str | int] | None = ...,
            absent_frames: str = ..., stream: typing.Literal[False] = ...) -> Analysis: ...


@typing.overload
def analyze(source: typing.Any, what: str | Collection[str] = ..., *, start: int | None = ..., stop: int | None = ...,
            step: int | None = ..., box: ArrayLike | str | None = ..., clip: ArrayLike | None = ...,
            min_area: float = ..., threads: int = ..., columns: Mapping[str, str | int] | None = ...,
            absent_frames: str = ..., stream: typing.Literal[True]) -> AnalysisStream: ...


def analyze(source: typing.Any, what: str | Collection[str] = ("volumes", "neighbors", "events"), *,
            start: int | None = None, stop: int | None = None, step: int | None = None,
            box: ArrayLike | str | None = None, clip: ArrayLike | None = None, min_area: float = 0.0,
            threads: int = 1, columns: Mapping[str, str | int] | None = None, absent_frames: str = "refuse",
            stream: bool = False) -> Analysis | AnalysisStream:
    """Voronoi volumes, neighbours and their changes in all frames of a trajectory.

    Parameters
    ----------
    source : object
        * an array of shape (frames, n, d), d = 2 or 3, which may be read piece by piece (mapped, h5py's); or (n, d);
        * a Universe, an AtomGroup, a Timestep or a trajectory of MDAnalysis;
        * Atoms of ASE, or an iterable of them: a list, `ase.io.Trajectory`, `ase.io.iread`;
        * an iterable of arrays (n, d), or of pairs (tuples) of a box and such an array; the box has shape (d,) or
          (d, d), or is None;
        * the name of a file: ``.npy``; ``.xtc``, ``.trr``, ``.dcd``, ``.nc``, ``.h5md``, which MDAnalysis reads; any
          other format that ASE reads, as XYZ, extended XYZ and dumps of LAMMPS;
        * the name of a tracking table: ``.csv``, ``.tsv``, ``.txt``, ``.dat``, also compressed, ``.gz``, with a row for
          each point and frame, in any order. It is read as ``annulus replay`` reads it.

        Row i has to be the same point in every frame. Frames may differ in the number of points, if not for
        ``events``. In a table points have ids, and may appear and disappear: see `Analysis.ids`.
    what : str, or tuple, list or set of str, optional
        ``volumes``, ``neighbors``, ``pairs``, ``events``, ``moves``: the attributes of that name of `FrameResult`.
    start, stop, step : int, optional
        The frames ``range(frames)[start:stop:step]``; `step` is 1 or more.
    box : array_like, shape (d,) or (d, d), or "open", optional
        The periodic box of all frames: lengths, or vectors as rows. By default each frame has that of the source, and
        open boundaries if there is none there. With ``open`` no frame has one.
    clip : array_like, optional
        For open boundaries: what cells and facets are intersected with, as for `MovingDelaunay.voronoi`.
    min_area : float, optional
        Pairs are neighbours whose common facet is not exactly empty, and has a larger area (length in 2D) than this.
        In crystals, whose atoms vibrate, facets that are nearly empty come and go: exclude them.
    threads : int, optional
        As for `MovingDelaunay`.
    columns : dict, optional
        Of a table: the names of columns, or their numbers from 1, by ``frame``, ``id``, ``x``, ``y``, ``z``, as
        ``{"id": "particle", "x": 3, "y": 4}``. Others are found by their names, but x, y and z are given together. A
        file with columns is a table, whatever its name.
    absent_frames : str, optional
        Gaps in the frame numbers of a table: ``refuse`` them; ``empty``, one frame without points for each gap;
        or ``skip`` them, which also takes times at any distance.
    stream : bool, optional
        Return an iterator, for trajectories that do not fit into memory.

    Returns
    -------
    Analysis, or AnalysisStream if `stream`

    Raises
    ------
    Error
        For a frame, whose number the message begins with: with the codes of `MovingDelaunay`; ``bad_input`` if it
        cannot be read; ``wrong_size`` if the number of points changes and `what` has ``events``. A `NotAvailableError`
        for boxes of ASE that are periodic in some directions only. For a table the message begins with the file and
        the line. For arguments with the code ``usage``. With `stream`, when the frame is requested.
    ImportError
        If the package that reads a file is not installed.

    Notes
    -----
    Units are those of the source: angstroms with ASE and, whatever the file has, MDAnalysis.

    What was passed over in a table, or may have another meaning, is a `TableWarning`; `Analysis.taken` says which
    columns were taken. A regular file is read twice, and a third time if points have a z. Tables whose rows are not in
    the order of frames are held in memory, 72 bytes for each row.

    Without a box one `MovingDelaunay` follows all frames; in a box a `PeriodicDelaunay`. If other points of a table are
    present than in the frame before, a new one is built.
    ``volumes`` cost what `voronoi_volumes` does, and the others about two microseconds per point in 2D and ten in 3D,
    for all of them. A frame of n points keeps 8 n bytes for ``volumes``, 4 n for ``neighbors``, and about 120 n in 2D
    and 340 n in 3D for ``pairs``.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> x = np.random.default_rng(0).random((5, 100, 3)) * 0.01 + np.random.default_rng(1).random((100, 3))
    >>> a = annulus.analyze(x, ("volumes", "neighbors"), box=[1, 1, 1])
    >>> a.volumes.shape, bool(np.allclose(a.volumes.sum(axis=1), 1))
    ((5, 100), True)
    """
    analyzer = FrameAnalyzer(what, min_area, clip, threads)
    results = _results(source, selection_of(start, stop, step, box, columns, absent_frames), analyzer)
    if _arguments.truth("stream", stream):
        return AnalysisStream(analyzer.what, results)
    return Analysis(analyzer.what, results)
