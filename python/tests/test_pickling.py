# SPDX-License-Identifier: GPL-3.0-or-later
"""Pickling, copying, subclasses, forks."""

import copy
import multiprocessing
import os
import pickle
import signal
import threading

import annulus
import numpy as np
import pytest

from support import HANGING, KINDS, as_set, check, points_of

COPIES = [lambda dt: pickle.loads(pickle.dumps(dt)), lambda dt: pickle.loads(pickle.dumps(dt, protocol=2)), copy.copy,
          copy.deepcopy]


def same(a, b):
    assert type(a) is type(b)
    assert np.array_equal(a.points, b.points, equal_nan=True) and np.array_equal(a.is_vertex, b.is_vertex)
    assert np.array_equal(a.vertex_of_input, b.vertex_of_input)
    assert repr(a) == repr(b)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("copied", COPIES)
def test_copies(kind, d, copied):
    dt = annulus.MovingDelaunay(points_of(kind, 40, d, 1), "tolerances", threads=2)
    other = copied(dt)
    same(dt, other)
    check(other)
    other.move(other.points + 1)
    other.remove([0])
    assert dt.is_vertex[0], "they have nothing in common"
    check(dt)
    check(other)


@pytest.mark.parametrize("scale", [1.0, 1e-320, 1e-150, 2.0**499.5])
def test_free_indices_stay_in_their_order(scale):
    x = points_of("uniform", 30, 2, 2)
    dt = annulus.MovingDelaunay(x * scale if scale != 1e-320 else np.round(x * 1000) * 5e-324, merge_duplicates=True)
    n = dt.npoints
    dt.remove([3, 11, 7])
    other = pickle.loads(pickle.dumps(dt))
    same(dt, other)
    check(other)
    new = np.array([[0.25, 0.5], [0.5, 0.75], [0.75, 0.25], [0.1, 0.1]]) * max(scale, 1e-300)
    assert dt.insert(new).tolist() == other.insert(new).tolist() == [7, 11, 3, n]
    assert as_set(dt.simplices) == as_set(other.simplices)


def test_no_points_and_degenerate_sets():
    for x in (np.zeros((0, 2)), np.ones((1, 3)), [[0, 0], [1, 1], [2, 2]], np.indices((4, 4, 4)).reshape(3, -1).T):
        dt = annulus.MovingDelaunay(x)
        same(dt, pickle.loads(pickle.dumps(dt)))
        n = dt.npoints
        dt.remove(np.arange(n))
        other = pickle.loads(pickle.dumps(dt))
        same(dt, other)
        assert other.npoints == n and other.nvertices == 0
        check(other)


class Counting:
    """Stands before a compiled mesh and counts the calls on it: each is one moment."""

    def __init__(self, mesh):
        self.mesh, self.asked = mesh, []

    def __getattr__(self, name):
        self.asked.append(name)
        return getattr(self.mesh, name)


def test_a_state_is_of_one_moment():
    dt = annulus.MovingDelaunay(points_of("uniform", 30, 2, 0))
    dt.remove([4, 2])
    state = dt.__getstate__()
    assert (np.flatnonzero(np.isnan(state["points"][:, 0])).tolist() == [2, 4]
            and state["free_indices"].tolist() == [4, 2])
    for call in (lambda: dt.__getstate__(), lambda: repr(dt), lambda: dt.audit(), lambda: dt.voronoi_volumes(),
                 lambda: dt.vertex_neighbor_vertices, lambda: dt.convex_hull, lambda: dt.find_simplex([[0.5, 0.5]]),
                 lambda: dt.nsimplex, lambda: dt.tolerances, lambda: dt.is_vertex):
        real = dt._mesh
        dt._mesh = Counting(real)
        call()
        asked, dt._mesh = dt._mesh.asked, real
        assert len(asked) == 1, asked


