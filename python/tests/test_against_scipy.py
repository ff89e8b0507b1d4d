# SPDX-License-Identifier: GPL-3.0-or-later
"""MovingDelaunay beside scipy.spatial.Delaunay, on points that are built, moved, inserted and removed."""

from fractions import Fraction

import annulus
import numpy as np
import pytest
import scipy.spatial
from hypothesis import given
from hypothesis import strategies as st

from support import KINDS, as_set, check, points_of, repeats

# Qhull computes in doubles: where points are as good as cospherical, or flat, what it says is no verdict.
SURE = 1e-5


def sure(dt):
    """Whether d + 2 points are nowhere near to cospherical, and the hull nowhere flat, so that there is one
    triangulation and Qhull finds it."""
    vertices = dt.is_vertex
    if dt.affine_dimension < dt.ndim or not (dt.theta[vertices] > SURE).all():
        return False
    size = np.ptp(dt.points[vertices], axis=0).max()
    return bool((dt.tolerances[vertices] > 1e-7 * size).all())


def beside_scipy(dt):
    """Compares everything both have. True where they could be."""
    check(dt)
    if not sure(dt):
        return False
    kept = np.flatnonzero(dt.is_vertex)
    x = dt.points[kept]
    theirs = scipy.spatial.Delaunay(x - x[0])  # Qhull squares coordinates, in doubles
    assert as_set(dt.simplices) == as_set(kept[theirs.simplices])
    assert as_set(dt.convex_hull) == as_set(kept[theirs.convex_hull])
    indptr, indices = theirs.vertex_neighbor_vertices
    ours = dt.vertex_neighbor_vertices
    for k, v in enumerate(kept):
        assert set(kept[indices[indptr[k]:indptr[k + 1]]]) == set(ours[1][ours[0][v]:ours[0][v + 1]])
    return True


@repeats(150)
@given(st.sampled_from(KINDS), st.integers(1, 60), st.integers(2, 3), st.integers(0, 2**32))
def test_any_points(kind, n, d, seed):
    beside_scipy(annulus.MovingDelaunay(points_of(kind, n, d, seed)))


@pytest.mark.parametrize("d", [2, 3])
def test_uniform_points_can_be_compared(d):
    """So that the tests here say something."""
    compared = [beside_scipy(annulus.MovingDelaunay(points_of("uniform", 12, d, seed))) for seed in range(60)]
    assert sum(compared) > 20


@repeats(60)
@given(st.sampled_from(KINDS), st.integers(2, 3), st.sampled_from(["auto", "tolerances", "in-place"]), st.data())
def test_moves_insertions_and_removals(kind, d, strategy, data):
    dt = annulus.MovingDelaunay(points_of(kind, 40, d, data.draw(st.integers(0, 2**32))), strategy)
    rng = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    for what in data.draw(st.lists(st.sampled_from(["all", "some", "insert", "remove"]), max_size=6)):
        before = dt.points
        try:
            if what == "all":
                dt.move(before + rng.standard_normal(before.shape) * 10.0 ** rng.integers(-12, 0))
            elif what == "some" and dt.nvertices > 0:
                some = rng.choice(np.flatnonzero(dt.is_vertex), 3)
                dt.move(before[some] + 0.01 * rng.standard_normal((3, d)), indices=some)
            elif what == "insert":
                dt.insert(rng.random((3, d)))
            elif dt.nvertices > 3:
                dt.remove(rng.choice(np.flatnonzero(dt.is_vertex), 3, replace=False))
        except annulus.Error as e:
            assert e.code == "duplicate_point"
            assert np.array_equal(dt.points, before, equal_nan=True)
        beside_scipy(dt)


@pytest.mark.parametrize("d", [2, 3])
def test_a_long_way(d):
    rng = np.random.default_rng(7)
    x = rng.random((300, d))
    dt = annulus.MovingDelaunay(x)
    velocity = rng.standard_normal(x.shape)
    compared = 0
    for _ in range(40):
        x = x + 2e-3 * velocity
        dt.move(x)
        assert as_set(dt.simplices) == as_set(scipy.spatial.Delaunay(x).simplices) or not sure(dt)
        compared += sure(dt)
    check(dt)
    assert compared > 0


def contains(corners, p):
    """Whether p is in a positive simplex or on its border, exactly: put in the place of a corner it turns none of
    them over."""
    def det(m):
        return (m[0][0] if len(m) == 1 else sum((-1) ** k * m[0][k] * det([[*row[:k], *row[k + 1:]] for row in m[1:]])
                                                for k in range(len(m))))

    points = [[Fraction(c) for c in corner] for corner in corners.tolist()]
    query = [Fraction(c) for c in p.tolist()]
    for i in range(len(points)):
        first, *others = points[:i] + [query] + points[i + 1:]
        if det([[a - b for a, b in zip(q, first)] for q in others]) < 0:
            return False
    return True


@pytest.mark.parametrize("kind", ["uniform", "grid", "clusters"])
@pytest.mark.parametrize("d", [2, 3])
def test_find_simplex(kind, d):
    x = points_of(kind, 200, d, 5)
    dt = annulus.MovingDelaunay(x)
    rng = np.random.default_rng(6)
    queries = np.concatenate([x, rng.uniform(x.min() - 0.2, x.max() + 0.2, (300, d)), (x[1:] + x[:-1]) / 2])
    found = dt.find_simplex(queries)
    inside = scipy.spatial.Delaunay(x).find_simplex(queries) >= 0
    assert found.dtype == np.int32 and (found[:len(x)] >= 0).all()
    for p, s in zip(queries, found):
        assert s == -1 or contains(dt.points[dt.simplices[s]], p)
    assert ((found >= 0) == inside).mean() > 0.95  # SciPy has a tolerance at the hull, and none for what is flat
    assert dt.find_simplex(queries[0]).shape == () and dt.find_simplex(np.zeros((0, d))).shape == (0,)
    assert np.array_equal(dt.find_simplex(queries[:40].reshape(4, 10, d)).ravel(), found[:40])
    assert (dt.find_simplex(np.array([[np.nan] * d, [np.inf] * d, [1e300] * d])) == -1).all()


@pytest.mark.parametrize("d", [2, 3])
def test_orientation(d):
    dt = annulus.MovingDelaunay(points_of("uniform", 100, d, 1))
    corners = dt.points[dt.simplices]
    assert (np.linalg.det(corners[:, 1:] - corners[:, :1]) > 0).all()
    middle = dt.points.mean(axis=0)
    facets = dt.points[dt.convex_hull]
    # The middle is to the left of a facet in the plane, and behind it in space, where it is seen from outside.
    side = np.linalg.det(np.concatenate([facets[:, 1:] - facets[:, :1], (middle - facets[:, 0])[:, None]], axis=1))
    assert (side > 0).all() if d == 2 else (side < 0).all()
