# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams in periodic boxes: polygons and polyhedra from their corners, beside brute force in NumPy and the
images as an open set. `tests/measure/periodic_diagram_test.cpp` has rational numbers."""

import itertools
import json

import annulus
import numpy as np
import pytest

CRYSTALS = [(np.array([[0, 0, 0]]), 6, 1),
            (np.array([[0, 0, 0], [.5, .5, .5]]), 14, 12),
            (np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]]), 12, 12)]
BOXES = {2: [[2, 1.5], [[1.5, 0], [0.5, 1.25]], [1, 0.05], [[1, 0], [3, 1]], [[0, 1], [1, 0]]],
         3: [[1, 1.5, 2], [[2, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]], [1, 0.3, 0.05],
             [[1, 0, 0], [0, 1, 0], [3, 0, 1]]]}


def vectors_of(box):
    box = np.asarray(box, dtype=float)
    return np.diag(box) if box.ndim == 1 else box


def shifts_within(reach, d):
    """All of them, 0 first."""
    shifts = np.array(list(itertools.product(range(-reach, reach + 1), repeat=d)))
    return shifts[np.argsort(np.abs(shifts).sum(axis=1), kind="stable")]


def area_vector(p):
    """Of a polygon in 3D; in 2D the way from one end to the other, turned to the right."""
    if p.shape[1] == 2:
        way = p[1] - p[0]
        return np.array([way[1], -way[0]])
    return np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum(axis=0) / 2


def check_polytopes(dt, v):
    """The cells as polytopes are those of the diagram, with corners of their own."""
    p, d = dt.voronoi_polytopes(), dt.ndim
    assert isinstance(p, annulus.PeriodicPolytopes) and len(p) == dt.npoints
    assert "PeriodicPolytopes: " in repr(p) and p.side_shifts.dtype == np.int32
    assert len(p.side_neighbors) == len(p.side_shifts) == 2 * len(v.ridge_points) == p.side_indptr[-1]
    assert len(p.side_corners) == p.corner_indptr[-1]
    seen = np.zeros(len(p.corners), dtype=int)
    for i in range(dt.npoints):
        faces = p.faces(i)
        own = range(p.side_indptr[i], p.side_indptr[i + 1])
        expected = [*((j, *s) for (k, j), s in zip(v.ridge_points.tolist(), v.ridge_shifts.tolist()) if k == i),
                    *((k, *(-c for c in s)) for (k, j), s in zip(v.ridge_points.tolist(), v.ridge_shifts.tolist())
                      if j == i)]
        assert sorted((p.side_neighbors[s], *p.side_shifts[s]) for s in own) == sorted(expected)
        for face, theirs, s in zip(faces, v.faces(i), own):
            assert np.array_equal(face, theirs)
            way = v.points[p.side_neighbors[s]] - v.points[i] + p.side_shifts[s] @ v.box
            assert area_vector(face) @ way >= 0  # seen from outside
            middle = (face - v.points[i] - way / 2) @ way / np.linalg.norm(way)
            assert np.abs(middle).max() < 1e-9 * np.abs(v.box).sum()
        corners = {int(c) for s in own for c in p.side_corners[p.corner_indptr[s]:p.corner_indptr[s + 1]]}
        seen[list(corners)] += 1
        assert len(corners) == len(v.regions[i])
        if d == 2:
            assert np.array_equal(p.polygon(i), v.polygon(i))
    assert np.all(seen == 1)
    if d == 3 and dt.npoints:
        with pytest.raises(annulus.Error, match="polyhedra"):
            p.polygon(0)


def check(dt):
    """The arrays of a diagram agree with each other and with those of the triangulation."""
    v, d = dt.voronoi(), dt.ndim
    assert isinstance(v, annulus.PeriodicVoronoi)
    assert np.array_equal(v.points, dt.points, equal_nan=True) and np.array_equal(v.box, dt.box)
    i, j, distance, D, S, A = dt.neighbor_list("ijdDSA")
    once = np.array([area > 0 and (a, *[0] * d) <= (b, *s) for a, b, s, area in zip(i, j, S, A)], dtype=bool)
    assert np.array_equal(v.ridge_points, np.column_stack([i, j])[once])
    assert np.array_equal(v.ridge_shifts, S[once])
    assert np.array_equal(v.vectors, D[once]) and np.array_equal(v.distances, distance[once])
    assert np.allclose(v.areas, A[once], rtol=1e-9, atol=1e-11 * np.max(A, initial=0))
    there = dt.is_vertex
    assert np.allclose(v.volumes[there], dt.voronoi_volumes()[there], rtol=1e-9)
    assert np.all(np.isnan(v.volumes) == ~there) and np.all(np.isnan(v.centroids[:, 0]) == ~there)
    assert np.array_equal(v.point_region, np.where(there, np.arange(dt.npoints), -1))
    assert len(v.ridge_vertices) == len(v.ridge_vertex_shifts) == len(v.ridge_points)
    size = np.abs(v.box).sum()
    for k, (ring, shifts) in enumerate(zip(v.ridge_vertices, v.ridge_vertex_shifts)):
        corners = v.ridge_corners(k)
        assert np.array_equal(corners, v.vertices[ring] + shifts @ v.box)
        assert len(corners) == 2 if d == 2 else len(corners) >= 3
        assert len({(c, *s) for c, s in zip(ring, shifts.tolist())}) == len(ring)
        one = v.points[v.ridge_points[k, 0]]
        other = one + v.vectors[k]
        assert np.allclose(np.linalg.norm(corners - one, axis=1), np.linalg.norm(corners - other, axis=1), rtol=1e-9)
        assert abs(area_vector(corners) @ v.vectors[k] / v.distances[k] - v.areas[k]) < 1e-9 * size**(d - 1)
        assert np.all(v.ridge_centroids[k] >= corners.min(axis=0) - 1e-9 * size)
        assert np.all(v.ridge_centroids[k] <= corners.max(axis=0) + 1e-9 * size)
    assert len(v.regions) == len(v.region_shifts) == dt.npoints
    for p in range(dt.npoints):
        faces = v.faces(p)
        corners = v.vertices[v.regions[p]] + v.region_shifts[p] @ v.box if there[p] else np.empty((0, d))
        assert (len(faces) > 0) == there[p] == (len(v.regions[p]) > 0)
        if not there[p]:
            continue
        areas = np.array([area_vector(f) for f in faces])
        assert np.allclose(areas.sum(axis=0), 0, atol=1e-9 * size**(d - 1))  # closed
        pyramids = [(f.mean(axis=0) - v.points[p]) @ a / d for f, a in zip(faces, areas)]
        assert min(pyramids) > -1e-12 and abs(sum(pyramids) - v.volumes[p]) < 1e-9 * size**d
        assert np.linalg.norm(areas, axis=1).sum() == pytest.approx(v.surfaces[p], rel=1e-6)
        of_faces = np.concatenate(faces)
        assert np.all(np.abs(of_faces[:, None] - corners).max(axis=2).min(axis=1) < 1e-9 * size)
        if d == 2:
            assert np.array_equal(v.polygon(p), corners) and len(faces) == len(corners)
            x, y = corners.T
            assert (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2 == pytest.approx(v.volumes[p], rel=1e-6)
        else:
            edges = sum(len(f) for f in faces) // 2
            assert len(corners) - edges + len(faces) == 2  # Euler
    if dt.nvertices:
        assert v.volumes[there].sum() == pytest.approx(abs(np.linalg.det(dt.box)), rel=1e-9)
    check_polytopes(dt, v)
    assert f"<PeriodicVoronoi: {dt.nvertices} points, {len(v.ridge_points)} ridges in {d}D" in repr(v)
    return v


@pytest.mark.parametrize("d, k", [(d, k) for d in (2, 3) for k in range(len(BOXES[d]))])
@pytest.mark.parametrize("n", [1, 2, 3, 20])
def test_diagrams_are_polygons_that_close_after_whatever_changes(d, k, n):
    box, random = vectors_of(BOXES[d][k]), np.random.default_rng(100 * k + n)
    x = (5 * random.random((n, d)) - 2) @ box
    dt = annulus.MovingDelaunay(x, box=box)
    check(dt)
    dt.move(x + 0.05 * random.standard_normal((n, d)) @ box)
    check(dt)
    dt.move(dt.points, box=box + 0.1 * box[::-1] * random.random((d, d)))
    check(dt)
    dt.insert(random.random((2, d)) @ dt.box)
    dt.remove([n // 2, n])
    check(dt)


@pytest.mark.parametrize("basis, facets, vertices", CRYSTALS)
@pytest.mark.parametrize("k", [1, 2])
def test_crystals_have_their_facets_and_vertices_once_each(basis, facets, vertices, k):
    cells = np.stack(np.meshgrid(*[np.arange(k)] * 3), -1).reshape(-1, 1, 3)
    x = (basis + cells).reshape(-1, 3) + k * np.random.default_rng(k).integers(-3, 4, (len(basis) * k**3, 3))
    v = check(annulus.MovingDelaunay(x, box=[k, k, k]))
    assert len(v.ridge_points) * 2 == facets * len(x) and len(v.vertices) == vertices * k**3
    assert np.allclose(v.centroids, x, atol=1e-12)
    assert {len(r) for r in v.regions} == {8 if facets == 6 else 24 if facets == 14 else 14}


def facet_by_cuts(x, i, k):
    """The corners of the part of the bisector of points i and k that is nearest to these two: a line or a square, cut
    by the bisectors with all others."""
    normal, middle = x[k] - x[i], (x[k] + x[i]) / 2
    far = 10 * np.abs(x).max()
    if x.shape[1] == 2:
        across = np.array([-normal[1], normal[0]]) / np.linalg.norm(normal)
        polygon = np.array([middle - far * across, middle + far * across])
    else:
        one = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        one /= np.linalg.norm(one)
        two = np.cross(normal, one) / np.linalg.norm(normal)
        polygon = np.array([middle + far * (a * one + b * two) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))])
    for m in np.argsort(np.linalg.norm(x - x[i], axis=1)):
        if m in (i, k) or not len(polygon):
            continue
        # positive: nearer to i than to m
        side = (x[m] + x[i]) @ (x[m] - x[i]) / 2 - polygon @ (x[m] - x[i])
        kept = []
        count = len(polygon)
        for c in range(count if count > 2 else count - 1):
            e = (c + 1) % count
            if side[c] > 0:
                kept.append(polygon[c])
            if (side[c] > 0) != (side[e] > 0):
                kept.append(polygon[c] + side[c] / (side[c] - side[e]) * (polygon[e] - polygon[c]))
        if count == 2 and side[1] > 0:
            kept.append(polygon[1])
        polygon = np.array(kept)
    return polygon


@pytest.mark.parametrize("d, k", [(2, 0), (2, 1), (3, 0), (3, 1)])
def test_ridges_are_those_of_brute_force(d, k):
    box, reach = vectors_of(BOXES[d][k]), 2
    x = np.random.default_rng(d + k).random((4, d)) @ box
    v = annulus.MovingDelaunay(x, box=box).voronoi()
    shifts = shifts_within(reach, d)
    images = (v.points[None] + (shifts @ v.box)[:, None]).reshape(-1, d)
    known = {(*pair, *s): r for r, (pair, s) in enumerate(zip(v.ridge_points.tolist(), v.ridge_shifts.tolist()))}
    found = 0
    for i in range(4):
        for m in range(1, len(images)):
            j, s = m % 4, shifts[m // 4].tolist()
            if m == i or (i, *[0] * d) > (j, *s):
                continue
            corners = facet_by_cuts(images, i, m)
            area = np.linalg.norm(area_vector(corners)) if len(corners) >= d else 0.0
            if (i, j, *s) not in known:
                assert area < 1e-12
                continue
            r, found = known[(i, j, *s)], found + 1
            assert area == pytest.approx(v.areas[r], rel=1e-6, abs=1e-9)
            ours = v.ridge_corners(r)
            assert np.all(np.linalg.norm(ours[:, None] - corners, axis=2).min(axis=1) < 1e-7)
    assert found == len(known)


@pytest.mark.parametrize("d", [2, 3])
def test_cells_are_those_of_the_images_as_an_open_set(d):
    box = vectors_of(BOXES[d][1])
    x = np.random.default_rng(d).random((12, d)) @ box
    v = annulus.MovingDelaunay(x, box=box).voronoi()
    shifts = shifts_within(2, d)
    images = (v.points[None] + (shifts @ v.box)[:, None]).reshape(-1, d)
    open_ = annulus.MovingDelaunay(images).voronoi()
    assert np.allclose(v.volumes, open_.volumes[:12], rtol=1e-9)
    assert np.allclose(v.centroids, open_.centroids[:12]) and np.allclose(v.surfaces, open_.surfaces[:12])
    number = {(k % 12, *shifts[k // 12].tolist()): k for k in range(len(images))}
    for r, ((i, j), s) in enumerate(zip(v.ridge_points.tolist(), v.ridge_shifts.tolist())):
        m = number[(j, *s)]
        theirs = open_.vertices[open_.ridge_dict[min(i, m), max(i, m)]]
        ours = v.ridge_corners(r)
        assert len(ours) == len(theirs)
        assert np.all(np.linalg.norm(ours[:, None] - theirs, axis=2).min(axis=1) < 1e-9)
    for mine, by, theirs in zip(v.regions, v.region_shifts, open_.regions):
        ours, theirs = v.vertices[mine] + by @ v.box, open_.vertices[theirs]
        assert len(ours) == len(theirs)
        assert np.all(np.linalg.norm(ours[:, None] - theirs, axis=2).min(axis=1) < 1e-9)


def test_points_far_away_have_their_cells_around_them():
    x = np.random.default_rng(5).random((10, 2))
    away = x + np.random.default_rng(6).integers(-5, 6, (10, 2))
    near, far = (annulus.MovingDelaunay(p, box=[1, 1]).voronoi() for p in (x, away))
    for i in range(10):
        assert np.allclose(far.polygon(i) - away[i], near.polygon(i) - x[i], atol=1e-12)
    assert np.allclose(far.centroids - away, near.centroids - x, atol=1e-12)


@pytest.mark.parametrize("box", [None, [1, 1], [1, 1, 1]])
def test_lists_are_of_ints_as_scipys_are(box):
    dt = annulus.MovingDelaunay(np.random.default_rng(8).random((20, len(box or [1, 1]))), box=box)
    dt.remove([3, 7])
    v = dt.voronoi()
    for lists in (v.regions, v.ridge_vertices):
        assert {type(k) for part in lists for k in part} == {int} and json.loads(json.dumps(lists)) == lists
    assert "18 points" in repr(v) and "18 vertices" in repr(dt)


def test_errors_and_nothing():
    v = annulus.MovingDelaunay(np.array([[0.5, 0.25, 0.125]]), box=[1, 1, 1]).voronoi()
    for call, code in ((lambda: v.polygon(0), "usage"), (lambda: v.faces(1), "unknown_vertex"),
                       (lambda: v.faces(-1), "unknown_vertex"), (lambda: v.ridge_corners(3), "usage")):
        with pytest.raises(annulus.Error) as e:
            call()
        assert e.value.code == code
    dt = annulus.MovingDelaunay(np.empty((0, 2)), box=[1, 1])
    v = check(dt)
    assert v.regions == [] == v.ridge_vertices and v.vertices.shape == (0, 2)
    dt.insert([[0.5, 0.5]])
    v = check(dt)
    assert v.polygon(0).shape == (4, 2)
    dt.remove([0])
    v = check(dt)
    assert v.regions == [[]] and v.polygon(0).shape == (0, 2) and v.faces(0) == []


@pytest.mark.parametrize("box", [[1e-20, 1], [1, 1e-20], [3.4e-36, 1], [[1e-17, 0], [.3e-17, 1]]])
def test_cells_of_boxes_that_are_thin_along_an_axis(box):
    basis = np.diag(box) if np.ndim(box) == 1 else np.array(box)
    for points in ([[0.0, 0.0]], [[0.0, 0.0], [.3, .5]], [[.1, .2], [.4, .9], [.8, .3]]):
        diagram = annulus.MovingDelaunay(np.array(points) @ basis, box=box).voronoi()
        for i, volume in enumerate(diagram.volumes):
            corners = diagram.polygon(i) @ np.linalg.inv(basis)
            x, y = corners.T
            area = (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
            assert area == pytest.approx(volume / abs(np.linalg.det(basis)), rel=1e-9)
