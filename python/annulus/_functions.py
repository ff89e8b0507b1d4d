# SPDX-License-Identifier: GPL-3.0-or-later
"""`audit`, and the tool's subcommands as functions: `degeneracy`, `counterexample`, `lloyd`, `nodt`."""

from __future__ import annotations

import os
import typing
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core, _lloyd
from ._construction import options_of
from ._error import Error, NotAvailableError
from ._queries import AuditResult, audit_result_of


class LloydResult(typing.NamedTuple):
    """The result of `lloyd`."""

    points: NDArray[np.float64]
    mean_displacement: NDArray[np.float64]
    max_displacement: NDArray[np.float64]
    report: _core.MoveResult


class NodtResult(typing.NamedTuple):
    """The result of `nodt`."""

    points: NDArray[np.float64]
    simplices: NDArray[np.int32]
    on_surface: NDArray[np.bool_]
    mean_displacement: NDArray[np.float64]
    max_displacement: NDArray[np.float64]
    report: _core.MoveResult


def audit(points: ArrayLike, simplices: ArrayLike, max_faults: int = 100) -> AuditResult:
    """An exact verdict on a triangulation made by any program: whether it is a Delaunay triangulation of the points.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
    simplices : array_like of int, shape (m, d + 1)
        The corners of each simplex as rows of `points`, in any order, such as
        ``scipy.spatial.Delaunay(points).simplices``. Of points on a line or in a plane the edges or triangles, shape
        (m, 2) or (m, 3). A single point, and no point, is a Delaunay triangulation without simplices, shape (0, d + 1);
        any simplex is a fault then.
    max_faults : int, optional
        How many faults to list at most.

    Returns
    -------
    AuditResult
        True if Delaunay. All faults are counted; `faults` lists them, sorted by kind, with the numbers of the points
        and simplices concerned.

    Raises
    ------
    Error
        With the codes ``wrong_size``, ``not_finite``, ``too_large``, and ``unknown_vertex`` for a number below -1 or
        above 2**31 - 1. (Other numbers of points that are not there are faults.)

    Notes
    -----
    The simplices are a Delaunay triangulation if each has a volume, no two overlap, no sphere of a simplex holds a
    corner of its neighbour strictly inside, they fill the convex hull, and each point is used and at a position of its
    own. Points on one sphere are no fault. The verdict is computed in integers, in microseconds per simplex. Signals
    (Ctrl-C) are handled from time to time.

    Examples
    --------
    >>> import annulus
    >>> kite = [[0, 0], [4, 0], [5, 5], [0, 4]]
    >>> bool(annulus.audit(kite, [[0, 1, 3], [3, 2, 1]]))
    True
    >>> annulus.audit(kite, [[0, 1, 2], [3, 0, 2]]).faults[0].kind
    'not_delaunay'
    """
    return audit_result_of(_core.audit(points, simplices, _arguments.whole("max_faults", max_faults, 0, 2**31 - 1)))


def degeneracy(points: ArrayLike, merge_duplicates: bool = False, *, box: ArrayLike | None = None,
               thresholds: Sequence[float] | None = None, values: bool = False) -> dict[str, typing.Any]:
    """Measures how degenerate points are: certified counts and distributions of their Delaunay triangulation.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3) = (n, d)
        At least two distinct points.
    merge_duplicates : bool, optional
        Count duplicate points once, instead of raising an `Error` with the code ``duplicate_point``. In a box images
        of one another are duplicates, too.
    box : array_like, shape (d,) or (d, d), optional
        The lengths of a periodic box, or its vectors as rows, as `MovingDelaunay` takes it. A single point is enough
        then. There is no hull: ``"ridges"`` is None; and what the result says of the paper's tolerances is not there.
    thresholds : list of float, optional
        Widths to count below, in mean spacings, 1 to 30 of them: above 0 and finite. In the result they are named as
        Python writes them. By default 1e-3, 1e-6, 1e-9 and 1e-12.
    values : bool, optional
        Also return what was found for every certificate.

    Returns
    -------
    dict
        The content of ``degeneracy.json`` as ``annulus degeneracy`` writes it: widths in mean spacings, and None
        for values that do not exist for points on a line or in a plane. ``file`` is empty.

        With `values`, under ``"values"`` what ``annulus degeneracy --raw`` writes: a dict with ``"bicells"`` (empty
        circles or spheres), ``"cells"`` and ``"ridges"`` (of the convex hull; in 2D its vertices). Each is a dict of
        arrays with a row for each of the m certificates, m = 0 for points on a line or in a plane:

        ``points`` : int32, shape (m, d + 2) of bi-cells, (m, d + 1) of others
            Rows of the argument `points`, of duplicate points the first.
        ``places`` : float64, shape (m, d + 2, d) or (m, d + 1, d), in a box only
            Where they are: the images that the certificate is of, as the mesh has rounded them. Images of one vertex
            count as points that move apart from one another, so widths and tolerances are lower bounds where a
            certificate has several.
        ``width_lower``, ``width_upper`` : float64, shape (m,)
            Between them is the width of the certificate, twice the distance to the nearest placement at which it is
            degenerate, in the unit of the points; both are 0 where it is degenerate.
        ``tolerance`` : float64, shape (m,)
            How far each of its points may move such that it still holds, certified, in the unit of the points.
        ``theta`` : float64, shape (m,), of bi-cells only
            The angle between the axis of its facet and the bisector of its two opposite points, in radians, from 0 to
            pi/2. Where it is small, the centre of the annulus is badly conditioned.
        ``stage`` : int8, shape (m,)
            The arithmetic that decided sign and tolerance: 0 filter, 1 intervals, 2 exact.

    Notes
    -----
    A microsecond for each bi-cell, ten or more for a degenerate one; O(n log n). `values` takes about 60 bytes for each
    certificate.

    Examples
    --------
    >>> import annulus
    >>> found = annulus.degeneracy([[0, 0], [2, 0], [2, 2], [0, 2.5]], values=True)["values"]
    >>> len(found["bicells"]["width_lower"]), len(found["cells"]["points"]), len(found["ridges"]["points"])
    (1, 2, 4)
    >>> bool(0 < found["bicells"]["width_lower"][0] <= found["bicells"]["width_upper"][0] < 1)
    True
    """
    return _core.degeneracy(points, box, _arguments.truth("merge_duplicates", merge_duplicates),
                            None if thresholds is None else _named_thresholds(thresholds),
                            _arguments.truth("values", values))


