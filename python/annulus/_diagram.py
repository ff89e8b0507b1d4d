# SPDX-License-Identifier: GPL-3.0-or-later
"""`Diagram`, what Voronoi diagrams with and without a box have in common."""

from __future__ import annotations

import functools
import typing

import numpy as np
from numpy.typing import NDArray

from ._queries import Floats, Indices


class Diagram:
    """Measures by ridge and by cell, vertices once each, and the vertices around each ridge: a `Voronoi` and a
    `PeriodicVoronoi` say what they are. Facets that are exactly empty are not among the ridges."""

    points: Floats
    ridge_points: Indices
    areas: Floats
    ridge_centroids: Floats
    distances: Floats
    vectors: Floats
    volumes: Floats
    centroids: Floats
    surfaces: Floats
    vertices: Floats

    def __init__(self, parts: dict[str, typing.Any], corners: Indices) -> None:
        """`corners`: a row for each corner of the rings, which begins with the number of its simplex, or -1, and is the
        same for the same corner."""
        self.points = parts["points"]
        full = ~parts["exactly_empty"]
        self.ridge_points = parts["pairs"][full]
        self.areas = parts["areas"][full]
        self.ridge_centroids = parts["facet_centroids"][full]
        self.distances = parts["distances"][full]
        self.vectors = parts["vectors"][full]
        self.volumes = parts["volumes"]
        self.centroids = parts["centroids"]
        self.surfaces = parts["surfaces"]
        first = parts["vertex_of_simplex"]
        kept = np.flatnonzero(first == np.arange(len(first)))
        number = np.full(len(first) + 1, -1, dtype=np.int32)  # the last one stays -1, for infinity
        number[kept] = np.arange(len(kept), dtype=np.int32)
        self.vertices = parts["vertices"][kept]
        numbered = np.column_stack([number[np.append(first, -1)[corners[:, 0]]], corners[:, 1:]])
        # Those of ridge k are the rows _begin[k] to _begin[k + 1] - 1 of _corners.
        self._begin, self._corners = _without_repetitions(parts["ring_begin"], numbered, full)

    @functools.cached_property
    def ridge_vertices(self) -> list[list[int]]:
        """list of lists of int: the vertices around each ridge, in order, -1 for infinity, which comes first."""
        return [ring.tolist() for ring in self._by_ridge(self._corners[:, 0])]

    @property
    def point_region(self) -> NDArray[np.intp]:
        """ndarray of int, shape (npoints,): the row of `regions` of each point, which is its own; -1 at free
        indices."""
        return np.where(np.isnan(self.points[:, 0]), -1, np.arange(len(self.points)))

    def _by_ridge(self, of_corners: Indices) -> list[Indices]:
        return np.split(of_corners, self._begin[1:-1]) if len(self._begin) > 1 else []

    def __repr__(self) -> str:
        points = np.count_nonzero(~np.isnan(self.points[:, 0]))  # without free indices
        return (f"<{type(self).__name__}: {points} points, {len(self.ridge_points)} ridges in "
                f"{self.points.shape[1]}D>")


def _without_repetitions(begin: Indices, corners: Indices, full: NDArray[np.bool_]) -> tuple[Indices, Indices]:
    """The lists that are `full`, each, as a cycle, without equal neighbours."""
    size = np.diff(begin)
    owner = np.repeat(np.arange(len(size)), size)
    before = np.arange(len(corners)) - 1
    some = size > 0
    before[begin[:-1][some]] = begin[1:][some] - 1
    keep = (np.any(corners != corners[before], axis=1) | (size[owner] == 1)) & full[owner]
    counts = np.bincount(owner[keep], minlength=len(size))[full]
    return np.concatenate([[0], np.cumsum(counts)]).astype(np.int32), corners[keep]
