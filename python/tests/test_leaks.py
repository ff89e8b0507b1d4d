# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand steps leak nothing."""

import gc
import os
import sys

import annulus
import numpy as np
import pytest


def own_memory():
    """Bytes that stand in no file: the system takes pages of programs and libraries away and brings them back as it likes."""
    with open("/proc/self/smaps_rollup", encoding="ascii") as f:
        return next(1024 * int(line.split()[1]) for line in f if line.startswith("Anonymous:"))


def everything(dt, x, rng):
    """A call of all there is."""
    report = dt.move(x)
    _ = report.changed_simplices, report.removed_simplices, report.as_dict(), repr(report), repr(dt)
    _ = dt.points, dt.simplices, dt.neighbors, dt.convex_hull, dt.vertex_neighbor_vertices, dt.vertex_to_simplex, dt.is_vertex
    _ = dt.tolerances, dt.theta, dt.displacements, dt.find_simplex(x[:5]), dt.flat_simplices, dt.voronoi_volumes()
    _ = dt.move(x[:3].astype(np.float32), indices=[0, 1, 2])
    dt.remove([4])
    dt.insert(x[4:5])
    for wrong in (x[:1], np.full_like(x, np.nan), x.astype(complex), None):
        try:
            dt.move(wrong)
        except (annulus.Error, TypeError):
            pass


@pytest.mark.skipif(not os.path.exists("/proc/self/smaps_rollup"), reason="asks Linux how much memory there is")
@pytest.mark.parametrize("d", [2, 3])
def test_a_thousand_steps(d):
    rng = np.random.default_rng(0)
    x = rng.random((60, d))
    dt = annulus.MovingDelaunay(x)
    sizes = []
    for step in range(1000):
        everything(dt, x + 0.01 * rng.standard_normal(x.shape), rng)
        if step % 100 == 99:
            gc.collect()
            sizes.append(own_memory())
    # After the first few hundred it stays where it is; a leak of one position a step would be a megabyte.
    assert sizes[-1] - sizes[3] < 400_000, sizes


@pytest.mark.parametrize("call", [
    lambda: annulus.MovingDelaunay(np.random.default_rng(0).random((3000, 3))).simplices,
    lambda: annulus.lloyd(500, 3),
    lambda: annulus.degeneracy(np.random.default_rng(0).random((300, 3))),
], ids=["construction", "lloyd", "degeneracy"])
def test_objects_go(call):
    sizes = []
    for _ in range(40):
        call()
        gc.collect()
        sizes.append(own_memory())
    assert sizes[-1] - sizes[15] < 3_000_000, sizes


def test_no_object_of_python_stays():
    rng = np.random.default_rng(1)
    x = rng.random((60, 2))
    dt = annulus.MovingDelaunay(x)
    for _ in range(20):
        everything(dt, x, rng)
    gc.collect()
    before = sys.gettotalrefcount() if hasattr(sys, "gettotalrefcount") else len(gc.get_objects())
    for _ in range(100):
        everything(dt, x, rng)
    gc.collect()
    after = sys.gettotalrefcount() if hasattr(sys, "gettotalrefcount") else len(gc.get_objects())
    assert after - before < 50
