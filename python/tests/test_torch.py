# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus.torch`: with PyTorch where it is installed; everywhere with a stand-in of a few lines, which calls `forward`
and `backward` as PyTorch does."""

import importlib
import sys
import types

import annulus
import numpy as np
import pytest


class Tensor:
    """What annulus.torch uses of a tensor."""

    def __init__(self, values):
        self.values = values

    def detach(self):
        return self

    cpu = detach

    def numpy(self):
        return self.values

    def to(self, other):
        return Tensor(self.values.astype(other.values.dtype))


@pytest.fixture
def stand_in(monkeypatch):
    """The module annulus.torch over a stand-in, and how to differentiate: values and pull of a call."""
    class Function:
        @classmethod
        def apply(cls, *arguments):
            context = types.SimpleNamespace()
            out = cls.forward(context, *arguments)
            out.backward = lambda g: cls.backward(context, g)
            return out

    fake = types.ModuleType("torch")
    fake.autograd = types.SimpleNamespace(Function=Function)
    fake.from_numpy = Tensor
    monkeypatch.setitem(sys.modules, "torch", fake)
    monkeypatch.delitem(sys.modules, "annulus.torch", raising=False)
    yield importlib.import_module("annulus.torch")
    sys.modules.pop("annulus.torch", None)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("shape", [(60, 2), (60, 3), (4, 60, 2)])
def test_stand_in(stand_in, shape, dtype):
    rng = np.random.default_rng(len(shape))
    x = rng.random(shape)
    dt = (annulus.MovingDelaunay if len(shape) == 2 else annulus.MovingDelaunayBatch)(x)
    x = (x + 0.01 * rng.standard_normal(x.shape)).astype(dtype)
    volumes = stand_in.voronoi_volumes(Tensor(x), dt)
    assert np.array_equal(dt.points, x) and volumes.values.dtype == dtype
    assert np.array_equal(volumes.values, dt.voronoi_volumes().astype(dtype))
    g = rng.standard_normal(shape[:-1]).astype(dtype)
    gradient, nothing = volumes.backward(Tensor(g))
    assert nothing is None and gradient.values.dtype == dtype
    assert np.array_equal(gradient.values, dt.voronoi_vjp(g).astype(dtype))
    dt.move(dt.points + 1e-3)
    with pytest.raises(RuntimeError, match="before the next change"):
        volumes.backward(Tensor(g))


def test_without_torch(monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", None)
    monkeypatch.delitem(sys.modules, "annulus.torch", raising=False)
    with pytest.raises(ImportError, match="needs PyTorch"):
        importlib.import_module("annulus.torch")
    assert "torch" not in annulus.__all__


@pytest.mark.parametrize("d", [2, 3])
def test_with_torch(d):
    torch = pytest.importorskip("torch")
    module = importlib.import_module("annulus.torch")
    dt = annulus.MovingDelaunay(np.random.default_rng(d).random((60, d)))
    inner = torch.from_numpy(np.isfinite(dt.voronoi_volumes()))
    x = torch.tensor(dt.points.copy(), requires_grad=True)
    energy = (module.voronoi_volumes(x, dt)[inner] ** 2).sum()
    energy.backward()
    volumes = dt.voronoi_volumes()
    assert np.allclose(x.grad.numpy(), dt.voronoi_vjp(np.where(np.isfinite(volumes), 2 * volumes, 0)))
