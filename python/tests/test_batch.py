# SPDX-License-Identifier: GPL-3.0-or-later
"""A batch is bit for bit the loop over its entries, for any number of threads; errors name entries."""

import pickle
import sys
import threading

import annulus
import numpy as np
import pytest

from support import HANGING, STRATEGIES

B, N, STEPS = 7, 60, 4


def walk(d):
    rng = np.random.default_rng(d)
    x = rng.random((B, N, d))
    x[2] = rng.permuted(np.stack(np.meshgrid(*[np.arange(8.0)] * d), -1).reshape(-1, d), axis=0)[:N] + [0.0] * d
    x[2] += 1e-3 * rng.random((N, d))  # near a lattice
    return x + np.concatenate([np.zeros((1, B, N, d)), 0.02 * rng.standard_normal((STEPS, B, N, d))]).cumsum(axis=0)


def bits(array):
    return array.tobytes(), array.shape, array.dtype


@pytest.mark.parametrize("threads", [1, 2, 5])
@pytest.mark.parametrize("d", [2, 3])
def test_the_loop(d, threads):
    way = walk(d)
    g = np.random.default_rng(1).standard_normal((B, N))
    batch = annulus.MovingDelaunayBatch(way[0], threads=threads, report_changes=True)
    single = [annulus.MovingDelaunay(x) for x in way[0]]
    assert (len(batch), batch.npoints, batch.ndim) == (B, N, d) and len(list(batch)) == B
    for x in way[1:]:
        reports = batch.move(x)
        assert [r.as_dict() for r in reports] == [dt.move(p).as_dict() for dt, p in zip(single, x)]
        assert bits(batch.points) == bits(x)
        assert bits(batch.voronoi_volumes()) == bits(np.stack([dt.voronoi_volumes() for dt in single]))
        assert bits(batch.voronoi_vjp(g)) == bits(np.stack([dt.voronoi_vjp(w) for dt, w in zip(single, g)]))
        assert all(np.array_equal(a.simplices, b.simplices) for a, b in zip(batch, single))
    out = np.empty((B, N), np.float32)
    assert batch.voronoi_volumes(out=out) is out
    assert np.array_equal(out, batch.voronoi_volumes().astype(np.float32))
    assert batch.voronoi_vjp(g, dtype=np.float32).dtype == np.float32
    whole = np.zeros((B, N, d))
    with pytest.raises(annulus.Error, match="overlap"):
        batch.voronoi_vjp(whole[..., 0], out=whole)


@pytest.mark.parametrize("threads", [1, 3])
def test_errors_name_entries(threads):
    x = walk(2)[0]
    batch = annulus.MovingDelaunayBatch(x, threads=threads)
    wrong = x + 0.01
    wrong[1, 5] = wrong[1, 9]
    wrong[4, 3] = np.nan
    with pytest.raises(annulus.BatchError, match=r"^entry 1: .*one more") as caught:
        batch.move(wrong)
    error = caught.value
    assert error.code == "duplicate_point" and error.vertices == (5, 9) and list(error.errors) == [1, 4]
    assert error.errors[4].code == "not_finite" and error.errors[4].vertices == (3,)
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and list(again.errors) == [1, 4] and again.vertices == (5, 9)
    for b in range(B):  # those that failed are as they were, the others have moved
        assert np.array_equal(batch.points[b], x[b] if b in (1, 4) else wrong[b])
        assert batch[b].audit()
    with pytest.raises(annulus.BatchError, match="entry 1") as caught:
        annulus.MovingDelaunayBatch(wrong, threads=threads)
    assert list(caught.value.errors) == [1, 4]
    before = batch.points
    for shape in ((B, N + 1, 2), (B + 1, N, 2), (B, N, 3), (N, 2), (B, N, 2, 1)):
        with pytest.raises(annulus.Error) as caught:
            batch.move(np.random.default_rng(0).random(shape))
        assert caught.value.code == "wrong_size" and np.array_equal(batch.points, before)
    for shape in ((B, N + 1), (B - 1, N), (B, N, 1), (N,)):
        with pytest.raises(annulus.Error, match="g must have shape") as caught:
            batch.voronoi_vjp(np.zeros(shape))
        assert caught.value.code == "wrong_size"
    for shape in ((N, 2), (B, N, 4), (2,)):
        with pytest.raises(annulus.Error, match="shape"):
            annulus.MovingDelaunayBatch(np.zeros(shape))
    batch[6].insert([[0.5, 0.5]])
    with pytest.raises(annulus.BatchError, match="entry 6: there are 61 points, not 60"):
        batch.voronoi_volumes()


