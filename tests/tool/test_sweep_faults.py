#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Former faults of `annulus sweep`: pipes, names, directories, journals.

usage: test_sweep_faults.py --tool=PATH [CLASS[.METHOD]...]
"""

import json
import os
import resource
import signal
import subprocess

import test_sweep
import tool

SMALL = "[[grid]]\npoints = 20\nseeds = 3\n"


class Specification(test_sweep.SweepTest):
    def refuse_spec(self, text, *words):
        fault = self.refuse(3, "sweep", self.write("spec.toml", text), "--output", "out")
        for word in words:
            self.assertIn(word, fault)

    def test_keys_of_very_many_parts(self):
        """The TOML parser uses stack for each part."""
        for key in ("a" + ".a" * 200_000, "\"a\"" + ".\"a\"" * 200_000):
            self.refuse_spec(f"\n{key} = 1\n" + SMALL, "spec.toml:2: ", "dots")
            self.refuse_spec(f"\n[{key}]\n" + SMALL, "spec.toml:2: ", "dots")
        self.sweep("title = \"" + 500 * "." + "\"\n" + SMALL, "out")

    def test_what_is_no_file(self):
        os.mkfifo(self.here / "pipe.xyz")
        for name in ("pipe.xyz", "/dev/zero"):
            self.refuse_spec(f"[[grid]]\nfile = \"{name}\"\n", "spec.toml:2: ", "'file'", name)

    def test_too_few_to_smooth(self):
        self.refuse_spec("[[grid]]\npoints = [30, 2]\nmotion = { kind = \"lloyd\", steps = 1 }\n", "spec.toml:2: ",
                         "'points'", "3 or more")
        self.refuse_spec("[[grid]]\npoints = 3\ndimension = 3\nmotion = { kind = \"nodt\", steps = 1 }\n",
                         "spec.toml:2: ", "'points'", "4 or more")

    def test_a_double_looks_like_one(self):
        self.refuse_spec("[[grid]]\npoints = 2.0\n", "spec.toml:2: ", "'points' is 2.0")

    def test_a_long_list(self):
        seeds = ", ".join(map(str, range(600_000)))
        self.write("spec.toml", f"[[grid]]\npoints = 20\nseeds = [{seeds}]\n")
        self.assertEqual(self.run_tool("sweep", "spec.toml", "--check").returncode, 0)

    def test_too_large_for_a_float(self):
        self.xyz("far.xyz", [(0.0, 0.0), (1e50, 0.0), (0.0, 1.0)])
        self.refuse_spec("[[grid]]\nfile = \"far.xyz\"\nrounding = \"float\"\n", "grid 1", "far.xyz", "float", "1e+50")

    def test_a_name_that_is_no_text(self):
        os.mkdir(self.here / os.fsdecode(b"d\xff"))
        name = os.path.join(os.fsdecode(b"d\xff"), os.fsdecode(b"s\xff.toml"))
        (self.here / name).write_text(SMALL, encoding="utf-8")
        self.succeed("sweep", name, "--output", "out", "--quiet")
        self.results("out")
        json.loads((self.here / "out" / "sums.json").read_text(encoding="utf-8"))


class Directory(test_sweep.SweepTest):
    def test_what_says_that_all_is_done(self):
        """All files must exist; sums.json may have any content."""
        whole = self.sweep(SMALL, "out")
        for name in test_sweep.FILES - {"sums.json"}:  # which identifies the sweep
            (self.here / "out" / name).unlink()
            self.succeed("sweep", "spec.toml", "--output", "out", "--quiet")
            self.assertEqual(self.results("out"), whole, name)
        (self.here / "mine").mkdir()
        for text in ("{\"command\": 3}", "[1]", "3",
                     "{\"command\": \"annulus sweep\", \"version\": {}, \"identity\": \"x\"}"):
            (self.here / "mine" / "sums.json").write_text(text, encoding="utf-8")
            self.assertEqual(self.refuse_or_none("mine"), not text.startswith("{\"command\": \"annulus"), text)
        os.mkdir(self.here / "pipes")
        os.mkfifo(self.here / "pipes" / "sums.json")
        self.refuse(3, "sweep", "spec.toml", "--output", "pipes")

    def refuse_or_none(self, directory):
        done = self.run_tool("sweep", "spec.toml", "--output", directory, "--quiet")
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return done.returncode == 3

    def test_files_that_change_places(self):
        """The bytes of both files in a row are the same."""
        spec = "[[grid]]\nfile = [\"a.xyz\", \"b.xyz\"]\n"
        lines = [b"0 0\n", b"1 0\n", b"0 1\n", b"3 1\n", b"7 3\n", b"2 2\n", b"5 1\n"]
        seen = set()
        for n in (3, 4):
            self.write("a.xyz", b"".join(lines[:n]))
            self.write("b.xyz", b"".join(lines[n:]))
            seen.add(self.sweep(spec, "out")["results.jsonl"])
        self.assertEqual(len(seen), 2)

    def test_nothing_is_left_of_what_came_to_nothing(self):
        self.write("bad.xyz", "1 2\n3 x\n")
        self.write("spec.toml", "[[grid]]\nfile = \"bad.xyz\"\n")
        for place in ("out", "out/", "a/b/c", "./d/../e/f"):
            self.refuse(3, "sweep", "spec.toml", "--output", place)


class Journal(test_sweep.SweepTest):
    def interrupt(self, lines):
        """Leaves a journal with this many lines, and returns them."""
        self.write("spec.toml", test_sweep.LONGER)
        done = self.run_tool("sweep", "spec.toml", "--output", "out", "--quiet",
                             env=tool.at(signal.SIGKILL, lines + 1, "pwrite", test_sweep.JOURNAL))
        self.assertEqual(done.returncode, -signal.SIGKILL, done.stderr)
        left = (self.here / "out" / test_sweep.JOURNAL).read_bytes().splitlines(keepends=True)
        self.assertEqual(len(left), lines)
        return left

    def test_force_begins_anew(self):
        self.interrupt(4)
        self.assertNotIn("before", self.succeed("sweep", "spec.toml", "--output", "out", "--force").stdout)

    def test_a_damaged_line(self):
        """A damaged line loses its trial, and no other."""
        lines = self.interrupt(6)
        whole = [line for line in lines if line.endswith(b"\n")]
        whole[3] = whole[3][:50] + bytes([whole[3][50] ^ 1]) + whole[3][51:]
        file = self.here / "out" / test_sweep.JOURNAL
        file.write_bytes(b"".join(whole))
        self.assertIn(f"of which {len(whole) - 2} were", self.succeed("sweep", "spec.toml", "--output", "out").stdout)
        self.assertEqual(self.results("out"), self.sweep(test_sweep.LONGER, "again"))

    def test_a_damaged_head(self):
        lines = self.interrupt(4)
        file = self.here / "out" / test_sweep.JOURNAL
        for damaged in (b"x" + b"".join(lines)[1:], b"".join(lines).replace(b"\n", b"\r\n"), b"something else\n",
                        b"of another program"):
            file.write_bytes(damaged)
            self.assertIn("damaged", self.refuse(3, "sweep", "spec.toml", "--output", "out"))
            self.assertEqual(file.read_bytes(), damaged)
        for cut in (0, 20, len(lines[0]) - 1):  # no trial was finished yet
            file.write_bytes(lines[0][:cut])
            done = self.run_tool("sweep", "spec.toml", "--output", "out", "--quiet",
                                 env=tool.at(signal.SIGKILL, 2, "pwrite", test_sweep.JOURNAL))
            self.assertEqual((done.returncode, done.stderr), (-signal.SIGKILL, ""))
            self.assertEqual(file.read_bytes(), lines[0])


class Limits(test_sweep.SweepTest):
    def test_threads_that_cannot_be_had(self):
        """Fewer threads give the same, and leave enough address space, which threads and then their work consume."""
        def run(megabytes, *words):
            return subprocess.run([tool.OPTIONS["tool"], *words], cwd=self.here, capture_output=True, text=True,
                                  timeout=tool.HANGING, check=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS,
                                                                        (megabytes << 20, megabytes << 20)))

        if run(300, "--version").returncode != 0:
            self.skipTest("a sanitizer's shadow needs more room")
        one = self.sweep(SMALL, "one")
        for megabytes in range(300, 720, 10):
            done = run(megabytes, "sweep", "spec.toml", "--output", "many", "--threads", "1000", "--quiet", "--force")
            self.assertEqual((done.returncode, done.stderr), (0, ""), megabytes)
            self.assertEqual(self.results("many"), one)


if __name__ == "__main__":
    tool.main(__doc__)
