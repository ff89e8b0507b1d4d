# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi volumes and neighbours of atoms that LAMMPS moves, beside its compute voronoi/atom, which is Voro++: every
atom in every tenth step, from Python, one mesh moved from frame to frame, and from `annulus replay` (ANNULUS_TOOL).

usage: PYTHONPATH=build/release/python ANNULUS_TOOL=build/release/annulus /usr/bin/python3 -m pytest \\
       python/tests/test_lammps.py --steps 20000 -s
"""

import itertools
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import annulus
import numpy as np
import pytest
from support import HANGING, SEED

TOOL = os.environ.get("ANNULUS_TOOL") and os.path.abspath(os.environ["ANNULUS_TOOL"])
EVERY = 10  # steps from frame to frame
VOLUME, AREA = 1e-12, 1e-11  # how far from those of LAMMPS they may be: of a volume; in LAMMPS' unit, as what follows
# Voro++ takes a vertex of a cell that is within 1e-11 of a bisector for one on it, and leaves out facets that are as
# small, as at places of a crystal at rest that are rounded. So it may count a facet smaller than this or not.
TINY = 1e-10
FACET = 4 ** (2 / 3) / 2**2.5  # the area of each facet of fcc with density 1: a^2 / 2^2.5

# Neighbours are found in the steps that are frames, so that images of atoms, which compute voronoi/atom takes, are
# those nearest to the box.
INPUT = """
units lj
atom_style atomic
lattice fcc {density}
region box {region}
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create {temperature} {seed} loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1.0 1.0 2.5
neighbor 0.4 bin
neigh_modify every {every} delay 0 check no
timestep 0.003
thermo_modify lost error
fix move all {fix}
run {before}
reset_timestep 0
variable drift equal {drift}/({steps}*dt)
velocity all set $(v_drift*lx) $(v_drift*ly) $(v_drift*lz) sum yes units box
compute cell all voronoi/atom neighbors yes
dump atoms all custom {every} atoms.lammpstrj id x y z ix iy iz c_cell[1] c_cell[2]
dump_modify atoms sort id format float %.17g
dump facets all local {seldom} facets.txt c_cell[1] c_cell[2] c_cell[3]
dump_modify facets format float %.17g
run {steps}
"""
MOTIONS = {
    "melt": dict(density=0.8442, region="block 0 4 0 5 0 6", temperature=3.0, fix="nve", before=200, drift=0),
    # The box changes in size and shape.
    "melt in a triclinic box": dict(density=0.8442, region="prism 0 5 0 5 0 5 1.3 0.7 0.9", temperature=3.0,
                                    fix="npt temp 1.6 1.6 0.3 aniso 6 6 1.5", before=200, drift=0),
    # At rest, then it vibrates, and drifts once around the box along each of its edges.
    "crystal": dict(density=1.0, region="block 0 4 0 5 0 6", temperature=0.2, fix="nve", before=0, drift=1),
    "crystal with pressure": dict(density=1.0, region="block 0 5 0 5 0 5", temperature=0.2,
                                  fix="npt temp 0.1 0.1 0.3 aniso 3 3 1.5", before=0, drift=0),
}


def simulate(here, motion, steps):
    (here / "in.lammps").write_text(INPUT.format(**motion, seed=SEED % 900000 + 1, every=EVERY, steps=steps,
                                                 seldom=max(EVERY, steps // 20)), encoding="ascii")
    root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    subprocess.run(["lmp", "-in", "in.lammps", "-log", "none"], cwd=here, check=True, env={**os.environ, **root},
                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, timeout=HANGING * max(1, steps // 400))


def frames_of(path):
    """Of a dump: the step, the lines of the box and the rows of each frame."""
    with open(path, encoding="ascii") as file:
        while head := list(itertools.islice(file, 9)):
            rows = int(head[3])
            bounds = np.array([line.split() for line in head[5:8]], dtype=float)
            yield int(head[1]), bounds, np.array(list(map(str.split, itertools.islice(file, rows))), dtype=float)


def box_of(bounds):
    """Its vectors as rows; the bounds of a triclinic one are those of all its corners."""
    if bounds.shape[1] == 2:
        return np.diag(bounds[:, 1] - bounds[:, 0])
    xy, xz, yz = bounds[:, 2]
    lower = bounds[:, 0] - [min(0, xy, xz, xy + xz), min(0, yz), 0]
    upper = bounds[:, 1] - [max(0, xy, xz, xy + xz), max(0, yz), 0]
    return np.diag(upper - lower) + np.array([[0, 0, 0], [xy, 0, 0], [xz, yz, 0]])


class Differences:
    """Between what was measured and what LAMMPS says, over all frames."""

    def __init__(self):
        self.cells = self.other_digits = self.other_counts = 0
        self.largest = 0.0
        self.steps = []  # whose frames have other counts

    def add(self, step, volumes, counts, rows, at_least, at_most):
        """Volumes and neighbours of the atoms of a frame, as measured, and the least and most that LAMMPS may count."""
        theirs, their_counts = rows[:, 7], rows[:, 8]
        relative = np.abs(volumes - theirs) / theirs
        assert np.all(relative <= VOLUME), relative.max()
        self.largest = max(self.largest, relative.max())
        self.cells += len(volumes)
        self.other_digits += np.count_nonzero(np.char.mod("%g", volumes) != np.char.mod("%g", theirs))
        assert np.all(at_least <= their_counts) and np.all(their_counts <= at_most)
        other = np.count_nonzero(counts != their_counts)
        self.other_counts += other
        self.steps += [step] if other else []

    def __str__(self):
        return (f"{self.cells} cells: volumes differ by {self.largest:.2g} of theirs at most, {self.other_digits} in "
                f"the digits that LAMMPS prints; {self.other_counts} have other numbers of neighbours, in the "
                f"frames of steps {self.steps}")


def sorted_pairs(first, second, area):
    kept = area > TINY
    order = np.lexsort((area[kept], second[kept], first[kept]))
    return [a[kept][order] for a in (first, second, area)]


def from_python(here, crystal, drift):
    """One mesh, moved from frame to frame. Returns the differences, and how many LAMMPS may count in each frame."""
    mesh, said, limits, compared = None, Differences(), {}, 0
    centres = []
    facets = frames_of(here / "facets.txt")
    next_facets = next(facets, None)
    for step, bounds, rows in frames_of(here / "atoms.lammpstrj"):
        x, box = rows[:, 1:4], box_of(bounds)
        if mesh is None:
            mesh = annulus.MovingDelaunay(x, box=box)
        else:
            mesh.move(x, box=box)
        assert np.array_equal(rows[:, 0], np.arange(1, len(x) + 1))
        centres.append(np.mean(x + rows[:, 4:7] @ box, axis=0))
        volumes, counts = mesh.voronoi_volumes(), mesh.neighbor_counts()
        limits[step] = mesh.neighbor_counts(TINY), mesh.neighbor_counts(strict=False)
        said.add(step, volumes, counts, rows, *limits[step])
        if crystal:
            assert np.all(mesh.neighbor_counts(FACET / 4) == 12)  # by area
        if next_facets is not None and next_facets[0] == step:
            i, j, A = mesh.neighbor_list("ijA")
            first, second, area = next_facets[2].T
            ours, theirs = sorted_pairs(i + 1, j + 1, A), sorted_pairs(first, second, area)
            assert np.array_equal(ours[0], theirs[0]) and np.array_equal(ours[1], theirs[1])
            assert np.allclose(ours[2], theirs[2], rtol=0, atol=AREA)
            compared += len(ours[0])
            next_facets = next(facets, None)
    assert next_facets is None and compared > 0
    if drift:
        assert np.allclose(centres[-1] - centres[0], drift * np.diag(box), rtol=1e-6)
    return said, limits


def from_replay(here, limits):
    subprocess.run([TOOL, "replay", "atoms.lammpstrj", "--voronoi", "--output", "out", "--quiet"], cwd=here, check=True,
                   timeout=HANGING * max(1, len(limits) * EVERY // 400))
    said = Differences()
    with open(here / "out" / "voronoi.csv", encoding="ascii") as file:
        header = next(file).strip().split(",")
        columns = [header.index(name) for name in ("frame", "id", "volume", "neighbours")]
        for step, _, rows in frames_of(here / "atoms.lammpstrj"):
            ours = [line.split(",") for line in itertools.islice(file, len(rows))]
            frame, ids, volumes, counts = np.array(ours, dtype=object)[:, columns].astype(float).T
            assert np.all(frame == step) and np.array_equal(ids, rows[:, 0])
            said.add(step, volumes, counts, rows, *limits[step])
        assert not file.read(1)
    return said


@pytest.mark.skipif(shutil.which("lmp") is None, reason="LAMMPS is not there (package lammps)")
@pytest.mark.parametrize("name", MOTIONS)
def test_volumes_and_neighbours_are_those_of_lammps(name, request):
    steps = request.config.getoption("--steps")
    with tempfile.TemporaryDirectory() as scratch:
        here = Path(scratch)
        simulate(here, MOTIONS[name], steps)
        said, limits = from_python(here, "crystal" in name, MOTIONS[name]["drift"])
        assert len(limits) == steps // EVERY + 1
        print(f"\n{name}, {steps} steps, {len(limits)} frames\n  Python  {said}")
        if TOOL:
            replayed = from_replay(here, limits)
            assert replayed.cells == said.cells
            print(f"  replay  {replayed}")
