#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The degeneracy of frames of a motion.

usage: test_frame_degeneracy.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import json
import random

import tool

try:
    import scipy.spatial
except ImportError:
    scipy = None
try:
    import vtk
except ImportError:
    vtk = None


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
        bicells = sum(int(r["bicells"]) for r in rows)
        self.assertIn(f'<p class="finding">25 of the {bicells} bi-cells of 3 frames are exactly degenerate, in 1 of '
                      "them. The median certified tolerance ", page)
        self.assertIn("The paper&#39;s tolerance is sound at all vertices.</p>", page)
        # What is 0 in all frames is a sentence, and no plot.
        self.assertIn('aria-label="Bi-cells that are exactly degenerate"', page)
        self.assertNotIn('aria-label="Vertices at which', page)
        self.assertIn("The paper&#39;s tolerance is sound at all vertices of all frames.", page)
        self.assertIn("<h2>Terms</h2>", page)
        lines = self.succeed("degeneracy", self.motion(), "--every", "1").stdout.splitlines()
        self.assertEqual(len(lines), 8)

    def test_flat_frames_have_no_numbers(self):
        self.write("a.xyz", "3\n\n0 0\n1 1\n2 2\n0\n\n3\n\n0 0\n1 0\n0 1\n")
        self.succeed("degeneracy", "a.xyz", "--every", "1", "--output", "out", "--quiet")
        with open(self.here / "out" / "degeneracy.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(r["points"], r["mean_spacing"] == "") for r in rows],
                         [("3", True), ("0", True), ("3", False)])
        said = "The points of no frame span the space"
        self.assertNotIn(said, (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8"))
        self.write("flat.xyz", "3\n\n0 0\n1 1\n2 2\n0\n\n")
        self.succeed("degeneracy", "flat.xyz", "--every", "1", "--output", "flat", "--quiet")
        page = (self.here / "flat" / "degeneracy.html").read_text(encoding="utf-8")
        self.assertIn(said, page)
        self.assertNotIn("<svg", page)

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
