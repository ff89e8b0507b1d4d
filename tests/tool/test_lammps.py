#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""replay of a dump of LAMMPS in a box that shears, beside what its compute voronoi/atom (Voro++) says of the same
atoms: volumes, neighbours with areas. usage: test_lammps.py --tool=PATH [CLASS[.METHOD]...]"""

import os
import shutil
import subprocess
import sys

import frames
import tool

SKIPPED = 77
ATOMS, FRAMES = 256, 10
# The box is sheared until LAMMPS takes another basis for it. `run 0` before each frame, since images of atoms are where
# they were when neighbours were last found, and compute voronoi/atom takes these; and images from far away, for where
# tilts are negative it expects them in a smaller region than they are in. Otherwise its volumes do not add up.
MELT = f"""
units lj
atom_style atomic
lattice fcc 0.8442
region box prism 0 4 0 4 0 4 1.3 0.7 0.9
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create 3.0 {tool.SEED % 900000 + 1} loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1.0 1.0 2.5
comm_modify cutoff 6
fix move all nve
fix shear all deform 1 xy erate 1.0 y erate 0.05 remap x
compute cell all voronoi/atom neighbors yes
thermo_modify lost error
run 100
variable k loop {FRAMES}
label again
run 20
dump atoms all custom 1 melt.lammpstrj id x y z ix iy iz c_cell[1] c_cell[2]
dump_modify atoms append yes format float %.17g
dump facets all local 1 facets.txt c_cell[1] c_cell[2] c_cell[3]
dump_modify facets append yes format float %.17g
run 0
undump atoms
undump facets
next k
jump SELF again
"""


def steps_of(path):
    """{step: (bounds of the box, rows of words)} of a dump."""
    steps = {}
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    for line in lines:
        if line.startswith("ITEM: TIMESTEP"):
            bounds, rows = [], []
            steps[int(next(lines))] = (bounds, rows)
        elif line.startswith("ITEM: NUMBER"):
            next(lines)
        elif line.startswith("ITEM: BOX BOUNDS"):
            bounds += [list(map(float, next(lines).split())) for _ in range(3)]
        elif not line.startswith("ITEM:"):
            rows.append(line.split())
    return steps


class Lammps(frames.FrameTest):
    def test_a_melt_that_is_sheared(self):
        self.write("in.melt", MELT)
        root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        subprocess.run(["lmp", "-in", "in.melt", "-log", "none"], cwd=self.here, check=True, env={**os.environ, **root},
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, timeout=tool.HANGING)
        self.succeed("replay", "melt.lammpstrj", "--voronoi", "--neighbors", "--changes", "--audit", 1,
                     "--output", "out")
        atoms, facets = steps_of(self.here / "melt.lammpstrj"), steps_of(self.here / "facets.txt")
        tilts = [bounds[0][2] for bounds, _ in atoms.values()]
        self.assertTrue(any(b < a for a, b in zip(tilts, tilts[1:])), tilts)  # one basis for another

        ours, pairs = {}, {}
        for row in self.table("out", "voronoi.csv"):
            ours[int(row["frame"]), int(row["id"])] = (float(row["volume"]), int(row["neighbours"]))
        for row in self.table("out", "pairs.csv"):
            pair = pairs.setdefault((int(row["frame"]), int(row["first"]), int(row["second"])), [])
            pair.append(float(row["area"]))
        self.assertEqual(len(ours), len(atoms) * ATOMS)
        for step, (_, rows) in atoms.items():
            for row in rows:
                volume, count = ours[step, int(row[0])]
                self.assertAlmostEqual(volume, float(row[7]), delta=1e-12 * volume)
                self.assertEqual(count, int(row[8]))
        theirs = {}
        for step, (_, rows) in facets.items():
            for first, second, area in rows:
                if int(first) < int(second):
                    theirs.setdefault((step, int(first), int(second)), []).append(float(area))
        self.assertEqual(set(pairs), set(theirs))
        for key, areas in pairs.items():
            self.assertEqual(len(areas), len(theirs[key]))
            for a, b in zip(sorted(areas), sorted(theirs[key])):
                self.assertAlmostEqual(a, b, delta=1e-12)
        # A basis for another changes no neighbours by itself.
        changes = [0] * len(atoms)
        for row in self.table("out", "changes.csv"):
            changes[list(atoms).index(int(row["frame"]))] += 1
        self.assertLess(max(changes[1:]), 2 * min(changes[1:]))


if __name__ == "__main__":
    if shutil.which("lmp") is None:
        print("SKIPPED: LAMMPS is not there (package lammps), and nothing was compared with its Voro++")
        sys.exit(SKIPPED)
    tool.main(__doc__)
