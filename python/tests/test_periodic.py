# SPDX-License-Identifier: GPL-3.0-or-later
"""MovingDelaunay with a box: crystals, lists, moves, errors, and what is not there yet."""

import copy
import pickle
import warnings
from types import SimpleNamespace as Thing

import annulus
import numpy as np
import pytest

FCC = np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]])
BCC = np.array([[0, 0, 0], [.5, .5, .5]])
TILTED = np.array([[2.0, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]])


def points(n, d=3, seed=0):
    return np.random.default_rng(seed).random((n, d))


def test_crystals_have_their_neighbours_and_volumes():
    for basis, count in ((FCC, 12), (BCC, 14)):
        cells = np.stack(np.meshgrid(*[np.arange(2)] * 3), -1).reshape(-1, 1, 3)
        x = (basis + cells).reshape(-1, 3)
        dt = annulus.MovingDelaunay(x, box=[2, 2, 2])
        assert isinstance(dt, annulus.PeriodicDelaunay)
        assert np.all(dt.neighbor_counts() == count)
        assert np.all(dt.neighbor_counts(0.0, strict=False) >= count)
        assert np.allclose(dt.voronoi_volumes(), 1 / len(basis), rtol=1e-9)
        assert dt.audit() and dt.audit().first_fault == ""


@pytest.mark.parametrize("box", [TILTED, TILTED[[1, 0, 2]], -TILTED, np.diag(TILTED)])
def test_the_lists_agree_with_points_and_box(box):
    vectors = np.diag(box) if box.ndim == 1 else box
    x = (5 * points(60) - 2) @ vectors
    dt = annulus.MovingDelaunay(x, box=box, threads=2)
    assert np.allclose(dt.points, x, atol=1e-12) and np.allclose(dt.box, vectors)
    i, j, d, D, S, A = dt.neighbor_list("ijdDSA")
    assert np.array_equal(D, dt.points[j] - dt.points[i] + S @ dt.box) or np.allclose(
        D, dt.points[j] - dt.points[i] + S @ dt.box, atol=1e-12)
    assert np.allclose(d, np.linalg.norm(D, axis=1))
    assert np.array_equal(np.lexsort((S[:, 2], S[:, 1], S[:, 0], j, i)), np.arange(len(i)))
    both = {(*a, *s) for a, s in zip(zip(i, j), S.tolist())}
    assert both == {(b, a, *(-s for s in t)) for a, b, *t in both}
    volumes = dt.voronoi_volumes()
    assert abs(volumes.sum() - abs(np.linalg.det(dt.box))) < 1e-9
    assert np.allclose(np.bincount(i, A * d / 6, 60), volumes)
    assert np.array_equal(dt.neighbor_counts(), np.bincount(i[A > 0], minlength=60))
    assert np.array_equal(dt.neighbor_list("S"), S)
    assert [a.dtype for a in dt.neighbor_list("Sid")] == [np.int32, np.int32, np.float64]


@pytest.mark.parametrize("d", [2, 3])
def test_simplices_with_offsets_are_positive_fill_the_box_and_meet(d):
    dt = annulus.MovingDelaunay(3 * points(30, d), box=np.full(d, 1.0))
    assert dt.simplex_offsets.dtype == np.int8 and dt.simplex_offsets.shape == (dt.nsimplex, d + 1, d)
    corners = dt.points[dt.simplices] + dt.simplex_offsets @ dt.box
    volume = np.linalg.det(corners[:, 1:] - corners[:, :1])
    assert np.all(volume > 0) and np.isclose(volume.sum(), 2 if d == 2 else 6)
    assert np.all(dt.simplex_offsets.min(axis=1) == 0)
    beyond, moved = dt.neighbors, dt.neighbor_offsets
    for c in range(dt.nsimplex):
        for k in range(d + 1):
            m = beyond[c, k]
            other = dt.points[dt.simplices[m]] + (dt.simplex_offsets[m] + moved[c, k]) @ dt.box
            common = [p for p in corners[c] if np.any(np.all(np.isclose(other, p), axis=1))]
            assert len(common) == d
    assert (dt.ndim, dt.npoints, dt.nvertices, dt.strategy) == (d, 30, 30, "rebuild")


