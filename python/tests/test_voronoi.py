# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi diagrams: beside SciPy, and beside what follows from their vertices.
`tests/measure/voronoi_diagram_test.cpp` has rational numbers."""

import threading

import annulus
import numpy as np
import pytest
import scipy.spatial

from support import lattice


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