def test_entries_are_objects():
    x = walk(2)[0]
    batch = annulus.MovingDelaunayBatch(x)
    batch[2].move(x[2] + 1)
    assert np.array_equal(batch.points[2], x[2] + 1) and batch[2].vertex_of_input.tolist() == list(range(N))
    again = pickle.loads(pickle.dumps(batch))
    assert np.array_equal(again.points, batch.points) and repr(again) == "<MovingDelaunayBatch: 7 of 60 points in 2D>"
    with pytest.raises(IndexError):
        batch[B]
    with pytest.raises(TypeError):
        batch["x"]


@pytest.mark.parametrize("shape", [(0, 5, 2), (3, 0, 2), (2, 1, 3), (0, 0, 3)])
def test_few(shape):
    batch = annulus.MovingDelaunayBatch(np.zeros(shape), threads=2)
    assert len(batch.move(np.ones(shape))) == shape[0] and batch.points.shape == shape
    assert batch.voronoi_volumes().shape == shape[:2] and batch.voronoi_vjp(np.ones(shape[:2])).shape == shape


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_strategies(strategy):
    """Under every strategy, also one that draws, and with positions of other types and layouts."""
    way = walk(2)
    batch = annulus.MovingDelaunayBatch(way[0], strategy, threads=3, seed=5)
    single = [annulus.MovingDelaunay(x, strategy, seed=5, report_changes=False) for x in way[0]]
    whole = np.round(1e6 * way[4]).astype(np.int64)
    for x in (way[1].astype(np.float32), np.asfortranarray(way[2]), way[3].tolist(), whole):
        reports = batch.move(x)
        assert [r.as_dict() for r in reports] == [dt.move(p).as_dict() for dt, p in zip(single, x)]
        assert bits(batch.points) == bits(np.array(x, np.float64, order="C"))
        for a, b in zip(batch, single):
            assert np.array_equal(a.simplices, b.simplices)
            assert bits(a.tolerances) == bits(b.tolerances)


@pytest.mark.parametrize("threads", [1, 2])
def test_the_gil_is_released(threads):
    """Another thread of Python runs during each call: with this interval it never does otherwise."""
    x = np.random.default_rng(0).random((4, 3000, 3))  # each call takes tens of milliseconds
    calls = {"build": lambda b: annulus.MovingDelaunayBatch(x, threads=threads), "move": lambda b: b.move(x[:, ::-1]),
             "volumes": lambda b: b.voronoi_volumes(), "gradient": lambda b: b.voronoi_vjp(x[..., 0])}
    interval = sys.getswitchinterval()
    sys.setswitchinterval(HANGING)
    try:
        for name, call in calls.items():
            for _ in range(1000):
                batch = annulus.MovingDelaunayBatch(x, threads=threads)
                ran, go = [], threading.Lock()
                go.acquire()
                other = threading.Thread(target=lambda: (go.acquire(), ran.append(1)))
                other.start()
                go.release()
                call(batch)
                seen = bool(ran)
                other.join()
                if seen:
                    break
            assert seen, name
    finally:
        sys.setswitchinterval(interval)


def test_threads_of_python():
    """Several threads of Python use one batch: all come to an end, and each volume is that of one of the states."""
    x = walk(2)
    batch = annulus.MovingDelaunayBatch(x[0], threads=2)
    states = [annulus.MovingDelaunay(p).voronoi_volumes() for p in (x[0][0], x[1][0])]
    v = int(np.flatnonzero(np.isfinite(states[0]) & np.isfinite(states[1]))[0])
    done = threading.Event()
    wrong = []

    def mover():
        for _ in range(100):
            batch.move(x[1])
            batch.move(x[0])
        done.set()

    def reader():
        while not done.is_set():
            volume = batch.voronoi_volumes()[0, v]
            if not any(np.isclose(volume, state[v], rtol=1e-9) for state in states):
                wrong.append(volume)

    threads = [threading.Thread(target=t, daemon=True) for t in (mover, reader, reader)]
    for t in threads:
        t.start()
    for t in threads:
        t.join(HANGING)
        assert not t.is_alive(), "they wait for each other"
    assert not wrong
