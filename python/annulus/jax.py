# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi volumes as a function of JAX. Importing this module needs JAX; `annulus` itself does not.

    import annulus.jax
    volumes = annulus.jax.voronoi_volumes(x, dt)
"""

from __future__ import annotations

import functools
import importlib
import threading
import typing

import numpy as np

from ._batch import MovingDelaunayBatch
from ._moving_delaunay import MovingDelaunay

try:
    jax: typing.Any = importlib.import_module("jax")
except ImportError as e:
    raise ImportError("annulus.jax needs JAX (the package jax), which cannot be imported") from e

__all__ = ["voronoi_volumes"]

# JAX may make callbacks from several threads, and a move and what is read after it belong together.
_LOCK = threading.Lock()


def _moved(dt: MovingDelaunay | MovingDelaunayBatch, x: typing.Any) -> None:
    x = np.asarray(x)
    if not np.array_equal(dt.points, x):
        dt.move(x)


def _volumes(dt: MovingDelaunay | MovingDelaunayBatch, x: typing.Any) -> typing.Any:
    with _LOCK:
        _moved(dt, x)
        return dt.voronoi_volumes(dtype=x.dtype)


def _gradient(dt: MovingDelaunay | MovingDelaunayBatch, x: typing.Any, g: typing.Any) -> typing.Any:
    with _LOCK:
        _moved(dt, x)
        return dt.voronoi_vjp(np.asarray(g), dtype=x.dtype)


def _forward(x: typing.Any, dt: MovingDelaunay | MovingDelaunayBatch) -> tuple[typing.Any, typing.Any]:
    return voronoi_volumes(x, dt), x


def _backward(dt: MovingDelaunay | MovingDelaunayBatch, x: typing.Any, g: typing.Any) -> tuple[typing.Any]:
    return (jax.pure_callback(functools.partial(_gradient, dt), jax.ShapeDtypeStruct(x.shape, x.dtype), x, g),)


@functools.partial(jax.custom_vjp, nondiff_argnums=(1,))
def voronoi_volumes(x: typing.Any, dt: MovingDelaunay | MovingDelaunayBatch) -> typing.Any:
    """The areas (2D) or volumes (3D) of the Voronoi cells of the points `x`, to which `dt` is moved.

    Parameters
    ----------
    x : jax.Array, shape (npoints, d), or (B, n, d) for a batch
        float64 or float32, on any device: it is copied to the CPU.
    dt : MovingDelaunay or MovingDelaunayBatch
        It moves, when and as often as JAX makes the calls. Results depend on `x` alone, up to rounding, so that
        derivatives may be computed after other moves; between calls `dt` may be used otherwise, but not by another
        thread. What `jax.jit` compiles keeps it.

    Returns
    -------
    jax.Array, shape (npoints,) or (B, n)
        Of the type of `x`. Infinite for unbounded cells, which have no derivative: their gradient counts as 0. There
        are no second derivatives and none in forward mode. Not for `jax.vmap`: use a batch.

    Raises
    ------
    Error
        As the method `move` of `dt`, from a callback: JAX makes an exception of its own of it.
    """
    return jax.pure_callback(functools.partial(_volumes, dt), jax.ShapeDtypeStruct(x.shape[:-1], x.dtype), x)


voronoi_volumes.defvjp(_forward, _backward)
