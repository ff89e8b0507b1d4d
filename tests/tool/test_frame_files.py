#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of replay, lloyd and nodt for every frame: --every, which files there are, and faults.

usage: test_frame_files.py --tool=PATH [CLASS[.METHOD]...]"""

import itertools
import json
import math
import re
import signal

import tool
from frames import delaunay_pairs, FrameTest, wander

try:
    import scipy.spatial
except ImportError:
    scipy = None
try:
    import vtk
except ImportError:
    vtk = None


class Frames(FrameTest):
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

    def test_neighbours_of_every_frame(self):
        """The pairs of the first frame, and of all others; cells are pyramids over their facets, which have half the
        distance of the two points as height."""
        for d, corner in ((2, "area"), (3, "volume")):
            facet = {2: "length", 3: "area"}[d]
            frames = wander(d, 4, 12, 3)
            self.succeed("replay", self.xyz_of(frames), "--neighbors", "--voronoi", "--output", "out", "--quiet")
            rows = self.table("out", "pairs.csv")
            self.assertEqual(list(rows[0]), ["frame", "first", "second", facet])
            keys = [(int(r["frame"]), int(r["first"]), int(r["second"])) for r in rows]
            self.assertEqual(keys, sorted(keys))
            self.assertEqual({f for f, _, _ in keys}, {0, 1, 2, 3})
            for f, frame in enumerate(frames):
                self.assertEqual({(i, j) for g, i, j in keys if g == f}, delaunay_pairs(frame), (d, f))
            volume = {}
            for (f, i, j), r in zip(keys, rows):
                pyramid = math.dist(frames[f][i], frames[f][j]) * float(r[facet] or "inf") / (2 * d)
                for k in (i, j):
                    volume[f, k] = volume.get((f, k), 0) + pyramid
            bounded = 0
            for r in self.table("out", "voronoi.csv"):
                found = volume[int(r["frame"]), int(r["id"])]
                self.assertEqual(math.isinf(found), r["unbounded"] == "1")
                if math.isfinite(found):
                    bounded += 1
                    self.assertAlmostEqual(found / float(r[corner]), 1, delta=1e-9)
            self.assertGreater(bounded, 4)

    def test_neighbours_of_cocircular_points(self):
        """A grid: 12 sides, and 4 diagonals whose facets are exactly empty. Words for ids come in their order."""
        text = "frame,id,x,y\n" + "".join(f"0,p{3 * y + x},{x},{y}\n" for y in range(3) for x in range(3))
        self.write("grid.csv", text)
        self.succeed("replay", "grid.csv", "--neighbors", "--output", "out", "--quiet")
        rows = self.table("out", "pairs.csv")
        self.assertEqual(len(rows), 16)
        diagonal = [r for r in rows if abs(int(r["first"][1]) - int(r["second"][1])) in (2, 4)]
        self.assertEqual([r["length"] for r in diagonal], ["0"] * 4)
        inner = [r for r in rows if r not in diagonal and r["length"]]
        self.assertEqual([(r["first"], r["second"], r["length"]) for r in inner],
                         [("p1", "p4", "1"), ("p3", "p4", "1"), ("p4", "p5", "1"), ("p4", "p7", "1")])
        line = {i: [float(i), 2.0 * i] for i in range(4)}
        self.succeed("replay", self.xyz_of([line, {}, {7: [1.0, 1.0]}]), "--neighbors", "--output", "out", "--quiet")
        self.assertEqual([(r["first"], r["second"], r["length"]) for r in self.table("out", "pairs.csv")],
                         [(str(i), str(i + 1), "") for i in range(3)])

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
        for words in (("--every", "3"), ("--voronoi",), ("--neighbors",), ("--changes",)):
            self.assertIn("--output", self.refuse(2, "replay", name, *words))
            self.assertIn("--output", self.refuse(2, "lloyd", "--points", "9", *words))
        self.refuse(2, "replay", name, "--every", "0", "--output", "out")
        for word in ("--voronoi", "--neighbors"):
            said = self.refuse(2, "replay", name, word, "--output", "out", "--tolerance", "paper")
            self.assertIn("certified", said)
            self.assertIn(word, said)

    def test_old_frames_go_with_old_results(self):
        name = self.xyz_of(wander(2, 6, 12, 1))
        self.succeed("replay", name, "--every", "1", "--voronoi", "--neighbors", "--changes", "--output", "out",
                     "--quiet")
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


if __name__ == "__main__":
    tool.main(__doc__)
