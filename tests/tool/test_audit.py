#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus audit` and `annulus counterexample`. usage: test_audit.py --tool=PATH [CLASS[.METHOD]...]"""

import json
import math

import tool
from tool import STRATEGIES, ToolTest


class Audits(ToolTest):
    HEAD = "MeshVersionFormatted 2\nDimension 2\n"

    def mesh_file(self, points, cells):
        return self.write("test.mesh", self.HEAD + f"Vertices\n{len(points)}\n"
                          + "".join(f"{x!r} {y!r} 0\n" for x, y in points)
                          + f"Triangles\n{len(cells)}\n" + "".join(f"{a} {b} {c} 0\n" for a, b, c in cells) + "End\n")

    def verdict(self, status, points, cells):
        name = self.mesh_file(points, cells)
        done = self.run_tool("audit", name)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn("NOT Delaunay" if status else "Delaunay", done.stdout)
        quiet = self.run_tool("audit", "--quiet", name)
        self.assertEqual((quiet.returncode, quiet.stdout, quiet.stderr), (status, "", ""))

    SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    KITE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.25)]

    def test_right(self):
        self.verdict(0, self.SQUARE, [(1, 2, 3), (1, 3, 4)])
        self.verdict(0, self.SQUARE, [(1, 2, 4), (2, 3, 4)])
        self.verdict(0, self.KITE, [(1, 2, 3), (1, 3, 4)])

    def test_wrong(self):
        self.verdict(1, self.KITE, [(1, 2, 4), (2, 3, 4)])                          # the other diagonal
        self.verdict(1, self.SQUARE, [(1, 3, 2), (1, 3, 4)])                        # a clockwise triangle
        self.verdict(1, self.SQUARE, [(1, 2, 3)])                                   # a vertex in no triangle
        self.verdict(1, self.SQUARE + [(0.5, 0.5)], [(1, 2, 5), (2, 3, 5), (3, 4, 5)])   # not convex
        self.verdict(1, self.SQUARE, [(1, 2, 3), (1, 3, 4), (1, 2, 3)])             # a triangle twice
        self.verdict(1, self.SQUARE[:3] + [(1.0, 1.0)], [(1, 2, 3), (1, 3, 4)])     # two vertices at one place

    def test_one_unit_in_the_last_place(self):
        below, above = math.nextafter(1.0, 0), math.nextafter(1.0, 2)
        for y, good, bad in ((below, [(1, 2, 4), (2, 3, 4)], [(1, 2, 3), (1, 3, 4)]),
                             (above, [(1, 2, 3), (1, 3, 4)], [(1, 2, 4), (2, 3, 4)])):
            points = self.SQUARE[:3] + [(0.0, y)]
            self.verdict(0, points, good)
            self.verdict(1, points, bad)

    def test_a_border_that_winds_twice(self):
        # Positive triangles around one vertex, each locally Delaunay, the border convex at every corner; twice around.
        ring = [(round(math.cos(2 * math.pi * k / 5), 6), round(math.sin(2 * math.pi * k / 5), 6))
                for k in range(0, 10, 2)]
        cells = [(1, 2 + k, 2 + (k + 1) % 5) for k in range(5)]
        self.verdict(1, [(0.0, 0.0)] + ring, cells)

    def test_what_a_run_writes(self):
        for strategy in STRATEGIES:
            self.succeed("lloyd", "--points", "150", "--iterations", "10", "--strategy", strategy, "--output", "out",
                         "--quiet")
            self.succeed("audit", "out/final.mesh")

    def test_a_spoiled_run(self):
        self.succeed("lloyd", "--points", "150", "--iterations", "10", "--output", "out", "--quiet")
        points, cells = self.mesh("out")
        cells = [tuple(i + 1 for i in c) for c in cells]
        self.verdict(0, points, cells)
        self.verdict(1, points, cells[1:])
        self.verdict(1, points, [cells[0][::-1]] + cells[1:])
        moved = list(points)
        inner = cells[len(cells) // 2][0] - 1
        moved[inner] = (moved[inner][0] + 0.9, moved[inner][1] - 0.7)
        self.verdict(1, moved, cells)

    def test_what_a_flat_run_writes(self):
        self.xyz("line.xyz", [(i, 0) for i in range(4)])
        self.succeed("lloyd", "--input", "line.xyz", "--iterations", "2", "--output", "out", "--quiet")
        self.assertEqual(self.mesh("out")[1], [])
        done = self.succeed("audit", "out/final.mesh")
        self.assertIn("4 points, 3 edges: Delaunay", done.stdout)

    def test_points_on_a_line(self):
        def flat(points, edges):
            self.write("test.mesh", self.HEAD + f"Vertices\n{len(points)}\n"
                       + "".join(f"{x!r} {y!r} 0\n" for x, y in points)
                       + f"Edges\n{len(edges)}\n" + "".join(f"{a} {b} 0\n" for a, b in edges) + "Triangles\n0\nEnd\n")
            return self.run_tool("audit", "test.mesh")
        line = [(0.0, 0.0), (2.0, 4.0), (1.0, 2.0)]
        self.assertEqual(flat(line, [(1, 3), (2, 3)]).returncode, 0)
        for points, edges in ((line, [(1, 2), (2, 3)]), (line, [(1, 3)]), (line, [(1, 3), (2, 3), (1, 2)]),
                              (line[:2] + [(1.0, 2.5)], [(1, 3), (2, 3)]), (line[:2] + line[:1], [(1, 2), (2, 3)])):
            done = flat(points, edges)
            self.assertEqual((done.returncode, "NOT Delaunay" in done.stdout), (1, True), (points, edges))
        for few in ([], [(1.0, 2.0)]):  # as replay writes what is left of a motion
            self.assertEqual(flat(few, []).returncode, 0)
        flat(line, [])
        self.assertIn("Edges where all points are collinear", self.refuse(3, "audit", "test.mesh"))

    def space(self, points, cells):
        self.write("space.mesh", f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(points)}\n"
                   + "".join(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in points)
                   + f"Tetrahedra\n{len(cells)}\n" + "".join(" ".join(map(str, c)) + " 0\n" for c in cells) + "End\n")
        return self.run_tool("audit", "space.mesh")

    def test_in_space(self):
        points = [(0, 0, 1.0), (0, 0, -1.0), (1.5, 0, 0), (-0.75, 1.25, 0), (-0.75, -1.25, 0)]
        three = [(1, 2, 4, 3), (1, 2, 5, 4), (1, 2, 3, 5)]
        two = [(3, 4, 5, 1), (4, 3, 5, 2)]
        self.assertIn("5 points, 3 tetrahedra: Delaunay\n", self.space(points, three).stdout)
        for cells in (two, three[:2], [(2, 1, 4, 3)] + three[1:]):
            done = self.space(points, cells)
            self.assertEqual((done.returncode, "NOT Delaunay" in done.stdout), (1, True), cells)
        far = [(0, 0, 3.0), (0, 0, -3.0)] + points[2:]
        self.assertEqual((self.space(far, two).returncode, self.space(far, three).returncode), (0, 1))
        self.assertIn("5 points, 2 tetrahedra: Delaunay", self.space(far, two).stdout)
        self.assertIn("vertex in no cell: 6", self.space(points + [(0.1, 0.1, 0.1)], three).stdout)

    def test_what_nodt_writes(self):
        self.succeed("nodt", "--sphere", "--vertices", "80", "--iterations", "3", "--output", "out", "--quiet")
        self.assertIn("Delaunay", self.succeed("audit", "out/final.mesh", "--output", "verdict").stdout)
        verdict = json.loads((self.here / "verdict" / "audit.json").read_text(encoding="utf-8"))
        self.assertEqual((verdict["dimension"], verdict["delaunay"]), (3, True))
        text = (self.here / "out" / "final.mesh").read_text(encoding="utf-8")
        self.write("spoiled.mesh", text.replace(text.split("\n")[6], "0.1 0.2 0.3 0", 1))
        self.assertEqual(self.run_tool("audit", "spoiled.mesh").returncode, 1)

    def test_flat_in_space(self):
        for last, word in (("1,1,0", "2 triangles"), ("3,0,0", "3 edges")):
            rows = ["0,0,0", "1,0,0", "0,1.5,0" if "tri" in word else "2,0,0", last]
            self.write("flat.csv", "frame,id,x,y,z\n" + "".join(f"{f},{i},{p}\n" for f in (0, 1)
                                                                for i, p in enumerate(rows)))
            self.succeed("replay", "flat.csv", "--dim", "3", "--output", "out", "--quiet")
            self.assertIn(f"4 points, {word}: Delaunay", self.succeed("audit", "out/final.mesh").stdout)

    def test_a_fault_names_vertices_as_the_file_does(self):
        name = self.mesh_file(self.SQUARE, [(1, 3, 2), (1, 3, 4)])
        self.assertIn("cell not positively oriented: 1 3 2", self.run_tool("audit", name).stdout)
        name = self.mesh_file(self.SQUARE, [(1, 2, 3)])
        self.assertIn("vertex in no cell: 4", self.run_tool("audit", name).stdout)