def _named_thresholds(thresholds: object) -> list[tuple[str, float]]:
    if not isinstance(thresholds, (list, tuple)) and not (isinstance(thresholds, np.ndarray) and thresholds.ndim == 1):
        raise TypeError(f"thresholds must be a list of numbers, not {_arguments.described(thresholds)}")
    widths = [_arguments.number("thresholds", width) for width in thresholds]
    if not 1 <= len(set(widths)) == len(widths) <= 30 or not all(0 < width < float("inf") for width in widths):
        raise Error("thresholds must be 1 to 30 finite numbers above 0 that differ, not "
                    f"{_arguments.described(thresholds)}", "usage")
    return [(repr(width), width) for width in widths]


def counterexample(delta: float = 0.01) -> dict[str, typing.Any]:
    """Five points in 3D where the paper's tolerance accepts a triangulation that is no longer Delaunay.

    Parameters
    ----------
    delta : float, optional
        How far two of the points are inside the unit sphere, 2**-40 to 0.1.

    Returns
    -------
    dict
        The content of ``counterexample.json`` as ``annulus counterexample`` writes it.
    """
    return _core.counterexample(_arguments.number("delta", delta))


def lloyd(points: int | ArrayLike, iterations: int = 100, *,
          density: str | ArrayLike | Callable[[NDArray[np.float64]], ArrayLike] = "one",
          domain: str | ArrayLike | Sequence[ArrayLike] | None = None, radius: float | None = None,
          strategy: str = "auto", tolerance: str = "certified", merge_duplicates: bool = False, threads: int = 1,
          seed: int = 0,
          callback: Callable[[int, float, float], object] | None = None) -> LloydResult:
    """Lloyd's iterations in 2D: in each iteration every point moves to the centroid of its Voronoi cell.

    Parameters
    ----------
    points : int or array_like, shape (n, 2)
        The number of points to sample with the density, or their positions: at least three, in the domain.
    iterations : int, optional
        Number of iterations.
    density : str, array_like or callable, optional
        The density of the centroids: ``one``, ``x2+y2``, ``x2`` or ``sin2`` (of the distance from the origin, in
        radians). Or an array of shape (rows, columns), values of 0 or more in the middles of the pixels of the
        domain's bounding box, the first row on top (the largest y), as in a picture. In between they are interpolated
        bilinearly, and constant in the half pixel along the border. Values are rounded to 2**-24 of the largest one.
        Integrals are exact up to rounding. Or a function of an array (m, 2) of positions that returns m values: it is
        called once, on a grid of 1024 pixels along the longer side of the box, which then is such an array. Arrays
        and functions are for polygons, not for a disc.
    domain : str, array_like of shape (m, 2), or a sequence of these, optional
        The domain to which cells are clipped: ``disc``, ``square``, the corners of a polygon in clockwise or
        counter-clockwise order, or a list of rings of a polygon: what an odd number of them encloses belongs to it. The
        first corner of a ring may be repeated at the end, other corners may be repeated as well, and corners may lie on
        edges: the result is the same, bit for bit, wherever a list begins. Edges must meet at their common corners
        only. Where a centroid is outside of a domain that is not convex, its point moves to the nearest point of its
        cell. By default, the disc for sampled points, and the convex hull for given ones.
    radius : float, optional
        Radius of the disc, or half the side of the square. By default 1, or 2 pi for ``sin2``.
    strategy, tolerance, merge_duplicates, threads, seed
        As for `MovingDelaunay`; the seed is also that of the sample. The result does not depend on ``threads``,
        nor on the strategy if it is certified.
    callback : callable, optional
        ``callback(step, mean_displacement, max_displacement)`` is called after each step, counted from 1. If it
        returns a true value, the iterations end.

    Returns
    -------
    LloydResult
        ``points`` (n, 2); ``mean_displacement`` and ``max_displacement`` by step, in the unit of the points;
        ``report``, the sum of the reports of all steps.

    Raises
    ------
    Error
        With the codes ``usage``, ``bad_input`` for an invalid domain, ``out_of_domain``, and those of
        `MovingDelaunay`.

    Notes
    -----
    Signals are handled between two steps.
    """
    options = _arguments.options(strategy, tolerance, merge_duplicates, threads, False, seed)
    how_many = not isinstance(points, (np.ndarray, list, tuple)) and hasattr(type(points), "__index__")
    size = None if radius is None else _arguments.length("radius", radius)
    corners, begin = _lloyd.rings_of(domain)
    return LloydResult(*_core.lloyd(
        _arguments.whole("points", points, 3, 100_000_000) if how_many else points,
        _lloyd.density_of(density, corners, None if how_many else points, size), corners, begin, size,
        _arguments.iterations_of(iterations), options_of(options), options["seed"],
        _arguments.function("callback", callback)))


