#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus advise` and checks its output. usage: test_advise.py --tool=PATH [CLASS[.METHOD]...]"""

import gzip
import json
import math
import os
import random
import subprocess

import tool
from advised import AdviseTest

KEYS = ["command", "version", "file", "dimension", "frames", "vertices", "box", "mean_spacing", "columns",
        "frame_distance", "displacement", "duplicates", "ids", "wrapped", "degeneracy", "expected", "measured",
        "seconds", "advice"]


class Advise(AdviseTest):
    def drifting(self, count, frames, step, d=2, box=None):
        """Points that all move by `step` spacings along x, and by a little more or less; in a box they are wrapped."""
        dice = random.Random(7)
        points = [[dice.random() for _ in range(d)] for _ in range(count)]
        speed = [step * count ** (-1 / d) * (0.9 + 0.2 * dice.random()) for _ in range(count)]
        return [{i: [(p[0] + f * v) % 1 if box else p[0] + f * v, *p[1:]]
                 for i, (p, v) in enumerate(zip(points, speed))} for f in range(frames)]

    def test_displacements_by_hand(self):
        """Nine points of a grid with spacing 2/3; in the one step one of them moves, by a tenth."""
        first = {i: (float(i % 3), float(i // 3)) for i in range(9)}
        second = {**first, 4: (1.1, 1.0)}
        found = self.advise(self.motion("a.csv", [first, second]))
        self.assertEqual(list(found), KEYS)
        self.assertEqual((found["dimension"], found["frames"], found["vertices"]), (2, 2, {"least": 9, "most": 9}))
        self.assertEqual(found["box"], {"low": [0, 0], "high": [2, 2]})
        self.assertAlmostEqual(found["mean_spacing"], 2 / 3)
        self.assertEqual(found["frame_distance"], {"least": 1, "most": 1})
        moved = found["displacement"]
        self.assertEqual((moved["total"], moved["at_rest"]), (9, 8))
        self.assertAlmostEqual(moved["mean"], 0.15 / 9)
        self.assertEqual(list(moved["quantiles"]), ["0.05", "0.25", "0.5", "0.75", "0.95", "0.99", "1"])
        self.assertEqual(moved["quantiles"]["0.75"], 0)
        self.assertAlmostEqual(moved["quantiles"]["0.95"], 0.15, delta=0.0015)
        self.assertAlmostEqual(moved["quantiles"]["1"], 0.15)
        self.assertEqual(found["ids"], {"appeared": 0, "disappeared": 0, "steps": 0, "first": []})
        self.assertEqual(found["duplicates"], {"points": 0, "frames": 0, "first": []})
        self.assertEqual((found["degeneracy"]["frame"], found["degeneracy"]["bicells"], found["degeneracy"]["zero"]),
                         (0, 8, 4))

    def test_quantiles_are_those_of_all_displacements(self):
        self.succeed("generate", "walk", "--points", 200, "--steps", 10, "--pace", 0.02, "--output", "w.csv")
        frames = {}
        for row in (self.here / "w.csv").read_text(encoding="ascii").splitlines()[1:]:
            frame, i, *p = row.split(",")
            frames.setdefault(int(frame), {})[i] = [float(c) for c in p]
        found = self.advise("w.csv")
        ways = sorted(math.dist(frames[f][i], frames[f + 1][i]) / found["mean_spacing"]
                      for f in range(10) for i in frames[0])
        self.assertEqual(found["displacement"]["total"], len(ways))
        self.assertAlmostEqual(found["displacement"]["mean"], sum(ways) / len(ways), places=12)
        for p, value in found["displacement"]["quantiles"].items():
            self.assertAlmostEqual(value / ways[max(math.ceil(float(p) * len(ways)), 1) - 1], 1, delta=0.011, msg=p)

    def test_duplicates_and_ids(self):
        a = {1: (0, 0), 2: (4, 0), 3: (0, 3), 5: (4, 0)}
        b = {1: (0, 0), 2: (4, 0), 3: (0, 3), 7: (1, 1)}
        c = {1: (0, 0.1), 3: (0, 3), 7: (1, 1), 9: (0.0, 3)}
        name = self.motion("a.csv", [a, b, c])
        found = self.advise(name)
        self.assertEqual(found["duplicates"], {"points": 2, "frames": 2, "first": [
            {"frame": 0, "id": "5", "where_is": "2"}, {"frame": 2, "id": "9", "where_is": "3"}]})
        self.assertEqual(found["ids"], {"appeared": 1, "disappeared": 1, "steps": 2, "first": [
            {"frame": 1, "id": "7", "what": "appears"}, {"frame": 2, "id": "2", "what": "disappears"}]})
        text = self.succeed("advise", name).stdout
        self.assertEqual(self.line(text, "duplicates"),
                         "2 points in 2 frames, the first: id 5 is where id 2 is in frame 0")
        self.assertEqual(self.line(text, "ids"),
                         "1 appear, 1 disappear, in 2 frames, the first: id 7 appears in frame 1")
        self.refuse(3, "replay", name)  # and so it is worth saying

    def test_ids_that_are_words(self):
        self.write("a.csv", "frame,id,x,y\n0,ann,0,0\n0,bob,1,0\n0,cid,0,1\n1,ann,0,0\n1,bob,0,0\n1,dan,0,1\n")
        found = self.advise("a.csv")
        self.assertEqual(found["duplicates"]["first"], [{"frame": 1, "id": "bob", "where_is": "ann"}])
        self.assertIn({"frame": 1, "id": "cid", "what": "disappears"}, found["ids"]["first"])
        rows = b"0,ann,0,0\n0,b\x1b[31m\xb5,1,0\n0,cid,0,1\n1,ann,0,0\n1,b\x1b[31m\xb5,0,0\n1,cid,0,1\n"
        (self.here / "b.csv").write_bytes(b"frame,id,x,y\n" + rows)
        text = self.succeed("advise", "b.csv").stdout
        self.assertIn("id b\ufffd[31m\ufffd is where id ann is", text)

    def test_a_pipe_with_a_name_is_read_once(self):
        text = self.motion("a.csv", self.drifting(20, 3, 0.01))
        (self.here / text).rename(self.here / "b.csv")
        os.mkfifo(self.here / "a.csv")
        with subprocess.Popen(["cp", "b.csv", "a.csv"], cwd=self.here) as copying:
            self.assertEqual(self.advise("a.csv")["frames"], 3)
            self.assertEqual(copying.wait(tool.HANGING), 0)

    def test_wrapped(self):
        steady, wrapped = (self.drifting(300, 30, 0.05, box=box) for box in (None, True))
        found = self.advise(self.motion("wrapped.csv", wrapped))
        jumps = sum(abs(wrapped[f + 1][i][0] - wrapped[f][i][0]) > 0.5 for f in range(29) for i in range(300))
        self.assertGreater(jumps, 5)
        self.assertEqual((found["wrapped"]["suspected"], found["wrapped"]["jumps"]), (True, jumps))
        self.assertEqual({e["axis"] for e in found["wrapped"]["first"]}, {"x"})
        self.assertEqual(len(found["wrapped"]["first"]), 5)
        self.assertEqual(found["advice"]["reason"], "wrapped")
        self.assertLess(found["displacement"]["quantiles"]["1"], 0.06)  # without the jumps
        self.assertEqual(found["displacement"]["total"], 300 * 29 - jumps)
        text = self.succeed("advise", "wrapped.csv").stdout
        self.assertRegex(self.line(text, "wrapped"), rf"\Ait seems so: {jumps} jumps by about the length of the box")
        self.assertTrue(self.line(text, "advice").startswith("Unwrap the trajectory"))
        found = self.advise(self.motion("steady.csv", steady))
        self.assertEqual((found["wrapped"]["suspected"], found["wrapped"]["jumps"]), (False, 0))

    def test_far_frames_are_not_wrapped(self):
        """Some points go by more than three quarters of the box, but more by half of it."""
        dice = random.Random(3)
        frames = [{i: (dice.random(), dice.random()) for i in range(200)} for _ in range(6)]
        found = self.advise(self.motion("a.csv", frames))
        self.assertGreater(found["wrapped"]["jumps"], 10)
        self.assertIs(found["wrapped"]["suspected"], False)
        self.assertGreater(found["displacement"]["quantiles"]["1"], 10)
        self.assertEqual(found["displacement"]["total"], 1000)
        self.assertEqual((found["advice"]["strategy"], found["advice"]["reason"]), ("rebuild", "far apart"))

    def test_gaps_of_frames(self):
        self.write("a.csv", "frame,id,x,y\n0,1,0,0\n0,2,1,0\n1,1,0,0\n1,2,1,0\n5,1,0,1\n5,2,1,0\n")
        self.assertEqual(self.advise("a.csv")["frame_distance"], {"least": 1, "most": 4})
        self.assertIn("--absent-frames", self.line(self.succeed("advise", "a.csv").stdout, "frames"))

    def test_a_periodic_box_is_ignored_and_announced(self):
        frame = ('4\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3\n'
                 'H .1 0 0\nH .2 .3 0\nH .5 .1 .4\nH 1 2 1\n')
        self.write("a.xyz", frame * 2)
        done = self.succeed("advise", "a.xyz", "--output", "out")
        self.assertRegex(done.stderr, r"\Aannulus: a.xyz:2: Lattice ignored: [^\n]*\n\Z")
        self.assertIn("--open", self.line(done.stdout, "periodic box"))
        found = json.loads((self.here / "out" / "advise.json").read_text(encoding="utf-8"))
        self.assertEqual(found["ignored"], ["box"])
        self.assertEqual(self.succeed("advise", "a.xyz", "--quiet").stderr, "")

    def test_points(self):
        """Files without a motion: tables without frames, meshes, one frame."""
        self.succeed("lloyd", "--points", 40, "--iterations", 2, "--output", "run", "--quiet")
        names = [self.xyz("a.xyz", [*tool.SPREAD, tool.SPREAD[2]]),
                 self.write("a.csv", "x,y\n" + "".join(f"{x},{y}\n" for x, y in [*tool.SPREAD, tool.SPREAD[2]]))]
        for name in names:
            found = self.advise(name)
            self.assertEqual((found["frames"], found["vertices"]["most"]), (1, 5), name)
            self.assertEqual(found["duplicates"]["first"], [{"frame": 0, "id": "5", "where_is": "2"}])
            self.assertEqual((found["displacement"], found["measured"], found["frame_distance"]), (None, None, None))
            self.assertEqual(found["advice"]["reason"], "one frame")
            self.assertGreater(found["degeneracy"]["tolerance"]["0.5"], 0)
        self.assertEqual(self.advise("run/final.mesh")["vertices"]["most"], 40)
        self.assertIn("5 vertices in 1 frame, dimension 2\n", self.succeed("advise", "a.xyz").stdout)

    def test_flat_points(self):
        text = self.succeed("advise", self.xyz("a.xyz", [(0, 0), (1, 1), (2, 2)])).stdout
        self.assertIn("fewer dimensions", self.line(text, "flat"))
        self.assertIsNone(self.advise("a.xyz")["degeneracy"])

    def test_formats(self):
        answers = []
        for format_name, suffix in (("xyz", "xyz"), ("csv", "csv"), ("lammps", "lammpstrj"), ("csv", "csv.gz")):
            self.succeed("generate", "orbit", "--points", 60, "--steps", 4, "--dim", 3, "--output", f"m.{suffix}")
            found = self.advise(f"m.{suffix}")
            answers.append({k: found[k] for k in ("displacement", "measured", "degeneracy", "box", "advice")})
        self.assertEqual(answers, [answers[0]] * 4)
        self.assertEqual(self.advise("m.csv", "--dim", 2)["dimension"], 2)
        found = self.advise("m.csv", "--columns", "x=y,y=x,z=z,frame=frame,id=id")
        self.assertEqual(found["box"]["low"][1], answers[0]["box"]["low"][0])
        self.refuse(3, "advise", "-", "--format", "csv")  # nothing there

    def test_standard_input(self):
        done = subprocess.run([tool.OPTIONS["tool"], "advise", "-", "--format", "xyz"], cwd=self.here, text=True,
                              input="3\n\na 0 0\na 1 0\na 0 1\n" * 2, capture_output=True, timeout=tool.HANGING,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("3 vertices in 2 frames, dimension 2\n", done.stdout)

    def test_refused(self):
        self.assertIn("missing.csv", self.refuse(3, "advise", "missing.csv"))
        self.write("late.csv", "frame,id,x,y\n0,1,0,0\n0,2,1,0\n1,1,0,0\n1,2,nan,0\n")
        self.assertIn("late.csv:5:", self.refuse(3, "advise", "late.csv", "--output", "out"))
        self.write("points.csv", "x,y\n0,0\n1,0\n0,nan\n")  # no motion: the fault is that of the points
        self.assertIn("points.csv:4:", self.refuse(3, "advise", "points.csv"))
        self.write("empty.xyz", "")
        self.refuse(3, "advise", "empty.xyz")
        self.write("cut.csv.gz", gzip.compress(b"frame,id,x,y\n0,1,0,0\n0,2,1,0\n")[:-3])
        self.assertIn("cut off", self.refuse(3, "advise", "cut.csv.gz"))
        self.xyz("a.xyz", tool.SPREAD)
        for words in (["advise"], ["advise", "a.xyz", "--steps", "-1"], ["advise", "a.xyz", "--dim", "4"],
                      ["advise", "a.xyz", "--format", "stl"], ["advise", "a.xyz", "--output", ""], ["advise", "-"],
                      ["advise", "a.xyz", "--columns", "x=1"]):
            self.refuse(2, *words)
        self.assertIn("no z", self.refuse(3, "advise", "a.xyz", "--dim", 3))

    def test_text_and_files(self):
        self.succeed("generate", "walk", "--points", 100, "--steps", 5, "--output", "w.csv")
        done = self.succeed("advise", "w.csv", "--output", "out")
        names = [line[:15].strip() for line in done.stdout.splitlines()]
        self.assertEqual(names[1:], ["dimension", "columns", "box", "mean spacing", "displacement", "duplicates", "ids",
                                     "wrapped", "degeneracy", "certificates", "tolerances", "expected gain",
                                     "counted cost", "moves", "seconds", "advice", "written to"])
        self.assertRegex(self.line(done.stdout, "advice"),
                         r"\AUse (auto|tolerances): a step costs [0-9.]+ rebuilds\.\Z")
        written = json.loads((self.here / "out" / "advise.json").read_text(encoding="utf-8"))
        self.assertEqual(written["command"], "annulus advise w.csv --output out")
        self.assertEqual([p.name for p in (self.here / "out").iterdir()], ["advise.json"])
        self.succeed("advise", "w.csv", "--output", "out", "--quiet")  # a directory with its own results is replaced
        done = self.succeed("advise", "w.csv", "--quiet", "--json")
        self.assertEqual((done.stdout, done.stderr), ("", ""))


if __name__ == "__main__":
    tool.main(__doc__)
