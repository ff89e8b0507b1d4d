# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact signs of determinants of points, over arrays, and how firmly each sign holds.

`orient_2d`, `orient_3d`, `in_circle` and `in_sphere` take arrays of rows of points and return a structured array with a
field for each of the following. Lengths are in the unit of the points.

* ``sign``: -1, 0 or 1, exact. Nothing is perturbed: it is 0 where the determinant is exactly 0.
* ``tolerance``: a certified lower bound. While every point of the row is less than this from where it is, the sign
  stays. 0 if the sign is 0.
* ``width_lower``, ``width_upper``: the ends of an enclosure of the width of the standard annulus, or for orientations
  of the narrowest slab that holds the points; at most a thousandth apart, relatively. 0 if the sign is 0.
* ``theta``: the angle of numerical stability in radians, 0 to pi/2; NaN for orientations.
* ``stage``: the stage that decided the sign, an index into `STAGES`.

Coordinates may be any numbers of magnitude at most 2**500. Swapping two points of a row negates its sign. A row takes
0.1 to 1.5 microseconds, and up to some ten where its sign needs integers. The GIL is released.
"""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

STAGES = ("filter", "interval", "exact")

__all__ = ["STAGES", "in_circle", "in_sphere", "orient_2d", "orient_3d"]


def orient_2d(points: ArrayLike) -> NDArray[np.void]:
    """Whether three points turn left (1) or right (-1).

    Parameters
    ----------
    points : array_like, shape (..., 3, 2)

    Returns
    -------
    structured ndarray, shape (...)
        The tolerance is half the least altitude of the triangle, rounded down.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain`` and ``environment``. `vertices` has the row,
        counted through all leading dimensions.

    Examples
    --------
    >>> from annulus import predicates
    >>> predicates.orient_2d([[[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 1], [2, 2]]])["sign"].tolist()
    [1, 0]
    """
    return typing.cast("NDArray[np.void]", _core.orient_2d(points))


def orient_3d(points: ArrayLike) -> NDArray[np.void]:
    """Whether the first three of four points turn left (1) or right (-1) as seen from the last.

    It is the sign of the determinant of the differences of the last three to the first.

    Parameters
    ----------
    points : array_like, shape (..., 4, 3)

    Returns
    -------
    structured ndarray, shape (...)
        The tolerance is half the width of the tetrahedron, rounded down.

    Raises
    ------
    Error
        As for `orient_2d`.
    """
    return typing.cast("NDArray[np.void]", _core.orient_3d(points))


def in_circle(points: ArrayLike) -> NDArray[np.void]:
    """Whether the last of four points is strictly inside (1) or outside (-1) the circle of the others.

    The signs are those for points that turn left; the opposite ones if the first three turn right. 0 if all four are on
    one circle or on one line.

    Parameters
    ----------
    points : array_like, shape (..., 4, 2)

    Returns
    -------
    structured ndarray, shape (...)
        Tolerance, width and theta are those of a bi-cell of the Delaunay triangulation of the four points.

    Raises
    ------
    Error
        As for `orient_2d`.

    Examples
    --------
    >>> from annulus import predicates
    >>> s = predicates.in_circle([[-1, 0], [0, -0.75], [1, 0], [0, 0.75]])
    >>> int(s["sign"]), bool(0.1249 < s["tolerance"] <= 0.125), predicates.STAGES[s["stage"]]
    (1, True, 'filter')
    """
    return typing.cast("NDArray[np.void]", _core.in_circle(points))


def in_sphere(points: ArrayLike) -> NDArray[np.void]:
    """Whether the last of five points is strictly inside (1) or outside (-1) the sphere of the others.

    The signs are those for points with a positive `orient_3d`; the opposite ones if it is negative. 0 if all five are
    on one sphere or in one plane.

    Parameters
    ----------
    points : array_like, shape (..., 5, 3)

    Returns
    -------
    structured ndarray, shape (...)
        Tolerance, width and theta are those of a bi-cell of the Delaunay triangulation of the five points.

    Raises
    ------
    Error
        As for `orient_2d`.
    """
    return typing.cast("NDArray[np.void]", _core.in_sphere(points))
