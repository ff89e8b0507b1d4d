#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directories of results: what is replaced, and what is in the way. usage: test_output_directories.py --tool=PATH
[CLASS[.METHOD]...]"""

import os
import socket
import subprocess
from pathlib import Path

import tool
from tool import RUN_FILES, ToolTest


class Directories(ToolTest):
    RUN = ["lloyd", "--points", "30", "--iterations", "2", "--quiet"]

    def names(self, directory="out"):
        return {p.name for p in (self.here / directory).iterdir()}

    def test_the_same_command_twice(self):
        for _ in range(2):
            self.succeed(*self.RUN, "--output", "out")
            self.assertEqual(self.names(), RUN_FILES)

    def test_stale_results_do_not_survive(self):
        self.succeed("nodt", "--sphere", "--vertices", "60", "--iterations", "1", "--output", "out", "--quiet")
        self.succeed("audit", "out/final.mesh", "--output", "out", "--quiet")  # removes only the run's files
        self.assertEqual(self.names(), RUN_FILES | {"domain.mesh", "domain.vtu", "dihedral.csv", "quality.csv",
                                                    "audit.json"})
        self.succeed("compare", "--output", "out", "--quiet", "--", *self.RUN)
        self.assertNotIn("domain.mesh", self.names())
        self.assertNotIn("summary.json", self.names())
        self.succeed(*self.RUN, "--output", "out")
        self.assertEqual(self.names(), RUN_FILES)

    def test_results_beside_other_files(self):
        self.succeed(*self.RUN, "--output", "out")
        (self.here / "out" / "notes.txt").write_text("mine")
        (self.here / "out" / "domain.mesh").write_text("stale")
        self.succeed(*self.RUN, "--seed", "4", "--output", "out")
        self.assertEqual(self.names(), RUN_FILES | {"notes.txt"})
        self.assertEqual(self.summary("out")["seed"], 4)

    def test_a_directory_of_something_else(self):
        out = self.here / "out"
        out.mkdir()
        (out / "keep.txt").write_text("mine")
        (out / "summary.json").write_text('{"command": "something else"}')
        for words in (self.RUN, ["compare", "--", *self.RUN], ["counterexample"]):
            words = words[:1] + ["--output", "out"] + words[1:]
            self.assertIn("out: holds other files; expected a new or empty directory", self.refuse(3, *words))
        self.succeed(*self.RUN, "--output", "out", "--force")
        self.assertEqual((out / "keep.txt").read_text(), "mine")
        self.assertEqual(self.summary("out")["vertices"], 30)
        self.assertEqual(self.names(), RUN_FILES | {"keep.txt"})

    def test_a_pipe_in_the_directory(self):
        (self.here / "out").mkdir()
        os.mkfifo(self.here / "out" / "summary.json")
        self.assertIn("out: holds other files", self.refuse(3, *self.RUN, "--output", "out"))

    def test_a_file_replaces_no_device_pipe_or_socket(self):
        self.xyz("points.xyz", tool.SPREAD)
        os.mkfifo(self.here / "pipe.xyz")
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(str(self.here / "socket.xyz"))
            os.symlink("/dev/null", self.here / "null.xyz")
            os.symlink("pipe.xyz", self.here / "link.xyz")
            for name, kind in (("pipe.xyz", "a pipe"), ("link.xyz", "a pipe"), ("socket.xyz", "a socket"),
                               ("null.xyz", "a device"), ("/dev/null", "a device"), ("/dev/stdout", "a pipe")):
                for words in (["generate", "uniform", "-n", "4", "--output", name],
                              ["degeneracy", "points.xyz", "--raw", name]):
                    words += ["--format", "xyz"] if words[0] == "generate" else []
                    self.assertRegex(self.refuse(3, *words, "--force"),
                                     rf"\Aannulus: {name}: is {kind}, which no file is to replace; expected ")
        os.mkdir(self.here / "out")
        os.mkfifo(self.here / "out" / "summary.json")
        self.assertIn("out/summary.json: is a pipe", self.refuse(3, *self.RUN, "--output", "out", "--force"))
        self.assertIn("x", self.succeed("generate", "uniform", "-n", "4", "--output", "-", "--format", "csv").stdout)

    def test_two_runs_at_once(self):
        """Into directories below a missing one, into a missing one, into one with another program's file."""
        for round in range(5):
            self.succeed(*self.RUN, "--output", f"mine{round}", "--quiet")
            (self.here / f"mine{round}" / "notes.txt").write_text("mine")
            for names in ((f"new{round}/a", f"new{round}/b"), (f"same{round}",) * 2, (f"mine{round}",) * 2):
                runs = [subprocess.Popen([tool.OPTIONS["tool"], *self.RUN, "--quiet", "--output", name], cwd=self.here,
                                         stderr=subprocess.PIPE, text=True) for name in names]
                for name, run in zip(names, runs):
                    self.assertEqual(run.communicate()[1], "", name)
                    self.assertEqual(run.returncode, 0, name)
                for name in names:
                    found = {p.name for p in (self.here / name).iterdir()} - {"notes.txt"}
                    self.assertEqual(found, RUN_FILES, name)

    def test_here(self):
        """The working directory is not replaced, because a shell may use it."""
        before = self.here.stat().st_ino
        for _ in range(2):
            self.succeed(*self.RUN, "--output", ".")
        self.assertEqual((self.names("."), self.here.stat().st_ino), (RUN_FILES, before))

    def test_new_directories_on_the_way(self):
        self.succeed("lloyd", "--points", "30", "--iterations", "2", "--output", "a/b c/d", "--quiet")
        self.assertEqual({p.name for p in (self.here / "a/b c/d").iterdir()}, RUN_FILES)

    def test_output_is_a_file(self):
        self.write("taken", "here already")
        self.assertIn("taken", self.refuse(3, "lloyd", "--points", "30", "--iterations", "2", "--output", "taken"))
        self.assertIn("taken", self.refuse(3, "lloyd", "--points", "30", "--iterations", "2", "--output", "taken/in"))
        self.assertEqual((self.here / "taken").read_text(), "here already")

    def test_a_file_that_cannot_be_replaced_leaves_the_rest_as_it_was(self):
        out = self.here / "out"
        (out / "report.html").mkdir(parents=True)
        (out / "summary.json").write_text("older")
        self.refuse(3, "lloyd", "--points", "30", "--iterations", "2", "--output", "out", "--force")
        self.assertEqual((out / "summary.json").read_text(), "older")

    def test_unwritable_directory(self):
        # /proc accepts no new entries, not even from root.
        if not Path("/proc/self").is_dir():
            self.skipTest("no /proc")
        self.assertIn("/proc/annulus", self.refuse(4, "lloyd", "--points", "30", "--iterations", "2",
                                                   "--output", "/proc/annulus"))
        self.refuse(4, "compare", "--output", "/proc/annulus", "--", "lloyd", "--points", "30", "--iterations", "2")

    def test_an_unwritable_directory_is_known_before_the_run(self):
        self.write("taken", "here already")
        motion = ["lloyd", "--points", "3000", "--iterations", "1000000"]
        self.refuse(3, *motion, "--output", "taken")
        self.refuse(3, "compare", "--output", "taken", "--", *motion)

    def test_directory_without_permission(self):
        locked = self.here / "locked"
        locked.mkdir(mode=0o500)
        self.addCleanup(locked.chmod, 0o700)
        if os.access(locked, os.W_OK):
            self.skipTest("this user may write everywhere")
        self.refuse(4, "lloyd", "--points", "30", "--iterations", "2", "--output", "locked/out")


if __name__ == "__main__":
    tool.main(__doc__)
