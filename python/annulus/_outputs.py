# SPDX-License-Identifier: GPL-3.0-or-later
"""The arguments `out` and `dtype` of methods that return numbers; `MovingDelaunay` says what they do."""

from __future__ import annotations

import typing
from collections.abc import Callable

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _arguments
from ._error import Error

_KINDS = (np.dtype(np.float64), np.dtype(np.float32))


def _kind_of(dtype: DTypeLike | None, out: object) -> np.dtype[typing.Any]:
    """The dtype of a result."""
    if dtype is None:
        return np.dtype(out.dtype) if isinstance(out, np.ndarray) else _KINDS[0]
    try:
        kind = np.dtype(dtype)
    except (TypeError, ValueError):  # ValueError: text that is no UTF-8
        kind = np.dtype(np.void)
    if kind not in _KINDS:
        raise TypeError(f"dtype must be float64 or float32, not {_arguments.described(dtype)}")
    if isinstance(out, np.ndarray) and out.dtype != kind:
        raise TypeError(f"dtype is {kind}, but out is {_arguments.described(out)}: leave dtype out, or make them agree")
    return kind


def _require(out: object, shape: tuple[int, ...], inputs: tuple[object, ...]) -> None:
    if not isinstance(out, np.ndarray) or isinstance(out, np.ma.MaskedArray):
        raise TypeError(f"out must be a NumPy array, not {_arguments.described(out)}")
    if out.dtype not in _KINDS:
        raise TypeError(f"out must be an array of float64 or float32, not {_arguments.described(out)}")
    if out.shape != shape:
        raise Error(f"out must have shape {shape}, not {out.shape}", "wrong_size")
    if not out.flags.c_contiguous or not out.flags.aligned:
        raise Error("out must be in C order, without gaps, and aligned", "usage")
    if not out.flags.writeable:
        raise Error("out must be writable, and this array is read-only", "usage")
    if any(isinstance(value, np.ndarray) and np.may_share_memory(out, value) for value in inputs):
        raise Error("out must not overlap an argument", "usage")


def returned(compute: Callable[[], NDArray[np.float64]], shape_of: Callable[[], tuple[int, ...]],
             out: NDArray[typing.Any] | None, dtype: DTypeLike | None, *inputs: object) -> NDArray[typing.Any]:
    """What `compute` returns, as `out` and `dtype` have it. `inputs` are the arguments of the method. `out` is checked
    first, for the shape of the result, which is only then looked up, and written to last."""
    if out is None and dtype is None:
        return compute()
    kind = _kind_of(dtype, out)
    shape = () if out is None else shape_of()
    if out is not None:
        _require(out, shape, inputs)
    values = compute()
    with np.errstate(all="ignore"):  # what float32 cannot hold becomes infinite or 0
        if out is None:
            return values.astype(kind, copy=False)
        if values.shape != shape:
            raise Error(f"out has shape {shape}, and another thread has changed what is needed to {values.shape}",
                        "wrong_size")
        out[...] = values
    return out
