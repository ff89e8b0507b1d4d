#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What replay measures in periodic boxes, beside clipping in rationals, Qhull and crystals: areas and volumes, pairs of
neighbours with shifts, and their changes. usage: test_boxed_motions.py --tool=PATH [CLASS[.METHOD]...]"""

import itertools
import math
import random
import shutil
from fractions import Fraction

import boxed
import frames
import tool

try:
    import numpy
    import scipy.spatial
except ImportError:
    scipy = None


class Boxed(boxed.BoxedTest):
    def test_areas_and_pairs_in_2d_are_those_of_clipping(self):
        """Boxes that are skewed and change; points in any image, few points, points that come and go."""
        dice = random.Random(tool.SEED)
        grid = 2 ** 16
        place = lambda: [dice.randrange(-2 * grid, 3 * grid) / grid for _ in range(2)]
        boxes = [[[1, 0], [k / 16, 1 + k / 8]] for k in range(4)]
        motion = [{i: place() for i in ids} for ids in ([3, 5, 9], [3, 5, 9], [5], [1, 5, 7, 8, 9])]
        self.lattice_xyz("a.xyz", motion, boxes, "T T F")
        done = self.succeed("replay", "a.xyz", "--voronoi", "--neighbors", "--changes", "--every", 1, "--audit", 1,
                            "--output", "out")
        self.assertIn("box            Lattice and pbc: 1 0, 0.1875 1.375\n", done.stdout)
        self.assertEqual(done.stderr, "")
        pairs, voronoi, changes = self.pairs(), self.voronoi(), self.shifted_changes()
        for f, (points, box) in enumerate(zip(motion, boxes)):
            areas, lengths = boxed.cells_2d(points, box)
            self.assertEqual(set(voronoi[f]), set(points))
            for i, area in areas.items():
                self.assertAlmostEqual(voronoi[f][i][0], area, delta=1e-9)
                count = sum((i == a) + (i == b) for a, b, _ in lengths)
                self.assertEqual(voronoi[f][i][1], count)
            self.assertAlmostEqual(sum(v for v, _ in voronoi[f].values()), 1 + f / 8, delta=1e-9)
            self.assertEqual({key for key, length in pairs[f].items() if length > 0}, set(lengths))
            for key, length in lengths.items():
                self.assertAlmostEqual(pairs[f][key], length, delta=1e-9)
        for f in range(1, 4):  # what is made is there, and what is broken was
            made, broken = changes.get(f, (set(), set()))
            self.assertLessEqual(made, set(pairs[f]))
            self.assertLessEqual(broken, set(pairs[f - 1]))
            self.assertEqual(len(pairs[f]) - len(pairs[f - 1]), len(made) - len(broken))
        said = self.summary("out")
        self.assertEqual(said["box"], [[1, 0], [0.1875, 1.375]])
        self.assertNotIn("ignored", said)
        self.assertEqual(said["audit"], {"checked": 3, "failed": 0})
        self.assertEqual(said["vertices"], 5)

    def test_volumes_and_pairs_in_3d_are_those_of_qhull(self):
        if scipy is None:
            self.skipTest("no SciPy")
        dice = numpy.random.default_rng(tool.SEED)
        box = numpy.array([[2.0, 0, 0], [0.5, 2.5, 0], [-0.75, 0.25, 2.25]])
        x = dice.random((40, 3)) @ box
        shifts = numpy.array(list(itertools.product((-1, 0, 1), repeat=3)))
        images = (x[None] + (shifts @ box)[:, None]).reshape(-1, 3)
        vor = scipy.spatial.Voronoi(images)
        away = dice.integers(-3, 4, (40, 3))
        self.lattice_xyz("a.xyz", [dict(enumerate(x + away @ box))], [box])
        self.succeed("replay", "a.xyz", "--voronoi", "--neighbors", "--output", "out")
        home = list(map(tuple, shifts)).index((0, 0, 0))
        expected = {}
        for (a, b) in vor.ridge_points:
            for p, q in ((a, b), (b, a)):
                i, j = int(p) % 40, int(q) % 40
                if int(p) // 40 != home:
                    continue
                shift = tuple(int(s) for s in shifts[int(q) // 40] + away[i] - away[j])
                if i < j or (i == j and shift > (0, 0, 0)):
                    expected[i, j, shift] = True
        self.assertEqual(set(self.pairs()[0]), set(expected))
        for i, (volume, _) in self.voronoi()[0].items():
            region = vor.regions[vor.point_region[home * 40 + i]]
            self.assertAlmostEqual(volume, scipy.spatial.ConvexHull(vor.vertices[region]).volume, delta=1e-9)

    def test_crystals_have_the_neighbours_that_are_counted_by_area(self):
        half = {"fcc": [(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)], "bcc": [(0, 0, 0), (1, 1, 1)], "sc": [(0, 0, 0)]}
        crystals = {name: [[c / 2 for c in p] for p in basis] for name, basis in half.items()}
        crystals["diamond"] = crystals["fcc"] + [[c + 0.25 for c in p] for p in crystals["fcc"]]
        for name, count in (("fcc", 12), ("bcc", 14), ("sc", 6), ("diamond", 16)):
            with self.subTest(name=name):
                points = dict(enumerate(crystals[name]))
                drifted = {i: [c + 7 * k / 8 for k, c in enumerate(p)] for i, p in points.items()}
                self.lattice_xyz("a.xyz", [points, drifted], [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]] * 2)
                self.succeed("replay", "a.xyz", "--voronoi", "--dim", 3, "--output", "out")
                for frame in self.voronoi().values():
                    self.assertEqual({n for _, n in frame.values()}, {count})

    def test_a_rigid_motion_changes_no_pair_however_it_is_written(self):
        """Positions wrapped by the file or not, and the box given by three bases of one lattice."""
        dice = random.Random(tool.SEED)
        start = {i: [dice.random(), dice.random()] for i in range(9)}
        for wrapped in (False, True):
            motion, boxes = [], []
            for f in range(12):
                frame = {i: [a + 0.13 * f, b + 0.31 * f] for i, (a, b) in start.items()}
                motion.append({i: [c % 1 for c in p] for i, p in frame.items()} if wrapped else frame)
                boxes.append([[1, 0], [0, 1]] if f < 6 else [[1, 0], [1, 1]] if f < 9 else [[0, 1], [-1, 1]])
            self.lattice_xyz("a.xyz", motion, boxes)
            self.succeed("replay", "a.xyz", "--changes", "--neighbors", "--output", "out")
            self.assertEqual(self.shifted_changes(), {})
            rows = (self.here / "out" / "iterations.csv").read_text(encoding="utf-8").splitlines()
            at = rows[0].split(",").index("displacement_mean")
            for row in rows[1:]:
                self.assertAlmostEqual(float(row.split(",")[at]), math.hypot(0.13, 0.31) * 3, delta=1e-6)
            shutil.rmtree(self.here / "out")

    def test_a_pair_that_changes_is_named_as_its_frames_name_it(self):
        """Four points of a square lattice of two; one moves: neighbours by the shifts of each frame."""
        square = {1: [0.1, 0.1], 2: [0.6, 0.2], 3: [0.2, 0.7], 4: [0.7, 0.6]}
        moved = {**square, 4: [1.35, 0.4]}
        self.lattice_xyz("a.xyz", [square, moved], [[[1, 0], [0, 1]]] * 2)
        self.succeed("replay", "a.xyz", "--changes", "--neighbors", "--output", "out")
        pairs, (made, broken) = self.pairs(), self.shifted_changes()[1]
        # Point 4 goes on at its image at 0.35: by it the pairs of both frames have one name.
        path = lambda key, f: (key[0], key[1], (key[2][0] + f * (key[1] == 4) - f * (key[0] == 4), key[2][1]))
        before, after = {path(k, 0) for k in pairs[0]}, {path(k, 1) for k in pairs[1]}
        self.assertEqual({path(k, 1) for k in made}, after - before)
        self.assertEqual({path(k, 0) for k in broken}, before - after)
        self.assertTrue(made and broken)

    def test_dumps_with_tilts_shares_and_images_are_one_motion(self):
        """x y z, xs ys zs, xu yu zu, x y z ix iy iz: the same volumes and, by paths, the same changes."""
        dice = random.Random(tool.SEED)
        lx, ly, lz, xy, xz, yz = 4.0, 3.0, 5.0, 1.0, -0.5, 0.75
        corner = [-1.0, 0.5, 2.0]
        box = [[lx, 0, 0], [xy, ly, 0], [xz, yz, lz]]
        ends = [(min(0, xy, xz, xy + xz), max(0, xy, xz, xy + xz)), (min(0, yz), max(0, yz)), (0, 0)]
        bounds = "".join(f"{corner[k] + low!r} {corner[k] + size + high!r} {tilt!r}\n"
                         for k, (size, (low, high), tilt) in enumerate(zip((lx, ly, lz), ends, (xy, xz, yz))))
        shares = {i: [dice.random() for _ in range(3)] for i in range(1, 13)}
        results = []
        for kind in ("x y z", "xs ys zs", "xu yu zu", "x y z ix iy iz"):
            text = ""
            for f in range(3):
                text += (f"ITEM: TIMESTEP\n{10 * f}\nITEM: NUMBER OF ATOMS\n12\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
                         f"{bounds}ITEM: ATOMS id {kind}\n")
                for i, s in shares.items():
                    path = [c + 0.07 * f * (i % 3) for c in s]
                    turns = [math.floor(c) for c in path]
                    inside = [c - t for c, t in zip(path, turns)]
                    words = {
                        "x y z": boxed.added(corner, inside, box),
                        "xs ys zs": inside,
                        "xu yu zu": boxed.added(corner, path, box),
                        "x y z ix iy iz": boxed.added(corner, inside, box) + turns
                    }[kind]
                    text += f"{i} {' '.join(map(repr, words))}\n"
            self.write("a.lammpstrj", text)
            done = self.succeed("replay", "a.lammpstrj", "--voronoi", "--changes", "--neighbors", "--audit", 1,
                                "--output", "out")
            self.assertIn("box            BOX BOUNDS pp pp pp: 4 0 0, 1 3 0, -0.5 0.75 5\n", done.stdout)
            self.assertEqual(self.summary("out")["box"], box)
            voronoi, changes = self.voronoi(), self.shifted_changes()
            for frame in voronoi.values():
                self.assertAlmostEqual(sum(v for v, _ in frame.values()), lx * ly * lz, delta=1e-8)
            results.append((voronoi, {f: [sorted(k[:2] for k in s) for s in both] for f, both in changes.items()}))
            self.assertTrue(changes)
        for voronoi, changes in results[1:]:
            self.assertEqual(changes, results[0][1])
            for f, frame in voronoi.items():
                for i, (volume, count) in frame.items():
                    self.assertAlmostEqual(volume, results[0][0][f][i][0], delta=1e-8)
                    self.assertEqual(count, results[0][0][f][i][1])


class Coincident(boxed.BoxedTest):
    def merged(self, motion, boxes, *words):
        """Beside the same motion without the points that are at the place of one of a smaller id, in rationals: replay
        writes the same. Returns what it prints, and the number of points left out."""
        apart = []
        for frame, box in zip(motion, boxes):
            seen, kept = set(), {}
            for i in sorted(frame):
                place = tuple(c % 1 for c in self.shares(frame[i], box))
                if place not in seen:
                    kept[i] = frame[i]
                seen.add(place)
            apart.append(kept)
        self.lattice_xyz("together.xyz", motion, boxes)
        self.lattice_xyz("apart.xyz", apart, boxes)
        common = ("--dim", len(boxes[0]), "--voronoi", "--neighbors", "--changes", "--audit", 1, *words)
        done = self.succeed("replay", "together.xyz", "--coincident", "merge", *common, "--output", "out", "--force")
        self.succeed("replay", "apart.xyz", *common, "--output", "apart", "--force")
        for name in ("voronoi.csv", "pairs.csv", "changes.csv", "final.mesh"):
            self.assertEqual(*((self.here / there / name).read_bytes() for there in ("out", "apart")), name)
        ways = [[row["displacement_mean"] for row in self.table(there, "iterations.csv")] for there in ("out", "apart")]
        self.assertEqual(*ways)
        self.assertEqual(self.summary("out")["audit"], {"checked": len(motion) - 1, "failed": 0})
        self.assertEqual(self.summary("out")["vertices"], len(apart[-1]))
        self.assertEqual(done.stderr, "")
        return done.stdout, sum(map(len, motion)) - sum(map(len, apart))

    @staticmethod
    def shares(point, box):
        """Coordinates in the vectors of the box, by Cramer's rule in rationals."""
        rows, p = [[Fraction(c) for c in v] for v in box], [Fraction(c) for c in point]
        whole = frames.determinant(rows)
        return [frames.determinant([p if j == k else v for j, v in enumerate(rows)]) / whole for k in range(len(rows))]

    def test_images_of_one_another_are_merged_and_come_apart(self):
        """Also where the last bits of images differ, which the grid of the box does not."""
        apart = {1: [0.1, 0.1], 2: [0.6, 0.2], 3: [0.2, 0.7], 4: [0.7, 0.6]}
        met = {**apart, 3: [1.6, -0.8], 4: [0.6, 0.2]}
        box = [[[1, 0], [0, 1]]] * 3
        self.lattice_xyz("a.xyz", [apart, met, apart], box)
        said = "in frame 1 the points of ids 2, 3 are at one place of the periodic box; expected points that differ, "
        self.lattice_xyz("b.xyz", [apart, {**apart, 3: [1.6, -0.8]}, apart], box)
        self.assertIn(said + "or --coincident merge", self.refuse(3, "replay", "b.xyz"))
        for strategy in ("auto", "rebuild", "signs", "tolerances"):
            done = self.succeed("replay", "a.xyz", "--coincident", "merge", "--strategy", strategy, "--voronoi",
                                "--output", "out", "--force")
            line = "2 points appeared, 2 disappeared, 2 merged with others at their place."
            self.assertIn(f"points         {line}\n", done.stdout)
            self.assertIn(line, (self.here / "out" / "report.html").read_text(encoding="utf-8"))
            self.assertEqual([sorted(frame) for frame in self.voronoi().values()], [[1, 2, 3, 4], [1, 2], [1, 2, 3, 4]])
        self.lattice_xyz("c.xyz", [met, apart], box)  # from the first frame on
        done = self.succeed("replay", "c.xyz", "--coincident", "merge", "--audit", 1)
        self.assertIn("2 points appeared, 0 disappeared, 2 merged", done.stdout)
        done = self.succeed("replay", "a.xyz", "--open", "--coincident", "merge", "--quiet")
        self.assertEqual(done.stderr, "")

    def test_a_motion_with_coincident_points_is_that_without_them(self):
        """Few places, in any image, in boxes that are skewed and change; points come and go."""
        dice = random.Random(tool.SEED)
        for d, fine, strategy in itertools.product((2, 3), (2, 4), ("auto", "signs")):
            with self.subTest(d=d, fine=fine, strategy=strategy):
                boxes = [[[float(j == k) + (k > j) * f / 8 for j in range(d)] for k in range(d)] for f in range(4)]
                motion = []
                for box in boxes:
                    turns = lambda: [dice.randrange(-9, 12) / fine for _ in range(d)]
                    motion.append({i: boxed.added([0.0] * d, turns(), box) for i in dice.sample(range(20), 12)})
                said, merged = self.merged(motion, boxes, "--strategy", strategy)
                self.assertIn(f" disappeared, {merged} merged with others", said)
        with self.subTest("a frame without points"):
            self.merged([{1: [0.0, 0.0], 2: [1.0, 2.0]}, {}, {1: [0.5, 0.5], 3: [0.5, -0.5], 4: [0.0, 0.0]}],
                        [[[1, 0], [0, 1]]] * 3)

    def test_points_too_far_away_are_refused_by_name(self):
        self.lattice_xyz("a.xyz", [{1: [0.5, 0.5]}, {1: [0.5, 0.5], 2: [1e11, 0.25]}], [[[1, 0], [0, 1]]] * 2)
        for choice in ("refuse", "merge"):
            line = self.refuse(3, "replay", "a.xyz", "--coincident", choice)
            self.assertRegex(line, r"a.xyz:7: in frame 1 the point of id 2: .*; expected a point nearer to the box")


class Open(frames.FrameTest):
    def test_pairs_of_an_open_mesh_are_its_neighbours(self):
        motion = frames.wander(2, 4, 9, tool.SEED)
        self.xyz_of(motion)
        self.succeed("replay", "motion.xyz", "--neighbors", "--output", "out")
        found = {}
        for row in self.table("out", "pairs.csv"):
            self.assertEqual(list(row), ["frame", "first", "second", "length"])
            found.setdefault(int(row["frame"]), set()).add((int(row["first"]), int(row["second"])))
        for f, frame in enumerate(motion):
            self.assertEqual(found[f], frames.delaunay_pairs(frame))


if __name__ == "__main__":
    tool.main(__doc__)