class Counterexample(ToolTest):
    def numbers(self, *words):
        return json.loads(self.succeed("counterexample", "--json", *words).stdout)

    def test_the_paper_accepts_what_is_not_delaunay(self):
        for delta in (0.01, 0.1, 1e-3, 1e-6, 1e-9):
            r = self.numbers("--delta", delta)
            tolerance = r["tolerance"]
            # Spheres around the origin, radii 1 - delta and 1: half of delta. p, q are rounded, and so is 1 - delta.
            self.assertAlmostEqual(tolerance["exact"] / delta, 0.5, delta=1e-15 / delta)
            self.assertLessEqual(tolerance["certified"], tolerance["exact"])
            self.assertGreaterEqual(tolerance["certified"], 0.996 * tolerance["exact"])
            self.assertGreater(tolerance["paper"], 1.4 * tolerance["exact"])
            self.assertAlmostEqual(r["move"], 0.7 * delta)
            self.assertEqual(r["accepted"], {"paper": True, "certified": False})
            self.assertEqual(r["delaunay"], {"three_cells_before": True, "three_cells_after": False,
                                             "two_cells_after": True})
        self.assertAlmostEqual(self.numbers()["tolerance"]["paper"], 0.00748, places=5)

    def test_text_and_file(self):
        done = self.succeed("counterexample", "--output", "out")
        self.assertIn("paper accepts, certified requires an evaluation", done.stdout)
        self.assertIn("three cells around ab: NOT Delaunay; two cells at pqr: Delaunay", done.stdout)
        written = json.loads((self.here / "out" / "counterexample.json").read_text(encoding="utf-8"))
        self.assertEqual({**written, "command": "annulus counterexample --json"}, self.numbers())
        self.assertEqual(self.succeed("counterexample", "--quiet").stdout, "")

    def test_refusals(self):
        for delta in ("0", "-0.1", "0.2", "nan", "x"):
            self.refuse(2, "counterexample", "--delta", delta)
        self.write("file", "")
        self.refuse(3, "counterexample", "--output", "file")


if __name__ == "__main__":
    tool.main(__doc__)
