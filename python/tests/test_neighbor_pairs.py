# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of neighbours, and edges that moves make and break: beside what follows from the simplices."""

import pickle

import annulus
import numpy as np
import pytest

from support import STRATEGIES, lattice, pairs_of


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


def test_flat_sets_have_no_empty_facets():
    """A square lattice in a plane of 3D has 4 neighbours in the plane, and diagonals count besides."""
    x = np.column_stack([lattice("square")[0], np.zeros(25)])
    dt = annulus.MovingDelaunay(x)
    counts = dt.neighbor_counts()
    assert np.array_equal(counts, dt.neighbor_counts(strict=False)) and counts[12] > 4
    assert np.isinf(dt.neighbor_list("A")).all() and annulus.MovingDelaunay(x[:, :2]).neighbor_counts()[12] == 4
