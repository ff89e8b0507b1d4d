#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of replay, lloyd and nodt for every frame: --every, --voronoi, --changes.

usage: test_frames.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import itertools
import json
import random
import re
import signal
import unittest
import xml.etree.ElementTree
from fractions import Fraction

import tool

try:
    import numpy
    import scipy.spatial
except ImportError:
    scipy = None
try:
    import vtk
except ImportError:
    vtk = None


def determinant(m):
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return sum((-1) ** i * row[0] * determinant([r[1:] for k, r in enumerate(m) if k != i])
               for i, row in enumerate(m) if row[0])


UNIT = 2 ** 20  # coordinates are multiples of 1/UNIT, so that the oracles count in integers


def delaunay_pairs(points):
    """Neighbours in the Delaunay triangulation of {id: point} in general position: simplices with empty spheres, in
    integers."""
    exact = {i: [int(UNIT * c) for c in p] for i, p in points.items()}
    assert all(c == UNIT * x for i, p in points.items() for c, x in zip(exact[i], p))
    lifted = {i: p + [sum(c * c for c in p), 1] for i, p in exact.items()}
    d = len(next(iter(exact.values())))
    pairs = set()
    for simplex in itertools.combinations(sorted(exact), d + 1):
        turn = determinant([exact[i] + [1] for i in simplex])
        rows = [lifted[i] for i in simplex]
        if all(turn * determinant(rows + [lifted[j]]) < 0 for j in exact if j not in simplex):
            pairs |= set(itertools.combinations(simplex, 2))
    return pairs


def voronoi_areas(points):
    """The area of each cell of {id: point} in 2D, None for cells that leave a far box. By clipping with bisectors, in
    rationals."""
    far = Fraction(10) ** 9
    exact = {i: [Fraction(c) for c in p] for i, p in points.items()}
    areas = {}
    for i, p in exact.items():
        cell = [[-far, -far], [far, -far], [far, far], [-far, far]]
        for j, q in exact.items():
            if i == j:
                continue
            side = [sum((p[k] - q[k]) * (2 * v[k] - p[k] - q[k]) for k in (0, 1)) for v in cell]
            clipped = []
            for k, v in enumerate(cell):
                n = (k + 1) % len(cell)
                if side[k] >= 0:
                    clipped.append(v)
                if side[k] * side[n] < 0:
                    t = side[k] / (side[k] - side[n])
                    clipped.append([v[m] + t * (cell[n][m] - v[m]) for m in (0, 1)])
            cell = clipped
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(cell, cell[1:] + cell[:1])) / 2
        areas[i] = None if any(abs(c) == far for v in cell for c in v) else float(area)
    return areas


def wander(d, frames, points, seed, step=0.03):
    """Frames as {id: point}: points walk, some leave, others arrive; ids are not indices."""
    dice = random.Random(seed)
    place = lambda: [dice.randrange(UNIT) / UNIT for _ in range(d)]
    now = {3 * i + 7: place() for i in range(points)}
    fresh = 5000
    result = []
    for _ in range(frames):
        result.append({i: list(p) for i, p in now.items()})
        now = {i: [round((c + step * dice.gauss(0, 1)) * UNIT) / UNIT for c in p] for i, p in now.items()}
        for _ in range(dice.randrange(3)):
            if len(now) > 3:
                del now[dice.choice(sorted(now))]
        for _ in range(dice.randrange(3)):
            now[fresh] = place()
            fresh -= 1  # an id below the earlier ones
    return result


