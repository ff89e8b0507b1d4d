#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi cells that `replay --clip` clips: sums in every frame, single cells and facets in rational numbers, refusals.

usage: test_clip.py --tool=PATH [CLASS[.METHOD]...]"""

import math
import re
from fractions import Fraction

import tool
from frames import FrameTest, polygon_area, voronoi_cells, wander

SQUARE = [(0.125, 0.125), (0.875, 0.125), (0.875, 0.875), (0.125, 0.875)]
PENTAGON = [(-0.5, -0.5), (0.5, -1), (1.5, 0.25), (1, 1.25), (-0.25, 1)]


def words_of(corners):
    return ",".join(repr(c) for corner in corners for c in corner)


def half_planes(corners):
    """a, b, e of each edge of a counter-clockwise polygon: a x + b y + e <= 0 inside."""
    rows = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        a, b = q[1] - p[1], p[0] - q[0]
        rows.append((a, b, -a * p[0] - b * p[1]))
    return rows


class Clip(FrameTest):
    def cells(self, corner="area"):
        """{frame: {id: measure}}; all cells are bounded."""
        result = {}
        for row in self.table("out", "voronoi.csv"):
            self.assertEqual(row["unbounded"], "0")
            result.setdefault(int(row["frame"]), {})[int(row["id"])] = float(row[corner])
        return result

    def facets(self):
        """{frame: {(first, second): length}}"""
        result = {}
        for row in self.table("out", "pairs.csv"):
            result.setdefault(int(row["frame"]), {})[int(row["first"]), int(row["second"])] = float(row["length"])
        return result

    def check_plane(self, frames, clip, corners):
        """Areas and lengths of all frames against rational numbers. Points are multiples of 2^-20."""
        self.succeed("replay", self.xyz_of(frames), "--clip", clip, "--voronoi", "--neighbors", "--output", "out",
                     "--quiet")
        cells, facets = self.cells(), self.facets()
        self.assertEqual(set(cells), {f for f, points in enumerate(frames) if points})
        for f, found in cells.items():
            points = {i: [Fraction(c) for c in p] for i, p in frames[f].items()}
            expected = voronoi_cells(points, corners)
            self.assertEqual(set(found), set(points))
            self.assertAlmostEqual(sum(found.values()), polygon_area(corners), delta=1e-12)
            for i, polygon in expected.items():
                self.assertAlmostEqual(found[i], float(polygon_area(polygon)), delta=1e-12, msg=(f, i))
            sides = facets.get(f, {})
            for i, polygon in expected.items():
                of_cell = 0
                for p, q in zip(polygon, polygon[1:] + polygon[:1]):
                    for j, other in points.items():
                        if j != i and p != q and all(self.is_between(v, points[i], other) for v in (p, q)):
                            length = sides[min(i, j), max(i, j)]
                            self.assertAlmostEqual(length, math.dist(map(float, p), map(float, q)), delta=1e-11)
                            of_cell += length
                self.assertAlmostEqual(of_cell, sum(x for pair, x in sides.items() if i in pair), delta=1e-11)

    @staticmethod
    def is_between(v, p, q):
        return sum((a - b) * (2 * c - a - b) for a, b, c in zip(p, q, v)) == 0

    def test_boxes_and_polygons(self):
        for seed, (clip, corners) in enumerate((
                (words_of([SQUARE[0], SQUARE[2]]), SQUARE),
                ("box:-1,-1,2,2", [(-1, -1), (2, -1), (2, 2), (-1, 2)]),
                ("polygon:" + words_of(PENTAGON), PENTAGON),
                ("polygon:" + words_of(reversed(PENTAGON + PENTAGON[:1])), PENTAGON),
                ("half-spaces:" + words_of(half_planes(PENTAGON)), PENTAGON))):
            with self.subTest(clip):
                self.check_plane(wander(2, 6, 14, seed + 1, step=0.05), clip, corners)

    def test_few_points_and_points_outside(self):
        """No point, one, two, points on a line, cocircular points, and points that are all far from the clip."""
        line = {i: [0.25 * i, 0.5 * i] for i in range(4)}
        grid = {i: [0.3125 * (i % 4), 0.3125 * (i // 4)] for i in range(16)}
        far = {i: [3.0 + 0.5 * i, 7.0 - 0.25 * i * i] for i in range(5)}
        frames = [line, {}, {3: [5.0, 0.0]}, {3: [5.0, 0.5]}, {3: [0.5, 0.0], 4: [0.75, 0.25]}, grid, far]
        self.check_plane(frames, words_of([SQUARE[0], SQUARE[2]]), SQUARE)
        self.check_plane(frames, "polygon:" + words_of(PENTAGON), PENTAGON)

    def test_sums_in_3d(self):
        corner = [(-1, 0, 0, 0), (0, -1, 0, 0), (0, 0, -1, 0), (1, 1, 1, -1.5)]
        for clip, volume in (("0.25,0.25,0.25,0.75,1,2", 0.5 * 0.75 * 1.75), ("-1,-1,-1,2,2,2", 27),
                             ("half-spaces:" + words_of(corner), 1.5 ** 3 / 6)):
            frames = wander(3, 5, 30, 2) + [{}, {1: [0.5, 0.5, 0.5]}]
            self.succeed("replay", self.xyz_of(frames), "--clip", clip, "--voronoi", "--output", "out", "--quiet")
            cells = self.cells("volume")
            self.assertEqual({f: set(found) for f, found in cells.items()},
                             {f: set(points) for f, points in enumerate(frames) if points})
            for f, found in cells.items():
                self.assertAlmostEqual(sum(found.values()), volume, delta=1e-11, msg=(clip, f))

    def test_what_is_inside_is_as_without_a_clip(self):
        frames = wander(2, 4, 30, 5)
        name = self.xyz_of(frames)
        self.succeed("replay", name, "--voronoi", "--changes", "--output", "out", "--quiet")
        without = self.table("out", "voronoi.csv")
        changes = self.table("out", "changes.csv")
        self.succeed("replay", name, "--clip", "-9,-9,9,9", "--voronoi", "--changes", "--output", "out", "--quiet")
        self.assertEqual(self.table("out", "changes.csv"), changes)
        cells, same = self.cells(), 0
        for row in without:
            area = cells[int(row["frame"])][int(row["id"])]
            if row["area"] and float(row["area"]) < 0.1:
                same += 1
                self.assertAlmostEqual(area / float(row["area"]), 1, delta=1e-9)
            elif not row["area"]:
                self.assertLess(area, 18 ** 2)
        self.assertGreater(same, 20)

    def test_the_page_shows_and_counts_what_is_clipped(self):
        """Cells are white where the clip takes something of them; all others have the area that they have without."""
        name = self.xyz_of(wander(2, 3, 150, 6))
        self.succeed("replay", name, "--voronoi", "--output", "out", "--quiet")
        without = {row["id"]: row for row in self.table("out", "voronoi.csv") if row["frame"] == "2"}
        for clip in ("0.25,0.25,0.75,0.75", "polygon:0.2,0.2,0.9,0.3,0.5,0.8",
                     "half-spaces:-1,0,0.25,0,-1,0.25,1,1,-1.25"):
            with self.subTest(clip):
                self.succeed("replay", name, "--clip", clip, "--voronoi", "--output", "out", "--quiet")
                page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
                drawn = whole = six = 0
                for row in self.table("out", "voronoi.csv"):
                    if row["frame"] != "2":
                        continue
                    drawn += float(row["area"]) > 0
                    before = without[row["id"]]["area"]
                    if before and float(row["area"]) > float(before) * (1 - 1e-9):
                        whole += 1
                        six += row["neighbours"] == "6"
                self.assertGreater(whole, 5)
                self.assertIn(f"{six} of the {whole} inner", page)
                self.assertIn("share of the cells wholly inside (%)", page)
                self.assertIn("</svg>cut by the clipping region</span>", page)
                self.assertNotIn("at the border", page)
                last = page.split('aria-label="Clipped Voronoi cells, frame 2"')[1].split("</svg>")[0]
                faces = dict(re.findall(r'class="face n(\d)" stroke-width="\d+" d="([^"]*)"', last))
                self.assertEqual(sum(d.count("M") for d in faces.values()), drawn)
                self.assertEqual(faces["5"].count("M"), drawn - whole)

    def test_where_it_is_said(self):
        """In the summary, on the page, on the terminal; the cells of .vtu files are clipped, too."""
        name = self.xyz_of(wander(2, 3, 12, 4))
        for clip, kind, rows, said in (
                ("0,0,1,2", "box", [[0, 0], [1, 2]], "a box from (0, 0) to (1, 2)"),
                ("polygon:0,0,2,0,0,2", "polygon", [[0, 0], [2, 0], [0, 2]], "a polygon with 3 corners"),
                ("half-spaces:-1,0,0,0,-1,0,1,1,-2", "half-spaces", [[-1, 0, 0], [0, -1, 0], [1, 1, -2]],
                 "3 half-spaces")):
            done = self.succeed("replay", name, "--clip", clip, "--voronoi", "--every", "1", "--output", "out")
            self.assertIn(f"clipped to {said}\n", done.stdout)
            self.assertEqual(self.summary("out")["clip"], {"kind": kind, "rows": rows})
            page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
            self.assertTrue(said in page and "Unbounded cells" not in page, clip)
            self.assertIn("In the last frame ", page)
            self.assertIn(" reach the clipping region, ", page)
            areas = tool.vtu_values(self.here / "out" / "frame-000000.vtu", "voronoi_area")
            self.assertAlmostEqual(sum(areas), 2, delta=1e-12)
        self.succeed("replay", name, "--voronoi", "--output", "out", "--quiet")
        self.assertNotIn("clip", self.summary("out"))

    def test_cells_that_reach_a_clip_are_counted(self):
        name = self.write("four.xyz", "4\n\n0 0\n1 0\n0 1\n1 1\n\n4\n\n0 0\n1 0\n0 1\n1 1.0625\n")
        for clip, said in (("-1,-1,2,2", "4 of 4 Voronoi cells reach the clipping region, none are wholly inside."),
                           ("5,4,6,5", "1 of 4 Voronoi cells reaches the clipping region, none are wholly inside.")):
            self.succeed("replay", name, "--clip", clip, "--voronoi", "--output", "out", "--quiet")
            self.assertIn("In the last frame " + said, self.page_of("out"))
        self.succeed("replay", name, "--clip", "0,0,1,1", "--neighbors", "--output", "out", "--quiet")
        self.assertNotIn("reach the clipping region", self.page_of("out"))

    def page_of(self, folder):
        return (self.here / folder / "report.html").read_text(encoding="utf-8")

    def test_refusals(self):
        name = self.xyz_of(wander(2, 2, 9, 1))
        for clip, words in (
                ("0,0,1", "3 numbers; in 2D a box has 4"), ("0,0,0,1,1,1", "6 numbers; in 2D a box has 4"),
                ("0,0,1,x", "--clip: 'x' is not a number"), ("0,0,1,inf", "'inf' is not a number"),
                ("1,0,0,1", "the lower corner"), ("0,0,0,1", "the lower corner"),
                ("polygon:0,0,1,1", "4 numbers; in 2D a polygon has 2 for each corner, and 3 corners at least"),
                ("polygon:0,0,1,0,1,1,0", "7 numbers"), ("polygon:0,0,2,0,1,0.5,1,2", "--clip: "),
                ("half-spaces:1,0,-1,0,1,-1", "6 numbers; in 2D a clip has 3 for each half-space, and 3 half-spaces"),
                ("half-spaces:1,0,-1,0,1,-1,1,1,-1", "do not bound it"),
                ("half-spaces:1,0,1,-1,0,1,0,1,0", "--clip: the half-spaces"),
                ("disc:1", "'disc' is no kind of clip")):
            with self.subTest(clip):
                said = self.refuse(2, "replay", name, "--clip", clip, "--voronoi", "--output", "out")
                self.assertIn("--clip", said)
                self.assertIn(words, said)
        self.assertIn("ask for one of them", self.refuse(2, "replay", name, "--clip", "0,0,1,1", "--output", "out"))
        self.assertIn("--output DIR", self.refuse(2, "replay", name, "--clip", "0,0,1,1", "--voronoi"))
        solid = self.write("solid.xyz", "4\nProperties=pos:R:3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        for clip, words in (("0,0,1,1", "4 numbers; in 3D a box has 6"), ("polygon:0,0,1,0,0,1", "in 3D")):
            self.assertIn(words, self.refuse(2, "replay", solid, "--clip", clip, "--voronoi", "--output", "out"))

    def test_a_periodic_box_has_none(self):
        lattice = 'Lattice="1 0 0 0 1 0 0 0 1" pbc="T T T" Properties=pos:R:3'
        name = self.write("boxed.xyz", f"2\n{lattice}\n0.25 0.25 0.25\n0.75 0.5 0.5\n")
        words = ("--clip", "0,0,0,1,1,1", "--voronoi", "--output", "out")
        for more in ((), ("--box", "1,1,1")):
            self.assertIn("in a periodic box every Voronoi cell is bounded",
                          self.refuse(2, "replay", name, *words, *more))
        self.succeed("replay", name, *words, "--open", "--quiet")
        self.assertAlmostEqual(sum(self.cells("volume")[0].values()), 1, delta=1e-13)


if __name__ == "__main__":
    tool.main(__doc__)
