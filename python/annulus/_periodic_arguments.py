# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arguments of a `PeriodicDelaunay`."""

from __future__ import annotations

import typing
import warnings

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments
from ._error import NotAvailableError, OpenBoundariesWarning


def plain(points: ArrayLike, name: str = "points") -> np.ndarray[typing.Any, typing.Any]:
    """Positions as an array. Whatever box their object has, the one that is given counts, but its flags do not agree
    with that if one is not set."""
    if type(points) is np.ndarray:
        return points
    flags = None if isinstance(points, (list, tuple)) else _arguments.periodic_directions(points)
    if flags is not None and not all(flags):
        raise NotAvailableError(f"{name} is an object with {list(map(int, flags))} as flags of its periodic "
                                "directions, but with box= all are periodic: give its array of positions if they shall "
                                "be")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OpenBoundariesWarning)
        return _arguments.array_of(points, name)


def refuse_clip(clip: object) -> None:
    """`MovingDelaunay` has this argument, so it may be None here, too."""
    if clip is not None:
        raise NotAvailableError("clip is not available with a periodic box: every cell is bounded without one, and "
                                "what it left would not be periodic")
