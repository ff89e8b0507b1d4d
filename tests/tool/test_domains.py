#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus lloyd` in polygons with holes, beside rational arithmetic. usage: test_domains.py --tool=PATH
[CLASS[.METHOD]...]"""

import random
from fractions import Fraction

import tool
from domains import RINGS, DomainTest, bisectors, centroid_2, in_rings


class Polygons(DomainTest):
    def sites(self, n, rings=None):
        dice, points = random.Random(tool.SEED), []
        while len(points) < n:
            p = (dice.random() * 4, dice.random() * 4)
            if in_rings(rings or RINGS, p):
                points.append(p)
        self.xyz("a.xyz", points)
        return [[Fraction(c) for c in p] for p in points]

    def test_centroids_in_an_l_with_a_hole(self):
        self.rings("l.xyz", RINGS)
        exact = 0
        for n in (3, 12, 40):
            sites = self.sites(n)
            found = self.after_a_step(n, 2, "--domain", "l.xyz")
            area = 0
            for v in range(n):
                mass, centroid = centroid_2(RINGS, sites, v)
                area += mass
                if in_rings(RINGS, centroid):
                    exact += 1
                    self.assert_near(found[v], centroid, 1e-13)
                else:  # the nearest point of the cell, a little inwards
                    self.assertTrue(in_rings(RINGS, found[v]))
                    self.assertTrue(all(height(list(map(Fraction, found[v]))) <= 0 for height in bisectors(sites, v)))
                    way = sum((Fraction(a) - b) ** 2 for a, b in zip(found[v], centroid))
                    self.assertLess(way, sum((a - b) ** 2 for a, b in zip(sites[v], centroid)))
            self.assertEqual(area, Fraction(71, 8))
        self.assertGreater(exact, 20)

    def test_a_centroid_in_the_hole_becomes_the_nearest_point(self):
        ring = [[(-2, -2), (2, -2), (2, 2), (-2, 2)], [(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5)]]
        self.rings("ring.xyz", ring)
        sites = [(1.75, 0), (-1.75, 0.5), (-1.75, -0.5)]  # the first has about the right half
        self.xyz("a.xyz", sites)
        found = self.after_a_step(3, 2, "--domain", "ring.xyz")
        for p in found:
            self.assertGreater(max(map(abs, p)), 1.5)
        _, centroid = centroid_2(ring, [[Fraction(c) for c in p] for p in sites], 0)
        self.assertLess(centroid[0], 1.5)
        self.assert_near(found[0], [1.5, centroid[1]], 4e-3)

    def test_rings_in_any_order_and_direction(self):
        closed = [ring + ring[:1] for ring in RINGS]
        files = {"open": self.rings("open.xyz", RINGS), "closed": self.rings("closed.xyz", closed),
                 "reversed": self.rings("reversed.xyz", [ring[::-1] for ring in closed[::-1]]),
                 "turned": self.rings("turned.xyz", [ring[2:] + ring[:2] for ring in RINGS]),
                 "far": self.rings("far.xyz", RINGS, "\n  \n\t\n# a hole\n"),
                 "table": self.write("table.csv", "\n".join("".join(f"{x!r},{y!r}\n" for x, y in r) for r in RINGS))}
        found = set()
        for name, file in files.items():
            self.succeed("lloyd", "--points", 60, "--domain", file, "--iterations", 6, "--audit", 1, "--output", name,
                         "--quiet")
            found.add((self.here / name / "final.mesh").read_bytes())
            self.assertEqual(len(found), 1, name)
            self.assertEqual(self.summary(name)["audit"], {"checked": 6, "failed": 0})

    def test_a_comment_begins_no_ring(self):
        dent = [(0, 0), (2, 0), (1, 0.5), (2, 2), (0, 2)]
        self.rings("dent.xyz", [dent])
        self.rings("said.xyz", [dent[:2], dent[2:]], "# the dent\n")
        for name in ("dent", "said"):
            self.succeed("lloyd", "--points", 40, "--domain", f"{name}.xyz", "--iterations", 4, "--output", name,
                         "--quiet")
        self.assertEqual(*((self.here / name / "final.mesh").read_bytes() for name in ("dent", "said")))

    def test_points_stay_in_the_domain(self):
        self.rings("l.xyz", RINGS)
        for words in ([], ["--density", "x2"], ["--density", "sin2"], ["--threads", 3], ["--strategy", "rebuild"]):
            self.succeed("lloyd", "--points", 200, "--domain", "l.xyz", "--iterations", 15, "--audit", 5, "--output",
                         "out", "--force", "--quiet", *words)
            points = self.mesh("out")[0]
            self.assertEqual(len(points), 200)
            self.assertTrue(all(in_rings(RINGS, p) for p in points))
        self.succeed("compare", "--strategies", "rebuild,auto", "--", "lloyd", "--points", 50, "--domain", "l.xyz",
                     "--iterations", 3)

    def test_rings_that_meet_are_refused_by_line(self):
        square = [(0, 0), (4, 0), (4, 4), (0, 4)]
        for rings, line, words in (([[(0, 0), (2, 2), (2, 0), (0, 2)]], 1, "line 3: .* corners 0 and 2"),
                                   ([square, [(1, 1), (5, 1), (1, 2)]], 2, "line 6: .* corners 1 and 4"),
                                   ([square, [(1, 1), (2, 1), (0, 2)]], 4, "line 7: .* corners 3 and 5"),
                                   ([square, [(1, 1), (3, 1), (2, 1), (2, 2)]], 6, "line 7: .* corners 4 and 5"),
                                   ([square, [(1, 1), (2, 2), (3, 3)]], 6, "all its 3 are on one line"),
                                   ([square, [(1, 1), (2, 2)]], 6, "different ones here: 2")):
            with self.subTest(rings=rings):
                said = self.refuse(3, "lloyd", "--points", 50, "--domain", self.rings("bad.xyz", rings))
                self.assertIn(f"bad.xyz:{line}: ", said)
                self.assertRegex(said, words)

    def test_points_in_a_hole_are_refused(self):
        self.rings("l.xyz", RINGS)
        self.xyz("a.xyz", [(0.1, 0.1), (3, 1), (0.4, 1.1), (0.75, 0.6)])
        self.assertIn("a.xyz:3: point outside the domain",
                      self.refuse(3, "lloyd", "--input", "a.xyz", "--domain", "l.xyz", "--iterations", 1))


if __name__ == "__main__":
    tool.main(__doc__)
