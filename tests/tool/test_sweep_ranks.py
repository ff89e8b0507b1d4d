#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `annulus sweep` as several processes under mpirun, kills them, and gives some of them other files.

usage: test_sweep_ranks.py --tool=PATH --mpirun=PATH [CLASS[.METHOD]...]
    --mpirun=none: a build without MPI: says so, and ends with status 77, which to CTest means that nothing was tested
"""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import tool
from test_sweep import JOURNAL, LONGER, SPEC, SweepTest
from test_sweep_resumed import Stopped

SKIPPED = 77


def mpirun(n=None):
    words = [tool.OPTIONS["mpirun"], "--oversubscribe"] + (["-n", str(n)] if n else [])
    return words + ["--allow-run-as-root"] if os.getuid() == 0 else words


def stat_of(process):
    """Parent and state of a process; None where there is none."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
    state, parent = text.rsplit(")", 1)[1].split()[:2]
    return int(parent), state


def has_stopped(process):
    """Whether all threads of a process have stopped. When its launcher ends, the kernel wakes and ends it only then."""
    try:
        threads = [Path(f"/proc/{process}/task/{thread}/stat").read_text(encoding="utf-8", errors="replace")
                   for thread in os.listdir(f"/proc/{process}/task")]
    except OSError:
        return False
    return all(text.rsplit(")", 1)[1].split()[0] == "T" for text in threads)


def ranks_of(launcher):
    """The processes below mpirun, by rank."""
    found = {}
    for process in filter(str.isdigit, os.listdir("/proc")):
        if (stat_of(process) or (None,))[0] != launcher:
            continue
        try:
            words = Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
        except OSError:
            continue
        for word in words:
            if word.startswith(b"OMPI_COMM_WORLD_RANK="):
                found[int(word.split(b"=")[1])] = int(process)
    return found


class Killed(Stopped):
    def until_all_are_gone(self, run, ranks):
        """Ranks do not outlive any of them, nor mpirun. mpirun is killed then: that of Open MPI 4.1 may wait for ever
        when no rank is left (tests/ATTACKS.md, find 16)."""
        while [p for p in ranks.values() if (stat_of(p) or (0, "Z"))[1] != "Z"]:
            time.sleep(0.02)
        run.kill()
        run.communicate()

    def kill(self, kept, victim):
        """Starts three ranks, of which the first stops before its fifth line of the journal, so that none can come to
        its end, and kills one of them, or mpirun. That ends the others, stopped ones too."""
        run = self.start(*mpirun(3), threads=1, env=tool.at(signal.SIGSTOP, 5, "pwrite", JOURNAL, rank=0))
        self.addCleanup(lambda: run.poll() is None and run.kill())
        ranks = {}
        while sorted(ranks) != [0, 1, 2] or not has_stopped(ranks[0]):
            self.assertIsNone(run.poll())
            time.sleep(0.02)
            ranks = ranks_of(run.pid)
        self.assertEqual(self.journal_lines(), kept + 4)
        os.kill(run.pid if victim == "mpirun" else ranks[victim], signal.SIGKILL)
        self.until_all_are_gone(run, ranks)
        self.assertNotEqual(run.returncode, 0)

    def test_killed_at_any_line(self):
        """Kills one rank, which ends the others, too, or mpirun; only the trials in progress are lost."""
        whole = self.sweep(LONGER, "whole")
        kept = 0
        for victim in (1, 0, "mpirun", 2):
            self.kill(kept, victim)
            # The number of lines that are written before all processes have ended varies. When these are all lines, the
            # journal has been removed, too.
            if (self.here / "out" / "costs.jsonl").exists():
                print(f"killed: {victim}, when all was done")
                self.assertEqual(self.results("out"), whole)
                return
            lines = self.journal_lines()
            self.assertGreaterEqual(lines, kept + 4)
            kept = lines
            print(f"killed: {victim}, {kept} lines in the journal")
            if kept > 26:  # four more are needed
                break
        done = subprocess.run([*mpirun(2), tool.OPTIONS["tool"], "sweep", "spec.toml", "--output", "out"],
                              cwd=self.here, capture_output=True, text=True, timeout=tool.HANGING, check=True)
        self.assertIn(f"of which {kept - 1} were done before", done.stdout)  # one line is the head
        self.assertEqual(self.results("out"), whole)


