# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus.lloyd` in polygons with holes, and under densities that are arrays or functions, beside fractions."""

import itertools
from fractions import Fraction

import annulus
import numpy as np
import pytest

RINGS = [[(0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 4), (0, 4)],
         [(0.25, 0.25), (1.25, 0.25), (1.25, 1.25), (0.25, 1.25)]]


def clipped(ring, height):
    """The part of a ring where height <= 0; by Green's theorem doubled edges do not count."""
    cut = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        h, k = height(a), height(b)
        if h <= 0:
            cut.append(a)
        if (h > 0) != (k > 0):
            cut.append(tuple(x + h / (h - k) * (y - x) for x, y in zip(a, b)))
    return cut


def cells(points, ring):
    """The parts of a ring nearest to each point."""
    x = [tuple(map(Fraction, p)) for p in points]
    for p in x:
        cell = [tuple(map(Fraction, c)) for c in ring]
        for q in x:
            if q != p:
                cell = clipped(cell, lambda c, p=p, q=q: sum((b - a) * (2 * z - a - b) for a, b, z in zip(p, q, c)))
        yield cell


def integrals(ring, density):
    """Of the density, and of it times x and y: exact where the density is a polynomial of degree 2."""
    rule = [(Fraction(-9, 16), (Fraction(1, 3),) * 3)] + [
        (Fraction(25, 48), tuple(Fraction(3 if i == k else 1, 5) for i in range(3))) for k in range(3)]
    sums = [Fraction(0)] * 3
    for b, c in zip(ring[1:], ring[2:]):
        a = ring[0]
        area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
        for weight, share in rule:
            p = tuple(sum(s * z for s, z in zip(share, axis)) for axis in zip(a, b, c))
            mass = area * weight * density(p)
            for i, factor in enumerate((1, *p)):
                sums[i] += mass * factor
    return sums


def test_an_l_with_a_hole():
    rng = np.random.default_rng(3)
    x = annulus.lloyd(40, 0, domain=RINGS, seed=5).points
    first = annulus.lloyd(x, 1, domain=RINGS).points
    closed = [np.array(ring + ring[:1])[::-1] for ring in RINGS[::-1]]
    assert np.array_equal(first, annulus.lloyd(x, 1, domain=closed, threads=2, strategy="rebuild").points)
    exact = 0
    for outer, hole, moved in zip(cells(x, RINGS[0]), cells(x, RINGS[1]), first):
        sums = [a - b for a, b in zip(integrals(outer, lambda p: 1), integrals(hole, lambda p: 1))]
        centroid = [float(s / sums[0]) for s in sums[1:]]
        inside = [not 0.25 < c < 1.25 for c in centroid]
        if any(inside) and min(centroid) < 1.5:
            assert moved == pytest.approx(centroid, abs=1e-13)
            exact += 1
    assert exact > 20
    r = annulus.lloyd(200, 10, domain=RINGS, seed=int(rng.integers(100))).points
    assert ((r[:, 0] < 1.5) | (r[:, 1] < 1.5)).all() and not ((abs(r - 0.75) < 0.5).all(axis=1)).any()
    assert annulus.lloyd(50, 2, domain=RINGS[0]).points.shape == (50, 2)


def bilinear(weights, lower, pixel):
    """The density of an array, its first row on top, as (rectangle, function) where it is one polynomial."""
    rows, columns = weights.shape
    node = [[int(weights[rows - 1 - min(max(j, 0), rows - 1), min(max(i, 0), columns - 1)])
             for i in range(-1, columns + 1)] for j in range(-1, rows + 1)]
    middle = [[lower[k] + pixel[k] * Fraction(2 * i - 1, 2) for i in range(n + 2)]
              for k, n in enumerate((columns, rows))]
    for i, j in itertools.product(range(columns + 1), range(rows + 1)):
        left, below = middle[0][i], middle[1][j]

        def at(p, i=i, j=j, left=left, below=below):
            s, t = (p[0] - left) / pixel[0], (p[1] - below) / pixel[1]
            return ((1 - t) * ((1 - s) * node[j][i] + s * node[j][i + 1])
                    + t * ((1 - s) * node[j + 1][i] + s * node[j + 1][i + 1]))

        yield (left, below, left + pixel[0], below + pixel[1]), at


