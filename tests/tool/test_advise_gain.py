#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `annulus advise` expects and counts, and docs/when.md. usage: test_advise_gain.py --tool=PATH
[CLASS[.METHOD]...]"""

import math
import random
import re
from pathlib import Path

import tool
from advised import AdviseTest

ROOT = Path(__file__).resolve().parents[2]


def results_rows(text):
    """The rows of bench/RESULTS.md by the heading they are under, as lists of cells."""
    rows, heading = [], ""
    for line in text.splitlines():
        if line.startswith("#"):
            heading = line
        elif line.startswith("| "):
            rows.append((heading, [cell.strip() for cell in line.strip("|").split("|")]))
    return rows


class Gain(AdviseTest):
    def test_the_table_is_that_of_the_benchmarks(self):
        walks = {2: [], 3: []}
        for heading, cells in results_rows((ROOT / "bench" / "RESULTS.md").read_text(encoding="utf-8")):
            if heading.startswith("## Random walk") and cells[0].startswith("s = "):
                walks[3 if "3D" in heading else 2].append([float(cells[0][4:]), float(cells[3])])
        for d in (2, 3):
            self.succeed("generate", "walk", "--points", 300, "--dim", d, "--steps", 2, "--pace", 1e-3, "--output",
                         f"w{d}.xyz")
            found = self.advise(f"w{d}.xyz")["expected"]
            self.assertEqual(found["table"], walks[d])
            self.assertAlmostEqual(found["gain_over_cgal"] / walks[d][-1][1], found["gain"])
            # A walk with that deviation of each coordinate has the root of d times as much, in spacings of its box.
            self.assertAlmostEqual(found["s"], 1e-3 * math.sqrt(d), delta=2e-4)
            between = [ratio for s, ratio in walks[d] if s in (0.001, 0.003)]
            self.assertGreaterEqual(found["gain_over_cgal"], min(between))
            self.assertLessEqual(found["gain_over_cgal"], max(between))

    def test_the_page_on_what_gains(self):
        """docs/when.md: its numbers are those of bench/RESULTS.md."""
        results = results_rows((ROOT / "bench" / "RESULTS.md").read_text(encoding="utf-8"))
        walks = {(3 if "3D" in h else 2, cells[0][4:]): float(cells[3]) for h, cells in results
                 if h.startswith("## Random walk") and cells[0].startswith("s = ")}
        checked = 0
        for heading, cells in results_rows((ROOT / "docs" / "when.md").read_text(encoding="utf-8")):
            if re.fullmatch(r"[\d.e-]+", cells[0]):
                for k, d in ((1, 2), (3, 3)):
                    ratio = walks[d, cells[0]]
                    for cell, value in ((cells[k], ratio), (cells[k + 1], ratio / walks[d, "1"])):
                        self.assertAlmostEqual(float(cell) / value, 1, delta=0.05, msg=cells)
                        checked += 1
            elif heading.startswith("## Where") and cells[0] not in ("row", "---"):
                rows = [other for _, other in results if other[0] == cells[0] and cells[2] in other[1:5]]
                self.assertTrue(rows, cells)
                self.assertTrue(cells[1] in rows[0] or cells[0].endswith(f"= {cells[1]}"), cells)
                checked += 1
        self.assertGreater(checked, 40)

    def test_advice_by_displacement(self):
        for d in (2, 3):
            for pace, strategies, reason in ((0.002, {"auto", "tolerances"}, "gain"), (1, {"rebuild"}, "far apart")):
                with self.subTest(d=d, pace=pace):
                    self.succeed("generate", "walk", "--points", 1500, "--dim", d, "--steps", 15, "--pace", pace,
                                 "--output", "w.xyz", "--force")
                    found = self.advise("w.xyz")
                    self.assertIn(found["advice"]["strategy"], strategies)
                    self.assertEqual(found["advice"]["reason"], reason)
                    cost = found["measured"]["cost_in_rebuilds"]["auto"]
                    self.assertAlmostEqual(found["measured"]["gain"], 1 / cost)
                    self.assertEqual(found["measured"]["steps"], 14)  # all but the first
                    moves = found["measured"]["moves"]
                    self.assertEqual(moves["asked"], 1500 * 14)
                    self.assertEqual(moves["asked"], sum(n for k, n in moves.items() if k != "asked"))
                    if reason == "gain":
                        self.assertLess(cost, 0.4)
                        self.assertEqual(found["advice"]["times_as_often"], 1)
                    else:
                        self.assertGreater(cost, 0.9)
                        self.assertLess(cost, 2)
                        k = found["advice"]["times_as_often"]
                        self.assertIn(f"written {k} times as often", found["advice"]["sentence"])
                        # At this factor the table has a gain of three.
                        slow = [s for s, ratio in found["expected"]["table"]
                                if ratio >= 3 * found["expected"]["table"][-1][1]]
                        self.assertGreaterEqual(found["expected"]["s"] / (k - 1), slow[-1])
                        self.assertLess(found["expected"]["s"] / k, 5 * slow[-1])
        self.assertEqual(self.advise("w.xyz", "--steps", 0)["advice"]["reason"], "far apart")

    def test_a_lattice(self):
        """Ulps of noise on a lattice in 3D: certificates change all the time, at whatever displacement."""
        dice = random.Random(5)
        frames = [{i: [c + 1e-15 * dice.random() for c in (i % 7, i // 7 % 7, i // 49)] for i in range(343)}
                  for _ in range(8)]
        found = self.advise(self.motion("a.csv", frames))
        self.assertGreater(found["degeneracy"]["below"]["1e-9"], found["degeneracy"]["bicells"] / 20)
        self.assertGreater(found["degeneracy"]["arithmetic"]["exact"], 0)
        self.assertEqual((found["advice"]["strategy"], found["advice"]["reason"]), ("rebuild", "degenerate"))

    def test_points_that_come_and_go(self):
        dice = random.Random(9)
        frames = [{1000 * f + i: (dice.random(), dice.random()) for i in range(300)} for f in range(4)]
        warning = r"annulus: a\.csv:1: no id is in two frames in a row: [^\n]*\n\Z"
        found = self.advise(self.motion("a.csv", frames), warning=warning)
        self.assertEqual((found["displacement"], found["expected"]["gain"]), (None, None))
        self.assertEqual((found["advice"]["strategy"], found["advice"]["reason"]), ("rebuild", "traffic"))
        self.assertEqual(self.advise("a.csv", "--steps", 0, warning=warning)["advice"]["reason"], "traffic")

    def test_one_step(self):
        """auto rebuilds it, whatever it is, so that its cost says nothing."""
        for d in (2, 3):
            self.succeed("generate", "walk", "--points", 2000, "--dim", d, "--steps", 1, "--pace", 1e-4, "--output",
                         f"w{d}.xyz")
            found = self.advise(f"w{d}.xyz")
            self.assertEqual((found["measured"]["steps"], found["advice"]["reason"]), (1, "gain"))

    def test_steps_bound_what_is_followed(self):
        self.succeed("generate", "walk", "--points", 50, "--steps", 120, "--output", "w.xyz")
        self.assertEqual(self.advise("w.xyz")["measured"]["steps"], 100)
        found = self.advise("w.xyz", "--steps", 7)
        self.assertEqual((found["measured"]["steps"], found["measured"]["moves"]["asked"]), (7, 350))
        self.assertEqual(found["displacement"]["total"], 120 * 50)
        self.assertIsNone(self.advise("w.xyz", "--steps", 0)["measured"])

    def test_the_same_whatever_the_machine_does(self):
        self.succeed("generate", "walk", "--points", 3000, "--dim", 3, "--steps", 5, "--output", "w.xyz")
        found = []
        for threads in (1, 3):
            found.append(self.advise("w.xyz", "--threads", threads))
            del found[-1]["seconds"], found[-1]["command"]
        self.assertEqual(*found)


if __name__ == "__main__":
    tool.main(__doc__)
