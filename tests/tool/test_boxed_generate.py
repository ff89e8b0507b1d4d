#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus generate --box`, whose files `replay` reads back. usage: test_boxed_generate.py --tool=PATH
[CLASS[.METHOD]...]"""

import math
import re

import boxed
import frames
import tool

POINTS = ["uniform", "grid", "jittered", "cospherical", "clusters", "surface"]
MOTIONS = ["walk", "shear", "orbit"]
BOXES = {"2,1": [[2, 0], [0, 1]], "1,0,0.5,2": [[1, 0], [0.5, 2]], "2,1,1.5": [[2, 0, 0], [0, 1, 0], [0, 0, 1.5]],
         "1,0.1,0,0.3,1,0,0.2,0.1,-1.5": [[1, 0.1, 0], [0.3, 1, 0], [0.2, 0.1, -1.5]]}
# Of a crystal: points of a unit cell, neighbours whose facets are not empty.
CRYSTALS = {"square": (1, 4), "triangular": (2, 6), "sc": (1, 6), "bcc": (2, 14), "fcc": (4, 12), "diamond": (8, 16)}


def frames_of(text):
    """The frames of extended XYZ: the vectors of the box, those that are periodic, and the points in order."""
    lines = text.splitlines()
    found = []
    at = 0
    while at < len(lines):
        n = int(lines[at])
        box = [float(c) for c in re.search(r'Lattice="([^"]*)"', lines[at + 1])[1].split()]
        pbc = re.search(r'pbc="([^"]*)"', lines[at + 1])[1]
        d = pbc.count("T")
        rows = [line.split() for line in lines[at + 2:at + 2 + n]]
        assert [int(r[0]) for r in rows] == list(range(n))
        found.append(([box[3 * k:3 * k + d] for k in range(d)], [tuple(map(float, r[1:])) for r in rows]))
        at += 2 + n
    return found


def shares(point, box):
    """By Cramer's rule."""
    whole = frames.determinant(box)
    return [frames.determinant([*box[:k], list(point), *box[k + 1:]]) / whole for k in range(len(box))]


