# SPDX-License-Identifier: GPL-3.0-or-later
"""Neighbours of atoms of crystals in periodic boxes, counted by the areas of their facets: at rest, vibrating, drifting
once around the box, from Python, and from `annulus replay` where the tool was built (ANNULUS_TOOL)."""

import csv
import os
import subprocess

import annulus
import numpy as np
import pytest
from support import HANGING, SEED

TOOL = os.environ.get("ANNULUS_TOOL") and os.path.abspath(os.environ["ANNULUS_TOOL"])
FCC = np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]])
# Atoms of a cubic cell, neighbours, and the least area of their facets in squares of the lattice constant.
CRYSTALS = {
    "fcc": (FCC, 12, 2**-2.5),  # rhombi
    "bcc": (np.array([[0, 0, 0], [.5, .5, .5]]), 14, 2**-3),  # six squares, and eight hexagons
    "sc": (np.zeros((1, 3)), 6, 1),
    "diamond": (np.vstack((FCC, FCC + .25)), 16, 2**-5.5),  # twelve triangles, and four hexagons
}
SIDE, DRIFT = 3, 20  # cells along an edge of the box, and in how many frames atoms drift once around it
SHAKEN = 0.004  # standard deviation of a coordinate that vibrates, in lattice constants
LEAST = 0.25  # of the least area at rest: facets with less do not count


def at_rest(basis, a):
    cells = np.indices((SIDE, SIDE, SIDE)).reshape(3, -1).T
    return a * (cells[:, None] + basis).reshape(-1, 3)


def motion(basis, a):
    """At rest; vibrating; vibrating and drifting along all edges at once; at rest again, where it is then."""
    rng = np.random.default_rng(SEED)
    x = at_rest(basis, a)
    turns = [0.0] * 10 + [k / DRIFT for k in range(1, DRIFT + 1)]
    moving = [x + turn * SIDE * a + SHAKEN * a * rng.standard_normal(x.shape) for turn in turns]
    return [x, *moving, x + SIDE * a]


def replayed(here, frames, box, least):
    """Neighbours of each atom in each frame, by voronoi.csv, and by the areas in pairs.csv."""
    with open(here / "atoms.xyz", "w", encoding="ascii") as file:
        for x in frames:
            file.write(f'{len(x)}\nLattice="{box} 0 0 0 {box} 0 0 0 {box}" pbc="T T T" Properties=id:I:1:pos:R:3\n')
            file.writelines(f"{i} {p[0]!r} {p[1]!r} {p[2]!r}\n" for i, p in enumerate(x.tolist()))
    subprocess.run([TOOL, "replay", "atoms.xyz", "--voronoi", "--neighbors", "--audit", "1", "--output", "out",
                    "--quiet"], cwd=here, check=True, timeout=HANGING)
    counts = np.zeros((2, len(frames), len(frames[0])), dtype=int)
    with open(here / "out" / "voronoi.csv", newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            counts[0, int(row["frame"]), int(row["id"])] = int(row["neighbours"])
    with open(here / "out" / "pairs.csv", newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            if float(row["area"]) > least:
                for end in ("first", "second"):
                    counts[1, int(row["frame"]), int(row[end])] += 1
    return counts


# Binary, so that atoms are where they should be; and that of copper
@pytest.mark.parametrize(("name", "a"), [*((name, 1) for name in CRYSTALS), ("fcc", 3.615)])
def test_neighbours_by_area_at_rest_vibrating_and_after_drifting_around_the_box(name, a, tmp_path):
    basis, neighbours, area = CRYSTALS[name]
    least = LEAST * area * a**2
    frames, box = motion(basis, a), SIDE * a
    mesh = annulus.MovingDelaunay(frames[0], box=[box] * 3)
    counts = []
    for x in frames:
        mesh.move(x)
        counts.append(mesh.neighbor_counts())
        assert np.all(mesh.neighbor_counts(least) == neighbours)
        assert mesh.audit()
    # By area only: while atoms vibrate, there are more facets, except in bcc, where no vertex is degenerate.
    assert (np.max(counts[1:-1]) > neighbours) == (name != "bcc")
    if a == 1:  # at rest all facets that are not exactly empty count
        assert np.all(counts[0] == neighbours) and np.all(counts[-1] == neighbours)
    if TOOL:
        facets, large = replayed(tmp_path, frames, box, least)
        assert np.all(large == neighbours)
        assert np.array_equal(facets, counts)


def test_in_diamond_that_vibrates_more_no_area_tells_sixteen_neighbours_from_others():
    rng = np.random.default_rng(SEED)
    basis, neighbours, _ = CRYSTALS["diamond"]
    x = at_rest(basis, 1)
    mesh = annulus.MovingDelaunay(x, box=[SIDE] * 3)
    counted, others = [], []
    for _ in range(20):
        mesh.move(x + 0.015 * rng.standard_normal(x.shape))
        areas = np.sort(mesh.neighbor_list("A"))
        counted.append(areas[-neighbours * len(x)])
        others.append(areas[-neighbours * len(x) - 1])
    # Facets larger than the first, or than any greater area, are less than sixteen at some atom in some frame; those
    # larger than any area below the second are more at some atom in some frame.
    assert min(counted) < max(others)
