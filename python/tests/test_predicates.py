# SPDX-License-Identifier: GPL-3.0-or-later
"""annulus.predicates and annulus.audit, compared with fractions and with SciPy."""

import doctest
import threading
from fractions import Fraction

import annulus
import annulus._functions
import numpy as np
import pytest
import scipy.spatial
from annulus import predicates

SHAPES = {"orient_2d": (3, 2), "orient_3d": (4, 3), "in_circle": (4, 2), "in_sphere": (5, 3)}


def determinant(m):
    if len(m) == 1:
        return m[0][0]
    return sum((-1)**k * m[0][k] * determinant([row[:k] + row[k + 1:] for row in m[1:]]) for k in range(len(m)))


def exact_sign(name, row):
    """By fractions: of the differences to the last point, lifted for circles and spheres."""
    k, d = SHAPES[name]
    x = [[Fraction(c) for c in p] for p in row.tolist()]
    m = [[a - b for a, b in zip(p, x[-1])] for p in x[:-1]]
    if k == d + 2:
        m = [p + [sum(c * c for c in p)] for p in m]
    value = determinant(m) * (-1 if d == 3 else 1)
    return (value > 0) - (value < 0)


def rows(name, n, seed):
    rng = np.random.default_rng(seed)
    k, d = SHAPES[name]
    yield rng.random((n, k, d))
    yield rng.integers(0, 4, (n, k, d)).astype(float)  # degenerate, many of them
    grid = rng.integers(0, 4, (n, k, d)).astype(float)
    yield grid + rng.integers(-2, 3, grid.shape) * 2.0**-52
    yield np.ldexp(rng.random((n, k, d)) - 0.5, rng.integers(-600, 400, (n, k, d)))


@pytest.mark.parametrize("name", SHAPES)
def test_signs_are_exact_and_tolerances_hold(name):
    rng = np.random.default_rng(1)
    zeros = 0
    for x in rows(name, 40, 3):
        s = getattr(predicates, name)(x)
        assert s.shape == (40,)
        assert s.dtype.names == ("sign", "tolerance", "width_lower", "width_upper", "theta", "stage")
        assert s["sign"].tolist() == [exact_sign(name, row) for row in x]
        zero = s["sign"] == 0
        zeros += zero.sum()
        assert not s["tolerance"][zero].any() and not s["width_upper"][zero].any() and (s["stage"][zero] == 2).all()
        assert (s["width_lower"] <= s["width_upper"]).all() and (s["tolerance"] * 2 <= s["width_upper"]).all()
        assert (s["tolerance"][~zero] > 0).all()
        assert np.isnan(s["theta"]).all() == name.startswith("orient")
        # Where every point moves by less than the tolerance, the sign stays.
        way = rng.standard_normal(x.shape)
        way *= (0.99 / np.linalg.norm(way, axis=2))[..., None] * s["tolerance"][:, None, None]
        moved = x + way
        within = (np.linalg.norm(moved - x, axis=2) < s["tolerance"][:, None]).all(axis=1)
        for row, sign, inside in zip(moved, s["sign"], within):
            assert not inside or exact_sign(name, row) == sign
    assert zeros > 5


def test_shapes_and_types():
    x = np.zeros((2, 3, 4, 2))
    assert predicates.in_circle(x).shape == (2, 3) and predicates.in_circle(x[0, 0]).shape == ()
    assert predicates.in_circle(x[:0]).shape == (0, 3)
    assert predicates.orient_2d(np.array([[0, 0], [1, 0], [0, 1]], dtype=np.float32))["sign"] == 1
    assert predicates.STAGES[predicates.orient_2d([[0, 0], [1, 0], [0, 1]])["stage"]] == "filter"
    for name, (k, d) in SHAPES.items():
        call = getattr(predicates, name)
        for wrong in (np.zeros((k, d + 1)), np.zeros((k - 1, d)), np.zeros(d)):
            with pytest.raises(annulus.Error) as e:
                call(wrong)
            assert e.value.code == "wrong_size"
        x = np.random.default_rng(0).random((5, k, d))
        for value, code in [(np.nan, "not_finite"), (-np.inf, "not_finite"), (1e200, "out_of_domain")]:
            x[3, 1, 1] = value
            with pytest.raises(annulus.Error) as e:
                call(x)
            assert e.value.code == code and e.value.vertices == (3,)
        with pytest.raises(TypeError):
            call(x.astype(complex))


