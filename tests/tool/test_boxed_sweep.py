#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus sweep` in periodic boxes, beside `generate --box` and `degeneracy`. usage: test_boxed_sweep.py --tool=PATH
[CLASS[.METHOD]...]"""

import json
from fractions import Fraction

import tool

SPEC = """hardest = 5

[[grid]]
box = ["2,1", "1,0.25,0,2", "1,1,1"]
points = [1, 40]
kind = ["uniform", "jittered"]
seeds = 2

[[grid]]
box = "2,2,2"
points = 32
kind = ["fcc", "clusters"]
motion = { kind = ["walk", "shear", "orbit"], pace = 0.3, steps = [0, 1, 4] }

[[grid]]
points = 40
seeds = 2
"""


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    minors = ([row[:k] + row[k + 1:] for row in rows[1:]] for k in range(len(rows)))
    return sum((-1) ** k * rows[0][k] * determinant(minor) for k, minor in enumerate(minors))


def orientation(points):
    return determinant([[a - b for a, b in zip(p, points[0])] for p in points[1:]])


class BoxedSweep(tool.ToolTest):
    def sweep(self, spec, *words):
        self.succeed("sweep", self.write("spec.toml", spec), "--output", "out", "--quiet", "--force", *words)
        return self.lines("results.jsonl")

    def lines(self, name):
        return [json.loads(line) for line in (self.here / "out" / name).read_text(encoding="utf-8").splitlines()]

    def study(self, *words):
        self.succeed("degeneracy", *words, "--quiet", "--output", "d")
        return json.loads((self.here / "d" / "degeneracy.json").read_text(encoding="utf-8"))

    def agree(self, line, there):
        self.assertEqual(line["box"], there["box"])
        self.assertEqual([line[key] for key in ("dimension", "vertices", "mean_spacing", "resolution")],
                         [there[key] for key in ("dimension", "vertices", "mean_spacing", "resolution")])
        counts = line["counts"]
        self.assertFalse([name for name in [*counts, *line["histograms"]] if "ridges" in name or "paper" in name])
        for kind in ("bicells", "cells"):
            self.assertEqual(counts[f"{kind}.total"], there[kind]["total"])
            self.assertEqual(counts[f"{kind}.zero"], there[kind]["zero"])
            for name, n in there[kind]["below"].items():
                self.assertEqual(counts[f"{kind}.below.{name}"], n)
        self.assertEqual(counts["tolerance.zero"], there["tolerance"]["zero"])
        self.assertEqual(counts["vertices"], there["tolerance"]["total"])

    def test_the_numbers_are_those_of_degeneracy(self):
        lines = self.sweep(SPEC)
        self.assertEqual(len(lines), 3 * 2 * 2 * 2 + 2 * 3 * 3 + 2)
        self.assertEqual([list(line)[:5] for line in lines[:-2]],
                         [["grid", "name", "kind", "dimension", "box"]] * (len(lines) - 2))
        given = ["2,1", "1,0.25,0,2", "1,1,1"]
        vectors = [[[2, 0], [0, 1]], [[1, 0.25], [0, 2]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]]
        for line in lines[:-2]:
            with self.subTest(line=line["kind"] + str(line["box"]), step=line["step"]):
                box = given[vectors.index(line["box"])] if line["grid"] == 1 else "2,2,2"
                words = ["--box", box, "--points", line["points"], "--seed", line["seed"], "--output", "p.xyz",
                         "--force"]
                if "motion" in line:
                    self.succeed("generate", line["motion"], "--from", line["kind"], "--steps", line["step"], "--pace",
                                 line["pace"], *words)
                    self.agree(line, self.study("p.xyz", "--frame", line["step"]))
                else:
                    self.succeed("generate", line["kind"], *words)
                    self.agree(line, self.study("p.xyz"))
        self.assertNotEqual(lines[0]["seed"], lines[4]["seed"])  # of two boxes
        shear = [line for line in lines if line.get("motion") == "shear"]
        self.assertNotEqual(shear[0]["box"], shear[1]["box"])  # which goes along
        for line in lines[-2:]:
            self.assertNotIn("box", line)
            self.assertIn("ridges.total", line["counts"])

    def test_sums_and_the_page(self):
        lines = self.sweep(SPEC)
        first = (self.here / "out" / "sums.json").read_bytes()
        sums = json.loads(first)["sums"]
        self.assertEqual(len(sums), 3 * 2 * 2 + 2 * 3 * 3 + 1)
        for one in sums[:12]:
            alike = [line for line in lines if line.get("box") == one["box"] and line["grid"] == one["grid"] and
                     (line["kind"], line["points"]) == (one["kind"], one["points"])]
            self.assertEqual(len(alike), 2)
            for name, n in one["counts"].items():
                self.assertEqual(sum(line["counts"][name] for line in alike), n)
        page = (self.here / "out" / "sweep.html").read_text(encoding="utf-8")
        self.assertIn("In periodic boxes in 2D ", page)
        self.assertIn("In periodic boxes in 3D ", page)
        self.assertIn("box 2 × 1", page)
        self.assertIn("box (1 0.25) (0 2)", page)
        self.assertEqual(page.count("tolerance is unsound"), 1)  # with open boundaries
        self.assertIn(" of 80 vertices", page)
        self.sweep(SPEC, "--threads", 2)
        self.assertEqual((self.here / "out" / "sums.json").read_bytes(), first)

    def test_hard_inputs_have_the_places_of_images(self):
        self.sweep("hardest = 40\n[[grid]]\nbox = [\"2,1\", \"1,1,1\"]\npoints = 30\nseeds = 3\n")
        page = (self.here / "out" / "sweep.html").read_text(encoding="utf-8")  # of boxes alone
        self.assertEqual(page.count("the standard one has those of the shared edge (2D) or triangle (3D)"), 1)
        self.assertNotRegex(page.split("</h1>")[1], "(?i)paper|unsound")
        hard = self.lines("hard.jsonl")
        self.assertEqual({one["certificate"] for one in hard},
                         {"orientation_2", "empty_circle_2", "orientation_3", "empty_sphere_3"})
        outside = 0
        for one in hard:
            points = [[Fraction(float.fromhex(c)) for c in p] for p in one["points"]]
            outside += any(not 0 <= c < 2 for p in points for c in p)
            d = len(points[0])
            if one["certificate"].startswith("orientation"):
                self.assertGreater(orientation(points), 0)
                continue
            self.assertGreater(orientation([*points[:d], points[-1]]), 0)
            p = points[d]
            lifted = [[a - b for a, b in zip(q, p)] for q in [*points[:d], points[-1]]]
            sign = determinant([[*row, sum(c * c for c in row)] for row in lifted])
            self.assertGreater(-sign if d == 2 else sign, 0)  # p is outside
        self.assertGreater(outside, 0)

    def test_rounding_merges_images(self):
        """In the box of edge 2 the points at 0.004 and 1.996 are at one place after rounding to two decimals, as are
        two that are equal then, and those a box apart."""
        self.write("a.csv", "x,y\n0.004,0.5\n1.996,0.5\n0.302,0.7\n0.298,0.7\n3.1,1\n1.1,-1\n1,1.7\n")
        spec = "[[grid]]\nfile = \"a.csv\"\nbox = \"2,2\"\nrounding = [\"double\", \"decimal:2\"]\n"
        lines = self.sweep(spec)
        self.assertEqual([(line["points"], line["vertices"], line["merged"]) for line in lines],
                         [(7, 6, 1), (7, 4, 3)])
        self.write("b.csv", "x,y\n0,0.5\n0.3,0.7\n1.1,1\n1,1.7\n")
        self.agree(lines[1], self.study("b.csv", "--box", "2,2"))
        # The grid of the box is coarser than doubles: the second point is rounded to the opposite side.
        self.write("a.csv", "x,y\n0,0.5\n1.9999999999999998,0.5\n0.3,0.7\n1,1\n")
        [line] = self.sweep("[[grid]]\nfile = \"a.csv\"\nbox = \"2,2\"\n")
        self.assertEqual((line["vertices"], line["merged"]), (3, 1))

    def test_files_with_boxes(self):
        self.succeed("generate", "shear", "--from", "jittered", "-n", 30, "--box", "2,1", "--steps", 4, "--pace", 0.5,
                     "--output", "a.xyz")
        self.succeed("generate", "uniform", "-n", 30, "--box", "1,1,2", "--output", "b.lammpstrj")
        lines = self.sweep("[[grid]]\nfile = \"a.xyz\"\nevery = 2\n[[grid]]\nfile = \"b.lammpstrj\"\n"
                           "[[grid]]\nfile = \"a.xyz\"\nframes = 1\nbox = \"3,0,0.5,2\"\n"
                           "[[grid]]\nfile = \"b.lammpstrj\"\nopen = true\n")
        self.assertEqual([line.get("frame") for line in lines], [0, 2, 4, None, 1, None])
        for line in lines[:3]:
            self.agree(line, self.study("a.xyz", "--frame", line["frame"]))
        self.assertNotEqual(lines[0]["box"], lines[1]["box"])
        self.agree(lines[3], self.study("b.lammpstrj"))
        self.agree(lines[4], self.study("a.xyz", "--frame", 1, "--box", "3,0,0.5,2"))
        self.assertEqual((lines[5]["ignored"], "box" in lines[5]), (["box"], False))
        self.assertGreater(lines[5]["counts"]["ridges.total"], 0)
        text = (self.here / "b.lammpstrj").read_text(encoding="utf-8").replace("pp pp pp", "pp pp ff")
        self.write("slab.lammpstrj", text)
        said = self.refuse(3, "sweep", self.write("spec.toml", "[[grid]]\nfile = \"slab.lammpstrj\"\n"), "--output",
                           "slab")
        self.assertIn("periodic in x and y only", said)
        self.assertIn("open = true in its [[grid]]", said)

    def test_refusals(self):
        grid = "[[grid]]\npoints = 32\n"
        for text, line, words in (
                ("box = [1, 1]\n", 3, "'box' is 1"),
                ("box = \"1,x\"\n", 3, "'box': 'x' is not a number"),
                ("box = \"\"\n", 3, "'box': '' is not a number"),
                ("box = \"1\"\n", 3, "'box' has 1 number, and a box has 2 or 4 in 2D"),
                ("box = \"1,1,2,2\"\n", 3, "'box': the vectors of the box"),
                ("box = [\"1,1\", \"1,1\"]\n", 3, "twice"),
                ("box = \"1,1\"\ndimension = 2\n", 4, "'dimension' and 'box' exclude each other"),
                ("box = \"1,1\"\nmotion = { kind = \"lloyd\", steps = 1 }\n", 4, "lloyd moves points with open"),
                ("box = \"1,1,1\"\nmotion = { kind = \"nodt\", steps = 1 }\n", 4, "nodt moves points with open"),
                ("kind = \"fcc\"\n", 3, "fcc is a crystal, which fills a periodic box; expected a 'box'"),
                ("box = \"1,1\"\nkind = \"fcc\"\n", 3, "fcc is a crystal in 3D"),
                ("box = \"1,1,1\"\nkind = \"sc\"\n", 2,
                 "'points' is 32, which whole unit cells of sc in the box do not have; expected 27 or 64"),
        ):
            with self.subTest(text=text):
                said = self.refuse(3, "sweep", self.write("spec.toml", grid + text), "--output", "out")
                self.assertIn(f"spec.toml:{line}: ", said)
                self.assertIn(words, said)
        spec = self.write("spec.toml", "[[grid]]\nfile = \"spec.toml\"\nbox = \"1,1\"\nopen = true\n")
        self.assertIn("'open' and 'box' exclude each other", self.refuse(3, "sweep", spec, "--output", "out"))


if __name__ == "__main__":
    tool.main(__doc__)
