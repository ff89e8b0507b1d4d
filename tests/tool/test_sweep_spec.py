#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` on specifications that it refuses, with the line and the key, and on some that it barely
accepts.

usage: test_sweep_spec.py --tool=PATH [CLASS[.METHOD]...]
"""

import os
import subprocess

import test_sweep
import tool
from test_sweep import SPEC


class Spec(test_sweep.SweepTest):
    def test_faults(self):
        grid = "[[grid]]\npoints = 10\n"
        for text, line, words in (
            ("", 0, ["empty"]),
            ("title = \"a\"\n", 1, ["'grid'", "[[grid]]"]),
            ("grid = 3\n", 1, ["'grid' is 3"]),
            ("[grid]\npoints = 3\n", 1, ["[[grid]]"]),
            ("title = 3\n" + grid, 1, ["'title' is 3", "text"]),
            ("seeds = 3\n" + grid, 1, ["unknown key 'seeds'", "seed, hardest, grid"]),
            ("\nseed = -1\n" + grid, 2, ["'seed' is -1", "whole number"]),
            ("seed = 1.5\n" + grid, 1, ["'seed' is 1.5"]),
            ("seed = true\n" + grid, 1, ["'seed' is true"]),
            ("hardest = 1000000\n" + grid, 1, ["'hardest'", "100000"]),
            ("[[grid]]\nkind = \"grid\"\n", 1, ["no 'points'"]),
            ("[[grid]]\npoints = []\n", 2, ["'points' is an empty list"]),
            ("[[grid]]\npoints = 0\n", 2, ["'points' is 0", "1 to 100000000"]),
            ("[[grid]]\npoints = [10,\n  20,\n  \"30\"]\n", 4, ["'points' is '30'", "whole number"]),
            ("[[grid]]\npoints = [10, 10]\n", 2, ["10 twice"]),
            (grid + "dimension = 4\n", 3, ["'dimension' is 4", "2 to 3"]),
            (grid + "kind = \"unifrom\"\n", 3, ["'kind' is 'unifrom'", "uniform, grid"]),
            (grid + "rounding = [\"double\", \"decimal:99\"]\n", 3,
             ["'rounding' is 'decimal:99'", "decimal:DIGITS (0 to 17)"]),
            (grid + "seeds = 0\n", 3, ["'seeds' is 0"]),
            (grid + "seeds = []\n", 3, ["'seeds' is an empty list"]),
            (grid + "seeds = [9007199254740992]\n", 3, ["'seeds'"]),
            (grid + "kinds = \"grid\"\n", 3, ["unknown key 'kinds' in [[grid]]"]),
            (grid + "name = 1979-05-27\n", 3, ["'name' is a date or time"]),
            (grid + "motion = \"walk\"\n", 3, ["'motion' is 'walk'", "a table"]),
            (grid + "motion = { kind = \"walk\" }\n", 3, ["no 'steps'"]),
            (grid + "motion = { steps = 3 }\n", 3, ["no 'kind'"]),
            (grid + "motion = { kind = \"fly\", steps = 3 }\n", 3,
             ["'kind' is 'fly'", "walk, shear, orbit, lloyd, nodt"]),
            (grid + "motion = { kind = \"walk\", steps = 3, speed = 1 }\n", 3, ["unknown key 'speed' in motion"]),
            (grid + "motion = { kind = \"walk\", steps = 3, pace = -1 }\n", 3, ["'pace' is -1"]),
            (grid + "motion = { kind = \"walk\", steps = 3, pace = nan }\n", 3, ["'pace'", "0 to 1000"]),
            (grid + "motion = { kind = \"lloyd\", steps = 3, pace = 1 }\n", 3, ["'pace' is of no motion"]),
            (grid + "dimension = 3\nmotion = { kind = \"lloyd\", steps = 3 }\n", 4, ["in 2D"]),
            (grid + "motion = { kind = \"nodt\", steps = 3 }\n", 3, ["in 3D"]),
            (grid + "dimension = 3\nkind = \"grid\"\nmotion = { kind = \"nodt\", steps = 3 }\n", 5, ["uniform"]),
            (grid + "[grid.motion]\nkind = \"walk\"\nsteps = -3\n", 5, ["'steps' is -3"]),
            (grid + "frames = 3\n", 3, ["'frames' needs a 'file'"]),
            (grid + "file = \"a.xyz\"\n", 2, ["'points' is of generated points"]),
            ("[[grid]]\nfile = \"missing.xyz\"\n", 2, ["'file'", "missing.xyz"]),
            ("[[grid]]\nfile = \".\"\n", 2, ["'file'"]),
            ("[[grid]]\nfile = \"spec.toml\"\nframes = 1\nevery = 2\n", 4, ["'every' and 'frames'"]),
            (grid + "points = 20\n", 3, ["TOML", "redefin"]),
            (grid + "kind = uniform\n", 3, ["TOML"]),
            (grid + "kind = \"uniform\n", 3, ["TOML"]),
            ("hardest = 100001\n" + grid, 1, ["'hardest' is 100001", "0 to 100000"]),
            ("[[grid]]\npoints = 100000001\n", 2, ["'points' is 100000001", "1 to 100000000"]),
            (grid + "rounding = \"decimal:18\"\n", 3, ["'rounding' is 'decimal:18'"]),
            (grid + "motion = { kind = \"walk\", steps = 1000000001 }\n", 3, ["'steps' is 1000000001"]),
            (grid + "motion = { kind = \"walk\", steps = 3, pace = 1000.5 }\n", 3, ["'pace' is 1000.5", "0 to 1000"]),
            (grid + "seeds = 1000001\n", 3, ["'seeds'"]),
            (grid + "seeds = 2000000\n", 3, ["'seeds'"]),
            (grid + "seeds = 1000000\ndimension = [2, 3]\n", 1, ["more than 1000000"]),
        ):
            with self.subTest(text=text):
                fault = self.refuse(3, "sweep", self.write("spec.toml", text), "--output", "out")
                where = "spec.toml:" if line == 0 else f"spec.toml:{line}: "
                self.assertIn(f"annulus: {where}", fault)
                for word in words:
                    self.assertIn(word.lower(), fault.lower())
        self.refuse(3, "sweep", self.write("spec.toml", b"\xff\xfe\x00points"), "--output", "out")
        self.refuse(3, "sweep", "missing.toml", "--output", "out")
        self.refuse(3, "sweep", ".", "--output", "out")

    def test_the_bounds_themselves_are_fine(self):
        for text, trials in (("points = 100000000\nrounding = \"decimal:17\"\n", "1 trial"),
                             ("points = 10\nseeds = 1000000\n", "1000000 trials"),
                             ("points = 10\nmotion = { kind = \"walk\", steps = 1000000000, pace = 1000 }\n",
                              "1 trial")):
            spec = self.write("spec.toml", "hardest = 100000\n[[grid]]\n" + text)
            self.assertIn(trials, self.succeed("sweep", spec, "--check").stdout)

    def test_usage(self):
        self.write("spec.toml", SPEC)
        self.refuse(2, "sweep", "spec.toml")
        self.refuse(2, "sweep", "--output", "out")
        self.refuse(2, "sweep", "spec.toml", "--output", "out", "--memory", "0")
        self.refuse(2, "sweep", "spec.toml", "--output", "out", "--threads", "0")
        self.assertIn("79 trials", self.succeed("sweep", "spec.toml", "--check").stdout)
        self.assertEqual(self.listing(), ["spec.toml"])

    def test_a_launcher_that_mpi_knows_nothing_of(self):
        """As under srun without PMI, or in a build without MPI: several processes, each of which would run
        everything."""
        self.write("spec.toml", SPEC)
        done = subprocess.run([tool.OPTIONS["tool"], "sweep", "spec.toml", "--output", "out"], cwd=self.here,
                              capture_output=True, text=True, env={**os.environ, "SLURM_STEP_NUM_TASKS": "2"},
                              timeout=tool.HANGING, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        # Libraries of MPI may warn: one measures the processor's clock, and does not believe it on a busy machine.
        said = "".join(line for line in done.stderr.splitlines(keepends=True) if line.startswith("annulus:"))
        self.assertRegex(said, r"\Aannulus: started as one of 2 processes, [^\n]+\n\Z")
        self.assertEqual(self.listing(), ["spec.toml"])

    def test_a_fault_in_a_file_of_points(self):
        self.write("bad.xyz", "1 2\n3 x\n")
        spec = self.write("spec.toml", "[[grid]]\nfile = \"bad.xyz\"\n")
        self.assertIn("annulus: bad.xyz:2: ", self.refuse(3, "sweep", spec, "--output", "out"))
        self.succeed("generate", "walk", "--points", 9, "--steps", 3, "--output", "walk.xyz")
        spec = self.write("spec.toml", "[[grid]]\nfile = \"walk.xyz\"\nframes = [0, 7]\n")
        self.assertIn("frames", self.refuse(3, "sweep", spec, "--output", "out"))


if __name__ == "__main__":
    tool.main(__doc__)
