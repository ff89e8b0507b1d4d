#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` and stops it: threads, kills, interruptions. Ranks are in test_sweep_ranks.py.

usage: test_sweep_resumed.py --tool=PATH [CLASS[.METHOD]...]
"""

import random
import signal
import subprocess
import time

import test_sweep
import tool
from test_sweep import FILES, JOURNAL, LONGER, SPEC


class Stopped(test_sweep.SweepTest):
    """A sweep that is to be stopped, and what is left of it."""

    def start(self, *launcher, threads=2):
        return subprocess.Popen([*launcher, tool.OPTIONS["tool"], "sweep", "spec.toml", "--output", "out", "--quiet", "--threads", str(threads)],
                                cwd=self.here, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)

    def journal_lines(self):
        """With the head; a line that was cut off is none."""
        try:
            return (self.here / "out" / JOURNAL).read_bytes().count(b"\n")
        except FileNotFoundError:
            return 0

    def wait_for_lines(self, run, n):
        while run.poll() is None and self.journal_lines() < n:
            time.sleep(0.01)


class Interrupted(Stopped):
    def test_threads_and_memory(self):
        one = self.sweep(SPEC, "one")
        for i, words in enumerate((["--threads", "4"], ["--threads", "3", "--memory", "0.002"])):
            self.assertEqual(self.sweep(SPEC, f"more{i}", *words), one)

    def test_killed_at_any_time(self):
        whole = self.sweep(LONGER, "whole")
        dice = random.Random()
        seed = dice.randrange(10**6)
        print("seed of the kills:", seed)
        dice.seed(seed)
        kept = killed = 0
        for turn in range(4):
            run = self.start()
            self.wait_for_lines(run, kept + dice.randrange(2, 7))
            run.kill()
            killed += run.wait() == -signal.SIGKILL
            run.stderr.close()
            if not (self.here / "out" / JOURNAL).exists():
                break
            lines = self.journal_lines()
            self.assertGreaterEqual(lines, kept)  # nothing is lost
            kept = lines
            if turn == 1:  # as a crash of the machine may leave it
                with open(self.here / "out" / JOURNAL, "ab") as journal:
                    journal.write(b"1234abcd {\"trial\":0,\"li")
        self.assertGreater(killed, 0, "too quick for this test: nothing was killed")
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
        self.assertRegex(done.stdout, r"of which [1-9]\d* (was|were) done before")
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
        run.send_signal(signal.SIGSTOP)  # it writes as long as we look
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


if __name__ == "__main__":
    tool.main(__doc__)
