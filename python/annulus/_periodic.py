# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicDelaunay`, what `MovingDelaunay` is with a box."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._error import Error, NotAvailableError
from ._no_array import NoArray
from ._periodic_arguments import choice_in_box, plain
from ._periodic_changes import PeriodicChanges
from ._periodic_diagrams import PeriodicDiagrams
from ._periodic_gradients import PeriodicGradients
from ._periodic_lists import PeriodicLists
from ._periodic_queries import PeriodicQueries
from ._plot import Plots
from ._queries import AuditResult, Floats, Indices, audit_result_of

STRATEGIES = ("auto", "signs", "tolerances")
WITHOUT_MEANING = {
    "convex_hull": "a torus has no border, so there is no hull",
    "displacements": "tolerances are what is left of them, from where the points are: there are no fixed positions",
}


class PeriodicDelaunay(PeriodicChanges, PeriodicLists, PeriodicQueries, PeriodicDiagrams, PeriodicGradients, Plots,
                       NoArray):
    """The Delaunay triangulation of points in a periodic box: ``MovingDelaunay(points, box=box)`` makes one.

    It is that of the points and all their translates by the vectors of the box, as finitely many simplices with
    offsets, and exact: proved after every build for `points` and `box`, which are those given, rounded once to about
    2**-49 of the box (docs/periodic.md). Any number of points, from none on, in any box that is not too thin or skewed.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Positions, in any unit of length, inside the box or not: any image of each point. Of an object with flags of
        its own (ASE's `pbc`), all have to be set; an array, such as `atoms.positions`, has none.
    box : array_like, shape (d,) or (d, d)
        The lengths of an orthorhombic box, or the vectors of any box as rows. All directions are periodic.
    threads : int, optional
        Number of threads of builds, and of steps that test all signs. Results do not depend on it.
    report_changes : bool, optional
        Whether calls list the pairs of neighbours that they make and break (`pairs_made`, `pairs_broken`) and the
        simplices that they create and remove (`changed_simplices`, `removed_simplices`). Off by
        default, also in `MovingDelaunay` with a box: a call that lists them copies arrays, O(n).
    strategy : {'auto', 'signs', 'tolerances'}, optional
        What a `move` tests: all signs, or only certificates of points that have left their tolerances, which are those
        of ways relative to the box; by default tolerances while they pay, judged by counts of work. Results do not
        depend on it.
    merge_duplicates : bool, optional
        Whether points that are images of one another, rounded, become one vertex (`vertex_of_input`) instead of an
        error. Not those that come to one place later.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``duplicate_point`` if two points are images
        of one another (unless `merge_duplicates`), ``too_large``, ``usage`` for a box without volume or one that is too
        skewed or too thin, ``environment``. `NotAvailableError` for an object that is not periodic in all directions.

    Notes
    -----
    A `move` flips where a sign fails; where flips are stuck or would cost more it rebuilds, which costs what
    constructing costs. What `MovingDelaunay` has and this class has not, because it has no meaning in a box, raises a
    `NotAvailableError` that says why. It is an `Error`, a `NotImplementedError` and an `AttributeError`.

    Vertices have indices in the order of the points. Removing a vertex makes its index free: `points` and what is by
    vertex are NaN there. The next insertion takes the index that was freed last.

    Arrays are computed on each access, and belong to the caller. Threads and processes: as with `MovingDelaunay`. What
    is pickled or copied has the same points, box and neighbours afterwards, bit for bit, wherever its points are; also
    attributes of your own. It is built again: simplices may have other numbers, and tolerances are not kept.

    Where the box is skewed and its vectors are not on their grid, a point outside of it may be given by `points` one
    unit of the grid beside its place. Positions that are taken from there, for `interpolate` or `insert`, are not
    exactly at the vertex then; those that you gave are.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> x = np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]])  # copper
    >>> dt = annulus.MovingDelaunay(x, box=[1, 1, 1])
    >>> dt.neighbor_counts()
    array([12, 12, 12, 12], dtype=int32)
    >>> dt.voronoi_volumes().sum()
    1.0
    """

    _mesh: _core.Periodic2 | _core.Periodic3
    _threads: int
    _report_changes: bool
    _strategy: str
    _vertex_of_input: Indices

    def __init__(self, points: ArrayLike, box: ArrayLike, threads: int = 1, report_changes: bool = False,
                 strategy: str = "auto", merge_duplicates: bool = False) -> None:
        threads = _arguments.whole("threads", threads, 1, 2**31 - 1)
        report_changes = _arguments.truth("report_changes", report_changes)
        strategy = _arguments.choice("strategy", strategy, STRATEGIES)
        array = plain(points)
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {array.shape if array.ndim <= 8 else '(..)'}",
                        "wrong_size")
        kind = _core.Periodic2 if array.shape[1] == 2 else _core.Periodic3
        merge_duplicates = _arguments.truth("merge_duplicates", merge_duplicates)
        self._mesh = kind.build(array, box, threads, report_changes, strategy, merge_duplicates)
        self._threads = threads
        self._report_changes = report_changes
        self._strategy = strategy
        self._vertex_of_input = self._mesh.vertex_of_input

    def move(self, points: ArrayLike, box: ArrayLike | None = None, *,
             indices: ArrayLike | None = None) -> _core.MoveResult:
        """Moves all points, and gives the box another shape, or moves some points.

        Parameters
        ----------
        points : array_like, shape (npoints, d) or (k, d)
            The new positions: any image of each point. Rows at free indices are not read.
        box : array_like, shape (d,) or (d, d), optional
            The new box; the old one by default. Not with `indices`.
        indices : array_like of int, shape (k,), optional
            Indices of the vertices to move, all at the same time. If an index occurs twice, its last row counts.

        Returns
        -------
        MoveResult
            All points are `within_tolerance`, `kept_in_place`, `flipped` or `rebuilt` in it; those of `indices` are
            counted alone, `reinserted`, while they are few. Its lists of simplices and edges are not available: they
            raise an `Error` with the code ``usage``.

        Raises
        ------
        Error
            With the codes of the constructor, ``unknown_vertex`` and ``wrong_size``; nothing has changed then,
            but `tolerances` may be computed again.

        Notes
        -----
        Some vertices are removed, and inserted where they go, at the cost of these, and tolerances are not kept; the
        result counts the vertices that are named. Where it is expected to cost less to move all, or with too few
        points, that is done, and the result counts all.
        """
        if indices is None:
            return self._mesh.move(plain(points), box)
        if box is not None:
            raise Error("box cannot be given together with indices", "usage")
        return self._mesh.move_some(plain(points), indices)

    def insert(self, points: ArrayLike) -> Indices:
        """Inserts vertices: all of them or, if it raises an exception, none.

        Parameters
        ----------
        points : array_like, shape (k, d)
            Inside the box or not: any image of each.

        Returns
        -------
        ndarray of int32, shape (k,)
            Their indices: first free ones, the one freed last first, then new ones.

        Raises
        ------
        Error
            With the codes ``duplicate_point`` if a vertex is, rounded, an image of one of the points (`vertices` names
            it; no vertex where two of the points are images of one another), ``wrong_size``, ``not_finite``,
            ``out_of_domain``, ``too_large``.

        Notes
        -----
        One point replaces the simplices near it, after a walk through O(n**(1/3)) of them. With few points, or in a box
        that is thinner than simplices are long, it costs a construction. Several points also copy arrays, O(n); more
        than an eighth of all are constructed with the others at once.
        """
        return self._mesh.insert(plain(points))

    def remove(self, indices: ArrayLike) -> None:
        """Removes vertices: all of them or, if it raises an exception, none. Their indices become free. It costs what
        `insert` costs.

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
        """Evaluates every certificate, and keeps `tolerances` from now on: those of the present points, of which
        nothing is used up. With ``strategy='signs'`` it does nothing. O(n), in 3D a few microseconds a point. What is
        kept is an eighth less, or half where cells are thin, than what `tolerances` has while none are, since it has
        to hold in boxes that are a little longer, too.

        Returns
        -------
        MoveResult
            Its `statistics` say what the call cost. Nothing has moved.
        """
        return self._mesh.recompute_tolerances()

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (npoints, d): the positions as they were given, each coordinate rounded to the
        grid of the box (to the nearest double where a point is more than eight boxes away); NaN at free indices."""
        return self._mesh.points

    @property
    def tolerances(self) -> Floats:
        """ndarray of float64, shape (npoints,): a lower bound of how far each point may be from where it is, while the
        box stays and every other point moves by no more than its own bound: no simplex changes. NaN at free indices.

        While tolerances are kept (`strategy`; insertions and removals end them) these are what is left of them;
        otherwise all certificates are evaluated, which in 3D takes a few microseconds a point. Of points more than
        eight boxes away from the origin it holds for moves relative to where they are in the box.
        """
        return self._mesh.tolerances

    @property
    def theta(self) -> Floats:
        """ndarray of float64, shape (npoints,): the least theta of the bi-cells of each vertex and its images, in
        radians; NaN at free indices. It is small where two neighbouring simplices have nearly the same circumcircle or
        circumsphere. O(n)."""
        return self._mesh.theta

    @property
    def box(self) -> Floats:
        """ndarray of float64, shape (d, d): the vectors of the box as rows, rounded to its grid."""
        return self._mesh.box

    def audit(self) -> AuditResult:
        """Checks the whole triangulation in integer arithmetic, with code that it does not share with what it checks.
        O(n), microseconds per simplex.

        Returns
        -------
        AuditResult
        """
        return audit_result_of(self._mesh.audit())

    @property
    def vertex_of_input(self) -> Indices:
        """ndarray of int32, shape (n,): the vertex of each point given to the constructor: 0, 1, 2, .. unless duplicate
        points were merged."""
        return self._vertex_of_input.copy()

    @property
    def strategy(self) -> str:
        """str: ``auto``, also where ``rebuild`` was given, ``signs`` or ``tolerances``."""
        return self._strategy

    def __getattr__(self, name: str) -> typing.Any:
        if name in WITHOUT_MEANING:
            raise NotAvailableError(f"{name} is not available with a periodic box: {WITHOUT_MEANING[name]}")
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __repr__(self) -> str:
        if not hasattr(self, "_mesh"):
            return f"<{type(self).__name__}: not initialised>"
        n = self.nvertices
        return f"<{type(self).__name__}: {n} {'vertex' if n == 1 else 'vertices'} in a box in {self.ndim}D>"

    # Format 1; "free_indices" were not there before. What the first versions pickled, points and a rounded box, are
    # arguments of the constructor.
    def __getstate__(self) -> dict[str, typing.Any]:
        more = {name: value for name, value in self.__dict__.items() if name != "_mesh"}
        vectors, places, images, free_indices = self._mesh.state()
        return {"format": 1, "vectors": vectors, "places": places, "images": images, "free_indices": free_indices,
                "more": more}

    def __setstate__(self, state: dict[str, typing.Any]) -> None:
        if not isinstance(state, dict) or not {"format", "vectors", "places", "images", "more"} <= state.keys():
            raise Error(f"state must be that of a pickled PeriodicDelaunay, not {_arguments.described(state)}",
                        "bad_input")
        if state["format"] != 1:
            raise Error("state was pickled by another version of annulus: format "
                        f"{_arguments.described(state['format'])}", "bad_input")
        places, more = state["places"], state["more"]
        kind = _core.Periodic2 if places.shape[1] == 2 else _core.Periodic3
        self._mesh = kind.build_again(state["vectors"], places, state["images"], state.get("free_indices", ()),
                                      more["_threads"], more.setdefault("_report_changes", False),
                                      more.setdefault("_strategy", "auto"))
        # Versions before kept the number of points, or nothing.
        inputs = more.pop("_inputs", len(places)) if "_vertex_of_input" not in more else 0
        more.setdefault("_vertex_of_input", np.arange(inputs, dtype=np.int32))
        self.__dict__.update(more)


def made_with_box(points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                  merge_duplicates: bool = False, threads: int = 1, *, box: ArrayLike, report_changes: bool = False,
                  seed: int = 0) -> PeriodicDelaunay:
    """What `MovingDelaunay` returns when it is given a box."""
    strategy = choice_in_box("strategy", strategy, (*STRATEGIES, "rebuild"), _arguments.STRATEGIES)
    choice_in_box("tolerance", tolerance, ("certified",), _arguments.TOLERANCES)
    options = _arguments.options("auto", "certified", merge_duplicates, threads, report_changes, seed)
    return PeriodicDelaunay(points, box, options["threads"], options["report_changes"],
                            "auto" if strategy == "rebuild" else strategy, options["merge_duplicates"])
