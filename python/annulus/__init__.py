# SPDX-License-Identifier: GPL-3.0-or-later
"""Delaunay triangulations of moving points, certified after every move.

`MovingDelaunay` keeps the triangulation of points in 2D or 3D right while they move, and proves it. Names are
those of `scipy.spatial.Delaunay` where SciPy has one. `audit` checks a triangulation made by any program, and
`predicates` has exact signs of points. `analyze` takes whole trajectories. `degeneracy`, `counterexample`, `lloyd` and
`nodt` are the subcommands of the tool as functions. The C++ library of the same name does all computations.
"""

from . import _core

if not _core.in_main_interpreter():  # the main one has imported it before, and Python passes its module on
    raise ImportError("annulus works in the main interpreter only, and this is a subinterpreter")

from . import predicates
from ._analysis import Analysis, AnalysisStream
from ._analyze import analyze
from ._batch import MovingDelaunayBatch
from ._core import MoveResult, MoveStatistics
from ._core import version as __version__
from ._error import BatchError, Error, NotAvailableError, OpenBoundariesWarning, TableWarning
from ._frame_result import FrameResult
from ._functions import LloydResult, NodtResult, audit, counterexample, degeneracy, lloyd, nodt
from ._moving_delaunay import MovingDelaunay
from ._periodic import PeriodicDelaunay
from ._periodic_polytopes import PeriodicPolytopes
from ._periodic_voronoi import PeriodicVoronoi
from ._polytopes import VoronoiPolytopes
from ._queries import AuditResult, Fault
from ._voronoi import Voronoi, t1

__all__ = ["Analysis", "AnalysisStream", "AuditResult", "BatchError", "Error", "Fault", "FrameResult", "LloydResult",
           "MoveResult", "MoveStatistics", "MovingDelaunay", "MovingDelaunayBatch", "NodtResult", "NotAvailableError",
           "OpenBoundariesWarning", "PeriodicDelaunay", "PeriodicPolytopes", "PeriodicVoronoi", "TableWarning",
           "Voronoi", "VoronoiPolytopes", "__version__", "analyze", "audit", "counterexample", "degeneracy", "lloyd",
           "nodt", "predicates", "t1"]

MoveResult.__module__ = MoveStatistics.__module__ = "annulus"
