# SPDX-License-Identifier: GPL-3.0-or-later
"""annulus.Error, its codes, and what is no such error: memory, signals, objects that were not initialised."""

import pickle
import subprocess
import sys

import annulus
import annulus._core
import numpy as np
import pytest

from support import HANGING

X = np.random.default_rng(0).random((30, 2))


def code(call, *arguments, **named):
    with pytest.raises(annulus.Error) as e:
        call(*arguments, **named)
    assert isinstance(e.value, ValueError) and str(e.value)
    return e.value.code


def test_codes():
    dt = annulus.MovingDelaunay(X)
    bad = X.copy()
    for value, expected in [(np.nan, "not_finite"), (np.inf, "not_finite"), (-np.inf, "not_finite"),
                            (1e200, "out_of_domain")]:
        bad[3, 1] = value
        assert code(annulus.MovingDelaunay, bad) == expected
        assert code(dt.move, bad) == expected
        assert code(dt.move, bad[3:4], [3]) == expected
        assert code(dt.insert, bad[3:4]) == expected
    bad[3] = bad[4]
    assert code(annulus.MovingDelaunay, bad) == "duplicate_point"
    assert code(dt.move, bad) == "duplicate_point"
    assert code(dt.insert, X[:1]) == "duplicate_point"
    assert code(dt.move, X[:3]) == "wrong_size"
    assert code(dt.move, X[:3], [1, 2]) == "wrong_size"
    assert code(dt.move, X[:1], [30]) == "unknown_vertex"
    assert code(dt.move, X[:1], [-1]) == "unknown_vertex"
    assert code(dt.remove, [2**40]) == "unknown_vertex"
    assert np.array_equal(dt.points, X) and dt.audit()
    for wrong in ({"strategy": "best"}, {"tolerance": "none"}, {"threads": 0}, {"threads": -3}):
        assert code(annulus.MovingDelaunay, X, **wrong) == "usage"
    for wrong in ({"threads": 1.5}, {"seed": -1}, {"strategy": None}, {"threads": 2**40}):
        with pytest.raises((TypeError, ValueError, OverflowError)):
            annulus.MovingDelaunay(X, **wrong)


def bad(x, i, value):
    out = x.copy()
    out[i] = value
    return out


def at(x, i, j):
    """Vertex i where j is."""
    return bad(x, i, x[j])


@pytest.mark.parametrize("strategy", ["auto", "rebuild", "relocate", "relocate-flips", "in-place", "tolerances",
                                      "tolerances-each", "paper", "paper-hybrid"])
@pytest.mark.parametrize("d", [2, 3])
def test_errors_name_the_vertices_concerned(d, strategy):
    x = np.random.default_rng(d).random((40, d))
    dt = annulus.MovingDelaunay(x, strategy)
    both, there = "vertices {} and {} would have the same position", "vertex {} has the position of "
    for call, expected, vertices, words in [
            (lambda: annulus.MovingDelaunay(at(x, 9, 4), strategy), "duplicate_point", (4, 9),
             "points 4 and 9 have the same position"),
            (lambda: annulus.MovingDelaunay(at(x, 3, 15), strategy), "duplicate_point", (3, 15),
             "points 3 and 15 have the same position"),
            (lambda: dt.move(at(x, 9, 4)), "duplicate_point", (4, 9), both.format(4, 9)),
            (lambda: dt.move(x[[11]], [2]), "duplicate_point", (2, 11), both.format(2, 11)),
            (lambda: dt.move(x[[2]], [11]), "duplicate_point", (2, 11), both.format(2, 11)),
            (lambda: dt.move(x[[8, 10, 1]], [1, 6, 8]), "duplicate_point", (6, 10), both.format(6, 10)),
            (lambda: dt.move(x[[8, 8]] + 0.001, [1, 6]), "duplicate_point", (1, 6), None),
            (lambda: dt.insert(x[[7]]), "duplicate_point", (7,), there.format(7) + "the point to be inserted"),
            (lambda: dt.insert([x[7] + 1, x[7] + 2, x[7]]), "duplicate_point", (7,),
             there.format(7) + "point 2 to be inserted"),
            (lambda: dt.insert([x[7] + 1, x[7] + 2, x[7] + 1]), "duplicate_point", (),
             "points 0 and 2 to be inserted have the same position"),
            (lambda: annulus.MovingDelaunay(bad(x, 5, np.nan), strategy), "not_finite", (5,),
             "point 5 is not a finite number"),
            (lambda: dt.move(bad(x, 5, np.inf)), "not_finite", (5,), "vertex 5 is not a finite number"),
            (lambda: dt.move(bad(x, 5, 1e200)), "out_of_domain", (5,), "vertex 5 is larger"),
            (lambda: dt.move(bad(x, 5, 1e200)[[5]], [8]), "out_of_domain", (8,), "vertex 8 is larger"),
            (lambda: dt.insert(bad(x, 5, 1e200)), "out_of_domain", (5,), "point 5 is larger"),
            (lambda: dt.move(x[[1]], [40]), "unknown_vertex", (40,), "no vertex has index 40"),
            (lambda: dt.remove([40]), "unknown_vertex", (40,), "no vertex has index 40"),
            (lambda: annulus.degeneracy(at(x, 9, 4)), "duplicate_point", (4, 9),
             "points 4 and 9 have the same position")]:
        with pytest.raises(annulus.Error) as e:
            call()
        assert (e.value.code, e.value.vertices) == (expected, vertices), str(e.value)
        assert words is None or words in str(e.value)
    dt.remove([6])
    with pytest.raises(annulus.Error) as e:
        dt.move(x[[1]], [6])
    assert (e.value.code, e.value.vertices) == ("unknown_vertex", (6,))
    assert dt.audit()