def nodt(surface: str | os.PathLike[str] | tuple[ArrayLike, ArrayLike], vertices: int, iterations: int = 100, *,
         gradation: float = 0.0, lock: float | None = None, allow_crossing: bool = False, strategy: str = "auto",
         tolerance: str = "certified", threads: int = 1, seed: int = 0,
         callback: Callable[[int, float, float], object] | None = None) -> NodtResult:
    """Natural-ODT optimisation of a tetrahedral mesh of the domain inside a closed surface.

    Parameters
    ----------
    surface : str, path or pair of array_like
        ``"sphere"``, the unit sphere; a .off, .obj, .ply or .stl file; or points (n, 3) and triangles (m, 3)
        that meet in common corners and edges, and have the same orientation seen from outside.
    vertices : int
        Approximate number of vertices: the size of cells is searched for.
    iterations : int, optional
        Number of iterations.
    gradation : float, optional
        Edges grow with the distance from the surface: at the depth of the ball of the same volume they are
        1 + `gradation` times as long.
    lock : float, optional
        A vertex rests while all dihedral angles of its cells are between `lock` and 180 - `lock`, in degrees.
    allow_crossing : bool, optional
        Accept a surface that crosses itself: a point is inside if a ray from it crosses the surface an odd number
        of times.
    strategy, tolerance, threads, seed, callback
        As for `lloyd`; the seed is also that of the initial mesh.

    Returns
    -------
    NodtResult
        ``points`` (n, 3); ``simplices`` (m, 4), the cells of the domain, positively oriented; ``on_surface``
        (n,), the vertices that were on the surface in the initial mesh, which stay on it;
        ``mean_displacement`` and ``max_displacement`` by step; ``report``, the sum of the reports of all steps.

    Raises
    ------
    Error
        With the codes ``usage``, ``bad_input`` for an invalid surface, ``too_few`` if no mesh with that number of
        vertices was found, and others.

    Notes
    -----
    Signals are handled between two steps, but not while CGAL's Mesh_3 generates the initial mesh.
    """
    options = _arguments.options(strategy, tolerance, False, threads, False, seed)
    return NodtResult(*_core.nodt(
        _surface_of(surface), _arguments.whole("vertices", vertices, 4, 10_000_000),
        _arguments.number("gradation", gradation), None if lock is None else _arguments.number("lock", lock),
        _arguments.truth("allow_crossing", allow_crossing), _arguments.iterations_of(iterations), options_of(options),
        options["seed"], _arguments.function("callback", callback)))


def _surface_of(surface: object) -> object:
    """None for the sphere, the name of a file as bytes, or a pair of arrays."""
    if isinstance(surface, str) and surface == "sphere":
        return None
    if isinstance(surface, (str, os.PathLike)):
        return _arguments.file_of("surface", surface)
    if not isinstance(surface, (tuple, list)):
        raise TypeError("surface must be 'sphere', a file or a pair, points and triangles; not "
                        f"{_arguments.described(surface)}")
    return tuple(surface)
