# SPDX-License-Identifier: GPL-3.0-or-later
"""Why a triangulation is no array."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import NDArray


class NoArray:
    """A triangulation, which is refused where NumPy makes an array of it.

    NumPy makes an array without dimensions of any other object, and what takes arrays then fails far from the mistake.
    SciPy's `LinearNDInterpolator(dt, values)`, which takes a `scipy.spatial.Delaunay`, would raise an `IndexError`.
    Arrays of objects (``dtype=object``) hold triangulations as they hold anything.
    """

    def __array__(self, dtype: typing.Any = None, copy: bool | None = None) -> NDArray[typing.Any]:
        if dtype is not None and np.dtype(dtype) == object:
            holder = np.empty((), dtype=object)
            holder[()] = self
            return holder
        raise TypeError(f"{type(self).__name__} is neither an array nor a scipy.spatial.Delaunay: dt.points are the "
                        "positions of its vertices, dt.simplices its simplices, dt.interpolate(values, x) interpolates "
                        "between them")
