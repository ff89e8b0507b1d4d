#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus lloyd`, and `annulus compare` with it. usage: test_lloyd.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import json
import math
import statistics

import tool
from tool import GRID, STRATEGIES, SUMMARY, SUMMARY_PLAIN, ToolTest


class Domains(ToolTest):
    def run_in(self, *words):
        self.succeed("lloyd", "--points", "80", "--iterations", "5", "--audit", "1", "--output", "out", "--quiet",
                     *words)
        self.assertEqual(self.summary("out")["audit"], {"checked": 5, "failed": 0})
        return self.mesh("out")[0]

    def test_disc(self):
        for radius in (1.0, 0.25, 3e10):
            points = self.run_in("--domain", "disc", "--radius", radius)
            self.assertTrue(all(math.hypot(*p) <= radius * (1 + 1e-12) for p in points))

    def test_square(self):
        for half in (1.0, 7.5):
            points = self.run_in("--domain", "square", "--radius", half)
            self.assertTrue(all(max(map(abs, p)) <= half * (1 + 1e-12) for p in points))

    CORNERS = [(0, 0), (4, 0), (5, 2), (2, 4), (0, 3)]

    def test_polygon_either_way_round(self):
        results = []
        for corners in (self.CORNERS, self.CORNERS[::-1]):
            self.xyz("polygon.xyz", corners)
            points = self.run_in("--domain", "polygon.xyz")
            self.assertEqual(len(points), 80)
            for (ax, ay), (bx, by) in zip(self.CORNERS, self.CORNERS[1:] + self.CORNERS[:1]):
                for x, y in points:
                    self.assertGreaterEqual((bx - ax) * (y - ay) - (by - ay) * (x - ax), -1e-10)
            results.append(points)
        self.assertEqual(*results)

    def test_a_closed_ring_is_the_open_one(self):
        """GeoJSON, WKT and shapefiles repeat the first corner at the end; other corners may be repeated or lie on
        edges."""
        c = self.CORNERS
        half = [(2, 0)]
        rings = {"open": c, "closed": c + c[:1], "twice": c[:1] + c + 2 * c[:1], "clockwise": (c + c[:1])[::-1],
                 "turned": c[2:] + c[:3], "doubled": [p for p in c for _ in range(2)] + c[:1],
                 "flat": half + c[1:] + c[:1] + half, "within": c[:1] + half + c[1:] + c[:1]}
        files = set()
        for name, ring in rings.items():
            self.xyz("ring.xyz", ring)
            self.run_in("--domain", "ring.xyz")
            files.add((self.here / "out" / "final.mesh").read_bytes())
            self.assertEqual(len(files), 1, name)
        # A point in the part that a lost corner would remove.
        self.xyz("square.xyz", [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
        self.xyz("points.xyz", [(0.1, 0.1), (0.2, 0.1), (0.1, 0.3), (0.9, 0.8), (0, 0), (1, 1)])
        self.succeed("lloyd", "--input", "points.xyz", "--domain", "square.xyz", "--iterations", "3", "--audit", "1",
                     "--quiet")
        self.xyz("outside.xyz", [(0.1, 0.1), (0.2, 0.1), (1.1, 0.3)])
        self.assertIn("outside.xyz:3: point outside the domain",
                      self.refuse(3, "lloyd", "--input", "outside.xyz", "--domain", "square.xyz", "--iterations", "3"))

    def test_what_is_wrong_with_a_polygon_is_said_by_line(self):
        for corners, line, words in (([(0, 0), (1, 0), (1, 0.5), (2, 0.5), (1, 0.5), (1, 1), (0, 1)], 2,
                                      "line 4: edges of a polygon must meet at their common corners only"),
                                     (4 * [(0, 0)], 1, "all its 4 are at one place"),
                                     (4 * [(1, 2)], 1, "all its 4 are at one place"),
                                     ([(0, 0), (1, 1), (2, 2), (0, 0)], 1, "all its 4 are on one line"),
                                     ([(0, 0), (1e101, 0), (0, 1)], 1, "between 1e-100 and 1e100"),
                                     ([(0, 0), (1, 1), (0, 0)], 1, "different ones here: 2")):
            with self.subTest(corners=corners):
                said = self.refuse(3, "lloyd", "--points", "50", "--domain", self.xyz("bad.xyz", corners))
                self.assertIn(f"bad.xyz:{line}: ", said)
                self.assertIn(words, said)

    def test_polygon_that_is_none(self):
        for name, corners in (("bow.xyz", [(0, 0), (2, 2), (2, 0), (0, 2)]),
                              ("star.xyz", [(math.cos(4 * math.pi * k / 5), math.sin(4 * math.pi * k / 5))
                                            for k in range(5)]),
                              ("line.xyz", [(0, 0), (1, 1), (2, 2)]),
                              ("two.xyz", [(0, 0), (1, 1)])):
            with self.subTest(name=name):
                self.xyz(name, corners)
                line = self.refuse(3, "lloyd", "--points", "50", "--domain", name, "--output", "out")
                self.assertIn(name, line)
        self.refuse(3, "lloyd", "--points", "50", "--domain", "missing.xyz", "--output", "out")

    def test_densities(self):
        meshes = set()
        for density in ("one", "x2+y2", "x2", "sin2"):
            self.run_in("--density", density)
            meshes.add((self.here / "out" / "final.mesh").read_bytes())
        self.assertEqual(len(meshes), 4)

    def test_hull_of_the_input(self):
        self.xyz("grid.xyz", GRID)
        self.succeed("lloyd", "--input", "grid.xyz", "--iterations", "5", "--audit", "1", "--output", "out", "--quiet")
        self.assertTrue(all(-1e-9 <= c <= 5 + 1e-9 for p in self.mesh("out")[0] for c in p))


class Reproducible(ToolTest):
    def final(self, *words):
        self.succeed("lloyd", "--points", "300", "--iterations", "12", "--output", "out", "--quiet", *words)
        return (self.here / "out" / "final.mesh").read_bytes()

    def test_seed(self):
        self.assertEqual(self.final("--seed", "5"), self.final("--seed", "5"))
        self.assertNotEqual(self.final("--seed", "5"), self.final("--seed", "6"))
        self.assertEqual(self.final(), self.final("--seed", "1"))

    def test_threads(self):
        for density in ("one", "sin2"):
            one = self.final("--threads", "1", "--density", density)
            for threads in (2, 3, 8):
                self.assertEqual(one, self.final("--threads", threads, "--density", density))

    def test_every_strategy_reaches_the_same_points(self):
        results = {}
        for strategy in STRATEGIES:
            self.final("--strategy", strategy)
            results[strategy] = sorted(self.mesh("out")[0])
        for strategy in STRATEGIES[1:]:
            with self.subTest(strategy=strategy):
                for p, q in zip(results["rebuild"], results[strategy]):
                    self.assertLess(math.dist(p, q), 1e-9)

    def test_counters(self):
        counts = []
        for _ in range(2):
            self.final()
            summary = self.summary("out")
            counts.append((summary["moves"], summary["arithmetic"]))
        self.assertEqual(counts[0], counts[1])


class Strategies(ToolTest):
    def compare(self, strategies, *inner):
        self.succeed("compare", "--strategies", ",".join(strategies), "--output", "out", "--quiet", "--", "lloyd",
                     *inner)
        result = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
        self.assertIs(result["agree"], True)
        self.assertEqual(list(result["strategies"]), strategies)
        for name in strategies:
            self.assertLessEqual(SUMMARY_PLAIN | set(SUMMARY), set(result["strategies"][name]))
            self.assertEqual(result["strategies"][name]["audit"]["failed"], 0)
        self.assertEqual(set(result["ratios"]), {f"{a}/{b}" for a in strategies for b in strategies if a != b})
        for pair, ratio in result["ratios"].items():
            a, b = (result["strategies"][n]["seconds"]["triangulation"] for n in pair.split("/"))
            self.assertAlmostEqual(ratio, a / b, delta=1e-9 * ratio)
        median = {}
        for name in strategies:
            with open(self.here / "out" / f"iterations-{name.replace(':', '-')}.csv", encoding="utf-8",
                      newline="") as file:
                median[name] = statistics.median(float(row["seconds_triangulation"]) for row in csv.DictReader(file))
        self.assertEqual(set(result["ratios_of_medians"]), set(result["ratios"]))
        for pair, ratio in result["ratios_of_medians"].items():
            a, b = pair.split("/")
            self.assertAlmostEqual(ratio, median[a] / median[b], delta=1e-6 * ratio)
        return result

    def test_all_agree(self):
        self.compare(STRATEGIES, "--points", "200", "--iterations", "15", "--audit", "1")

    def test_all_agree_on_a_grid(self):
        self.xyz("grid.xyz", GRID)
        self.compare(STRATEGIES, "--input", "grid.xyz", "--iterations", "6", "--audit", "1")

    def test_all_agree_on_a_line(self):
        self.xyz("line.xyz", [(i, 2 * i) for i in range(6)])
        self.compare(STRATEGIES, "--input", "line.xyz", "--iterations", "3", "--audit", "1")

    def test_three_points(self):
        self.compare(STRATEGIES, "--points", "3", "--iterations", "6", "--audit", "1")

    def test_variants(self):
        result = self.compare(["tolerances", "tolerances:certified", "paper:floating", "tolerances-each"],
                              "--points", "200", "--iterations", "15")
        self.assertEqual(result["strategies"]["paper:floating"]["tolerance"], "floating")

    def test_default_strategies_and_files(self):
        self.succeed("compare", "--output", "out", "--", "lloyd", "--points", "60", "--iterations", "3")
        self.assertEqual({p.name for p in (self.here / "out").iterdir()},
                         {"compare.json", "report.html", "iterations-rebuild.csv", "iterations-relocate.csv",
                          "iterations-auto.csv"})

    def test_tolerances_pass_more_as_the_motion_dies_down(self):
        self.succeed("lloyd", "--points", "300", "--iterations", "150", "--output", "out", "--quiet")
        with open(self.here / "out" / "iterations.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(int(rows[-1]["within_tolerance"]), int(rows[0]["within_tolerance"]))

    def test_the_arithmetic_is_reported(self):
        # A grid is degenerate everywhere: the exact stage has to decide.
        self.xyz("grid.xyz", GRID)
        self.succeed("lloyd", "--input", "grid.xyz", "--iterations", "0", "--output", "out", "--quiet")
        self.assertGreater(self.summary("out")["arithmetic"]["exact"], 0)


if __name__ == "__main__":
    tool.main(__doc__)