def test_several_threads():
    x = np.random.default_rng(2).integers(0, 3, (2000, 4, 2))
    alone = predicates.in_circle(x)
    said = []
    threads = [threading.Thread(target=lambda: said.append(predicates.in_circle(x))) for _ in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert len(said) == 4 and all(s.tobytes() == alone.tobytes() for s in said)


@pytest.mark.parametrize("d", [2, 3])
def test_audit_of_ours_and_of_scipys(d):
    rng = np.random.default_rng(d)
    x = rng.random((200, d))
    dt = annulus.MovingDelaunay(x)
    assert annulus.audit(x, dt.simplices) == dt.audit()
    assert annulus.audit(x, rng.permuted(dt.simplices, axis=1).astype(np.int64))
    theirs = scipy.spatial.Delaunay(x)
    assert annulus.audit(x, theirs.simplices), "corners have any orientation there"
    # SciPy joggles or drops nothing here: a grid has points on one circle, which is no fault.
    grid = np.indices((4,) * d).reshape(d, -1).T
    own = annulus.MovingDelaunay(grid)
    assert annulus.audit(grid, own.simplices).degenerate_facets == own.audit().degenerate_facets > 0
    # Points that move, and simplices that stay.
    moved = annulus.audit(x + 0.02 * rng.standard_normal(x.shape), dt.simplices, max_faults=10**6)
    count = (moved.inverted_cells + moved.violated_facets + moved.concave_ridges + moved.topological_faults)
    assert not moved and len(moved.faults) == count
    for f in moved.faults:
        for s in f.simplices:
            assert set(f.vertices) & set(dt.simplices[s].tolist())
    assert annulus.audit(x, dt.simplices, max_faults=0).faults == ()


def test_audit_names_what_is_wrong():
    kite = [[0, 0], [4, 0], [5, 5], [0, 4]]
    (fault,) = annulus.audit(kite, [[0, 1, 2], [3, 0, 2]]).faults
    assert fault.kind == "not_delaunay" and sorted(fault.simplices) == [0, 1] and set(fault.vertices) == {0, 1, 2, 3}
    for simplices, kind, vertices, numbers in [
            ([[0, 1, 3], [1, 2, 9]], "unknown_vertex", (1, 2, 9), (1,)),
            ([[0, 1, 3], [1, 2, -1]], "unknown_vertex", (1, 2, -1), (1,)),
            ([[1, 3, 0]], "unused_vertex", (2,), ())]:
        fault = annulus.audit(kite, simplices).faults[0]
        assert (fault.kind, fault.vertices, fault.simplices) == (kind, vertices, numbers)
    twice = annulus.audit(kite, [[0, 1, 3], [1, 2, 3], [1, 0, 3]])
    assert twice.faults[0].kind == "overlap" and twice.faults[0].simplices == (0, 2)
    flat = annulus.audit([*kite, [2, 0]], [[0, 1, 3], [1, 2, 3], [0, 4, 1]])
    assert flat.faults[0].kind == "flat_cell" and flat.faults[0].simplices == (2,) and not flat
    doubled = annulus.audit([*kite, kite[1]], [[0, 1, 3], [1, 2, 3]])
    assert {f.kind for f in doubled.faults} == {"unused_vertex", "duplicate_point"}


def test_audit_of_flat_points():
    for x in ([[0, 0], [1, 1], [3, 3], [2, 2]], [[0, 0, 1], [1, 0, 1], [0, 1, 1], [2, 2, 1], [1, 0.5, 1]]):
        dt = annulus.MovingDelaunay(x)
        assert annulus.audit(x, dt.flat_simplices)
        assert not annulus.audit(x, dt.flat_simplices[1:])
    assert annulus.audit(np.zeros((0, 3)), np.zeros((0, 4), dtype=int))


def test_what_audit_refuses():
    x = np.random.default_rng(0).random((20, 2))
    simplices = annulus.MovingDelaunay(x).simplices
    bad = x.copy()
    bad[3, 1] = np.nan
    for points, cells, code in [(bad, simplices, "not_finite"), (x[:, :1], simplices, "wrong_size"),
                                (x, np.zeros((2, 4), dtype=int), "wrong_size"), (x, simplices[0], "wrong_size"),
                                (x, [[0, 1, -5]], "unknown_vertex"), (x, [[0, 1, 2**40]], "unknown_vertex")]:
        with pytest.raises(annulus.Error) as e:
            annulus.audit(points, cells)
        assert e.value.code == code
    for cells in (simplices.astype(float), simplices == 1, None):
        with pytest.raises(TypeError):
            annulus.audit(x, cells)


def test_examples():
    assert doctest.testmod(predicates).failed == 0
    assert doctest.testmod(annulus._functions).failed == 0
