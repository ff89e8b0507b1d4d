# SPDX-License-Identifier: GPL-3.0-or-later
"""What reports say, which indices there are, and that a refused call changes nothing."""

import annulus
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from support import STRATEGIES, as_oriented_set, as_set, check, points_of, repeats

COUNTS = ("within_tolerance", "kept_in_place", "flipped", "reinserted", "rebuilt")


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("strategy", STRATEGIES)
def test_reports_add_up(strategy, d):
    rng = np.random.default_rng(1)
    x = rng.random((120, d))
    dt = annulus.MovingDelaunay(x, strategy, report_changes=True)
    for step in (1e-6, 1e-3, 0.03, 0.3):
        before = as_oriented_set(dt.simplices)
        x = x + step * rng.standard_normal(x.shape) / 10
        r = dt.move(x)
        assert r.asked == 120
        assert sum(getattr(r, name) for name in COUNTS) == r.asked
        now = as_oriented_set(dt.simplices)
        assert as_oriented_set(r.changed_simplices) == now - before
        assert as_oriented_set(r.removed_simplices) == before - now
        assert (len(r.changed_simplices) == len(now - before)
                and len(r.removed_simplices) == len(before - now)), "each once"
        assert r.changed_simplices.shape[1] == d + 1 and not r.changed_simplices.flags.writeable
        assert r.as_dict()["asked"] == 120 and r.as_dict().keys() == {"asked", *COUNTS}
        assert r.statistics.as_dict().keys() >= {"flips", "cost", "exact"}
        assert r.statistics.evaluated == r.statistics.filter + r.statistics.interval + r.statistics.exact
        assert "asked 120" in repr(r)
        check(dt)


def test_simplices_are_those_of_now():
    """They are kept between calls that change no simplex; every other call must drop them."""
    rng = np.random.default_rng(2)
    for strategy in STRATEGIES:
        for d in (2, 3):
            x = rng.random((60, d))
            dt = annulus.MovingDelaunay(x, strategy, report_changes=bool(rng.integers(2)))
            for step in range(25):
                _ = dt.simplices, dt.vertex_neighbor_vertices
                kind = step % 5
                if kind < 2:
                    x = dt.points + 10.0 ** -rng.integers(1, 8) * rng.standard_normal(dt.points.shape)
                    dt.move(x)
                elif kind == 2:
                    some = rng.choice(60, 5, replace=False)
                    dt.move(rng.random((5, d)), indices=some)
                elif kind == 3:
                    dt.move(dt.points[[3]] + 0.2, indices=[3])
                else:
                    dt.remove([7])
                    assert dt.insert(rng.random((1, d))).tolist() == [7]
                assert as_set(dt.simplices) == as_set(annulus.MovingDelaunay(dt.points).simplices)
            check(dt)


def test_changed_simplices_can_be_left_out():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((50, 2)), report_changes=False)
    report = dt.move(dt.points + 0.1 * np.sin(7 * dt.points[:, ::-1]))
    for name in ("changed_simplices", "removed_simplices"):
        with pytest.raises(annulus.Error, match="report_changes=True") as e:
            getattr(report, name)
        assert e.value.code == "usage"


def test_free_indices():
    dt = annulus.MovingDelaunay(points_of("uniform", 20, 2, 3))
    dt.remove([4, 9])
    check(dt)
    assert dt.npoints == 20 and dt.nvertices == 18
    assert dt.vertex_to_simplex[[4, 9]].tolist() == [-1, -1]
    dt.move(dt.points)  # NaN at free indices
    x = dt.points.copy()
    x[4] = x[5]
    dt.move(x)  # ignored
    check(dt)
    assert dt.insert([[0.5, 0.51], [0.2, 0.3], [0.9, 0.1]]).tolist() == [9, 4, 20], (
        "the one freed last first, then new ones")
    check(dt)
    with pytest.raises(annulus.Error) as e:
        dt.remove([3, 3])
    assert e.value.code == "unknown_vertex" and dt.is_vertex[3]
    dt.remove(np.arange(dt.npoints))
    check(dt)
    assert dt.nvertices == 0 and dt.affine_dimension == -1 and dt.npoints == 21
    assert sorted(dt.insert(points_of("uniform", 22, 2, 4))) == list(range(22))
    check(dt)