class Ranks(SweepTest):
    def run_ranks(self, n, *words, status=0):
        done = subprocess.run([*mpirun(n), tool.OPTIONS["tool"], "sweep", *words], cwd=self.here, capture_output=True,
                              text=True, timeout=tool.HANGING, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_any_number_of_ranks(self):
        one = self.sweep(SPEC, "one")
        for n, threads in ((1, 1), (2, 1), (4, 1), (2, 2)):
            done = self.run_ranks(n, "spec.toml", "--output", f"{n}x{threads}", "--threads", str(threads))
            self.assertEqual(done.stdout.count("written to"), 1)
            self.assertEqual(self.results(f"{n}x{threads}"), one)
        # The first rank to request gets more: one rank may have done everything on a busy machine, which is not a
        # fault. But not always.
        for _ in range(20):
            if len({line["rank"] for line in self.lines("4x1", "costs.jsonl")}) > 1:
                break
            self.run_ranks(4, "spec.toml", "--output", "4x1", "--threads", "1", "--force")
        else:
            self.fail("one rank does everything")

    def test_faults_come_once(self):
        self.write("bad.xyz", "1 2\n3 x\n")
        self.write("spec.toml", "[[grid]]\npoints = 20\nseeds = 40\n[[grid]]\nfile = \"bad.xyz\"\n")
        for words, status, line in ((["spec.toml", "--output", "out"], 3, "bad.xyz:2: "),
                                    (["missing.toml", "--output", "out"], 3, "missing.toml"),
                                    (["spec.toml"], 2, "--output")):
            done = self.run_ranks(3, *words, status=status)
            self.assertEqual([line in text for text in done.stderr.splitlines() if text.startswith("annulus:")], [True],
                             done.stderr)

    def run_in(self, *directories):
        words = mpirun()
        for i, directory in enumerate(directories):
            words += ([":"] if i > 0 else []) + ["-n", "1", "-wdir", str(self.here / directory), tool.OPTIONS["tool"],
                                                 "sweep", "spec.toml", "--output", str(self.here / "out")]
        run = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
        try:
            _, said = run.communicate(timeout=tool.HANGING)
        except subprocess.TimeoutExpired:
            os.killpg(run.pid, signal.SIGKILL)
            run.communicate()
            self.fail("still running")
        return run.returncode, [line for line in said.splitlines() if line.startswith("annulus:")]

    def test_a_rank_with_other_files(self):
        for i, points in enumerate(("0 0\n1 0\n0 1\n", "0 0\n1 0\n0 2\n", None)):
            (self.here / str(i)).mkdir()
            self.write(f"{i}/spec.toml", "[[grid]]\nfile = \"p.xyz\"\n[[grid]]\npoints = 20\nseeds = 30\n")
            if points is not None:
                self.write(f"{i}/p.xyz", points)
        for other, words in (("1", "not the same"), ("2", "spec.toml:2: 'file'")):
            status, said = self.run_in("0", "0", other)
            self.assertEqual((status, len(said)), (3, 1), said)
            self.assertIn(words, said[0])
        self.assertEqual(self.run_in("0", "0", "0"), (0, []))
        self.results("out")


if __name__ == "__main__":
    if "--mpirun=none" in sys.argv:
        print("SKIPPED: this build has no MPI, and nothing is known of `annulus sweep` as several processes "
              "(tools/setup installs Open MPI)")
        sys.exit(SKIPPED)
    # If ranks communicate by shared memory, mpirun of Open MPI 4.1 often waits for ever, in PMIx_server_finalize and
    # with no rank left, after one was killed; seldom if each has its own tables (tests/ATTACKS.md, find 16).
    os.environ["PMIX_MCA_gds"] = "hash"
    tool.main(__doc__, "mpirun")