def test_copies_while_others_insert_and_remove():
    """Each copy is of one moment: free indices are those without a place, and none is lost."""
    x = points_of("uniform", 60, 2, 3)
    dt = annulus.MovingDelaunay(x)
    raised, over = [], threading.Event()

    def change(seed):
        own = np.random.default_rng(seed)
        try:
            for k in range(300):
                new = dt.insert(own.random((3, 2)) + 2 * seed)
                dt.remove(new[::-1])
        except BaseException as e:
            raised.append(e)

    def look():
        try:
            while not over.is_set():
                state = dt.__getstate__()
                gone = np.flatnonzero(np.isnan(state["points"][:, 0]))
                assert sorted(state["free_indices"].tolist()) == gone.tolist()
                other = pickle.loads(pickle.dumps(dt))
                assert other.nvertices >= 60 and other.nvertices % 3 == 0 and np.array_equal(other.points[:60], x)
        except BaseException as e:
            raised.append(e)

    changing = [threading.Thread(target=change, args=(seed,)) for seed in (1, 2)]
    looking = threading.Thread(target=look)
    for t in (*changing, looking):
        t.start()
    for t in changing:
        t.join()
    over.set()
    looking.join()
    assert not raised, raised
    check(dt)


class Named(annulus.MovingDelaunay):
    """A subclass with a signature and attributes of its own."""

    def __init__(self, name):
        super().__init__(points_of("uniform", 20, 2, 0))
        self.name = name

    def move(self, points, indices=None):
        self.name += "'"
        return super().move(points, indices)


@pytest.mark.parametrize("copied", COPIES)
def test_subclasses(copied):
    dt = Named("it")
    dt.move(dt.points + 1)
    other = copied(dt)
    same(dt, other)
    assert other.name == "it'" and repr(other).startswith("<Named: 20 vertices in 2D")
    other.anything = 3


def test_reports():
    dt = annulus.MovingDelaunay(points_of("uniform", 50, 3, 0), "tolerances", report_changes=True)
    report = dt.move(points_of("uniform", 50, 3, 1))
    other = pickle.loads(pickle.dumps(report))
    assert other.as_dict() == report.as_dict() and np.array_equal(other.changed_simplices, report.changed_simplices)
    assert np.array_equal(other.removed_simplices, report.removed_simplices)
    cost = pickle.loads(pickle.dumps(report.statistics))
    assert report.statistics.evaluated > 0
    assert cost.as_dict() == other.statistics.as_dict() == report.statistics.as_dict()


def test_what_is_no_state():
    dt = annulus.MovingDelaunay(points_of("uniform", 20, 2, 0))
    for harm in ({"format": 7}, {"free_indices": [3, 3]}, {"free_indices": [20]}, {"points": np.full((20, 2), np.nan)}):
        other = annulus.MovingDelaunay.__new__(annulus.MovingDelaunay)
        with pytest.raises(annulus.Error):
            other.__setstate__({**dt.__getstate__(), **harm})
    for state in (None, 3, {}, {"format": 1}):
        with pytest.raises(annulus.Error, match="state"):
            annulus.MovingDelaunay.__new__(annulus.MovingDelaunay).__setstate__(state)


def in_a_child(dt):
    dt.move(dt.points + 0.5)
    return bool(dt.audit()), dt.points


def test_a_pool_of_processes():
    dt = annulus.MovingDelaunay(points_of("uniform", 200, 2, 0))
    for method in ("fork", "spawn"):
        with multiprocessing.get_context(method).Pool(1) as pool:
            right, points = pool.apply(in_a_child, (dt,))
        assert right and np.array_equal(points, dt.points + 0.5)


def test_a_fork():
    dt = annulus.MovingDelaunay(points_of("uniform", 200, 3, 0))
    child = os.fork()
    if child == 0:
        os._exit(0 if in_a_child(dt)[0] else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    check(dt)


def test_a_fork_in_the_middle_of_a_call():
    """The thread that was in it is not in the child: no call there waits for it, and none sees what is half done."""
    x = np.random.default_rng(0).random((60_000, 3))
    dt = annulus.MovingDelaunay(x, "rebuild")
    over = threading.Event()

    def move():
        while not over.is_set():
            dt.move(x[::-1])
            dt.move(x)

    mover = threading.Thread(target=move)
    mover.start()
    in_a_call, wrong, between_calls = 0, 1, 2
    codes = []
    while codes.count(in_a_call) < 5 and set(codes) <= {in_a_call, between_calls} and mover.is_alive():
        child = os.fork()
        if child == 0:
            signal.alarm(HANGING)
            try:
                dt.npoints
            except RuntimeError as e:
                os._exit(in_a_call if "forked" in str(e) else wrong)
            except BaseException:
                os._exit(wrong)
            os._exit(between_calls)
        codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    over.set()
    mover.join()
    assert codes.count(in_a_call) == 5, codes
    assert dt.audit()
