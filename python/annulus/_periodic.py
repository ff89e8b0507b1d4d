# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicDelaunay`, what `MovingDelaunay` is with a box."""

from __future__ import annotations

import typing
import warnings

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._error import Error, OpenBoundariesWarning
from ._no_array import NoArray
from ._periodic_gradients import PeriodicGradients
from ._periodic_voronoi import PeriodicDiagrams
from ._plot import Plots
from ._queries import AuditResult, Floats, Indices, audit_result_of

_QUANTITIES = "ijdDSA"
STRATEGIES = ("auto", "signs", "tolerances")
_MISSING = ("recompute_tolerances", "convex_hull", "flat_simplices", "vertex_neighbor_vertices", "vertex_to_simplex",
            "theta", "displacements", "vertex_of_input", "affine_dimension", "edges",
            "voronoi_polytopes", "nearest_vertex", "interpolate")


class NotAvailableError(Error, NotImplementedError, AttributeError):
    """Something that is not available with a periodic box. Its code is ``usage``. It is an `AttributeError`, too, so
    that `hasattr` is False for what is missing."""

    def __init__(self, what: str, code: str = "usage", vertices: tuple[int, ...] = ()) -> None:
        super().__init__(what, code, vertices)


class PeriodicDelaunay(PeriodicDiagrams, PeriodicGradients, Plots, NoArray):
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

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``duplicate_point`` if two points are images
        of one another, ``too_large``, ``usage`` for a box without volume or one that is too skewed or too thin,
        ``environment``. `NotAvailableError` for an object that is not periodic in all directions.

    Notes
    -----
    A `move` flips where a sign fails; where flips are stuck or would cost more it rebuilds, which costs what
    constructing costs. There are no lists of simplices that change with a box yet: what `MovingDelaunay` has and this
    class has not raises a `NotAvailableError`, which is an `Error`, a `NotImplementedError` and an `AttributeError`.

    Vertices have indices in the order of the points. Removing a vertex makes its index free: `points` and what is by
    vertex are NaN there. The next insertion takes the index that was freed last.

    Arrays are computed on each access, and belong to the caller. Threads and processes: as with `MovingDelaunay`. What
    is pickled or copied is the same afterwards, bit for bit, wherever its points are; also attributes of your own.

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

    def __init__(self, points: ArrayLike, box: ArrayLike, threads: int = 1, report_changes: bool = False,
                 strategy: str = "auto") -> None:
        threads = _arguments.whole("threads", threads, 1, 2**31 - 1)
        report_changes = _arguments.truth("report_changes", report_changes)
        strategy = _arguments.choice("strategy", strategy, STRATEGIES)
        array = _plain(points)
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {array.shape if array.ndim <= 8 else '(..)'}",
                        "wrong_size")
        kind = _core.Periodic2 if array.shape[1] == 2 else _core.Periodic3
        self._mesh = kind.build(array, box, threads, report_changes, strategy)
        self._threads = threads
        self._report_changes = report_changes
        self._strategy = strategy

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
            With the codes of the constructor, ``unknown_vertex`` and ``wrong_size``; nothing has changed then.

        Notes
        -----
        Some vertices are removed, and inserted where they go, at the cost of these, and tolerances are not kept; the
        result counts the vertices that are named. Where it is expected to cost less to move all, or with too few
        points, that is done, and the result counts all.
        """
        if indices is None:
            return self._mesh.move(_plain(points), box)
        if box is not None:
            raise Error("box cannot be given together with indices", "usage")
        return self._mesh.move_some(_plain(points), indices)

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
        return self._mesh.insert(_plain(points))

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
    def box(self) -> Floats:
        """ndarray of float64, shape (d, d): the vectors of the box as rows, rounded to its grid."""
        return self._mesh.box

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented, one simplex of
        each set of translates. A vertex may occur several times in one."""
        return self._mesh.simplices

    @property
    def simplex_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): which image of its vertex each corner is. It is at
        ``points[simplices] + simplex_offsets @ box``. The least offset of a simplex is 0 in each direction. Raises an
        `Error` with the code ``too_large`` where one is above 127, as may be where neighbours were given 127 boxes
        apart or more."""
        return self._mesh.simplex_offsets

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each corner."""
        return self._mesh.neighbors

    @property
    def neighbor_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): what to add to the offsets of that simplex, so that the corners
        of the common facet have the same ones. Raises an `Error` with the code ``too_large`` where one is not from
        -128 to 127."""
        return self._mesh.neighbor_offsets

    def neighbor_list(self, quantities: str = "ijdDSA") -> typing.Any:
        """Pairs of Voronoi cells that touch, with the facet between them, sorted by i, j and S.

        Parameters
        ----------
        quantities : str, optional
            What to return, as for `ase.neighborlist.neighbor_list`: ``i`` and ``j``, the points; ``d``, the distance;
            ``D``, the vector ``points[j] - points[i] + S @ box``; ``S``, the shift; and ``A``, the length (2D) or area
            (3D) of the facet: 0 where it is exactly empty, and only there.

        Returns
        -------
        tuple of ndarrays, or one ndarray
            In the order of `quantities`, with a row for each pair in each direction. A point may be its own neighbour,
            and two points may be neighbours several times, with different S.
        """
        if not isinstance(quantities, str) or not quantities or set(quantities) - set(_QUANTITIES):
            raise Error(f"quantities must be letters of {_QUANTITIES!r}, not {_arguments.described(quantities)}",
                        "usage")
        arrays = dict(zip(_QUANTITIES, self._mesh.neighbours()))
        return arrays[quantities] if len(quantities) == 1 else tuple(arrays[q] for q in quantities)

    def find_simplex(self, xi: ArrayLike) -> tuple[Indices, Indices]:
        """The simplices that contain points, decided exactly for the points as they would be rounded.

        Parameters
        ----------
        xi : array_like, shape (k, d)
            Inside the box or not.

        Returns
        -------
        simplices : ndarray of int32, shape (k,)
            -1 for a point with a coordinate that is NaN, and without simplices.
        shifts : ndarray of int32, shape (k, d)
            Which image of the simplex it is: its corners are at ``points[simplices[s]] + (simplex_offsets[s] + shift)
            @ box``.

        Raises
        ------
        Error
            With the codes ``wrong_size``, ``not_finite`` for infinity, ``out_of_domain``.
        """
        return self._mesh.find_simplex(_plain(xi))

    @property
    def pairs_made(self) -> tuple[Indices, Indices, Indices]:
        """tuple of ndarrays, i, j and S: the pairs of neighbours that the last call of `move`, `insert` or `remove`
        made, each once, i <= j, ascending: point j, moved by ``S @ box``, is a neighbour of point i since. Facets of
        the triangulation count, also those that are exactly empty. Points that are given as other images change
        nothing, nor does a box in another basis of its lattice. Raises an `Error` with the code ``usage`` without
        `report_changes`."""
        return self._mesh.pairs(True)

    @property
    def pairs_broken(self) -> tuple[Indices, Indices, Indices]:
        """tuple of ndarrays, i, j and S: the pairs that the same call broke, by points and box before it."""
        return self._mesh.pairs(False)

    @property
    def changed_simplices(self) -> tuple[Indices, Indices]:
        """tuple of ndarrays, vertices (k, d + 1) and offsets (k, d + 1, d), int32: the simplices that the last call of
        `move`, `insert` or `remove` created. They are positively oriented, as `simplices`, but each is written in one
        way only: corners ascend by (vertex, offset), the last two exchanged where that makes the simplex positive, and
        the least offset is 0 in each direction. Simplices ascend. Points that are given as other images change nothing,
        nor does a box in another basis of its lattice. Raises an `Error` with the code ``usage`` without
        `report_changes`."""
        return self._mesh.changed_cells(True)

    @property
    def removed_simplices(self) -> tuple[Indices, Indices]:
        """tuple of ndarrays, vertices and offsets: the simplices that the same call removed, by points and box before
        it. A simplex that was turned over is in both lists, with its vertices in another order."""
        return self._mesh.changed_cells(False)

    def neighbor_counts(self, min_area: float = 0.0, strict: bool = True) -> Indices:
        """The number of neighbours of each point.

        Parameters
        ----------
        min_area : float, optional
            Only neighbours are counted whose facet has a greater length or area, or with ``strict=False`` at least
            this one.
        strict : bool, optional
            With 0 and True, the default, facets that are exactly empty are not counted, and all others are: 12 in fcc
            crystals, 14 in bcc, as long as their coordinates are not rounded.

        Returns
        -------
        ndarray of int32, shape (npoints,)
            0 at free indices.
        """
        return self._mesh.neighbour_counts(_arguments.number("min_area", min_area),
                                           _arguments.truth("strict", strict))

    def audit(self) -> AuditResult:
        """Checks the whole triangulation in integer arithmetic, with code that it does not share with what it checks.
        O(n), microseconds per simplex.

        Returns
        -------
        AuditResult
        """
        return audit_result_of(self._mesh.audit())

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return 2 if isinstance(self._mesh, _core.Periodic2) else 3

    @property
    def npoints(self) -> int:
        """int: rows of `points`, free indices included."""
        return self._mesh.index_bound

    @property
    def nvertices(self) -> int:
        """int: how many vertices there are."""
        return self._mesh.vertices

    @property
    def is_vertex(self) -> NDArray[np.bool_]:
        """ndarray of bool, shape (npoints,): False at free indices."""
        return self._mesh.is_vertex

    @property
    def nsimplex(self) -> int:
        """int: rows of `simplices`."""
        return self._mesh.cells

    @property
    def strategy(self) -> str:
        """str: ``auto``, also where ``rebuild`` was given, ``signs`` or ``tolerances``."""
        return self._strategy

    def __getattr__(self, name: str) -> typing.Any:
        if name in _MISSING:
            raise NotAvailableError(f"{name} is not available with a periodic box yet")
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
        self.__dict__.update(more)


def _plain(points: ArrayLike) -> np.ndarray[typing.Any, typing.Any]:
    """Positions as an array. Whatever box their object has, the one that is given counts, but its flags do not agree
    with that if one is not set."""
    if type(points) is np.ndarray:
        return points
    flags = None if isinstance(points, (list, tuple)) else _arguments.periodic_directions(points)
    if flags is not None and not all(flags):
        raise NotAvailableError(f"the points are an object with {list(map(int, flags))} as flags of its periodic "
                                "directions, but with box= all are periodic: give its array of positions if they shall "
                                "be")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OpenBoundariesWarning)
        return _arguments.array_of(points, "points")


def made_with_box(points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                  merge_duplicates: bool = False, threads: int = 1, *, box: ArrayLike, report_changes: bool = False,
                  seed: int = 0) -> PeriodicDelaunay:
    """What `MovingDelaunay` returns when it is given a box."""
    options = _arguments.options("auto" if strategy == "signs" else strategy, tolerance, merge_duplicates, threads,
                                 report_changes, seed)
    if options["strategy"] not in ("rebuild", *STRATEGIES):
        raise NotAvailableError(f"strategy={strategy!r} is not available with a periodic box")
    for name, usual in (("tolerance", "certified"), ("merge_duplicates", False)):
        if options[name] != usual:
            raise NotAvailableError(f"{name}={options[name]!r} is not available with a periodic box yet")
    return PeriodicDelaunay(points, box, options["threads"], options["report_changes"],
                            "auto" if strategy == "rebuild" else strategy)
