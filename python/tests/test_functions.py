# SPDX-License-Identifier: GPL-3.0-or-later
"""degeneracy, counterexample, lloyd, nodt; beside the tool where it was built (ANNULUS_TOOL)."""

import csv
import fractions
import json
import os
import subprocess

import annulus
import numpy as np
import pytest
import scipy.spatial

TOOL = os.environ.get("ANNULUS_TOOL", "")
with_tool = pytest.mark.skipif(not TOOL, reason="the tool was not built")
GRID = np.indices((6, 6)).reshape(2, -1).T
# The tetrahedron with corners at the origin and the unit vectors, seen from outside.
TETRAHEDRON = (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]),
               np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))


def tool(directory, *words):
    subprocess.run([TOOL, *map(str, words)], cwd=directory, check=True, stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL)


def write_xyz(path, points):
    path.write_text("".join(" ".join(map(repr, p)) + "\n" for p in points.tolist()), encoding="utf-8")


def test_degeneracy_of_a_grid():
    r = annulus.degeneracy(GRID)
    assert (r["dimension"], r["affine_dimension"], r["vertices"], r["simplices"], r["merged"]) == (2, 2, 36, 50, 0)
    assert (r["bicells"]["total"], r["bicells"]["zero"]) == (65, 25)
    assert (r["ridges"]["total"], r["ridges"]["zero"]) == (20, 16)
    assert [t["name"] for t in r["thresholds"]] == ["1e-3", "1e-6", "1e-9", "1e-12", "ulp"]
    json.dumps(r)
    r = annulus.degeneracy(np.random.default_rng(0).random((200, 3)).astype(np.float32))
    assert r["dimension"] == 3 and r["bicells"]["zero"] == 0 and r["bicells"]["total"] > 1000


