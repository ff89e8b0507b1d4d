# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact results for one certificate, from its points and the definitions alone: integers, rational numbers and their
square roots.

Nothing here comes from the library, nor from its formulas: signs are determinants by elimination; widths are distances
of parallel lines and planes and of concentric circles and spheres, found by solving for their centres.
"""

import math
import struct
from fractions import Fraction as Q
from itertools import combinations

POINTS = {"orientation_2": 3, "empty_circle_2": 4, "orientation_3": 4, "empty_sphere_3": 5}
DIMENSION = {name: int(name[-1]) for name in POINTS}


# ---- Numbers -------------------------------------------------------------------------------------------------------

def exponent(x):
    """The least e with x an integer times 2^e, for a double x that is not 0."""
    n, d = x.as_integer_ratio()
    return (n & -n).bit_length() - 1 if d == 1 else 1 - d.bit_length()


def determinant(rows):
    """The determinant of an integer matrix, by Bareiss' elimination."""
    m, sign, last = [list(r) for r in rows], 1, 1
    for k in range(len(m) - 1):
        if m[k][k] == 0:
            other = next((i for i in range(k + 1, len(m)) if m[i][k] != 0), None)
            if other is None:
                return 0
            m[k], m[other], sign = m[other], m[k], -sign
        for i in range(k + 1, len(m)):
            for j in range(k + 1, len(m)):
                m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) // last
        last = m[k][k]
    return sign * m[-1][-1]


def next_up(x):
    """The next double above x >= 0."""
    return struct.unpack("<d", struct.pack("<q", struct.unpack("<q", struct.pack("<d", x))[0] + 1))[0]


def next_down(x):
    return struct.unpack("<d", struct.pack("<q", struct.unpack("<q", struct.pack("<d", x))[0] - 1))[0]


def root(x, bits=200):
    """A lower bound of the square root of x, a relative 2^-bits below it at most."""
    if x == 0:
        return Q(0)
    shift = max(0, 2 * bits - (x.numerator.bit_length() - x.denominator.bit_length()) + 2)
    shift += shift & 1
    return Q(math.isqrt((x.numerator << shift) // x.denominator), 1 << shift // 2)


def double_near(x):
    """A double near x >= 0: Python's division of integers is rounded correctly."""
    return x.numerator / x.denominator


# ---- Widths --------------------------------------------------------------------------------------------------------

class Slab:
    """Two parallel lines or planes; their distance squared."""

    def __init__(self, square):
        self.square = square

    def is_at_least(self, w):
        return w * w <= self.square

    def near(self):
        return root(self.square)


class Annulus:
    """Two concentric circles or spheres; their radii squared."""

    def __init__(self, r2, s2):
        self.r2, self.s2 = min(r2, s2), max(r2, s2)

    def is_at_least(self, w):  # w + r <= s  <=>  2 w r <= s^2 - r^2 - w^2
        rest = self.s2 - self.r2 - w * w
        return rest >= 0 and 4 * w * w * self.r2 <= rest * rest

    def near(self):
        roots = root(self.r2) + root(self.s2)
        return (self.s2 - self.r2) / roots if roots else Q(0)


def minus(x, y):
    return [a - b for a, b in zip(x, y)]


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def slab(normal, along):
    return Slab(Q(dot(normal, along) ** 2, dot(normal, normal))) if any(normal) else None


def slabs_of_simplex(x):
    """All slabs in which the certificate of a cell can fail: a facet and its vertex, in 3D also two opposite edges."""
    d = len(x[0])
    all = []
    for i in range(d + 1):
        rest = x[:i] + x[i + 1:]
        u = minus(rest[1], rest[0])
        normal = [-u[1], u[0]] if d == 2 else cross(u, minus(rest[2], rest[0]))
        all.append(slab(normal, minus(x[i], rest[0])))
    if d == 3:
        for i, j, k, l in ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2)):
            all.append(slab(cross(minus(x[j], x[i]), minus(x[l], x[k])), minus(x[k], x[i])))
    return [s for s in all if s]


def solve(rows, right):
    """The solution of a square system of integers as numerators and their common denominator; None where it is
    singular."""
    d = determinant(rows)
    if d == 0:
        return None
    return [determinant([r[:k] + [b] + r[k + 1:] for r, b in zip(rows, right)]) for k in range(len(rows))], d


