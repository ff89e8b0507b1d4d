#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus` on files that are read as streams: pipes, packed, long and broken files.

usage: test_streams.py --tool=PATH [CLASS[.METHOD]...]"""

import gzip
import resource
import signal
import subprocess

import tool

CSV = ("frame,id,x,y\n" + "".join(f"{f},{i},{i % 3 + 0.01 * f!r},{i // 3 + 0.1 * (i % 3)!r}\n" for f in range(4)
                                  for i in range(9)))
XYZ = "".join("9\n\n" + "".join(f"{i % 3 + 0.01 * f!r} {i // 3 + 0.1 * (i % 3)!r}\n" for i in range(9))
              for f in range(4))
LAMMPS = "".join(
    f"ITEM: TIMESTEP\n{100 * f}\nITEM: NUMBER OF ATOMS\n9\nITEM: BOX BOUNDS ff ff ff\n0 3\n0 3\n-0.5 0.5\nITEM: ATOMS "
    "id type x y z\n" +
    "".join(f"{i + 1} 1 {i % 3 + 0.01 * f!r} {i // 3 + 0.1 * (i % 3)!r} 0\n" for i in reversed(range(9)))
    for f in range(4))


class Streams(tool.ToolTest):
    def fed(self, text, *words):
        """The tool with these bytes on standard input."""
        if isinstance(text, str):
            text = text.encode()
        done = subprocess.run([tool.OPTIONS["tool"], *words], cwd=self.here, input=text, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=tool.HANGING, check=False)
        done.stdout, done.stderr = done.stdout.decode(), done.stderr.decode()
        return done

    def last_positions(self):
        return sorted(self.mesh("out")[0])

    def test_every_format_from_a_file_a_packed_one_and_standard_input(self):
        expected = sorted((i % 3 + 0.03, i // 3 + 0.1 * (i % 3)) for i in range(9))
        for name, extension, text in (("csv", ".csv", CSV), ("xyz", ".xyz", XYZ), ("lammps", ".lammpstrj", LAMMPS),
                                      ("lammps", ".DUMP", LAMMPS)):
            with self.subTest(name=name, extension=extension):
                for file, content in (("a" + extension, text), ("a" + extension + ".gz", gzip.compress(text.encode())),
                                      ("a.txt", text)):
                    words = ["--format", name] if file == "a.txt" else []
                    self.succeed("replay", self.write(file, content), *words, "--audit", "1", "--output", "out",
                                 "--quiet")
                    self.assertEqual(self.last_positions(), expected)
                for content in (text, gzip.compress(text.encode()), "\ufeff" + text):
                    done = self.fed(content, "replay", "-", "--format", name, "--audit", "1", "--output", "out")
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    self.assertIn(" 3 iterations", done.stdout)
                    self.assertEqual(self.last_positions(), expected)

    def test_points_from_standard_input(self):
        done = self.fed("0 0\n1 0\n0 1\n1 1.5\n", "degeneracy", "-", "--format", "xyz")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("4 points in dimension 2", done.stdout)
        done = self.fed("0,0\n1,0\n0,1\n", "lloyd", "--input", "-", "--format", "csv", "--iterations", "2")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = self.fed("0 0\n1 nan\n", "degeneracy", "-", "--format", "xyz")
        self.assertEqual((done.returncode, done.stderr),
                         (3, "annulus: standard input:2: y is nan: 'nan'; expected a finite number\n"))

    def test_what_standard_input_is_has_to_be_said(self):
        for words in (["replay", "-"], ["degeneracy", "-"], ["lloyd", "--input", "-"]):
            self.assertIn("--format", self.refuse(2, *words))
        self.refuse(2, "replay", "a.xyz", "--format", "off")
        self.refuse(2, "degeneracy", "a.xyz", "--format", "stl")

    def test_nothing_or_rubbish_comes(self):
        for name in ("xyz", "csv", "lammps"):
            for content, fault in ((b"", "is empty"), (b"\n" * 1_000_000, "has no frames"), (b"\x1f\x8b", "is cut off"),
                                   (b"\x00" * 1000, ""),
                                   (gzip.compress(XYZ.encode())[:-9], "is cut off" if name == "xyz" else "")):
                done = self.fed(content, "replay", "-", "--format", name)
                self.assertEqual((done.returncode, done.stdout), (3, ""), (name, content[:20]))
                self.assertRegex(done.stderr, rf"\Aannulus: standard input:\d+: .*({fault}).*; expected [^\n]+\n\Z")

    def test_a_pipe_is_flat_or_not_by_its_first_points(self):
        flat, bent = "1 0 7\n0 1 7\n0 0 7\n", "1 0 7\n0 1 7\n0 0 8\n"
        frames = ["3\n\n" + rows for rows in (flat, flat, bent)]
        done = self.fed("".join(frames), "replay", "-", "--format", "xyz")
        self.assertEqual(done.returncode, 3)
        self.assertIn("standard input:15: z is not that of all points before; expected --dim 3, or --dim 2 to drop z",
                      done.stderr)
        for dim in "23":
            self.assertEqual(self.fed("".join(frames), "replay", "-", "--format", "xyz", "--dim", dim).returncode, 0)
        self.succeed("replay", self.write("a.xyz", "".join(frames)), "--output", "out")  # which is read until z differs
        self.assertEqual(self.summary("out")["dimension"], 3)

    def test_what_was_done_before_a_fault_is_kept(self):
        broken = XYZ + "9\n\n0 0\n"
        line = self.refuse(3, "replay", self.write("a.xyz", broken))
        self.assertIn("a.xyz:47: the file ends after 1 of 9 points; expected 8 more", line)
        done = self.run_tool("replay", "a.xyz", "--output", "out")
        self.assertEqual((done.returncode, done.stdout), (3, ""))
        self.assertEqual(done.stderr, line + "; what was done before is in out.partial\n")
        self.assertEqual({p.name for p in (self.here / "out.partial").iterdir()}, tool.RUN_FILES)
        self.assertFalse((self.here / "out").exists())
        summary = self.summary("out.partial")
        self.assertEqual((summary["iterations"], summary["interrupted"]), (3, True))
        self.succeed("audit", "out.partial/final.mesh")

    def test_a_fault_in_the_first_step_leaves_nothing(self):
        self.write("a.xyz", "2\n\n0 0\n1 0\n2\n\n0 0\n")
        self.refuse(3, "replay", "a.xyz", "--output", "out")

    def test_an_interrupted_pipe(self):
        """The signal comes while the run waits for a pipe that has no more data and no end."""
        words = ["replay", "-", "--format", "xyz", "--output", "out"]
        run = subprocess.Popen([tool.OPTIONS["tool"], *words], cwd=self.here, stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env=tool.at(signal.SIGSTOP, 2, "read", "pipe:"))
        self.addCleanup(lambda: (run.kill(), run.communicate()))
        run.stdin.write((XYZ + "9\n").encode())  # in one piece, which the first read returns
        run.stdin.flush()
        tool.until_it_stops(run)
        run.send_signal(signal.SIGINT)
        run.send_signal(signal.SIGCONT)
        out, err = run.communicate(timeout=tool.HANGING)  # its other end goes, as on a terminal
        self.assertEqual((run.returncode, out), (-signal.SIGINT, b""))
        self.assertEqual(err, b"annulus: interrupted after 3 steps; what was done is in out.partial\n")
        self.assertEqual(self.summary("out.partial")["iterations"], 3)

    def fits(self, megabytes, *words):
        """Whether a run succeeds with this limit of private memory, counted at allocation: resident memory depends on
        the load of the machine."""
        limit = lambda: resource.setrlimit(resource.RLIMIT_DATA, (megabytes << 20, megabytes << 20))
        return self.run_tool(*words, preexec_fn=limit).returncode == 0

    def test_memory_does_not_grow_with_the_length_of_a_file(self):
        for name in ("a.xyz", "a.csv", "a.lammpstrj", "a.xyz.gz"):
            for steps in (20, 1000):
                self.succeed("generate", "walk", "--points", "500", "--pace", "0.001", "--steps", steps, "--output",
                             name, "--force")
                if steps == 20:
                    least = next(m for m in range(1, 1000) if self.fits(m, "replay", name, "--audit", "0"))
            self.assertGreater((self.here / name).stat().st_size, 5 << 20)
            self.assertTrue(self.fits(least + 1, "replay", name, "--audit", "0"), (name, least))


if __name__ == "__main__":
    tool.main(__doc__)
