#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` and stops it: threads, kills, interruptions, ranks.

usage: test_sweep_resumed.py --tool=PATH --mpirun=PATH [CLASS[.METHOD]...]     (--mpirun=none: a build without MPI)
"""

import os
import random
import signal
import subprocess
import time

import test_sweep
import tool
from test_sweep import FILES, JOURNAL, LONGER, SPEC


class Interrupted(test_sweep.SweepTest):
    def test_threads_and_memory(self):
        one = self.sweep(SPEC, "one")
        for i, words in enumerate((["--threads", "4"], ["--threads", "3", "--memory", "0.002"])):
            self.assertEqual(self.sweep(SPEC, f"more{i}", *words), one)

    def start(self, *launcher, threads=2):
        return subprocess.Popen([*launcher, tool.OPTIONS["tool"], "sweep", "spec.toml", "--output", "out", "--quiet", "--threads", str(threads)],
                                cwd=self.here, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)

    def journal_lines(self):
        try:
            return (self.here / "out" / JOURNAL).read_bytes().count(b"\n")
        except FileNotFoundError:
            return 0

    def wait_for_lines(self, run, n):
        while run.poll() is None and self.journal_lines() < n:
            time.sleep(0.01)

    def test_killed_at_any_time(self):
        whole = self.sweep(LONGER, "whole")
        dice = random.Random()
        seed = dice.randrange(10**6)
        print("seed of the kills:", seed)
        dice.seed(seed)
        kept = 0
        for turn in range(4):
            run = self.start()
            self.wait_for_lines(run, kept + dice.randrange(2, 7))
            run.kill()
            run.wait()
            run.stderr.close()
            if not (self.here / "out" / JOURNAL).exists():
                break
            lines = self.journal_lines()
            self.assertGreaterEqual(lines, kept)  # nothing is lost
            kept = lines
            if turn == 1:  # as a crash of the machine may leave it
                with open(self.here / "out" / JOURNAL, "ab") as journal:
                    journal.write(b"1234abcd {\"trial\":0,\"li")
        self.succeed("sweep", "spec.toml", "--output", "out", "--quiet")
        self.assertEqual(self.results("out"), whole)

    def test_interrupted(self):
        whole = self.sweep(LONGER, "whole")
        run = self.start()
        self.wait_for_lines(run, 3)
        run.send_signal(signal.SIGINT)
        text = run.communicate()[1]
        self.assertEqual(run.returncode, -signal.SIGINT)
        self.assertRegex(text, r"\Aannulus: interrupted: \d+ of 30 trials are kept in out, [^\n]+\n\Z")
        self.assertEqual([p.name for p in (self.here / "out").iterdir()], [JOURNAL])
        done = self.succeed("sweep", "spec.toml", "--output", "out")
        self.assertRegex(done.stdout, r"of which [1-9]\d* were done before")
        self.assertEqual(self.results("out"), whole)

    def test_what_is_done_is_not_done_again(self):
        before = self.sweep(SPEC, "out")
        stamp = (self.here / "out" / "costs.jsonl").read_bytes()
        self.assertIn("already", self.succeed("sweep", "spec.toml", "--output", "out").stdout)
        self.assertEqual((self.here / "out" / "costs.jsonl").read_bytes(), stamp)
        self.assertEqual(self.sweep(SPEC, "out", "--force"), before)
        self.assertNotEqual((self.here / "out" / "costs.jsonl").read_bytes(), stamp)
        # Another specification may take the place of results that are whole, as with every subcommand.
        self.sweep("[[grid]]\npoints = 20\n", "out")
        self.assertEqual(len(self.lines("out")), 1)

    def test_another_specification(self):
        self.write("spec.toml", LONGER)
        run = self.start()
        self.wait_for_lines(run, 2)
        self.assertIn("another sweep is writing", self.refuse_now("sweep", "spec.toml", "--output", "out"))
        run.kill()
        run.wait()
        run.stderr.close()
        other = self.write("other.toml", "[[grid]]\npoints = 20\n")
        self.assertIn("another specification", self.refuse_now("sweep", other, "--output", "out"))
        self.succeed("sweep", other, "--output", "out", "--quiet", "--force")
        self.assertEqual(len(self.lines("out")), 1)

    def refuse_now(self, *words):
        done = self.run_tool(*words)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, r"\Aannulus: [^\n]+\n\Z")
        return done.stderr

    def test_a_directory_of_others(self):
        self.write("spec.toml", "[[grid]]\npoints = 20\n")
        (self.here / "out").mkdir()
        self.write("out/mine", "")
        self.refuse(3, "sweep", "spec.toml", "--output", "out")
        self.succeed("sweep", "spec.toml", "--output", "out", "--force", "--quiet")
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, FILES | {"mine"})


class Ranks(Interrupted):
    def setUp(self):
        super().setUp()
        if tool.OPTIONS["mpirun"].endswith("none"):
            self.skipTest("this build has no MPI")

    def mpirun(self, n):
        words = [tool.OPTIONS["mpirun"], "-n", str(n), "--oversubscribe"]
        return words + ["--allow-run-as-root"] if os.getuid() == 0 else words

    def run_ranks(self, n, *words, status=0):
        done = subprocess.run([*self.mpirun(n), tool.OPTIONS["tool"], "sweep", *words], cwd=self.here, capture_output=True, text=True, timeout=120,
                              check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_any_number_of_ranks(self):
        one = self.sweep(SPEC, "one")
        for n, threads in ((2, 1), (4, 1), (2, 2)):
            done = self.run_ranks(n, "spec.toml", "--output", f"{n}x{threads}", "--threads", str(threads))
            self.assertEqual(done.stdout.count("written to"), 1)
            self.assertEqual(self.results(f"{n}x{threads}"), one)
        ranks = {line["rank"] for line in self.lines("4x1", "costs.jsonl")}
        self.assertGreater(len(ranks), 1, "one rank did everything")

    def test_faults_come_once(self):
        self.write("bad.xyz", "1 2\n3 x\n")
        self.write("spec.toml", "[[grid]]\npoints = 20\nseeds = 40\n[[grid]]\nfile = \"bad.xyz\"\n")
        for words, status, line in ((["spec.toml", "--output", "out"], 3, "bad.xyz:2: "), (["missing.toml", "--output", "out"], 3, "missing.toml"),
                                    (["spec.toml"], 2, "--output")):
            done = self.run_ranks(3, *words, status=status)
            self.assertEqual([line in text for text in done.stderr.splitlines() if text.startswith("annulus:")], [True], done.stderr)

    def test_killed_at_any_time(self):
        """One rank, which takes the others with it; what it was doing is all that is lost."""
        whole = self.sweep(LONGER, "whole")
        kept = 0
        for turn, rank in enumerate((1, 0, 2)):
            run = self.start(*self.mpirun(3), threads=1)
            self.wait_for_lines(run, kept + 4)
            victim = self.rank_of(run.pid, rank)
            if victim:
                os.kill(victim, signal.SIGKILL)
            run.communicate(timeout=60)
            if not (self.here / "out" / JOURNAL).exists():
                break
            self.assertNotEqual(run.returncode, 0)
            lines = self.journal_lines()
            self.assertGreaterEqual(lines, kept)
            kept = lines
            print(f"turn {turn}: rank {rank} killed, {kept} lines in the journal")
        self.run_ranks(2, "spec.toml", "--output", "out", "--quiet")
        self.assertEqual(self.results("out"), whole)

    @staticmethod
    def rank_of(launcher, rank):
        """The process below mpirun that has that rank."""
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            try:
                with open(f"/proc/{entry}/stat", encoding="utf-8", errors="replace") as file:
                    parent = int(file.read().rsplit(")", 1)[1].split()[1])
                if parent != launcher:
                    continue
                with open(f"/proc/{entry}/environ", "rb") as file:
                    if f"OMPI_COMM_WORLD_RANK={rank}".encode() in file.read().split(b"\0"):
                        return int(entry)
            except OSError:
                continue
        return None

    # Not once more with ranks.
    test_threads_and_memory = test_interrupted = test_what_is_done_is_not_done_again = None
    test_another_specification = test_a_directory_of_others = None


if __name__ == "__main__":
    tool.main(__doc__, "mpirun")
