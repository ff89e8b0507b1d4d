# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi volumes of moving points beside SciPy's, frame by frame.

    PYTHONPATH=build/release/python /usr/bin/python3 -m pytest python/tests/test_voronoi_volumes.py --frames 1000 -s

Ours are good to 2**-33. Qhull computes in doubles: far corners and those of slivers are less good there. So where the
two differ by more than 1e-9, rational numbers decide which is right.
"""

import pickle
from fractions import Fraction
from itertools import permutations

import annulus
import numpy as np
import pytest
import scipy.spatial

AGREE, OURS = 1e-9, 2.0**-33
POINTS = 150


def determinant(rows):
    if len(rows) == 2:
        return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
    (a, b, c), *others = rows
    minor = [[r[:k] + r[k + 1:] for r in others] for k in range(3)]
    return a * determinant(minor[0]) - b * determinant(minor[1]) + c * determinant(minor[2])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def circumcentre(points):
    """Of the origin and k points in d dimensions, in the space that they span: sum of l_i p_i with 2 p_j .
    sum = |p_j|^2, by Cramer's rule."""
    gram = [[2 * dot(p, q) for q in points] for p in points]
    squares = [dot(p, p) for p in points]
    if len(points) == 1:
        weights = [Fraction(1, 2)]
    else:
        whole = determinant(gram)
        weights = [determinant([row[:k] + [s] + row[k + 1:] for row, s in zip(gram, squares)]) / whole
                   for k in range(len(points))]
    return [sum(w * p[k] for w, p in zip(weights, points)) for k in range(len(points[0]))]


def exact_volume(x, simplices, v):
    """The Voronoi cell of v as a sum, with signs, of what lies between it and the centres of an edge, a triangle on
    it, and a tetrahedron on that."""
    d = x.shape[1]
    total = Fraction(0)
    for simplex in simplices[(simplices == v).any(axis=1)]:
        home = [Fraction(c) for c in x[v].tolist()]
        others = [[Fraction(c) - h for c, h in zip(x[w].tolist(), home)] for w in simplex if w != v]
        if determinant(others) < 0:
            others[0], others[1] = others[1], others[0]
        for order in permutations(range(d)):
            sign = np.linalg.det(np.eye(d)[list(order)])
            flag = [circumcentre([others[k] for k in order[:m]]) for m in range(1, d + 1)]
            total += round(sign) * determinant(flag)
    return total / (2 if d == 2 else 6)


def motion(frames, d, seed):
    """Random points that walk; every seventh frame they are all somewhere else."""
    rng = np.random.default_rng(seed)
    spacing = POINTS ** (-1 / d)
    for frame in range(frames):
        x = (rng.random((POINTS, d)) if frame % 7 == 0
             else x + 10.0 ** rng.uniform(-4, -0.5) * spacing * rng.standard_normal((POINTS, d)))
        yield x


@pytest.mark.parametrize("d", [2, 3])
def test_frames(d, request):
    frames = request.config.getoption("--frames")
    dt, cells, near, far = None, 0, 0.0, []
    for x in motion(frames, d, seed=d):
        if dt is None:
            dt = annulus.MovingDelaunay(x)
        else:
            dt.move(x)
        ours = dt.voronoi_volumes()
        voronoi = scipy.spatial.Voronoi(x)
        simplices = None
        for v in range(POINTS):
            region = voronoi.regions[voronoi.point_region[v]]
            assert np.isinf(ours[v]) == (-1 in region)
            if -1 in region:
                continue
            cells += 1
            theirs = scipy.spatial.ConvexHull(voronoi.vertices[region] - x[v]).volume
            difference = abs(ours[v] - theirs) / theirs
            if difference <= AGREE:
                near = max(near, difference)
                continue
            if simplices is None:
                simplices = scipy.spatial.Delaunay(x).simplices
            exact = exact_volume(x, simplices, v)
            far.append((float(abs(Fraction(theirs) - exact) / exact), float(abs(Fraction(ours[v]) - exact) / exact)))
            assert far[-1][1] <= OURS, (v, x)
    assert cells > 20 * frames and len(far) < cells / 100
    print(f"\n{d}D: {frames} frames of {POINTS} points, {cells} bounded cells. Within 1e-9 of SciPy's: "
          f"{cells - len(far)}, at most {near:.1e} from them. "
          f"Others: {len(far)}" + (f"; exact volumes say that ours are within {max(o for _, o in far):.1e} "
                                   f"and SciPy's off by {min(t for t, _ in far):.1e} to {max(t for t, _ in far):.1e}"
                                   if far else ""))


