# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of `annulus nodt`, a reader of what it writes, and a check of the mesh."""

import csv
import os
import unittest
from collections import Counter
from itertools import combinations

import tool

FILES = {"summary.json", "iterations.csv", "dihedral.csv", "quality.csv", "final.mesh", "domain.mesh", "final.vtu",
         "domain.vtu", "report.html"}

# The meshes of the paper take half a minute each where the tool is instrumented.
SHORT = unittest.skipIf(float(os.environ.get("ANNULUS_TEST_MULTIPLIER", "1")) < 1, "a short run of the tests")

CUBE = "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for x in (0, 2) for y in (0, 1) for z in (0, 1)) + \
    "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n"


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def volume(a, b, c, d):
    return dot(minus(b, a), cross(minus(c, a), minus(d, a))) / 6


class NodtTest(tool.ToolTest):
    def nodt(self, *words, out="out"):
        done = self.succeed("nodt", *words, "--output", out)
        more = {f"domain.{f.rstrip('2')}" for w in words for f in str(w).split(",") if f in ("msh", "msh22", "vtk")}
        self.assertEqual({p.name for p in (self.here / out).iterdir()}, FILES | more)
        return done

    def tetrahedra(self, name, out="out"):
        words = (self.here / out / name).read_text(encoding="utf-8").split()
        at = words.index("Vertices")
        count = int(words[at + 1])
        points = [tuple(map(float, words[at + 2 + 4 * i:at + 5 + 4 * i])) for i in range(count)]
        at = words.index("Tetrahedra")
        cells = [tuple(int(w) - 1 for w in words[at + 2 + 5 * i:at + 6 + 5 * i]) for i in range(int(words[at + 1]))]
        return points, cells

    def part(self):
        """Points, tetrahedra and triangles of domain.mesh."""
        points, cells = self.tetrahedra("domain.mesh")
        words = (self.here / "out" / "domain.mesh").read_text(encoding="utf-8").split()
        at = words.index("Triangles")
        return points, cells, [tuple(int(w) - 1 for w in words[at + 2 + 4 * i:at + 5 + 4 * i])
                               for i in range(int(words[at + 1]))]

    def rows(self, name="iterations.csv"):
        with open(self.here / "out" / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def check_mesh(self, exact_volume, relative):
        """The domain's cells fill the domain, meet facet to facet, and are cells of the whole triangulation."""
        points, cells = self.tetrahedra("domain.mesh")
        everything = self.tetrahedra("final.mesh")
        number = {p: i for i, p in enumerate(everything[0])}  # some vertices are in no cell of the domain
        self.assertLessEqual({tuple(number[points[i]] for i in c) for c in cells}, set(everything[1]))
        self.assertEqual(sorted(points, key=number.get), points)
        for c in everything[1]:
            self.assertGreater(volume(*(everything[0][i] for i in c)), 0)
        self.assertLess(abs(sum(volume(*(points[i] for i in c)) for c in cells) / exact_volume - 1), relative)
        facets = Counter(tuple(sorted(f)) for c in cells for f in combinations(c, 3))
        self.assertEqual(set(facets.values()) - {1, 2}, set())
        edges = Counter(e for f, n in facets.items() if n == 1 for e in combinations(f, 2))
        self.assertTrue(all(n % 2 == 0 for n in edges.values()), "the surface of the mesh is not closed")
