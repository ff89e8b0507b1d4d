# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in and out: types, shapes, order, whose memory, how long it lives."""

import ctypes
import gc
import mmap
import os
import sys
import threading
import weakref

import annulus
import numpy as np
import pytest

from support import as_set, check

X = np.random.default_rng(0).random((40, 2))
ARRAYS = ["points", "simplices", "neighbors", "vertex_to_simplex", "is_vertex", "flat_simplices", "convex_hull",
          "tolerances", "theta", "displacements", "vertex_of_input"]


class Likeness:
    def __array__(self, dtype=None):
        return X.astype(dtype) if dtype is not None else X


def misaligned(x):
    raw = np.empty(x.nbytes + 1, dtype=np.uint8)
    out = raw[1:].view(x.dtype).reshape(x.shape)
    out[:] = x
    assert not out.flags.aligned
    return out


FORMS = {
    "as it is": X,
    "Fortran order": np.asfortranarray(X),
    "every other row": np.repeat(X, 2, axis=0)[::2],
    "every other column": np.repeat(X, 2, axis=1)[:, ::2],
    "backwards": X[::-1].copy()[::-1],
    "other byte order": X.astype(">f8"),
    "misaligned": misaligned(X),
    "read-only": np.frombuffer(X.tobytes()).reshape(X.shape),
    "list of lists": X.tolist(),
    "list of tuples": [tuple(p) for p in X],
    "list of arrays": list(X),
    "__array__": Likeness(),
    "subclass": X.view(type("Sub", (np.ndarray,), {})),
}


@pytest.mark.parametrize("form", FORMS)
def test_every_form_is_the_same(form):
    x = FORMS[form]
    dt = annulus.MovingDelaunay(x)
    assert np.array_equal(dt.points, X)
    assert as_set(dt.simplices) == as_set(annulus.MovingDelaunay(X).simplices)
    dt.move(X[::-1].copy())
    dt.move(x)
    assert np.array_equal(dt.points, X)
    dt.move(np.repeat(X[:3] + 5, 2, axis=0)[::2], indices=np.arange(6)[::2])
    assert np.array_equal(dt.points[[0, 2, 4]], X[:3] + 5)


@pytest.mark.parametrize("kind", [np.float32, np.float16, np.int8, np.int64, np.uint16])
def test_other_numbers_are_exact(kind):
    x = np.array([[0, 0], [3, 1], [1, 4], [5, 9], [2, 6]], dtype=kind)
    if np.issubdtype(kind, np.floating):
        x = x / kind(7)
        assert x.dtype == kind
    dt = annulus.MovingDelaunay(x)
    assert dt.points.dtype == np.float64 and np.array_equal(dt.points, x.astype(np.float64))
    dt.move(x + kind(1))
    assert np.array_equal(dt.points, (x + kind(1)).astype(np.float64))


@pytest.mark.parametrize("kind", [np.int64, np.uint64, ">i8"])
def test_whole_numbers_that_are_no_doubles(kind):
    x = np.array([[0, 0], [2**60, 1], [1, 2**53]], dtype=kind)
    dt = annulus.MovingDelaunay(x)
    assert [[int(c) for c in p] for p in dt.points] == x.tolist()
    for wrong in (2**53 + 1, 2**63 - 1, 2**62 + 3):
        y = x.copy()
        y[2, 0] = wrong
        for call in (annulus.MovingDelaunay, dt.move, dt.insert, lambda p: dt.move(p[2:], [1]), annulus.degeneracy):
            for form in (y, y.tolist()):
                with pytest.raises(TypeError, match=str(wrong)):
                    call(form)
    assert np.array_equal(dt.points, x.astype(float))


def test_more_than_memory():
    for n in (2**33, 2**45):
        with pytest.raises(MemoryError):
            annulus.MovingDelaunay(np.broadcast_to(np.float32(0), (n, 3)))


def test_points_from_one():
    """An array whose rows are all the same memory."""
    with pytest.raises(annulus.Error) as e:
        annulus.MovingDelaunay(np.broadcast_to([1.0, 2.0], (5, 2)))
    assert e.value.code == "duplicate_point"
    dt = annulus.MovingDelaunay(np.broadcast_to([1.0, 2.0], (5, 2)), merge_duplicates=True)
    assert dt.npoints == 1 and dt.vertex_of_input.tolist() == [0] * 5


@pytest.mark.parametrize("x", [X.astype(complex), X.astype(object), X.astype("U10"), X.astype(np.longdouble),
                               X.astype("datetime64[s]"), X.astype("S9"), X.view([("x", float), ("y", float)]),
                               X.astype("m8[s]"), [["1", "2"]], np.ma.masked_less(X, 0.1), None, "abc", 3, {1: 2},
                               [[1, 2], [3]]], ids=lambda x: str(getattr(x, "dtype", x)))
