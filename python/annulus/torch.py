# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi volumes as a function of PyTorch. Importing this module needs PyTorch; `annulus` itself does not.

    import annulus.torch
    volumes = annulus.torch.voronoi_volumes(x, dt)
"""

from __future__ import annotations

import importlib
import typing

from ._batch import MovingDelaunayBatch
from ._moving_delaunay import MovingDelaunay

try:
    torch: typing.Any = importlib.import_module("torch")
except ImportError as e:
    raise ImportError("annulus.torch needs PyTorch (the package torch), which cannot be imported") from e

__all__ = ["voronoi_volumes"]


def _snapshots(dt: MovingDelaunay | MovingDelaunayBatch) -> list[typing.Any]:
    """The arrays of positions, of which there are others after a change."""
    return [entry.points for entry in dt] if isinstance(dt, MovingDelaunayBatch) else [dt.points]


class _Volumes(torch.autograd.Function):  # type: ignore[misc]
    @staticmethod
    def forward(context: typing.Any, x: typing.Any, dt: MovingDelaunay | MovingDelaunayBatch) -> typing.Any:
        dt.move(x.detach().cpu().numpy())
        context.dt, context.points = dt, _snapshots(dt)
        return torch.from_numpy(dt.voronoi_volumes()).to(x)

    @staticmethod
    def backward(context: typing.Any, g: typing.Any) -> tuple[typing.Any, None]:
        dt = context.dt
        if any(a.ctypes.data != b.ctypes.data for a, b in zip(_snapshots(dt), context.points)):
            raise RuntimeError("dt has changed since voronoi_volumes: call backward before the next change")
        return torch.from_numpy(dt.voronoi_vjp(g.detach().cpu().numpy())).to(g), None


def voronoi_volumes(x: typing.Any, dt: MovingDelaunay | MovingDelaunayBatch) -> typing.Any:
    """Moves `dt` to the points `x`, and returns the areas (2D) or volumes (3D) of its Voronoi cells.

    Parameters
    ----------
    x : torch.Tensor, shape (npoints, d), or (B, n, d) for a batch
        float64 or float32, on any device: it is copied to the CPU.
    dt : MovingDelaunay or MovingDelaunayBatch
        It moves. `backward` must come before its next change, otherwise it raises a `RuntimeError`.

    Returns
    -------
    torch.Tensor, shape (npoints,) or (B, n)
        Of the type and device of `x`. Infinite for unbounded cells, which have no derivative: leave them out of sums
        (``volumes[torch.isfinite(volumes)]``). There are no second derivatives.

    Raises
    ------
    Error
        As `MovingDelaunay.move`.
    """
    return _Volumes.apply(x, dt)
