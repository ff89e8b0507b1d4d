# SPDX-License-Identifier: GPL-3.0-or-later
"""`out=` and `dtype=`: the same numbers, rounded once; what is not fit for them is refused, and nothing is written."""

import annulus
import numpy as np
import pytest


def methods(dt, rng):
    """Name, call, shape of the result and an array among the arguments, of every method that has `out`."""
    n, d = dt.npoints, dt.ndim
    g, values, xi = rng.standard_normal(n), rng.random((n, 2)), rng.random((3, 4, d))
    box = np.array([[0.0] * d, [1.0] * d])
    return {"volumes": (lambda **more: dt.voronoi_volumes(**more), (n,), None),
            "clipped": (lambda **more: dt.voronoi_volumes(box, **more), (n,), box),
            "vjp": (lambda **more: dt.voronoi_vjp(g, **more), (n, d), g),
            "interpolate": (lambda **more: dt.interpolate(values, xi, **more), (3, 4, 2), values)}


def every_method(d):
    """The same, those of a periodic box included."""
    rng = np.random.default_rng(d)
    dt = annulus.MovingDelaunay(rng.random((50, d)))
    dt.remove([7])
    periodic = annulus.MovingDelaunay(rng.random((50, d)), box=[1.0] * d)
    g = rng.standard_normal(50)
    return methods(dt, rng) | {"periodic": (lambda **more: periodic.voronoi_volumes(**more), (50,), None),
                               "periodic vjp": (lambda **more: periodic.voronoi_vjp(g, **more), (50, d), g)}


CALLS = [(d, name) for d in (2, 3) for name in ("volumes", "clipped", "vjp", "interpolate", "periodic",
                                           "periodic vjp")]


@pytest.mark.parametrize("d, name", CALLS)
def test_the_same_numbers(d, name):
    call, shape, _ = every_method(d)[name]
    plain = call()
    assert plain.shape == shape and plain.dtype == np.float64
    single = plain.astype(np.float32)
    assert not np.array_equal(single, plain, equal_nan=True)
    for dtype, numbers in ((np.float64, plain), (np.float32, single), ("float32", single), (float, plain)):
        given = call(dtype=dtype)
        assert given.dtype == np.dtype(dtype) and np.array_equal(given, numbers, equal_nan=True)
        out = np.full(shape, -1.0, dtype)
        assert call(out=out) is out and np.array_equal(out, numbers, equal_nan=True)
        assert call(out=out, dtype=dtype) is out


@pytest.mark.parametrize("d, name", CALLS)
def test_what_is_refused(d, name):
    call, shape, argument = every_method(d)[name]

    def refused(out, kind, code=None, **more):
        before = np.copy(out)
        with pytest.raises(kind, match="out|dtype") as caught:
            call(out=out, **more)
        assert code is None or caught.value.code == code
        assert not isinstance(out, np.ndarray) or np.array_equal(out, before)

    for wrong in ([0.0] * shape[0], np.ma.zeros(shape), np.zeros(shape, int), np.zeros(shape, complex),
                  np.zeros(shape, np.float16), np.zeros(shape, ">f8"), "x"):
        refused(wrong, TypeError)
    refused(np.zeros(shape), TypeError, dtype=np.float32)
    for wrong in ((shape[0] + 1, *shape[1:]), (1, *shape), ()):
        refused(np.zeros(wrong), annulus.Error, "wrong_size")
    refused(np.zeros((2 * shape[0], *shape[1:]))[::2], annulus.Error, "usage")
    bytes_of = np.zeros(8 * int(np.prod(shape)) + 1, np.uint8)[1:]
    refused(bytes_of.view(np.float64).reshape(shape), annulus.Error, "usage")
    if len(shape) > 1:
        refused(np.zeros(shape, order="F"), annulus.Error, "usage")
    fixed = np.zeros(shape)
    fixed.flags.writeable = False
    refused(fixed, annulus.Error, "usage")
    for dtype in (np.int32, np.float16, complex, ">f4", "nothing", 3):
        with pytest.raises(TypeError, match="dtype"):
            call(dtype=dtype)
    if argument is not None:  # one block of memory, of which the argument is the beginning
        whole = np.zeros(argument.size + int(np.prod(shape)))
        beside = whole[argument.size:].reshape(shape)
        over = whole[argument.size - 1:-1].reshape(shape)
        whole[:argument.size] = argument.ravel()
        moved = whole[:argument.size].reshape(argument.shape)
        x = np.random.default_rng(1).random((50, d))
        dt, periodic = annulus.MovingDelaunay(x), annulus.MovingDelaunay(x, box=[1.0] * d)
        again = {"clipped": lambda out: dt.voronoi_volumes(moved, out=out),
                 "vjp": lambda out: dt.voronoi_vjp(moved, out=out),
                 "periodic vjp": lambda out: periodic.voronoi_vjp(moved, out=out),
                 "interpolate": lambda out: dt.interpolate(moved, np.full((3, 4, d), 0.5), out=out)}[name]
        with pytest.raises(annulus.Error, match="overlap") as caught:
            again(over)
        assert caught.value.code == "usage" and not beside.any()
        assert again(beside) is beside and beside.any()


def test_nothing_is_written_if_the_call_fails():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((50, 2)))
    out = np.full((50, 2), -1.0)
    with pytest.raises(annulus.Error):
        dt.voronoi_vjp(np.ones(49), out=out)
    assert (out == -1).all()


@pytest.mark.filterwarnings("error")
def test_rounding_to_float32():
    """To nearest, ties to even; too large is infinite, too small 0, and without a warning."""
    wide = annulus.MovingDelaunay(1e30 * np.random.default_rng(0).random((50, 2)))
    assert np.isinf(wide.voronoi_volumes(dtype=np.float32)).all()
    narrow = annulus.MovingDelaunay(1e-30 * np.random.default_rng(0).random((50, 2)))
    finite = np.isfinite(narrow.voronoi_volumes())
    assert (narrow.voronoi_volumes(dtype=np.float32)[finite] == 0).all() and finite.sum() > 30
    grid = np.stack(np.meshgrid(*[np.arange(3.0)] * 2), -1).reshape(-1, 2)
    for k, rounded in ((1, 0), (3, 4), (5, 4)):  # areas 1 + k 2**-24, halfway between two floats
        stretched = annulus.MovingDelaunay(grid * [1 + k * 2.0**-24, 1])
        assert stretched.voronoi_volumes()[4] == 1 + k * 2.0**-24
        assert stretched.voronoi_volumes(dtype=np.float32)[4] == 1 + rounded * 2.0**-24
