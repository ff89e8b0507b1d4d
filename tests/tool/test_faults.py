#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the machine: full disks, no memory, no standard output, signals at any point.

usage: test_faults.py --tool=PATH [CLASS[.METHOD]...]
"""

import itertools
import json
import os
import resource
import signal
import subprocess
from pathlib import Path

import tool
from tool import OPTIONS, RUN_FILES, ToolTest

TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
MOTION = "frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n1,1,0.1,0\n1,2,1,0.1\n1,3,0,1\n"
LLOYD = ["lloyd", "--points", "60", "--iterations", "2"]


class Faults(ToolTest):
    def setUp(self):
        super().setUp()
        self.xyz("points.xyz", tool.SPREAD)
        self.write("motion.csv", MOTION)
        self.write("tetrahedron.off", TETRAHEDRON)
        self.succeed(*LLOYD, "--output", "plane", "--quiet")
        self.calls = [LLOYD, ["nodt", "--surface", "tetrahedron.off", "--vertices", "30", "--iterations", "1"],
                      ["replay", "motion.csv"], ["audit", "plane/final.mesh"], ["degeneracy", "points.xyz"],
                      ["advise", "motion.csv"], ["counterexample"]]

    def every_call(self, *options):
        """Every subcommand with `options`, which come before the motion of compare."""
        yield from (words + list(options) for words in self.calls)
        yield ["compare", *options, "--", *LLOYD]

    def run_with(self, words, **limits):
        """Under resource limits: RLIMIT_FSIZE=4096."""
        def limit():
            for name, value in limits.items():
                resource.setrlimit(getattr(resource, name), (value, value))
        return subprocess.run([OPTIONS["tool"], *map(str, words)], cwd=self.here, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=tool.HANGING, check=False, preexec_fn=limit)

    def assert_one_line(self, done, pattern, words):
        self.assertEqual(done.returncode, 4, f"{words}: {done.stderr}")
        self.assertRegex(done.stderr, r"\Aannulus: [^\n]*" + pattern + r"[^\n]*\n\Z", words)

    def test_standard_output_that_cannot_be_written(self):
        for words in [*self.every_call(), ["counterexample", "--json"], ["--help"], ["lloyd", "--help"], ["--version"],
                      ["compare", "--", "lloyd", "--help"]]:
            with self.subTest(words=words), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([OPTIONS["tool"], *words], cwd=self.here, stdin=subprocess.DEVNULL, stdout=full,
                                      stderr=subprocess.PIPE, text=True, timeout=tool.HANGING, check=False)
                self.assert_one_line(done, "standard output: (No space left on device|not all could be written)", words)

    def test_closed_streams(self):
        # A file of the results must not become standard output.
        done = subprocess.run([OPTIONS["tool"], *LLOYD, "--output", "out"], cwd=self.here, stderr=subprocess.PIPE,
                              text=True, timeout=tool.HANGING, check=False,
                              preexec_fn=lambda: (os.close(0), os.close(1)))
        self.assert_one_line(done, "standard output: Bad file descriptor", LLOYD)
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, RUN_FILES)
        for name in RUN_FILES:
            self.assertNotIn("certificates   ", (self.here / "out" / name).read_text(encoding="utf-8"))

    def test_a_full_disk(self):
        for words in self.every_call("--output", "out"):
            with self.subTest(words=words):
                before = self.listing()
                done = self.run_with(words, RLIMIT_FSIZE=100)
                self.assert_one_line(done, "out/.*: cannot be written: File too large", words)
                self.assertEqual((done.stdout, self.listing()), ("", before))

    def test_a_disk_that_fills_at_any_file(self):
        whole = self.here / "plane"
        sizes = sorted({p.stat().st_size for p in whole.iterdir()})
        self.succeed(*LLOYD, "--output", "out", "--quiet")
        old = {p.name: p.read_bytes() for p in (self.here / "out").iterdir()}
        # One file more each time. Halfway between two sizes: report.html holds times, and its size changes by a tenth.
        for smaller, larger in itertools.pairwise([0, *sizes]):
            done = self.run_with(LLOYD + ["--seed", "5", "--output", "out"], RLIMIT_FSIZE=(smaller + larger) // 2)
            self.assertEqual(done.returncode, 4)
            self.assertEqual({p.name: p.read_bytes() for p in (self.here / "out").iterdir()}, old)
        self.assertEqual([n for n in self.listing() if ".annulus" in n], [])

    def test_no_memory(self):
        if self.run_with(["--version"], RLIMIT_AS=1 << 30).returncode != 0:
            self.skipTest("cannot run in a gigabyte of addresses (sanitizers)")
        least = next(m for m in range(8, 1024, 2) if self.run_with(["--version"], RLIMIT_AS=m << 20).returncode == 0)
        self.xyz("grid.xyz", [(x, y, z) for x in range(24) for y in range(24) for z in range(24)])  # exact arithmetic
        for words in (["lloyd", "--points", "20000", "--iterations", "1"], ["degeneracy", "grid.xyz"]):
            failed = 0
            for more in (2, 4, 7, 10, 14):
                done = self.run_with(words + ["--output", "out"], RLIMIT_AS=(least + more) << 20)
                if done.returncode != 0:
                    failed += 1
                    self.assert_one_line(done, "out of memory", (words, more))
                    self.assertEqual([n for n in self.listing() if n.startswith(("out", "."))], [])
                else:
                    break
            self.assertGreater(failed, 1, words)


    def test_threads_that_cannot_be_had(self):
        """Fewer threads give the same results."""
        self.succeed("generate", "uniform", "--points", 20000, "--dim", 3, "--output", "many.xyz")
        for words, file in ((["lloyd", "--points", "20000", "--iterations", "2"], "final.vtu"),
                            (["degeneracy", "many.xyz"], "degeneracy.json"),
                            (["nodt", "--sphere", "--vertices", "500", "--iterations", "2"], "final.vtu")):
            found = []
            for threads, environment in ((1, None), (4, tool.with_threads(0)), (4, tool.with_threads(1))):
                done = self.run_tool(*words, "--threads", threads, "--output", "out", "--quiet", env=environment)
                self.assertEqual((done.returncode, done.stderr), (0, ""), words)
                text = (self.here / "out" / file).read_text(encoding="utf-8")
                found.append(json.loads(text)["bicells"] if file.endswith(".json") else text)
            self.assertEqual(found, [found[0]] * 3, words)


class Signals(ToolTest):
    LONG = ["lloyd", "--points", "300", "--iterations", "100000000", "--audit", "0"]

    def interrupted(self, number, *words, partial="out.partial", steps=r"[1-9]\d*"):
        """Interrupts at one of the calls of the clock, of which every step has some and the start has few."""
        done = self.run_tool(*words, env=tool.at(number, 1000, "clock"))
        self.assertEqual((done.returncode, done.stdout), (-number, ""))
        self.assertRegex(done.stderr,
                         rf"\Aannulus: interrupted after {steps} of \d+ steps; what was done is in {partial}\n\Z")
        self.assertFalse((self.here / "out").exists())
        return self.here / partial

    def test_an_interrupted_run_keeps_what_it_has(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            partial = self.interrupted(number, *self.LONG, "--output", "out")  # the second and third replace it
            self.assertEqual({p.name for p in partial.iterdir()}, RUN_FILES)
            summary = self.summary("out.partial")
            self.assertIs(summary["interrupted"], True)
            self.assertEqual(summary["moves"]["asked"], 300 * summary["iterations"])
            self.succeed("audit", "out.partial/final.mesh")
            rows = (partial / "iterations.csv").read_text(encoding="utf-8").splitlines()
            self.assertEqual(len(rows), summary["iterations"] + 1)
            self.assertIn("was interrupted after", (partial / "report.html").read_text(encoding="utf-8"))
        self.assertEqual([n for n in self.listing() if ".annulus" in n], [])

    def test_in_space_and_in_comparison(self):
        partial = self.interrupted(signal.SIGTERM, "nodt", "--sphere", "--vertices", "60", "--iterations", "100000000",
                                   "--audit", "0", "--output", "out")
        self.assertIn("domain.mesh", {p.name for p in partial.iterdir()})
        self.assertIs(self.summary("out.partial")["interrupted"], True)
        # It records steps before any strategy follows them.
        partial = self.interrupted(signal.SIGTERM, "compare", "--output", "out", "--", *self.LONG, steps=r"\d+")
        comparison = json.loads((partial / "compare.json").read_text(encoding="utf-8"))
        self.assertIs(comparison["interrupted"], True)
        self.assertNotIn("agree", comparison)
        self.assertNotIn("ratios", comparison)

    def test_a_run_that_is_done_is_not_interrupted(self):
        self.succeed(*self.LONG[:3], "--iterations", "3", "--output", "out", "--quiet")
        self.assertNotIn("interrupted", self.summary("out"))

    def test_nothing_to_keep(self):
        done = self.run_tool(*self.LONG, env=tool.at(signal.SIGTERM, 1000, "clock"))
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", -signal.SIGTERM))
        self.assertEqual(self.listing(), [])

    def test_killed_at_any_change(self):
        """The old directory or the new one is complete under its name; other remains are hidden and do not disturb.
        Kills before each call that changes a file; all other times leave the same files as one of these."""
        words = ["lloyd", "--points", "60", "--iterations", "2", "--quiet", "--output", "out"]
        for target in ("new", "old"):
            for number in (signal.SIGKILL, signal.SIGTERM):
                self.succeed(*words)
                final, ended = [], 0
                for count in itertools.count(1):
                    if target == "new":
                        self.clear()
                    done = self.run_tool(*words, "--seed", "7", env=tool.at(number, count, "change"))
                    ended += done.returncode == -number
                    out = self.here / "out"
                    if out.exists() or target == "old":
                        self.assertEqual({p.name for p in out.iterdir()}, RUN_FILES, (target, number, count))
                        final.append(self.summary("out")["seed"])
                        self.assertIn(final[-1], (1, 7))
                        (out / "final.vtu").read_text(encoding="utf-8").index("</VTKFile>")
                    if number == signal.SIGTERM:
                        self.assertLessEqual(set(self.listing_of_top()), {"out", "out.partial"} | self.litter)
                    self.litter = {n for n in self.listing_of_top() if n.startswith(".annulus-")}
                    if done.returncode == 0:
                        break
                    self.assertEqual((done.returncode, done.stdout), (-number, ""), (target, number, count))
                self.assertGreater(ended, 10, "the places are not found")
                self.assertEqual(final[-1], 7)
                self.clear()

    litter = set()

    def listing_of_top(self):
        return [p.name for p in self.here.iterdir()]

    def clear(self):
        for p in sorted(self.here.rglob("*"), reverse=True):
            if p.is_dir():
                p.rmdir()
            else:
                p.unlink()
        self.litter = set()


if __name__ == "__main__":
    tool.main(__doc__)
