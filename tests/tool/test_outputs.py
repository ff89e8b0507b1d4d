#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files: complete or absent. usage: test_outputs.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import json
import math
import os
import re
import signal
import subprocess
import time
import xml.etree.ElementTree

import tool
from tool import RUN_FILES, SUMMARY, SUMMARY_PLAIN, ToolTest


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
        self.assertEqual((summary["strategy"], summary["tolerance"]), ("auto", "certified"))
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

    RUNS = (("lloyd", "--points", "60", "--iterations", "7"),
            ("nodt", "--sphere", "--vertices", "60", "--iterations", "4"), ("replay", "walk.xyz"))

    def rows(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_triangulation_seconds_are_those_of_the_steps(self):
        """Construction and first tolerances belong to no step and are reported separately: otherwise strategies with
        tolerances would be charged for work that others do not have."""
        self.succeed("generate", "walk", "--from", "grid", "--points", "64", "--dim", "3", "--steps", "5", "--pace",
                     "0.1", "--output", "walk.xyz")
        for run in self.RUNS:
            for strategy in ("auto", "tolerances", "rebuild", "relocate"):
                with self.subTest(run=run, strategy=strategy):
                    self.succeed(*run, "--strategy", strategy, "--output", "out", "--quiet", "--force")
                    summary = self.summary("out")
                    self.check_seconds(summary, self.rows(self.here / "out" / "iterations.csv"))

    def check_seconds(self, summary, rows):
        self.assertEqual(set(summary["seconds"]), {"triangulation", "motion", "total"})
        self.assertGreater(summary["seconds_construction"], 0)
        steps = [float(row["seconds_triangulation"]) for row in rows]
        self.assertEqual(float(rows[0]["seconds_cumulative"]), steps[0])  # nothing before the first
        self.assertEqual(float(rows[-1]["seconds_cumulative"]), summary["seconds"]["triangulation"])
        self.assertAlmostEqual(math.fsum(steps), summary["seconds"]["triangulation"], delta=1e-9)

    def test_what_compare_compares_are_the_steps(self):
        self.succeed("generate", "walk", "--from", "grid", "--points", "64", "--dim", "3", "--steps", "5", "--pace",
                     "0.1", "--output", "walk.xyz")
        strategies = ["rebuild", "auto", "tolerances", "tolerances-each", "relocate"]
        for run in self.RUNS:
            with self.subTest(run=run):
                self.succeed("compare", "--strategies", ",".join(strategies), "--output", "out", "--force", "--", *run)
                compared = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
                total = {}
                for name in strategies:
                    rows = self.rows(self.here / "out" / f"iterations-{name}.csv")
                    self.check_seconds(compared["strategies"][name], rows)
                    total[name] = math.fsum(float(row["seconds_triangulation"]) for row in rows)
                for pair, ratio in compared["ratios"].items():
                    a, b = pair.split("/")
                    self.assertAlmostEqual(ratio, total[a] / total[b], delta=1e-6 * ratio)

    def test_with_one_thread_pauses_do_not_count(self):
        """The tool is stopped most of the time: its seconds are no more than those that it had the processor."""
        words = ["compare", "--strategies", "rebuild,relocate", "--output", "out", "--quiet", "--", "lloyd", "--points",
                 "2000", "--iterations", "25"]
        run = subprocess.Popen([tool.OPTIONS["tool"], *words], cwd=self.here)
        ended = 0
        while not ended:
            for number, seconds in ((signal.SIGSTOP, 0.02), (signal.SIGCONT, 0.005)):
                os.kill(run.pid, number)
                time.sleep(seconds)
            ended, status, used = os.wait4(run.pid, os.WNOHANG)
        run.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(run.returncode, 0)
        runs = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))["strategies"].values()
        for seconds in (sum(r["seconds"]["triangulation"] for r in runs), sum(r["seconds_construction"] for r in runs),
                        min(r["seconds"]["motion"] for r in runs)):
            self.assertGreater(seconds, 0)
        timed = sum(r["seconds"]["triangulation"] + r["seconds_construction"] for r in runs)
        self.assertLess(timed + min(r["seconds"]["motion"] for r in runs), used.ru_utime + used.ru_stime + 0.02)
        self.assertLess(used.ru_utime + used.ru_stime, min(r["seconds"]["total"] for r in runs))
        page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("Times are processor time, in which pauses of the machine do not count"), 2)

    def test_with_several_threads_times_are_of_the_wall_clock(self):
        self.succeed("compare", "--threads", 2, "--output", "out", "--quiet", "--", "lloyd", "--points", "60",
                     "--iterations", "4")
        page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("Times are of the wall clock, which counts pauses of the machine, too"), 2)
        self.assertNotIn("rocessor time", page)

    def test_the_share_within_tolerance_is_known_only_where_it_was_tested(self):
        """A step that evaluates all signs, or rebuilds, tests no tolerances."""
        self.succeed("generate", "walk", "--points", "100", "--steps", "30", "--pace", "0.0001", "--output", "slow.csv")
        self.succeed("generate", "walk", "--points", "100", "--steps", "30", "--pace", "0.1", "--output", "fast.csv")
        for file in ("slow.csv", "fast.csv"):
            for strategy in tool.STRATEGIES:
                with self.subTest(file=file, strategy=strategy):
                    self.succeed("replay", file, "--strategy", strategy, "--output", "out", "--quiet", "--force")
                    page = (self.here / "out" / "report.html").read_text(encoding="utf-8")
                    row = re.search(r"s that tested tolerances</th><td>(\d+)", page)
                    tested = int(row[1]) if row else 0  # none: no number
                    moves = json.loads((self.here / "out" / "summary.json").read_text(encoding="utf-8"))["moves"]
                    within = re.search(r'<th scope="row">(at rest|within[^<]*)</th><td>([\d,]+)', page)
                    never = strategy in ("rebuild", "relocate", "relocate-flips", "in-place")
                    self.assertEqual(within is None, not never and tested == 0 and moves["within_tolerance"] == 0)
                    if within:
                        self.assertEqual(int(within[2].replace(",", "")), moves["within_tolerance"])
                    self.assertEqual("Moves beyond their tolerance" in page, tested > 0)
                    if never:
                        self.assertEqual((tested, within[1]), (0, "at rest"))
                    elif file == "slow.csv":
                        self.assertGreater(tested, 20)
                    elif strategy == "auto":
                        self.assertLess(tested, 5)

    def test_flips_are_empty_where_they_are_not_counted(self):
        for strategy in tool.STRATEGIES:
            self.succeed("lloyd", "--points", "200", "--iterations", "5", "--strategy", strategy, "--output", "out",
                         "--quiet", "--force")
            rows = self.rows(self.here / "out" / "iterations.csv")
            self.assertEqual({row["flips"] == "" for row in rows}, {strategy.startswith("paper")}, strategy)
            if strategy == "paper":
                self.assertGreater(sum(int(row["flipped"]) for row in rows), 0)
            elif strategy == "tolerances":
                self.assertGreater(sum(int(row["flips"]) for row in rows), 0)

    def test_one_is_singular(self):
        self.write("one.csv", "frame,id,x,y\n0,1,0.5,0.5\n1,1,0.25,0.5\n")
        said = self.succeed("replay", "one.csv", "--output", "one").stdout
        self.assertIn("1 vertex, 1 iteration, strategy auto", said)
        self.assertIn("1 vertex, 2 frames: strategy auto",
                      (self.here / "one" / "report.html").read_text(encoding="utf-8"))
        self.write("two.csv", "frame,id,x,y\n0,1,0.5,0.5\n0,2,0.25,0.5\n")
        self.assertIn("2 vertices, 0 iterations, strategy auto", self.succeed("replay", "two.csv").stdout)
        said = self.succeed("lloyd", "--points", "3", "--iterations", "1").stdout
        self.assertIn("3 vertices, 1 iteration, ", said)
        for words in (said, *(self.succeed(*run).stdout
                              for run in (("lloyd", "--points", "3", "--iterations", "0"), ("counterexample",)))):
            self.assertNotRegex(words,
                                r"(?<![\d.,])1 "
                                r"(vertices|iterations|points|steps|triangles|edges|frames|slivers|bi-cells|cells)\b")

    def test_the_first_steps_are_all_measured(self):
        self.succeed("lloyd", "--points", "60", "--iterations", "40", "--output", "out", "--quiet")
        with open(self.here / "out" / "iterations.csv", encoding="utf-8", newline="") as file:
            measured = [r["annulus_width_mean"] != "" for r in csv.DictReader(file)]
        self.assertEqual(measured[:20], 20 * [True])
        self.assertTrue(measured[-1])
        self.assertIn(False, measured)

    def test_vtu_and_report_are_well_formed(self):
        self.succeed("lloyd", "--points", "60", "--iterations", "3", "--output", "out", "--quiet")
        root = xml.etree.ElementTree.parse(self.here / "out" / "final.vtu").getroot()
        self.assertEqual(root.get("type"), "UnstructuredGrid")
        report = (self.here / "out" / "report.html").read_text(encoding="utf-8")
        self.assertTrue(report.rstrip().endswith("</html>"))
        self.assertIn("<h1>60 vertices, 3 Lloyd iterations: strategy auto</h1>", report)
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

    RUN = ["lloyd", "--points", "30", "--iterations", "2", "--quiet"]

    def test_every_json_has_the_version(self):
        version = self.succeed("--version").stdout.split()[1]
        self.xyz("points.xyz", tool.SPREAD)
        self.succeed(*self.RUN, "--output", "run")
        for words in (["compare", "--output", "a", "--", *self.RUN], ["audit", "run/final.mesh", "--output", "b"],
                      ["degeneracy", "points.xyz", "--output", "c"], ["counterexample", "--output", "d"],
                      ["advise", "points.xyz", "--output", "e"]):
            self.succeed(*words)
        for file in ("run/summary.json", "a/compare.json", "b/audit.json", "c/degeneracy.json",
                     "d/counterexample.json", "e/advise.json"):
            content = json.loads((self.here / file).read_text(encoding="utf-8"))
            self.assertEqual(content["version"], version, file)
            self.assertTrue(content["command"].startswith("annulus "), file)

    def test_a_replay_is_headed_by_steps_and_counts_who_is_there_at_the_end(self):
        self.write("motion.csv", "frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n1,1,0,0\n1,2,1,0\n1,3,0,1\n1,4,1,1\n")
        self.succeed("replay", "motion.csv", "--output", "out", "--quiet")
        self.assertEqual(self.summary("out")["vertices"], 4)
        self.assertIn("<h1>4 vertices, 2 frames: strategy auto</h1>",
                      (self.here / "out" / "report.html").read_text(encoding="utf-8"))

    def test_a_tolerance_without_end(self):
        """The outer points on a line have no certificate: their tolerance is infinite, not 0."""
        self.xyz("line.xyz", [(i, 0) for i in range(4)])
        self.succeed("lloyd", "--input", "line.xyz", "--iterations", "0", "--output", "out", "--quiet")
        self.assertIn(float("inf"), tool.vtu_values(self.here / "out" / "final.vtu", "tolerance"))

    def test_final_mesh_has_shortest_decimals(self):
        self.succeed("lloyd", "--points", "40", "--iterations", "3", "--output", "out", "--quiet")
        text = (self.here / "out" / "final.mesh").read_text(encoding="utf-8")
        for number in re.findall(r"-?\d+\.\d+(?:e[-+]?\d+)?", text):
            digits = number.lstrip("-").split("e")[0].replace(".", "").strip("0")
            least = f"{float(number)!r}".lstrip("-").split("e")[0].replace(".", "").strip("0")
            self.assertEqual(digits, least)


if __name__ == "__main__":
    tool.main(__doc__)
