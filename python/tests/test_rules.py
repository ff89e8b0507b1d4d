# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules that hold in every language, as tables: what there is at a free index, what `threads` may be, defaults, order
of arguments, which vertices an error names. tests/engine/rules_test.cpp and tests/c/rules.c are the same tables."""

import inspect

import annulus
import numpy as np
import pytest

from support import STRATEGIES, check


def some_points(n, d, seed):
    return np.random.default_rng(seed).random((n, d))


# ---- A free index has NaN, no neighbours and no simplex --------------------------------------------------------------

ABSENT = {
    "points": lambda dt, i: np.isnan(dt.points[i]).all(),
    "tolerances": lambda dt, i: np.isnan(dt.tolerances[i]),
    "theta": lambda dt, i: np.isnan(dt.theta[i]),
    "displacements": lambda dt, i: np.isnan(dt.displacements[i]),
    "voronoi_volumes": lambda dt, i: np.isnan(dt.voronoi_volumes()[i]),
    "vertex_to_simplex": lambda dt, i: dt.vertex_to_simplex[i] == -1,
    "vertex_neighbor_vertices": lambda dt, i: np.diff(dt.vertex_neighbor_vertices[0])[i] == 0,
    "simplices": lambda dt, i: not (dt.simplices == i).any(),
    "is_vertex": lambda dt, i: not dt.is_vertex[i],
}


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("strategy", STRATEGIES)
def test_free_indices(strategy, d):
    x = some_points(40, d, 1)
    dt = annulus.MovingDelaunay(x, strategy)

    def look(free):
        for name, is_absent in ABSENT.items():
            assert [i for i in range(dt.npoints) if is_absent(dt, i)] == free, name
        check(dt)

    look([])
    dt.remove([4, 9])
    look([4, 9])
    for step in (1e-9, 0.3):
        dt.move(x + step * x[:, ::-1])  # with numbers at free indices
        look([4, 9])
        dt.move(dt.points)  # with NaN there
        look([4, 9])
    with pytest.raises(annulus.Error):
        dt.insert(dt.points[[7]])
    look([4, 9])
    assert dt.insert(some_points(1, d, 2)).tolist() == [9]
    look([4])


# ---- threads, defaults, order of arguments ---------------------------------------------------------------------------

@pytest.mark.parametrize("threads, allowed", [(1, True), (2, True), (7, True), (0, False), (-1, False), (-3, False),
                                              (-2**31, False)])
def test_threads(threads, allowed):
    x = some_points(20, 2, 3)
    for call in (lambda: annulus.MovingDelaunay(x, threads=threads), lambda: annulus.lloyd(10, 1, threads=threads),
                 lambda: annulus.nodt("sphere", 30, 1, threads=threads)):
        if allowed:
            call()
            continue
        with pytest.raises(annulus.Error) as e:
            call()
        assert e.value.code == "usage" and "threads must be 1 or more" in str(e.value)


def test_defaults():
    parameters = inspect.signature(annulus.MovingDelaunay).parameters
    for name, default in {"strategy": "auto", "tolerance": "certified", "threads": 1, "merge_duplicates": False,
                          "report_changes": True, "seed": 0}.items():
        assert parameters[name].default == default and type(parameters[name].default) is type(default), name
    x = some_points(30, 2, 4)
    r = annulus.MovingDelaunay(x).move(x + 0.3 * x[:, ::-1] ** 2)
    assert r.flipped + r.rebuilt > 0 and len(r.changed_simplices) > 0


def test_order_of_arguments():
    """In C++ and C indices come before points; here points come first, since indices may be left out."""
    assert list(inspect.signature(annulus.MovingDelaunay.move).parameters) == ["self", "points", "indices"]
    dt = annulus.MovingDelaunay(some_points(20, 2, 5))
    for call in (lambda to: dt.move(to, indices=[3, 1]), lambda to: dt.move(to, [3, 1])):
        to = dt.points[[3, 1]] + [[0.01, 0], [0, 0.01]]
        call(to)
        assert np.array_equal(dt.points[[3, 1]], to)


# ---- Errors name all vertices ----------------------------------------------------------------------------------------

@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("strategy", STRATEGIES)
def test_errors_name_all_vertices(strategy, d):
    x = some_points(40, d, 6)

    def but(rows, place):
        y = x.copy()
        y[rows] = x[place] if isinstance(place, int) else place
        return y

    nan = float("nan")
    dt = annulus.MovingDelaunay(x, strategy)
    dt.remove([6])
    for name, call, code, vertices in [
            ("two points", lambda: annulus.MovingDelaunay(but([9], 4), strategy), "duplicate_point", (4, 9)),
            ("three points", lambda: annulus.MovingDelaunay(but([9, 2], 4), strategy), "duplicate_point", (2, 4, 9)),
            ("NaN", lambda: annulus.MovingDelaunay(but([9, 5], nan), strategy), "not_finite", (5, 9)),
            ("all: three", lambda: dt.move(but([9, 30], 4)), "duplicate_point", (4, 9, 30)),
            ("all: far", lambda: dt.move(but([9, 4, 7], 1e200)), "out_of_domain", (4, 7, 9)),
            ("all: NaN", lambda: dt.move(but([6, 8], nan)), "not_finite", (8,)),
            ("some: three", lambda: dt.move(x[[3, 3]], [5, 8]), "duplicate_point", (3, 5, 8)),
            ("some: NaN", lambda: dt.move(but([8, 5], nan)[[8, 5]], [8, 5]), "not_finite", (5, 8)),
            ("some: unknown", lambda: dt.move(x[:4], [6, 1, -1, 99]), "unknown_vertex", (-1, 6, 99)),
            ("some: beyond", lambda: dt.move(x[:3], [1, 2**40, 2**41]), "unknown_vertex", (2**40, 2**41)),
            ("insert: NaN", lambda: dt.insert(but([1, 3], nan)[:4] + 5), "not_finite", (1, 3)),
            ("insert: taken", lambda: dt.insert(x[[7]]), "duplicate_point", (7,)),
            ("insert: two taken", lambda: dt.insert([x[7], x[0] + 3, x[2]]), "duplicate_point", (2, 7)),
            ("remove", lambda: dt.remove([6, 1, 1, 99]), "unknown_vertex", (1, 6, 99)),
            ("degeneracy", lambda: annulus.degeneracy(but([9, 30], 4)), "duplicate_point", (4, 9, 30)),
            ("degeneracy", lambda: annulus.degeneracy(but([9, 30], nan)), "not_finite", (9, 30)),
            ("audit", lambda: annulus.audit(but([9, 30], nan), [list(range(d + 1))]), "not_finite", (9, 30)),
            ("lloyd", lambda: annulus.lloyd(but([9, 30], nan)[:, :2], 1), "not_finite", (9, 30))]:
        with pytest.raises(annulus.Error) as e:
            call()
        assert (e.value.code, e.value.vertices) == (code, vertices), (name, str(e.value))
    check(dt)


def test_predicates_name_all_rows():
    rows = some_points(20, 3, 7).reshape(5, 4, 3)
    rows[[1, 3], 2] = np.inf
    with pytest.raises(annulus.Error) as e:
        annulus.predicates.orient_3d(rows)
    assert (e.value.code, e.value.vertices) == ("not_finite", (1, 3))


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("points, simplices, delaunay", [(0, [], True), (1, [], True), (2, [], False),
                                                         (2, [[0, 1]], True), (1, [[0, 0]], False),
                                                         (1, [[0, 1]], False)])
def test_a_single_point_is_delaunay_without_simplices(points, simplices, delaunay, d):
    cells = np.array(simplices, dtype=int).reshape(len(simplices), 2 if simplices else d + 1)
    assert annulus.audit(some_points(points, d, 8), cells).delaunay == delaunay
    assert annulus.MovingDelaunay(some_points(1, d, 9)).audit()
