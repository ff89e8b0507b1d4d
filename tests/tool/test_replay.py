#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus replay` and checks its output. usage: test_replay.py --tool=PATH [CLASS[.METHOD]...]"""

import math
import random

import tool


def wander(frames, points, seed, step):
    """Frames as {id: (x, y)}: points walk, and sometimes one leaves or arrives."""
    dice = random.Random(seed)
    now = {i: (dice.random(), dice.random()) for i in range(points)}
    fresh = points
    result = []
    for _ in range(frames):
        result.append(dict(now))
        now = {i: (x + step * dice.gauss(0, 1), y + step * dice.gauss(0, 1)) for i, (x, y) in now.items()}
        for _ in range(dice.randrange(3)):
            del now[dice.choice(sorted(now))]
        for _ in range(dice.randrange(3)):
            now[fresh] = (dice.random(), dice.random())
            fresh += 1
    return result


def as_csv(frames, seed=0):
    rows = []
    for f, frame in enumerate(frames):
        lines = [f"{10 * f},{i},{x!r},{y!r}" for i, (x, y) in frame.items()]
        random.Random(seed + f).shuffle(lines)  # points of a frame may come in any order
        rows += lines
    return "frame,id,x,y\n" + "\n".join(rows) + "\n"


class Replay(tool.ToolTest):
    def test_a_failed_audit(self):
        """Five points (annulus counterexample) that move by less than the paper's tolerances: three cells remain where
        two are right."""
        rows = ["frame,id,x,y,z"]
        for frame, (height, radius) in enumerate([(0.99, 1.0), (0.997, 0.993)]):
            turns = [2 * math.pi * k / 3 for k in range(3)]
            points = [(0, 0, height), (0, 0, -height)] + [(radius * math.cos(t), radius * math.sin(t), 0)
                                                          for t in turns]
            rows += [f"{frame},{i},{x!r},{y!r},{z!r}" for i, (x, y, z) in enumerate(points)]
        self.write("spindle.csv", "\n".join(rows) + "\n")
        for kind, status in (("paper", 1), ("certified", 0)):
            done = self.run_tool("replay", "spindle.csv", "--strategy", "paper", "--tolerance", kind, "--output", kind)
            self.assertEqual(done.returncode, status, done.stderr)
            self.assertEqual("1 of 1 FAILED; first: step 1: not locally Delaunay" in done.stdout, status == 1)
            self.assertEqual(self.summary(kind)["audit"], {"checked": 1, "failed": status})

    def check(self, name, last, *words):
        self.succeed("replay", name, "--audit", "1", "--output", "out", "--quiet", *words)
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, tool.RUN_FILES)
        self.assertEqual(sorted(self.mesh("out")[0]), sorted(last))
        if len(last) > 2:
            self.succeed("audit", "out/final.mesh")
        summary = self.summary("out")
        self.assertEqual(summary["audit"]["failed"], 0)
        return summary

    def test_every_strategy_with_points_that_come_and_go(self):
        frames = wander(25, 60, 1, 0.01)
        self.assertTrue(any(set(a) - set(b) for a, b in zip(frames, frames[1:])))
        self.write("walk.csv", as_csv(frames))
        asked = sum(len(set(a) & set(b)) for a, b in zip(frames, frames[1:]))
        for strategy in tool.STRATEGIES:
            with self.subTest(strategy=strategy):
                summary = self.check("walk.csv", frames[-1].values(), "--strategy", strategy)
                self.assertEqual(summary["iterations"], 24)
                self.assertEqual(summary["moves"]["asked"], asked)
                self.assertEqual(summary["audit"]["checked"], 24)

    def test_what_came_and_went_is_said(self):
        frames = [{0: (0, 0), 1: (1, 0), 2: (0, 1), 3: (1, 1.5)},
                  {1: (1, 0), 2: (0, 1), 3: (1, 1.5), 7: (3, 3), 9: (0, 0)}]
        self.write("a.csv", as_csv(frames))
        self.assertIn("2 points appeared, 1 disappeared", self.succeed("replay", "a.csv").stdout)

    def test_a_point_may_take_the_place_that_another_leaves(self):
        frames = [{0: (0, 0), 1: (1, 0), 2: (0, 1)}, {0: (1, 0), 1: (0, 0), 2: (0, 1)},
                  {1: (1, 0), 2: (0, 1), 5: (0, 0)}]
        self.write("a.csv", as_csv(frames))
        self.check("a.csv", frames[-1].values())

    def test_everything_leaves_and_other_points_come(self):
        frames = [{i: (i % 3, i // 3 + 0.1 * i) for i in range(6)}, {i: (i % 2 + 0.01 * i, i) for i in range(10, 18)}]
        self.write("a.csv", as_csv(frames))
        for strategy in tool.STRATEGIES:
            with self.subTest(strategy=strategy):
                self.check("a.csv", frames[1].values(), "--strategy", strategy)

    def test_xyz(self):
        frames = [{i: (random.Random(i).random() + 0.01 * f, random.Random(-i).random()) for i in range(9)}
                  for f in range(4)]
        plain = "".join("9\n\n" + "".join(f"{x!r} {y!r}\n" for x, y in f.values()) for f in frames)
        atoms = "".join("9\nstep\n" + "".join(f"H {x!r} {y!r} 0.5\n" for x, y in f.values()) for f in frames)
        extended = "".join("9\nTime=1 Properties=mass:R:1:species:S:1:pos:R:3:q:I:2 pbc=F\n" +
                           "".join(f"1.5 H {x!r} {y!r} 7 1 2\n" for x, y in f.values()) for f in frames)
        for text in (plain, atoms, extended):
            self.write("a.xyz", text)
            self.check("a.xyz", frames[-1].values())

    def solid(self, name, *words):
        """final.mesh of a replay in 3D: points and tetrahedra."""
        self.succeed("replay", name, "--audit", "1", "--output", "out", "--quiet", *words)
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, tool.RUN_FILES)
        summary = self.summary("out")
        self.assertEqual((summary["dimension"], summary["audit"]["failed"]), (3, 0))
        text = (self.here / "out" / "final.mesh").read_text(encoding="utf-8").split()
        at = text.index("Vertices")
        points = [tuple(map(float, text[at + 2 + 4 * i:at + 5 + 4 * i])) for i in range(int(text[at + 1]))]
        return points, int(text[text.index("Tetrahedra") + 1]) if "Tetrahedra" in text else 0

    def test_points_that_come_and_go_in_space(self):
        dice = random.Random(3)
        frames = [{i: (x, y, dice.random()) for i, (x, y) in f.items()} for f in wander(12, 40, 2, 0.01)]
        text = "frame,id,x,y,z\n" + "".join(
            f"{f},{i},{x!r},{y!r},{z!r}\n" for f, frame in enumerate(frames) for i, (x, y, z) in frame.items())
        self.write("walk.csv", text)
        for strategy in tool.STRATEGIES:
            for words in ((), ("--dim", "3")):
                with self.subTest(strategy=strategy, words=words):
                    points, cells = self.solid("walk.csv", "--strategy", strategy, *words)
                    self.assertEqual(sorted(points), sorted(frames[-1].values()))
                    self.assertGreater(cells, len(points))
        # Without its z it is a 2D motion.
        self.check("walk.csv", [p[:2] for p in frames[-1].values()], "--dim", "2")

    def test_flat_frames_of_space(self):
        flat = {i: (i % 3 + 0.1 * (i // 3), float(i // 3), 0.0) for i in range(9)}
        line = {i: (float(i), 2.0 * i, 3.0 * i) for i in range(9)}
        solid = {i: (x, y, float(i * i % 5)) for i, (x, y, _) in flat.items()}
        for frames in ([solid, flat], [flat, line, solid], [line, flat], [solid, line]):
            text = "".join(f"9\n\n" + "".join(f"H {x!r} {y!r} {z!r}\n" for x, y, z in f.values()) for f in frames)
            self.write("a.xyz", text)
            points, cells = self.solid("a.xyz", "--dim", "3")
            self.assertEqual(points, list(frames[-1].values()))
            self.assertEqual(cells > 0, frames[-1] is solid)

    def test_ids_of_extended_xyz(self):
        # The same points in another order at every step: a reader that takes positions in the file as ids would see
        # them all jump.
        dice = random.Random(5)
        points = {i: (dice.random(), dice.random()) for i in range(3, 90, 3)}
        text = ""
        for _ in range(6):
            order = list(points)
            dice.shuffle(order)
            text += f'{len(points)}\nProperties="id:I:1:mass:R:1:pos:R:2" pbc="F F F"\n'
            text += "".join(f"{i} 7.5 {points[i][0]!r} {points[i][1]!r}\n" for i in order)
        self.write("a.xyz", text)
        summary = self.check("a.xyz", points.values())
        self.assertEqual(summary["moves"]["asked"], 5 * len(points))
        self.assertEqual(summary["moves"]["within_tolerance"], 5 * len(points))

    def test_whether_it_went_in_the_plane_or_in_space_is_said(self):
        rows = "3\n\nH 0 0 {0}\nH 1 0 {0}\nH 0 1 {1}\n"
        self.write("flat.xyz", rows.format(0.5, 0.5))
        self.write("solid.xyz", rows.format(0.5, 1.5))
        self.write("plane.xyz", "3\n\n0 0\n1 0\n0 1\n")
        for words, said in ((["flat.xyz"], "2: z is the same everywhere: 0.5"), (["solid.xyz"], "3"),
                            (["plane.xyz"], "2"), (["solid.xyz", "--dim", "2"], "2: --dim 2 drops z"),
                            (["flat.xyz", "--dim", "3"], "3")):
            done = self.succeed("replay", *words, "--output", "out")
            self.assertIn(f"\ndimension      {said}\n", done.stdout)
            page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
            self.assertIn(f"in {said[0]}D", page)
            self.assertIn(said[3:], page)
            self.assertEqual("z" in self.summary("out")["columns"], said == "3")

    def test_frames_without_points(self):
        cloud = {i: (i % 3 + 0.1 * (i // 3), float(i // 3)) for i in range(9)}
        frame = "9\n\n" + "".join(f"{x!r} {y!r}\n" for x, y in cloud.values())
        for text, last, vertices in ((("0\n\n" + frame) * 2, cloud, 9), (frame + "0\n\n", {}, 0)):
            self.write("a.xyz", text)
            for strategy in tool.STRATEGIES:
                with self.subTest(strategy=strategy, last=len(last)):
                    summary = self.check("a.xyz", last.values(), "--strategy", strategy)
                    self.assertEqual(summary["vertices"], vertices)
        solid = "9\n\n" + "".join(f"H {x!r} {y!r} {i * i % 5}\n" for i, (x, y) in cloud.items())
        self.write("a.xyz", "0\n\n" + solid + "0\n\n" + solid)
        self.assertEqual(len(self.solid("a.xyz")[0]), 9)

    def test_absent_frames(self):
        rows = "".join(f"{f},{i},{i % 3}.{f},{i // 3}\n" for f in (0, 1, 2, 4) for i in range(9))
        self.write("a.csv", "frame,id,x,y\n" + rows)
        line = self.refuse(3, "replay", "a.csv")
        self.assertIn("a.csv:29: frame 4 after frame 2", line)
        self.assertIn("--absent-frames", line)
        done = self.succeed("replay", "a.csv", "--absent-frames", "skip")
        self.assertIn(" 3 iterations", done.stdout)
        self.assertIn("0 points appeared, 0 disappeared", done.stdout)
        done = self.succeed("replay", "a.csv", "--absent-frames", "empty", "--audit", "1")
        self.assertIn(" 4 iterations", done.stdout)
        self.assertIn("9 points appeared, 9 disappeared", done.stdout)
        self.refuse(2, "replay", "a.csv", "--absent-frames", "perhaps")

    def test_points_at_one_place(self):
        frames = [{1: (0, 0), 2: (1, 0), 3: (0, 1), 4: (1, 1.5)}, {1: (0, 0), 2: (1, 0), 3: (1, 0), 4: (1, 1.5)},
                  {1: (0, 0), 2: (0, 1), 3: (1, 0), 4: (1, 1.5)}]
        self.write("a.csv", as_csv(frames))
        line = self.refuse(3, "replay", "a.csv")
        self.assertRegex(line, r"a.csv:\d+: in frame 10 the point of id 3 is where that of id 2 is \(line \d+\)")
        self.assertIn("--coincident merge", line)
        for strategy in tool.STRATEGIES:
            with self.subTest(strategy=strategy):
                self.check("a.csv", frames[-1].values(), "--strategy", strategy, "--coincident", "merge")
        done = self.succeed("replay", "a.csv", "--coincident", "merge")
        self.assertIn("1 point appeared, 1 disappeared, 1 merged", done.stdout)
        self.write("b.csv", as_csv(frames[1:]))
        self.check("b.csv", frames[-1].values(), "--coincident", "merge")

    def test_no_z(self):
        self.write("a.csv", "frame,id,x,y\n0,1,2,3\n")
        self.assertRegex(self.refuse(3, "replay", "a.csv", "--dim", "3"), "a.csv: points have no z")

    def test_one_frame(self):
        self.write("a.csv", "id,frame,y,x,other\n5,3,0,0,a\n6,3,0,1,b\n7,3,1,0,c\n")
        summary = self.check("a.csv", [(0, 0), (1, 0), (0, 1)])
        self.assertEqual(summary["iterations"], 0)

    def test_bad_input(self):
        for name, text, message in (
            ("a.csv", "frame,id,x\n", "a.csv:1: .*no column y"),
            ("b.csv", "frame,id,x,y\n0,1,2,3\n0,1,3,4\n", "b.csv:3: has the id 1 of line 2, in the same frame"),
            ("d.csv", "frame,id,x,y\n1,1,2,3\n1,2,3\n", "d.csv:3: has 3 columns"),
            ("e.csv", "frame,id,x,y\n1,1,2,3\n1,2,nan,3\n", "e.csv:3: x is nan"),
            ("f.csv", "frame,id,x,y\n0,1,2,3\n0,2,2.0,3\n0,3,9,9\n", "f.csv:3: .*line 2"),
            ("g.csv", "frame,id,x,y\n0,1,2,3\n0,2,5,3\n0,3,9,1e200\n", "g.csv:4: .*out of domain"),
            ("h.csv", "frame,id,x,y\n", "h.csv:1: has no frames"),
            ("a.xyz", "2\n\n0 0\n", "a.xyz:3: the file ends after 1 of 2"),
            ("b.xyz", "0\n\n", "b.xyz:1: has no points in any frame"),
            ("w.xyz", "1\nProperties=a:S:18446744073709551615:pos:R:3\nH 0 0 0\n",
             "w.xyz:2: .*'a'.* columns; expected"),
            ("w.csv", "frame,id,x,y\n1,1,2,3\n1,2,4,3\n2,1,2,3\n4,1,2,3\n", "w.csv:5: frame 4 .*expected frame 3"),
            ("c.xyz", "1\n\n0 0\n1\n\n0 0 0\n", "c.xyz:6: a frame has a z"),
            ("d.xyz", "1\nProperties=species:S:1\nH\n", "d.xyz:2: Properties have no pos"),
            ("a.pp", "0 0\n", "a.pp: has the unknown extension"),
        ):
            self.write(name, text)
            self.assertRegex(self.refuse(3, "replay", name), message)
        self.refuse(3, "replay", "missing.csv")
        self.refuse(2, "replay")
        self.refuse(2, "replay", "a.xyz", "--dim", "4")


if __name__ == "__main__":
    tool.main(__doc__)
