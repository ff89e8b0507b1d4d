#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages say that a run found, against lattices and energies in closed form. usage: test_findings.py --tool=PATH
[CLASS[.METHOD]...]"""

import html
import json
import math
import random
import re

import tool


def extents(path):
    """The least and the largest x and y of outlines: `M` with a corner, `l` with the ways to the others."""
    corners = []
    for outline in path.split("M")[1:]:
        at = [0, 0]
        numbers = list(map(int, re.findall(r"-?\d+", outline)))
        for way in zip(numbers[::2], numbers[1::2]):
            at = [a + b for a, b in zip(at, way)]
            corners.append(at)
    return [choose(values) for values in zip(*corners) for choose in (min, max)]


class Findings(tool.ToolTest):
    def page(self, *words):
        self.succeed(*words, "--output", "out", "--force", "--quiet")
        return (self.here / "out" / "report.html").read_text(encoding="utf-8")

    def found(self, *words):
        return html.unescape(" ".join(re.findall(r'<p class="finding">(.*?)</p>', self.page(*words))))

    def lattice(self, name, places, head=""):
        """Three frames; the points go half a spacing in each."""
        self.write(name, "".join(f"{len(places)}\n{head}\n" + "".join(f"A {x + f / 2} {y} 0\n" for x, y in places)
                                 for f in range(3)))
        return name

    def test_squares_have_four_neighbours(self):
        """An edge of the triangulation whose facet is exactly empty makes no neighbours."""
        places = [(x, y) for x in range(6) for y in range(6)]
        self.assertIn("All 16 inner vertices have four or fewer neighbours at the end (100 % at the start). The least "
                      "angle of a triangle stayed at 45 degrees",
                      self.found("replay", self.lattice("a.xyz", places)))
        box = 'Lattice="6 0 0 0 6 0 0 0 1" Properties=species:S:1:pos:R:3 pbc="T T F"'
        self.assertIn("All 36 vertices have four or fewer neighbours at the end",
                      self.found("replay", self.lattice("b.xyz", places, box)))

    def test_hexagons_have_six(self):
        # Rows 7/8 apart: all triangles are alike, and no four points are on a circle.
        places = [(x + (y % 2) / 2, 0.875 * y) for x in range(6) for y in range(6)]
        angle = math.degrees(2 * math.atan(0.5 / 0.875))
        box = 'Lattice="6 0 0 0 5.25 0 0 0 1" Properties=species:S:1:pos:R:3 pbc="T T F"'
        said = self.found("replay", self.lattice("c.xyz", places, box))
        self.assertIn("All 36 vertices have six neighbours at the end (100 % at the start)", said)
        self.assertIn(f"stayed at {angle:.1f} degrees on average", said)
        self.assertNotIn("at the border", self.page("replay", "c.xyz"))  # a periodic box has none
        self.assertIn("In the 2 frames after the first, points moved by", said)

    def test_the_energy_of_a_square_lattice(self):
        """Four points move to the middles of four squares."""
        self.write("d.xyz", "".join(f"{x} {y}\n" for x, y in ((-0.4, -0.5), (0.5, -0.5), (-0.4, 0.5), (0.5, 0.5))))
        said = self.found("lloyd", "--input", "d.xyz", "--domain", "square", "--iterations", 60)
        start = 0  # two columns of two rectangles; the border between them is at 0.05
        for low, high, site in ((-1, 0.05, -0.4), (0.05, 1, 0.5)):
            across = ((high - site) ** 3 - (low - site) ** 3) / 3
            start += 2 * (across * 1 + (high - low) / 12)
        end = 4 * (2 / 12)
        self.assertIn(f"the energy is {100 * end / start:.1f} % of that at the start", said)

    def test_large_and_small_lengths(self):
        for radius in ("1e-90", "1e90"):
            text = self.page("lloyd", "--points", 50, "--radius", radius, "--iterations", 3)
            self.assertNotRegex(text.split("<script>")[0], r"(?i)\b(nan|inf)\b")
            self.assertIn("six neighbours at the end", text)

    def test_the_mean_spacing_is_of_what_the_page_says(self):
        places = [(x, 2 * y) for x in range(4) for y in range(5)]
        box = 'Lattice="8 0 0 0 20 0 0 0 1" Properties=species:S:1:pos:R:3 pbc="T T F"'
        for words, length, said in (
                (["lloyd", "--points", 50, "--domain", "square", "--radius", 3, "--iterations", 1],
                 math.sqrt(36 / 50), "square root of the area of the domain per vertex"),
                (["lloyd", "--points", 50, "--domain", "box", "--size", "1,2,3", "--iterations", 1],
                 (6 / 50) ** (1 / 3), "cube root of the volume of the domain per vertex"),
                (["lloyd", "--points", 50, "--box", "1,2", "--iterations", 1],
                 math.sqrt(2 / 50), "square root of the area of the periodic box per vertex"),
                (["replay", self.lattice("open.xyz", places)],
                 math.sqrt(3 * 8 / 20), "square root of the area of the bounding box of the points in the first frame"),
                (["replay", self.lattice("box.xyz", places, box)],
                 math.sqrt(8 * 20 / 20), "square root of the area of the periodic box in the first frame, per point")):
            with self.subTest(words=words):
                page = self.page(*words)
                self.assertIn("<dt>Mean spacing</dt><dd>The unit of lengths: the " + said, page)
                summary = json.loads((self.here / "out" / "summary.json").read_text(encoding="utf-8"))
                self.assertAlmostEqual(summary["mean_spacing"], length, delta=1e-12)

    def test_inner_vertices_are_not_on_the_hull(self):
        """Those in the middle of its edges are on it."""
        page = self.page("replay", self.lattice("h.xyz", [(x, y) for x in range(6) for y in range(6)]))
        self.assertIn("those that are not on the convex hull", page)
        self.assertIn("</svg>unbounded</span>", page)
        white = re.findall(r'class="face n5" stroke-width="\d+" d="([^"]*)"', page)
        self.assertEqual([d.count("M") for d in white], [20, 20])

    def test_one_and_two_points(self):
        for places in ([(0, 0)], [(0, 0), (1, 0)], [(0, 0), (1, 0), (2, 0)]):
            self.assertIn("In the 2 frames after the first, points moved",
                          self.found("replay", self.lattice("e.xyz", places)))

    def test_of_many_cells_a_window_is_drawn(self):
        text = self.page("lloyd", "--points", 7000, "--iterations", 0)
        self.assertRegex(text, r"Voronoi cells at the start: the 2,\d{3} cells in a window in the middle, of 7,000\.")
        drawn = sum(d.count("M") for d in re.findall(r'class="face n\d" stroke-width="\d+" d="([^"]*)"', text))
        self.assertGreater(drawn, 2400)
        self.assertLess(drawn, 3400)

    def test_cells_that_the_domain_cuts_are_at_the_border(self):
        """Of 8 x 8 points, shaken a little: those along the sides and around a hole, not only those of the hull."""
        dice = random.Random(tool.SEED)
        places = [(x - 3.5 + dice.uniform(-0.05, 0.05), y - 3.5 + dice.uniform(-0.05, 0.05))
                  for x in range(8) for y in range(8)]
        self.write("shaken.xyz", "".join(f"{x!r} {y!r}\n" for x, y in places))
        square = "".join(f"{x} {y}\n" for x, y in ((-4, -4), (4, -4), (4, 4), (-4, 4)))
        hole = "".join(f"{x} {y}\n" for x, y in ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)))
        self.write("square.xyz", square)
        self.write("hole.xyz", square + "\n" + hole)
        cut = {"square.xyz": 28, "hole.xyz": 28 + 4}  # around the hole, in the middle, there are four
        for domain, border in cut.items():
            text = self.page("lloyd", "--input", "shaken.xyz", "--domain", domain, "--iterations", 1)
            drawn = [sum(d.count("M") for d in re.findall(rf'class="face n{shade}" stroke-width="\d+" d="([^"]*)"',
                                                          text.split("Voronoi cells before")[1])) for shade in range(6)]
            self.assertEqual(border, drawn[5], domain)
        text = self.page("lloyd", "--points", 100, "--iterations", 2, "--voronoi")
        self.assertIn("cells of voronoi.csv, which the domain does not cut", text)
        # Every cell that the circle cuts is white: the others are convex polygons of few corners.
        text = self.page("lloyd", "--points", 100, "--iterations", 20)
        for d in re.findall(r'class="face n[0-4]" stroke-width="\d+" d="([^"]*)"', text):
            for outline in d.split("M")[1:]:
                self.assertLess(len(re.findall(r"-?\d+", outline)) // 2, 14)
        self.assertRegex(text, r'class="face n5"')
        self.assertIn("inner vertices", text)

    def test_all_cuts_of_a_motion_are_across_one_axis(self):
        """The box is lowest along z at first, then along x."""
        dice = random.Random(tool.SEED)
        places = [[dice.random() for _ in range(3)] for _ in range(40)]
        self.write("m.xyz", "".join("40\n\n" + "".join(f"A {x * s} {y * 2} {z}\n" for x, y, z in places)
                                    for s in (3, 1.5, 0.5)))
        text = self.page("replay", "m.xyz")
        middle = (min(z for _, _, z in places) + max(z for _, _, z in places)) / 2
        cuts = re.findall(r"<figcaption>Frame (\d), cut at (\w) = ([\d.]+), \d+ cut edges</figcaption>", text)
        self.assertEqual([cut[:2] for cut in cuts], [("0", "z"), ("1", "z"), ("2", "z")])
        for cut in cuts:
            self.assertAlmostEqual(float(cut[2]), middle, delta=1e-3)
        self.assertNotIn('class="dots"', text)  # a cut shows no vertices

    def test_volumes_of_cells_in_a_3d_box(self):
        """Four bars, two of them broader at the start."""
        self.write("v.xyz", "".join(f"{x} {y} 0.5\n" for x, y in ((0.3, 0.25), (0.8, 0.25), (0.3, 0.75), (0.8, 0.75))))
        left = (0.3 + 0.8) / 2
        start = 100 * abs(left - 0.5) / 0.5
        words = ["--domain", "box", "--size", "1,1,1", "--input", "v.xyz"]
        said = self.found("lloyd", *words, "--iterations", 40)
        self.assertIn(f"at the end (standard deviation), by {start:.3g} % at the start", said)

    def test_without_an_iteration_there_is_one_picture(self):
        for words in (["--points", 50], ["--points", 50, "--domain", "box", "--size", "1,1,1"],
                      ["--points", 50, "--box", "1,1"], ["--points", 50, "--box", "1,1,1"]):
            with self.subTest(words=words):
                page = self.page("lloyd", *words, "--iterations", 0)
                self.assertIn("At the start, and at the end: there was no iteration", page)
                self.assertNotIn("After 0", page)
                self.assertNotIn(">Before", page)

    def test_cells_are_drawn_in_the_periodic_box(self):
        """Points that leave the box are images: the picture stays where it was."""
        places = [(x, y) for x in range(6) for y in range(6)]
        box = 'Lattice="6 0 0 0 6 0 0 0 1" Properties=species:S:1:pos:R:3 pbc="T T F"'
        page = self.page("replay", self.lattice("w.xyz", [(x + 60, y) for x, y in places], box))
        shown = re.findall(r'class="face n\d" stroke-width="\d+" d="([^"]*)"', page)
        self.assertEqual(len(shown), 2)  # of the first and of the last frame: a step of a whole spacing
        for first, last in zip(extents(shown[0]), extents(shown[1])):
            self.assertAlmostEqual(first, last, delta=10)  # of 10,000

    def test_boxes_and_domains_have_an_outline(self):
        """Cells and triangulation, before and after; of a domain the triangulation alone, whose cells end at it."""
        for words, count in ((["--box", "1,0.2,0,1"], 4), (["--box", "1,1,1"], 2), ([], 2),
                             (["--domain", "box", "--size", "1,2,1"], 2)):
            with self.subTest(words=words):
                page = self.page("lloyd", "--points", 60, *words, "--iterations", 3)
                self.assertEqual(count, page.count('class="outline"'))

    def test_a_periodic_triangulation_has_no_point_without_an_edge(self):
        page = self.page("lloyd", "--points", 60, "--box", "1,1", "--iterations", 1)
        after = page.split("<h2>The triangulation</h2>")[1]
        edges = re.search(r'class="edges" stroke-width="\d+" d="([^"]*)"', after)[1]
        dots = re.search(r'class="dots" stroke-width="\d+" d="([^"]*)"', after)[1]
        corners = set()
        for trail in edges.split("M")[1:]:
            at = [0, 0]
            numbers = list(map(int, re.findall(r"-?\d+", trail)))
            for way in zip(numbers[::2], numbers[1::2]):
                at = [a + b for a, b in zip(at, way)]
                corners.add(tuple(at))
        shown = re.findall(r"M(-?\d+) ?(-?\d+)h0", dots)
        self.assertGreater(len(shown), 60)
        self.assertLessEqual({(int(x), int(y)) for x, y in shown}, corners)

    def test_a_cut_of_a_periodic_box_is_in_its_middle_but_not_in_a_layer(self):
        def frame(places):
            return (f'{len(places)}\nLattice="4 0 0 0 4 0 0 0 4" Properties=species:S:1:pos:R:3\n' +
                    "".join(f"A {x} {y} {z}\n" for x, y, z in places))

        dice = random.Random(tool.SEED)
        gas = [[4 * dice.random() for _ in range(3)] for _ in range(40)]
        self.write("g.xyz", frame(gas) + frame([[4 * dice.random() for _ in range(3)] for _ in range(40)]))
        self.assertEqual(["2", "2"], re.findall(r"cut at z = ([\d.]+)", self.cuts("g.xyz")))
        grid = [(x, y, z) for x in range(4) for y in range(4) for z in range(4)]
        self.write("l.xyz", frame(grid) * 2)
        first, second = re.findall(r"cut at z = ([\d.]+)", self.cuts("l.xyz"))
        self.assertEqual(first, second)
        self.assertTrue(2.1 < float(first) < 2.4, first)

    def cuts(self, name):
        return " ".join(re.findall(r"<figcaption>(Frame[^<]*)<", self.page("replay", name)))

    def test_points_that_a_box_carries_do_not_move_in_it(self):
        frames = []
        for tilt in (0, 0.3, 0.6):
            rows = "".join(f"A {(x + tilt * y / 4)!r} {y} 0\n" for x in range(4) for y in range(4))
            frames.append(f'16\nLattice="4 0 0 {tilt} 4 0 0 0 1" Properties=species:S:1:pos:R:3 pbc="T T F"\n{rows}')
        self.write("s.xyz", "".join(frames))
        page = self.page("replay", "s.xyz")
        self.assertIn("The box changed: its area is 16 at the end, as at the start", page)
        self.assertIn("from 90 to 81.5 degrees", page)
        self.assertRegex(page, r"In the 2 frames after the first, points did not move relative to the box(, but for "
                         r"rounding)?\.")
        self.assertNotIn("How far points go", page)

    def test_cells_outside_of_a_clip_have_no_area_in_its_curves(self):
        places = [(x, y) for x in range(12) for y in range(12)]
        page = self.page("replay", self.lattice("k.xyz", places), "--clip", "3.1,3.2,6.3,6.4", "--voronoi")
        curves = page.partition("The area of cells cut to the clipping region")[2].partition("</svg>")[0]
        bottom = re.search(r'<path class="grid" d="M[\d.]+ ([\d.]+)H', curves)[1]  # the axis
        shown = re.findall(r'class="curve c\d" d="([^"]*)"', curves)
        self.assertEqual(len(shown), 3)
        for curve in shown:
            self.assertNotIn(" " + bottom, curve)

    def test_no_line_crosses_a_cell(self):
        """A cell in a polygon that is not convex is made of parts; it is drawn as one."""
        self.write("l.xyz", "0 0\n4 0\n4 1.5\n1.5 1.5\n1.5 4\n0 4\n\n0.25 0.25\n1 0.25\n1 1\n0.25 1\n")
        text = self.page("lloyd", "--points", 200, "--domain", "l.xyz", "--iterations", 20)
        outlines = re.findall(r'class="face n\d" stroke-width="\d+" d="([^"]*)"', text)
        self.assertEqual(2 * 200, sum(d.count("M") for d in outlines))

    def test_other_tolerances_have_no_cells(self):
        """They need not be Delaunay."""
        text = self.page("lloyd", "--points", 50, "--iterations", 2, "--strategy", "paper", "--tolerance", "floating")
        self.assertNotIn("Voronoi cells", text)
        self.assertIn("In 2 iterations points moved by", text)


if __name__ == "__main__":
    tool.main(__doc__)
