# SPDX-License-Identifier: GPL-3.0-or-later
"""What a periodic box has of the lists and numbers of `MovingDelaunay`, beside brute force and the images as an open
set, and why the rest has no meaning there."""

import copy
import itertools
import pickle

import annulus
import numpy as np
import pytest

BOXES = {2: [[2, 1.5], [[1.5, 0], [0.5, 1.25]], [1, 0.05], [[1, 0], [3, 1]], [[0, 1], [1, 0]]],
         3: [[1, 1.5, 2], [[2, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]], [1, 0.3, 0.05],
             [[1, 0, 0], [0, 1, 0], [3, 0, 1]]]}
CASES = [(d, k, n) for d in (2, 3) for k in range(len(BOXES[d])) for n in (1, 2, 3, 10, 200)]


def vectors_of(box):
    box = np.asarray(box, dtype=float)
    return np.diag(box) if box.ndim == 1 else box


def pairs_of_simplices(dt):
    """All pairs (i, j, S) of corners of simplices, in both directions."""
    pairs = set()
    for s, o in zip(dt.simplices.tolist(), dt.simplex_offsets.astype(int)):
        for a, b in itertools.permutations(range(dt.ndim + 1), 2):
            pairs.add((s[a], s[b], *(o[b] - o[a]).tolist()))
    return pairs


