#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus lloyd` in boxes and with --keep-boundary, beside rational arithmetic. usage: test_borders.py --tool=PATH
[CLASS[.METHOD]...]"""

import random
from fractions import Fraction

import tool
from domains import RINGS, DomainTest, centroid_2, centroid_3


class Borders(DomainTest):
    def column(self, name):
        return [row[name] for row in self.table("out", "iterations.csv")]

    def kept(self, points, *words):
        """The points after some iterations with --keep-boundary."""
        self.xyz("a.xyz", points)
        self.succeed("lloyd", "--input", "a.xyz", "--keep-boundary", "--iterations", 200, "--audit", 20, "--output",
                     "out", "--force", "--quiet", *words)
        self.assertEqual(self.summary("out")["audit"], {"checked": 10, "failed": 0})
        return self.mesh("out")[0]

    def test_points_on_the_border_of_a_square_spread_along_it(self):
        dice = random.Random(tool.SEED)
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        below = [(dice.random() / 3, 0) for _ in range(3)]
        right = [(1, dice.random()) for _ in range(2)]
        inner = [(0.1 + 0.8 * dice.random(), 0.1 + 0.8 * dice.random()) for _ in range(12)]
        found = self.kept(corners + below + right + inner)
        self.assertEqual(found[:4], corners)
        self.assertTrue(all(y == 0 for _, y in found[4:7]) and all(x == 1 for x, _ in found[7:9]))
        self.assertTrue(all(0 < x < 1 and 0 < y < 1 for x, y in found[9:]))
        xs = [0, *sorted(x for x, _ in found[4:7]), 1]
        self.assertGreater(min(b - a for a, b in zip(xs, xs[1:])), 0.15)
        # Without the option they leave it.
        self.succeed("lloyd", "--input", "a.xyz", "--iterations", 1, "--output", "out", "--force", "--quiet")
        self.assertTrue(all(0 < x < 1 and 0 < y < 1 for x, y in self.mesh("out")[0]))

    def test_a_step_along_an_edge_is_the_projection_of_the_centroid(self):
        self.rings("l.xyz", RINGS)
        points = [(0, 0), (2, 0), (4, 1), (0.25, 0.75), (1.5, 3), (0.75, 1), (0.125, 2.5), (3, 0.5), (1.25, 0.25)]
        self.xyz("a.xyz", points)
        found = self.after_a_step(9, 2, "--domain", "l.xyz", "--keep-boundary")
        sites = [[Fraction(c) for c in p] for p in points]
        edge = {1: 1, 2: 0, 3: 0, 4: 0}  # vertex and the coordinate that stays
        for v in (0, 5, 8):
            self.assertEqual(tuple(found[v]), points[v])
        for v in (1, 2, 3, 4, 6, 7):
            _, centroid = centroid_2(RINGS, sites, v)
            if v not in edge:
                self.assert_near(found[v], centroid, 1e-13)
                continue
            k = edge[v]
            self.assertEqual(found[v][k], points[v][k])
            low, high = {1: (0, 4), 2: (0, Fraction(3, 2)), 3: (Fraction(1, 4), Fraction(5, 4)),
                         4: (Fraction(3, 2), 4)}[v]
            at = sites[v][1 - k]
            self.assert_near([found[v][1 - k]], [min(max(centroid[1 - k], (at + low) / 2), (at + high) / 2)], 1e-13)

    def test_slanted_edges(self):
        self.rings("triangle.xyz", [[(0, 0), (3, 1), (1, 2)]])
        found = self.kept([(0.6, 0.2), (1.5, 0.5), (2, 1.5), (0.5, 1), (1.2, 0.9), (1.4, 1.2)], "--domain",
                          "triangle.xyz")
        for (x, y), (a, b) in zip(found, ((-1, 3), (-1, 3), (1, 2), (-2, 1))):
            self.assertAlmostEqual(a * x + b * y, 5 if a == 1 else 0, delta=1e-14)

    def test_what_is_refused_or_told(self):
        self.xyz("a.xyz", [(0.1, 0.1), (0.2, 0.3), (0.3, 0.1)])
        done = self.succeed("lloyd", "--input", "a.xyz", "--domain", "square", "--keep-boundary", "--iterations", 1)
        self.assertIn("no point is on the boundary", done.stderr)
        for words in (("--input", "a.xyz", "--domain", "disc"), ("--points", 9), ("--input", "a.xyz", "--box", "1,1")):
            self.refuse(2, "lloyd", "--keep-boundary", *words)


class Boxes(DomainTest):
    def test_centroids_in_a_box(self):
        dice = random.Random(tool.SEED)
        for n, size, lower, upper in ((1, "2,1,3", (0, 0, 0), (2, 1, 3)), (9, "2,1,3", (0, 0, 0), (2, 1, 3)),
                                      (2, "-1,0,1,0.5,2,4", (-1, 0, 1), (0.5, 2, 4))):
            with self.subTest(n=n):
                points = [[a + dice.random() * (b - a) for a, b in zip(lower, upper)] for _ in range(n)]
                self.xyz("a.xyz", points)
                found = self.after_a_step(n, 3, "--domain", "box", "--size", size)
                sites = [[Fraction(c) for c in p] for p in points]
                volume = 0
                for v in range(n):
                    mass, centroid = centroid_3(lower, upper, sites, v)
                    volume += mass
                    self.assert_near(found[v], centroid, 1e-12)
                self.assertEqual(volume, Fraction(upper[0] - lower[0]) * Fraction(upper[1] - lower[1])
                                 * Fraction(upper[2] - lower[2]))

    def test_a_rectangle(self):
        for size, ring in (("2,1", [(0, 0), (2, 0), (2, 1), (0, 1)]), ("-1,2,3,4", [(-1, 2), (3, 2), (3, 4), (-1, 4)])):
            self.rings("ring.xyz", [ring])
            for name, words in (("box", ("box", "--size", size)), ("file", ("ring.xyz",))):
                self.succeed("lloyd", "--points", 50, "--iterations", 5, "--output", name, "--force", "--quiet",
                             "--domain", *words)
            self.assertEqual(*((self.here / name / "final.mesh").read_bytes() for name in ("box", "file")))

    def test_a_lattice_rests_and_points_stay_in_the_box(self):
        self.xyz("a.xyz", [(x + 0.5, y + 0.5, z + 0.5) for x in range(3) for y in range(2) for z in range(2)])
        self.succeed("lloyd", "--input", "a.xyz", "--domain", "box", "--size", "3,2,2", "--iterations", 3, "--audit", 1,
                     "--output", "out", "--quiet")
        for row in self.table("out", "iterations.csv"):
            self.assertLess(float(row["displacement_max"]), 1e-14)
        files = set()
        for k, words in enumerate(((), ("--threads", 2), ("--strategy", "rebuild"), ("--strategy", "relocate"))):
            self.succeed("lloyd", "--points", 300, "--domain", "box", "--size", "1,1,2", "--iterations", 12, "--audit",
                         3, "--output", f"out{k}", "--quiet", *words)
            self.assertEqual(self.summary(f"out{k}")["audit"], {"checked": 4, "failed": 0})
            values = tool.vtu_values(self.here / f"out{k}" / "final.vtu", "Points")
            points = [values[i:i + 3] for i in range(0, len(values), 3)]
            self.assertEqual(len(points), 300)
            self.assertTrue(all(0 < x < 1 and 0 < y < 1 and 0 < z < 2 for x, y, z in points))
            files.add(tuple(points))
        self.assertEqual(len(files), 1)

    def test_what_there_is_not(self):
        self.xyz("a.xyz", [(0, 0, 0), (1, 1, 1), (0, 1, 2)])
        solid = ("lloyd", "--points", 9, "--domain", "box", "--size", "1,1,1")
        for words, part in (((*solid, "--density", "x2"), "density is one"), ((*solid, "--radius", 2), "--radius"),
                            (("lloyd", "--points", 9, "--size", "1,1"), "--size is for --domain box"),
                            (("lloyd", "--points", 9, "--domain", "box"), "needs its lengths"),
                            (("lloyd", "--points", 9, "--domain", "box", "--size", "1,1,1,1,1"), "5 numbers"),
                            (("lloyd", "--points", 9, "--domain", "box", "--size", "1,x"), "'x' is not a number"),
                            (("lloyd", "--points", 9, "--domain", "box", "--size", "1,0,1"), "1e-100"),
                            (("lloyd", "--points", 9, "--box", "1,1,1", "--size", "1,1,1"), "--size"),
                            (("compare", "--", *solid), "3D"), (solid[:1] + solid[3:], "how many points")):
            with self.subTest(words=words):
                self.assertIn(part, self.refuse(2, *words))
        self.assertIn("a.xyz:3: point outside the domain",
                      self.refuse(3, "lloyd", "--input", "a.xyz", "--domain", "box", "--size", "1,1,1.5"))


if __name__ == "__main__":
    tool.main(__doc__)
