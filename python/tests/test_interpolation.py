# SPDX-License-Identifier: GPL-3.0-or-later
"""Nearest vertices, and Laplace interpolation between the values of vertices."""

import annulus
import numpy as np
import pytest

from support import lattice


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