def test_what_is_no_point(x):
    with pytest.raises((TypeError, ValueError)):
        annulus.MovingDelaunay(x)
    dt = annulus.MovingDelaunay(X)
    for call in (dt.move, dt.insert, dt.find_simplex):
        with pytest.raises((TypeError, ValueError)):
            call(x)
    assert np.array_equal(dt.points, X)


def test_long_doubles_would_be_rounded():
    with pytest.raises(TypeError):
        annulus.MovingDelaunay(X.astype(np.longdouble))
    with pytest.raises(TypeError, match="masked"):
        annulus.MovingDelaunay(np.ma.masked_less(X, 0.1))


@pytest.mark.parametrize("shape", [(), (0,), (4,), (2, 2, 2), (4, 0), (4, 1), (4, 4), (0, 4)])
def test_other_shapes(shape):
    with pytest.raises(annulus.Error) as e:
        annulus.MovingDelaunay(np.zeros(shape))
    assert e.value.code == "wrong_size"
    dt = annulus.MovingDelaunay(X)
    for call in (dt.move, dt.insert, lambda x: dt.move(x, [0])):
        with pytest.raises(annulus.Error) as e:
            call(np.zeros(shape))
        assert e.value.code == "wrong_size"


@pytest.mark.parametrize("indices", [[True, False], np.ones(40, dtype=bool), [1.0], ["1"], [None], [[0], [1]], [0, -1],
                                     [40], [2**31], [2**62], [2**63], [2**64], np.array([2**64 - 1], dtype=np.uint64),
                                     [1 + 0j], np.ma.masked_array([1, 2], [0, 1])], ids=str)
def test_what_is_no_index(indices):
    dt = annulus.MovingDelaunay(X)
    for call in (dt.remove, lambda i: dt.move(np.random.default_rng(1).random((len(i), 2)), i)):
        with pytest.raises((TypeError, ValueError, OverflowError)):
            call(indices)
    assert np.array_equal(dt.points, X)


def test_no_index_and_one():
    dt = annulus.MovingDelaunay(X)
    assert dt.move(np.zeros((0, 2)), indices=[]).asked == 0
    dt.remove([])
    assert dt.insert(np.zeros((0, 2))).tolist() == []
    dt.remove(5)
    assert dt.npoints == 40 and dt.nvertices == 39
    dt.remove(np.array([6, 7], dtype=np.uint8))
    assert dt.nvertices == 37
    dt.remove(np.array([8, 9], dtype=np.uint64))
    dt.move(X[[10]] + 1, indices=np.array([10], dtype=">i4"))
    dt.move(X[[11, 12]] + 1, indices=(11, np.int8(12)))
    assert dt.nvertices == 35 and np.array_equal(dt.points[10:13], X[10:13] + 1)


def test_nothing_is_copied_that_need_not_be():
    dt = annulus.MovingDelaunay(X)
    for name in ("points", "simplices", "neighbors", "vertex_to_simplex"):
        assert np.shares_memory(getattr(dt, name), getattr(dt, name)), name
    filtered = annulus.MovingDelaunay(X, "tolerances")
    simplices = filtered.simplices
    assert filtered.move(X + 1e-12).within_tolerance == 40
    assert np.shares_memory(simplices, filtered.simplices), "the same simplices, the same array"


def test_only_private_memory_is_read_where_it_is(tmp_path):
    """What another process, a file, or another package may write in is copied before it is looked at: nothing is read
    twice."""
    shared = mmap.mmap(-1, X.nbytes)
    from_map = np.frombuffer(shared).reshape(X.shape)
    from_map[:] = X
    np.save(tmp_path / "x.npy", X)
    buffer = bytearray(X.tobytes())
    numbers = annulus._core.numbers
    for x in (X, np.concatenate([X, X])[:40], np.stack([X, X])[1], X[:7].copy()):
        assert np.shares_memory(numbers(x), x), "NumPy's own, and no other thread"
    for x in (from_map, from_map[3:], np.load(tmp_path / "x.npy", mmap_mode="r"),
              np.load(tmp_path / "x.npy", mmap_mode="r+"), np.frombuffer(buffer).reshape(X.shape),
              np.ctypeslib.as_array((ctypes.c_double * 6)(*range(6))).reshape(3, 2), X.astype(np.int64),
              X.astype(np.float32), X[:, ::-1], X[::2]):
        read = numbers(x)
        assert not np.shares_memory(read, x) and np.array_equal(read, x) and read.flags.c_contiguous
        assert read.dtype == np.float64
    with_another = []
    other = threading.Thread(target=lambda: with_another.append(np.shares_memory(numbers(X), X)))
    other.start()
    other.join()
    assert with_another == [False], "another thread of Python may write"


