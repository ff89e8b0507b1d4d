#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus nodt` on faulty surfaces: it terminates with a mesh or one line.

usage: test_surfaces.py --tool=PATH [CLASS[.METHOD]...]; ANNULUS_MUTANTS=N and ANNULUS_TEST_SEED=N for more and other
       mutants
"""

import os
import random
import resource
import subprocess

import tool
from tool import OPTIONS, ToolTest

# Corners and faces, counter-clockwise from outside.
TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
BOX = ([(x, y, z) for x in (0, 2) for y in (0, 1) for z in (0, 1)],
       [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
        (1, 5, 7), (1, 7, 3)])
# A prism over an L: not convex, with an inner ridge.
L_SHAPE = ([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))],
           [(0, 3, 1), (1, 3, 2), (0, 5, 3), (3, 5, 4), (6, 7, 9), (7, 8, 9), (6, 9, 11), (9, 10, 11)]
           + [f for i in range(6) for j in [(i + 1) % 6] for f in ((i, j, j + 6), (i, j + 6, i + 6))])


def off(points, faces):
    return (f"OFF\n{len(points)} {len(faces)} 0\n" + "".join(" ".join(map(repr, p)) + "\n" for p in points)
            + "".join(f"{len(f)} " + " ".join(map(str, f)) + "\n" for f in faces))


class Surfaces(ToolTest):
    def mesh(self, points, faces, *more, vertices=60):
        self.write("a.off", off(points, faces))
        words = ["nodt", "--surface", "a.off", "--vertices", vertices, "--iterations", "2", *more]
        # Not of the clock.
        return subprocess.run([OPTIONS["tool"], *map(str, words)], cwd=self.here, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (tool.HANGING, tool.HANGING)))

    def judge(self, done, what):
        if done.returncode == 0:
            self.assertEqual(done.stderr, "", what)
        else:
            self.assertEqual((done.returncode, done.stdout), (3, ""), f"{what}: {done.stderr}")
            self.assertRegex(done.stderr, r"\Aannulus: a\.off[^\n]+\n\Z", what)

    def accept(self, points, faces, *more, **options):
        done = self.mesh(points, faces, *more, **options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def refuse_surface(self, pattern, points, faces):
        self.write("a.off", off(points, faces))
        self.assertRegex(self.refuse(3, "nodt", "--surface", "a.off", "--vertices", "60"), pattern)

    def test_sharp_edges(self):
        # Mesh_3 refined for ever here.
        self.accept([(0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 4)], TETRAHEDRON[1], vertices=600)
        for height in (0.3, 0.05):
            self.accept([(x, y, z * height) for x, y, z in TETRAHEDRON[0]], TETRAHEDRON[1])
        self.accept(*L_SHAPE)

    def test_sharp_edges_are_kept_or_refused(self):
        self.accept(*L_SHAPE, "--sharp", "30")
        self.accept(*TETRAHEDRON, "--sharp", "30")
        # Acute.
        for points in ([(0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 4)], [(x, y, 0.05 * z) for x, y, z in TETRAHEDRON[0]]):
            self.judge(self.mesh(points, TETRAHEDRON[1], "--sharp", "30"), points)

    def test_lengths(self):
        points, faces = TETRAHEDRON
        for tiny in (1e-320, 5e-324, 1e-200, 1e-17):
            with self.subTest(tiny=tiny):
                self.accept([(0, 0, tiny)] + points[1:], faces)
        for scale in (1e-25, 1e11):
            with self.subTest(scale=scale):
                self.accept([tuple(scale * x for x in p) for p in points], faces)
        for scale in (1e-40, 1e40):
            with self.subTest(scale=scale):
                self.refuse_surface("a.off: its longest side is below 1e-30, or a coordinate beyond",
                                    [tuple(scale * x for x in p) for p in points], faces)
        self.accept([(x + 1e6, y, z) for x, y, z in points], faces)
        self.refuse_surface("a.off: it is more than 1e7 times", [(x + 1e9, y, z) for x, y, z in points], faces)

    def test_crossings(self):
        points, faces = TETRAHEDRON
        shifted = [(x + 0.2, y + 0.1, z + 0.15) for x, y, z in points]
        two = points + shifted, faces + [tuple(i + 4 for i in f) for f in faces]
        self.refuse_surface("a.off: it crosses or touches itself near", *two)
        self.accept(*two, "--allow-crossing")
        # One within the other meets it nowhere; a corner in a facet touches; a triangle without area.
        inner = [(0.1 + 0.2 * x, 0.1 + 0.2 * y, 0.1 + 0.2 * z) for x, y, z in points]
        self.accept(points + inner, faces + [tuple(i + 4 for i in f[::-1]) for f in faces])
        touching = [(0.25 * x + 0.25, 0.25 * y + 0.25, 0.25 * z) for x, y, z in points]
        self.refuse_surface("crosses or touches", points + touching, two[1])
        middle = points + [(0.5, 0, 0)]
        self.refuse_surface("a triangle has no area", middle,
                            [(0, 2, 1), (2, 1, 3)[::-1], (0, 3, 2), (0, 4, 3), (4, 1, 3), (0, 1, 4)])

    def test_mutants(self):
        """Moved, merged, flattened corners; faces dropped, turned, repeated; numbers from the ends of the doubles."""
        seed = tool.SEED
        statuses = {0: 0, 3: 0}
        for i in range(int(os.environ.get("ANNULUS_MUTANTS", "15"))):
            with self.subTest(seed=seed, mutant=i):
                points, faces = self.mutant(random.Random(f"{seed} {i}"))
                more = ["--allow-crossing"] if i % 2 else []
                done = self.mesh(points, faces, *more, vertices=20 + 10 * (i % 10))
                self.judge(done, off(points, faces))
                statuses[done.returncode] += 1
        self.assertGreater(min(statuses.values()), 0, "all alike")

    @staticmethod
    def mutant(bits):
        points, faces = bits.choice((TETRAHEDRON, BOX, L_SHAPE))
        points, faces = [list(map(float, p)) for p in points], list(faces)
        for _ in range(bits.randint(1, 3)):
            i, j, k = bits.randrange(len(points)), bits.randrange(len(points)), bits.randrange(3)
            kind = bits.randrange(10)
            if kind < 3:
                points[i][k] += bits.choice((-1, 1)) * 10 ** bits.uniform(-17, 0.5)
            elif kind == 3:
                points[i][k] = bits.choice((0.0, -0.0, 1e-320, 1e-160, 1e-17, 1e17, 1e160, points[j][k]))
            elif kind == 4:
                factor = 10 ** bits.uniform(-8, 8)
                for p in points:
                    p[k] *= factor
            elif kind == 5:
                points[i] = [p + bits.choice((0, 1e-16, 1e-9)) for p in points[j]]
            elif kind == 6:  # nearly flat
                for p in points:
                    p[k] = 1e-3 * p[k] + bits.uniform(-1, 1) * 10 ** bits.uniform(-12, -2)
            elif kind == 7:
                factor = 10 ** bits.uniform(-60, 60)
                points = [[factor * x for x in p] for p in points]
            elif kind == 8:
                f = bits.randrange(len(faces))
                faces[f] = bits.choice((faces[f][::-1], faces[0], faces[f][1:] + faces[f][:1], (i, j, k)))
            else:
                for p in points:
                    p[k] += bits.choice((1e3, 1e6, 1e9))
        return points, faces


if __name__ == "__main__":
    tool.main(__doc__)
