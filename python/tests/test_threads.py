# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads of Python: on objects of their own, and on one; with and without threads of the library."""

import sys
import threading
import time

import annulus
import numpy as np
import pytest

from support import HANGING, as_set, check


def in_threads(*calls):
    """Runs them at once and raises what one of them raised."""
    raised = []

    def guarded(call):
        try:
            call()
        except BaseException as e:
            raised.append(e)

    threads = [threading.Thread(target=guarded, args=(call,)) for call in calls]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        for t in threads:
            t.start()
        for t in threads:
            t.join(HANGING)
            assert not t.is_alive(), "they wait for each other"
    finally:
        sys.setswitchinterval(interval)
    if raised:
        raise raised[0]


@pytest.mark.parametrize("d", [2, 3])
def test_one_object(d):
    rng = np.random.default_rng(0)
    places = rng.random((8, 150, d))
    dt = annulus.MovingDelaunay(places[0])
    stop = threading.Event()

    def mover(seed):
        own = np.random.default_rng(seed)
        for _ in range(60):
            dt.move(places[own.integers(8)])
            some = own.choice(150, 4, replace=False)
            dt.move(dt.points[some] + 1e-3 * own.random((4, d)), indices=some)
        stop.set()

    def reader():
        while not stop.is_set():
            points, simplices, (indptr, indices) = dt.points, dt.simplices, dt.vertex_neighbor_vertices
            assert points.shape == (150, d) and not np.isnan(points).any()
            assert simplices.min() == 0 and simplices.max() == 149
            assert indptr[-1] == len(indices) and len(dt.tolerances) == 150
            assert dt.audit()
            dt.find_simplex(points[:5])
            repr(dt)

    in_threads(lambda: mover(1), lambda: mover(2), reader, reader)
    check(dt)


def test_objects_of_their_own():
    rng = np.random.default_rng(1)
    x = rng.random((300, 3))
    way = 1e-3 * rng.standard_normal((10, 300, 3)).cumsum(axis=0)
    results = [None] * 4

    def follow(k):
        dt = annulus.MovingDelaunay(x, threads=1 + k % 2)
        for step in way:
            dt.move(x + step)
        results[k] = as_set(dt.simplices)

    in_threads(*(lambda k=k: follow(k) for k in range(4)))
    assert results.count(results[0]) == 4


def test_others_go_on_meanwhile():
    """The GIL is released: another thread counts on in the middle of a call. Of a busy machine it may have nothing for
    as long as a call takes; so there are many calls, and one in which it counts is enough."""
    x = np.random.default_rng(2).random((100_000, 3))
    call = 0  # odd in the middle of one
    counted = threading.Event()

    def build():
        nonlocal call
        for _ in range(200):
            call += 1
            annulus.MovingDelaunay(x)
            call += 1
            if counted.is_set():
                break

    def count():
        builder = threads[0]
        n, last = 0, 0
        while builder.is_alive() and not counted.is_set():
            n, last = (n + 1 if call == last and call % 2 else 0), call
            if n == 10:  # without the call's leave a switch of threads would give one or two
                counted.set()
            time.sleep(1e-3)

    threads = [threading.Thread(target=build), threading.Thread(target=count)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert counted.is_set()


class Timed(threading.Thread):
    """A thread that says what it has had of a processor."""

    def run(self):
        self.clock = time.pthread_getcpuclockid(self.ident)  # here, while the thread is certainly there
        super().run()

    def processor_seconds(self):
        """None before it has begun and once it is gone."""
        try:
            return time.clock_gettime(self.clock)
        except (AttributeError, OSError):
            return None


@pytest.mark.skipif(not hasattr(time, "pthread_getcpuclockid"), reason="reads the processor time of a thread")
@pytest.mark.parametrize("call", [
    lambda x: annulus.MovingDelaunay(x),
    lambda x: annulus.degeneracy(x[:30_000]),
    lambda x: annulus.lloyd(20_000, 30),
], ids=["construction", "degeneracy", "lloyd"])
def test_two_threads_compute_at_once(call):
    """Both have had a processor, and neither is done. If a call kept the GIL, it would be done before the other
    begins. A busy machine may let one of them wait until the other is done: then it is tried again."""
    x = np.random.default_rng(3).random((150_000, 3))
    for _ in range(20):
        threads = [Timed(target=call, args=(x,)) for _ in range(2)]
        for t in threads:
            t.start()
        at_once = False
        while not at_once and all(t.is_alive() for t in threads):
            seconds = [t.processor_seconds() for t in threads]
            at_once = None not in seconds and min(seconds) > 0.03 and all(t.is_alive() for t in threads)
            time.sleep(1e-3)
        for t in threads:
            t.join()
        if at_once:
            return
    pytest.fail("two calls never compute at once")


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("strategy", ["auto", "tolerances", "rebuild"])
def test_an_array_that_is_written_meanwhile(d, strategy):
    """What is proved is proved of positions as they were at one moment, whatever is written later: also what nothing
    could be proved of."""
    rng = np.random.default_rng(4)
    home = rng.random((500, d))
    x = home.copy()
    dt = annulus.MovingDelaunay(x, strategy)
    stop = threading.Event()

    def write():
        own = np.random.default_rng(5)
        while not stop.is_set():
            some = own.integers(0, len(x), 50)
            x[some] = own.choice([np.nan, np.inf, 1e300, -1e-310, 0.5, 1e100], (50, d))
            x[some] = home[some] + 1e-3 * own.standard_normal((50, d))

    def move():
        try:
            for _ in range(40):
                try:
                    dt.move(x)
                except annulus.Error as e:
                    assert e.code in ("not_finite", "out_of_domain", "duplicate_point")
                try:
                    dt.move(x[:100], indices=np.arange(100))
                    dt.find_simplex(x)
                except annulus.Error as e:
                    assert e.code in ("not_finite", "out_of_domain", "duplicate_point")
                assert dt.audit()
        finally:
            stop.set()

    in_threads(write, move)
    check(dt)


def test_lloyd_in_two_threads():
    results = [None] * 2

    def run(k):
        results[k] = annulus.lloyd(300, 10, seed=3, callback=lambda *_: None).points

    in_threads(lambda: run(0), lambda: run(1))
    assert np.array_equal(results[0], results[1])
