# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions in periodic boxes, a reader of what replay writes of them, and areas and pairs by clipping."""

import itertools
import math
from fractions import Fraction

import frames


def added(point, shift, box):
    return [c + sum(s * v[k] for s, v in zip(shift, box)) for k, c in enumerate(point)]


def cells_2d(points, box, reach=3):
    """By clipping with bisectors in rationals: {id: area} and {(i, j, shift): length} of facets that are not empty,
    i < j, or i = j and shift > 0."""
    far = Fraction(10) ** 6
    exact = {i: [Fraction(c) for c in p] for i, p in points.items()}
    exact_box = [[Fraction(c) for c in v] for v in box]
    middle = {i: around_origin(p, exact_box) for i, p in exact.items()}
    areas, lengths = {}, {}
    for i, (p, turned) in middle.items():
        # Corners, each with the name of the side after it.
        cell = [([x, y], None) for x, y in ((-far, -far), (far, -far), (far, far), (-far, far))]
        for j, (r, turned_j) in middle.items():
            for shift in itertools.product(range(-reach, reach + 1), repeat=2):
                if i == j and shift == (0, 0):
                    continue
                q = added(r, shift, exact_box)
                side = [sum((p[k] - q[k]) * (2 * v[k] - p[k] - q[k]) for k in (0, 1)) for v, _ in cell]
                clipped = []
                for k, (v, name) in enumerate(cell):
                    n = (k + 1) % len(cell)
                    crossing = None
                    if side[k] * side[n] < 0:
                        t = side[k] / (side[k] - side[n])
                        crossing = [v[m] + t * (cell[n][0][m] - v[m]) for m in (0, 1)]
                    leaves = side[n] < 0
                    new = (j, tuple(s + a - b for s, a, b in zip(shift, turned, turned_j)))
                    if side[k] > 0:
                        clipped.append((v, name))
                    elif side[k] == 0:
                        clipped.append((v, new if leaves else name))
                    if crossing:
                        clipped.append((crossing, new if leaves else name))
                cell = clipped
        corners = [v for v, _ in cell]
        areas[i] = float(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1])) / 2)
        for k, (v, (j, shift)) in enumerate(cell):
            w = cell[(k + 1) % len(cell)][0]
            if v != w and (i < j or (i == j and shift > (0, 0))):
                length = math.hypot(float(v[0] - w[0]), float(v[1] - w[1]))
                lengths[i, j, shift] = lengths.get((i, j, shift), 0) + length
    return areas, lengths


def around_origin(p, box):
    """The image of the point with shares from 0 to 1, and which multiples of the vectors were taken away; in 2D."""
    det = box[0][0] * box[1][1] - box[0][1] * box[1][0]
    shares = [(p[0] * box[1][1] - p[1] * box[1][0]) / det, (p[1] * box[0][0] - p[0] * box[0][1]) / det]
    turns = [math.floor(s) for s in shares]
    return added(p, [-t for t in turns], box), turns


class BoxedTest(frames.FrameTest):
    def lattice_xyz(self, name, motion, boxes, pbc="T T T"):
        """Frames of {id: point} in extended XYZ, with z = 0 where points are flat."""
        text = ""
        for frame, box in zip(motion, boxes):
            rows = [list(v) + [0.0] * (3 - len(v)) for v in box] + [[0.0, 0.0, 1.0]] * (3 - len(box))
            text += (f'{len(frame)}\nLattice="{" ".join(repr(float(c)) for v in rows for c in v)}" pbc="{pbc}" '
                     "Properties=id:I:1:pos:R:3\n")
            for i, p in frame.items():
                text += f"{i} {' '.join(repr(float(c)) for c in (list(p) + [0.0])[:3])}\n"
        return self.write(name, text)

    def pairs(self, directory="out"):
        """{frame: {(i, j, shift): measure}}"""
        result = {}
        for row in self.table(directory, "pairs.csv"):
            shift = tuple(int(row[s]) for s in ("s1", "s2", "s3") if s in row)
            key = (int(row["first"]), int(row["second"]), shift)
            found = result.setdefault(int(row["frame"]), {})
            self.assertNotIn(key, found)
            found[key] = float(row["area" if "s3" in row else "length"])
        return result

    def shifted_changes(self, directory="out"):
        """{frame: (made, broken)} of (i, j, shift)"""
        result = {}
        for row in self.table(directory, "changes.csv"):
            made, broken = result.setdefault(int(row["frame"]), (set(), set()))
            shift = tuple(int(row[s]) for s in ("s1", "s2", "s3") if s in row)
            {"made": made, "broken": broken}[row["change"]].add((int(row["first"]), int(row["second"]), shift))
        return result

    def voronoi(self, directory="out"):
        result = {}
        for row in self.table(directory, "voronoi.csv"):
            self.assertEqual(row["unbounded"], "0")
            cell = (float(row.get("area") or row["volume"]), int(row["neighbours"]))
            result.setdefault(int(row["frame"]), {})[int(row["id"])] = cell
        return result
