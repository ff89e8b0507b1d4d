# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of degenerate sets, derived in docs/degeneracy.md."""

import math
from collections import defaultdict

A = 4 * math.pi / 3
PLANE = 3 * math.pi
SPACE_SETS = 0.4 / 12 * math.gamma(11 / 3) * A ** (-11 / 3) * (4 * math.pi) ** 5 * 2 * math.pi / 21
SPACE = 2 * SPACE_SETS
ZETA = sum(n ** -1.5 for n in range(1, 200000)) + 2 / math.sqrt(200000)
ZETA3 = 1.2020569031595942
BETA = sum((-1) ** n * (2 * n + 1) ** -1.5 for n in range(200000))
ALL_DIRECTIONS = 4 * ZETA * BETA / ZETA3  # sum of L^-3 over primitive vectors of the plane
ODD = ALL_DIRECTIONS / (1 + 2 ** -1.5)
TRAPEZOIDS = 4 / math.pi * 0.5 * (ODD / 2 + (ALL_DIRECTIONS - ODD))


def representations(most, centre):
    """How many points of the lattice are at each squared distance (in quarters) from a centre in half units."""
    r2 = defaultdict(int)
    k = int(math.sqrt(most)) + 2
    for x in range(-k, k + 1):
        for y in range(-k, k + 1):
            r2[(2 * x - centre[0]) ** 2 + (2 * y - centre[1]) ** 2] += 1
    return r2


def quadruples_around_lattice(h):
    """Empty circles through four points of the lattice around points of it and of half of it, per vertex."""
    most = 12 / (math.pi * h * h)
    total = 0.0
    for centre in ((0, 0), (1, 0), (0, 1), (1, 1)):
        for n4, r2 in representations(most, centre).items():
            total += math.comb(r2, 4) * math.exp(-math.pi * n4 / 4 * h * h)
    return total * h ** 6
