# SPDX-License-Identifier: GPL-3.0-or-later
"""Gradients of Voronoi areas and volumes beside finite differences."""

import annulus
import numpy as np
import pytest
import scipy.sparse

from support import lattice


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
