# SPDX-License-Identifier: GPL-3.0-or-later
"""`MovingDelaunay`, the public class over the compiled classes `Mesh2` and `Mesh3`."""

from __future__ import annotations

import inspect
import typing

from numpy.typing import ArrayLike

from . import _arguments, _core
from ._construction import Construction, options_of
from ._error import Error, NotAvailableError
from ._no_array import NoArray
from ._periodic import PeriodicDelaunay, made_with_box
from ._plot import Plots
from ._queries import Indices

Self = typing.TypeVar("Self", bound="MovingDelaunay")


class MovingDelaunay(Construction, Plots, NoArray):
    """A Delaunay triangulation that is kept right while its vertices move.

    With ``tolerance="certified"``, the simplices are a Delaunay triangulation of the points at their current
    positions after every call. Every step proves this: by tolerances, within which nothing can change, and by
    exact signs where a tolerance is exceeded.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Positions, in any unit of length. Boundaries are open unless `box` is given: if an object has a periodic box,
        its positions alone are taken, with an `OpenBoundariesWarning`. float32 and integers are converted exactly;
        values that would have to be rounded to float64 (long doubles, integers that are no float64) raise a
        `TypeError`. Any number of points is allowed, also fewer than d + 1, and they may lie on a line or in a
        plane.
    box : array_like, shape (d,) or (d, d), optional
        The lengths, or the vectors as rows, of a periodic box. The object is then a `PeriodicDelaunay`, whose
        docstring says what it has.
    strategy : str, optional
        How the triangulation is kept right: ``auto`` (in each step the cheapest of tolerances, signs with flips,
        and rebuilding, as estimated from counts), ``tolerances``, ``tolerances-each``, ``in-place``, ``rebuild``,
        ``relocate``, ``relocate-flips``, ``paper`` or ``paper-hybrid``. With `box`: ``auto``, ``signs``,
        ``tolerances``, or ``rebuild``, which is ``auto`` there.
    tolerance : str, optional
        ``certified``, a proved lower bound; with the strategies ``paper`` and ``paper-hybrid`` also ``paper`` and
        ``floating``, which are uncertified and meant for comparison. ``paper`` is unsound in 3D.
    merge_duplicates : bool, optional
        Merge duplicate points into one vertex (see `vertex_of_input`). By default they raise an `Error` with the
        code ``duplicate_point``. With `box` images of one another are duplicates, too, if they are so after
        rounding; coordinates of an image that were computed in doubles may be rounded to another place.
    threads : int, optional
        Number of threads for the parallel parts, 1 or more. Results do not depend on it.
    report_changes : bool, optional
        Whether results of `move` list `changed_simplices` and `removed_simplices` (the default; in C++ and C it is
        not). A step in which no simplex changes costs the same without lists, but where most change, to sort them
        may take longer than the step.
    seed : int, optional
        Seed of the sample that ``paper-hybrid`` draws.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``duplicate_point``, ``too_large``,
        ``usage``, ``environment``.

    Notes
    -----
    **Indices.** The index of a vertex is its row in `points`; negative indices are not allowed. `remove` makes
    indices free; `insert` takes the free indices, the one freed last first, and then new ones. At free indices
    every array of numbers by vertex (`points`, `tolerances`, `theta`, `displacements`, `voronoi_volumes`) is NaN,
    `vertex_to_simplex` is -1, the list of neighbours is empty, and no simplex contains them. `move` needs a row
    for them nevertheless, and ignores it.

    **Arrays.** `points`, `simplices`, `neighbors`, `flat_simplices`, `vertex_to_simplex` and
    `vertex_neighbor_vertices` are read-only snapshots: they do not change when vertices move, and remain valid
    when the triangulation is deleted. The first access after a change copies them; further accesses cost nothing.

    **Outputs.** Methods that return one array of float64 by point or position, `voronoi_volumes`, `voronoi_vjp` and
    `interpolate`, take two more arguments. ``dtype`` may be float64 or float32: everything is computed in float64, and
    each number is then rounded to float32, the nearest and the even one of two, infinite if it is too large. ``out`` is
    an array of either dtype that they fill and return. It must have the shape of the result, be in C order and
    writable, and not overlap an argument; otherwise a `TypeError` or an `Error` with the code ``wrong_size`` or
    ``usage`` is raised. After an exception it is as it was. Attributes are snapshots, and have no arguments:
    ``numpy.copyto(x, dt.points, "same_kind")`` rounds in the same way.

    **Threads.** The GIL is released during computations. Calls on one object from several threads are
    serialised, and the result of each is that of one moment. float64 arrays in C order are read in place if NumPy
    has allocated them and Python has one thread; all others are copied first, so that no other thread of Python
    and no other process can write to an array while it is read. A signal (Ctrl-C) is handled after the call, in
    `audit` also during it.

    **Processes.** A child of `os.fork` may use its copy, with ``threads=1``. If another thread was in a call on
    the object at the time of the fork, using it in the child raises a `RuntimeError`. Pickling keeps positions,
    indices and options. After unpickling, tolerances are computed again, and where d + 2 points are cocircular or
    cospherical the simplices are those of a rebuild.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> points = np.random.default_rng(0).random((1000, 2))
    >>> dt = annulus.MovingDelaunay(points)
    >>> report = dt.move(points + 1e-4 * np.sin(9 * points))
    >>> report.asked, dt.audit().delaunay
    (1000, True)
    """

    # For type checkers, which see the class that `box` makes. They prefer `__new__` to the `__init__` of a base.
    @typing.overload
    def __new__(cls: type[Self], points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                merge_duplicates: bool = False, threads: int = 1, *, report_changes: bool = True,
                seed: int = 0, box: None = None) -> Self: ...

    @typing.overload
    def __new__(cls, points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                merge_duplicates: bool = False, threads: int = 1, *, report_changes: bool = False,
                seed: int = 0, box: ArrayLike) -> InBox: ...

    def __new__(cls, *arguments: typing.Any, **named: typing.Any) -> typing.Any:
        if named.get("box") is None:
            return super().__new__(cls)
        if cls is not MovingDelaunay:
            raise NotAvailableError(f"box is not available in {cls.__name__}: classes derived from MovingDelaunay have "
                                    "open boundaries")
        return made_with_box(*arguments, **named)

    # ---- Changes -----------------------------------------------------------------------------

    def move(self, points: ArrayLike, indices: ArrayLike | None = None) -> _core.MoveResult:
        """Moves all or some vertices at the same time.

        Parameters
        ----------
        points : array_like, shape (npoints, d) or (k, d)
            The new positions. Rows of free indices are ignored.
        indices : array_like of int, shape (k,), optional
            Indices of the vertices to move; all of them by default. If an index occurs twice, its last row counts.
            They are the second argument because they may be left out; in C++ and C indices come before points.

        Returns
        -------
        MoveResult
            What became of the vertices, and the simplices that were created and removed; its `statistics` say what
            the call cost.

        Raises
        ------
        Error
            With the codes ``duplicate_point`` if two vertices would be at one position, ``wrong_size``,
            ``unknown_vertex``, ``not_finite``, ``out_of_domain``; no vertex has moved then.
        """
        return self._mesh.move(points, indices)

    def insert(self, points: ArrayLike) -> Indices:
        """Inserts vertices: all of them or, if it raises an exception, none.

        Parameters
        ----------
        points : array_like, shape (k, d)

        Returns
        -------
        ndarray of int32, shape (k,)
            Their indices: first free ones, the one freed last first, then new ones.

        Raises
        ------
        Error
            With the codes ``duplicate_point`` if a vertex is at this position already (`merge_duplicates` does not
            apply here), ``wrong_size``, ``not_finite``, ``out_of_domain``, ``too_large``.

        Notes
        -----
        An insertion finds a vertex near the point in O(log n) and walks from there: on average through 6 to 8
        triangles for 10,000 to a million random points, or 9 to 12 tetrahedra for 10,000 to 200,000. One insertion
        takes ten to twenty microseconds in 2D, about forty in 3D. Additional costs: the first insertion after a
        construction copies arrays, O(n); while all points are in a plane or on a line, each insertion compares the
        point with all others, O(n); at a vertex with k neighbours it may take O(k). If more than one point is inserted,
        they are first compared with all positions, O(n). If memory runs out half way, the vertices inserted so far are
        removed again, and there may be more free indices than before.
        """
        return self._mesh.insert(points)

    def remove(self, indices: ArrayLike) -> None:
        """Removes vertices: all of them or, if it raises an `Error`, none. Their indices become free.

        Parameters
        ----------
        indices : array_like of int, shape (k,)

        Raises
        ------
        Error
            With the code ``unknown_vertex`` for an index that is not that of a vertex, or that occurs twice.
        """
        self._mesh.remove(indices)

    def recompute_tolerances(self) -> _core.MoveResult:
        """Computes every tolerance again, measured from the current positions of the vertices. O(n)."""
        return self._mesh.recompute_tolerances()

    def __repr__(self) -> str:
        if not hasattr(self, "_mesh"):
            return f"<{type(self).__name__}: not initialised>"
        n, strategy = self._mesh.summary()
        return (f"<{type(self).__name__}: {n} {'vertex' if n == 1 else 'vertices'} in {self.ndim}D, "
                f"strategy {strategy!r}, tolerance {self._options['tolerance']!r}>")

    # ---- Pickling and copying ----------------------------------------------------------------

    def __getstate__(self) -> dict[str, typing.Any]:
        more = {name: value for name, value in self.__dict__.items() if name != "_mesh"}
        points, free_indices = self._mesh.state()
        return {"format": 1, "points": points, "free_indices": free_indices, "more": more}

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
        self._vertex_of_input.flags.writeable = False


if typing.TYPE_CHECKING:
    class InBox(PeriodicDelaunay, MovingDelaunay):  # type: ignore[misc]
        """What type checkers take `MovingDelaunay` with a box for: a `PeriodicDelaunay`, which it is. That it is a
        `MovingDelaunay`, too, is not so, but mypy ignores a `__new__` that makes something else than its class."""


# What `help` shows, and not what `__new__` passes on.
setattr(MovingDelaunay, "__signature__", inspect.signature(MovingDelaunay.__init__).replace(
    parameters=list(inspect.signature(MovingDelaunay.__init__).parameters.values())[1:],
    return_annotation=inspect.Signature.empty))


def of_mesh(mesh: _core.Mesh2 | _core.Mesh3, options: dict[str, typing.Any]) -> MovingDelaunay:
    """The public object over a mesh that was built with these options, as `_arguments.options` returns them."""
    dt = object.__new__(MovingDelaunay)
    dt._options, dt._mesh, dt._vertex_of_input = options, mesh, mesh.vertex_of_input
    dt._vertex_of_input.flags.writeable = False
    return dt