def check(dt):
    """The lists are those of the simplices."""
    d, n, there = dt.ndim, dt.npoints, dt.is_vertex
    pairs = pairs_of_simplices(dt)
    indptr, indices = dt.vertex_neighbor_vertices
    shifts = dt.vertex_neighbor_shifts
    assert indptr.dtype == indices.dtype == shifts.dtype == np.int32
    assert indptr.shape == (n + 1,) and indptr[0] == 0 and indptr[-1] == len(indices) == len(shifts)
    assert shifts.shape == (len(indices), d)
    i = np.repeat(np.arange(n), np.diff(indptr))
    rows = [(a, b, *s) for a, b, s in zip(i.tolist(), indices.tolist(), shifts.tolist())]
    assert rows == sorted(pairs)
    edges, by = dt.edges, dt.edge_shifts
    assert edges.dtype == by.dtype == np.int32 and edges.shape == (len(pairs) // 2, 2) and by.shape == (len(edges), d)
    one = [(a, b, *s) for (a, b), s in zip(edges.tolist(), by.tolist())]
    assert one == sorted(set(one)) and all(a <= b for a, b, *_ in one)
    assert all(s > [0] * d for a, b, *s in one if a == b)
    other = {(b, a, *(-c for c in s)) for a, b, *s in one}
    assert set(one) | other == pairs and not set(one) & other
    of = dt.vertex_to_simplex
    assert of.dtype == np.int32 and of.shape == (n,)
    assert all(v in dt.simplices[s] if inside else s == -1 for v, (s, inside) in enumerate(zip(of, there)))
    assert dt.affine_dimension == (d if dt.nvertices else -1)
    assert dt.flat_simplices.shape == (0, d + 1) and dt.flat_simplices.dtype == np.int32
    theta = dt.theta
    assert theta.shape == (n,) and np.array_equal(np.isnan(theta), ~there)
    assert np.all((theta[there] >= 0) & (theta[there] <= np.pi / 2))
    return dt


@pytest.mark.parametrize("d, k, n", CASES)
def test_lists_are_those_of_the_simplices_after_whatever_changes(d, k, n):
    box, rng = vectors_of(BOXES[d][k]), np.random.default_rng(100 * k + n)
    x = (5 * rng.random((n, d)) - 2) @ box
    dt = check(annulus.MovingDelaunay(x, box=box))
    dt.move(x + 0.3 * rng.standard_normal(x.shape) @ box, box=1.25 * box)
    check(dt)
    dt.insert((3 * rng.random((3, d)) - 1) @ box)
    check(dt)
    dt.remove([0, n + 1])
    check(dt)
    assert np.array_equal(dt.vertex_of_input, np.arange(n)) and dt.vertex_of_input.dtype == np.int32
    for other in (pickle.loads(pickle.dumps(dt)), copy.deepcopy(dt)):
        assert np.array_equal(other.vertex_of_input, np.arange(n)) and np.array_equal(other.edges, dt.edges)
    dt.remove(np.flatnonzero(dt.is_vertex))
    check(dt)


@pytest.mark.parametrize("d", [2, 3])
def test_lattices(d):
    x = np.stack(np.meshgrid(*[np.arange(2.0)] * d), -1).reshape(-1, d)
    dt = check(annulus.MovingDelaunay(x, box=[2] * d))
    assert len(dt.edges) == dt.nsimplex * 3 // 2 if d == 2 else len(dt.edges) == dt.nsimplex + 8
    assert dt.theta == pytest.approx(np.full(len(x), dt.theta[0]))  # all points are alike


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("k", [0, 1])
@pytest.mark.parametrize("n", [1, 3, 40])
def test_edges_and_theta_are_those_of_the_images_as_an_open_set(d, k, n):
    box, rng = vectors_of(BOXES[d][k]), np.random.default_rng(n)
    dt = annulus.MovingDelaunay(rng.random((n, d)) @ box, box=box)
    reach = 2 if n > 3 else 3
    shifts = np.array(list(itertools.product(range(-reach, reach + 1), repeat=d)))
    middle = np.flatnonzero(np.all(shifts == 0, axis=1))[0]
    images = annulus.MovingDelaunay((dt.points + (shifts @ dt.box)[:, None]).reshape(-1, d))
    expected = set()
    for i, j in images.edges.tolist():
        for a, b in ((i, j), (j, i)):
            if a // n == middle:
                expected.add((a % n, b % n, *shifts[b // n].tolist()))
    edges = {(a, b, *s) for (a, b), s in zip(dt.edges.tolist(), dt.edge_shifts.tolist())}
    assert edges | {(b, a, *(-c for c in s)) for a, b, *s in edges} == expected
    # Points and images are rounded, and theta is of rounded vectors.
    assert dt.theta == pytest.approx(images.theta[middle * n:(middle + 1) * n], rel=1e-9)


@pytest.mark.parametrize("d", [2, 3])
def test_tolerances_can_be_computed_again(d):
    rng = np.random.default_rng(d)
    x = rng.random((200, d))
    for strategy in ("tolerances", "auto"):
        dt = annulus.MovingDelaunay(x, box=np.ones(d), strategy=strategy)
        fresh = dt.tolerances
        result = dt.recompute_tolerances()
        assert result.asked == 0 and result.statistics.tolerance_recomputations == 1
        assert result.statistics.evaluated >= dt.nsimplex
        kept = dt.tolerances
        assert np.all(kept <= fresh) and np.median(kept / fresh) > 0.8  # they are rounded down
        step = 0.3 * fresh.min() / np.sqrt(d)
        assert dt.move(dt.points + step).within_tolerance == 200  # they are kept
        used = dt.tolerances
        assert np.all(used <= kept) and np.any(used < 0.99 * kept)
        dt.recompute_tolerances()
        assert np.all(dt.tolerances >= used) and np.any(dt.tolerances > 1.01 * used) and dt.audit()
    dt = annulus.MovingDelaunay(x, box=np.ones(d), strategy="signs")
    assert dt.recompute_tolerances().statistics.tolerance_recomputations == 0
    assert dt.move(dt.points + 1e-12).within_tolerance == 0
    empty = annulus.MovingDelaunay(np.empty((0, d)), box=np.ones(d), strategy="tolerances")
    assert empty.recompute_tolerances().statistics.evaluated == 0


def test_what_has_no_meaning_says_why():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((9, 3)), box=[1, 1, 1])
    without = {"convex_hull": "no hull", "displacements": "no fixed positions"}
    for name in dir(annulus.MovingDelaunay):
        assert name.startswith("_") or hasattr(dt, name) == (name not in without), name
    for name, reason in without.items():
        with pytest.raises(annulus.NotAvailableError, match=f"^{name} .*{reason}") as caught:
            getattr(dt, name)
        assert "yet" not in str(caught.value) and getattr(dt, name, 7) == 7
    for call in (dt.voronoi, dt.voronoi_polytopes, dt.voronoi_volumes, dt.neighbor_counts,
                 lambda clip: dt.neighbor_list("ij", clip=clip)):
        with pytest.raises(annulus.NotAvailableError, match="clip .* bounded"):
            call(clip=[[0, 0, 0], [1, 1, 1]])
        call(clip=None)
    for options, reason in (({"strategy": "in-place"}, " signs, "),
                            ({"tolerance": "paper", "strategy": "paper"}, " signs, "),
                            ({"tolerance": "floating"}, "certified")):
        with pytest.raises(annulus.Error, match=reason):
            annulus.MovingDelaunay(np.zeros((1, 3)), box=[1, 1, 1], **options)
    with pytest.raises(TypeError):
        dt.neighbor_list(3)
    with pytest.raises(annulus.Error, match="min_area"):
        dt.neighbor_counts(-1.0)
