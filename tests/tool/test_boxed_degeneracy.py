#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus degeneracy` in periodic boxes: of files and of --box. usage: test_boxed_degeneracy.py --tool=PATH
[CLASS[.METHOD]...]"""

import csv
import gzip
import json
import xml.etree.ElementTree

import boxed
import tool

THRESHOLDS = ["1e-3", "1e-6", "1e-9", "1e-12", "ulp"]


class BoxedDegeneracy(boxed.BoxedTest):
    def study(self, *words):
        done = self.succeed("degeneracy", *words, "--output", "out", "--quiet", "--force")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, {"degeneracy.json", "degeneracy.html"})
        page = self.page()
        for svg in page.split("<svg")[1:]:
            xml.etree.ElementTree.fromstring("<svg" + svg.split("</svg>")[0] + "</svg>")
        for words in ("hull", "paper"):
            self.assertNotIn(words, page.split("</h1>")[1].replace("there is no hull", ""))
        self.assertIn("periodic box from", page)
        return json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))

    def page(self):
        return (self.here / "out" / "degeneracy.html").read_text(encoding="utf-8")

    def test_perfect_crystals_are_degenerate(self):
        """By Euler's formula, with what the Voronoi cells of the crystals have of facets: in 3D all facets of the
        triangulation are degenerate but those between two holes of the lattice."""
        # Of a point: the facets of all triangulations that its holes' sides have in common.
        for kind, n, box, sides in (("square", 16, "4,4", 2), ("sc", 27, "3,3,3", 6), ("fcc", 32, "2,2,2", 8),
                                    ("bcc", 16, "2,2,2", 12)):
            with self.subTest(kind=kind):
                self.succeed("generate", kind, "-n", n, "--box", box, "--output", "a.xyz", "--force")
                result = self.study("a.xyz")
                d = len(box.split(","))
                facets = result["simplices"] * (d + 1) // 2
                self.assertEqual(result["bicells"]["total"], facets)
                if kind != "bcc":  # its tetrahedra are all alike, with a sphere each
                    self.assertEqual(result["bicells"]["zero"], facets - sides * n)
                else:
                    self.assertEqual((result["bicells"]["zero"], facets), (0, sides * n))
                self.assertEqual((result["cells"]["total"], result["cells"]["zero"]), (result["simplices"], 0))
                self.assertEqual(result["tolerance"]["total"], n)
                self.assertEqual(result["tolerance"]["zero"], 0 if kind == "bcc" else n)
                self.assertIn("exactly degenerate", self.page())

    def test_a_vibration_removes_what_is_exact(self):
        words = ("generate", "fcc", "-n", 256, "--box", "4,4,4", "--output", "a.xyz", "--force")
        self.succeed(*words, "--vibration", 1e-7)
        found = self.study("a.xyz")["bicells"]
        self.assertEqual((found["zero"], found["below"]["1e-9"]), (0, found["below"]["1e-9"]))
        self.succeed(*words)
        exact = self.study("a.xyz")["bicells"]["zero"]
        self.assertGreater(found["below"]["1e-6"], exact / 2)
        self.succeed(*words, "--vibration", 0.1)
        found = self.study("a.xyz")["bicells"]
        self.assertLess(found["below"]["1e-6"], 10)

    def test_sums_and_what_there_is_not(self):
        self.succeed("generate", "uniform", "-n", 300, "--box", "2,1,0.5", "--output", "a.xyz")
        result = self.study("a.xyz")
        self.assertEqual([t["name"] for t in result["thresholds"]], THRESHOLDS)
        self.assertEqual(result["box"], [[2, 0, 0], [0, 1, 0], [0, 0, 0.5]])
        self.assertAlmostEqual(result["mean_spacing"], 300 ** (-1 / 3), delta=1e-12)
        self.assertEqual(result["resolution"], 2.0 ** -47)  # the extent is 2, and 4 the power of two above it
        self.assertIsNone(result["ridges"])
        self.assertEqual(set(result["tolerance"]), {"total", "zero", "below", "certified"})
        self.assertEqual(result["bicells"]["total"], 2 * result["cells"]["total"])
        for part in (result["bicells"], result["cells"]):
            self.assertEqual(sum(part["arithmetic"].values()), part["total"])
            histogram = part["width"]["histogram"]
            self.assertEqual(sum(histogram["counts"]) + histogram["underflow"] + histogram["overflow"], part["total"])
        done = self.succeed("degeneracy", "a.xyz")
        self.assertIn("box            Lattice and pbc: 2 0 0, 0 1 0, 0 0 0.5\n", done.stdout)
        self.assertIn("periodic       no hull ridges; the paper's tolerances are not computed\n", done.stdout)
        self.assertNotIn("unsound", done.stdout)

    def test_where_the_box_comes_from(self):
        self.succeed("generate", "jittered", "-n", 60, "--box", "1,0.25,0,2", "--output", "a.xyz")
        lines = (self.here / "a.xyz").read_text(encoding="utf-8").splitlines()[2:]
        self.xyz("plain.xyz", [tuple(map(float, line.split()[1:])) for line in lines])
        self.succeed("generate", "jittered", "-n", 60, "--box", "1,0.25,0,2", "--output", "a.lammpstrj")
        results = [self.study("a.xyz"), self.study("a.lammpstrj"), self.study("plain.xyz", "--box", "1,0.25,0,2"),
                   self.study("a.xyz", "--box", "1,0.25,0,2", "--threads", 2), self.study("a.xyz", "--frame", 0),
                   # another basis of the same lattice
                   self.study("plain.xyz", "--box", "1,0.25,1,2.25")]
        for result in results[1:]:
            for key in ("bicells", "cells", "tolerance", "convexity"):
                for count in ("total", "zero", "below", "non_convex", "flat"):
                    self.assertEqual(result[key].get(count), results[0][key].get(count), (key, count))
        self.assertEqual([result["box"] for result in results], 5 * [[[1, 0.25], [0, 2]]] + [[[1, 0.25], [1, 2.25]]])
        # Without the box, or with a box that is not periodic, boundaries are open.
        self.assertIsNotNone(json.loads(self.open_json("a.xyz", "--open"))["ridges"])
        self.write("b.xyz", (self.here / "a.xyz").read_text(encoding="utf-8").replace("T T F", "F F F"))
        self.assertIsNotNone(json.loads(self.open_json("b.xyz"))["ridges"])

    def open_json(self, *words):
        self.succeed("degeneracy", *words, "--output", "open", "--quiet", "--force")
        return (self.here / "open" / "degeneracy.json").read_text(encoding="utf-8")

    def test_frames(self):
        self.succeed("generate", "shear", "--from", "sc", "-n", 64, "--box", "4,4,4", "--steps", 5, "--pace", 1,
                     "--output", "a.lammpstrj")  # by a quarter of a cell each
        done = self.succeed("degeneracy", "a.lammpstrj", "--every", 1, "--output", "out")
        self.assertIn("box            BOX BOUNDS", done.stdout)
        with open(self.here / "out" / "degeneracy.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["frame"]) for row in rows], list(range(6)))
        for row in rows:
            self.assertEqual({row[key] for key in row if key.startswith("paper")}, {""})
        # A quarter of a cell: prisms of rhombi, degenerate along the third axis only. Four of them: the lattice again.
        zero = [int(row["zero"]) for row in rows]
        self.assertEqual((zero[4], zero[1] < zero[0], zero[5]), (zero[0], True, zero[1]))
        self.assertNotIn("paper", self.page().lower().split("<h1")[1].split("</h1>")[1])
        self.assertEqual(self.study("a.lammpstrj", "--frame", 5)["bicells"]["zero"], zero[5])

    def test_one_point_and_none(self):
        result = self.study(self.write("one.csv", "x,y,z\n5,6,7\n"), "--box", "1,1,1")
        self.assertEqual((result["vertices"], result["simplices"]), (1, 6))
        self.write("two.xyz", '1\nLattice="1 0 0 0 1 0 0 0 1" Properties=id:I:1:pos:R:3\n1 0 0 0\n'
                   '0\nLattice="1 0 0 0 1 0 0 0 1" Properties=id:I:1:pos:R:3\n')
        self.succeed("degeneracy", "two.xyz", "--every", 1, "--output", "out")
        self.assertIn("has 0 points; expected one at least", self.refuse(3, "degeneracy", "two.xyz", "--frame", 1))

    def test_every_certificate(self):
        self.succeed("generate", "bcc", "-n", 16, "--box", "2,2,2", "--vibration", 0.1, "--output", "a.xyz")
        result = self.study("a.xyz", "--raw", "raw.csv.gz")
        with gzip.open(self.here / "raw.csv.gz", "rt", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        count = {kind: sum(row["kind"] == kind for row in rows) for kind in ("bicell", "cell", "ridge")}
        self.assertEqual(count, {"bicell": result["bicells"]["total"], "cell": result["cells"]["total"], "ridge": 0})
        least = min(float(row["tolerance"]) for row in rows)
        self.assertAlmostEqual(least / result["mean_spacing"], result["tolerance"]["certified"]["quantiles"]["0"],
                               delta=1e-12)

    def test_images_of_one_another_are_merged(self):
        """The point that comes first stands for them; certificates are named by it."""
        points = [(0.25, 0.5), (2.25, -0.5), (0.25, 0.5), (0.75, 0.625), (0.5, 0.125)]
        self.xyz("a.xyz", points)
        done = self.succeed("degeneracy", "a.xyz", "--box", "1,1", "--output", "out", "--raw", "raw.csv")
        self.assertEqual(done.stderr, "annulus: a.xyz: merged 2 duplicate points\n")
        found = json.loads((self.here / "out" / "degeneracy.json").read_text(encoding="utf-8"))
        self.assertEqual((found["points"], found["merged"], found["vertices"]), (5, 2, 3))
        with open(self.here / "raw.csv", newline="", encoding="utf-8") as file:
            named = {row[k] for row in csv.DictReader(file) for k in row if k.startswith("point") and row[k]}
        self.assertEqual(named, {"0", "3", "4"})
        self.xyz("b.xyz", points[:1] + points[3:])
        alone = self.study("b.xyz", "--box", "1,1")
        for key in ("bicells", "cells", "tolerance", "mean_spacing", "resolution"):
            self.assertEqual(found[key], alone[key])
        frame = "{}\nLattice=\"1 0 0 0 1 0 0 0 1\" Properties=id:I:1:pos:R:3\n"
        self.write("c.xyz", frame.format(3) + "7 0 0 0\n9 1 2 0\n8 .5 .25 0\n" + frame.format(1) + "9 0 0 0\n")
        self.assertIn("merged 1 duplicate point\n", self.succeed("degeneracy", "c.xyz", "--frame", 0).stderr)
        self.succeed("degeneracy", "c.xyz", "--every", 1, "--output", "out", "--force")
        with open(self.here / "out" / "degeneracy.csv", newline="", encoding="utf-8") as file:
            self.assertEqual([(row["points"], row["merged"]) for row in csv.DictReader(file)],
                             [("3", "1"), ("1", "0")])

    def test_what_is_refused(self):
        self.xyz("a.xyz", [(0, 0), (0.5, 0.25), (1e11, 1)])
        self.assertRegex(self.refuse(3, "degeneracy", "a.xyz", "--box", "1,1", "--output", "out", "--raw", "raw.csv"),
                         "a.xyz:3: .*; expected a point nearer to the box")
        self.write("b.xyz", '2\nLattice="1 0 0 0 1 0 0 0 1" Properties=id:I:1:pos:R:3\n7 0 0 0\n9 1e11 2 0\n')
        for words in ((), ("--frame", 0), ("--every", 1, "--quiet")):
            self.assertRegex(self.refuse(3, "degeneracy", "b.xyz", *words), r"b.xyz:[34]: .*a point nearer to the box")
        for words, said in ((["--box", "1,1", "--open"], "--open and --box exclude each other"),
                            (["--box", "1,x"], "'x' is not a number"),
                            (["--box", "1,1,1"], "--box has 3 numbers, and a box in 2D has 2 lengths or 4"),
                            (["--box", "1"], "--box has 1 number, and a box has 2 or 4 in 2D, 3 or 9 in 3D"),
                            (["--box", "1,1,2,2"], "--box: the vectors of the box")):
            self.assertIn(said, self.refuse(2, "degeneracy", "a.xyz", *words))
        self.write("c.xyz", '2\nLattice="9 0 0 0 9 0 0 0 9" pbc="T F T" Properties=pos:R:3\n0 0 0\n1 2 3\n')
        self.assertIn("c.xyz:2: Lattice and pbc: a box that is periodic in x and z only",
                      self.refuse(3, "degeneracy", "c.xyz"))
        self.succeed("degeneracy", "c.xyz", "--box", "9,9,9")


if __name__ == "__main__":
    tool.main(__doc__)
