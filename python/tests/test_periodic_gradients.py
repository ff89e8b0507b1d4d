# SPDX-License-Identifier: GPL-3.0-or-later
"""Gradients of Voronoi areas and volumes in periodic boxes beside finite differences."""

import pickle

import annulus
import numpy as np
import pytest
import scipy.sparse

TILTED = np.array([[2.0, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]])
BOXES = [(2, np.array([1.0, 1.5])), (2, TILTED[:2, :2]), (3, np.diag(TILTED)), (3, TILTED)]


@pytest.mark.parametrize("n", [2, 5, 40])
@pytest.mark.parametrize("d, box", BOXES)
def test_gradients(d, box, n):
    rng = np.random.default_rng(n)
    vectors = np.diag(box) if box.ndim == 1 else box
    x = (5 * rng.random((n, d)) - 2) @ vectors
    dt = annulus.MovingDelaunay(x, box=box)
    g = rng.standard_normal(n)
    gradient = dt.voronoi_vjp(g)
    assert gradient.shape == x.shape and gradient.dtype == np.float64
    assert np.all(dt.voronoi_vjp(np.ones(n)) == 0)  # the volume of the box does not change
    assert np.allclose(gradient.sum(axis=0), 0, atol=1e-12)  # nor do volumes where all points move alike
    indptr, indices, values = dt.voronoi_jacobian()
    i, j = dt.neighbor_list("ij")
    pairs = set(zip(i.tolist(), j.tolist())) | {(k, k) for k in range(n)}
    assert list(zip(np.repeat(np.arange(n), np.diff(indptr)).tolist(), indices.tolist())) == sorted(pairs)
    for axis in range(d):
        matrix = scipy.sparse.csr_matrix((values[:, axis], indices, indptr), (n, n))
        assert matrix.T @ g == pytest.approx(gradient[:, axis], abs=1e-12)
        assert np.allclose(matrix.sum(axis=0), 0, atol=1e-12) and np.allclose(matrix.sum(axis=1), 0, atol=1e-9)
    h = 1e-6
    for k in rng.choice(n, 5):
        for axis in range(d):
            sums = []
            for sign in (1, -1):
                moved = x.copy()
                moved[k, axis] += sign * h
                sums.append(annulus.MovingDelaunay(moved, box=box).voronoi_volumes() @ g)
            assert gradient[k, axis] == pytest.approx((sums[0] - sums[1]) / (2 * h), abs=2e-6)


def test_a_crystal_is_at_rest_and_points_alone_have_no_derivative():
    fcc = np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]])
    dt = annulus.MovingDelaunay(fcc, box=[1, 1, 1])
    assert np.allclose(dt.voronoi_vjp([1, 1, 0, 0]).sum(axis=0), 0, atol=1e-15)
    away = annulus.MovingDelaunay(fcc + [[3, 0, 0], [0, -7, 0], [0, 0, 1], [0, 0, 0]], box=[1, 1, 1])
    assert np.array_equal(away.voronoi_vjp([1, 2, 3, 4]), dt.voronoi_vjp([1, 2, 3, 4]))
    for n in (0, 1):
        dt = annulus.MovingDelaunay(np.zeros((n, 3)), box=[1, 1, 1])
        assert np.array_equal(dt.voronoi_vjp(np.ones(n)), np.zeros((n, 3)))
        indptr, indices, values = dt.voronoi_jacobian()
        assert (indptr.tolist(), indices.tolist()) == (list(range(n + 1)), list(range(n)))
        assert np.array_equal(values, np.zeros((n, 3)))


def test_gradients_while_points_move():
    """A descent to equal areas in a box: each step goes down."""
    rng = np.random.default_rng(5)
    dt = annulus.MovingDelaunay(rng.random((200, 2)), box=[1, 1])
    energies = []
    for _ in range(30):
        g = dt.voronoi_volumes() - 1 / 200
        energies.append(np.sum(g**2) / 2)
        dt.move(dt.points - 5 * dt.voronoi_vjp(g))
    assert energies[-1] < 0.4 * energies[0] and all(b < a for a, b in zip(energies, energies[1:]))


def test_outputs_copies_and_errors():
    rng = np.random.default_rng(3)
    dt = annulus.MovingDelaunay(rng.random((20, 3)), box=[1, 1, 1])
    g = rng.random(20)
    out = np.empty((20, 3), np.float32)
    assert dt.voronoi_vjp(g, out=out) is out and np.array_equal(out, dt.voronoi_vjp(g).astype(np.float32))
    assert np.array_equal(pickle.loads(pickle.dumps(dt)).voronoi_vjp(g), dt.voronoi_vjp(g))
    for bad in (np.ones(19), np.ones((20, 1))):
        with pytest.raises(annulus.Error) as caught:
            dt.voronoi_vjp(bad)
        assert caught.value.code == "wrong_size"
    with pytest.raises(annulus.Error, match="out must have shape"):
        dt.voronoi_vjp(g, out=np.empty((20, 2)))
