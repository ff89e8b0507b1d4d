#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` and checks its results. Refusals are in test_sweep_spec.py and test_sweep_faults.py; threads and
kills in test_sweep_resumed.py, ranks in test_sweep_ranks.py.

usage: test_sweep.py --tool=PATH [CLASS[.METHOD]...]
"""

import csv
import json
import re
import shutil
from fractions import Fraction

import tool

SPEC = """title = "Some of everything"
hardest = 4

[[grid]]
points = [60, 300]
dimension = [2, 3]
kind = ["uniform", "jittered", "surface"]
rounding = ["double", "float", "decimal:3"]
seeds = 2

[[grid]]
name = "motions"
points = 100
motion = { kind = ["walk", "lloyd"], pace = [0.01, 0.1], steps = [0, 3, 10] }
seeds = 2

[[grid]]
points = 100
dimension = 3
motion = { kind = "nodt", steps = 2 }
"""
# About thirty trials of a twentieth of a second or more: long enough to be killed.
LONGER = """hardest = 3
[[grid]]
points = [2000, 4000]
dimension = 3
kind = ["uniform", "jittered", "clusters"]
seeds = 5
"""
HASHED = ["results.jsonl", "sums.json", "hard.jsonl", "sweep.html", "spec.toml"]
FILES = {*HASHED, "costs.jsonl"}
JOURNAL = ".sweep-journal"


class SweepTest(tool.ToolTest):
    def sweep(self, spec, directory, *words):
        self.succeed("sweep", self.write("spec.toml", spec), "--output", directory, "--quiet", *words)
        return self.results(directory)

    def results(self, directory):
        self.assertEqual({p.name for p in (self.here / directory).iterdir()}, FILES)
        return {name: (self.here / directory / name).read_bytes() for name in HASHED}

    def lines(self, directory, name="results.jsonl"):
        return [json.loads(line) for line in (self.here / directory / name).read_text(encoding="utf-8").splitlines()]


class Found(SweepTest):
    def test_the_numbers_are_those_of_degeneracy(self):
        """Compares each line with `generate` and `degeneracy` for the line's parameters."""
        self.sweep(SPEC, "out")
        lines = self.lines("out")
        self.assertEqual(len(lines), 72 + 2 * 3 * 3 + 1)
        for i, line in enumerate(lines):
            if line.get("motion") in ("lloyd", "nodt") or line["rounding"] != "double":
                continue
            with self.subTest(line=i):
                words = ["--dim", line["dimension"], "--points", line["points"], "--seed", line["seed"], "--output",
                         "p.xyz", "--force"]
                if "motion" in line:
                    self.succeed("generate", line["motion"], "--steps", line["step"], "--pace", line["pace"], *words)
                    self.succeed("degeneracy", "p.xyz", "--frame", line["step"], "--quiet", "--output", "d")
                else:
                    self.succeed("generate", line["kind"], *words)
                    self.succeed("degeneracy", "p.xyz", "--quiet", "--output", "d")
                there = json.loads((self.here / "d" / "degeneracy.json").read_text(encoding="utf-8"))
                self.assertEqual((line["vertices"], line["mean_spacing"]), (there["vertices"], there["mean_spacing"]))
                counts = line["counts"]
                for kind in ("bicells", "cells", "ridges"):
                    self.assertEqual(counts[f"{kind}.total"], there[kind]["total"])
                    self.assertEqual(counts[f"{kind}.zero"], there[kind]["zero"])
                    for name, n in there[kind]["below"].items():
                        self.assertEqual(counts[f"{kind}.below.{name}"], n)
                    for name, n in there[kind]["arithmetic"].items():
                        self.assertEqual(counts[f"{kind}.stage.{name}"], n)
                self.assertEqual(counts["bicells.not_convex"], there["convexity"]["non_convex"])
                histogram = line["histograms"]["bicells.width"]
                padded = [0] * histogram["first"] + histogram["in"]
                self.assertEqual(padded, there["bicells"]["width"]["histogram"]["counts"][:len(padded)])
                self.assertEqual(line["least"]["bicells.width"], there["bicells"]["width"]["quantiles"]["0"])
                h = line["histograms"]["tolerance.paper_over_exact"]  # its bin 80 begins at 1
                dense = [0] * h["first"] + h["in"] + [0] * 320
                self.assertLessEqual(sum(dense[81:]) + h["above"], counts["tolerance.paper_above_exact"])
                self.assertGreaterEqual(sum(dense[80:]) + h["above"], counts["tolerance.paper_above_exact"])
                self.assertEqual(counts["tolerance.paper_unsound"],
                                 round(there["tolerance"]["share_unsound"] * there["vertices"]))
                for stage in ("filter", "interval", "exact"):
                    for name in ("theta_log", "bicells.width_ulps"):
                        h = line["histograms"][f"{name}.{stage}"]
                        self.assertEqual(sum(h["in"]) + h["below"] + h["above"], counts[f"bicells.stage.{stage}"])

    def test_sums(self):
        """In Python integers."""
        self.sweep(SPEC, "out")
        sums = json.loads((self.here / "out" / "sums.json").read_text(encoding="utf-8"))
        expected = {}
        for line in self.lines("out"):
            where = {k: v for k, v in line.items() if k in ("grid", "name", "kind", "dimension", "points", "rounding",
                                                            "motion", "pace", "step")}
            expected.setdefault(json.dumps(where), []).append(line)
        self.assertEqual(len(sums["sums"]), len(expected))
        for one, (where, lines) in zip(sums["sums"], expected.items()):
            self.assertEqual({k: one[k] for k in json.loads(where)}, json.loads(where))
            self.assertEqual(one["counts"], {k: sum(line["counts"][k] for line in lines) for k in lines[0]["counts"]})
            self.assertEqual(one["least"], {k: min(line["least"][k] for line in lines) for k in lines[0]["least"]})
            for name, h in one["histograms"].items():
                dense = [0] * sums["scales"][name]["bins"]
                for line in lines:
                    for i, n in enumerate(line["histograms"][name]["in"]):
                        dense[line["histograms"][name]["first"] + i] += n
                self.assertEqual([0] * h["first"] + h["in"], dense[:h["first"] + len(h["in"])])
                self.assertEqual(sum(h["in"]), sum(dense))
                self.assertEqual(h["below"], sum(line["histograms"][name]["below"] for line in lines))

    def test_seeds(self):
        """The same points are rounded in several ways, other trials have different points; seeds of a list are used
        unchanged."""
        self.sweep("[[grid]]\npoints = [20, 30]\nkind = [\"uniform\", \"jittered\"]\nrounding = [\"double\", "
                   "\"float\"]\nseeds = 3\n", "out")
        seeds = {}
        for line in self.lines("out"):
            seeds.setdefault((line["points"], line["kind"], line["rounding"]), []).append(line["seed"])
        for n in (20, 30):
            for kind in ("uniform", "jittered"):
                self.assertEqual(seeds[n, kind, "double"], seeds[n, kind, "float"])
        self.assertEqual(len({s for some in seeds.values() for s in some}), 12)
        self.sweep("[[grid]]\npoints = 20\nseeds = [7, 5]\n", "list")
        self.assertEqual([line["seed"] for line in self.lines("list")], [7, 5])
        before = self.sweep("seed = 2\n[[grid]]\npoints = 20\n", "a")
        self.assertNotEqual(self.sweep("seed = 3\n[[grid]]\npoints = 20\n", "b")["results.jsonl"],
                            before["results.jsonl"])

    def test_rounded_points(self):
        self.succeed("generate", "uniform", "--points", 200, "--seed", 7, "--output", "p.xyz")
        points = [tuple(map(float, line.split()[-2:]))
                  for line in (self.here / "p.xyz").read_text().splitlines()[-200:]]
        self.xyz("r.xyz", [tuple(float(f"{c:.2f}") for c in p) for p in points])
        self.succeed("degeneracy", "r.xyz", "--quiet", "--output", "d")
        there = json.loads((self.here / "d" / "degeneracy.json").read_text(encoding="utf-8"))
        self.sweep("[[grid]]\npoints = 200\nrounding = \"decimal:2\"\nseeds = [7]\n[[grid]]\nfile = "
                   "\"p.xyz\"\nrounding = \"decimal:2\"\n", "out")
        for line in self.lines("out"):
            self.assertEqual((line["vertices"], line["merged"]), (there["vertices"], there["merged"]))
            self.assertEqual(line["counts"]["bicells.zero"], there["bicells"]["zero"])
        self.assertGreater(there["bicells"]["zero"], 0)

    def test_recorded_motions(self):
        self.succeed("generate", "walk", "--points", 50, "--steps", 6, "--pace", 0.2, "--output", "walk.xyz")
        self.sweep("[[grid]]\nfile = \"walk.xyz\"\nevery = 3\n[[grid]]\nfile = \"walk.xyz\"\nframes = [6, 1]\n", "out")
        lines = self.lines("out")
        self.assertEqual([line["frame"] for line in lines], [0, 3, 6, 1, 6])
        self.assertEqual(lines[2]["counts"], lines[4]["counts"])

    def test_a_periodic_box_that_is_ignored_is_announced(self):
        frame = ('4\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3\nH .1 0 0\nH .2 .3 0\nH .5 .1 0\nH .3 '
                 '-.2 {}\n')
        self.write("one.xyz", frame.format(1))
        self.write("two.xyz", frame.format(1) + frame.format(2))
        self.xyz("open.xyz", [(0.1, 0.0), (0.2, 0.3), (0.5, 0.1)])
        for grid in ('file = "one.xyz"\n', 'file = "one.xyz"\ndimension = 2\n', 'file = "two.xyz"\nevery = 1\n',
                     'file = "two.xyz"\nframes = 1\n'):
            with self.subTest(grid=grid):
                name = grid.split('"')[1]
                self.sweep(f"[[grid]]\n{grid}", "taken")
                self.assertNotIn("is ignored", (self.here / "taken" / "sweep.html").read_text(encoding="utf-8"))
                self.assertTrue(all("box" in line and "ignored" not in line for line in self.lines("taken")))
                self.sweep(f"[[grid]]\n{grid}open = true\n[[grid]]\nfile = \"open.xyz\"\n", "out")
                lines, sums = self.lines("out"), json.loads((self.here / "out"
                                                             / "sums.json").read_text(encoding="utf-8"))["sums"]
                for line in lines + sums:
                    self.assertEqual(line.get("ignored"), ["box"] if line["file"] == name else None)
                page = (self.here / "out" / "sweep.html").read_text(encoding="utf-8")
                self.assertEqual(page.count("its periodic box is ignored"), 1)
                self.assertLess(page.index(f"{name}: its periodic box is ignored"), page.index("<table"))
                for directory in ("out", "taken"):
                    shutil.rmtree(self.here / directory)

    def test_repeated_points(self):
        """Repeated points of a file count in `points` and `merged`, as in degeneracy.json; so do those that rounding
        merges."""
        corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (3.0, 2.0), (0.25, 0.25)]
        self.xyz("set.xyz", corners + [(1.0, 0.0), (1.0, 0.0), (-0.0, 1.0)])
        frames = corners, [*corners[1:], corners[2]]
        self.write("motion.csv", "frame,id,x,y\n" + "".join(f"{f},{i},{x},{y}\n" for f, frame in enumerate(frames)
                                                            for i, (x, y) in enumerate(frame)))
        self.succeed("degeneracy", "set.xyz", "--quiet", "--output", "set")
        self.succeed("degeneracy", "motion.csv", "--frame", 1, "--quiet", "--output", "frame")
        self.sweep("[[grid]]\nfile = \"set.xyz\"\nrounding = [\"double\", \"grid:1.5\"]\n[[grid]]\nfile = "
                   "\"motion.csv\"\nframes = 1\n", "out")
        double, coarse, frame = self.lines("out")
        for line, name, merged in ((double, "set", 3), (frame, "frame", 1)):
            there = json.loads((self.here / name / "degeneracy.json").read_text(encoding="utf-8"))
            keys = ("points", "vertices", "merged")
            self.assertEqual([line[k] for k in keys], [there[k] for k in keys], name)
            self.assertEqual(line["merged"], merged)
        self.assertEqual((coarse["points"], coarse["vertices"], coarse["merged"]), (8, 4, 4))

    def test_flat_points(self):
        self.sweep("[[grid]]\npoints = [1, 2, 30]\nrounding = \"grid:10\"\n", "out")
        for line in self.lines("out"):
            self.assertLess(line["affine_dimension"], 2)
            self.assertEqual(line["counts"], {"experiments": 1, "flat": 1})

    def test_hardest(self):
        """Compared with all certificates (`degeneracy --raw`), and in rational numbers."""
        self.sweep("hardest = 6\n[[grid]]\npoints = 400\nkind = \"jittered\"\nrounding = \"decimal:3\"\nseeds = [4]\n",
                   "out")
        self.sweep("hardest = 6\n[[grid]]\npoints = 400\nkind = \"jittered\"\nseeds = [4]\n", "unrounded")
        self.succeed("generate", "jittered", "--points", 400, "--seed", 4, "--output", "p.xyz")
        points = [tuple(float(f"{float(c):.3f}") for c in line.split()[-2:])
                  for line in (self.here / "p.xyz").read_text().splitlines()[-400:]]
        self.xyz("r.xyz", points)
        self.succeed("degeneracy", "r.xyz", "--raw", "raw.csv", "--quiet")
        met = {}
        with open(self.here / "raw.csv", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                x = [points[int(row[f"point_{i}"])] for i in range(4) if row[f"point_{i}"]]
                size = max(abs(a - b) for p in x[1:] for a, b in zip(p, x[0]))
                if float(row["width_upper"]) > 0 and row["stage"] != "filter":
                    met.setdefault((len(x), row["stage"]), []).append((float(row["width_lower"]) / size, frozenset(x)))
        hard = self.lines("out", "hard.jsonl")
        for name, k in (("orientation_2", 3), ("empty_circle_2", 4)):
            for stage in ("interval", "exact"):
                ours = [h for h in hard if (h["certificate"], h["stage"]) == (name, stage)]
                keys = {}
                for key, x in met.get((k, stage), []):
                    keys[x] = min(key, keys.get(x, key))
                self.assertEqual([float.fromhex(h["key"]) for h in ours], sorted(keys.values())[:6])
        hard += self.lines("unrounded", "hard.jsonl")
        self.assertEqual(len([h for h in hard if h["stage"] == "filter"]), 24)
        for h in hard:
            self.assertGreater(self.determinant(h["points"]), 0)
            if h["stage"] == "filter":
                self.assertGreaterEqual(float.fromhex(h["key"]), 1024)  # bounds.h: filter_slack

    @staticmethod
    def determinant(points):
        x = [[Fraction(float.fromhex(c)) for c in p] for p in points]
        rows = [[c - c0 for c, c0 in zip(p, x[0])] for p in x[1:]]
        if len(x) == 3:
            (a, b), (c, d) = rows
            return a * d - b * c
        (a, b), (c, d), (e, f) = rows  # of b, p and q: p is outside of the circle through a, b and q
        s, t, u = a * a + b * b, c * c + d * d, e * e + f * f
        return -(a * (d * u - f * t) - b * (c * u - e * t) + s * (c * f - d * e))

    def test_the_page(self):
        self.sweep(SPEC, "out")
        page = (self.here / "out" / "sweep.html").read_text(encoding="utf-8")
        self.assertFalse(re.search(r"(?i)\b(nan|inf)\b", page.split("<script>")[0]))
        for heading in ("What was found", "Distributions in 2D", "Which arithmetic decides in 2D",
                        "Distributions in 3D", "Which arithmetic decides in 3D", "The sweep in numbers"):
            self.assertIn(f"<h2>{heading}</h2>", page)
        # The rows of each dimension, seven of them, from the first to the last, in seven styles.
        number = {d: [int(n) for n in re.findall(rf'<th scope="row">(\d+) &nbsp;[^<]*, {d}D, ', page)] for d in (2, 3)}
        shown = [[int(n) for n in some.split()] for some in re.findall(r"these are shown: ([\d ]+);", page)]
        self.assertEqual([len(some) for some in shown], [7, 7])
        for plot in re.findall(r'<svg class="plot".*?</svg>', page):
            styles = re.findall(r'class="curve ([^"]*)"', plot)
            self.assertEqual(len(styles), len(set(styles)))
        for d, some in zip((2, 3), shown):
            self.assertLess(set(some), set(number[d]))
            self.assertEqual([some[0], some[-1]], [number[d][0], number[d][-1]])
            self.assertIn(f"In {d}D none of ", page)
        # Curves are named by what differs: not by the dimension.
        names = re.findall(r'class="name c\d" x="[^"]*" y="[^"]*" dy=".34em">([^<]*)<', page)
        self.assertIn("jittered, 60, decimal:3", names)
        self.assertFalse([name for name in names if "3D" in name or len(name) > 24])
        # Whose name is long is called what no other has.
        self.assertFalse([name for name in names if name.startswith("row ")])
        # The filter decides all cells in 3D; the paper's tolerance is right in 2D.
        self.assertRegex(page, r"<figcaption>The filter decided all [\d,]+ cells. Of the certificates in a bin, ")
        self.assertEqual(page.count('aria-label="Cells by width"'), 1)
        self.assertEqual(page.count("The paper&#39;s tolerance is the exact one at all vertices"), 1)
        self.assertEqual(page.count('aria-label="The paper&#39;s tolerance over the exact one"'), 1)
        self.assertIn("<dt>Bi-cell</dt><dd>Two triangles that share an edge (2D) or tetrahedra that", page)
        # Curves of ratios begin at 1 or below, and not at the upper edge of the bin of 1.
        ratios = page.split('aria-label="The paper&#39;s tolerance over the exact one"')[1].split("</svg>")[0]
        tick = float(re.search(r'class="tl m" x="([\d.]+)"[^>]*>1<', ratios)[1])
        for curve in re.findall(r'class="curve [^"]*" d="M([\d.]+) ', ratios):
            self.assertLessEqual(float(curve), tick + 0.2)


if __name__ == "__main__":
    tool.main(__doc__)
