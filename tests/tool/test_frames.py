#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of replay, lloyd and nodt for every frame: --voronoi, --changes, against triangulations.

usage: test_frames.py --tool=PATH [CLASS[.METHOD]...]"""

import random
import unittest

import tool
from frames import delaunay_pairs, FrameTest, voronoi_areas, wander

try:
    import numpy
    import scipy.spatial
except ImportError:
    scipy = None
try:
    import vtk
except ImportError:
    vtk = None


class Frames(FrameTest):
    def test_changes_are_those_of_triangulations_in_rationals(self):
        for d, points in ((2, 11), (3, 9)):
            frames = wander(d, 8, points, 4)
            name = self.xyz_of(frames)
            pairs = [delaunay_pairs(frame) for frame in frames]
            self.assertNotEqual(pairs[0], pairs[1])
            for strategy in tool.STRATEGIES:
                with self.subTest(d=d, strategy=strategy):
                    self.succeed("replay", name, "--strategy", strategy, "--changes", "--output", "out", "--quiet")
                    self.check_changes(pairs)

    def test_without_arrivals_as_many_pairs_break_as_are_made_inside_of_the_hull(self):
        """T1 transitions: four outer points at rest keep the hull."""
        dice = random.Random(8)
        outer = {1000 + i: list(p) for i, p in enumerate([(-9, -9), (9, -9), (9, 9), (-9, 9)])}
        inner = {i: [dice.random(), dice.random()] for i in range(40)}
        frames = []
        for _ in range(12):
            frames.append({**outer, **{i: list(p) for i, p in inner.items()}})
            inner = {i: [c + 0.02 * dice.gauss(0, 1) for c in p] for i, p in inner.items()}
        self.succeed("replay", self.xyz_of(frames), "--changes", "--output", "out", "--quiet")
        said = self.changes()
        self.assertGreater(len(said), 5)
        for made, broken in said.values():
            self.assertEqual(len(made), len(broken))

    def test_voronoi_cells_against_rationals(self):
        frames = wander(2, 6, 12, 9)
        self.succeed("replay", self.xyz_of(frames), "--voronoi", "--output", "out", "--quiet")
        rows = self.table("out", "voronoi.csv")
        self.assertEqual([(int(r["frame"]), int(r["id"])) for r in rows],
                         [(f, i) for f, frame in enumerate(frames) for i in sorted(frame)])
        for f, frame in enumerate(frames):
            areas, pairs = voronoi_areas(frame), delaunay_pairs(frame)
            for row in (r for r in rows if int(r["frame"]) == f):
                i = int(row["id"])
                self.assertEqual(int(row["neighbours"]), sum(i in pair for pair in pairs))
                self.assertEqual(row["unbounded"] == "1", areas[i] is None)
                self.assertEqual(row["area"] == "", areas[i] is None)
                if areas[i] is not None:
                    self.assertAlmostEqual(float(row["area"]) / areas[i], 1, delta=1e-9)

    @unittest.skipUnless(scipy, "SciPy is not installed")
    def test_voronoi_cells_of_space_against_scipy(self):
        frames = wander(3, 10, 60, 5)
        self.succeed("replay", self.xyz_of(frames), "--voronoi", "--output", "out", "--quiet")
        rows = {(int(r["frame"]), int(r["id"])): r for r in self.table("out", "voronoi.csv")}
        for f, frame in enumerate(frames):
            ids = sorted(frame)
            diagram = scipy.spatial.Voronoi(numpy.array([frame[i] for i in ids]))
            for i, region in zip(ids, diagram.point_region):
                corners = diagram.regions[region]
                volume = rows.pop((f, i))["volume"]
                self.assertEqual(volume == "", -1 in corners)
                if volume:
                    self.assertAlmostEqual(float(volume) / scipy.spatial.ConvexHull(diagram.vertices[corners]).volume,
                                           1, delta=1e-9)
        self.assertEqual(rows, {})


if __name__ == "__main__":
    tool.main(__doc__)