def test_faults_name_indices_after_a_removal():
    """The paper's tolerance lets a spindle of five points (docs/theory.md 3) grow past the sphere of four of them."""
    s = np.sqrt(0.75)
    spindle = np.array([[0, 0, 0.99], [0, 0, -0.99], [1, 0, 0], [-0.5, s, 0], [-0.5, -s, 0]])
    grown = spindle * (1 - 0.007)
    grown[:2] = [[0, 0, 0.997], [0, 0, -0.997]]
    dt = annulus.MovingDelaunay(np.vstack([[[5, 5, 5]], spindle]), "paper", tolerance="paper")
    dt.remove([0])
    dt.recompute_tolerances()
    dt.move(np.vstack([[[5, 5, 5]], grown]))
    audit = dt.audit()
    assert not audit and audit.violated_facets > 0
    words, numbers = audit.first_fault.split("opposites")
    assert words == "not locally Delaunay: facet, " and sorted(numbers.split()) == list("12345"), audit.first_fault


def test_all_or_nothing():
    x = points_of("uniform", 30, 3, 9)
    dt = annulus.MovingDelaunay(x)
    before = dt.points
    new = np.random.default_rng(5).random((4, 3))
    for wrong, code in [(x[7], "duplicate_point"), (new[1], "duplicate_point"), ([np.nan] * 3, "not_finite"),
                        ([1e200, 0, 0], "out_of_domain")]:
        for at in range(4):
            with pytest.raises(annulus.Error) as e:
                dt.insert(np.insert(new, at, wrong, axis=0))
            assert e.value.code == code
            assert dt.npoints == 30 and np.array_equal(dt.points, before)
    with pytest.raises(annulus.Error):
        dt.remove([1, 2, 30])
    assert dt.nvertices == 30
    with pytest.raises(annulus.Error):
        dt.move(np.zeros((2, 3)), indices=[1, 2])
    assert np.array_equal(dt.points, before)
    check(dt)
    dt.move(x[[1, 2]], indices=[2, 1])  # they may exchange places
    assert np.array_equal(dt.points[[1, 2]], x[[2, 1]])
    check(dt)


def test_merged_points():
    x = np.array([[0, 0], [1, 0], [0, 1], [1, 0], [-0.0, 0], [2, 3]])
    with pytest.raises(annulus.Error) as e:
        annulus.MovingDelaunay(x)
    assert e.value.code == "duplicate_point"
    dt = annulus.MovingDelaunay(x, merge_duplicates=True)
    assert dt.vertex_of_input.tolist() == [0, 1, 2, 1, 0, 3] and dt.npoints == 4
    assert np.array_equal(dt.points[dt.vertex_of_input], x)
    check(dt)
    with pytest.raises(annulus.Error) as e:
        dt.insert([[1, 0]])
    assert e.value.code == "duplicate_point"


@repeats(40)
@given(st.integers(0, 6), st.integers(2, 3), st.integers(0, 2), st.integers(0, 2**32))
def test_few_and_flat_points(n, d, k, seed):
    """No points, one, fewer than d + 1, and such as span k dimensions only; they move, and come to span more."""
    rng = np.random.default_rng(seed)
    x = np.unique(rng.integers(0, 9, (n, k)) @ rng.integers(-3, 4, (k, d)) + rng.integers(0, 9, d),
                  axis=0).astype(float)
    dt = annulus.MovingDelaunay(x)
    check(dt)
    assert dt.affine_dimension <= k
    if dt.affine_dimension < d:
        assert dt.simplices.shape == (0, d + 1) and dt.convex_hull.shape == (0, d)
        assert dt.find_simplex(np.zeros((3, d))).tolist() == [-1] * 3
    r = dt.move(x + 1)
    assert r.asked == len(x)
    check(dt)
    dt.insert(rng.random((d + 2, d)) + 20)
    check(dt)
    assert dt.affine_dimension == d


def test_tolerances_hold():
    """Vertices that stay within tolerances leave the simplices as they are."""
    rng = np.random.default_rng(11)
    dt = annulus.MovingDelaunay(rng.random((200, 2)), "tolerances")
    simplices = as_set(dt.simplices)
    way = rng.standard_normal((200, 2))
    way *= (0.99 * dt.tolerances / np.linalg.norm(way, axis=1))[:, None]
    assert dt.move(dt.points + way).within_tolerance == 200
    assert (as_set(dt.simplices) == simplices and (dt.displacements <= dt.tolerances).all()
            and dt.displacements.max() > 0)
    dt.recompute_tolerances()
    assert dt.displacements.max() == 0
    check(dt)
