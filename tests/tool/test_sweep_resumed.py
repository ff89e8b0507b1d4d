#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` and stops it: threads, kills, interruptions. Ranks are in test_sweep_ranks.py.

usage: test_sweep_resumed.py --tool=PATH [CLASS[.METHOD]...]
"""

import signal
import subprocess

import test_sweep
import tool
from test_sweep import FILES, JOURNAL, LONGER, SPEC


class Stopped(test_sweep.SweepTest):
    """A sweep that is to be stopped, and its remains."""

    def start(self, *launcher, threads=2, **more):
        return subprocess.Popen([*launcher, tool.OPTIONS["tool"], "sweep", "spec.toml", "--output", "out", "--quiet",
                                 "--threads", str(threads)], cwd=self.here, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True, start_new_session=True, **more)

    def journal_lines(self):
        """The lines of the journal with its head, without a line that was cut off."""
        try:
            return (self.here / "out" / JOURNAL).read_bytes().count(b"\n")
        except FileNotFoundError:
            return 0


class Interrupted(Stopped):
    def test_threads_and_memory(self):
        one = self.sweep(SPEC, "one")
        for i, words in enumerate((["--threads", "4"], ["--threads", "3", "--memory", "0.002"])):
            self.assertEqual(self.sweep(SPEC, f"more{i}", *words), one)

    def test_killed_at_any_line(self):
        """Kills each run before a certain line of its journal is written, counted from the existing ones."""
        whole = self.sweep(LONGER, "whole")
        kept = 0
        for turn, count in enumerate((3, 6, 1, 2)):
            # The head, which an existing journal has already, is a line, too.
            run = self.start(env=tool.at(signal.SIGKILL, count, "pwrite", JOURNAL))
            self.assertEqual(run.wait(), -signal.SIGKILL)
            run.stderr.close()
            kept += count - 1
            self.assertEqual(self.journal_lines(), kept)  # nothing is lost
            if turn == 1:  # as after a crash of the machine
                with open(self.here / "out" / JOURNAL, "ab") as journal:
                    journal.write(b"1234abcd {\"trial\":0,\"li")
        self.assertIn(f"of which {kept - 1} were done before",
                      self.succeed("sweep", "spec.toml", "--output", "out").stdout)
        self.assertEqual(self.results("out"), whole)

    def test_interrupted(self):
        """The signal comes between two lines of the journal. What has begun is finished or not; nothing else begins."""
        whole = self.sweep(LONGER, "whole")
        run = self.start(env=tool.at(signal.SIGINT, 4, "pwrite", JOURNAL))
        text = run.communicate()[1]
        self.assertEqual(run.returncode, -signal.SIGINT)
        self.assertRegex(text, r"\Aannulus: interrupted: [1-9]\d* of 30 trials are kept in out, [^\n]+\n\Z")
        self.assertEqual([p.name for p in (self.here / "out").iterdir()], [JOURNAL])
        done = self.succeed("sweep", "spec.toml", "--output", "out")
        self.assertRegex(done.stdout, r"of which [1-9]\d* (was|were) done before")
        self.assertEqual(self.results("out"), whole)

    def test_what_is_done_is_not_done_again(self):
        before = self.sweep(SPEC, "out")
        costs = self.here / "out" / "costs.jsonl"
        costs.write_text("marked", encoding="utf-8")
        self.assertIn("already", self.succeed("sweep", "spec.toml", "--output", "out").stdout)
        self.assertEqual(costs.read_text(encoding="utf-8"), "marked")
        self.assertEqual(self.sweep(SPEC, "out", "--force"), before)
        self.assertNotEqual(costs.read_text(encoding="utf-8"), "marked")
        # Another specification may replace complete results, as with every subcommand.
        self.sweep("[[grid]]\npoints = 20\n", "out")
        self.assertEqual(len(self.lines("out")), 1)

    def test_another_specification(self):
        self.write("spec.toml", LONGER)
        run = self.start(env=tool.at(signal.SIGSTOP, 3, "pwrite", JOURNAL))  # it is still writing during the check
        tool.until_it_stops(run)
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
