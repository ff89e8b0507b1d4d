# SPDX-License-Identifier: GPL-3.0-or-later
"""Domains and densities of `lloyd`."""

from __future__ import annotations

import typing
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments
from ._error import Error

PIXELS = 1024  # along the longer side of a domain, of a density that is a function


def _reals(value: object, name: str) -> NDArray[np.float64]:
    array = _arguments.array_of(value, name)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name} must be an array of numbers, not {_arguments.described(value)}")
    reals: NDArray[np.float64] = array.astype(np.float64)
    return reals


def rings_of(domain: str | ArrayLike | Sequence[ArrayLike] | None) -> tuple[str | ArrayLike | None, list[int]]:
    """The domain, with the corners of all its rings in one array, and the first corner of each ring."""
    if isinstance(domain, str):
        return _arguments.choice("domain", domain, _arguments.DOMAINS), [0]
    if not isinstance(domain, (list, tuple)) or not domain or not isinstance(domain[0], (list, tuple, np.ndarray)):
        return typing.cast(ArrayLike, domain), [0]
    if not len(domain[0]) or np.ndim(domain[0][0]) == 0:  # a corner, not a ring of them
        return typing.cast(ArrayLike, domain), [0]
    rings = [_reals(ring, "domain") for ring in domain]
    for k, ring in enumerate(rings):
        if ring.ndim != 2 or ring.shape[1] != 2:
            raise Error(f"ring {k} of domain must have shape (m, 2), not {ring.shape}", "wrong_size")
    return np.concatenate(rings), [0, *np.cumsum([len(ring) for ring in rings[:-1]]).tolist()]


def _box(domain: str | ArrayLike | None, points: ArrayLike | None,
         radius: float | None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The lower and the upper corner of the bounding box of the domain, a polygon."""
    if isinstance(domain, str) and domain == "square":
        half = 1.0 if radius is None else radius
        return np.full(2, -half), np.full(2, half)
    corners = _reals(points, "points") if domain is None else _reals(domain, "domain")
    if corners.ndim != 2 or corners.shape[1] != 2 or not len(corners):
        raise Error("domain must have shape (m, 2), not " + str(corners.shape), "wrong_size")
    return corners.min(axis=0), corners.max(axis=0)


def _pixels(function: Callable[[NDArray[np.float64]], ArrayLike], lower: NDArray[np.float64],
            upper: NDArray[np.float64]) -> NDArray[np.float64]:
    """The values of a function in the middles of pixels, the first row on top."""
    extent = upper - lower
    if not (extent > 0).all():  # refused later, as a domain
        return np.ones((1, 1))
    columns, rows = (max(1, round(PIXELS * float(e / extent.max()))) for e in extent)
    x = lower[0] + (np.arange(columns) + 0.5) / columns * extent[0]
    y = upper[1] - (np.arange(rows) + 0.5) / rows * extent[1]
    at = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    values = _reals(function(at), "the result of density")
    if values.shape != (len(at),):
        raise Error(f"density must return as many values as it gets positions, ({len(at)},), not {values.shape}",
                    "wrong_size")
    return values.reshape(rows, columns)


def density_of(density: str | ArrayLike | Callable[[NDArray[np.float64]], ArrayLike], domain: str | ArrayLike | None,
               points: ArrayLike | None, radius: float | None) -> str | NDArray[np.uint32]:
    """The name of a density, or the weights of pixels: whole numbers below 2**24 in proportion to its values. `domain`
    is as `rings_of` returns it; `points` are those whose convex hull is the domain if there is no other."""
    if isinstance(density, str):
        return _arguments.choice("density", density, _arguments.DENSITIES)
    values = np.ones((1, 1)) if callable(density) else _reals(density, "density")
    if domain is None and points is None or isinstance(domain, str) and domain == "disc":
        raise Error("a density that is an array or a function needs a polygon as domain, not a disc", "usage")
    if callable(density):
        values = _pixels(density, *_box(domain, points, radius))
    if values.ndim != 2 or 0 in values.shape:
        raise Error(f"density must have shape (rows, columns), not {values.shape}", "wrong_size")
    if not np.isfinite(values).all():
        raise Error("density has values that are not finite", "not_finite")
    most = float(values.max())
    if float(values.min()) < 0 or most == 0:
        raise Error("density must be at least 0 everywhere, and above 0 somewhere", "bad_input")
    exponent = int(np.frexp(most)[1])
    weights: NDArray[np.uint32] = np.minimum(np.rint(np.ldexp(values, 24 - exponent)), 2**24 - 1).astype(np.uint32)
    return weights