def test_an_error_can_be_sent_elsewhere():
    for error in (annulus.Error("words", "usage"), annulus.Error("words", "duplicate_point", (3, 15))):
        there = pickle.loads(pickle.dumps(error))
        assert (isinstance(there, annulus.Error) and (str(there), there.code, there.vertices)
                == ("words", error.code, error.vertices))


def test_what_was_not_initialised():
    class Forgetful(annulus.MovingDelaunay):
        def __init__(self):
            pass

    for dt in (Forgetful(), annulus.MovingDelaunay.__new__(annulus.MovingDelaunay)):
        assert "not initialised" in repr(dt)
        for name in ("points", "simplices", "nvertices"):
            with pytest.raises(AttributeError):
                getattr(dt, name)
        with pytest.raises(AttributeError):
            dt.move(X)


@pytest.mark.skipif(sys.version_info < (3, 10), reason="not possible in Python before")
@pytest.mark.parametrize("kind", [annulus.MoveResult, annulus.MoveStatistics, annulus._core.Mesh2, annulus._core.Mesh3,
                                  annulus._core.Options])
def test_what_python_cannot_make(kind):
    for call in (kind, lambda: kind.__new__(kind), lambda: object.__new__(kind)):
        with pytest.raises(TypeError):
            call()


def test_memory_that_runs_out():
    """In a process of its own: what is left afterwards is what was there before."""
    program = """
import annulus, numpy, resource
x = numpy.random.default_rng(0).random((20000, 3))
dt = annulus.MovingDelaunay(x, "tolerances")
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
soft, hard = resource.getrlimit(resource.RLIMIT_AS)
refused = 0
there = x[::-1].copy()
for more in (1 << 18, 1 << 20, 1 << 21, 1 << 22):
    resource.setrlimit(resource.RLIMIT_AS, (used + more, hard))
    try:
        dt.move(there)
    except MemoryError:
        refused += 1
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
assert refused > 0
dt.move(x)
assert dt.audit(), dt.audit()
print("right")
"""
    done = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, timeout=HANGING,
                          check=False)
    assert done.stdout == "right\n", done


def test_an_interrupted_run():
    """Ctrl-C is seen between two steps of a run."""
    program = """
import annulus, os, signal, threading, time
mine = time.pthread_getcpuclockid(threading.main_thread().ident)
before = time.clock_gettime(mine)
def interrupt():
    while time.clock_gettime(mine) < before + 0.1:  # of the processor, of which only the run takes any
        time.sleep(1e-3)
    os.kill(os.getpid(), signal.SIGINT)
try:
    threading.Thread(target=interrupt).start()
    annulus.lloyd(2000, 10**7)
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, timeout=HANGING,
                          check=False)
    assert done.stdout == "interrupted\n", done


def test_an_interrupted_move():
    """Ctrl-C in a call is seen after it; what it did is done."""
    program = """
import annulus, numpy, os, signal, threading, time
x = numpy.random.default_rng(0).random((20000, 3))
dt = annulus.MovingDelaunay(x, "rebuild")
mine = time.pthread_getcpuclockid(threading.main_thread().ident)
before = time.clock_gettime(mine)
def interrupt():
    while time.clock_gettime(mine) < before + 0.05:
        time.sleep(1e-3)
    os.kill(os.getpid(), signal.SIGINT)
try:
    threading.Thread(target=interrupt).start()
    while True:
        dt.move(x + 1)
        dt.move(x)
except KeyboardInterrupt:
    assert dt.audit() and (numpy.array_equal(dt.points, x) or numpy.array_equal(dt.points, x + 1))
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, timeout=HANGING,
                          check=False)
    assert done.stdout == "interrupted\n", done


def test_what_a_callback_raises():
    def stop(step, mean, largest):
        raise KeyError(step)

    with pytest.raises(KeyError, match="1"):
        annulus.lloyd(50, 3, callback=stop)
    steps = []
    result = annulus.lloyd(50, 9, callback=lambda step, mean, largest: steps.append((step, mean, largest)) or step == 4)
    assert [s[0] for s in steps] == [1, 2, 3, 4] and len(result.mean_displacement) == 4
    assert [s[1] for s in steps] == result.mean_displacement.tolist()


def test_a_floating_point_unit_that_flushes_is_noticed():
    ctypes = pytest.importorskip("ctypes")
    libm = ctypes.CDLL("libm.so.6")
    dt = annulus.MovingDelaunay(X)
    libm.fesetround(0x400)  # FE_DOWNWARD of x86-64
    try:
        if libm.fegetround() != 0x400:
            pytest.skip("another machine")
        with pytest.raises(annulus.Error) as e:
            dt.move(X)
        with pytest.raises(annulus.Error) as built:
            annulus.MovingDelaunay(X)
    finally:
        libm.fesetround(0)
    assert e.value.code == built.value.code == "environment"
    dt.move(X)
    assert dt.audit()
