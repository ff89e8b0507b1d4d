# SPDX-License-Identifier: GPL-3.0-or-later
"""`MovingDelaunay`: what users see of the compiled classes `Mesh2` and `Mesh3`."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments, _core
from ._error import Error
from ._queries import Indices, Queries


class MovingDelaunay(Queries):
    """A Delaunay triangulation that is kept right while its vertices move.

    After every call, with ``tolerance="certified"``, the simplices are a Delaunay triangulation of the points
    where they are now. That is proved in every step, by tolerances within which nothing can change and by
    exact signs where a tolerance does not tell.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Positions, in any unit of length. Boundaries are open: there are no periodic boxes, and of an object
        that carries one its positions are taken, with an `OpenBoundariesWarning`. float32 and integers are
        taken exactly; what would have to be rounded to float64 (long doubles, integers that are none) is a
        `TypeError`. There may be any number of points, also fewer than d + 1, and they may lie on a line or in
        a plane.
    strategy : str, optional
        How the triangulation is kept right: ``auto`` (the cheapest of tolerances, signs with flips, and
        rebuilding, as counts tell), ``tolerances``, ``tolerances-each``, ``in-place``, ``rebuild``, ``relocate``,
        ``relocate-flips``, ``paper`` or ``paper-hybrid``.
    tolerance : str, optional
        ``certified``, a proved lower bound; with the strategies ``paper`` and ``paper-hybrid`` also ``paper`` and
        ``floating``, which are uncertified, for comparison. ``paper`` is unsound in 3D.
    merge_duplicates : bool, optional
        Equal points become one vertex (see `vertex_of_input`). Without it they are an `Error` with the code
        ``duplicate_point``.
    threads : int, optional
        How many may work on what is parallel. Results do not depend on it.
    report_changes : bool, optional
        Whether reports list `changed_simplices` and `removed_simplices`.
    seed : int, optional
        Of the sample that ``paper-hybrid`` draws.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``duplicate_point``, ``too_large``,
        ``usage``, ``environment``.

    Notes
    -----
    **Indices.** Vertices have the index of their row in `points`; negative ones are not allowed. `remove` leaves
    an index free, `insert` takes those that are free, the one freed last first, and then new ones. At
    free indices every array of numbers by vertex (`points`, `tolerances`, `theta`, `displacements`,
    `voronoi_volumes`) is NaN, `vertex_to_simplex` is -1, the list of neighbours is empty, and no simplex names
    them. `move` takes a row for them all the same and ignores it.

    **Arrays.** `points`, `simplices`, `neighbors`, `flat_simplices`, `vertex_to_simplex`,
    `vertex_neighbor_vertices` are read-only arrays that show one moment: they stay as they are when vertices
    move, and when the triangulation is gone. They are copied once after a change, when they are asked for;
    asking again costs nothing.

    **Threads.** The GIL is released while something is computed; calls on one object from several threads
    take turns, and each is of one moment. float64 in C order is read where it is if NumPy has allocated it
    and Python has one thread; all else is copied first, so that no other thread of Python and no other
    process writes in what is being read. A signal (Ctrl-C) is seen after the call, by `audit` now and then.

    **Processes.** A child of `os.fork` may go on with its copy, with ``threads=1``; if another thread was in a
    call on the object when it was forked, using it there is a `RuntimeError`. Pickling keeps positions,
    indices and options; tolerances are fresh then, and where d + 2 points are cocircular or cospherical the
    simplices are those of a rebuild.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> points = np.random.default_rng(0).random((1000, 2))
    >>> dt = annulus.MovingDelaunay(points)
    >>> report = dt.move(points + 1e-4 * np.sin(9 * points))
    >>> report.asked, dt.audit().delaunay
    (1000, True)
    """

    _options: dict[str, typing.Any]

    def __init__(self, points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                 merge_duplicates: bool = False, threads: int = 1, *, report_changes: bool = True,
                 seed: int = 0) -> None:
        options = _arguments.options(strategy, tolerance, merge_duplicates, threads, report_changes, seed)
        array = points if type(points) is np.ndarray else _arguments.array_of(points, "points")
        shape = array.shape
        if len(shape) != 2 or shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {shape if len(shape) <= 8 else '(..)'}",
                        "wrong_size")
        mesh = (_core.Mesh2 if shape[1] == 2 else _core.Mesh3).build(array, options_of(options))
        self._options = options
        self._mesh = mesh
        self._index_of_input = mesh.vertex_of_input
        self._index_of_input.flags.writeable = False

    # ---- What changes it ---------------------------------------------------------------------

    def move(self, points: ArrayLike, indices: ArrayLike | None = None) -> _core.MoveReport:
        """Moves all vertices, or some, at once.

        Parameters
        ----------
        points : array_like, shape (npoints, d) or (k, d)
            Where they go. Rows of free indices are ignored.
        indices : array_like of int, shape (k,), optional
            Indices of the vertices to move; all of them by default. For one that is named twice the last row holds.

        Returns
        -------
        MoveReport
            What became of the vertices, what was computed, and the simplices that came and went.

        Raises
        ------
        Error
            ``duplicate_point`` where two vertices would be at one place, ``wrong_size``, ``unknown_vertex``,
            ``not_finite``, ``out_of_domain``; no vertex has moved then.
        """
        return self._mesh.move(points, indices)

    def insert(self, points: ArrayLike) -> Indices:
        """Inserts vertices, all of them or, when it raises, none.

        Parameters
        ----------
        points : array_like, shape (k, d)

        Returns
        -------
        ndarray of int32, shape (k,)
            Their indices: those that are free, the one freed last first, then new ones.

        Raises
        ------
        Error
            ``duplicate_point`` where a vertex is (`merge_duplicates` does not apply here), ``wrong_size``,
            ``not_finite``, ``out_of_domain``, ``too_large``.

        Notes
        -----
        A vertex is found near the place in O(log n), and a walk goes from there: on average 6 to 8 triangles for
        10,000 to a million random points, 9 to 12 tetrahedra for 10,000 to 200,000. Ten to twenty microseconds each in
        the plane, some forty in space. What else it costs: the first insertion after a construction copies arrays,
        O(n); while all points are in a plane or on a line each one rebuilds everything, O(n log n); where a vertex
        has k neighbours it may take O(k). More than one at once are first compared with all positions, which takes
        O(n). When memory runs out half way, those that were inserted are taken out again, and there may be more free
        indices than before.
        """
        return self._mesh.insert(points)

    def remove(self, indices: ArrayLike) -> None:
        """Removes vertices, all of them or, when it raises an `Error`, none; their indices become free.

        Parameters
        ----------
        indices : array_like of int, shape (k,)

        Raises
        ------
        Error
            ``unknown_vertex`` for an index that is no vertex', or is there twice.
        """
        self._mesh.remove(indices)

    def recompute_tolerances(self) -> _core.MoveReport:
        """Makes every tolerance fresh, to be measured from where the vertices are now. O(n)."""
        return self._mesh.recompute_tolerances()

    def __repr__(self) -> str:
        if not hasattr(self, "_mesh"):
            return f"<{type(self).__name__}: not initialised>"
        n, strategy = self._mesh.summary()
        return (f"<{type(self).__name__}: {n} {'vertex' if n == 1 else 'vertices'} in "
                f"{'the plane' if self.ndim == 2 else 'space'}, "
                f"strategy {strategy!r}, tolerance {self._options['tolerance']!r}>")

    # ---- Pickling and copying ----------------------------------------------------------------

    def __getstate__(self) -> dict[str, typing.Any]:
        more = {name: value for name, value in self.__dict__.items() if name != "_mesh"}
        points, free_indices = self._mesh.state()
        return {"format": 1, "points": points, "free_indices": free, "more": more}

    def __setstate__(self, state: dict[str, typing.Any]) -> None:
        if not isinstance(state, dict) or not {"format", "points", "free_indices", "more"} <= state.keys():
            raise Error(f"state must be that of a pickled MovingDelaunay, not {_arguments.described(state)}",
                        "bad_input")
        if state["format"] != 1:
            raise Error("state was pickled by another version of annulus: format "
                        f"{_arguments.described(state['format'])}", "bad_input")
        points, more = state["points"], state["more"]
        kind = _core.Mesh2 if points.shape[1] == 2 else _core.Mesh3
        self._mesh = kind.build_again(points, state["free_indices"], options_of(more["_options"]))
        self.__dict__.update(more)
        self._index_of_input.flags.writeable = False


def options_of(o: dict[str, typing.Any]) -> _core.Options:
    """What the compiled module takes, of options that `_arguments.options` has looked at."""
    return _core.options(o["strategy"], o["tolerance"], o["threads"], o["merge_duplicates"], o["report_changes"],
                         o["seed"])
