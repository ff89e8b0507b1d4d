# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus.jax`: with JAX where it is installed; everywhere with a stand-in of a few lines, which makes callbacks and
calls the two halves of a custom derivative as JAX does."""

import importlib
import sys
import types

import annulus
import numpy as np
import pytest


@pytest.fixture
def stand_in(monkeypatch):
    """The module annulus.jax over a stand-in; `vjp(x, dt)` returns volumes and what pulls a gradient back."""
    class CustomVjp:
        def __init__(self, function, nondiff_argnums):
            assert nondiff_argnums == (1,)
            self.function = function

        def __call__(self, x, dt):
            return self.function(x, dt)

        def defvjp(self, forward, backward):
            self.forward, self.backward = forward, backward

        def vjp(self, x, dt):
            out, kept = self.forward(x, dt)
            return out, lambda g: self.backward(dt, kept, g)

    def pure_callback(call, expected, *arguments):
        out = call(*arguments)
        assert (out.shape, out.dtype) == (expected.shape, expected.dtype)
        return out

    fake = types.ModuleType("jax")
    fake.custom_vjp, fake.pure_callback = CustomVjp, pure_callback
    fake.ShapeDtypeStruct = lambda shape, dtype: types.SimpleNamespace(shape=shape, dtype=dtype)
    monkeypatch.setitem(sys.modules, "jax", fake)
    monkeypatch.delitem(sys.modules, "annulus.jax", raising=False)
    yield importlib.import_module("annulus.jax")
    sys.modules.pop("annulus.jax", None)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("shape", [(60, 2), (60, 3), (4, 60, 2)])
def test_stand_in(stand_in, shape, dtype):
    rng = np.random.default_rng(len(shape))
    x = rng.random(shape)
    dt = (annulus.MovingDelaunay if len(shape) == 2 else annulus.MovingDelaunayBatch)(x)
    x = (x + 0.01 * rng.standard_normal(shape)).astype(dtype)
    volumes, pull = stand_in.voronoi_volumes.vjp(x, dt)
    assert np.array_equal(dt.points, x) and volumes.dtype == dtype
    expected = dt.voronoi_volumes()
    assert np.array_equal(volumes, expected.astype(dtype)) and np.array_equal(stand_in.voronoi_volumes(x, dt), volumes)
    g = rng.standard_normal(shape[:-1]).astype(dtype)
    gradient = dt.voronoi_vjp(g)
    dt.move(x.astype(float) + 1e-3)  # JAX may make other calls in between
    pulled, = pull(g)
    assert np.array_equal(dt.points, x) and pulled.dtype == dtype
    assert np.allclose(pulled, gradient, rtol=1e-6 if dtype == np.float32 else 1e-9, atol=1e-9)


def test_without_jax(monkeypatch):
    monkeypatch.setitem(sys.modules, "jax", None)
    monkeypatch.delitem(sys.modules, "annulus.jax", raising=False)
    with pytest.raises(ImportError, match="needs JAX"):
        importlib.import_module("annulus.jax")
    assert "jax" not in annulus.__all__


@pytest.mark.parametrize("d", [2, 3])
def test_with_jax(d):
    jax = pytest.importorskip("jax")
    module = importlib.import_module("annulus.jax")
    dt = annulus.MovingDelaunay(np.random.default_rng(d).random((60, d)).astype(np.float32))
    inner = np.isfinite(dt.voronoi_volumes())
    x = jax.numpy.asarray(dt.points, dtype=np.float32)
    energy = jax.jit(lambda x: (jax.numpy.where(inner, module.voronoi_volumes(x, dt), 0) ** 2).sum())
    gradient = np.asarray(jax.grad(energy)(x))
    expected = dt.voronoi_vjp(np.where(inner, 2 * dt.voronoi_volumes(), 0))
    assert np.allclose(gradient, expected, rtol=1e-4, atol=1e-5 * np.abs(expected).max())