@with_tool
@pytest.mark.parametrize("d", [2, 3])
def test_degeneracy_has_the_values_of_every_certificate(tmp_path, d):
    x = np.random.default_rng(d).random((40, d))
    x[-8:] = np.indices((2,) * 3).reshape(3, -1).T[:, :d] / 8 + 2  # in 2D two at each place
    found = annulus.degeneracy(x, merge_duplicates=True, values=True)
    values = found.pop("values")
    assert found.keys() == annulus.degeneracy(x, merge_duplicates=True).keys()
    write_xyz(tmp_path / "x.xyz", x)
    tool(tmp_path, "degeneracy", "x.xyz", "--dim", d, "--raw", "raw.csv", "--quiet")
    with open(tmp_path / "raw.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    stages = ("filter", "interval", "exact")
    for kind, one in (("bicells", "bicell"), ("cells", "cell"), ("ridges", "ridge")):
        of, theirs = values[kind], [row for row in rows if row["kind"] == one]
        width = d + 2 if kind == "bicells" else d + 1
        assert of["points"].shape == (len(theirs), width) and of["points"].dtype == np.int32 and len(theirs) > 0
        assert of["points"].tolist() == [[int(row[f"point_{i}"]) for i in range(width)] for row in theirs]
        for name in ("width_lower", "width_upper", "tolerance"):
            assert of[name].tolist() == [float(row[name]) for row in theirs]
        assert [stages[s] for s in of["stage"]] == [row["stage"] for row in theirs] and of["stage"].dtype == np.int8
        assert ("theta" in of) == (kind == "bicells")
        zero = np.count_nonzero(of["width_upper"] == 0)
        assert (found[kind]["total"], found[kind]["zero"]) == (len(theirs), zero) and np.all(of["tolerance"] >= 0)
    theta = values["bicells"]["theta"]
    assert theta.shape == (found["bicells"]["total"],) and np.all((0 <= theta) & (theta <= np.pi / 2 + 1e-12))
    flat = annulus.degeneracy(np.arange(9.0).reshape(-1, 1) * np.ones(d), values=True)["values"]
    assert [flat[kind]["points"].shape for kind in flat] == [(0, d + 2), (0, d + 1), (0, d + 1)]


def copies(x, box):
    """All images of the points in their box and those around it."""
    d = x.shape[1]
    shifts = np.indices((3,) * d).reshape(d, -1).T - 1
    return (x[None] + (shifts @ box)[:, None]).reshape(-1, d)


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("points", ["random", "lattice"])
def test_degeneracy_in_a_box_is_that_of_many_copies(d, points):
    rng = np.random.default_rng(8 + d)
    box = np.diag([4.0] * d)
    if points == "random":
        box[1, 0] = 1.0
        x = rng.random((40, d)) @ box
    else:
        x = np.indices((4,) * d).reshape(d, -1).T @ box / 4
    found = annulus.degeneracy(x, box=box, values=True)
    assert found["vertices"] == len(x) and found["ridges"] is None and found["values"].keys() == {"bicells", "cells"}
    assert found.keys() == {*annulus.degeneracy(x, box=box), "values"}
    rounded = annulus.MovingDelaunay(x, box=box).points
    many = copies(rounded, box)
    open_set = annulus.degeneracy(many, values=True)["values"]["bicells"]

    def name(rows):  # three bi-cells around a vertex have the same points
        return frozenset(rows[:d]), frozenset(rows[d:])

    width_of = {name(p): w for p, *w in zip(open_set["points"].tolist(), open_set["width_lower"].tolist(),
                                            open_set["width_upper"].tolist())}
    number_of = {tuple(p): k for k, p in enumerate(np.round(many, 9).tolist())}
    bicells = found["values"]["bicells"]
    assert bicells["places"].shape == (len(bicells["stage"]), d + 2, d)
    compared = 0
    for p, places, lower, upper in zip(bicells["points"], bicells["places"], bicells["width_lower"],
                                       bicells["width_upper"]):
        in_box = (places - rounded[p]) @ np.linalg.inv(box)
        assert np.allclose(in_box, np.round(in_box), atol=1e-9)
        rows = [number_of.get(tuple(q)) for q in (np.round(places, 9) + 0.0).tolist()]
        if name(rows) not in width_of:  # at the hull of the copies, or another diagonal of cospherical points
            continue
        compared += 1
        theirs = width_of[name(rows)]
        assert lower <= theirs[1] * (1 + 1e-9) + 1e-12 and theirs[0] <= upper * (1 + 1e-9) + 1e-12
    assert compared > len(bicells["stage"]) / 4
    assert (np.sum(bicells["width_upper"] == 0) > 0) == (points == "lattice")


def test_degeneracy_in_a_box_of_few_points_and_of_duplicates():
    assert annulus.degeneracy([[0.5, 0.25]], box=[1, 1])["vertices"] == 1
    for wrong, code in ((lambda: annulus.degeneracy(np.empty((0, 2)), box=[1, 1]), "too_few"),
                        (lambda: annulus.degeneracy([[0, 0], [1, 0]], box=[1, 1]), "duplicate_point"),
                        (lambda: annulus.degeneracy(GRID, box=[1, 1, 1]), "wrong_size")):
        with pytest.raises(annulus.Error) as e:
            wrong()
        assert e.value.code == code
    merged = annulus.degeneracy([[0, 0], [1, 0], [0.5, 0.5]], True, box=[1, 1])
    assert (merged["points"], merged["vertices"]) == (3, 2)


def test_degeneracy_of_little():
    line = annulus.degeneracy([[0, 0], [1, 1], [2, 2]])
    assert line["affine_dimension"] == 1 and line["simplices"] == 2 and line["bicells"] is None
    for x, code in [(np.zeros((0, 2)), "too_few"), ([[1, 2]], "too_few"), ([[1, 2], [1, 2]], "duplicate_point"),
                    ([[1, np.nan], [1, 2]], "not_finite"), (np.zeros((3, 4)), "wrong_size"), ([1, 2, 3], "wrong_size")]:
        with pytest.raises(annulus.Error) as e:
            annulus.degeneracy(x)
        assert e.value.code == code
    assert annulus.degeneracy(np.concatenate([GRID, GRID[:3]]), merge_duplicates=True)["merged"] == 3


@with_tool
@pytest.mark.parametrize("d", [2, 3])
def test_degeneracy_is_the_tools(tmp_path, d):
    x = np.random.default_rng(d).integers(0, 9, (60, d)) / 7
    write_xyz(tmp_path / "x.xyz", x)
    tool(tmp_path, "degeneracy", "x.xyz", "--dim", d, "--output", "out", "--quiet")
    theirs = json.loads((tmp_path / "out" / "degeneracy.json").read_text(encoding="utf-8"))
    ours = annulus.degeneracy(x, merge_duplicates=True)
    for name in ("command", "file", "seconds"):
        assert name in ours
        del ours[name], theirs[name]
    assert theirs.pop("columns")["x"] == "column 1"  # arrays have none
    assert ours == theirs and list(ours) == list(theirs)


@with_tool
def test_degeneracy_below_thresholds(tmp_path):
    x = np.random.default_rng(1).random((80, 2))
    write_xyz(tmp_path / "x.xyz", x)
    tool(tmp_path, "degeneracy", "x.xyz", "--thresholds", "0.25,1e-05,0.5", "--output", "out", "--quiet")
    theirs = json.loads((tmp_path / "out" / "degeneracy.json").read_text(encoding="utf-8"))
    for thresholds in ([0.25, 1e-5, 0.5], np.array([0.25, 1e-5, 0.5]), (fractions.Fraction(1, 4), 1e-5, 0.5)):
        ours = annulus.degeneracy(x, thresholds=thresholds)
        assert [t["name"] for t in ours["thresholds"]] == ["0.25", "1e-05", "0.5", "ulp"]
        assert ours["thresholds"] == theirs["thresholds"] and ours["bicells"] == theirs["bicells"]
        assert 0 < ours["bicells"]["below"]["0.25"] < ours["bicells"]["below"]["0.5"]


@pytest.mark.parametrize("thresholds", [[], [0], [-1.0], [float("inf")], [float("nan")], [1e-3, 1e-3],
                                        [k + 1 for k in range(31)]])
def test_thresholds_that_are_none(thresholds):
    with pytest.raises(annulus.Error, match="thresholds must be 1 to 30 finite numbers above 0 that differ") as e:
        annulus.degeneracy(GRID, thresholds=thresholds)
    assert e.value.code == "usage"
    assert len(annulus.degeneracy(GRID, thresholds=[k + 1 for k in range(30)])["thresholds"]) == 31


def test_counterexample():
    r = annulus.counterexample()
    assert r["delta"] == 0.01
    assert r["accepted"] == {"paper": True, "certified": False}
    assert r["delaunay"] == {"three_cells_before": True, "three_cells_after": False, "two_cells_after": True}
    for wrong in (0, 1, -1, np.nan, np.inf):
        with pytest.raises(annulus.Error) as e:
            annulus.counterexample(wrong)
        assert e.value.code == "usage"
    with pytest.raises(TypeError):
        annulus.counterexample("0.01")


@with_tool
def test_counterexample_is_the_tools(tmp_path):
    tool(tmp_path, "counterexample", "--delta", 0.02, "--output", "out", "--quiet")
    theirs = json.loads((tmp_path / "out" / "counterexample.json").read_text(encoding="utf-8"))
    assert {**annulus.counterexample(0.02), "command": 0} == {**theirs, "command": 0}


def test_lloyd():
    r = annulus.lloyd(200, 60, density="x2+y2", seed=4)
    assert r.points.shape == (200, 2) and (np.linalg.norm(r.points, axis=1) < 1).all()
    assert len(r.mean_displacement) == len(r.max_displacement) == 60
    assert r.mean_displacement[-1] < r.mean_displacement[0] / 5 and (r.mean_displacement <= r.max_displacement).all()
    assert r.report.asked == 200 * 60
    again = annulus.lloyd(200, 60, density="x2+y2", seed=4, strategy="rebuild", threads=2)
    assert np.array_equal(r.points, again.points), "neither strategy nor threads change a bit"
    assert annulus.lloyd(5, 0, seed=1).points.shape == (5, 2)


def test_a_step_of_lloyd_goes_to_centroids():
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    x = np.random.default_rng(0).random((30, 2))
    ours = annulus.lloyd(x, 1, domain=square).points
    assert np.array_equal(ours, annulus.lloyd(x, 1, domain=square[::-1]).points)
    # Cells cut to the square are those of the points and their mirror images.
    images = [x, x * [-1, 1], x * [1, -1], [2, 0] + x * [-1, 1], [0, 2] + x * [1, -1]]
    voronoi = scipy.spatial.Voronoi(np.concatenate(images))
    for v in range(30):
        corners = voronoi.vertices[voronoi.regions[voronoi.point_region[v]]]
        hull = scipy.spatial.ConvexHull(corners)
        p = corners[hull.vertices]
        q = np.roll(p, -1, axis=0)
        cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
        centroid = ((p + q) * cross[:, None]).sum(axis=0) / (3 * cross.sum())
        assert ours[v] == pytest.approx(centroid, abs=1e-9)


def clipped_centroids(points, corners):
    """Exact centroids, by fractions, of the Voronoi cells of points, cut to a polygon that turns left at each of its
    corners."""
    x = [tuple(map(fractions.Fraction, p)) for p in points.tolist()]
    for i, p in enumerate(x):
        cell = [tuple(map(fractions.Fraction, c)) for c in corners]
        for j, q in enumerate(x):
            if i == j:
                continue
            # How much nearer to q than to p, in the half plane that stays not at all.
            height = [(q[0] - p[0]) * (2 * c[0] - p[0] - q[0]) + (q[1] - p[1]) * (2 * c[1] - p[1] - q[1]) for c in cell]
            kept = []
            for k, (a, h) in enumerate(zip(cell, height)):
                b, g = cell[(k + 1) % len(cell)], height[(k + 1) % len(cell)]
                if h <= 0:
                    kept.append(a)
                if h * g < 0:
                    t = h / (h - g)
                    kept.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
            cell = kept
        area = sx = sy = fractions.Fraction(0)
        for (ax, ay), (bx, by) in zip(cell, cell[1:] + cell[:1]):
            cross = ax * by - ay * bx
            area, sx, sy = area + cross, sx + (ax + bx) * cross, sy + (ay + by) * cross
        yield float(sx / (3 * area)), float(sy / (3 * area))


@pytest.mark.parametrize("corners", [[(0, 0), (1, 0), (1, 1), (0, 1)],
                                     [(-0.5, 0), (1.5, -0.25), (1.25, 1.5), (0.5, 2), (-0.5, 1)],
                                     [(0, 0), (1, 0), (0, 1)]])
def test_a_closed_ring_is_the_open_one(corners):
    rng = np.random.default_rng(5)
    x = rng.random((12, 2)) / 2
    exact = np.array(list(clipped_centroids(x, corners)))
    middle = [tuple((np.array(corners[0]) + corners[1]) / 2)]
    first = None
    for ring in (corners, corners + corners[:1], corners[:1] + corners + 3 * corners[:1], (corners + corners[:1])[::-1],
                 corners[1:] + corners[:2], middle + corners[1:] + corners[:1] + middle,
                 [c for c in corners for _ in range(3)]):
        moved = annulus.lloyd(x, 1, domain=ring).points
        first = moved if first is None else first
        assert np.array_equal(first, moved), ring
        assert np.abs(moved - exact).max() < 1e-14, ring
    r = annulus.lloyd(2000, 5, domain=np.array(corners + corners[:1]), seed=1).points
    assert np.array_equal(r, annulus.lloyd(2000, 5, domain=np.array(corners), seed=1).points)


def test_what_is_wrong_with_a_domain_is_said_by_corner():
    for corners, words in (([(0, 0)] * 4, "at one place"),
                           ([(0, 0), (2, 0), (1, 0), (1, 1)], "corners 0 and 1, counted from 0, meet elsewhere"),
                           ([(0, 0), (1, 1), (2, 2), (0, 0)], "on one line")):
        with pytest.raises(annulus.Error, match=words) as e:
            annulus.lloyd(20, 1, domain=corners)
        assert e.value.code == "bad_input"


def test_what_lloyd_refuses():
    x = np.random.default_rng(0).random((30, 2))
    for arguments, named, code in [((2,), {}, "usage"), ((x,), {"domain": "ball"}, "usage"),
                                   ((x,), {"density": "2"}, "usage"), ((x, -1), {}, "usage"),
                                   ((x + 3,), {"domain": "disc"}, "out_of_domain"), ((x[:2],), {}, "too_few"),
                                   ((9,), {"radius": -1.0}, "bad_input"),
                                   ((9,), {"domain": [[0, 0], [1, 1]]}, "bad_input"),
                                   ((9,), {"radius": 1e5, "density": "sin2"}, "usage"),
                                   ((np.repeat(x, 2, axis=0),), {}, "duplicate_point"),
                                   ((np.full((4, 2), np.nan),), {}, "not_finite"),
                                   ((x,), {"strategy": "none"}, "usage"),
                                   (([[0, 0], [1, 1], [2, 2]],), {}, "bad_input"),
                                   ((np.zeros((4, 3)),), {}, "wrong_size")]:
        with pytest.raises(annulus.Error) as e:
            annulus.lloyd(*arguments, **named)
        assert e.value.code == code, (arguments, named, str(e.value))
    assert annulus.lloyd(np.repeat(x, 2, axis=0), 2, merge_duplicates=True).points.shape == (30, 2)
    assert annulus.lloyd(np.int64(9), 1).points.shape == (9, 2)


@with_tool
def test_lloyd_is_the_tools(tmp_path):
    tool(tmp_path, "lloyd", "--points", 100, "--iterations", 20, "--density", "x2", "--seed", 5, "--output", "out",
         "--quiet")
    words = (tmp_path / "out" / "final.mesh").read_text(encoding="utf-8").split()
    at = words.index("Vertices") + 2
    theirs = np.array(words[at:at + 300], dtype=float).reshape(100, 3)[:, :2]
    assert np.array_equal(annulus.lloyd(100, 20, density="x2", seed=5).points, theirs)


def test_nodt():
    r = annulus.nodt("sphere", 200, 5, seed=2)
    n = len(r.points)
    assert r.points.shape == (n, 3) and r.on_surface.shape == (n,) and r.on_surface.dtype == bool and 150 < n < 300
    assert np.linalg.norm(r.points[r.on_surface], axis=1) == pytest.approx(1, abs=1e-9)
    corners = r.points[r.simplices]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    assert (volumes > 0).all() and 3 < volumes.sum() < 4.19
    assert len(r.mean_displacement) == 5 and r.report.asked == 5 * n
    assert np.array_equal(annulus.nodt("sphere", 200, 5, seed=2, strategy="rebuild").points, r.points)
    assert len(annulus.nodt("sphere", 100, 9, callback=lambda step, *_: step == 2).mean_displacement) == 2


def test_nodt_of_a_surface(tmp_path):
    points, triangles = TETRAHEDRON
    r = annulus.nodt((points, triangles), 100, 3)
    assert np.array_equal(r.points, annulus.nodt((points, triangles[:, ::-1]), 100, 3).points), "either way round"
    file = tmp_path / "tetrahedron.off"
    file.write_text("OFF\n4 4 0\n" + "".join("%d %d %d\n" % tuple(p) for p in points)
                    + "".join("3 %d %d %d\n" % tuple(t) for t in triangles),
                    encoding="utf-8")
    assert np.array_equal(annulus.nodt(file, 100, 3).points, r.points)
    assert np.array_equal(annulus.nodt(str(file), 100, 3).points, r.points)


def test_what_nodt_refuses(tmp_path):
    points, triangles = TETRAHEDRON
    for surface, vertices, named, code in [("sphere", 3, {}, "usage"), ("sphere", 100, {"gradation": -1.0}, "usage"),
                                           ("sphere", 100, {"lock": 80.0}, "usage"),
                                           ((points, triangles[:3]), 100, {}, "bad_input"),
                                           ((points, triangles + 1), 100, {}, "unknown_vertex"),
                                           ((points[:, :2], triangles), 100, {}, "wrong_size"),
                                           ((points,), 100, {}, "wrong_size"),
                                           (tmp_path / "none.off", 100, {}, "bad_input"),
                                           ("sphere", 100, {"iterations": -1}, "usage")]:
        with pytest.raises(annulus.Error) as e:
            annulus.nodt(surface, vertices, **named)
        assert e.value.code == code, str(e.value)
