#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic boxes of extended XYZ and LAMMPS: refused, or announced. usage: test_periodic.py --tool=PATH
[CLASS[.METHOD]...]"""

import json
import shutil

import tool


class Periodic(tool.ToolTest):
    def test_a_periodic_box_is_refused_or_announced(self):
        frame = '3\nLattice="9 0 0 0 9 0 0 0 9" {}Properties=species:S:1:pos:R:3\nH 0 0 0\nH 1 0 0\nH 0 1 0\n'
        dump = ("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS{}\n0 9\n0 9\n0 9\nITEM: ATOMS id x y z\n"
                "1 0 0 0\n2 1 0 0\n3 0 1 0\n")
        for name, text, line, what in (
            ("a.xyz", frame.format("") * 3, 2, "Lattice"),
            ("a.xyz", frame.format('pbc="T F F" ') * 3, 2, "Lattice and pbc"),
            ("a.xyz", frame.format('pbc="F F F" ') + frame.format(""), 7, "Lattice"),
            ("a.lammpstrj", dump.format(" pp pp pp") * 2, 5, "BOX BOUNDS pp pp pp"),
            ("a.lammpstrj", dump.format(" ff ff pp"), 5, "BOX BOUNDS ff ff pp"),
            ("a.lammpstrj", dump.format(""), 5, "BOX BOUNDS, without a word on its sides"),
        ):
            with self.subTest(text=text):
                self.write(name, text)
                self.assertEqual(self.refuse(3, "replay", name, "--output", "out"),
                                 f"annulus: {name}:{line}: {what}: a periodic box, and these are not supported here; "
                                 "expected --open, by which points are taken as they stand, with open boundaries")
                done = self.succeed("replay", name, "--output", "out", "--open")
                self.assertRegex(done.stderr, rf"\Aannulus: {name}:{line}: {what} ignored: [^\n]*open boundaries\n\Z")
                self.assertEqual(self.summary("out")["ignored"], ["box"])
                page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
                self.assertLess(page.index(f"{what} ignored"), page.index("<table"))  # before all else
                self.assertEqual(self.succeed("replay", name, "--quiet", "--open").stderr, "")
        for name, text in (("a.xyz", frame.format('pbc="F F F" ')), ("a.lammpstrj", dump.format(" ff ss mm"))):
            self.write(name, text)
            done = self.succeed("replay", name, "--output", "out")
            self.assertEqual(done.stderr, "")
            self.assertNotIn("ignored", self.summary("out"))

    def test_a_periodic_box_is_refused_or_announced_by_whatever_reads_points(self):
        """Each of these handles the box itself. (A sweep: test_sweep.py.)"""
        frame = ('4\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3\nH .1 0 0\nH .2 .3 0\nH .5 .1 0\nH .3 '
                 '-.2 0\n')
        self.write("one.xyz", frame)
        self.write("film.xyz", frame * 3)
        lloyd = ["lloyd", "--ignore-z", "--input", "one.xyz", "--iterations", 2]
        for name, result, before, words in (
            ("film.xyz", "summary.json", [], ["replay", "film.xyz"]),
            ("one.xyz", "degeneracy.json", [], ["degeneracy", "one.xyz"]),
            ("one.xyz", "degeneracy.json", [], ["degeneracy", "one.xyz", "--ignore-z"]),
            ("film.xyz", "degeneracy.json", [], ["degeneracy", "film.xyz", "--frame", 1]),
            ("film.xyz", "degeneracy.json", [], ["degeneracy", "film.xyz", "--every", 2]),
            ("one.xyz", "summary.json", [], lloyd),
            ("film.xyz", "compare.json", ["compare"], ["replay", "film.xyz"]),
            ("one.xyz", "compare.json", ["compare"], lloyd),
        ):
            with self.subTest(words=[*before, *words]):
                whole = [*before, "--output", "out", "--", *words] if before else [*words, "--output", "out"]
                self.assertEqual(self.refuse(3, *whole),
                                 f"annulus: {name}:2: Lattice: a periodic box, and these are not supported here; "
                                 "expected --open, by which points are taken as they stand, with open boundaries")
                said = f"{name}:2: Lattice ignored: points are taken as they stand, with open boundaries"
                self.assertEqual(self.succeed(*whole, "--open").stderr, f"annulus: {said}\n")
                found = json.loads((self.here / "out" / result).read_text(encoding="utf-8"))
                for one in [found, *(found["strategies"].values() if before else [])]:
                    self.assertEqual(one["ignored"], ["box"])
                (page,) = (self.here / "out").glob("*.html")
                text = page.read_text(encoding="utf-8")
                self.assertIn(said, text)
                # Before all else.
                self.assertLess(text.index(said), min(text.find(part) % len(text)
                                                      for part in ("<table", "<figure", "<h2")))
                shutil.rmtree(self.here / "out")


if __name__ == "__main__":
    tool.main(__doc__)