def test_memory_that_another_process_writes():
    """What is proved is proved of positions as they were at one moment, whatever another process writes."""
    memory = mmap.mmap(-1, 500 * 2 * 8 + 8)
    x = np.frombuffer(memory, count=1000).reshape(500, 2)
    over = np.frombuffer(memory, dtype=np.int64, offset=8000)
    home = np.random.default_rng(4).random((500, 2))
    x[:] = home
    child = os.fork()
    if child == 0:
        try:
            own = np.random.default_rng(5)
            while not over[0]:
                some = own.integers(0, 500, 50)
                x[some] = home[some] + 1e-2 * own.standard_normal((50, 2))
        finally:
            os._exit(0)
    try:
        dt = annulus.MovingDelaunay(home)
        for _ in range(200):
            try:
                dt.move(x)
            except annulus.Error as e:
                assert e.code == "duplicate_point"
            assert dt.audit()
    finally:
        over[0] = 1
        assert os.waitpid(child, 0)[1] == 0


def test_an_argument_is_left_alone():
    x = X.copy()
    x.flags.writeable = False
    before = sys.getrefcount(x)
    dt = annulus.MovingDelaunay(x)
    for _ in range(10):
        dt.move(x)
        with pytest.raises(annulus.Error):
            dt.move(x, [1])
    assert sys.getrefcount(x) == before, "nothing holds it"
    x.flags.writeable = True
    x[0] = 7
    assert np.array_equal(dt.points, X), "nothing reads it"


@pytest.mark.parametrize("name", ARRAYS)
def test_an_array_outlives_everything(name):
    dt = annulus.MovingDelaunay(X)
    array = getattr(dt, name)
    before = array.copy()
    dt.move(X[::-1].copy())
    dt.insert(np.random.default_rng(1).random((200, 2)) + 2)
    dt.remove(np.arange(30))
    assert np.array_equal(array, before)
    gone = weakref.ref(dt)
    del dt
    gc.collect()
    assert gone() is None
    junk = [np.full(before.shape, -7, dtype=before.dtype) for _ in range(50)]
    assert np.array_equal(array, before) and len(junk) == 50


def test_what_is_shared_is_read_only():
    dt = annulus.MovingDelaunay(X)
    for array in (dt.points, dt.simplices, dt.neighbors, dt.vertex_to_simplex, *dt.vertex_neighbor_vertices,
                  dt.vertex_of_input):
        with pytest.raises(ValueError):
            array[0] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True
    for array in (dt.tolerances, dt.theta, dt.displacements, dt.convex_hull, dt.find_simplex(X), dt.insert([[3, 3]])):
        array[0] = 0  # of this array alone
    check(dt)


def test_reference_counts():
    dt = annulus.MovingDelaunay(X, report_changes=True)
    own = sys.getrefcount(dt)
    arrays = [getattr(dt, name) for name in ARRAYS]
    report = dt.move(X + 0.1)
    changed = report.changed_simplices
    assert sys.getrefcount(dt) == own, "arrays hold their memory, and not the triangulation"
    base = arrays[0].base
    held = sys.getrefcount(base)  # by the array, the name and, until Python 3.13, the argument
    del arrays
    assert sys.getrefcount(base) == held - 1, "the array held it once, and nothing else let go"
    before = changed.copy()
    del report, dt
    gc.collect()
    assert np.array_equal(changed, before)


def test_moving_by_its_own_points():
    dt = annulus.MovingDelaunay(X)
    dt.move(dt.points)
    dt.move(dt.points[5:9], indices=range(5, 9))
    assert np.array_equal(dt.points, X)
    dt.insert(dt.points[:3] + 0.5)
    check(dt)


@pytest.mark.parametrize("box", [None, [1, 1]], ids=["open", "periodic"])
def test_a_triangulation_is_no_array(box):
    dt = annulus.MovingDelaunay(X, box=box)
    interpolate = pytest.importorskip("scipy.interpolate")
    values = X[:, 0]
    for wrong in (lambda: interpolate.LinearNDInterpolator(dt, values),
                  lambda: interpolate.CloughTocher2DInterpolator(dt, values),
                  lambda: interpolate.NearestNDInterpolator(dt, values), lambda: np.asarray(dt),
                  lambda: np.array([dt, dt]), lambda: np.asarray(dt, dtype=float), lambda: annulus.MovingDelaunay(dt)):
        with pytest.raises(TypeError, match=r"neither an array nor a scipy\.spatial\.Delaunay: dt\.points"):
            wrong()
    with pytest.raises(TypeError, match=r"dt\.interpolate\(values, x\) interpolates"):
        np.asarray(dt)
    several = np.array([dt, dt], dtype=object)
    assert several.shape == (2,) and several[0] is dt and np.array(dt, dtype=object)[()] is dt
