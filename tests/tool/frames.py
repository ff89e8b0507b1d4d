# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions for tests of what is written for every frame, and a reader of what was written."""

import csv
import itertools
import random
import xml.etree.ElementTree
from fractions import Fraction

import tool

try:
    import scipy.spatial
except ImportError:
    scipy = None
try:
    import vtk
except ImportError:
    vtk = None


def determinant(m):
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return sum((-1) ** i * row[0] * determinant([r[1:] for k, r in enumerate(m) if k != i])
               for i, row in enumerate(m) if row[0])


UNIT = 2 ** 20  # coordinates are multiples of 1/UNIT, so that the oracles count in integers


def delaunay_pairs(points):
    """Neighbours in the Delaunay triangulation of {id: point} in general position: simplices with empty spheres, in
    integers."""
    exact = {i: [int(UNIT * c) for c in p] for i, p in points.items()}
    assert all(c == UNIT * x for i, p in points.items() for c, x in zip(exact[i], p))
    lifted = {i: p + [sum(c * c for c in p), 1] for i, p in exact.items()}
    d = len(next(iter(exact.values())))
    pairs = set()
    for simplex in itertools.combinations(sorted(exact), d + 1):
        turn = determinant([exact[i] + [1] for i in simplex])
        rows = [lifted[i] for i in simplex]
        if all(turn * determinant(rows + [lifted[j]]) < 0 for j in exact if j not in simplex):
            pairs |= set(itertools.combinations(simplex, 2))
    return pairs


def voronoi_cells(points, clip):
    """The polygon of each Voronoi cell of {id: point} in 2D, clipped to a convex polygon, in rationals."""
    exact = {i: [Fraction(c) for c in p] for i, p in points.items()}
    cells = {}
    for i, p in exact.items():
        cell = [[Fraction(c) for c in corner] for corner in clip]
        for j, q in exact.items():
            if i == j:
                continue
            side = [sum((p[k] - q[k]) * (2 * v[k] - p[k] - q[k]) for k in (0, 1)) for v in cell]
            clipped = []
            for k, v in enumerate(cell):
                n = (k + 1) % len(cell)
                if side[k] >= 0:
                    clipped.append(v)
                if side[k] * side[n] < 0:
                    t = side[k] / (side[k] - side[n])
                    clipped.append([v[m] + t * (cell[n][m] - v[m]) for m in (0, 1)])
            cell = clipped
        cells[i] = cell
    return cells


def polygon_area(polygon):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(polygon, polygon[1:] + polygon[:1])) / 2


def voronoi_areas(points):
    """The area of each cell of {id: point} in 2D, None for cells that leave a far box."""
    far = Fraction(10) ** 9
    cells = voronoi_cells(points, [[-far, -far], [far, -far], [far, far], [-far, far]])
    return {i: None if any(abs(c) == far for v in cell for c in v) else float(polygon_area(cell))
            for i, cell in cells.items()}


def wander(d, frames, points, seed, step=0.03):
    """Frames as {id: point}: points walk, some leave, others arrive; ids are not indices."""
    dice = random.Random(seed)
    place = lambda: [dice.randrange(UNIT) / UNIT for _ in range(d)]
    now = {3 * i + 7: place() for i in range(points)}
    fresh = 5000
    result = []
    for _ in range(frames):
        result.append({i: list(p) for i, p in now.items()})
        now = {i: [round((c + step * dice.gauss(0, 1)) * UNIT) / UNIT for c in p] for i, p in now.items()}
        for _ in range(dice.randrange(3)):
            if len(now) > 3:
                del now[dice.choice(sorted(now))]
        for _ in range(dice.randrange(3)):
            now[fresh] = place()
            fresh -= 1  # an id below the earlier ones
    return result


class FrameTest(tool.ToolTest):
    def xyz_of(self, frames, seed=0):
        """Extended XYZ with quoted properties, ids out of order."""
        text = ""
        for f, frame in enumerate(frames):
            order = list(frame.items())
            random.Random(seed + f).shuffle(order)
            d = len(order[0][1]) if order else 2
            text += f'{len(order)}\nProperties="id:I:1:mass:R:1:pos:R:{d}" Time={f}\n'
            text += "".join(f"{i} 1.5 {' '.join(map(repr, p))}\n" for i, p in order)
        return self.write("motion.xyz", text)

    def table(self, *names):
        with open(self.here.joinpath(*names), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def changes(self, directory="out"):
        """{frame: (made, broken)}"""
        result = {}
        for row in self.table(directory, "changes.csv"):
            made, broken = result.setdefault(int(row["frame"]), (set(), set()))
            pair = (int(row["first"]), int(row["second"]))
            self.assertLess(*pair)
            kind = {"made": made, "broken": broken}[row["change"]]
            self.assertNotIn(pair, kind)
            kind.add(pair)
        return result

    def check_changes(self, pairs, directory="out"):
        """Of frames with these neighbours."""
        said = self.changes(directory)
        for f in range(1, len(pairs)):
            made, broken = said.pop(f, (set(), set()))
            self.assertEqual(made, pairs[f] - pairs[f - 1], f)
            self.assertEqual(broken, pairs[f - 1] - pairs[f], f)
        self.assertEqual(said, {})

    def series(self, directory="out"):
        root = xml.etree.ElementTree.parse(self.here / directory / "frames.pvd").getroot()
        return [(int(e.get("timestep")), e.get("file")) for e in root.iter("DataSet")]
