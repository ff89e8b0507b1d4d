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


def choice_in_box(name: str, value: object, choices: tuple[str, ...], elsewhere: tuple[str, ...]) -> str:
    """One of the strings that there are in a box. Others, which there are without one, are not available."""
    if isinstance(value, str) and value in elsewhere and value not in choices:
        raise NotAvailableError(f"{name}={value!r} is not available with a periodic box: {name} must be "
                                f"{_arguments.one_of(choices)}")
    return _arguments.choice(name, value, choices)


def refuse_clip(clip: object) -> None:
    """`MovingDelaunay` has this argument, so it may be None here, too."""
    if clip is not None:
        raise NotAvailableError("clip is not available with a periodic box: every cell is bounded without one, and "
                                "what it left would not be periodic")
