#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus generate` and reads its output. usage: test_generate.py --tool=PATH [CLASS[.METHOD]...]"""

import gzip
import math
import os
import signal
import subprocess

import tool

POINTS = ["uniform", "grid", "jittered", "cospherical", "clusters", "surface"]
MOTIONS = ["walk", "shear", "orbit"]


def frames_of(text):
    """The frames of extended XYZ as lists of points."""
    lines = text.splitlines()
    frames = []
    at = 0
    while at < len(lines):
        n = int(lines[at])
        rows = [line.split() for line in lines[at + 2:at + 2 + n]]
        assert [int(r[0]) for r in rows] == list(range(n))
        frames.append([tuple(map(float, r[1:])) for r in rows])
        at += 2 + n
    return frames


class Generate(tool.ToolTest):
    def generated(self, *words):
        return frames_of(self.succeed("generate", *words).stdout)

    def test_points(self):
        for kind in POINTS:
            for dim in (2, 3):
                with self.subTest(kind=kind, dim=dim):
                    [points] = self.generated(kind, "-n", 300, "--dim", dim)
                    self.assertEqual(len(set(points)), 300)
                    self.assertEqual({len(p) for p in points}, {dim})
                    if kind != "clusters":  # some of which reach beyond
                        self.assertTrue(all(0 <= c <= 1 for p in points for c in p))
                    if kind == "cospherical":
                        self.assertTrue(all(abs(math.dist(p, [0.5] * dim) - 0.5) < 1e-15 for p in points))
                    if kind == "surface":
                        axes = [1, 0.8, 0.6]
                        self.assertTrue(
                            all(abs(math.hypot(*((c - 0.5) / a for c, a in zip(p, axes if dim == 3 else [1, 0.8])))
                                    - 0.5) < 1e-15
                                for p in points))
                    if kind == "grid":
                        self.assertEqual(len({p[0] for p in points}), math.ceil(300 ** (1 / dim)))

    def test_motions(self):
        for kind in MOTIONS:
            for start in POINTS:
                with self.subTest(kind=kind, start=start):
                    frames = self.generated(kind, "-n", 100, "--from", start, "--steps", 4, "--pace", 0.1)
                    self.assertEqual(len(frames), 5)
                    self.assertEqual(frames[0], self.generated(start, "-n", 100)[0])
                    for a, b in zip(frames, frames[1:]):
                        ways = [math.dist(p, q) for p, q in zip(a, b)]
                        self.assertGreater(max(ways), 0.001)
                        self.assertLess(max(ways), 0.1)
                    if kind == "orbit":
                        self.assertTrue(all(abs(w - 0.01) < 0.001 for w in ways))
                    if kind == "shear":
                        self.assertTrue(all(abs(q[0] - p[0] - 0.01 * p[1]) < 1e-15 and p[1] == q[1]
                                            for p, q in zip(a, b)))

    def test_the_same_seed_gives_the_same_bytes(self):
        words = ("walk", "-n", 50, "--steps", 3)
        self.assertEqual(self.generated(*words), self.generated(*words, "--threads", 2))
        self.assertNotEqual(self.generated(*words), self.generated(*words, "--seed", 2))

    def test_what_is_written_is_read(self):
        for name in ("a.xyz", "a.csv", "a.lammpstrj", "a.XYZ.GZ", "a.csv.gz", "a.dump"):
            for dim in (2, 3):
                with self.subTest(name=name, dim=dim):
                    done = self.succeed("generate", "walk", "-n", 40, "--steps", 5, "--dim", dim, "--output", name,
                                        "--force")
                    self.assertEqual((done.stdout, done.stderr), ("", ""))
                    self.succeed("replay", name, "--audit", 1, "--output", "out", "--quiet")
                    summary = self.summary("out")
                    self.assertEqual((summary["dimension"], summary["iterations"], summary["audit"]["failed"]),
                                     (dim, 5, 0))
                    points = self.generated("walk", "-n", 40, "--steps", 5, "--dim", dim)[-1]
                    if dim == 2:
                        self.assertEqual(self.mesh("out")[0], points)
        self.assertEqual(self.listing()[:6],
                         sorted(["a.xyz", "a.csv", "a.lammpstrj", "a.XYZ.GZ", "a.csv.gz", "a.dump"]))

    def test_through_a_pipe(self):
        tool_path = tool.OPTIONS["tool"]
        done = subprocess.run(f"'{tool_path}' generate shear -n 200 --steps 50 --dim 3 --format lammps | '{tool_path}' "
                              "replay - --format lammps --audit 10", shell=True, cwd=self.here, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=tool.HANGING, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("200 vertices, 50 iterations", done.stdout)
        self.assertIn("5 checked, all Delaunay", done.stdout)

    def test_wrong_usage(self):
        self.write("a.xyz", "mine")
        for words in (["walk"], ["run", "-n", 3], ["walk", "-n", 0], ["walk", "-n", 3, "--dim", 4],
                      ["walk", "-n", 3, "--from", "walk"], ["walk", "-n", 3, "--pace", "nan"],
                      ["walk", "-n", 3, "--pace", -1], ["grid", "-n", 3, "--steps", 4],
                      ["grid", "-n", 3, "--from", "grid"], ["walk", "-n", 3, "--output", "a.txt"],
                      ["walk", "-n", 3, "--output", "a"], ["walk", "-n", 3, "--output", "a.off"],
                      ["walk", "-n", 3, "--format", "ply"], ["walk", "-n", 3, "--output", "a.xyz"]):
            with self.subTest(words=words):
                self.refuse(2, "generate", *words)
        self.assertEqual((self.here / "a.xyz").read_text(encoding="utf-8"), "mine")

    def test_what_cannot_be_written(self):
        (self.here / "folder.xyz").mkdir()
        self.refuse(4, "generate", "walk", "-n", 3, "--output", "folder.xyz", "--force")
        self.refuse(4, "generate", "walk", "-n", 3, "--output", "nowhere/a.xyz")
        if os.path.exists("/dev/full"):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([tool.OPTIONS["tool"], "generate", "walk", "-n", "30"], stdout=full,
                                      stderr=subprocess.PIPE, text=True, timeout=tool.HANGING, check=False)
            self.assertEqual(done.returncode, 4)
            self.assertRegex(done.stderr, r"\Aannulus: standard output[^\n]*\n\Z")

    def test_an_interrupted_file_is_none(self):
        done = self.run_tool("generate", "walk", "-n", "1000", "--steps", "1000000", "--output", "a.csv.gz",
                             env=tool.at(signal.SIGINT, 3, "write", "a.csv.gz"))
        self.assertEqual(done.returncode, -signal.SIGINT)
        self.assertEqual(self.listing(), [])

    def test_packed(self):
        self.succeed("generate", "grid", "-n", 9, "--output", "a.xyz.gz")
        self.succeed("generate", "grid", "-n", 9, "--output", "a.xyz")
        self.assertEqual(gzip.decompress((self.here / "a.xyz.gz").read_bytes()), (self.here / "a.xyz").read_bytes())


if __name__ == "__main__":
    tool.main(__doc__)
