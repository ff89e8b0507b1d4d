#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus nodt --mesh`: valid and faulty tetrahedral meshes from files, and the results.

usage: test_tetrahedra.py --tool=PATH [CLASS[.METHOD]...]; ANNULUS_MUTANTS=N and ANNULUS_TEST_SEED=N for more and other
       mutants
"""

import os
import random
import unittest
from collections import Counter
from itertools import combinations, permutations, product

import tool

try:
    import meshio
except ImportError:
    meshio = None

FOUR = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


def volume(a, b, c, d):
    u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def blocks(cubes, size=(1, 1, 1)):
    """Cubes of a lattice, six tetrahedra each, all along the same diagonal: they fit."""
    numbers, cells = {}, []
    for cube in cubes:
        for order in permutations(range(3)):
            at, corners = list(cube), [tuple(cube)]
            for k in order:
                at[k] += 1
                corners.append(tuple(at))
            cell = [numbers.setdefault(c, len(numbers)) for c in corners]
            if volume(*corners) < 0:
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(tuple(cell))
    return [tuple(s * x for s, x in zip(size, p)) for p in numbers], cells


def box(n, m, k):
    return list(product(range(n), range(m), range(k)))


def medit(points, cells, head="MeshVersionFormatted 2\nDimension 3\n"):
    return (head + f"Vertices\n{len(points)}\n" + "".join(" ".join(map(repr, p)) + " 0\n" for p in points)
            + f"Tetrahedra\n{len(cells)}\n" + "".join(" ".join(str(v + 1) for v in c) + " 7\n" for c in cells)
            + "End\n")


def read(path):
    words = path.read_text(encoding="utf-8").split()

    def section(name, columns, number):
        if name not in words:
            return []
        at = words.index(name) + 1
        rows = (words[at + 1 + columns * i:at + columns * (i + 1)] for i in range(int(words[at])))
        return [tuple(map(number, r)) for r in rows]
    return (section("Vertices", 4, float), [tuple(i - 1 for i in t) for t in section("Triangles", 4, int)],
            [tuple(i - 1 for i in c) for c in section("Tetrahedra", 5, int)])


class Tetrahedra(tool.ToolTest):
    def nodt(self, points, cells, *more, iterations=10):
        self.write("a.mesh", medit(points, cells))
        return self.succeed("nodt", "--mesh", "a.mesh", "--iterations", iterations, "--audit", 1, "--output", "out",
                            *more)

    def check(self, euler=None):
        """Checks that domain.mesh is a mesh with its boundary, and V - E + F of the boundary. Returns its contents."""
        points, triangles, cells = read(self.here / "out" / "domain.mesh")
        self.assertEqual({v for c in cells for v in c}, set(range(len(points))))
        self.assertLessEqual(set(points), set(read(self.here / "out" / "final.mesh")[0]))
        facets = Counter(tuple(sorted(f)) for c in cells for f in combinations(c, 3))
        self.assertLessEqual(max(facets.values()), 2)
        self.assertEqual(sorted(tuple(sorted(t)) for t in triangles), sorted(f for f, n in facets.items() if n == 1))
        sides = Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
        self.assertTrue(all(n == sides[b, a] for (a, b), n in sides.items()), "not closed")
        inner = (0, 0, 0)
        self.assertAlmostEqual(sum(volume(inner, *(points[v] for v in t)) for t in triangles) /
                               sum(volume(*(points[v] for v in c)) for c in cells), 1, places=9)
        if euler is not None:
            self.assertEqual(len({v for t in triangles for v in t}) - len(sides) // 2 + len(triangles), euler)
        if meshio is not None:  # another reader
            mesh = meshio.read(self.here / "out" / "domain.mesh")
            self.assertEqual([tuple(map(float, p)) for p in mesh.points], points)
            self.assertEqual([tuple(map(int, c)) for c in mesh.cells_dict["tetra"]], cells)
            self.assertEqual([tuple(map(int, t)) for t in mesh.cells_dict["triangle"]], triangles)
        self.assertEqual(self.summary("out")["audit"]["failed"], 0)
        return points, triangles, cells

    def volume(self):
        points, _, cells = read(self.here / "out" / "domain.mesh")
        return sum(volume(*(points[v] for v in c)) for c in cells)

    def test_shapes(self):
        ring = [c for c in box(7, 7, 3) if not (2 <= c[0] <= 4 and 2 <= c[1] <= 4)]
        for name, cubes, euler in (("cube", box(4, 4, 4), 2), ("torus", ring, 0),
                                   ("two", box(3, 3, 3) + [(x + 9, y, z) for x, y, z in box(3, 3, 3)], 4),
                                   ("cavity", [c for c in box(5, 5, 5) if c != (2, 2, 2)], 4)):
            with self.subTest(name):
                points, cells = blocks(cubes)
                self.nodt(points, cells, "--sharp", 40, "--force")
                self.check(euler)
                self.assertEqual(self.summary("out")["vertices"], len(points))
                self.assertGreater(self.volume() / len(cubes), 0.97)
                self.assertLess(self.volume() / len(cubes), 1 + 1e-9)

    def test_sharp(self):
        points, cells = blocks(box(4, 4, 4), (1.0, 1.25, 0.75))
        top = (4.0, 5.0, 3.0)
        bits = random.Random(1)
        sides = [[k for k in range(3) if p[k] in (0, top[k])] for p in points]
        points = [tuple(x if k in s or len(s) == 0 else x + bits.uniform(-0.2, 0.2) for k, x in enumerate(p))
                  for p, s in zip(points, sides)]
        on = [(i, s) for i, s in enumerate(sides) if len(s) > 1]
        for more, kept in (((), False), (("--sharp", 89), True), (("--sharp", 91), False)):
            with self.subTest(more=more):
                self.nodt(points, cells, *more, "--force", iterations=40)
                after = read(self.here / "out" / "final.mesh")[0]
                gone = [i for i, s in on if any(after[i][k] != points[i][k] for k in s)]
                self.assertEqual(gone == [], kept)
                if kept:
                    self.assertTrue(any(after[i] != points[i] for i, s in on), "nothing moves along an edge")
                    self.assertLessEqual({p for p in product(*((0, t) for t in top))}, set(after))
                    self.check(2)
                    self.assertIn("Sharp edges are kept: 12 curves, 8 corners",
                                  (self.here / "out" / "report.html").read_text(encoding="utf-8"))

    def test_sharp_surface(self):
        self.write("box.off", "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for x in (0, 2) for y in (0, 1) for z in (0, 1))
                   +
                   "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n")
        self.succeed("nodt", "--surface", "box.off", "--vertices", 400, "--sharp", 30, "--iterations", 30, "--audit",
                     10, "--output", "out")
        points, _, _ = self.check(2)
        self.assertLessEqual(set(product((0, 2), (0, 1), (0, 1))), set(points))
        self.assertGreater(sum(sum(x in (0, t) for x, t in zip(p, (2, 1, 1))) == 2 for p in points), 24)
        self.assertGreater(self.volume(), 1.98)

    def test_thin(self):
        points, cells = blocks(box(8, 8, 1), (1, 1, 0.1))  # circumcentres are inside all the same
        self.nodt(points, cells, "--sharp", 40)
        self.check()

    def test_one_tetrahedron(self):
        self.nodt([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 2, 1, 3)])
        points, _, cells = self.check(2)
        self.assertEqual((len(points), len(cells)), (4, 1))
        # No Delaunay cell whose circumcentre is inside.
        self.write("b.mesh", medit(FOUR[:3] + [(0.3, 0.3, 0.1)], [(0, 1, 2, 3)]))
        self.assertIn("b.mesh: no Delaunay cell of its vertices", self.refuse(3, "nodt", "--mesh", "b.mesh"))

    def test_again(self):
        """nodt reads its own output; the vertices keep their order."""
        self.succeed("nodt", "--sphere", "--vertices", 300, "--iterations", 20, "--output", "first")
        self.succeed("nodt", "--mesh", "first/domain.mesh", "--iterations", 0, "--output", "out")
        self.assertEqual(read(self.here / "first" / "domain.mesh")[0], read(self.here / "out" / "final.mesh")[0])
        points, triangles, _ = self.check(2)
        self.assertEqual({v for t in triangles for v in t},
                         {v for t in read(self.here / "first" / "domain.mesh")[1] for v in t})
        self.succeed("compare", "--strategies", "rebuild,auto", "--", "nodt", "--mesh", "first/domain.mesh",
                     "--iterations", 3)
        self.succeed("audit", "first/final.mesh")
        self.assertGreater(len(points), 250)

    def test_usage(self):
        self.write("a.mesh", medit(FOUR, [(0, 1, 2, 3)]))
        for words in (["--mesh", "a.mesh", "--vertices", 100], ["--mesh", "a.mesh", "--sphere"],
                      ["--mesh", "a.mesh", "--surface", "a.off"], ["--mesh", "a.mesh", "--allow-crossing"],
                      ["--sphere", "--vertices", 100, "--sharp", 30],
                      *(["--mesh", "a.mesh", "--sharp", x] for x in (0, 180, -1, "nan", "inf", "x")),
                      *(["--mesh", "a.mesh", "--lock", x] for x in ("nan", "inf")),
                      *(["--mesh", "a.mesh", "--sizing", "graded", "--gradation", x]
                        for x in ("nan", "-nan", "inf", -1))):
            self.refuse(2, "nodt", *words)

    def test_faults(self):
        good = medit(FOUR + [(1, 1, 1)], [(0, 1, 2, 3), (1, 2, 3, 4)])
        for content, message in (
            (good.replace("Dimension 3", "Dimension 2"), r":5: has 4 columns"),
            (good.replace("2 3 4 5 7", "3 2 4 5 7"), r":13: a tetrahedron is inverted against that at line 12"),
            (good.replace("1 1 1 0", "0.5 0.5 0 0"), r":13: "),
            (good.replace("1 2 3 4 7\n", "1 2 3 4 7\n1 2 3 4 7\n"), r":1[234]: "),
            (good.replace("Tetrahedra\n2", "Tetrahedra\n1").replace("2 3 4 5 7\n", "").replace("1 2 3 4 7",
                                                                                               "1 2 3 x 7"), r":12: "),
            (good.replace("1 0 0 0", "1 0 nan 0"), r":6: "),
            (good.replace("1 0 0 0", "1e200 0 0 0"), r"a\.mesh: its longest side"),
            (good[:100], r"a\.mesh:\d+: "), ("\x01\x00", r"a\.mesh:1: begins with"),
        ):
            self.write("a.mesh", content)
            self.assertRegex(self.refuse(3, "nodt", "--mesh", "a.mesh"), message)
        inner = [tuple(0.1 + 0.1 * x for x in p) for p in FOUR]
        self.write("a.mesh", medit(FOUR + inner, [(0, 1, 2, 3), (4, 5, 6, 7)]))
        self.assertIn("a.mesh:16: a tetrahedron lies within another part", self.refuse(3, "nodt", "--mesh", "a.mesh"))
        self.refuse(3, "nodt", "--mesh", "missing.mesh")

    def test_mutants(self):
        """Moved and merged vertices, cells dropped, turned, repeated, joined to others: a mesh or one line with the
        file's name."""
        seed = tool.SEED
        statuses = Counter()
        for i in range(int(os.environ.get("ANNULUS_MUTANTS", "40"))):
            with self.subTest(seed=seed, mutant=i):
                bits = random.Random(f"{seed} {i}")
                points, cells = blocks(bits.choice((box(1, 1, 1), box(2, 1, 1), box(3, 2, 2))), (1.0, 1.0, 1.0))
                for _ in range(bits.randint(1, 3)):
                    p, c, k, kind = (bits.randrange(len(points)), bits.randrange(len(cells)), bits.randrange(3),
                                     bits.randrange(7))
                    if kind < 3:
                        moved = list(points[p])
                        moved[k] = bits.choice((moved[k] + bits.choice((-1, 1)) * 10 ** bits.uniform(-17, 0.3), 1e-320,
                                                1e-160, -0.0, 1e9))
                        points[p] = tuple(moved)
                    elif kind == 3:
                        points[p] = bits.choice(points)
                    elif kind == 4 and len(cells) > 1:
                        del cells[c]
                    elif kind == 5:
                        cells[c] = tuple(bits.sample(cells[c], 4))
                    else:
                        cells.append(tuple(bits.sample(range(len(points)), 4)))
                self.write("a.mesh", medit(points, cells))
                more = ["--sharp", 40] if i % 2 else []
                done = self.run_tool("nodt", "--mesh", "a.mesh", "--iterations", 3, "--audit", 1, *more)
                statuses[done.returncode] += 1
                if done.returncode == 0:
                    self.assertEqual(done.stderr, "")
                else:
                    self.assertEqual((done.returncode, done.stdout), (3, ""), done.stderr)
                    self.assertRegex(done.stderr, r"\Aannulus: a\.mesh[^\n]+\n\Z")
        self.assertGreater(min(statuses[0], statuses[3]), 0, "all alike")


if __name__ == "__main__":
    tool.main(__doc__)
