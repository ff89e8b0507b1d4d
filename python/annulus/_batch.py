# SPDX-License-Identifier: GPL-3.0-or-later
"""`MovingDelaunayBatch`: independent triangulations that move together."""

from __future__ import annotations

import typing
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments, _core, _outputs
from ._construction import options_of
from ._error import Error
from ._moving_delaunay import MovingDelaunay, of_mesh
from ._queries import Floats


class MovingDelaunayBatch:
    """B triangulations of n points each, which are independent of one another and move in one call.

    Every method computes the entries with several threads, after one release of the GIL. What an entry is and what it
    returns are bit for bit those of a `MovingDelaunay` of its own that makes the same calls, for any number of threads.

    Parameters
    ----------
    points : array_like, shape (B, n, 2) or (B, n, 3)
        Positions, as for `MovingDelaunay`. B and n may be 0.
    strategy, tolerance, seed : optional
        As for `MovingDelaunay`, the same for all entries.
    threads : int, optional
        How many entries are computed at the same time, at most as many as the machine runs at once. Each entry is
        computed by one thread.
    report_changes : bool, optional
        Whether results of `move` list simplices. By default they do not, unlike those of `MovingDelaunay`.

    Raises
    ------
    Error
        With the code ``wrong_size`` for points of another shape. `BatchError`, with the codes of `MovingDelaunay`, if
        an entry cannot be built; then there is no batch.

    Notes
    -----
    ``batch[b]`` is entry b, a `MovingDelaunay` that can be used by itself; ``len(batch)`` is B. It stays part of the
    batch: what moves one moves the other. If its number of points changes, the calls of the batch raise a `BatchError`
    with the code ``wrong_size``.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> x = np.random.default_rng(0).random((8, 100, 2))
    >>> batch = annulus.MovingDelaunayBatch(x, threads=2)
    >>> reports = batch.move(x + 1e-3 * np.sin(9 * x))
    >>> batch.voronoi_volumes().shape, len(batch), bool(batch[3].audit())
    ((8, 100), 8, True)
    """

    def __init__(self, points: ArrayLike, strategy: str = "auto", tolerance: str = "certified", threads: int = 1, *,
                 report_changes: bool = False, seed: int = 0) -> None:
        options = _arguments.options(strategy, tolerance, False, threads, report_changes, seed)
        array = _arguments.array_of(points, "points")
        if array.ndim != 3 or array.shape[2] not in (2, 3):
            raise Error("points must have shape (B, n, 2) or (B, n, 3), not "
                        f"{array.shape if array.ndim <= 8 else '(..)'}", "wrong_size")
        self._threads = options["threads"]
        options["threads"] = 1
        _, self._npoints, self._ndim = array.shape
        self._entries = tuple(of_mesh(mesh, options) for mesh in
                              _core.batch_build(self._ndim, array, options_of(options), self._threads))

    def move(self, points: ArrayLike) -> tuple[_core.MoveResult, ...]:
        """Moves all vertices of all entries.

        Parameters
        ----------
        points : array_like, shape (B, n, d)
            The new positions.

        Returns
        -------
        tuple of MoveResult
            One for each entry.

        Raises
        ------
        Error
            With the code ``wrong_size``; nothing has moved then.
        BatchError
            With the codes of `MovingDelaunay.move`, if some entries cannot move. `BatchError.errors` has them: they
            are as they were, and all others have moved.
        """
        return _core.batch_move(self._ndim, self._meshes(), points, self._threads)

    def voronoi_volumes(self, *, out: NDArray[typing.Any] | None = None,
                        dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The areas (2D) or volumes (3D) of the Voronoi cells: `MovingDelaunay.voronoi_volumes` of each entry.

        Parameters
        ----------
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (B, n)
            ``inf`` for unbounded cells.
        """
        return _outputs.returned(
            lambda: _core.batch_volumes(self._ndim, self._meshes(), self._npoints, self._threads).reshape(
                len(self), self._npoints), lambda: (len(self), self._npoints), out, dtype)

    def voronoi_vjp(self, g: ArrayLike, *, out: NDArray[typing.Any] | None = None,
                    dtype: DTypeLike | None = None) -> NDArray[typing.Any]:
        """The gradient of ``sum(g * volumes)``: `MovingDelaunay.voronoi_vjp` of each entry.

        Parameters
        ----------
        g : array_like, shape (B, n)
            Entries at unbounded cells count as 0.
        out, dtype : optional
            Where the numbers go, and as what: *Outputs* in `MovingDelaunay`.

        Returns
        -------
        ndarray of float64, shape (B, n, d)
        """
        shape = (len(self), self._npoints, self._ndim)
        return _outputs.returned(
            lambda: _core.batch_gradient(self._ndim, self._meshes(), self._npoints, self._threads, g).reshape(shape),
            lambda: shape, out, dtype, g)

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (B, n, d): current positions. A copy."""
        return _core.batch_points(self._ndim, self._meshes(), self._npoints, self._threads).reshape(
            len(self), self._npoints, self._ndim)

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return self._ndim

    @property
    def npoints(self) -> int:
        """int: n, the number of points of each entry."""
        return self._npoints

    def __len__(self) -> int:
        return len(self._entries)

    def __getitem__(self, entry: int) -> MovingDelaunay:
        if not isinstance(entry, (int, np.integer)):
            raise TypeError(f"entry must be a whole number, not {_arguments.described(entry)}")
        return self._entries[entry]

    def __iter__(self) -> Iterator[MovingDelaunay]:
        return iter(self._entries)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} of {self._npoints} points in {self._ndim}D>"

    def _meshes(self) -> tuple[_core.Mesh2 | _core.Mesh3, ...]:
        return tuple(entry._mesh for entry in self._entries)