def test_moves_change_points_and_box_and_failed_ones_change_nothing():
    x = points(50)
    dt = annulus.MovingDelaunay(x, box=[1, 1, 1])
    assert dt.move(x + 0.7) is None
    assert np.allclose(dt.points, x + 0.7)
    dt.move(x @ TILTED, box=TILTED)
    fresh = annulus.MovingDelaunay(x @ TILTED, box=TILTED)
    for ours, theirs in zip(dt.neighbor_list(), fresh.neighbor_list()):
        assert np.array_equal(ours, theirs)
    before = dt.points, dt.box, dt.simplices
    y = x @ TILTED
    y[8] = y[3] + TILTED[0] - 2 * TILTED[2]
    with pytest.raises(annulus.Error) as caught:
        dt.move(y)
    assert (caught.value.code, caught.value.vertices) == ("duplicate_point", (3, 8))
    for bad, box, code in ((x[:7], None, "wrong_size"), (x, [1, 1, 0], "usage"), (x, [1, np.nan, 1], "not_finite"),
                           (x, [1, 1], "wrong_size"), (x[:, :2], None, "wrong_size"),
                           (x, [[1, 0, 0], [1e4, 1, 0], [0, 0, 1]], "usage")):
        with pytest.raises(annulus.Error) as caught:
            dt.move(bad, box)
        assert caught.value.code == code
    for old, new in zip(before, (dt.points, dt.box, dt.simplices)):
        assert np.array_equal(old, new)


def test_an_object_with_a_box_of_its_own_takes_the_one_that_is_given():
    atoms = Thing(positions=FCC, cell=np.eye(3), pbc=np.array([True] * 3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        dt = annulus.MovingDelaunay(atoms, box=atoms.cell)
    assert np.all(dt.neighbor_counts() == 12)
    with pytest.warns(annulus.OpenBoundariesWarning):
        annulus.MovingDelaunay(atoms)


def test_few_points_and_none():
    for n in range(4):
        dt = annulus.MovingDelaunay(points(n), box=[1, 1, 1])
        assert dt.audit() and len(dt.neighbor_list("i")) == (0 if n == 0 else 2 * (dt.nsimplex + n))
    assert repr(annulus.MovingDelaunay(points(1), box=[1, 1, 1])) == "<PeriodicDelaunay: 1 vertex in a box in 3D>"


def test_copies_and_pickles_are_the_same():
    dt = annulus.MovingDelaunay(3 * points(20), box=TILTED)
    for other in (pickle.loads(pickle.dumps(dt)), copy.deepcopy(dt)):
        assert np.array_equal(other.simplices, dt.simplices)
        assert np.array_equal(other.simplex_offsets, dt.simplex_offsets)


def test_points_that_are_far_away_have_right_lists_and_offsets_that_do_not_fit_are_refused():
    x = points(20)
    far = x + 1000 * np.arange(20)[:, None]
    dt = annulus.MovingDelaunay(far, box=[1, 1, 1])
    i, j, D, S = dt.neighbor_list("ijDS")
    assert np.allclose(D, far[j] - far[i] + S, atol=1e-9)
    assert dt.audit()
    with pytest.raises(annulus.Error, match="does not fit int8") as caught:
        dt.simplex_offsets
    assert caught.value.code == "too_large"


def test_what_is_not_there_yet_says_so():
    dt = annulus.MovingDelaunay(points(9), box=[1, 1, 1])
    for name in ("insert", "remove", "find_simplex", "tolerances", "convex_hull", "theta"):
        with pytest.raises(annulus.NotAvailableError, match=name):
            getattr(dt, name)
        with pytest.raises(NotImplementedError):
            getattr(dt, name)
    for options in ({"strategy": "tolerances"}, {"tolerance": "paper", "strategy": "paper"},
                    {"merge_duplicates": True}):
        with pytest.raises(annulus.NotAvailableError):
            annulus.MovingDelaunay(points(9), box=[1, 1, 1], **options)
    with pytest.raises(AttributeError):
        dt.nonsense
    with pytest.raises(annulus.Error, match="quantities"):
        dt.neighbor_list("ijx")

    class Derived(annulus.MovingDelaunay):
        pass

    with pytest.raises(annulus.NotAvailableError, match="Derived"):
        Derived(points(9), box=[1, 1, 1])
    with pytest.raises(TypeError):
        annulus.MovingDelaunay(points(9), box=[1, 1, 1], colour="red")
