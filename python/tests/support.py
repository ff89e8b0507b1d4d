# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the package share: points, what must hold of any triangulation, how often to try."""

import itertools
import os
from pathlib import Path

import numpy as np
from hypothesis import HealthCheck, seed, settings

# What is drawn is drawn from this, the same every time; ANNULUS_TEST_SEED for other draws (tools/explore).
SEED = int(os.environ.get("ANNULUS_TEST_SEED")
           or (Path(__file__).resolve().parents[2] / "tests/seed").read_text(encoding="ascii"))
HANGING = 1800  # seconds: no call takes a hundredth of it, and a machine may be very busy
MULTIPLIER = float(os.environ.get("ANNULUS_TEST_MULTIPLIER", "1"))
STRATEGIES = ["auto", "rebuild", "relocate", "relocate-flips", "in-place", "tolerances", "tolerances-each", "paper",
              "paper-hybrid"]


def repeats(n):
    """A property that is tried n times, or as many times more as ANNULUS_TEST_MULTIPLIER says, with the cases of
    SEED."""
    chosen = settings(max_examples=max(1, round(n * MULTIPLIER)), deadline=None, database=None, print_blob=True,
                      suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
    return lambda test: seed(SEED)(chosen(test))


def points_of(kind, n, d, seed):
    """Points that differ, of a family: random ones, and such as have d + 2 nearly or exactly on one circle or
    sphere."""
    rng = np.random.default_rng(seed)
    if kind == "uniform":
        x = rng.random((n, d))
    elif kind == "far":
        x = rng.random((n, d)) + 1e6
    elif kind == "grid":
        x = rng.integers(0, 2 + round(n ** (1 / d)), (n, d)).astype(float)
    elif kind == "jittered":
        x = rng.integers(0, 2 + round(n ** (1 / d)), (n, d)) + 1e-9 * rng.standard_normal((n, d))
    elif kind == "sphere":
        x = rng.standard_normal((n, d))
        x /= np.linalg.norm(x, axis=1)[:, None]
    elif kind == "flat":
        x = rng.random((n, d)) * np.array([1.0] * (d - 1) + [1e-12])
    elif kind == "clusters":
        x = rng.integers(0, 3, (n, d)) + 1e-6 * rng.random((n, d))
    else:
        raise ValueError(kind)
    return np.unique(x, axis=0)


KINDS = ["uniform", "far", "grid", "jittered", "sphere", "flat", "clusters"]


def as_set(simplices):
    return {tuple(sorted(map(int, s))) for s in simplices}


def as_oriented_set(simplices):
    """Rows that are even permutations of one another are one simplex; odd ones are the one turned over."""

    def one(row):
        row = list(map(int, row))
        swaps = sum(a > b for k, b in enumerate(row) for a in row[:k])
        return swaps % 2, *sorted(row)

    return {one(row) for row in simplices}


def check(dt):
    """What holds whatever the points: exact audit, and arrays that say the same of one triangulation."""
    verdict = dt.audit()
    assert verdict, verdict
    simplices, neighbors, is_vertex = dt.simplices, dt.neighbors, dt.is_vertex
    d, n = dt.ndim, dt.npoints
    assert simplices.shape == neighbors.shape == (dt.nsimplex, d + 1) and simplices.dtype == neighbors.dtype == np.int32
    assert dt.points.shape == (n, d) and is_vertex.shape == (n,) and is_vertex.sum() == dt.nvertices
    assert np.array_equal(~is_vertex, np.isnan(dt.points).all(axis=1))
    for values in (dt.tolerances, dt.theta, dt.displacements):
        assert values.shape == (n,) and np.array_equal(np.isnan(values), ~is_vertex)
        assert (values[is_vertex] >= 0).all()
    full = dt.affine_dimension == d
    assert full == (len(simplices) > 0)

    facets = {}
    for s, cell in enumerate(simplices):
        for i in range(d + 1):
            facets.setdefault(frozenset(map(int, np.delete(cell, i))), []).append((s, i))
    outside = set()
    for facet, sides in facets.items():
        assert len(sides) <= 2
        if len(sides) == 1:
            (s, i), = sides
            assert neighbors[s, i] == -1
            outside.add(facet)
        else:
            (s, i), (t, k) = sides
            assert neighbors[s, i] == t and neighbors[t, k] == s
    assert {frozenset(map(int, f)) for f in dt.convex_hull} == outside and len(dt.convex_hull) == len(outside)

    edges = {i: set() for i in range(n)}
    for s in simplices if full else dt.flat_simplices:
        for v, w in itertools.permutations(map(int, s), 2):
            edges[v].add(w)
    indptr, indices = dt.vertex_neighbor_vertices
    assert indptr.shape == (n + 1,) and indptr[0] == 0 and indptr[-1] == len(indices)
    for v in range(n):
        assert indices[indptr[v]:indptr[v + 1]].tolist() == sorted(edges[v])

    of = dt.vertex_to_simplex
    assert of.shape == (n,)
    for v in range(n):
        assert of[v] == -1 if not full or not is_vertex[v] else v in simplices[of[v]]


def lattice(kind, side=5):
    """Points of a lattice, and the number of the one in the middle."""
    d = 2 if kind == "square" else 3
    base = np.array(list(itertools.product(range(side), repeat=d)), dtype=float)
    shifts = {"square": [[0, 0]], "cubic": [[0, 0, 0]], "bcc": [[0, 0, 0], [.5, .5, .5]],
              "fcc": [[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]]}[kind]
    x = np.concatenate([base + s for s in shifts])
    return x, int(np.argmin(np.sum((x - side // 2) ** 2, axis=1)))


def pairs_of(simplices):
    """The edges of simplices, as sorted pairs of indices."""
    return {tuple(sorted(pair)) for row in simplices.tolist() for pair in itertools.combinations(row, 2)}
