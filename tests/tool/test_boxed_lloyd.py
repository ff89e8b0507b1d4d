#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus lloyd --box`, beside Qhull on the images of the points. usage: test_boxed_lloyd.py --tool=PATH
[CLASS[.METHOD]...]"""

import itertools

import frames
import tool

try:
    import numpy
    import scipy.spatial
except ImportError:
    scipy = None

SKEWED = {2: [[1, 0], [0.375, 0.75]], 3: [[1, 0, 0], [0.25, 1.25, 0], [-0.375, 0.125, 0.875]]}


def words_of(box):
    return ",".join(repr(c) for vector in box for c in vector)


def cells(points, box):
    """The volumes of the Voronoi cells, the vectors from the points to their centroids, and the energy: the integral of
    the square of the distance to the nearest point."""
    x, box = numpy.array(points), numpy.array(box)
    n, d = x.shape
    x = x - numpy.floor(x @ numpy.linalg.inv(box)) @ box
    shifts = sorted(itertools.product(range(-2, 3), repeat=d), key=lambda s: s != (0,) * d)
    vor = scipy.spatial.Voronoi((x[None] + (numpy.array(shifts) @ box)[:, None]).reshape(-1, d))
    volume, moment, energy = numpy.zeros(n), numpy.zeros((n, d)), 0
    for pair, ring in zip(vor.ridge_points, vor.ridge_vertices):
        for i in pair:
            if i >= n:
                continue
            assert -1 not in ring
            corner = vor.vertices[ring] - x[i]
            for k in range(1, len(ring) - d + 2):  # a fan
                simplex = numpy.vstack([corner[:1], corner[k:k + d - 1]])
                size = abs(numpy.linalg.det(simplex)) / (2 if d == 2 else 6)
                total = simplex.sum(axis=0)
                volume[i] += size
                moment[i] += size * total / (d + 1)
                energy += size * ((simplex ** 2).sum() + total @ total) / ((d + 1) * (d + 2))
    return volume, moment / volume[:, None], energy


class BoxedLloyd(frames.FrameTest):
    def positions(self, directory, step, n, d):
        file = self.here / directory / f"frame-{step:06}.vtu"
        return [list(tool.vtu_values(file, "Points")[3 * i:3 * i + d]) for i in range(n)]

    def scattered(self, n, d):
        """In any image of the box."""
        dice = numpy.random.default_rng(tool.SEED)
        points = (4 * dice.random((n, d)) - 1) @ numpy.array(SKEWED[d])
        self.xyz("a.xyz", points.tolist())
        return points

    def column(self, name, directory="out"):
        return [row[name] for row in self.table(directory, "iterations.csv")]

    def test_a_step_leads_to_the_centroids_that_qhull_computes(self):
        if scipy is None:
            self.skipTest("no SciPy")
        for n, d in ((1, 2), (2, 2), (9, 2), (1, 3), (3, 3), (20, 3)):
            with self.subTest(n=n, d=d):
                points, box = self.scattered(n, d), SKEWED[d]
                self.succeed("lloyd", "--input", "a.xyz", "--box", words_of(box), "--iterations", 1, "--audit", 1,
                             "--every", 1, "--output", "out")
                _, offset, _ = cells(points, box)
                away = numpy.array(self.positions("out", 1, n, d)) - (points + offset)
                share = away @ numpy.linalg.inv(numpy.array(box))
                self.assertLess(abs(share - share.round()).max(), 1e-12)
                way = numpy.hypot.reduce(offset, axis=1) / (numpy.linalg.det(numpy.array(box)) / n) ** (1 / d)
                self.assertAlmostEqual(float(self.column("displacement_mean")[0]), way.mean(), delta=1e-12)
                self.assertAlmostEqual(float(self.column("displacement_max")[0]), way.max(), delta=1e-12)

    def test_energy_falls_and_volumes_add_up_in_every_step(self):
        if scipy is None:
            self.skipTest("no SciPy")
        for d, n, steps in ((2, 60, 15), (3, 40, 8)):
            with self.subTest(d=d):
                box = SKEWED[d]
                self.succeed("lloyd", "--points", n, "--box", words_of(box), "--iterations", steps, "--every", 1,
                             "--voronoi", "--audit", 1, "--output", "out")
                self.assertEqual(self.summary("out")["audit"], {"checked": steps, "failed": 0})
                sums = [0.0] * (steps + 1)
                for row in self.table("out", "voronoi.csv"):
                    sums[int(row["frame"])] += float(row["area" if d == 2 else "volume"])
                energies = []
                for step in range(steps + 1):
                    self.assertAlmostEqual(sums[step], abs(numpy.linalg.det(numpy.array(box))), delta=1e-9)
                    energies.append(cells(self.positions("out", step, n, d), box)[2])
                for before, after in zip(energies, energies[1:]):
                    self.assertLess(after, before)

    def test_a_lattice_rests(self):
        square = [[i / 4 + 3, j / 4] for i in range(4) for j in range(4)]
        cubic = [[i / 2, j / 2, k / 2] for i in range(2) for j in range(2) for k in range(2)]
        bcc = cubic + [[c + 0.25 for c in p] for p in cubic]
        thirds = [[i / 3, j / 3] for i in range(3) for j in range(3)]
        for points, box, most in ((square, "1,1", 0), (cubic, "1,1,1", 0), (bcc, "1,1,1", 0), (thirds, "1,1", 1e-14)):
            self.xyz("a.xyz", points)
            for strategy in ("auto", "rebuild", "signs", "tolerances"):
                self.succeed("lloyd", "--input", "a.xyz", "--box", box, "--iterations", 3, "--audit", 1, "--strategy",
                             strategy, "--every", 3, "--output", "out")
                for way in self.column("displacement_max"):
                    self.assertLess(float(way), 1e-14)
                if most == 0:  # on the grid: rounding leaves every point at its place
                    self.assertEqual(self.positions("out", 0, len(points), len(box.split(","))),
                                     self.positions("out", 3, len(points), len(box.split(","))))

    def test_positions_depend_neither_on_threads_nor_on_the_strategy(self):
        for box, d in (("3,2", 2), ("1,1,1", 3)):
            found = []
            for k, words in enumerate((["--threads", 1], ["--threads", 2], ["--strategy", "rebuild"],
                                       ["--strategy", "signs"], ["--strategy", "tolerances"],
                                       ["--strategy", "tolerances", "--threads", 2])):
                self.succeed("lloyd", "--points", 300, "--box", box, "--iterations", 12, "--seed", 5, "--every", 12,
                             "--output", f"out{k}", "--force", *words)
                found.append((self.positions(f"out{k}", 0, 300, d), self.positions(f"out{k}", 12, 300, d)))
            for again in found[1:]:
                self.assertEqual(found[0], again)
            self.assertNotEqual(*found[0])
            self.assertEqual((self.here / "out0" / "final.mesh").read_bytes(),
                             (self.here / "out1" / "final.mesh").read_bytes())
        moves = self.summary("out2")["moves"]
        self.assertEqual((moves["asked"], moves["rebuilt"]), (3600, 3600))

    def test_points_may_be_close_together_or_far_from_the_box(self):
        """Cells that are thinner than rounding; points of clusters over six decades; images a million boxes away."""
        self.succeed("generate", "clusters", "--points", 200, "--dim", 3, "--output", "clusters.xyz")
        for name, points, box in (("a.xyz", [(0.1, 0.1), (0.1 + 1e-14, 0.1), (0.7, 0.3)], "1,1"),
                                  ("b.xyz", [(1e6 + 0.1, -5000.1), (0.7, 0.3), (7, 1)], "1,1"),
                                  ("clusters.xyz", None, "1,1,1")):
            if points:
                self.xyz(name, points)
            self.succeed("lloyd", "--input", name, "--box", box, "--iterations", 20, "--audit", 1, "--output", "out")
            self.assertEqual(self.summary("out")["audit"], {"checked": 20, "failed": 0})
            ways = [float(way) for way in self.column("displacement_max")]
            self.assertLess(ways[-1], ways[0])

    def test_files_and_page(self):
        done = self.succeed("lloyd", "--points", 50, "--box", "2,0,0.5,1", "--iterations", 4, "--output", "out")
        self.assertIn("box            --box: 2 0, 0.5 1\n", done.stdout)
        self.assertIn(" decided for tolerances: filter", done.stdout)
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, tool.RUN_FILES)
        said = self.summary("out")
        self.assertEqual((said["box"], said["dimension"], said["vertices"], said["iterations"]),
                         ([[2, 0], [0.5, 1]], 2, 50, 4))
        self.succeed("lloyd", "--points", 50, "--iterations", 4, "--output", "open")
        self.assertEqual([list(row) for row in self.table("out", "iterations.csv")],
                         [list(row) for row in self.table("open", "iterations.csv")])
        page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        for words in ("4 Lloyd iterations", "periodic box from", "--box", "0.5, 1", "Before", "After 4 iterations"):
            self.assertIn(words, page)
        self.assertEqual(said["tolerance"], "certified")
        self.assertIn('aria-label="Displacement, tolerance"', page)

    def test_what_there_is_with_open_boundaries_only_is_refused(self):
        box = ["lloyd", "--points", 20, "--box", "1,1"]
        for words, what in ((["--strategy", "in-place"],
                             "the strategies are auto, rebuild, signs and tolerances, not in-place"),
                            (["--strategy", "paper", "--tolerance", "paper"], "tolerances are certified, not paper"),
                            (["--density", "x2"], "in a periodic box the density is one"),
                            (["--density", "picture.png"], "in a periodic box the density is one"),
                            (["--dots", "cells"], "in a periodic box the density is one"),
                            (["--domain", "square"], "with --box the domain is the periodic box"),
                            (["--radius", 2], "with --box the domain is the periodic box"),
                            (["--open"], "--open and --box exclude each other")):
            self.assertIn(what, self.refuse(2, *box, *words))
        for numbers, what in (("1,x", "'x' is not a number"), ("1", "--box has 1 number, and a box has 2 or 4 in 2D"),
                              ("1,1,0", "--box: the vectors of the box")):
            self.assertIn(what, self.refuse(2, "lloyd", "--points", 20, "--box", numbers))
        self.assertIn("say how many points", self.refuse(2, "lloyd", "--box", "1,1"))
        self.xyz("a.xyz", [(0, 0), (0.5, 0.25), (1e11, 1)])
        self.assertRegex(self.refuse(3, "lloyd", "--input", "a.xyz", "--box", "1,1"),
                         "a.xyz:3: .*; expected a point nearer to the box")

    def test_images_of_one_another_are_merged(self):
        self.xyz("a.xyz", [(0, 0), (0.5, 0.25), (2, 1), (0.5, 0.25), (0.375, 0.75)])
        self.xyz("b.xyz", [(0, 0), (0.5, 0.25), (0.375, 0.75)])
        for name, words, said in (("a.xyz", ("lloyd",), "annulus: a.xyz: merged 2 duplicate points\n"),
                                  ("b.xyz", ("lloyd",), ""),
                                  ("a.xyz", ("compare", "--", "lloyd"),
                                   "annulus: a.xyz: merged 2 duplicate points\n")):
            files = () if "--" in words else ("--output", name[0])
            done = self.succeed(*words, "--input", name, "--box", "1,1", "--iterations", 3, "--audit", 1, *files)
            self.assertEqual(done.stderr, said)
        self.assertEqual(self.summary("a")["vertices"], 3)
        self.assertEqual((self.here / "a" / "final.mesh").read_bytes(), (self.here / "b" / "final.mesh").read_bytes())

    def test_the_box_of_a_file_is_replaced(self):
        self.write("a.xyz", '2\nLattice="9 0 0 0 9 0 0 0 9" Properties=pos:R:3\n0.25 0.5 0\n0.5 0.625 0\n')
        self.succeed("lloyd", "--input", "a.xyz", "--ignore-z", "--box", "1,1", "--iterations", 2, "--output", "out")
        self.assertEqual(self.summary("out")["box"], [[1, 0], [0, 1]])
        self.assertNotIn("ignored", self.summary("out"))


if __name__ == "__main__":
    tool.main(__doc__)
