# SPDX-License-Identifier: GPL-3.0-or-later
"""An analysis of MDAnalysis. Importing this module needs MDAnalysis; `annulus` itself does not.

    import annulus.mdanalysis
    run = annulus.mdanalysis.Voronoi(universe.atoms).run(stop=100)
    run.results.volumes
"""

from __future__ import annotations

import importlib
import typing

from numpy.typing import ArrayLike

from ._analysis import Analysis
from ._frame_analyzer import FrameAnalyzer
from ._frame_result import FrameResult
from ._snapshots import atoms_at, selection_of, snapshot_of

try:
    _base: typing.Any = importlib.import_module("MDAnalysis.analysis.base")
except ImportError as e:
    raise ImportError("annulus.mdanalysis needs MDAnalysis, which cannot be imported") from e

__all__ = ["Voronoi"]


class Voronoi(_base.AnalysisBase):  # type: ignore[misc]
    """What `annulus.analyze` computes, as an `MDAnalysis.analysis.base.AnalysisBase`.

    Parameters
    ----------
    atomgroup : AtomGroup or Universe
        Its cells divide the box, or all of it if the group is a part of a system.
    what, box, clip, min_area, threads
        As for `annulus.analyze`.
    **arguments
        Those of AnalysisBase, such as ``verbose``.

    Attributes
    ----------
    results : MDAnalysis.analysis.base.Results
        After `run`: the arrays of `annulus.Analysis` that `what` names (``volumes``, ``neighbors``, ..), ``boxes``,
        and ``analysis``, the `annulus.Analysis` itself, with `to_pandas`, `to_hdf5` and `to_parquet`.

    Raises
    ------
    Error
        As `annulus.analyze`; that of a frame by `run`.

    Notes
    -----
    ``run(start, stop, step)`` chooses frames, and ``run(frames=..)`` any list of them. Everything is kept in memory;
    `annulus.analyze` with ``stream=True`` keeps nothing.
    """

    def __init__(self, atomgroup: typing.Any, what: typing.Any = ("volumes", "neighbors", "events"), *,
                 box: ArrayLike | str | None = None, clip: ArrayLike | None = None, min_area: float = 0.0,
                 threads: int = 1, **arguments: typing.Any) -> None:
        super().__init__(atomgroup.universe.trajectory, **arguments)
        self._atoms = atomgroup.atoms
        self._box = selection_of(None, None, None, box).box
        self._arguments = (what, min_area, clip, threads)
        FrameAnalyzer(*self._arguments)  # refuses wrong ones

    def _prepare(self) -> None:
        self._analyzer = FrameAnalyzer(*self._arguments)
        for name in ("analysis", "boxes", *self._analyzer.what):  # of an earlier run
            self.results.pop(name, None)
        self._frames: list[FrameResult] = []

    def _single_frame(self) -> None:
        snapshot = snapshot_of(int(self._ts.frame), atoms_at(self._atoms, self._ts), self._box)
        self._frames.append(self._analyzer(snapshot))

    def _conclude(self) -> None:
        self.results.analysis = analysis = Analysis(self._analyzer.what, self._frames)
        if len(analysis):
            self.results.boxes = analysis.boxes
            for name in analysis.what:
                self.results[name] = getattr(analysis, name)
