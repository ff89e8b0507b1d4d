# SPDX-License-Identifier: GPL-3.0-or-later
"""`MovingDelaunay`: what users see of the compiled classes `Mesh2` and `Mesh3`."""

from __future__ import annotations

import typing

import numpy as np

from . import _core
from ._error import Error

if typing.TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]
    Indices = NDArray[np.int32]


class AuditResult(typing.NamedTuple):
    """The verdict of `MovingDelaunay.audit`, and the first fault found. True where the triangulation is Delaunay."""

    delaunay: bool
    inverted_cells: int
    violated_facets: int
    concave_ridges: int
    topological_faults: int
    degenerate_facets: int
    first_fault: str

    def __bool__(self) -> bool:
        return self.delaunay


class MovingDelaunay:
    """A Delaunay triangulation that is kept right while its vertices move.

    After every call, with ``tolerance="certified"``, the simplices are a Delaunay triangulation of the points where they are now. That is
    proved in every step, by tolerances within which nothing can change and by exact signs where a tolerance does not tell.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        Positions, in any unit of length. float32 and integers up to 2**53 are taken exactly; what would have to be rounded to float64 (long
        doubles) is a `TypeError`. float64 in C order is read where it is. There may be any number of points, also fewer than d + 1, and
        they may lie on a line or in a plane.
    strategy : str, optional
        How the triangulation is kept right: ``auto`` (the cheapest of tolerances, signs with flips, and rebuilding, as counts tell),
        ``filter``, ``filter-each``, ``in-place``, ``rebuild``, ``relocate``, ``relocate-flips`` or ``hybrid``.
    tolerance : str, optional
        ``certified``, a proved lower bound; ``paper`` and ``floating`` are uncertified, for comparison.
    merge_duplicates : bool, optional
        Equal points become one vertex (see `index_of_input`). Without it they are an `Error` with the code ``collision``.
    threads : int, optional
        How many may work on what is parallel. Results do not depend on it.
    second_look : str, optional
        In the plane, a cheap test before a certificate is evaluated: ``off``, ``unequal`` or ``safe-region``.
    report_changes : bool, optional
        Whether reports list `changed_simplices`.
    seed : int, optional
        Of the sample that ``hybrid`` draws.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``out_of_domain``, ``collision``, ``too_large``, ``usage``, ``environment``.

    Notes
    -----
    **Indices.** Vertices have the index of their row in `points`. `remove` leaves an index vacant, `insert` takes those that are vacant, the
    one vacated last first, and then new ones. At vacant indices every array of numbers by vertex (`points`, `tolerances`, `theta`,
    `displacements`, `voronoi_volumes`) is NaN, `vertex_to_simplex` is -1, the list of neighbours is empty, and no simplex names them. `move` takes
    a row for them all the same and ignores it.

    **Arrays.** `points`, `simplices`, `neighbors`, `flat_simplices`, `vertex_to_simplex`, `vertex_neighbor_vertices` are read-only arrays that show one
    moment: they stay as they are when vertices move, and when the triangulation is gone. They are copied once after a change, when they are asked for;
    asking again costs nothing.

    **Threads.** The GIL is released while something is computed; calls on one object from several threads take turns. Do not write in an
    array while another thread has it as an argument of a call. A signal (Ctrl-C) is seen after the call.

    **Processes.** A child of `os.fork` may go on with its copy, with ``threads=1``, unless another thread was in a call on the object when it was forked.
    Pickling keeps positions, indices and options; tolerances are fresh then, and where d + 2 points are cocircular or cospherical the simplices are those of a rebuild.

    Examples
    --------
    >>> import numpy as np, annulus
    >>> points = np.random.default_rng(0).random((1000, 2))
    >>> dt = annulus.MovingDelaunay(points)
    >>> report = dt.move(points + 1e-4 * np.sin(9 * points))
    >>> report.asked, dt.audit().delaunay
    (1000, True)
    """

    _mesh: _core._Mesh
    _options: dict[str, typing.Any]
    _index_of_input: Indices

    def __init__(self, points: ArrayLike, strategy: str = "auto", tolerance: str = "certified", merge_duplicates: bool = False,
                 threads: int = 1, *, second_look: str = "off", report_changes: bool = True, seed: int = 0) -> None:
        options = {"strategy": strategy, "tolerance": tolerance, "merge_duplicates": bool(merge_duplicates), "threads": threads,
                   "second_look": second_look, "report_changes": bool(report_changes), "seed": seed}
        if not isinstance(points, np.ndarray):
            points = np.asarray(points)
        shape = points.shape
        if len(shape) != 2 or shape[1] not in (2, 3):
            raise Error(f"points must have shape (n, 2) or (n, 3), not {shape}", "wrong_size")
        mesh = (_core.Mesh2 if shape[1] == 2 else _core.Mesh3)(points, _options_of(options))
        self._options = options
        self._mesh = mesh
        self._index_of_input = mesh.index_of_input
        self._index_of_input.flags.writeable = False

    # ---- What changes it ---------------------------------------------------------------------

    def move(self, points: ArrayLike, indices: ArrayLike | None = None) -> _core.MoveReport:
        """Moves all vertices, or some, at once.

        Parameters
        ----------
        points : array_like, shape (npoints, d) or (k, d)
            Where they go. Rows of vacant indices are ignored.
        indices : array_like of int, shape (k,), optional
            Who goes, by index; all without it. For one that is named twice the last row holds.

        Returns
        -------
        MoveReport
            What became of the vertices, what was computed, and the simplices that may be new.

        Raises
        ------
        Error
            ``collision`` where two vertices would be at one place, ``wrong_size``, ``unknown_vertex``, ``not_finite``, ``out_of_domain``; nobody has
            moved then.
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
            Their indices: those that are vacant, the one vacated last first, then new ones.

        Raises
        ------
        Error
            ``collision`` where a vertex is (`merge_duplicates` does not apply here), ``wrong_size``, ``not_finite``, ``out_of_domain``, ``too_large``.

        Notes
        -----
        O(log n) expected for each; more than one at once are first compared with all positions, which takes O(n). When memory runs out half way, those that were
        inserted are taken out again, and there may be more vacant indices than before.
        """
        return self._mesh.insert(points)

    def remove(self, indices: ArrayLike) -> None:
        """Removes vertices, all of them or, when it raises an `Error`, none; their indices become vacant.

        Parameters
        ----------
        indices : array_like of int, shape (k,)

        Raises
        ------
        Error
            ``unknown_vertex`` for an index that is no vertex', or is there twice.
        """
        self._mesh.remove(indices)

    def settle(self) -> _core.MoveReport:
        """Makes every tolerance fresh, to be measured from where the vertices are now. O(n)."""
        return self._mesh.settle()

    # ---- What is read off it -----------------------------------------------------------------

    @property
    def points(self) -> Floats:
        """ndarray of float64, shape (npoints, d): positions by vertex index, NaN at vacant indices. Read-only, as of now."""
        return self._mesh.points

    @property
    def simplices(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): vertices of the simplices, positively oriented.

        Counter-clockwise in the plane; in space the determinant of the differences from the first vertex is positive. None, shape (0, d + 1), where the points do not span the plane or
        space: see `flat_simplices`. Their order has no meaning and changes.
        """
        return self._mesh.simplices

    @property
    def neighbors(self) -> Indices:
        """ndarray of int32, shape (nsimplex, d + 1): the simplex beyond the facet opposite to each vertex; -1 outside."""
        return self._mesh.neighbors

    @property
    def flat_simplices(self) -> Indices:
        """ndarray of int32, shape (m, k + 1): where the points span only k < d dimensions, their triangles or edges; else (0, d + 1)."""
        return self._mesh.flat_simplices

    @property
    def convex_hull(self) -> Indices:
        """ndarray of int32, shape (m, d): the facets with nothing beyond them.

        In the plane with the triangulation to their left, in space counter-clockwise as seen from outside.
        """
        return self._mesh.convex_hull

    @property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """Two ndarrays of int32, (indptr, indices): the neighbours of vertex v are ``indices[indptr[v]:indptr[v + 1]]``, ascending."""
        return self._mesh.vertex_neighbor_vertices

    @property
    def vertex_to_simplex(self) -> Indices:
        """ndarray of int32, shape (npoints,): a simplex of each vertex; -1 at vacant indices and where there are no simplices."""
        return self._mesh.vertex_to_simplex

    @property
    def tolerances(self) -> Floats:
        """ndarray of float64, shape (npoints,): how far each vertex may be from where its tolerance is measured, in the unit of the points.

        While every vertex is within its own, the triangulation is Delaunay; with ``tolerance="certified"`` these are proved lower bounds. While no tolerances are
        kept (``auto`` decides when), the least tolerance of the certificates of each vertex. 0 where the points do not span the space, NaN at vacant indices.
        """
        return self._mesh.tolerances

    @property
    def theta(self) -> Floats:
        """ndarray of float64, shape (npoints,): the least theta of the bi-cells of each vertex, in radians; pi/2 without one, NaN if vacant.

        It is small where two neighbouring simplices have nearly the same circumscribed circle or sphere.
        """
        return self._mesh.theta

    @property
    def displacements(self) -> Floats:
        """ndarray of float64, shape (npoints,): an upper bound of how far each vertex is from where its tolerance is measured; NaN if vacant."""
        return self._mesh.displacements

    def voronoi_volumes(self) -> Floats:
        """The areas (in the plane) or volumes of the Voronoi cells, in the unit of the points to the power of d.

        Returns
        -------
        ndarray of float64, shape (npoints,)
            ``inf`` for unbounded cells, at the vertices of the hull; NaN at vacant indices.
        """
        return self._mesh.voronoi_volumes()

    def find_simplex(self, xi: ArrayLike) -> Indices:
        """The simplices that contain points, decided exactly.

        Parameters
        ----------
        xi : array_like, shape (..., d)

        Returns
        -------
        ndarray of int32, shape (...)
            Rows of `simplices`; -1 outside of the convex hull and for NaN. A point on a facet is in either of its simplices.
        """
        return self._mesh.find_simplex(xi)

    def audit(self) -> AuditResult:
        """Looks at all of it with integer arithmetic, which shares no code with what it audits. O(n), microseconds a simplex.

        Returns
        -------
        AuditResult
            Vertices in `first_fault` are counted without vacant indices.
        """
        return AuditResult(*self._mesh.audit())

    @property
    def ndim(self) -> int:
        """int: d, 2 or 3."""
        return 2 if isinstance(self._mesh, _core.Mesh2) else 3

    @property
    def affine_dimension(self) -> int:
        """int: that which the points span; -1 without points."""
        return self._mesh.dimension

    @property
    def npoints(self) -> int:
        """int: rows of `points`, vacant indices included."""
        return self._mesh.npoints

    @property
    def nvertices(self) -> int:
        """int: vertices, vacant indices not counted."""
        return self._mesh.vertices

    @property
    def nsimplex(self) -> int:
        """int: rows of `simplices`."""
        return len(self._mesh.simplices)

    @property
    def is_vertex(self) -> NDArray[np.bool_]:
        """ndarray of bool, shape (npoints,): False at vacant indices."""
        return self._mesh.is_vertex

    @property
    def index_of_input(self) -> Indices:
        """ndarray of int32, shape (n,): the vertex that each point became in the beginning; not 0, 1, 2 .. only where some were merged."""
        return self._index_of_input

    @property
    def strategy(self) -> str:
        """str: the strategy in force: that of the options, but that ``hybrid`` becomes ``filter`` when it switches."""
        return self._mesh.strategy

    def __repr__(self) -> str:
        if not hasattr(self, "_mesh"):
            return f"<{type(self).__name__}: not initialised>"
        n = self.nvertices
        return (f"<{type(self).__name__}: {n} {'vertex' if n == 1 else 'vertices'} in {'the plane' if self.ndim == 2 else 'space'}, "
                f"strategy {self.strategy!r}, tolerance {self._options['tolerance']!r}>")

    # ---- Pickling and copying ----------------------------------------------------------------

    def __getstate__(self) -> dict[str, typing.Any]:
        more = {name: value for name, value in self.__dict__.items() if name != "_mesh"}
        return {"format": 1, "points": self._mesh.points, "vacant": self._mesh.vacant, "more": more}

    def __setstate__(self, state: dict[str, typing.Any]) -> None:
        if state.get("format") != 1:
            raise Error(f"this was pickled by another version of annulus: format {state.get('format')}", "bad_input")
        points, more = state["points"], state["more"]
        kind = _core.Mesh2 if points.shape[1] == 2 else _core.Mesh3
        self._mesh = kind(points, state["vacant"], _options_of(more["_options"]))
        self.__dict__.update(more)
        self._index_of_input.flags.writeable = False


def _options_of(o: dict[str, typing.Any]) -> _core.Options:
    return _core.Options(o["strategy"], o["tolerance"], o["second_look"], o["threads"], o["merge_duplicates"], o["report_changes"], o["seed"])
