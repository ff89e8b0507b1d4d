#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus compare` in periodic boxes. usage: test_boxed_compare.py --tool=PATH [CLASS[.METHOD]...]"""

import json
import random

import boxed
import tool

STRATEGIES = ("tolerances", "signs", "auto", "rebuild")


class BoxedCompare(boxed.BoxedTest):
    def compare(self, *inner, strategies=STRATEGIES):
        done = self.succeed("compare", "--strategies", ",".join(strategies), "--output", "out", "--", *inner,
                            "--audit", 1)
        found = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
        self.assertTrue(found["agree"])
        self.assertIn("all strategies agree\n", done.stdout)
        self.assertEqual(list(found["strategies"]), list(strategies))
        return found

    def test_a_recorded_motion(self):
        """In a box that is sheared, of points that come and go, 2D and 3D."""
        for d in (2, 3):
            motion, boxes = [], []
            for f in range(6):
                dice = random.Random(tool.SEED)
                points = {i: [dice.random() + 1e-4 * f * (i % 3) for _ in range(d)] for i in range(60)}
                if f == 3:
                    del points[7]
                motion.append(points)
                boxes.append([[1 if i == j else 0 for j in range(d)] for i in range(d)])
                boxes[-1][-1][0] = f / 512
            self.lattice_xyz("a.xyz", motion, boxes)
            found = self.compare("replay", "a.xyz")
            self.assertEqual(found["box"], boxes[-1])
            for name, run in found["strategies"].items():
                self.assertEqual(run["audit"], {"checked": 5, "failed": 0})
                self.assertEqual(run["moves"]["asked"], 299)
                # Where points appear or disappear every strategy builds.
                self.assertEqual(run["moves"]["rebuilt"], 299 if name == "rebuild" else 119)
            rows = {name: self.table("out", f"iterations-{name}.csv") for name in STRATEGIES}
            for column in ("displacement_mean", "displacement_max", "asked"):
                for name in STRATEGIES:
                    self.assertEqual([row[column] for row in rows[name]], [row[column] for row in rows["rebuild"]])
            self.assertGreater(sum(int(row["within_tolerance"]) for row in rows["tolerances"]), 0)
            self.assertEqual(sum(int(row["within_tolerance"]) for row in rows["signs"]), 0)
            page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
            for words in ("Cumulative time of each strategy", "periodic box from", "with images at the sides of the box"
                          if d == 2 else "Lattice and pbc"):
                self.assertIn(words, page)

    def test_lloyd_iterations(self):
        for box, d in (("2,1", 2), ("1,0,0,0.25,1,0,0,0,1", 3)):
            found = self.compare("lloyd", "--points", 80, "--box", box, "--iterations", 6, "--seed", 4)
            self.succeed("lloyd", "--points", 80, "--box", box, "--iterations", 6, "--seed", 4, "--output", "alone")
            rows, alone = self.table("out", "iterations-rebuild.csv"), self.table("alone", "iterations.csv")
            for column in ("displacement_mean", "displacement_max"):
                self.assertEqual([row[column] for row in rows], [row[column] for row in alone])
            for run in found["strategies"].values():
                self.assertEqual((run["dimension"], run["vertices"], run["moves"]["asked"]), (d, 80, 480))
                self.assertEqual(run["box"], self.summary("alone")["box"])

    def test_which_strategies_there_are(self):
        self.lattice_xyz("a.xyz", [{1: [0.5, 0.5], 2: [0.25, 0.5], 3: [0, 0]}] * 2, [[[1, 0], [0, 1]]] * 2)
        self.write("open.csv", "frame,id,x,y\n0,1,0.1,0.2\n0,2,0.7,0.6\n0,3,0.5,0.1\n")
        lloyd = ("lloyd", "--points", 20, "--iterations", 1)
        for inner in (("replay", "a.xyz"), ("replay", "open.csv", "--box", "1,1"), (*lloyd, "--box", "1,1")):
            self.succeed("compare", "--output", "out", "--", *inner)
            found = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
            self.assertEqual(list(found["strategies"]), ["rebuild", "signs", "auto"])
            for names, what in (("auto,relocate", "are auto, rebuild, signs and tolerances, not relocate"),
                                ("paper:floating", "in a periodic box tolerances are certified, not floating")):
                self.assertIn(what, self.refuse(2, "compare", "--strategies", names, "--", *inner))
        for inner in (("replay", "a.xyz", "--open"), ("replay", "open.csv"), lloyd):
            self.succeed("compare", "--output", "out", "--", *inner)
            found = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
            self.assertEqual(list(found["strategies"]), ["rebuild", "relocate", "auto"])
            self.assertIn("the strategy signs is for periodic boxes",
                          self.refuse(2, "compare", "--strategies", "signs", "--", *inner))

    def test_what_cannot_be_taken_is_refused(self):
        square = [[1, 0], [0, 1]]
        self.lattice_xyz("a.xyz", [{1: [0.5, 0.5], 2: [0.25, 0.5]}, {1: [0.5, 0.5], 2: [1.5, 0.5]}], [square] * 2)
        self.assertIn("a.xyz:7: in frame 1 the points of ids 1, 2 are at one place of the periodic box",
                      self.refuse(3, "compare", "--", "replay", "a.xyz"))
        self.compare("replay", "a.xyz", "--coincident", "merge", strategies=("auto", "rebuild", "signs"))
        self.assertIn("--open and --box exclude each other",
                      self.refuse(2, "compare", "--", "replay", "a.xyz", "--box", "1,1", "--open"))
        lloyd = ("compare", "--", "lloyd", "--points", 20, "--box")
        self.assertIn("the density is one", self.refuse(2, *lloyd, "1,1", "--density", "x2"))
        self.assertIn("'x' is not a number", self.refuse(2, *lloyd, "1,x"))
        self.lattice_xyz("none.xyz", [{}, {1: [0.5, 0.5]}, {}], [square] * 3)
        self.compare("replay", "none.xyz", strategies=("auto", "rebuild"))


if __name__ == "__main__":
    tool.main(__doc__)