def thickness(box):
    """The least distance of opposite sides."""
    if len(box) == 2:
        return abs(frames.determinant(box)) / max(math.hypot(*v) for v in box)
    sides = ([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
             for a, b in ((box[0], box[1]), (box[1], box[2]), (box[2], box[0])))
    return abs(frames.determinant(box)) / max(math.hypot(*side) for side in sides)


class BoxedGenerate(boxed.BoxedTest):
    def generated(self, *words):
        return frames_of(self.succeed("generate", *words).stdout)

    def test_families(self):
        for words, box in BOXES.items():
            d = len(box)
            middle = [sum(v[k] for v in box) / 2 for k in range(d)]
            for kind in POINTS:
                with self.subTest(kind=kind, box=words):
                    [(said, points)] = self.generated(kind, "-n", 250, "--box", words)
                    self.assertEqual(said, box)
                    self.assertEqual((len(set(points)), {len(p) for p in points}), (250, {d}))
                    inside = [shares(p, box) for p in points]
                    if kind != "clusters":
                        self.assertTrue(all(-1e-12 < s < 1 + 1e-12 for p in inside for s in p))
                    away = [math.dist(p, middle) / (thickness(box) / 4) for p in points]
                    if kind == "cospherical":
                        self.assertLess(max(abs(a - 1) for a in away), 1e-14)
                    if kind == "surface":
                        self.assertTrue(0.5 < min(away) < 0.85 and 0.95 < max(away) < 1 + 1e-14)
                    if kind == "uniform":
                        for k in range(d):  # a standard deviation is 0.018
                            self.assertAlmostEqual(sum(p[k] for p in inside) / 250, 0.5, delta=0.1)
                    if kind == "grid":
                        self.assertEqual(len({round(p[0], 9) for p in inside}), math.ceil(250 ** (1 / d)))

    def test_what_is_written_is_read_in_its_box(self):
        for name in ("a.xyz", "a.lammpstrj", "a.xyz.gz"):
            for words, box in BOXES.items():
                with self.subTest(name=name, box=words):
                    call = ("walk", "-n", 40, "--steps", 3, "--box", words)
                    self.succeed("generate", *call, "--output", name, "--force")
                    self.succeed("replay", name, "--audit", 1, "--every", 1, "--output", "out", "--quiet", "--force")
                    summary = self.summary("out")
                    self.assertEqual((summary["box"], summary["vertices"], summary["iterations"], summary["audit"]),
                                     (box, 40, 3, {"checked": 3, "failed": 0}))
                    expected = self.generated(*call)
                    for frame in range(4):
                        values = tool.vtu_values(self.here / "out" / f"frame-{frame:06}.vtu", "Points")
                        points = [values[3 * i:3 * i + len(box)] for i in range(40)]
                        for p, q in zip(points, expected[frame][1]):  # up to vectors of the box
                            for s in shares([a - b for a, b in zip(p, q)], box):
                                self.assertAlmostEqual(s, round(s), delta=1e-13)

    def test_perfect_crystals(self):
        for kind, (of_cell, neighbours) in CRYSTALS.items():
            d = 2 if of_cell <= 2 and kind in ("square", "triangular") else 3
            box = [2, 4 * math.sqrt(3)] if kind == "triangular" else [2, 4] if d == 2 else [2, 4, 2]
            along = [2, 4] if d == 2 else [2, 4, 2]
            with self.subTest(kind=kind):
                n = of_cell * math.prod(along)
                self.succeed("generate", kind, "-n", n, "--box", ",".join(map(repr, box)), "--output", "a.xyz",
                             "--force")
                [(_, points)] = frames_of((self.here / "a.xyz").read_text(encoding="utf-8"))
                self.assertEqual(len(set(points)), n)
                self.assertTrue(all(0 <= c < side for p in points for c, side in zip(p, box)))
                # Every point has the neighbours that crystallography counts, all cells the same volume.
                self.succeed("replay", "a.xyz", "--neighbors", "--voronoi", "--audit", 1, "--output", "out", "--force")
                count = dict.fromkeys(range(n), 0)
                for (i, j, _), size in self.pairs()[0].items():
                    if size > 1e-9:
                        count[i] += 1
                        count[j] += 1
                self.assertEqual(set(count.values()), {neighbours})
                for volume, _ in self.voronoi()[0].values():
                    self.assertAlmostEqual(volume, math.prod(box) / n, delta=1e-12)

    def test_vibration(self):
        words = ("bcc", "-n", 2000, "--box", "10,10,10")
        perfect, still = self.generated(*words)[0][1], self.generated(*words, "--vibration", 0)[0][1]
        self.assertEqual(perfect, still)
        moved = self.generated(*words, "--vibration", 0.1)[0][1]
        away = [q[k] - p[k] for p, q in zip(perfect, moved) for k in range(3)]
        spacing = 0.5 ** (1 / 3)
        deviation = math.sqrt(sum(a * a for a in away) / len(away))
        self.assertAlmostEqual(deviation / spacing, 0.1, delta=0.005)  # five standard deviations are 0.0045
        self.assertAlmostEqual(sum(away) / len(away), 0, delta=0.005)
        self.assertLess(max(map(abs, away)), 0.36 * spacing)

    def test_motions(self):
        for kind in MOTIONS:
            for start, n in (("uniform", 108), ("clusters", 108), ("fcc", 108)):
                with self.subTest(kind=kind, start=start):
                    words = ("--box", "3,3,3", "-n", n)
                    film = self.generated(kind, "--from", start, *words, "--steps", 4, "--pace", 0.1)
                    self.assertEqual(len(film), 5)
                    self.assertEqual(film[0], self.generated(start, *words)[0])
                    for (_, a), (_, b) in zip(film, film[1:]):
                        ways = [math.dist(p, q) for p, q in zip(a, b)]
                        self.assertGreater(max(ways), 0.01)
                        self.assertLess(max(ways), 0.6)
                        if kind == "orbit":  # 0.1 of the spacing, 0.63
                            self.assertTrue(all(abs(w - 0.063) < 0.002 for w in ways))
                    if kind != "shear":
                        self.assertEqual([box for box, _ in film], 5 * [film[0][0]])

    def test_a_shear_takes_the_box_along(self):
        for words in ("3,3,3", "3,0.5,1,3"):
            with self.subTest(box=words):
                d = 3 if words == "3,3,3" else 2
                call = ("shear", "-n", 64, "--box", words, "--steps", 100, "--pace", 0.2)
                film = self.generated(*call)
                start = film[0][0]
                strain = 0.2 * 64 ** (-1 / d)
                for (a, x), (b, y) in zip(film, film[1:]):
                    for p, q in zip(x, y):
                        self.assertLess(abs(q[0] - p[0] - strain * p[1]), 1e-12)
                        self.assertEqual(q[1:], p[1:])
                    # The lattice is that of the sheared vectors, in short ones.
                    self.assertAlmostEqual(frames.determinant(b), frames.determinant(start), delta=1e-9)
                    for v in a:
                        for s in shares([v[0] + strain * v[1], *v[1:]], b):
                            self.assertAlmostEqual(s, round(s), delta=1e-9)
                    for i, v in enumerate(b):
                        for k, w in enumerate(b):
                            if i != k:
                                product = sum(c * e for c, e in zip(v, w))
                                self.assertLess(abs(product), 0.501 * sum(c * c for c in w))
                self.assertGreater(len({tuple(map(tuple, b)) for b, _ in film}), 15)
                for name in ("a.xyz", "a.lammpstrj"):
                    self.succeed("generate", *call, "--output", name, "--force")
                    self.succeed("replay", name, "--audit", 1, "--output", "out", "--force")
                    self.assertEqual(self.summary("out")["audit"], {"checked": 100, "failed": 0})
                    self.assertEqual(self.summary("out")["box"], film[-1][0])

    def test_uniform_points_are_those_of_lloyd(self):
        [(_, points)] = self.generated("uniform", "-n", 30, "--box", "2,1", "--seed", 7)
        self.succeed("lloyd", "--points", 30, "--box", "2,1", "--seed", 7, "--iterations", 1, "--every", 1, "--output",
                     "out")
        values = tool.vtu_values(self.here / "out" / "frame-000000.vtu", "Points")
        for i, p in enumerate(points):
            self.assertLess(math.dist(p, values[3 * i:3 * i + 2]), 1e-14)

    def test_the_same_seed_gives_the_same_bytes(self):
        for words in (("walk", "-n", 50, "--steps", 3, "--box", "1,1,1"),
                      ("bcc", "-n", 16, "--vibration", 0.1, "--box", "2,2,2")):
            self.assertEqual(self.generated(*words), self.generated(*words, "--threads", 2))
            self.assertNotEqual(self.generated(*words), self.generated(*words, "--seed", 2))

    def test_what_is_refused(self):
        for words, said in (
                (("fcc", "-n", 32), "fcc is a crystal, which fills a periodic box: --box LIST"),
                (("walk", "--from", "sc", "-n", 8), "sc is a crystal, which fills a periodic box"),
                (("fcc", "-n", 32, "--box", "2,2"), "fcc is a crystal in 3D, and --box is in 2D"),
                (("square", "-n", 8, "--box", "2,2,2"), "square is a crystal in 2D, and --box is in 3D"),
                (("fcc", "-n", 50, "--box", "2,2,2"), "fill this box with edges as equal as can be with 32 or 108"),
                (("diamond", "-n", 3, "--box", "2,2,2"), "fill this box with edges as equal as can be with 8"),
                (("sc", "-n", 9, "--box", "1,1,1"), "1 point each, fill this box with edges as equal as can be with 8"),
                (("uniform", "-n", 5, "--box", "1,1", "--dim", 3), "--dim 3, and --box is in 2D"),
                (("uniform", "-n", 5, "--box", "1"), "--box has 1 number, and a box has 2 or 4 in 2D, 3 or 9 in 3D"),
                (("uniform", "-n", 5, "--box", "1,x"), "'x' is not a number"),
                (("uniform", "-n", 5, "--box", "1,1,2,2"), "--box: the vectors of the box"),
                (("uniform", "-n", 5, "--box", "1,1", "--vibration", 0.1), "--vibration is for crystals"),
                (("square", "-n", 4, "--box", "1,1", "--vibration", "nan"), "--vibration is not a number from 0"),
                (("square", "-n", 4, "--box", "1,1", "--vibration", -1), "--vibration is not a number from 0"),
                (("square", "-n", 4, "--box", "1,1", "--steps", 3), "--steps is for motions"),
                (("uniform", "-n", 5, "--box", "1,1", "--output", "a.csv"), "a table has no place for a periodic box"),
                (("uniform", "-n", 5, "--box", "1,1", "--format", "csv"), "a table has no place for a periodic box")):
            with self.subTest(words=words):
                self.assertIn(said, self.refuse(2, "generate", *words))
        for n in (32, 108):
            self.succeed("generate", "fcc", "-n", n, "--box", "2,2,2", "--dim", 3)


if __name__ == "__main__":
    tool.main(__doc__)