@pytest.mark.parametrize("d", [2, 3])
def test_exact_volumes_are_volumes(d):
    """The oracle itself: of a point in the middle of a lattice, and of one cell of many as Qhull has it."""
    grid = np.indices((3,) * d).reshape(d, -1).T + 1e-3 * np.random.default_rng(0).random((3**d, d))
    middle = (3**d - 1) // 2
    exact = exact_volume(grid, scipy.spatial.Delaunay(grid).simplices, middle)
    voronoi = scipy.spatial.Voronoi(grid)
    assert float(exact) == pytest.approx(scipy.spatial.ConvexHull(
        voronoi.vertices[voronoi.regions[voronoi.point_region[middle]]]).volume, rel=1e-9)
    assert float(exact) == pytest.approx(1, rel=1e-2)


@pytest.mark.parametrize("d", [2, 3])
def test_who_has_no_volume(d):
    dt = annulus.MovingDelaunay(np.random.default_rng(3).random((400, d)))
    dt.remove([5, 7])
    volumes = dt.voronoi_volumes()
    assert np.isnan(volumes[[5, 7]]).all() and np.isnan(volumes).sum() == 2
    hull = np.unique(dt.convex_hull)
    assert np.isinf(volumes[hull]).all() and np.isinf(volumes).sum() == len(hull)
    assert np.isinf(annulus.MovingDelaunay(np.arange(3 * d, dtype=float).reshape(3, d)).voronoi_volumes()).all()


def change(dt, rng):
    """One call that changes few cells or all: what it is and where to depends on rng and on where the vertices are."""
    spacing = POINTS ** (-1 / dt.ndim)
    living = np.flatnonzero(dt.is_vertex)
    some = rng.choice(living, rng.integers(1, 5), replace=False)
    what = rng.choice(["few", "few", "few named", "tiny", "all", "insert", "remove", "recompute_tolerances"])
    if what == "few":
        dt.move(dt.points[some] + 0.3 * spacing * rng.standard_normal((len(some), dt.ndim)), some)
    elif what == "few named":  # all are given, few move
        x = dt.points.copy()
        x[some] += 0.1 * spacing * rng.standard_normal((len(some), dt.ndim))
        dt.move(x)
    elif what in ("tiny", "all"):
        dt.move(dt.points + (1e-9 if what == "tiny" else 0.05) * spacing * rng.standard_normal(dt.points.shape))
    elif what == "insert":
        dt.insert(dt.points[some] + 0.3 * spacing * rng.standard_normal((len(some), dt.ndim)))
    elif what == "remove":
        dt.remove(some)
    else:
        dt.recompute_tolerances()
    return what


@pytest.mark.parametrize("strategy", ["auto", "tolerances", "tolerances-each", "relocate", "rebuild"])
@pytest.mark.parametrize("d", [2, 3])
def test_kept_volumes_equal_recomputed_ones(d, strategy):
    """Volumes requested after each call, beside those of an object that had the same calls and computes
    the first time: bit for bit. Those of an object that is made of the points, whose simplices have another order,
    differ in their last bits at most."""
    x = np.random.default_rng(d).random((POINTS, d))
    dt, rng, done = annulus.MovingDelaunay(x, strategy), np.random.default_rng(10 + d), set()
    dt.voronoi_volumes()
    for step in range(1, 37):
        done.add(str(change(dt, rng)))
        kept = dt.voronoi_volumes()
        assert kept.tobytes() == dt.voronoi_volumes().tobytes()
        if step % 4:
            continue
        fresh, again = annulus.MovingDelaunay(x, strategy), np.random.default_rng(10 + d)
        for _ in range(step):
            change(fresh, again)
        assert fresh.points.tobytes() == dt.points.tobytes()
        assert kept.tobytes() == fresh.voronoi_volumes().tobytes(), (step, strategy)
        other = annulus.MovingDelaunay(dt.points[dt.is_vertex]).voronoi_volumes()
        np.testing.assert_allclose(kept[dt.is_vertex], other, rtol=2 * OURS, atol=0)
        assert np.isnan(kept[~dt.is_vertex]).all()
    assert len(done) == 7


@pytest.mark.parametrize("d", [2, 3])
def test_kept_volumes_do_not_survive_a_pickle_or_a_failure(d):
    dt = annulus.MovingDelaunay(np.random.default_rng(5).random((POINTS, d)))
    before = dt.voronoi_volumes()
    before[:] = 0  # an array of the caller's
    other = pickle.loads(pickle.dumps(dt))
    other.move(other.points[:3] + 0.01, [0, 1, 2])
    with pytest.raises(annulus.Error):
        dt.move(dt.points[[4]], [3])  # where another is
    again = dt.voronoi_volumes()
    assert again.tobytes() == annulus.MovingDelaunay(dt.points).voronoi_volumes().tobytes()
    assert not np.array_equal(again, other.voronoi_volumes(), equal_nan=True)
