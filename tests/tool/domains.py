# SPDX-License-Identifier: GPL-3.0-or-later
"""Domains for tests of Lloyd iterations, and exact centroids of cells in them, in rational arithmetic."""

import itertools
from fractions import Fraction

import frames
import tool

# An L with a square hole, in which there is a triangle.
L = [(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 4), (0, 4)]
HOLE = [(0.25, 0.25), (1.25, 0.25), (1.25, 1.25), (0.25, 1.25)]
ISLAND = [(0.5, 0.5), (1, 0.5), (0.75, 1)]
RINGS = [L, HOLE, ISLAND]


def in_ring(ring, p):
    """Even-odd rule; exact, for p on no horizontal line through a corner."""
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > p[1]) != (by > p[1]):
            inside ^= p[0] < ax + Fraction(p[1] - ay) * (bx - ax) / Fraction(by - ay)
    return inside


def in_rings(rings, p):
    p = [Fraction(c) for c in p]
    return sum(in_ring([[Fraction(c) for c in q] for q in ring], p) for ring in rings) % 2 == 1


def bisectors(sites, v):
    """Functions that are positive nearer to another site than to v."""
    for u, other in enumerate(sites):
        if u != v:
            normal = [2 * (b - a) for a, b in zip(sites[v], other)]
            bound = sum(b * b for b in other) - sum(a * a for a in sites[v])
            yield lambda p, n=normal, h=bound: sum(a * b for a, b in zip(n, p)) - h


def crossing(a, b, height):
    t = height(a) / (height(a) - height(b))
    return [x + t * (y - x) for x, y in zip(a, b)]


def centroid_2(rings, sites, v):
    """Of the part of the rings nearest to site v. A ring that is cut by a line, doubled edges and all, has by Green's
    theorem the integrals of its part."""
    mass, moment = 0, [0, 0]
    for k, ring in enumerate(rings):
        ring = [[Fraction(c) for c in p] for p in ring]
        if (sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])) > 0) != (k % 2 == 0):
            ring.reverse()
        for height in bisectors(sites, v):
            cut = []
            for a, b in zip(ring, ring[1:] + ring[:1]):
                if height(a) <= 0:
                    cut.append(a)
                if (height(a) > 0) != (height(b) > 0):
                    cut.append(crossing(a, b, height))
            ring = cut
        for a, b in zip(ring, ring[1:] + ring[:1]):
            w = a[0] * b[1] - a[1] * b[0]
            mass += w / 2
            for i in range(2):
                moment[i] += w * (a[i] + b[i]) / 6
    return mass, [m / mass for m in moment]


def cut_tetrahedron(corners, height):
    """Tetrahedra that fill the part of one where height <= 0."""
    inside = [p for p in corners if height(p) <= 0]
    outside = [p for p in corners if height(p) > 0]
    if not inside or not outside:
        return [inside] if inside else []
    across = {(i, o): crossing(p, q, height) for i, p in enumerate(inside) for o, q in enumerate(outside)}
    if len(inside) == 1:
        return [inside + list(across.values())]
    if len(inside) == 2:  # two triangles, and the prism between them
        one, two = ([p, across[i, 0], across[i, 1]] for i, p in enumerate(inside))
    else:
        one, two = inside, [across[i, 0] for i in range(3)]
    return [one + two[:1], one[1:] + two[:2], one[2:] + two]


def centroid_3(lower, upper, sites, v):
    """Of the part of a box nearest to site v."""
    pieces = []
    for order in itertools.permutations(range(3)):
        corner, tetrahedron = list(lower), [list(lower)]
        for k in order:
            corner[k] = upper[k]
            tetrahedron.append(list(corner))
        pieces.append([[Fraction(c) for c in p] for p in tetrahedron])
    for height in bisectors(sites, v):
        pieces = [part for piece in pieces for part in cut_tetrahedron(piece, height)]
    mass, moment = 0, [0, 0, 0]
    for a, *others in pieces:
        x, y, z = ([q - p for p, q in zip(a, b)] for b in others)
        size = abs(x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0])
                   + x[2] * (y[0] * z[1] - y[1] * z[0])) / 6
        mass += size
        for i in range(3):
            moment[i] += size * (a[i] + sum(b[i] for b in others)) / 4
    return mass, [m / mass for m in moment]


class DomainTest(frames.FrameTest):
    def rings(self, name, rings, between="\n"):
        return self.write(name, between.join("".join(f"{x!r} {y!r}\n" for x, y in ring) for ring in rings))

    def after_a_step(self, n, d, *words):
        self.succeed("lloyd", "--input", "a.xyz", "--iterations", 1, "--audit", 1, "--every", 1, "--output", "out",
                     "--force", "--quiet", *words)
        values = tool.vtu_values(self.here / "out" / "frame-000001.vtu", "Points")
        return [list(values[3 * i:3 * i + d]) for i in range(n)]

    def assert_near(self, found, expected, most):
        for a, b in zip(found, expected):
            self.assertLess(abs(Fraction(a) - b), most)