def test_an_array_is_a_density_of_exact_integrals():
    rng = np.random.default_rng(8)
    lower, upper = (Fraction(-1), Fraction(1, 2)), (Fraction(2), Fraction(5, 2))
    ring = [(-1, 0.5), (2, 0.5), (2, 2.5), (-1, 2.5)]
    x = rng.random((6, 2)) * [3, 2] + [-1, 0.5]
    for shape in ((1, 1), (2, 4), (5, 3)):
        weights = rng.integers(0, 9, shape) + np.eye(*shape, dtype=int)
        pixel = [(b - a) / n for a, b, n in zip(lower, upper, shape[::-1])]
        moved = annulus.lloyd(x, 1, domain=ring, density=weights).points
        assert np.array_equal(moved, annulus.lloyd(x, 1, domain=ring, density=weights / 16).points)
        for cell, target in zip(cells(x, ring), moved):
            sums = [Fraction(0)] * 3
            for (a, b, c, d), at in bilinear(weights, lower, pixel):
                part = cell
                for height in (lambda p, a=a: a - p[0], lambda p, b=b: b - p[1], lambda p, c=c: p[0] - c,
                               lambda p, d=d: p[1] - d):
                    part = clipped(part, height)
                sums = [s + t for s, t in zip(sums, integrals(part, at))]
            assert target == pytest.approx([float(s / sums[0]) for s in sums[1:]], abs=1e-12), shape


def test_an_array_in_an_l_and_points_that_follow_it():
    weights = np.zeros((8, 8))
    weights[6:, :] = 1  # below
    r = annulus.lloyd(300, 5, domain=RINGS, density=weights, seed=1).points
    assert (r[:, 1] < 1.26).all() and np.array_equal(r, annulus.lloyd(300, 5, domain=RINGS, density=weights, seed=1,
                                                                      threads=2).points)


def test_a_function_is_a_density():
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    x = np.random.default_rng(2).uniform(-1, 1, (50, 2))
    named = annulus.lloyd(x, 1, domain=square, density="x2").points
    assert annulus.lloyd(x, 1, domain=square, density=lambda p: p[:, 0] ** 2).points == pytest.approx(named, abs=2e-5)
    seen = []
    annulus.lloyd(9, 1, domain=[(0, 0), (2, 0), (2, 1), (0, 1)], density=lambda p: seen.append(p) or p[:, 0])
    assert len(seen) == 1 and seen[0].shape == (1024 * 512, 2)
    assert (seen[0][0] == [1 / 1024, 1 - 1 / 1024]).all() and (seen[0].max(axis=0) < [2, 1]).all()
    annulus.lloyd(x, 1, density=lambda p: 1 + p[:, 1])  # in the convex hull
    annulus.lloyd(9, 1, domain="square", radius=2, density=np.ones((3, 3)))


def test_what_is_refused():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for density, domain, code, words in ((np.ones(3), square, "wrong_size", "rows, columns"),
                                         (np.zeros((2, 2)), square, "bad_input", "above 0"),
                                         (-np.eye(2), square, "bad_input", "at least 0"),
                                         (np.full((2, 2), np.nan), square, "not_finite", "finite"),
                                         (np.ones((2, 2)), None, "usage", "polygon"),
                                         (np.ones((2, 2)), "disc", "usage", "polygon"),
                                         (lambda p: p, square, "wrong_size", "as many values"),
                                         ("one", [square, [[0.5, 0.5, 1]] * 3], "wrong_size", "ring 1"),
                                         ("one", [square, [(0.5, 0.5), (2, 0.5), (0.5, 0.75)]], "bad_input",
                                          "corners 1 and 4"),
                                         ("one", [(0, 0), (2, 2), (2, 0), (0, 2)], "bad_input", "corners 0 and 2")):
        with pytest.raises(annulus.Error, match=words) as e:
            annulus.lloyd(20, 1, density=density, domain=domain)
        assert e.value.code == code
    with pytest.raises(TypeError, match="density must be an array of numbers"):
        annulus.lloyd(20, 1, density=[["a"]], domain=square)
