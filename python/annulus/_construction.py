# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of `MovingDelaunay` that constructs one with open boundaries."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments, _core
from ._error import Error
from ._neighbors import VoronoiQueries


class Construction(VoronoiQueries):
    """Construction from points and options."""

    _options: dict[str, typing.Any]

    def __init__(self, points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                 merge_duplicates: bool = False, threads: int = 1, *, report_changes: bool = True,
                 seed: int = 0, box: ArrayLike | None = None) -> None:
        options = _arguments.options(strategy, tolerance, merge_duplicates, threads, report_changes, seed)
        array = points if type(points) is np.ndarray else _arguments.array_of(points, "points")
        shape = array.shape
        if len(shape) != 2 or shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {shape if len(shape) <= 8 else '(..)'}",
                        "wrong_size")
        mesh = (_core.Mesh2 if shape[1] == 2 else _core.Mesh3).build(array, options_of(options))
        self._options = options
        self._mesh = mesh
        self._vertex_of_input = mesh.vertex_of_input
        self._vertex_of_input.flags.writeable = False


def options_of(o: dict[str, typing.Any]) -> _core.Options:
    """The options for the compiled module, from those that `_arguments.options` has checked."""
    return _core.options(o["strategy"], o["tolerance"], o["threads"], o["merge_duplicates"], o["report_changes"],
                         o["seed"])
