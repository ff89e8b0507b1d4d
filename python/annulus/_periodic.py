# SPDX-License-Identifier: GPL-3.0-or-later
"""`PeriodicDelaunay`, what `MovingDelaunay` is with a box."""

from __future__ import annotations

import typing
import warnings

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._error import Error, OpenBoundariesWarning
from ._queries import AuditResult, Floats, Indices, audit_result_of

_QUANTITIES = "ijdDSA"
_MISSING = ("insert", "remove", "recompute_tolerances", "find_simplex", "convex_hull", "flat_simplices",
            "vertex_neighbor_vertices", "vertex_to_simplex", "tolerances", "theta", "displacements", "is_vertex",
            "vertex_of_input", "affine_dimension")


class NotAvailableError(Error, NotImplementedError):
    """Something that is not available with a periodic box. Its code is ``usage``."""

    def __init__(self, what: str, code: str = "usage", vertices: tuple[int, ...] = ()) -> None:
        super().__init__(what, code, vertices)


class PeriodicDelaunay:
    """The Delaunay triangulation of points in a periodic box: ``MovingDelaunay(points, box=box)`` makes one.

    It is that of the points and all their translates by the vectors of the box, as finitely many simplices with
    offsets, and exact: proved after every build for `points` and `box`, which are those given, rounded once to about
    2**-49 of the box (docs/periodic.md). Any number of points, from none on, in any box.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Positions, in any unit of length, inside the box or not: any image of each point.
    box : array_like, shape (d,) or (d, d)
        The lengths of an orthorhombic box, or the vectors of any box as rows. All directions are periodic.
    threads : int, optional
        Number of threads of a build. Results do not depend on it.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``duplicate_point`` if two points are images
        of one another, ``too_large``, ``usage`` for a box without volume or one that is too skewed, ``environment``.

    Notes
    -----
    Every `move` builds anew, and costs what constructing costs. There are no tolerances, no reports, no insertion and
    no removal with a box yet: what `MovingDelaunay` has and this class has not raises an `Error` that is a
    `NotImplementedError`, too.

    Arrays are computed on each access, and belong to the caller. Threads and processes: as with `MovingDelaunay`.
    Pickling keeps points, box and threads.

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

    def __init__(self, points: ArrayLike, box: ArrayLike, threads: int = 1) -> None:
        threads = _arguments.whole("threads", threads, 1, 2**31 - 1)
        array = _plain(points)
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {array.shape if array.ndim <= 8 else '(..)'}",
                        "wrong_size")
        kind = _core.Periodic2 if array.shape[1] == 2 else _core.Periodic3
        self._mesh = kind.build(array, box, threads)
        self._threads = threads

    def move(self, points: ArrayLike, box: ArrayLike | None = None) -> None:
        """Moves all points, and gives the box another shape. Builds anew.

        Parameters
        ----------
        points : array_like, shape (npoints, d)
            The new positions: any image of each point.
        box : array_like, shape (d,) or (d, d), optional
            The new box; the old one by default.

        Raises
        ------
        Error
            With the codes of the constructor; nothing has changed then.
        """
        self._mesh.move(_plain(points), box)

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (npoints, d): the positions as they were given, each coordinate rounded to the
        grid of the box (to the nearest double where a point is more than eight boxes away)."""
        return self._mesh.points

    @property
    def box(self) -> Floats:
        """ndarray of float64, shape (d, d): the vectors of the box as rows, rounded to its grid."""
        return self._mesh.box

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented, one simplex of
        each set of translates. A vertex may occur several times in one."""
        return self._mesh.cells()[0]

    @property
    def simplex_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): which image of its vertex each corner is. It is at
        ``points[simplices] + simplex_offsets @ box``. The least offset of a simplex is 0 in each direction."""
        return self._mesh.cells()[1]

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each corner."""
        return self._mesh.cells()[2]

    @property
    def neighbor_offsets(self) -> NDArray[np.int8]:
        """ndarray of int8, shape (nsimplex, d + 1, d): what to add to the offsets of that simplex, so that the corners
        of the common facet have the same ones."""
        return self._mesh.cells()[3]

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
        """
        return self._mesh.neighbour_counts(_arguments.number("min_area", min_area),
                                           _arguments.truth("strict", strict))

    def voronoi_volumes(self) -> Floats:
        """The areas (2D) or volumes (3D) of the Voronoi cells, which add up to that of the box.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            Each with a relative error of at most 2**-33, 1.2e-10.
        """
        return self._mesh.voronoi_volumes()

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
        """int: rows of `points`."""
        return self._mesh.vertices

    @property
    def nvertices(self) -> int:
        """int: the same, since there are no free indices."""
        return self._mesh.vertices

    @property
    def nsimplex(self) -> int:
        """int: rows of `simplices`."""
        return self._mesh.simplices

    @property
    def strategy(self) -> str:
        """str: ``rebuild``."""
        return "rebuild"

    def __getattr__(self, name: str) -> typing.Any:
        if name in _MISSING:
            raise NotAvailableError(f"{name} is not available with a periodic box yet")
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __repr__(self) -> str:
        n = self.npoints
        return f"<{type(self).__name__}: {n} {'vertex' if n == 1 else 'vertices'} in a box in {self.ndim}D>"

    def __reduce__(self) -> tuple[typing.Any, ...]:
        return type(self), (self.points, self.box, self._threads)


def _plain(points: ArrayLike) -> np.ndarray[typing.Any, typing.Any]:
    """Positions as an array. Whatever box their object has, the one that is given counts."""
    if type(points) is np.ndarray:
        return points
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OpenBoundariesWarning)
        return _arguments.array_of(points, "points")


def made_with_box(points: ArrayLike, strategy: str = "auto", tolerance: str = "certified",
                  merge_duplicates: bool = False, threads: int = 1, *, box: ArrayLike, report_changes: bool = True,
                  seed: int = 0) -> PeriodicDelaunay:
    """What `MovingDelaunay` returns when it is given a box."""
    options = _arguments.options(strategy, tolerance, merge_duplicates, threads, report_changes, seed)
    if options["strategy"] not in ("auto", "rebuild"):
        raise NotAvailableError(f"strategy={strategy!r} is not available with a periodic box yet: every move builds "
                                "anew")
    for name, usual in (("tolerance", "certified"), ("merge_duplicates", False)):
        if options[name] != usual:
            raise NotAvailableError(f"{name}={options[name]!r} is not available with a periodic box yet")
    return PeriodicDelaunay(points, box, options["threads"])
