# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand steps leak nothing."""

import ctypes
import gc
import sys

import annulus
import numpy as np
import pytest


class Mallinfo(ctypes.Structure):
    """What mallinfo2 of the GNU C library returns."""

    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks",
                                                     "fsmblks", "uordblks", "fordblks", "keepcost")]


def held():
    """Bytes that malloc has given and not been given back, and blocks of Python's own: counted, and not what the
    system says is resident, which depends on what else it does."""
    ask = ctypes.CDLL(None).mallinfo2
    ask.restype = Mallinfo
    info = ask()
    return info.uordblks + info.hblkhd, sys.getallocatedblocks()


counts = pytest.mark.skipif(not hasattr(ctypes.CDLL(None), "mallinfo2"),
                            reason="reads the counters of the GNU C library, 2.33 or later")


def assert_none_is_lost(sizes, steps):
    """What is lost at each step is missing in every interval of so many steps, malloc's least block being 32 bytes;
    tables that grow, of Python or of ours, grow in some. What is noted is three blocks itself."""
    print(sizes)
    assert sizes[-1][0] - sizes[0][0] < 100_000, sizes  # nor what is lost now and then
    for taken, least in zip(zip(*sizes), (30 * steps, 3 + steps // 2)):
        assert min(b - a for a, b in zip(taken, taken[1:])) < least, sizes


def everything(dt, x, rng):
    """A call of all there is."""
    report = dt.move(x)
    _ = report.changed_simplices, report.removed_simplices, report.as_dict(), repr(report), repr(dt)
    _ = (dt.points, dt.simplices, dt.neighbors, dt.convex_hull, dt.vertex_neighbor_vertices, dt.vertex_to_simplex,
         dt.is_vertex)
    _ = dt.tolerances, dt.theta, dt.displacements, dt.find_simplex(x[:5]), dt.flat_simplices, dt.voronoi_volumes()
    _ = report.edges_made, dt.edges, dt.neighbor_list("ijdDSA"), dt.neighbor_counts(), dt.nearest_vertex(x[:5])
    box = [x.min(axis=0), x.max(axis=0) + 1]
    _ = dt.voronoi(clip=box).regions, dt.voronoi_vjp(x[:, 0]), dt.voronoi_jacobian(), dt.voronoi_volumes(clip=box)
    _ = dt.voronoi_polytopes(box).faces(5)
    _ = dt.interpolate(x, x[:5] + 1e-3)
    out = np.empty_like(x, np.float32)
    _ = dt.voronoi_volumes(out=out[:, 0].copy()), dt.voronoi_vjp(x[:, 0], out=out), dt.voronoi_vjp(x[:, 0], dtype=float)
    _ = dt.interpolate(x, x[:5] + 1e-3, dtype=np.float32)
    rows = x[:(d := x.shape[1]) + 2]
    _ = (annulus.predicates.in_circle if d == 2 else annulus.predicates.in_sphere)(rows), annulus.audit(x, dt.simplices)
    _ = annulus.audit(x[:-1], dt.simplices[::-1]).faults
    _ = dt.move(x[:3].astype(np.float32), indices=[0, 1, 2])
    dt.remove([4])
    dt.insert(x[4:5])
    batch = annulus.MovingDelaunayBatch([x, x + 1])
    _ = batch.move([x + 1, x]), batch.points, batch.voronoi_volumes(), batch.voronoi_vjp(x[:, 0] + [[0], [1]]), batch[1]
    for wrong in ([x, np.zeros_like(x)], [x], [x[1:], x[1:]], None):
        try:
            batch.move(wrong)
        except (annulus.Error, TypeError):
            pass
    for wrong in (x, out[1:], None, out[:, :1]):
        try:
            dt.voronoi_vjp(x[:, 0], out=wrong)
        except (annulus.Error, TypeError):
            pass
    for wrong in (x[:1], np.full_like(x, np.nan), x.astype(complex), None):
        try:
            dt.move(wrong)
        except (annulus.Error, TypeError):
            pass


@counts
@pytest.mark.parametrize("d", [2, 3])
def test_a_thousand_steps(d):
    rng = np.random.default_rng(0)
    x = rng.random((60, d))
    dt = annulus.MovingDelaunay(x, report_changes=True)
    sizes = []
    for step in range(1000):
        everything(dt, x + 0.01 * rng.standard_normal(x.shape), rng)
        if step % 100 == 99:
            gc.collect()
            sizes.append(held())
    assert_none_is_lost(sizes[3:], 100)


@counts
@pytest.mark.parametrize("call", [
    lambda: annulus.MovingDelaunay(np.random.default_rng(0).random((3000, 3))).simplices,
    lambda: annulus.lloyd(500, 3),
    lambda: annulus.degeneracy(np.random.default_rng(0).random((300, 3))),
], ids=["construction", "lloyd", "degeneracy"])
def test_objects_go(call):
    sizes = []
    for step in range(40):
        call()
        if step % 8 == 7:
            gc.collect()
            sizes.append(held())
    assert_none_is_lost(sizes[1:], 8)


def test_no_object_of_python_stays():
    rng = np.random.default_rng(1)
    x = rng.random((60, 2))
    dt = annulus.MovingDelaunay(x, report_changes=True)
    for _ in range(20):
        everything(dt, x, rng)
    gc.collect()
    before = sys.gettotalrefcount() if hasattr(sys, "gettotalrefcount") else len(gc.get_objects())
    for _ in range(100):
        everything(dt, x, rng)
    gc.collect()
    after = sys.gettotalrefcount() if hasattr(sys, "gettotalrefcount") else len(gc.get_objects())
    assert after - before < 50
