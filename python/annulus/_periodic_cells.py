# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi cells and edges of a periodic box in 2D, cut into the pieces that lie within it, for pictures: in floating
point, and not exact."""

from __future__ import annotations

import typing

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def cells_in_box(dt: typing.Any) -> tuple[list[Array], NDArray[np.intp]]:
    """Polygons that fill the box, counter-clockwise, and the point of each. A cell is in as many pieces as the box cuts
    it into. O(n), and some twenty microseconds for each piece that is cut."""
    rings, begin = _rings(dt)
    count = np.diff(begin)
    cells = np.flatnonzero(count)  # there is none at a free index
    if not len(cells):
        return [], np.zeros(0, dtype=np.intp)
    low = np.floor(np.minimum.reduceat(rings, begin[cells], axis=0))
    high = np.ceil(np.maximum.reduceat(rings, begin[cells], axis=0))
    box = dt.box
    pieces = np.split((rings - np.repeat(low, count[cells], axis=0)) @ box, begin[cells[1:]])
    cut = np.any(high - low > 1, axis=1)
    polygons = [pieces[k] for k in np.flatnonzero(~cut)]
    owners = cells[~cut].tolist()
    for k in np.flatnonzero(cut):
        ring = rings[begin[cells[k]]:begin[cells[k] + 1]]
        for shift in np.ndindex(*(high[k] - low[k]).astype(int)):
            piece = _within_unit_square(ring - low[k] - shift)
            if len(piece) > 2:
                polygons.append(piece @ box)
                owners.append(cells[k])
    return polygons, np.array(owners, dtype=np.intp)


def edges_in_box(dt: typing.Any) -> Array:
    """Pieces of the edges of the triangulation that lie within the box, shape (k, 2, 2)."""
    i, j, vectors, shifts = dt.neighbor_list("ijDS")
    once = (i < j) | (i == j) & ((shifts[:, 0] > 0) | (shifts[:, 0] == 0) & (shifts[:, 1] > 0))
    inverse = np.linalg.inv(dt.box)
    start = (dt.points @ inverse)[i[once]]
    way = vectors[once] @ inverse
    start = start - np.floor(start)
    # Its images that may meet the box: those moved by a cell that the edge runs through.
    low = np.floor(np.minimum(start, start + way)).astype(int)
    high = np.floor(np.maximum(start, start + way)).astype(int)
    out: list[Array] = []
    for a in range(low[:, 0].min(initial=0), high[:, 0].max(initial=0) + 1):
        for b in range(low[:, 1].min(initial=0), high[:, 1].max(initial=0) + 1):
            from_, to = _parts_within_unit_square(start - [a, b], way)
            kept = to - from_ > 0
            ends = np.stack([from_, to], axis=1)[kept]
            out.append((start[kept] - [a, b])[:, None] + ends[:, :, None] * way[kept][:, None])
    box: Array = dt.box
    return np.concatenate(out) @ box


def _rings(dt: typing.Any) -> tuple[Array, NDArray[np.intp]]:
    """The corners of the cells around `points`, one cell after the other, in shares of the box, and where each cell
    begins, with the end of all."""
    v = dt.voronoi()
    begin, corners = v._cells
    return v.vertices[corners[:, 0]] @ np.linalg.inv(v.box) + corners[:, 1:], begin


def _within_unit_square(polygon: Array) -> Array:
    """The part of a convex polygon that is within [0, 1]^2, by Sutherland and Hodgman."""
    for axis, sign, least in ((0, 1.0, 0.0), (0, -1.0, -1.0), (1, 1.0, 0.0), (1, -1.0, -1.0)):
        if not len(polygon):
            break
        inside = sign * polygon[:, axis] - least
        after, next_inside = np.roll(polygon, -1, axis=0), np.roll(inside, -1)
        crossed = (inside > 0) != (next_inside > 0)
        share = np.where(crossed, inside / np.where(crossed, inside - next_inside, 1.0), 0.0)
        points = np.stack([polygon, polygon + share[:, None] * (after - polygon)], axis=1).reshape(-1, 2)
        polygon = points[np.stack([inside > 0, crossed], axis=1).reshape(-1)]
    return polygon


def _parts_within_unit_square(start: Array, way: Array) -> tuple[Array, Array]:
    """From which to which share of itself a segment is within [0, 1]^2, by Liang and Barsky; nowhere where the first is
    not less."""
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = -start / way, (1 - start) / way
    across = way == 0
    outside = across & ((start < 0) | (start >= 1))
    first = np.where(across, np.where(outside, np.inf, -np.inf), np.minimum(one, other)).max(axis=1)
    last = np.where(across, np.where(outside, -np.inf, np.inf), np.maximum(one, other)).min(axis=1)
    return np.clip(first, 0.0, 1.0), np.clip(last, 0.0, 1.0)
