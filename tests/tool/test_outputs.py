#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that are written: whole or absent. usage: test_outputs.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import os
import re
import signal
import subprocess
import time
import xml.etree.ElementTree
from pathlib import Path

import tool
from tool import OPTIONS, RUN_FILES, SUMMARY, SUMMARY_PLAIN, ToolTest


class Outputs(ToolTest):
    def test_files_and_keys(self):
        self.succeed("lloyd", "--points", "60", "--iterations", "4", "--audit", "2", "--seed", "9", "--threads", "2",
                     "--output", "out")
        self.assertEqual({p.name for p in (self.here / "out").iterdir()}, RUN_FILES)
        summary = self.summary("out")
        for key in SUMMARY_PLAIN:
            self.assertIn(key, summary)
        for key, inner in SUMMARY.items():
            self.assertLessEqual(inner, set(summary[key]), key)
        self.assertEqual((summary["dimension"], summary["vertices"], summary["iterations"]), (2, 60, 4))
        self.assertEqual((summary["strategy"], summary["tolerance"]), ("filter", "certified"))
        self.assertEqual((summary["threads"], summary["seed"]), (2, 9))
        self.assertEqual(summary["audit"], {"checked": 2, "failed": 0})
        moves = dict(summary["moves"])
        self.assertEqual(moves.pop("asked"), 60 * 4)
        self.assertEqual(sum(moves.values()), 60 * 4)
        self.assertIn("lloyd --points 60", summary["command"])

    def test_iterations_csv(self):
        self.succeed("lloyd", "--points", "60", "--iterations", "7", "--output", "out", "--quiet")
        with open(self.here / "out" / "iterations.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(r["iteration"]) for r in rows], list(range(1, 8)))
        total = self.summary("out")["seconds"]["triangulation"]
        self.assertAlmostEqual(float(rows[-1]["seconds_cumulative"]), total, delta=1e-12)
        for row in rows:
            parts = ("within_tolerance", "kept_in_place", "flipped", "reinserted", "rebuilt")
            self.assertEqual(int(row["asked"]), sum(int(row[p]) for p in parts))

    def test_vtu_and_report_are_well_formed(self):
        self.succeed("lloyd", "--points", "60", "--iterations", "3", "--output", "out", "--quiet")
        root = xml.etree.ElementTree.parse(self.here / "out" / "final.vtu").getroot()
        self.assertEqual(root.get("type"), "UnstructuredGrid")
        report = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        self.assertTrue(report.rstrip().endswith("</html>"))
        self.assertIn("<h1>60 vertices, 3 Lloyd iterations: filter</h1>", report)
        self.assertEqual(report.count("annulus lloyd --points 60"), 1)
        self.assertNotRegex(report, r"(?i)src=[\"']https?:|<link[^>]+https?:", "the report fetches something")

    def test_no_iterations(self):
        self.succeed("lloyd", "--points", "40", "--iterations", "0", "--output", "out")
        summary = self.summary("out")
        self.assertEqual((summary["iterations"], summary["moves"]["asked"]), (0, 0))
        self.assertEqual(summary["audit"], {"checked": 1, "failed": 0})
        self.succeed("audit", "out/final.mesh")
        self.assertEqual(len((self.here / "out" / "iterations.csv").read_text().splitlines()), 1)

    def test_audit_never(self):
        self.succeed("lloyd", "--points", "40", "--iterations", "3", "--audit", "0", "--output", "out")
        self.assertEqual(self.summary("out")["audit"], {"checked": 0, "failed": 0})

    def test_audit_of_the_last_step(self):
        self.succeed("lloyd", "--points", "40", "--iterations", "5", "--audit", "3", "--output", "out")
        self.assertEqual(self.summary("out")["audit"]["checked"], 2)

    def test_quiet(self):
        for words in (["lloyd", "--points", "30", "--iterations", "2", "--quiet", "--output", "out"],
                      ["compare", "--quiet", "--", "lloyd", "--points", "30", "--iterations", "2"],
                      ["audit", "--quiet", "out/final.mesh"]):
            done = self.succeed(*words)
            self.assertEqual((done.stdout, done.stderr), ("", ""), words)

    def test_no_progress_where_there_is_no_terminal(self):
        done = self.succeed("lloyd", "--points", "30", "--iterations", "2")
        self.assertEqual(done.stderr, "")
        self.assertIn("audit", done.stdout)

    def test_existing_directory(self):
        out = self.here / "out"
        out.mkdir()
        (out / "keep.txt").write_text("mine")
        (out / "summary.json").write_text("older")
        self.succeed("lloyd", "--points", "30", "--iterations", "2", "--output", "out")
        self.assertEqual((out / "keep.txt").read_text(), "mine")
        self.assertEqual(self.summary("out")["vertices"], 30)
        self.assertEqual({p.name for p in out.iterdir()}, RUN_FILES | {"keep.txt"})

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
        self.refuse(3, "lloyd", "--points", "30", "--iterations", "2", "--output", "out")
        self.assertEqual((out / "summary.json").read_text(), "older")

    def test_unwritable_directory(self):
        # /proc takes no new entries, not even from root.
        if not Path("/proc/self").is_dir():
            self.skipTest("no /proc")
        self.assertIn("/proc/annulus", self.refuse(3, "lloyd", "--points", "30", "--iterations", "2",
                                                   "--output", "/proc/annulus"))
        self.refuse(3, "compare", "--output", "/proc/annulus", "--", "lloyd", "--points", "30", "--iterations", "2")

    def test_an_unwritable_directory_is_known_before_the_run(self):
        self.write("taken", "here already")
        motion = ["lloyd", "--points", "3000", "--iterations", "1000000"]
        self.refuse(3, *motion, "--output", "taken", timeout=10)
        self.refuse(3, "compare", "--output", "taken", "--", *motion, timeout=10)

    def test_an_interruption_leaves_all_or_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for directory in ("new/deep", "."):
                with self.subTest(number=number, directory=directory):
                    self.interrupt(number, directory)

    def interrupt(self, number, directory):
        """Sends the signal while the results are being written.

        A busy machine may not look in time: then the tool has come to its end, all must be there, and another run is
        to be caught.
        """
        before = self.listing()
        out = self.here / directory
        for _ in range(100):
            status = self.run_and_send(number, out)
            left = {p.name for p in out.iterdir()} if out.is_dir() else set()
            if status == 0:
                self.assertLessEqual(RUN_FILES, left)
            else:
                self.assertEqual(status, -number)
            if RUN_FILES <= left:
                for name in RUN_FILES:
                    (out / name).unlink()
                for name in sorted(set(self.listing()) - set(before), reverse=True):  # directories, inner ones first
                    (self.here / name).rmdir()
            self.assertEqual(self.listing(), before)
            if status != 0:
                return
        self.fail("no run was seen writing its results")

    def run_and_send(self, number, out):
        """Sends the signal to a run when the first file of its results has begun to appear; returns its status."""
        def default_action():  # whoever runs the tests may ignore the signal, as nohup and shells do for their children
            signal.signal(number, signal.SIG_DFL)

        run = subprocess.Popen([OPTIONS["tool"], "lloyd", "--points", "20000", "--iterations", "1", "--quiet", "--output",
                                out], cwd=self.here, stdin=subprocess.DEVNULL, preexec_fn=default_action)
        self.addCleanup(run.kill)  # nothing, once it has been waited for
        begun = False
        while run.poll() is None and not begun:
            try:
                # Later than the trial at the beginning, which is gone at once, and the new directory with it.
                begun = any(p.name.startswith(".") and "probe" not in p.name for p in out.iterdir())
            except FileNotFoundError:
                pass
            time.sleep(0.0005)
        run.send_signal(number)
        return run.wait(timeout=60)

    def test_directory_without_permission(self):
        locked = self.here / "locked"
        locked.mkdir(mode=0o500)
        self.addCleanup(locked.chmod, 0o700)
        if os.access(locked, os.W_OK):
            self.skipTest("this user may write everywhere")
        self.refuse(3, "lloyd", "--points", "30", "--iterations", "2", "--output", "locked/out")

    def test_final_mesh_has_shortest_decimals(self):
        self.succeed("lloyd", "--points", "40", "--iterations", "3", "--output", "out", "--quiet")
        text = (self.here / "out" / "final.mesh").read_text(encoding="utf-8")
        for number in re.findall(r"-?\d+\.\d+(?:e[-+]?\d+)?", text):
            digits = number.lstrip("-").split("e")[0].replace(".", "").strip("0")
            least = f"{float(number)!r}".lstrip("-").split("e")[0].replace(".", "").strip("0")
            self.assertEqual(digits, least)


if __name__ == "__main__":
    tool.main(__doc__)
