#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus degeneracy` and checks its output. usage: test_degeneracy.py --tool=PATH [CLASS[.METHOD]...]"""

import json
import math
import random
import re
import xml.etree.ElementTree

import tool

GRID = [(x, y) for x in range(6) for y in range(6)]
LATTICE = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)]


class Degeneracy(tool.ToolTest):
    def csv(self, name, points):
        head = "x,y,z\n" if len(points[0]) == 3 else "x,y\n"
        return self.write(name, head + "".join(",".join(repr(c) for c in p) + "\n" for p in points))

    def study(self, *words):
        done = self.succeed("degeneracy", *words, "--output", "out", "--quiet")
        self.assertEqual(done.stdout, "")
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, {"degeneracy.json", "degeneracy.html"})
        page = (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")
        numbers = page.split("<script>")[0]
        self.assertFalse(re.search(r"(?i)\b(nan|inf)\b", numbers), "the page shows what is no number")
        self.assertNotIn("http", page.replace("http://www.w3.org/2000/svg", ""))
        for svg in page.split("<svg")[1:]:
            xml.etree.ElementTree.fromstring("<svg" + svg.split("</svg>")[0] + "</svg>")
        return json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))

    def check_sums(self, result):
        thresholds = [t["name"] for t in result["thresholds"]]
        self.assertEqual(thresholds, ["1e-3", "1e-6", "1e-9", "1e-12", "ulp"])
        for kind in ("bicells", "cells", "ridges", "tolerance"):
            part = result[kind]
            self.assertEqual(list(part["below"]), thresholds)
            for n in part["below"].values():
                self.assertLessEqual(part["zero"], n)
                self.assertLessEqual(n, part["total"])
            if kind != "tolerance":
                self.assertEqual(sum(part["arithmetic"].values()), part["total"])
                histogram = part["width"]["histogram"]
                self.assertEqual(sum(histogram["counts"]) + histogram["underflow"] + histogram["overflow"],
                                 part["total"])
        self.assertEqual(result["tolerance"]["total"], result["vertices"])
        self.assertEqual(result["points"] - result["merged"], result["vertices"])

    def test_a_grid(self):
        result = self.study(self.xyz("grid.xyz", GRID))
        self.check_sums(result)
        self.assertEqual((result["dimension"], result["affine_dimension"], result["vertices"]), (2, 2, 36))
        self.assertEqual((result["bicells"]["total"], result["bicells"]["zero"]), (65, 25))
        self.assertEqual((result["cells"]["total"], result["cells"]["zero"]), (50, 0))
        self.assertEqual((result["ridges"]["total"], result["ridges"]["zero"]), (20, 16))
        self.assertEqual(result["tolerance"]["share_unsound"], 0)
        self.assertIsNone(result["standard_annuli"])
        page = (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")
        self.assertNotIn('aria-label="Tolerances of vertices"', page)  # all are exactly 0
        self.assertIn("All vertices have a certified tolerance of 0", page)
        self.assertIn("The histogram of widths leaves out 25 of the 65 bi-cells", page)
        self.assertIn("<dt>Bi-cell</dt><dd>Two triangles that share an edge.</dd>", page)
        # Half of the bi-cells are 0, the others have one width: a step up to 100 %, on a decade or more.
        widths = page.split('aria-label="Widths"')[1].split("</svg>")[0]
        labels = re.findall(r'class="tl m"[^>]*>([^<]+)<', widths)
        self.assertGreaterEqual(len(labels), 2)
        shares = [float(s) for s in re.findall(r'class="tl e"[^>]*>([^<]+)<', widths)]
        self.assertEqual(max(shares), 100)
        curve = re.findall(r"[ML]([\d.]+) ([\d.]+)", re.search(r'class="curve c0" d="([^"]*)"', widths)[1])
        self.assertEqual(curve[0][1], curve[1][1])
        self.assertEqual(curve[1][0], curve[2][0])
        self.assertEqual(curve[2][1], curve[3][1])
        # The step is at the greatest width, as a place between the two ticks with labels.
        ticks = [(float(x), float(n)) for x, n in re.findall(r'class="tl m" x="([\d.]+)"[^>]*>([\d.]+)<', widths)]
        (x0, n0), (x1, n1) = ticks[0], ticks[-1]
        share = math.log(result["bicells"]["width"]["quantiles"]["1"] / n0) / math.log(n1 / n0)
        self.assertAlmostEqual(float(curve[1][0]), x0 + share * (x1 - x0), delta=0.5)

    def test_widths_that_are_all_equal(self):
        """Of two equilateral triangles: no histogram, which would be a bar."""
        self.study(self.csv("rhombus.csv", [(0, 0), (1, 0), (0.5, 3 ** 0.5 / 2), (1.5, 3 ** 0.5 / 2)]))
        page = (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")
        self.assertIn("The only bi-cell is not exactly degenerate: the narrowest annulus is ", page)
        self.assertIn(" The bi-cell has the width ", page)
        self.assertIn('aria-label="Widths"', page)
        self.assertNotIn('aria-label="Widths of bi-cells"', page)
        self.study(self.csv("bent.csv", [(0, 0), (1, 0), (0.5, 0.9), (1.5, 1), (2.5, 0.3)]))
        page = (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")
        self.assertIn('aria-label="Widths of bi-cells"', page)

    def test_a_lattice(self):
        result = self.study(self.csv("lattice.csv", LATTICE))
        self.check_sums(result)
        self.assertEqual((result["dimension"], result["affine_dimension"]), (3, 3))
        self.assertGreater(result["bicells"]["zero"], 0)
        self.assertEqual(result["bicells"]["zero"], result["standard_annuli"]["zero"])
        self.assertEqual(result["cells"]["zero"], 0)

    def test_the_same_points_from_every_format(self):
        dice = random.Random(2)
        points = [tuple(dice.random() for _ in range(3)) for _ in range(60)]
        text = "\n".join(" ".join(repr(c) for c in p) for p in points) + "\n"
        files = [
            self.csv("p.csv", points),
            self.write("p.xyz", text),
            self.write("p.off", f"OFF\n{len(points)} 0 0\n" + text),
            self.write("p.ply", "ply\nformat ascii 1.0\nelement vertex 60\nproperty double x\nproperty double y\n"
                                "property double z\nend_header\n" + text),
            self.write("p.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n60\n" +
                       "".join(" ".join(repr(c) for c in p) + " 0\n" for p in points) + "End\n"),
        ]
        results = []
        for name in files:
            result = self.study(name)
            self.check_sums(result)
            for key in ("command", "file", "seconds", "columns"):
                result.pop(key, None)  # formats with a fixed order of coordinates have no columns
            results.append(result)
        for result in results[1:]:
            self.assertEqual(result, results[0])

    def test_dimension(self):
        dice = random.Random(3)
        space = self.csv("space.csv", [tuple(dice.random() for _ in range(3)) for _ in range(30)])
        plane = self.csv("plane.csv", [tuple(dice.random() for _ in range(2)) for _ in range(30)])
        self.assertEqual(self.study(space)["dimension"], 3)
        self.assertEqual(self.study(space, "--dim", "3")["dimension"], 3)
        self.assertEqual(self.study(space, "--ignore-z")["dimension"], 2)
        self.assertEqual(self.study(space, "--ignore-z", "--dim", "2")["dimension"], 2)
        self.assertEqual(self.study(plane)["dimension"], 2)
        self.assertIn("--ignore-z", self.refuse(3, "degeneracy", space, "--dim", "2"))
        self.assertIn("no z", self.refuse(3, "degeneracy", plane, "--dim", "3"))
        self.refuse(2, "degeneracy", space, "--dim", "3", "--ignore-z")
        self.refuse(2, "degeneracy", space, "--dim", "4")
        self.refuse(2, "degeneracy")

    def test_duplicates_are_merged(self):
        done = self.run_tool("degeneracy", self.xyz("twice.xyz", GRID + [(0.0, -0.0), (3, 3)]), "--output", "out")
        self.assertEqual(done.returncode, 0)
        self.assertIn("merged 2 duplicate points", done.stderr)
        self.assertIn("36 points in dimension 2", done.stdout)
        result = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        self.assertEqual((result["points"], result["merged"], result["vertices"]), (38, 2, 36))

    def test_flat_points(self):
        for name, points, span, simplices, words in (
            ("line", [(x, 2 * x) for x in range(5)], 1, 4, "on a line"),
            ("two", [(0, 0), (1, 0)], 1, 1, "on a line"),
            ("plane", [(x, y, x + y) for x in range(3) for y in range(3)], 2, 8, "in a plane"),
            ("line3", [(x, x, x) for x in range(4)], 1, 3, "on a line"),
        ):
            name = self.csv(name + ".csv", points)
            result = self.study(name)
            self.assertEqual((result["affine_dimension"], result["simplices"]), (span, simplices), name)
            self.assertIsNone(result["bicells"])
            self.assertIn(words, self.succeed("degeneracy", name).stdout)

    def test_bad_input(self):
        self.assertIn("at least 2", self.refuse(3, "degeneracy", self.xyz("one.xyz", [(1, 2), (1, 2)])))
        self.assertIn("out of domain", self.refuse(3, "degeneracy", self.xyz("far.xyz", [(1, 2), (1e200, 2), (0, 0)])))
        self.refuse(3, "degeneracy", "missing.xyz")
        self.refuse(3, "degeneracy", self.write("bad.csv", "x,y\n0,0\n1,nan\n"))
        self.write("file", "")
        self.refuse(3, "degeneracy", self.xyz("grid.xyz", GRID), "--output", "file")

    def test_the_published_tolerance_is_unsound_in_space(self):
        h = 0.75**0.5
        result = self.study(self.csv("five.csv", [(0, 0, 0.99), (0, 0, -0.99), (1, 0, 0), (-0.5, h, 0), (-0.5, -h, 0)]))
        self.assertEqual(result["tolerance"]["share_unsound"], 1)
        self.assertEqual(result["tolerance"]["unsound_certificates"], 3)
        self.assertEqual(result["convexity"]["share_non_convex"], 1)

    def test_extreme_magnitudes(self):
        dice = random.Random(5)
        points = [(dice.random(), dice.random()) for _ in range(50)]
        here = self.study(self.xyz("here.xyz", points))
        for k in (-900, -490, 490):
            there = self.study(self.xyz("there.xyz", [(x * 2.0**k, y * 2.0**k) for x, y in points]))
            self.check_sums(there)
            self.assertAlmostEqual(there["mean_spacing"] / here["mean_spacing"] / 2.0**k, 1, places=12)
            self.assertEqual(there["bicells"]["below"], here["bicells"]["below"])


if __name__ == "__main__":
    tool.main(__doc__)
