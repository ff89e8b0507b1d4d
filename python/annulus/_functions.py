# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool's subcommands as functions: `degeneracy`, `counterexample`, `lloyd`, `nodt`."""

from __future__ import annotations

import os
import typing
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._moving_delaunay import options_of


class LloydResult(typing.NamedTuple):
    """What `lloyd` comes to."""

    points: NDArray[np.float64]
    mean_displacement: NDArray[np.float64]
    max_displacement: NDArray[np.float64]
    report: _core.MoveReport


class NodtResult(typing.NamedTuple):
    """What `nodt` comes to."""

    points: NDArray[np.float64]
    simplices: NDArray[np.int32]
    on_surface: NDArray[np.bool_]
    mean_displacement: NDArray[np.float64]
    max_displacement: NDArray[np.float64]
    report: _core.MoveReport


def degeneracy(points: ArrayLike, merge_duplicates: bool = False) -> dict[str, typing.Any]:
    """How degenerate points are: certified counts and distributions of their Delaunay triangulation.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        At least two that differ.
    merge_duplicates : bool, optional
        Count equal points once, instead of raising an `Error` with the code ``duplicate_point``.

    Returns
    -------
    dict
        The content of ``degeneracy.json`` as ``annulus degeneracy`` writes it: widths in mean spacings, and
        None for what points on a line or in a plane do not have. ``file`` is empty.
    """
    return _core.degeneracy(points, _arguments.truth("merge_duplicates", merge_duplicates))


def counterexample(delta: float = 0.01) -> dict[str, typing.Any]:
    """Five points of space where the paper's tolerance accepts a triangulation that is no longer Delaunay.

    Parameters
    ----------
    delta : float, optional
        How far two of them are inside the unit sphere, 2**-40 to 0.1.

    Returns
    -------
    dict
        The content of ``counterexample.json`` as ``annulus counterexample`` writes it.
    """
    return _core.counterexample(_arguments.number("delta", delta))


def lloyd(points: int | ArrayLike, iterations: int = 100, *, density: str = "one",
          domain: str | ArrayLike | None = None, radius: float | None = None, strategy: str = "auto",
          tolerance: str = "certified", merge_duplicates: bool = False, threads: int = 1, seed: int = 0,
          callback: Callable[[int, float, float], object] | None = None) -> LloydResult:
    """Lloyd's iterations in the plane: every point goes to the centroid of its Voronoi cell, again and again.

    Parameters
    ----------
    points : int or array_like, shape (n, 2)
        How many to sample with the density, or where they are: at least three, in the domain.
    iterations : int, optional
        How many.
    density : str, optional
        Under which centroids are taken: ``one``, ``x2+y2``, ``x2`` or ``sin2`` (of the distance from the
        origin, in radians).
    domain : str or array_like, shape (m, 2), optional
        To which cells are cut: ``disc``, ``square`` or the corners of a convex polygon, in order, either way
        round. The first may be repeated at the end, others too, and corners may lie on edges: the result is
        the same, bit for bit. Without it the disc for points that are sampled, the convex hull for those that
        are given.
    radius : float, optional
        Of the disc, or half the side of the square: 1, or 2 pi for ``sin2``.
    strategy, tolerance, merge_duplicates, threads, seed
        As for `MovingDelaunay`; the seed is of the sample too. The result does not depend on ``threads``, nor
        on certified strategies.
    callback : callable, optional
        ``callback(step, mean_displacement, max_displacement)`` is called after each step, counted from 1;
        what it returns ends the iterations if it is true.

    Returns
    -------
    LloydResult
        ``points`` (n, 2); ``mean_displacement`` and ``max_displacement`` by step, in the unit of the points;
        ``report``, the sum of the steps' reports.

    Raises
    ------
    Error
        ``usage``, ``bad_input`` for a domain that is none, ``out_of_domain``, and those of `MovingDelaunay`.

    Notes
    -----
    A signal is seen between two steps.
    """
    options = _arguments.options(strategy, tolerance, merge_duplicates, threads, False, seed)
    how_many = not isinstance(points, (np.ndarray, list, tuple)) and hasattr(type(points), "__index__")
    return LloydResult(*_core.lloyd(
        _arguments.whole("points", points, 3, 100_000_000) if how_many else points,
        _arguments.choice("density", density, _arguments.DENSITIES),
        _arguments.choice("domain", domain, _arguments.DOMAINS) if isinstance(domain, str) else domain,
        None if radius is None else _arguments.length("radius", radius), _arguments.iterations_of(iterations),
        options_of(options),
        options["seed"], _arguments.function("callback", callback)))


def nodt(surface: str | os.PathLike[str] | tuple[ArrayLike, ArrayLike], vertices: int, iterations: int = 100, *,
         gradation: float = 0.0, lock: float | None = None, allow_crossing: bool = False, strategy: str = "auto",
         tolerance: str = "certified", threads: int = 1, seed: int = 0,
         callback: Callable[[int, float, float], object] | None = None) -> NodtResult:
    """Natural-ODT optimisation of a tetrahedral mesh of what a closed surface encloses.

    Parameters
    ----------
    surface : str, path or pair of array_like
        ``"sphere"``, the unit sphere; a .off, .obj, .ply or .stl file; or points (n, 3) and triangles (m, 3)
        that meet in common corners and edges, and turn the same way seen from outside.
    vertices : int
        About how many: the size of cells is searched for.
    iterations : int, optional
        How many.
    gradation : float, optional
        Edges grow with the distance from the surface, to 1 + `gradation` times as long at the depth of the
        ball of the same volume.
    lock : float, optional
        A vertex rests while all dihedral angles of its cells are between this and 180 less it, in degrees.
    allow_crossing : bool, optional
        Take a surface that crosses itself: inside is where a ray leaves it an odd number of times.
    strategy, tolerance, threads, seed, callback
        As for `lloyd`; the seed is of the first mesh too.

    Returns
    -------
    NodtResult
        ``points`` (n, 3); ``simplices`` (m, 4), the cells of the domain, positively oriented; ``on_surface``
        (n,), the vertices that were on the surface in the first mesh, which stay on it; displacements by
        step; ``report``, the sum of the steps' reports.

    Raises
    ------
    Error
        ``usage``, ``bad_input`` for a surface that is none, ``too_few`` where no mesh of so many vertices was
        found, and others.

    Notes
    -----
    A signal is seen between two steps, and not while the first mesh is made, by CGAL's Mesh_3.
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