class Frames(tool.ToolTest):
    def xyz_of(self, frames, seed=0):
        """Extended XYZ with quoted properties, ids out of order."""
        text = ""
        for f, frame in enumerate(frames):
            order = list(frame.items())
            random.Random(seed + f).shuffle(order)
            d = len(order[0][1]) if order else 2
            text += f'{len(order)}\nProperties="id:I:1:mass:R:1:pos:R:{d}" Time={f}\n'
            text += "".join(f"{i} 1.5 {' '.join(map(repr, p))}\n" for i, p in order)
        return self.write("motion.xyz", text)

    def table(self, *names):
        with open(self.here.joinpath(*names), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def changes(self, directory="out"):
        """{frame: (made, broken)}"""
        result = {}
        for row in self.table(directory, "changes.csv"):
            made, broken = result.setdefault(int(row["frame"]), (set(), set()))
            pair = (int(row["first"]), int(row["second"]))
            self.assertLess(*pair)
            kind = {"made": made, "broken": broken}[row["change"]]
            self.assertNotIn(pair, kind)
            kind.add(pair)
        return result

    def check_changes(self, pairs, directory="out"):
        """Of frames with these neighbours."""
        said = self.changes(directory)
        for f in range(1, len(pairs)):
            made, broken = said.pop(f, (set(), set()))
            self.assertEqual(made, pairs[f] - pairs[f - 1], f)
            self.assertEqual(broken, pairs[f - 1] - pairs[f], f)
        self.assertEqual(said, {})

    def test_changes_are_those_of_triangulations_in_rationals(self):
        for d, points in ((2, 11), (3, 9)):
            frames = wander(d, 8, points, 4)
            name = self.xyz_of(frames)
            pairs = [delaunay_pairs(frame) for frame in frames]
            self.assertNotEqual(pairs[0], pairs[1])
            for strategy in tool.STRATEGIES:
                with self.subTest(d=d, strategy=strategy):
                    self.succeed("replay", name, "--strategy", strategy, "--changes", "--output", "out", "--quiet")
                    self.check_changes(pairs)

    def test_without_arrivals_as_many_pairs_break_as_are_made_inside_of_the_hull(self):
        """T1 transitions: four outer points at rest keep the hull."""
        dice = random.Random(8)
        outer = {1000 + i: list(p) for i, p in enumerate([(-9, -9), (9, -9), (9, 9), (-9, 9)])}
        inner = {i: [dice.random(), dice.random()] for i in range(40)}
        frames = []
        for _ in range(12):
            frames.append({**outer, **{i: list(p) for i, p in inner.items()}})
            inner = {i: [c + 0.02 * dice.gauss(0, 1) for c in p] for i, p in inner.items()}
        self.succeed("replay", self.xyz_of(frames), "--changes", "--output", "out", "--quiet")
        said = self.changes()
        self.assertGreater(len(said), 5)
        for made, broken in said.values():
            self.assertEqual(len(made), len(broken))

    def test_voronoi_cells_against_rationals(self):
        frames = wander(2, 6, 12, 9)
        self.succeed("replay", self.xyz_of(frames), "--voronoi", "--output", "out", "--quiet")
        rows = self.table("out", "voronoi.csv")
        self.assertEqual([(int(r["frame"]), int(r["id"])) for r in rows],
                         [(f, i) for f, frame in enumerate(frames) for i in sorted(frame)])
        for f, frame in enumerate(frames):
            areas, pairs = voronoi_areas(frame), delaunay_pairs(frame)
            for row in (r for r in rows if int(r["frame"]) == f):
                i = int(row["id"])
                self.assertEqual(int(row["neighbours"]), sum(i in pair for pair in pairs))
                self.assertEqual(row["unbounded"] == "1", areas[i] is None)
                self.assertEqual(row["area"] == "", areas[i] is None)
                if areas[i] is not None:
                    self.assertAlmostEqual(float(row["area"]) / areas[i], 1, delta=1e-9)

    @unittest.skipUnless(scipy, "SciPy is not installed")
    def test_voronoi_cells_of_space_against_scipy(self):
        frames = wander(3, 10, 60, 5)
        self.succeed("replay", self.xyz_of(frames), "--voronoi", "--output", "out", "--quiet")
        rows = {(int(r["frame"]), int(r["id"])): r for r in self.table("out", "voronoi.csv")}
        for f, frame in enumerate(frames):
            ids = sorted(frame)
            diagram = scipy.spatial.Voronoi(numpy.array([frame[i] for i in ids]))
            for i, region in zip(ids, diagram.point_region):
                corners = diagram.regions[region]
                volume = rows.pop((f, i))["volume"]
                self.assertEqual(volume == "", -1 in corners)
                if volume:
                    self.assertAlmostEqual(float(volume) / scipy.spatial.ConvexHull(diagram.vertices[corners]).volume,
                                           1, delta=1e-9)
        self.assertEqual(rows, {})

    def series(self, directory="out"):
        root = xml.etree.ElementTree.parse(self.here / directory / "frames.pvd").getroot()
        return [(int(e.get("timestep")), e.get("file")) for e in root.iter("DataSet")]

    def test_ids_of_64_bits(self):
        ids = [3, 2**63, 2**64 - 1]
        (self.here / "a.xyz").write_text("3\nProperties=id:I:1:pos:R:2\n"
                                         + "".join(f"{i} {x} {y}\n" for i, (x, y) in zip(ids, tool.TRIANGLE)))
        self.succeed("replay", "a.xyz", "--every", "1", "--voronoi", "--output", "out", "--quiet")
        self.assertEqual([int(r["id"]) for r in self.table("out", "voronoi.csv")], ids)
        self.assertEqual(list(tool.vtu_values(self.here / "out" / "frame-000000.vtu", "id")), ids)

    def test_every_third_frame(self):
        frames = wander(3, 11, 20, 6)
        self.succeed("replay", self.xyz_of(frames), "--every", "3", "--voronoi", "--output", "out", "--quiet")
        series = self.series()
        self.assertEqual(series, [(f, f"frame-{f:06}.vtu") for f in (0, 3, 6, 9)])
        volumes = {(int(r["frame"]), int(r["id"])): r["volume"] for r in self.table("out", "voronoi.csv")}
        for f, file in series:
            path = self.here / "out" / file
            ids = tool.vtu_values(path, "id")
            self.assertEqual(sorted(ids), sorted(frames[f]))
            x = tool.vtu_values(path, "Points")
            for k, i in enumerate(ids):
                self.assertEqual(list(x[3 * k:3 * k + 3]), frames[f][i])
                volume = tool.vtu_values(path, "voronoi_volume")[k]
                self.assertEqual(volumes[f, i], "" if volume == float("inf") else repr(volume).replace("e-0", "e-"))
            corners = tool.vtu_values(path, "connectivity")
            edges = {tuple(sorted((ids[a], ids[b]))) for c in range(0, len(corners), 4)
                     for a, b in itertools.combinations(corners[c:c + 4], 2)}
            if f == 0:
                self.assertEqual(edges, delaunay_pairs(frames[f]))
            if vtk:
                reader = vtk.vtkXMLUnstructuredGridReader()
                reader.SetFileName(str(path))
                reader.Update()
                grid = reader.GetOutput()
                self.assertEqual((grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (len(ids), len(corners) // 4))
                self.assertEqual(grid.GetPoint(1), tuple(x[3:6]))

    def test_frame_numbers_are_the_files(self):
        text = "".join(f"ITEM: TIMESTEP\n{t}\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 "
                       "1\nITEM: ATOMS id x y\n"
                       f"1 0 0\n2 1 0\n3 {x} 0.4\n4 0.5 -0.4\n" for t, x in ((500, 0.5), (750, 0.6), (1000, 5)))
        self.write("dump.lammpstrj", text)
        self.succeed("replay", "dump.lammpstrj", "--every", "2", "--changes", "--voronoi", "--output", "out", "--quiet")
        self.assertEqual(self.series(), [(500, "frame-000000.vtu"), (1000, "frame-000002.vtu")])
        self.assertEqual({r["frame"] for r in self.table("out", "voronoi.csv")}, {"500", "750", "1000"})
        self.assertEqual(set(self.changes()), {1000})

    def test_flat_frames_and_frames_without_points(self):
        line = {i: [float(i), 2.0 * i] for i in range(5)}
        solid = {i: [float(i), float(i * i)] for i in range(5)}
        frames = [line, solid, line, {}, solid]
        name = self.xyz_of(frames)
        for strategy in tool.STRATEGIES:
            with self.subTest(strategy=strategy):
                self.succeed("replay", name, "--every", "1", "--voronoi", "--changes", "--strategy", strategy,
                             "--output", "out", "--quiet")
                said = self.changes()
                chain = {(i, i + 1) for i in range(4)}
                pairs = [chain, delaunay_pairs(solid), chain, set(), delaunay_pairs(solid)]
                for f in range(1, 5):
                    self.assertEqual(said.get(f, (set(), set())), (pairs[f] - pairs[f - 1], pairs[f - 1] - pairs[f]), f)
                rows = self.table("out", "voronoi.csv")
                self.assertEqual([sum(int(r["frame"]) == f for r in rows) for f in range(5)], [5, 5, 5, 0, 5])
                self.assertTrue(all(r["unbounded"] == "1" and r["area"] == "" for r in rows if r["frame"] in "02"))
                self.assertEqual([r["neighbours"] for r in rows[:5]], ["1", "2", "2", "2", "1"])
                self.assertEqual(len(self.series()), 5)

    def test_lloyd_and_nodt_write_them_too(self):
        self.succeed("lloyd", "--points", "30", "--iterations", "6", "--every", "2", "--voronoi", "--changes",
                     "--output", "out", "--quiet")
        self.assertEqual([f for f, _ in self.series()], [0, 2, 4, 6])
        areas = {}
        for row in self.table("out", "voronoi.csv"):
            areas.setdefault(int(row["frame"]), set()).add(int(row["id"]))
        self.assertEqual(areas, {f: set(range(30)) for f in range(7)})
        pairs = []
        for f, file in self.series():
            corners = tool.vtu_values(self.here / "out" / file, "connectivity")
            pairs.append({tuple(sorted(pair)) for c in range(0, len(corners), 3)
                          for pair in itertools.combinations(corners[c:c + 3], 2)})
        now = set(pairs[0])
        for f, (made, broken) in sorted(self.changes().items()):
            self.assertTrue(broken <= now and not made & now)
            now = now - broken | made
        self.assertEqual(now, pairs[-1])
        self.succeed("nodt", "--sphere", "--vertices", "60", "--iterations", "3", "--every", "3", "--voronoi",
                     "--changes", "--output", "nodt", "--quiet")
        self.assertEqual([f for f, _ in self.series("nodt")], [0, 3])
        self.assertTrue((self.here / "nodt" / "domain.mesh").exists())

    def test_every_strategy_writes_the_same(self):
        name = self.xyz_of(wander(2, 10, 40, 3))
        contents = set()
        for strategy in tool.STRATEGIES:
            self.succeed("replay", name, "--voronoi", "--changes", "--strategy", strategy, "--output", strategy,
                         "--quiet")
            rows = [(r["frame"], r["id"], r["neighbours"], r["unbounded"]) for r in self.table(strategy, "voronoi.csv")]
            contents.add(((self.here / strategy / "changes.csv").read_text(encoding="utf-8"), tuple(rows)))
        self.assertEqual(len(contents), 1)

    def test_the_page_has_a_slider_and_curves(self):
        name = self.xyz_of(wander(2, 100, 20, 2))
        self.succeed("replay", name, "--voronoi", "--changes", "--output", "out", "--quiet")
        page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("type=\"range\""), 1)
        for heading in ("Over time", "Neighbours that change", "Voronoi cells over time", "Cells with six neighbours"):
            self.assertIn(heading, page)
        self.assertRegex(page, r"\d+ of 100 frames are shown: one in 4, and the last")
        self.assertEqual(re.findall(r"(?:src|href)=", page), [])
        self.succeed("replay", name, "--output", "plain", "--quiet")
        self.assertNotIn("Voronoi cells over time", (self.here / "plain" / "report.html").read_text(encoding="utf-8"))

    def test_what_does_not_go_together(self):
        name = self.xyz_of(wander(2, 3, 9, 1))
        for words in (("--every", "3"), ("--voronoi",), ("--changes",)):
            self.assertIn("--output", self.refuse(2, "replay", name, *words))
            self.assertIn("--output", self.refuse(2, "lloyd", "--points", "9", *words))
        self.refuse(2, "replay", name, "--every", "0", "--output", "out")
        self.assertIn("certified", self.refuse(2, "replay", name, "--voronoi", "--output", "out", "--tolerance",
                                               "paper"))

    def test_old_frames_go_with_old_results(self):
        name = self.xyz_of(wander(2, 6, 12, 1))
        self.succeed("replay", name, "--every", "1", "--voronoi", "--changes", "--output", "out", "--quiet")
        (self.here / "out" / "frame-of-mine.vtu").write_text("mine", encoding="utf-8")
        self.succeed("replay", name, "--every", "4", "--output", "out", "--quiet")
        names = {p.name for p in (self.here / "out").iterdir()}
        self.assertEqual(names, tool.RUN_FILES | {"frames.pvd", "frame-000000.vtu", "frame-000004.vtu",
                                                  "frame-of-mine.vtu"})

    def test_a_fault_further_on_leaves_what_was_before(self):
        frames = wander(2, 4, 9, 1)
        name = self.xyz_of(frames)
        path = self.here / name
        path.write_text(path.read_text(encoding="utf-8") + "2\n\n0 0\n", encoding="utf-8")
        done = self.run_tool("replay", name, "--every", "1", "--changes", "--voronoi", "--output", "out")
        self.assertEqual(done.returncode, 3)
        self.assertFalse((self.here / "out").exists())
        self.assertEqual(len(self.series("out.partial")), 4)
        self.check_changes([delaunay_pairs(frame) for frame in frames], "out.partial")
        self.assertEqual(self.listing()[0], "motion.xyz")

    def test_an_interrupted_run_keeps_its_frames(self):
        words = ["lloyd", "--points", "200", "--iterations", "1000000", "--audit", "0", "--every", "5", "--changes",
                 "--output", "out", "--quiet"]
        done = self.run_tool(*words, env=tool.at(signal.SIGINT, 1, "open", "frame-000010.vtu"))
        self.assertEqual(done.returncode, -signal.SIGINT)
        self.assertGreaterEqual(len(self.series("out.partial")), 3)
        self.assertEqual({p.name for p in self.here.iterdir()}, {"out.partial"})

    def test_compare_follows_a_recorded_motion(self):
        frames = wander(2, 12, 40, 7)
        name = self.xyz_of(frames)
        names = ",".join(tool.STRATEGIES)
        self.succeed("compare", "--strategies", names, "--output", "out", "--quiet", "--", "replay", name, "--audit",
                     "1")
        content = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
        self.assertIs(content["agree"], True)
        asked = sum(len(set(a) & set(b)) for a, b in zip(frames, frames[1:]))
        for run in content["strategies"].values():
            self.assertEqual((run["iterations"], run["moves"]["asked"], run["vertices"]), (11, asked, len(frames[-1])))
            self.assertEqual(run["audit"], {"checked": 11, "failed": 0})
        self.succeed("compare", "--", "replay", self.xyz_of(wander(3, 5, 30, 7)))
        self.succeed("compare", "--", "replay", self.xyz_of([frames[0]]))
        self.refuse(2, "compare", "--", "replay", name, "--output", "x")
        self.refuse(3, "compare", "--", "replay", "missing.xyz")
        self.assertIn("replay", self.succeed("compare", "--", "--help").stdout)


class Degeneracy(tool.ToolTest):
    def motion(self):
        """A grid that is perturbed more and more; the numbers of its frames are 10, 20 .."""
        dice = random.Random(1)
        rows = ["frame,id,x,y"]
        for f in range(5):
            rows += [f"{10 * f + 10},{i},{i % 6 + f * 1e-3 * dice.random()!r},{i // 6 + f * 1e-3 * dice.random()!r}"
                     for i in range(36)]
        return self.write("motion.csv", "\n".join(rows) + "\n")

    def test_a_frame(self):
        name = self.motion()
        self.succeed("degeneracy", name, "--frame", "10", "--output", "out", "--quiet")
        content = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        self.assertEqual((content["vertices"], content["bicells"]["zero"]), (36, 25))
        self.succeed("degeneracy", name, "--frame", "30", "--output", "out", "--quiet")
        content = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        self.assertEqual(content["bicells"]["zero"], 0)
        self.assertIn("has no frame 15", self.refuse(3, "degeneracy", name, "--frame", "15"))
        self.refuse(2, "degeneracy", name, "--frame", "10", "--every", "2")
        self.refuse(3, "degeneracy", name)

    def test_over_a_motion(self):
        self.succeed("degeneracy", self.motion(), "--every", "2", "--thresholds", "1e-2,1e-5", "--output", "out",
                     "--quiet")
        with open(self.here / "out" / "degeneracy.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([r["frame"] for r in rows], ["10", "30", "50"])
        self.assertEqual([r["zero"] for r in rows], ["25", "0", "0"])
        self.assertEqual([k for k in rows[0] if k.startswith("below_")], ["below_1e-2", "below_1e-5", "below_ulp"])
        self.assertLess(float(rows[0]["width_median"]), float(rows[2]["width_median"]) + 1)
        self.assertGreaterEqual(int(rows[1]["below_1e-2"]), int(rows[1]["below_1e-5"]))
        page = (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")
        self.assertIn("Widths and tolerances", page)
        lines = self.succeed("degeneracy", self.motion(), "--every", "1").stdout.splitlines()
        self.assertEqual(len(lines), 8)

    def test_flat_frames_have_no_numbers(self):
        self.write("a.xyz", "3\n\n0 0\n1 1\n2 2\n0\n\n3\n\n0 0\n1 0\n0 1\n")
        self.succeed("degeneracy", "a.xyz", "--every", "1", "--output", "out", "--quiet")
        with open(self.here / "out" / "degeneracy.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(r["points"], r["mean_spacing"] == "") for r in rows],
                         [("3", True), ("0", True), ("3", False)])

    def test_thresholds(self):
        self.xyz("grid.xyz", tool.GRID)
        self.succeed("degeneracy", "grid.xyz", "--thresholds", "0.5,1e-7", "--output", "out", "--quiet")
        content = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        self.assertEqual([t["name"] for t in content["thresholds"]], ["0.5", "1e-7", "ulp"])
        self.assertEqual(content["bicells"]["below"]["1e-7"], 25)
        for bad in ("0", "-1", "nan", "inf", "x", "1e-3,1e-3", "1e-3,0.001", ",".join(f"{i}e-3" for i in range(1, 40))):
            self.refuse(2, "degeneracy", "grid.xyz", "--thresholds", bad)

    def test_raw_certificates(self):
        points = tool.SPREAD + [tool.SPREAD[0]]
        self.xyz("a.xyz", points)
        self.succeed("degeneracy", "a.xyz", "--raw", "raw.csv", "--output", "out", "--quiet")
        with open(self.here / "raw.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        content = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        for kind, name in (("bicell", "bicells"), ("cell", "cells"), ("ridge", "ridges")):
            of_kind = [r for r in rows if r["kind"] == kind]
            self.assertEqual(len(of_kind), content[name]["total"])
            for r in of_kind:
                self.assertEqual(r["point_3"] == "", kind != "bicell")
                self.assertLessEqual(float(r["width_lower"]), float(r["width_upper"]))
                self.assertLessEqual(2 * float(r["tolerance"]), float(r["width_upper"]))
                self.assertGreater(2.01 * float(r["tolerance"]), float(r["width_lower"]))
        # The width of a triangle is its least height.
        for r in (r for r in rows if r["kind"] == "cell"):
            a, b, c = (points[int(r[f"point_{i}"])] for i in range(3))
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            longest = max(((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5 for p, q in ((a, b), (b, c), (c, a)))
            self.assertAlmostEqual(float(r["width_lower"]), area / longest, delta=1e-12)
        self.assertIn("--force", self.refuse(2, "degeneracy", "a.xyz", "--raw", "raw.csv"))
        self.succeed("degeneracy", "a.xyz", "--raw", "raw.csv.gz", "--quiet")
        self.assertEqual((self.here / "raw.csv.gz").read_bytes()[:2], b"\x1f\x8b")


if __name__ == "__main__":
    tool.main(__doc__)