def annulus(one, other):
    """The concentric circles or spheres through `one` and through `other`: (Annulus or Slab, whether `one` is on the
    inner one)."""
    rows, right = [], []
    for group in (one, other):
        for x in group[1:]:  # |x - c| = |group[0] - c|
            rows.append([2 * t for t in minus(x, group[0])])
            right.append(dot(x, x) - dot(group[0], group[0]))
    found = solve(rows, right)
    if found is None:  # parallel lines, or planes: the centre is at infinity
        u = [r for r in rows if any(r)]
        if len(one[0]) == 2:
            normal = [-u[0][1], u[0][0]]
        else:
            normal = next((n for a, b in combinations(u, 2) if any(n := cross(a, b))), [0, 0, 0])
        return slab(normal, minus(other[0], one[0])), False
    top, below = found
    radius = [Q(sum((below * t - c) ** 2 for t, c in zip(x, top)), below * below) for x in (one[0], other[0])]
    return Annulus(*radius), radius[0] < radius[1]


def obstacles(name, x):
    """The slabs and annuli whose least width is that of the certificate."""
    if name.startswith("orientation"):
        return slabs_of_simplex(x)
    if name == "empty_circle_2":
        a, b, p, q = x
        return [annulus([a, b], [p, q])[0]]
    a, b, c, p, q = x
    all, forward = [], True
    for one, other in (([a, b, c], [p, q]), ([a, b], [c, p, q]), ([c, a], [b, p, q]), ([b, c], [a, p, q])):
        found, inner = annulus(one, other)
        all.append(found)
        forward = forward and inner
    # An annulus with the wrong side inside is not an obstacle while both cells are positive: so they must remain
    # positive.
    if not forward:
        all += slabs_of_simplex([b, a, c, p]) + slabs_of_simplex([a, b, c, q])
    return [o for o in all if o]


# ---- Answers -------------------------------------------------------------------------------------------------------

def greatest_double(is_at_least, near):
    """The largest double not above the truth."""
    y = double_near(near)
    while y > 0 and not is_at_least(Q(y)):
        y = next_down(y)
    while is_at_least(Q(next_up(y))):
        y = next_up(y)
    return y


def hexadecimal(n):
    return hex(n)


def answer(name, points):
    """The exact results for the certificate `name` of these points, tuples of doubles, as in the columns of the
    files."""
    shift = min((exponent(c) for p in points for c in p if c != 0), default=0)
    unit = Q(2) ** shift
    x = [[int(Q(c) / unit) for c in p] for p in points]
    vectors = [minus(p, x[0]) for p in x[1:]]
    if name.startswith("orientation"):
        n, degree = determinant(vectors), len(points[0])
    else:
        degree = len(points[0]) + 2
        n = -determinant([v + [dot(v, v)] for v in vectors])
    sign = (n > 0) - (n < 0)
    e = shift * degree
    if n:
        zeros = (n & -n).bit_length() - 1
        n, e = n >> zeros if n > 0 else -(-n >> zeros), e + zeros
    else:
        e = 0
    row = {"sign": str(sign), "determinant": hexadecimal(n), "exponent": str(e), "tolerance": float.hex(0.0),
           "tolerance_decimal": "0", "width_lower": float.hex(0.0), "width_upper": float.hex(0.0),
           "width_squared": "0x0/0x1" if sign == 0 else ""}
    if sign <= 0:
        if sign < 0:
            row["width_lower"] = row["width_upper"] = ""
        return row
    found = obstacles(name, x)

    def is_at_least(w):  # w in the unit of the points
        return all(o.is_at_least(w / unit) for o in found)

    near = min(o.near() for o in found) * unit
    tolerance = greatest_double(lambda y: is_at_least(2 * y), near / 2)
    lower = greatest_double(is_at_least, near)
    exact = (any(o.near() and o.is_at_least(Q(lower) / unit) and not strictly_above(o, Q(lower) / unit) for o in found)
             if lower else False)
    row["tolerance"], row["tolerance_decimal"] = tolerance.hex(), repr(tolerance)
    row["width_lower"] = lower.hex()
    row["width_upper"] = (lower if exact else next_up(lower)).hex()
    if name.startswith("orientation"):
        least = min(o.square for o in found) * unit * unit
        row["width_squared"] = hex(least.numerator) + "/" + hex(least.denominator)
    return row


def strictly_above(o, w):
    """Whether the width is greater than w, given that it is not below."""
    if isinstance(o, Slab):
        return w * w < o.square
    rest = o.s2 - o.r2 - w * w
    return 4 * w * w * o.r2 < rest * rest
