# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams, neighbours, their changes, gradients and nearest vertices: beside SciPy, beside what follows from
the simplices, and beside finite differences. `tests/measure/voronoi_diagram_test.cpp` has rational numbers."""

import itertools
import pickle
import threading

import annulus
import numpy as np
import pytest
import scipy.sparse
import scipy.spatial

from support import STRATEGIES


def lattice(kind, side=5):
    """Points, and the number of the one in the middle."""
    d = 2 if kind == "square" else 3
    base = np.array(list(itertools.product(range(side), repeat=d)), dtype=float)
    shifts = {"square": [[0, 0]], "cubic": [[0, 0, 0]], "bcc": [[0, 0, 0], [.5, .5, .5]],
              "fcc": [[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]]}[kind]
    x = np.concatenate([base + s for s in shifts])
    return x, int(np.argmin(np.sum((x - side // 2) ** 2, axis=1)))


def pairs_of(simplices):
    return {tuple(sorted(pair)) for row in simplices.tolist() for pair in itertools.combinations(row, 2)}


@pytest.mark.parametrize("d", [2, 3])
def test_names_of_scipy(d):
    x = np.random.default_rng(d).random((150, d))
    ours, theirs = annulus.MovingDelaunay(x).voronoi(), scipy.spatial.Voronoi(x)
    assert np.array_equal(ours.points, theirs.points)
    pairs = set(map(tuple, ours.ridge_points.tolist()))
    more = pairs - {tuple(sorted(p)) for p in theirs.ridge_points.tolist()}
    assert len(pairs) - len(more) == len(theirs.ridge_points)
    # Qhull leaves out ridges in 3D that have one corner and two rays.
    assert all(d == 3 and len(ours.ridge_dict[pair]) == 2 and ours.ridge_dict[pair][0] == -1 for pair in more)
    near = scipy.spatial.cKDTree(theirs.vertices).query(ours.vertices)
    assert len(ours.vertices) == len(theirs.vertices) and len(set(near[1])) == len(near[1])
    assert np.all(near[0] <= 1e-9 * (1 + np.abs(ours.vertices).max(axis=1)))
    number = np.append(near[1], -1)
    rings = {tuple(sorted(p)): ring for p, ring in theirs.ridge_dict.items()}
    for pair in pairs - more:
        assert sorted(number[ours.ridge_dict[pair]]) == sorted(rings[pair])
    regions = [theirs.regions[k] for k in theirs.point_region]
    assert list(ours.point_region) == list(range(150))
    for mine, other in zip(ours.regions, regions):
        assert sorted(number[mine]) == sorted(other)
    assert "150 points" in repr(ours)
    if d == 2:
        figure = pytest.importorskip("matplotlib.figure")
        axes = figure.Figure().add_subplot()
        assert scipy.spatial.voronoi_plot_2d(ours, ax=axes) is axes.figure


@pytest.mark.parametrize("d", [2, 3])
def test_ridges_are_polygons(d):
    """Areas, centroids and volumes follow from the vertices in the order of `ridge_vertices` and `regions`."""
    v = annulus.MovingDelaunay(np.random.default_rng(10 + d).random((200, d))).voronoi()
    for (i, j), ring, area, middle, distance in zip(v.ridge_points, v.ridge_vertices, v.areas, v.ridge_centroids,
                                                    v.distances):
        e = v.points[j] - v.points[i]
        assert distance == pytest.approx(np.linalg.norm(e))
        assert (-1 in ring) == np.isinf(area) == np.isnan(middle[0]) and -1 not in ring[1:]
        if -1 in ring:
            continue
        p = v.vertices[ring]
        if d == 2:
            assert len(ring) == 2 and area == pytest.approx(np.linalg.norm(p[1] - p[0]))
            assert middle == pytest.approx(p.mean(axis=0))
            continue
        parts = np.cross(p[1:-1] - p[0], p[2:] - p[0]) @ e / distance / 2
        assert area == pytest.approx(parts.sum(), rel=1e-6)
        assert middle == pytest.approx(parts @ (p[0] + p[1:-1] + p[2:]) / 3 / parts.sum(), abs=1e-6)
    surface = np.zeros(200)
    for column in (0, 1):
        np.add.at(surface, v.ridge_points[:, column], v.areas)
    assert v.surfaces == pytest.approx(surface)
    finite = np.isfinite(v.volumes)
    assert finite.sum() > 50 and np.array_equal(np.isnan(v.centroids[:, 0]), ~finite)
    assert v.volumes == pytest.approx(annulus.MovingDelaunay(v.points).voronoi_volumes(), rel=2**-31)
    if d == 2:
        for k, region in enumerate(v.regions):
            assert (region[0] == -1 and -1 not in region[1:]) if not finite[k] else -1 not in region
            if finite[k]:
                p, q = v.vertices[region], np.roll(v.vertices[region], -1, axis=0)
                turn = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
                assert v.volumes[k] == pytest.approx(turn.sum() / 2, rel=1e-6)
                assert v.centroids[k] == pytest.approx(turn @ (p + q) / 3 / turn.sum(), abs=1e-6)


@pytest.mark.parametrize("kind, strict, facets", [("square", 4, 9), ("cubic", 6, 27), ("bcc", 14, 65),
                                                  ("fcc", 12, 108)])
def test_lattices(kind, strict, facets):
    """Neighbours that share a facet, as every textbook has them, whatever diagonals the triangulation has."""
    x, middle = lattice(kind)
    dt = annulus.MovingDelaunay(x)
    assert dt.neighbor_counts()[middle] == strict <= dt.neighbor_counts(strict=False)[middle]
    assert np.array_equal(dt.neighbor_counts(strict=False), np.diff(dt.vertex_neighbor_vertices[0]))
    i, j, area = dt.neighbor_list("ijA")
    assert np.sum((i == middle) & (area > 0)) == strict
    v = dt.voronoi()
    assert v.volumes[middle] == pytest.approx(1 / {"square": 1, "cubic": 1, "bcc": 2, "fcc": 4}[kind])
    assert v.centroids[middle] == pytest.approx(x[middle])
    assert sum(len(r) for (a, b), r in v.ridge_dict.items() if middle in (a, b)) == {"square": 8, "cubic": 24,
                                                                                   "bcc": 72, "fcc": 48}[kind]
    # Facets that noise makes are small, not empty.
    noisy = annulus.MovingDelaunay(x + 1e-10 * np.random.default_rng(0).standard_normal(x.shape))
    assert np.array_equal(noisy.neighbor_counts(), noisy.neighbor_counts(strict=False))
    assert noisy.neighbor_counts(min_area=1e-6)[middle] == strict
    assert dt.neighbor_counts(min_area=1e-6, strict=False)[middle] == strict


@pytest.mark.parametrize("d", [2, 3])
def test_neighbor_list(d):
    dt = annulus.MovingDelaunay(np.random.default_rng(20 + d).random((100, d)))
    dt.remove([3])
    i, j, distance, vector, shift, area = dt.neighbor_list("ijdDSA")
    indptr, indices = dt.vertex_neighbor_vertices
    assert np.array_equal(i, np.repeat(np.arange(100), np.diff(indptr))) and np.array_equal(j, indices)
    assert np.array_equal(vector, dt.points[j] - dt.points[i])
    assert distance == pytest.approx(np.linalg.norm(vector, axis=1)) and not shift.any() and shift.shape == (len(i), d)
    assert np.array_equal(dt.neighbor_list("j"), j) and dt.neighbor_list("Di")[1].tolist() == i.tolist()
    assert set(map(tuple, dt.edges.tolist())) == pairs_of(dt.simplices) and len(dt.edges) == len(i) / 2
    sums = np.zeros(100)
    np.add.at(sums, i, area * distance / (2 * d))
    volumes = dt.voronoi_volumes()
    assert np.isnan(volumes[3]) and sums[3] == 0
    assert np.delete(sums, 3) == pytest.approx(np.delete(volumes, 3), rel=2**-31)


@pytest.mark.parametrize("strategy", STRATEGIES)
@pytest.mark.parametrize("d", [2, 3])
def test_changes_of_edges(strategy, d):
    rng = np.random.default_rng(d)
    x = rng.random((100, d))
    dt = annulus.MovingDelaunay(x, strategy)
    seen = 0
    for step in (1e-3, 0.01, 0.03, 0.3, 0.02, 0.02):
        before, triangles = pairs_of(dt.simplices), {tuple(sorted(t)) for t in dt.simplices.tolist()}
        x = x + step * rng.standard_normal(x.shape)
        report = pickle.loads(pickle.dumps(dt.move(x)))
        now = pairs_of(dt.simplices)
        assert list(map(tuple, report.edges_made.tolist())) == sorted(now - before)
        assert list(map(tuple, report.edges_broken.tolist())) == sorted(before - now)
        if d == 3:
            continue
        after = {tuple(sorted(t)) for t in dt.simplices.tolist()}
        events = annulus.t1(report)
        seen += len(events)
        for i, j, k, lowest in events.tolist():
            assert (i, j) in before - now and (k, lowest) in now - before
            assert {tuple(sorted(t)) for t in ((i, j, k), (i, j, lowest))} <= triangles - after
            assert {tuple(sorted(t)) for t in ((k, lowest, i), (k, lowest, j))} <= after - triangles
    assert seen > 0 or d == 3


def test_one_flip():
    x = np.array([[0, 0], [1, -0.4], [2, 0], [1, 0.5]])
    dt = annulus.MovingDelaunay(x)
    assert (1, 3) in pairs_of(dt.simplices)
    report = dt.move(x * [0.3, 3])
    assert annulus.t1(report).tolist() == [[1, 3, 0, 2]]
    assert report.edges_made.tolist() == [[0, 2]] and report.edges_broken.tolist() == [[1, 3]]
    silent = annulus.MovingDelaunay(x, report_changes=False).move(x * [0.3, 3])
    for name in ("edges_made", "edges_broken"):
        with pytest.raises(annulus.Error, match="report_changes=True"):
            getattr(silent, name)
    for wrong in (silent, annulus.MovingDelaunay(np.eye(3)).move(np.eye(3))):
        with pytest.raises(annulus.Error, match="2D|report_changes=True"):
            annulus.t1(wrong)


@pytest.mark.parametrize("d", [2, 3])
def test_flat_sets_change_edges_too(d):
    x = np.zeros((5, d))
    x[:, 0] = [0, 1, 2, 3, 4]
    dt = annulus.MovingDelaunay(x)
    x[[1, 2], 0] = [2, 1]
    report = dt.move(x)
    assert report.edges_made.tolist() == [[0, 2], [1, 3]] and report.edges_broken.tolist() == [[0, 1], [2, 3]]
    assert np.isinf(dt.voronoi().areas).all() and dt.voronoi().ridge_vertices == [[]] * 4
    assert dt.voronoi_volumes(clip=[[-1] * d, [5] * d]).sum() == pytest.approx(6**d)


@pytest.mark.parametrize("points", ["random", "lattice"])
@pytest.mark.parametrize("d", [2, 3])
def test_gradients(d, points):
    rng = np.random.default_rng(30 + d)
    x = rng.random((120, d)) if points == "random" else lattice("square" if d == 2 else "fcc", 6 if d == 2 else 4)[0]
    dt = annulus.MovingDelaunay(x)
    dt.remove([7])
    finite = np.isfinite(dt.voronoi_volumes())
    g = rng.standard_normal(len(x))
    gradient = dt.voronoi_vjp(g)
    assert gradient.shape == x.shape and np.all(gradient[7] == 0)
    indptr, indices, values = dt.voronoi_jacobian()
    assert np.array_equal(np.diff(indptr) > 0, finite)
    for axis in range(d):
        matrix = scipy.sparse.csr_matrix((values[:, axis], indices, indptr), (len(x), len(x)))
        assert matrix.T @ np.where(finite, g, 0) == pytest.approx(gradient[:, axis], abs=1e-12)
    h = 1e-6 if points == "random" else 1e-8  # volumes have no second derivative where points are cospherical
    for k in rng.choice(np.flatnonzero(finite), 12):
        for axis in range(d):
            sums = []
            for sign in (1, -1):
                moved = x.copy()
                moved[k, axis] += sign * h
                other = annulus.MovingDelaunay(moved)
                other.remove([7])
                sums.append(np.sum(other.voronoi_volumes()[finite] * g[finite]))
            assert gradient[k, axis] == pytest.approx((sums[0] - sums[1]) / (2 * h), abs=1e-6)


def test_gradients_while_points_move():
    """A descent to equal areas: each step goes down."""
    rng = np.random.default_rng(5)
    dt = annulus.MovingDelaunay(rng.random((300, 2)))
    inner = np.all(np.abs(dt.points - 0.5) < 0.3, axis=1)
    target = dt.voronoi_volumes()[inner].mean()
    energies = []
    for _ in range(30):
        g = np.where(inner, dt.voronoi_volumes() - target, 0)
        energies.append(np.sum(g**2) / 2)
        dt.move(dt.points - 5 * np.where(inner[:, None], dt.voronoi_vjp(g), 0))
    assert energies[-1] < 0.4 * energies[0] and all(b < a for a, b in zip(energies, energies[1:]))


@pytest.mark.parametrize("d", [2, 3])
def test_clips(d):
    rng = np.random.default_rng(40 + d)
    x = rng.random((80, d))
    dt = annulus.MovingDelaunay(x)
    box = np.array([[0.1] * d, [0.9] * d])
    v = dt.voronoi(clip=box)
    assert v.volumes.sum() == pytest.approx(0.8**d, rel=1e-12) and np.isfinite(v.areas).all()
    assert np.array_equal(dt.voronoi_volumes(clip=box), v.volumes)
    faces = np.concatenate([np.column_stack([np.eye(d), np.full(d, -0.9)]),
                            np.column_stack([-np.eye(d), np.full(d, 0.1)])])
    assert dt.voronoi_volumes(clip=faces) == pytest.approx(v.volumes, abs=1e-14)
    if d == 2:
        corners = np.array([[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]])
        for polygon in (corners, corners[::-1]):
            assert dt.voronoi_volumes(clip=polygon) == pytest.approx(v.volumes, abs=1e-14)
        with pytest.raises(annulus.Error, match="convex"):
            dt.voronoi(clip=[[0, 0], [1, 0], [0.2, 0.2], [0, 1]])
    # Mirror images of the points at the faces of a box bound its cells by these faces.
    images = [x]
    for axis in range(d):
        for face in (0, 1):
            image = x.copy()
            image[:, axis] = 2 * face - x[:, axis]
            images.append(image)
    mirrored = annulus.MovingDelaunay(np.concatenate(images)).voronoi()
    mine = dt.voronoi(clip=[[0] * d, [1] * d])
    assert mine.volumes == pytest.approx(mirrored.volumes[:80], rel=1e-9)
    assert mine.surfaces == pytest.approx(mirrored.surfaces[:80], rel=1e-9)
    assert mine.centroids == pytest.approx(mirrored.centroids[:80], abs=1e-9)
    i, j, area = dt.neighbor_list("ijA", clip=box)
    assert np.isfinite(area).all() and dt.neighbor_counts(clip=box, min_area=1e-12).sum() == np.sum(area > 1e-12)
    for wrong, code, what in ((box[::-1], "bad_input", "no interior"), (box * np.nan, "not_finite", "not finite"),
                              ([1.0, 2.0], "wrong_size", rf"shape \(2, {d}\)"), (faces[:d], "bad_input", "not bound"),
                              (np.eye(2, 5 - d), *(("bad_input", "in 3D") if d == 2 else ("wrong_size", "a box")))):
        with pytest.raises(annulus.Error, match=what) as e:
            dt.voronoi(clip=wrong)
        assert e.value.code == code


@pytest.mark.parametrize("clip", ["box", "half-spaces"])
@pytest.mark.parametrize("d", [2, 3])
def test_polytopes(d, clip):
    """Closed cells with the volumes and areas of the clipped diagram, whose neighbours are beyond their sides."""
    x = np.random.default_rng(d).random((60, d))
    dt = annulus.MovingDelaunay(x)
    dt.remove([7])
    clip = {"box": [[0.1] * d, [0.9] * d],
            "half-spaces": np.vstack([np.eye(d + 1)[:d] - 0.9 * np.eye(d + 1)[d], [-1] * d + [0.4]])}[clip]
    cells, diagram = dt.voronoi_polytopes(clip), dt.voronoi(clip)
    areas = {(i, j): area for (i, j), area in zip(diagram.ridge_points.tolist(), diagram.areas)}
    assert len(cells) == 60 and repr(cells).startswith("<VoronoiPolytopes: 60 cells") and cells.faces(7) == []
    total = 0.0
    for i in range(60):
        faces = cells.faces(i)
        beyond = cells.side_neighbors[cells.side_indptr[i]:cells.side_indptr[i + 1]].tolist()
        assert len(faces) == len(beyond) and set(beyond) <= set(range(60)) - {7, i} | {-1}
        volume, ends = 0.0, {}
        for face, j in zip(faces, beyond):
            if d == 2:
                area = np.linalg.norm(face[1] - face[0])
                volume += np.linalg.det(face) / 2
                ends[tuple(face[0])] = ends.get(tuple(face[0]), 0) + 1
                ends[tuple(face[1])] = ends.get(tuple(face[1]), 0) - 1
            else:
                normal = sum(np.cross(p - face[0], q - face[0]) for p, q in zip(face[1:], face[2:])) / 2
                area = np.linalg.norm(normal)
                volume += normal @ face.mean(axis=0) / 3 if area > 1e-12 else 0
                for p, q in zip(face, np.roll(face, -1, axis=0)):
                    ends[tuple(p), tuple(q)] = ends.get((tuple(p), tuple(q)), 0) + 1
                    ends[tuple(q), tuple(p)] = ends.get((tuple(q), tuple(p)), 0) - 1
            if j >= 0:
                assert abs(areas.get((min(i, j), max(i, j)), 0) - area) < 1e-12
                # On the bisector.
                assert np.allclose(np.sum((face - x[i]) ** 2, axis=1), np.sum((face - x[j]) ** 2, axis=1), atol=1e-12)
        assert not any(ends.values())  # each edge once in each direction: closed
        assert (volume > 0 or not faces) and abs(volume - (diagram.volumes[i] if i != 7 else 0)) < 1e-12
        total += volume
        if d == 2:
            polygon = cells.polygon(i)
            assert np.array_equal(polygon, np.array([face[0] for face in faces]).reshape(-1, 2))
            assert all(np.array_equal(a[1], b[0]) for a, b in zip(faces, faces[1:] + faces[:1]))
    assert abs(total - np.nansum(diagram.volumes)) < 1e-11
    for i in (-1, 60):
        with pytest.raises(annulus.Error) as caught:
            cells.faces(i)
        assert caught.value.code == "unknown_vertex"
    with pytest.raises(TypeError):
        cells.faces(1.5)
    with pytest.raises(annulus.Error, match="clip must be given"):
        dt.voronoi_polytopes(None)
    if d == 3:
        with pytest.raises(annulus.Error, match="faces"):
            cells.polygon(0)


def test_polytopes_of_few_points_and_of_lattices():
    square = [[0, 0], [1, 1]]
    for points, areas in (([[0.5, 0.5]], [1]), ([[3e40, -2.0]], [1]), ([[0.25, 0.5], [0.75, 0.5]], [0.5, 0.5]),
                          ([[0.5, 0.5], [0.5, 9.0]], [1, 0]), (np.zeros((0, 2)), [])):
        cells = annulus.MovingDelaunay(points).voronoi_polytopes(square)
        polygons = [cells.polygon(i) for i in range(len(points))]
        found = [0.5 * np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]) for p in polygons]
        assert np.allclose(found, areas, atol=1e-15)
    assert cells.corners.shape == (0, 2) and len(cells) == 0
    x, middle = lattice("cubic")
    cells = annulus.MovingDelaunay(x).voronoi_polytopes([[-1] * 3, [5] * 3])
    areas = {}
    beyond = cells.side_neighbors[cells.side_indptr[middle]:cells.side_indptr[middle + 1]]
    for face, j in zip(cells.faces(middle), beyond):
        normal = sum(np.cross(p - face[0], q - face[0]) for p, q in zip(face[1:], face[2:])) / 2
        areas[j] = areas.get(j, 0) + np.linalg.norm(normal)
    assert sorted(np.round(list(areas.values()), 9))[-6:] == [1] * 6 and abs(sum(areas.values()) - 6) < 1e-9


@pytest.mark.parametrize("d", [2, 3])
def test_nearest_vertices(d):
    rng = np.random.default_rng(50 + d)
    x = rng.random((300, d))
    dt = annulus.MovingDelaunay(x)
    dt.remove([0, 8])
    queries = np.concatenate([rng.uniform(-1, 2, (200, d)), x[:20], (x[20:30] + x[30:40]) / 2])
    distances = np.linalg.norm(queries[:, None] - dt.points[None], axis=2)
    found = dt.nearest_vertex(queries)
    assert found.dtype == np.int32 and np.array_equal(found, np.nanargmin(distances, axis=1))
    assert dt.nearest_vertex(queries.reshape(2, -1, d)).shape == (2, len(queries) // 2)
    assert dt.nearest_vertex(x[5]) == 5
    grid, _ = lattice("square" if d == 2 else "cubic", 4)
    middle = annulus.MovingDelaunay(grid).nearest_vertex(np.full(d, 1.5) + 1e-16 * np.arange(d))
    assert np.abs(grid[middle] - 1.5).max() == 0.5
    line = np.zeros((4, d))
    line[:, 0] = [0, 1, 2, 3]
    assert annulus.MovingDelaunay(line).nearest_vertex(np.full(d, 1.8)) == 2
    for wrong, code in ((np.full(d, np.nan), "not_finite"), ([1.0], "wrong_size")):
        with pytest.raises(annulus.Error) as e:
            dt.nearest_vertex(wrong)
        assert e.value.code == code
    with pytest.raises(annulus.Error, match="no vertex"):
        annulus.MovingDelaunay(np.empty((0, d))).nearest_vertex(np.zeros(d))


@pytest.mark.parametrize("points", ["random", "lattice"])
@pytest.mark.parametrize("d", [2, 3])
def test_interpolation(d, points):
    rng = np.random.default_rng(60 + d)
    x = rng.random((100, d)) if points == "random" else lattice("square" if d == 2 else "cubic", 4)[0]
    dt = annulus.MovingDelaunay(x)
    dt.remove([2])
    inside = np.concatenate([rng.uniform(x.min(axis=0), x.max(axis=0), (60, d)), x[30:33],
                             np.full((1, d), 1.5 if points == "lattice" else 0.5)])
    inside = inside[dt.find_simplex(inside) >= 0]
    matrix = rng.standard_normal((d, 2))
    values = x @ matrix + [1, 2]
    values[2] = np.nan
    found = dt.interpolate(values, inside)
    kept = np.isfinite(found[:, 0])
    assert kept.sum() > 20 and found[kept] == pytest.approx((inside @ matrix + [1, 2])[kept], abs=1e-9)
    assert found.shape == (len(inside), 2) and dt.interpolate(values[:, 0], inside[0]).shape == ()
    # The weights of a position are those of the facets that it would have as a point.
    for q in inside[kept][:8]:
        if np.any(np.all(x == q, axis=1)):
            continue
        other = annulus.MovingDelaunay(dt.points[dt.is_vertex])
        new = other.insert([q])[0]
        i, j, distance, area = other.neighbor_list("ijdA")
        mine = i == new
        weights = (area / distance)[mine] / np.sum((area / distance)[mine])
        squares = np.sum(other.points**2, axis=1)
        expected = weights @ squares[j[mine]]
        assert dt.interpolate(np.sum(np.nan_to_num(x)**2, axis=1), q) == pytest.approx(expected, abs=1e-9)
    assert np.isnan(dt.interpolate(values, np.full((2, d), 9.0))).all()
    for wrong, code in ((lambda: dt.interpolate(values[1:], inside), "wrong_size"),
                        (lambda: dt.interpolate(values, [1.0]), "wrong_size")):
        with pytest.raises(annulus.Error) as e:
            wrong()
        assert e.value.code == code


def test_few_points():
    for d in (2, 3):
        for n in (0, 1, 2):
            dt = annulus.MovingDelaunay(np.arange(n * d, dtype=float).reshape(n, d))
            v = dt.voronoi()
            assert len(v.ridge_points) == max(0, n - 1) and len(v.regions) == n and np.isinf(v.volumes).all()
            assert np.all(dt.voronoi_vjp(np.ones(n)) == 0) and len(dt.voronoi_jacobian()[1]) == 0
            if n > 0:
                assert dt.voronoi_volumes(clip=[[0] * d, [1] * d]).sum() == pytest.approx(1)


def test_what_is_refused():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((20, 2)))
    for call, code in ((lambda: dt.neighbor_list("ijx"), "usage"), (lambda: dt.neighbor_list(""), "usage"),
                       (lambda: dt.neighbor_counts(min_area=-1), "usage"),
                       (lambda: dt.voronoi_vjp(np.ones(19)), "wrong_size"),
                       (lambda: dt.voronoi_vjp(np.ones((20, 1))), "wrong_size")):
        with pytest.raises(annulus.Error) as e:
            call()
        assert e.value.code == code
    for call in (lambda: dt.neighbor_list(3), lambda: dt.neighbor_counts(strict=2), lambda: dt.voronoi_vjp(["a"] * 20)):
        with pytest.raises(TypeError):
            call()


def test_regions_of_flat_hull_triangles():
    """The widest angle around a point is not always towards infinity."""
    x = [[-2, 0], [0, 0], [2, 0], [-1, 0.01], [1, 0.01], [0, 60.0]]
    assert annulus.MovingDelaunay(x).voronoi().regions[1] == [-1, 1, 4, 3, 0]


@pytest.mark.parametrize("scale, offset", [(1e-5, 5e6), (1e-6, 1e6), (1e-2, 4e8), (1, 1e10), (1e150, 0), (1e-150, 0)])
def test_polygons_far_away_and_in_any_unit(scale, offset):
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    x = np.random.default_rng(0).random((50, 2)) * scale + offset
    dt = annulus.MovingDelaunay(x, merge_duplicates=True)
    area = np.nansum(dt.voronoi_volumes(clip=square * scale + offset)) / scale / scale
    assert abs(area - 1) < 2e-16 * (1 + offset / scale) * 20 + 1e-12


def test_polygons_have_to_be_convex():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((50, 2)))
    star = [(0.5 + 0.4 * np.cos(4 * np.pi * k / 5), 0.5 + 0.4 * np.sin(4 * np.pi * k / 5)) for k in range(5)]
    for wrong in ([[0, 0], [1, 0], [1, 0.5], [0.5, 0.5], [0.5, 0.5], [0.5, 1], [0, 1]], star, [[0, 0], [1, 0], [0, 0]],
                  [[0, 0], [1, 0], [0.5, 0]], [[0, 0]] * 4):
        with pytest.raises(annulus.Error, match="convex polygon"):
            dt.voronoi_volumes(clip=wrong)
    corner = np.array([[0.1, 0.2], [0.9, 0.3], [0.4, 0.93]])
    on_edges = np.concatenate([corner[i] + (corner[(i + 1) % 3] - corner[i]) * k / 10 for i in range(3)
                               for k in range(10)]).reshape(-1, 2)
    for clip in (on_edges, on_edges[::-1]):
        assert abs(np.nansum(dt.voronoi_volumes(clip=clip)) - 0.277) < 1e-12


@pytest.mark.parametrize("power", [-1065, -600, 0, 300, 500])
def test_polygons_of_any_size(power):
    """A triangle with edges 3, 4 and 5, of which subnormal coordinates and normals hold few digits."""
    corners = np.ldexp([[1.0, 1], [4, 1], [1, 5]], power)
    v = annulus.MovingDelaunay(corners[:1]).voronoi(clip=corners)
    assert v.surfaces[0] == pytest.approx(np.ldexp(12.0, power), rel=1e-12)
    normals = np.array([[-1.0, 0], [0, -1], [4, 3]])
    for length in (-1070, 0, 1020):
        if -1070 <= length + power < 1019:
            rows = np.column_stack([np.ldexp(normals, length), -np.ldexp([-1.0, -1, 19], length + power)])
            v = annulus.MovingDelaunay(corners[:1]).voronoi(clip=rows)
            assert v.surfaces[0] == pytest.approx(np.ldexp(12.0, power), rel=1e-12)


def test_points_and_measures_are_of_one_moment(monkeypatch):
    """As beside a thread that inserts before the one call that takes the lock, and moves after it."""
    rng = np.random.default_rng(0)
    dt = annulus.MovingDelaunay(rng.random((40, 2)))
    inner = annulus._core.voronoi

    def beside(mesh, *rest):
        dt.insert([[0.5, 0.5]])
        dt.remove([3])
        dt.remove([4])
        parts = inner(mesh, *rest)
        moved.append(dt.points)
        dt.move(1 + rng.random((41, 2)))
        dt.insert([[0.25, 0.25], [0.75, 0.75]])
        return parts

    moved = []
    monkeypatch.setattr(annulus._core, "voronoi", beside)
    v = dt.voronoi()
    assert np.array_equal(v.points, moved[0], equal_nan=True) and v.points.shape == (41, 2)
    assert len(v.volumes) == len(v.regions) == 41 and v.regions[3] == [] and v.point_region[3] == -1


def test_points_and_measures_beside_a_thread():
    rng = np.random.default_rng(1)
    dt = annulus.MovingDelaunay(rng.random((200, 2)))
    stop = threading.Event()

    def changes():
        while not stop.is_set():
            dt.remove(dt.insert(rng.random((20, 2))))

    thread = threading.Thread(target=changes)
    thread.start()
    try:
        for _ in range(30):
            v = dt.voronoi()
            assert len(v.regions) == len(v.points) == len(v.volumes)
            assert np.array_equal(np.isnan(v.points[:, 0]), np.isnan(v.volumes))
            assert v.distances == pytest.approx(np.linalg.norm(np.diff(v.points[v.ridge_points], axis=1)[:, 0], axis=1))
    finally:
        stop.set()
        thread.join()


@pytest.mark.parametrize("power", [-1000, -600, 300, 480])
@pytest.mark.parametrize("d", [2, 3])
def test_interpolation_in_any_unit(d, power):
    """Areas of facets may be too small for doubles, or too large, where weights are not."""
    rng = np.random.default_rng(70 + d)
    x = rng.random((60, d))
    queries = rng.uniform(0.3, 0.7, (20, d))
    values = rng.random(60)
    usual = annulus.MovingDelaunay(x).interpolate(values, queries)
    assert np.isfinite(usual).any()
    found = annulus.MovingDelaunay(np.ldexp(x, power)).interpolate(values, np.ldexp(queries, power))
    assert found == pytest.approx(usual, rel=1e-12, nan_ok=True)


def test_clipped_areas_are_as_far_off_as_their_angle_is_small():
    """Two points 1e-11 apart: sides of their cells nearly coincide."""
    v = annulus.MovingDelaunay([[0.3, 0.4], [0.3, 0.4 + 1e-11], [0.8, 0.5]]).voronoi(clip=[[0, 0], [1, 1]])
    (twins,) = np.flatnonzero(np.all(v.ridge_points == [0, 1], axis=1))
    sine = 1e-11 / 0.51 * 0.9
    others = np.arange(3) != twins
    assert v.volumes.sum() == pytest.approx(1, rel=1e-13)
    # From x = 0 to the bisector with the third point, which both cells share.
    assert v.areas[twins] == pytest.approx(0.55 + 0.1 * (0.45 - 0.4) / 0.5, abs=1e-9)
    length = np.hypot(1, 0.2)
    assert abs(v.areas[others].sum() - length) < 2 * 2**-46 * np.sqrt(2) / sine


def test_flat_sets_have_no_empty_facets():
    """A square lattice in a plane of 3D has 4 neighbours in the plane, and diagonals count besides."""
    x = np.column_stack([lattice("square")[0], np.zeros(25)])
    dt = annulus.MovingDelaunay(x)
    counts = dt.neighbor_counts()
    assert np.array_equal(counts, dt.neighbor_counts(strict=False)) and counts[12] > 4
    assert np.isinf(dt.neighbor_list("A")).all() and annulus.MovingDelaunay(x[:, :2]).neighbor_counts()[12] == 4
