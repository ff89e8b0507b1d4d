#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic boxes of extended XYZ, LAMMPS and --box: how replay takes them, which are refused or announced, here and by
other commands. usage: test_periodic.py --tool=PATH [CLASS[.METHOD]...]"""

import json
import random
import shutil

import boxed
import tool


class Taken(boxed.BoxedTest):
    def wandering(self, d, n, step, strain):
        """Five frames of points that wander by so much a step, in a box that is sheared by so much a step."""
        dice = random.Random(tool.SEED)
        motion = [{i: [dice.random() for _ in range(d)] for i in range(n)}]
        while len(motion) < 5:
            motion.append({i: [c + step * dice.gauss(0, 1) for c in p] for i, p in motion[-1].items()})
        rows = [[float(i == j) for j in range(d)] for i in range(d)]
        self.lattice_xyz("a.xyz", motion, [[*rows[:-1], [k * strain, *rows[-1][1:]]] for k in range(5)])

    def follow(self, strategy):
        return self.succeed("replay", "a.xyz", "--strategy", strategy, "--voronoi", "--neighbors", "--changes",
                            "--every", 4, "--audit", 1, "--output", strategy)

    def test_steps_flip_and_with_the_strategy_rebuild_they_rebuild(self):
        self.wandering(2, 200, 0.004, 1 / 32)
        for strategy in ("auto", "signs", "tolerances", "rebuild"):
            done = self.follow(strategy)
            page = (self.here / strategy / "report.html").read_text(encoding="utf-8")
            counts = strategy in ("auto", "tolerances")
            for text in (done.stdout, page):  # not those whose signs are tested all at once
                self.assertEqual("decided for tolerances" in text, counts)
            moves = self.summary(strategy)["moves"]
            self.assertEqual(moves["asked"], 800)
            self.assertEqual(moves["rebuilt"], 800 if strategy == "rebuild" else 0)
            self.assertEqual(moves["within_tolerance"] + moves["kept_in_place"] + moves["flipped"],
                             0 if strategy == "rebuild" else 800)
            for words in ("Lattice and pbc", "0.125, 1", "with images at the sides of the box"):
                self.assertIn(words, page)
            self.assertNotIn("Unbounded cells", page)

    def test_results_do_not_depend_on_the_strategy(self):
        for d, n, step, strain in ((2, 200, 0.004, 1 / 32), (2, 200, 1e-6, 0), (3, 100, 1e-6, 1e-6), (3, 60, 0.1, 0)):
            with self.subTest(d=d, step=step):
                self.wandering(d, n, step, strain)
                for strategy in ("rebuild", "auto", "signs", "tolerances"):
                    self.follow(strategy)
                    self.assertEqual(self.summary(strategy)["audit"], {"checked": 4, "failed": 0})
                    for name in ("changes.csv", "frames.pvd"):
                        self.assertEqual((self.here / strategy / name).read_bytes(),
                                         (self.here / "rebuild" / name).read_bytes(), name)
                    # Which cell a number is computed from is not the same.
                    for frame, measures in self.pairs("rebuild").items():
                        again = self.pairs(strategy)[frame]
                        self.assertEqual(set(measures), set(again))
                        for pair, length in measures.items():
                            self.assertAlmostEqual(length, again[pair], delta=1e-12)
                    for frame, cells in self.voronoi("rebuild").items():
                        again = self.voronoi(strategy)[frame]
                        self.assertEqual(set(cells), set(again))
                        for i, (volume, count) in cells.items():
                            self.assertAlmostEqual(volume, again[i][0], delta=1e-9 * volume)
                            self.assertEqual(count, again[i][1])

    def test_tolerances_are_kept_where_points_move_little(self):
        self.wandering(2, 200, 1e-6, 0)
        for strategy in ("auto", "tolerances", "signs", "rebuild"):
            done = self.follow(strategy)
            self.assertIn(f"strategy {strategy}, certified tolerances\n", done.stdout)
            self.assertEqual(self.summary(strategy)["tolerance"], "certified")
            page = (self.here / strategy / "report.html").read_text(encoding="utf-8")
            rows = self.table(strategy, "iterations.csv")
            within = [int(row["within_tolerance"]) for row in rows]
            for row in rows:  # measured with every strategy, in mean spacings
                self.assertTrue(1e-4 < float(row["tolerance_mean"]) < 1, row)
                self.assertEqual((row["annulus_width_mean"], row["theta_min"]), ("", ""))
            self.assertIn('aria-label="Displacement, tolerance"', page)
            keeps = strategy in ("auto", "tolerances")
            if keeps:  # they begin with a step
                self.assertEqual(within[0], 0)
                self.assertGreater(min(within[1:]), 100)
                self.assertGreater(int(rows[0]["certificates_evaluated"]), 600)
                self.assertLess(int(rows[-1]["certificates_evaluated"]), 600)
            else:
                self.assertEqual([(row["certificates_evaluated"], row["within_tolerance"]) for row in rows],
                                 [("0", "0")] * 4)
            for words in ("Moves beyond their tolerance", "frames that tested tolerances</th><td>3",
                          "of the moves in the 3 of 4 frames that tested tolerances stayed within their tolerance"):
                self.assertEqual(words in page, keeps, words)
            self.assertEqual(f"The strategy {strategy} tests no tolerances." in page, not keeps)

    def test_strategies_that_a_box_does_not_have_are_refused(self):
        self.wandering(2, 20, 0.01, 0)
        self.write("open.csv", "frame,id,x,y\n0,1,0.1,0.2\n0,2,0.7,0.6\n0,3,0.5,0.1\n1,1,0.2,0.2\n")
        for strategy in ("relocate", "relocate-flips", "in-place", "tolerances-each", "paper", "paper-hybrid"):
            self.assertEqual(self.refuse(2, "replay", "a.xyz", "--strategy", strategy),
                             "annulus: in a periodic box the strategies are auto, rebuild, signs and tolerances, not "
                             f"{strategy}, or --open for open boundaries")
            self.succeed("replay", "a.xyz", "--open", "--strategy", strategy)
        self.assertEqual(self.refuse(2, "replay", "a.xyz", "--strategy", "paper", "--tolerance", "floating"),
                         "annulus: in a periodic box tolerances are certified, not floating, or --open for open "
                         "boundaries")
        # signs is for boxes; whether there is one, the file says, unless the command does.
        says = "annulus: the strategy signs is for periodic boxes: use auto, or in-place"
        self.assertEqual(self.refuse(2, "replay", "open.csv", "--strategy", "signs"), says)
        self.assertEqual(self.refuse(2, "replay", "absent.xyz", "--open", "--strategy", "signs"), says)
        self.assertEqual(self.refuse(2, "lloyd", "--points", 20, "--strategy", "signs"), says)
        self.assertIn("absent.xyz", self.refuse(3, "replay", "absent.xyz", "--strategy", "signs"))
        self.succeed("replay", "open.csv", "--box", "1,1", "--strategy", "signs")

    def test_a_short_way_in_a_skewed_box_changes_nothing(self):
        """0.07 of one vector, and 0.56 of the other."""
        motion = [{1: [0.1, y], 2: [0.6, 0.45], 3: [0.3, 0.75]} for y in (0.1, 0.17)]
        self.lattice_xyz("a.xyz", motion, [[[1, 0], [8, 1]]] * 2)
        self.succeed("replay", "a.xyz", "--changes", "--every", 1, "--audit", 1, "--output", "out")
        self.assertEqual(self.shifted_changes(), {})
        self.assertLess(float(self.table("out", "iterations.csv")[-1]["displacement_max"]), 0.15)  # in mean spacings

    def test_a_box_for_points_that_are_absent_for_a_frame(self):
        """Of a table, with frames without points, first and between."""
        self.write("a.csv", "frame,id,x,y\n0,1,0.5,0.5\n0,2,0.75,0.5\n2,1,3.5,-0.5\n2,2,0.75,0.625\n3,1,0.5,0.5\n")
        self.succeed("replay", "a.csv", "--box", "1,1", "--absent-frames", "empty", "--voronoi", "--neighbors",
                     "--changes", "--every", 1, "--audit", 1, "--output", "out")
        self.assertEqual(set(self.voronoi()), {0, 2, 3})
        pairs, changes = self.pairs(), self.shifted_changes()
        self.assertEqual((changes[1], changes[2]), ((set(), set(pairs[0])), (set(pairs[2]), set())))
        self.lattice_xyz("b.xyz", [{}, {1: [0.5, 0.5]}, {}], [[[1, 0], [0, 1]]] * 3)
        self.succeed("replay", "b.xyz", "--voronoi", "--output", "out", "--audit", 1)
        self.assertEqual({f: list(cells) for f, cells in self.voronoi().items()}, {1: [1]})

    def test_a_box_from_the_command_line(self):
        self.write("a.csv", "frame,id,x,y\n0,1,0.1,0.2\n0,2,0.7,0.6\n1,1,0.2,0.2\n1,2,0.7,0.7\n")
        for box, area in (("2,1", 2), ("2,0,0.5,1", 2)):
            self.succeed("replay", "a.csv", "--box", box, "--voronoi", "--output", "out")
            for frame in self.voronoi().values():
                self.assertAlmostEqual(sum(v for v, _ in frame.values()), area, delta=1e-9)
        self.assertEqual(self.summary("out")["box"], [[2, 0], [0.5, 1]])
        for words, what in ((["--box", "1,2,3"], "--box has 3 numbers, and a box in 2D has 2 lengths or 4"),
                            (["--box", "1,x"], "'x' is not a number"),
                            (["--box", "1,0"], "--box: the vectors of the box"),
                            (["--box", "1,1", "--open"], "--open and --box exclude each other"),
                            (["--box", "1,1", "--strategy", "paper"], "in a periodic box the strategies are auto,")):
            self.assertIn(what, self.refuse(2, "replay", "a.csv", *words))
        # In place of the box of a file, whatever that is.
        self.write("b.xyz", '2\nLattice="9 0 0 0 9 0" pbc="T F F" Properties=pos:R:2\n0 0\n0.25 0.5\n')
        self.succeed("replay", "b.xyz", "--box", "1,1", "--voronoi", "--output", "out")
        self.assertAlmostEqual(sum(v for v, _ in self.voronoi()[0].values()), 1, delta=1e-9)

    def test_what_cannot_be_taken_is_refused(self):
        one = '2\n{} Properties=pos:R:3\n0 0 0\n1 2 3\n'
        whole = 'Lattice="9 0 0 0 9 0 0 0 9"'
        for text, line, what in (
            (one.format(whole + ' pbc="T F T"'), 2, "Lattice and pbc: a box that is periodic in x and z only"),
            (one.format('pbc="T T T"'), 2, "pbc: a periodic box of 0 numbers"),
            (one.format('Lattice="9 9 9"'), 2, "Lattice: a periodic box of 3 numbers"),
            (one.format('cell="9 9 9 90 90 90"'), 2, "cell: a periodic box of 6 numbers"),
            (one.format('Lattice="9 0 0 9 0 0 0 0 9"'), 2, "Lattice: the vectors of the box"),
            (one.format(whole + ' pbc="T F"'), 2, "pbc has 2 values"),
            (one.format('pbc="F F F"') + one.format(whole), 6,
             "a frame has a periodic box, and frames before have none"),
            (one.format(whole) + one.format('pbc="F F F"'), 7,
             "a frame has no periodic box, and frames before have one"),
            (one.format(whole).replace("1 2 3", "9 0 18"), 3,
             "in frame 0 the points of ids 0, 1 are at one place of the periodic box"),
            (one.format(whole).replace("1 2 3", "1e11 0 0"), 4, "in frame 0 the point of id 1: "),
        ):
            with self.subTest(what=what):
                self.write("a.xyz", text)
                self.assertIn(f"a.xyz:{line}: {what}", self.refuse(3, "replay", "a.xyz", "--dim", 3))
        dump = ("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS{}\n0 9\n0 9\n0 9\n"
                "ITEM: ATOMS id x y z\n1 0 0 0\n2 1 2 3\n")
        self.write("a.lammpstrj", dump.format(" pp pp ff"))
        self.assertIn("a.lammpstrj:5: BOX BOUNDS pp pp ff: a box that is periodic in x and y only; expected one that "
                      "is periodic in every direction, or --open", self.refuse(3, "replay", "a.lammpstrj"))
        self.succeed("replay", "a.lammpstrj", "--dim", 2)
        self.write("a.lammpstrj", dump.format(" pp pp pp").replace("0 9\n", "-1e308 1e308\n", 1))
        self.assertIn("a.lammpstrj:5: BOX BOUNDS pp pp pp: a coordinate of a vector of the box is not a finite number",
                      self.refuse(3, "replay", "a.lammpstrj"))
        self.write("a.lammpstrj", dump.format(""))  # all sides, where the file does not say
        self.assertIn("box  ", self.succeed("replay", "a.lammpstrj").stdout)

    def test_results_do_not_depend_on_threads_and_files_are_complete(self):
        dice = random.Random(tool.SEED)
        motion = [{i: [dice.random() for _ in range(3)] for i in range(30)} for _ in range(2)]
        self.lattice_xyz("a.xyz", motion, [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]] * 2)
        files = {"summary.json", "iterations.csv", "final.mesh", "final.vtu", "report.html", "pairs.csv", "voronoi.csv",
                 "changes.csv", "frames.pvd", "frame-000000.vtu", "frame-000001.vtu"}
        for threads in (1, 2):
            self.succeed("replay", "a.xyz", "--every", 1, "--voronoi", "--neighbors", "--changes", "--threads", threads,
                         "--output", f"out{threads}")
            self.assertEqual({p.name for p in (self.here / f"out{threads}").iterdir()}, files)
        for name in files - {"summary.json", "iterations.csv", "report.html"}:
            self.assertEqual((self.here / "out1" / name).read_bytes(), (self.here / "out2" / name).read_bytes(), name)
        volumes = tool.vtu_values(self.here / "out1" / "frame-000001.vtu", "voronoi_volume")
        ids = tool.vtu_values(self.here / "out1" / "frame-000001.vtu", "id")
        self.assertEqual(ids[:30], tuple(range(30)))
        self.assertGreater(len(ids), 30)  # images
        self.assertAlmostEqual(sum(volumes[:30]), 1, delta=1e-9)
        self.assertEqual(tool.vtu_values(self.here / "out1" / "final.vtu", "vertex"), ids)


class Periodic(tool.ToolTest):
    def test_an_open_box_is_announced(self):
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
                if words[0] == "lloyd":  # the others take the box
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
