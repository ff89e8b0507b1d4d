#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the built tool and looks at what comes out: exit status, both streams, files.

usage: test_tool.py --tool=PATH [CLASS[.METHOD]...]     the tests, or some of them
       test_tool.py --registered=CLASS,CLASS...         fails unless these are all the classes
"""

import csv
import json
import math
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

TOOL = None
STRATEGIES = ["rebuild", "relocate", "relocate-flips", "in-place", "filter", "filter-each", "hybrid"]
RUN_FILES = {"summary.json", "iterations.csv", "final.mesh", "final.vtu", "report.html"}
SUMMARY = {
    "seconds": {"triangulation", "motion", "total"},
    "moves": {"asked", "within_tolerance", "kept_in_place", "flipped", "reinserted", "rebuilt"},
    "arithmetic": {"filter", "interval", "exact"},
    "audit": {"checked", "failed"},
}
SUMMARY_PLAIN = {"command", "dimension", "vertices", "iterations", "strategy", "tolerance", "threads", "seed"}

TRIANGLE = [(0, 0), (1, 0), (0, 1)]
GRID = [(x, y) for x in range(6) for y in range(6)]
SPREAD = [(0, 0), (1, 0.125), (0.25, 1), (0.75, 0.875), (0.5, 0.375)]


class ToolTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.here = Path(scratch.name)

    def run_tool(self, *words, timeout=60):
        return subprocess.run([TOOL, *map(str, words)], cwd=self.here, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=timeout, check=False)

    def succeed(self, *words):
        done = self.run_tool(*words)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stderr}")
        return done

    def refuse(self, status, *words, timeout=20):
        """Exit status, nothing on standard output, exactly one line on standard error; returns that line."""
        before = self.listing()
        try:
            done = self.run_tool(*words, timeout=timeout)
        except subprocess.TimeoutExpired:
            self.fail(f"{words}: still running after {timeout} s, expected exit status {status}")
        self.assertEqual(done.returncode, status, f"{words}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stdout, "", words)
        self.assertRegex(done.stderr, r"\Aannulus: [^\n]+\n\Z", words)
        self.assertEqual(self.listing(), before, f"{words} left something behind")
        return done.stderr.rstrip("\n")

    def listing(self):
        return sorted(str(p.relative_to(self.here)) for p in self.here.rglob("*"))

    def write(self, name, content):
        path = self.here / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content, encoding="utf-8")
        return name

    def xyz(self, name, points):
        return self.write(name, "".join(" ".join(repr(c) for c in p) + "\n" for p in points))

    def summary(self, directory):
        return json.loads((self.here / directory / "summary.json").read_text(encoding="utf-8"))

    def mesh(self, directory):
        """Points and triangles of final.mesh."""
        words = (self.here / directory / "final.mesh").read_text(encoding="utf-8").split()
        at = words.index("Vertices")
        count = int(words[at + 1])
        points = [(float(words[at + 2 + 3 * i]), float(words[at + 3 + 3 * i])) for i in range(count)]
        at = words.index("Triangles")
        cells = [tuple(int(w) - 1 for w in words[at + 2 + 4 * i:at + 5 + 4 * i]) for i in range(int(words[at + 1]))]
        return points, cells


class Usage(ToolTest):
    def test_help(self):
        top = self.succeed("--help").stdout
        for name in ("lloyd", "compare", "audit", "counterexample"):
            self.assertIn(name, top)
            text = self.succeed(name, "--help").stdout
            self.assertIn("Usage:", text)
        for option in ("--points", "--input", "--density", "--domain", "--radius", "--iterations", "--strategy",
                       "--tolerance", "--audit", "--output", "--seed", "--threads", "--quiet"):
            self.assertIn(option, self.succeed("lloyd", "--help").stdout)
        self.assertIn("--strategies", self.succeed("compare", "--help").stdout)
        self.assertIn("--points", self.succeed("compare", "--", "lloyd", "--help").stdout)
        self.assertIn("--sphere", self.succeed("compare", "--", "nodt", "--help").stdout)

    def test_every_subcommand_takes_the_common_options(self):
        for name in ("lloyd", "compare", "audit", "counterexample"):
            text = self.succeed(name, "--help").stdout
            for option in ("--seed", "--output", "--threads", "--quiet"):
                self.assertIn(option, text, name)
        common = ["--seed", "3", "--threads", "2", "--quiet", "--output"]
        self.succeed("lloyd", "--points", "20", "--iterations", "1", *common, "lloyd")
        self.succeed("compare", *common, "compare", "--", "lloyd", "--points", "20", "--iterations", "1")
        self.succeed("counterexample", *common, "example")
        done = self.succeed("audit", "lloyd/final.mesh", *common, "audit")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        audit = json.loads((self.here / "audit" / "audit.json").read_text(encoding="utf-8"))
        self.assertIs(audit["delaunay"], True)
        self.assertEqual((audit["dimension"], audit["vertices"], audit["first_fault"]), (2, 20, ""))
        self.assertEqual(set(audit["faults"].values()), {0})

    def test_help_names_every_strategy(self):
        text = self.succeed("lloyd", "--help").stdout
        for name in STRATEGIES:
            self.assertIn(name, text)

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"\Aannulus \d+\.\d+\.\d+\n\Z")

    def test_wrong_usage(self):
        self.xyz("three.xyz", TRIANGLE)
        for words in (
            [],
            ["nonsense"],
            ["lloyd"],
            ["lloyd", "--nonsense"],
            ["lloyd", "--points", "2"],
            ["lloyd", "--points", "0"],
            ["lloyd", "--points", "ten"],
            ["lloyd", "--points", "1000000000000"],
            ["lloyd", "--points", "10", "--input", "three.xyz"],
            ["lloyd", "--points", "10", "--ignore-z"],
            ["lloyd", "--points", "10", "--density", "x3"],
            ["lloyd", "--points", "10", "--strategy", "magic"],
            ["lloyd", "--points", "10", "--tolerance", "magic"],
            ["lloyd", "--points", "10", "--threads", "0"],
            ["lloyd", "--points", "10", "--radius", "0"],
            ["lloyd", "--points", "10", "--radius", "-1"],
            ["lloyd", "--points", "10", "--iterations", "1.5"],
            ["lloyd", "--points", "10", "surplus"],
            ["lloyd", "--points", "10", "--output", ""],
            ["audit"],
            ["audit", "x.mesh", "--output", ""],
            ["counterexample", "--output", ""],
            ["compare", "--output", "", "--", "lloyd", "--points", "10"],
            ["compare"],
            ["compare", "--"],
            ["compare", "--", "audit", "x.mesh"],
            ["compare", "--", "lloyd"],
            ["compare", "--", "lloyd", "--points", "10", "--output", "out"],
            ["compare", "--strategies", "filter,magic", "--", "lloyd", "--points", "10"],
            ["compare", "--strategies", "filter,filter", "--", "lloyd", "--points", "10"],
            ["compare", "--strategies", "filter:magic", "--", "lloyd", "--points", "10"],
        ):
            with self.subTest(words=words):
                self.refuse(2, *words)

    def test_negative_counts_are_wrong_usage(self):
        for option in ("--iterations", "--audit", "--seed"):
            with self.subTest(option=option):
                self.refuse(2, "lloyd", "--points", "10", option, "-1", timeout=5)

    def test_a_radius_that_is_no_number_is_refused(self):
        for radius in ("nan", "inf", "-inf"):
            with self.subTest(radius=radius):
                line = self.refuse(2, "lloyd", "--points", "10", "--iterations", "1", "--radius", radius)
                self.assertLess(len(line), 200)


class Inputs(ToolTest):
    def vertices_of(self, name, *options):
        self.succeed("lloyd", "--input", name, "--iterations", "2", "--output", "out", "--quiet", *options)
        return self.summary("out")["vertices"]

    def test_xyz_plain(self):
        self.assertEqual(self.vertices_of(self.xyz("a.xyz", SPREAD)), 5)

    def test_xyz_with_count(self):
        lines = "".join(f"C {x} {y}\n" for x, y in SPREAD)
        self.assertEqual(self.vertices_of(self.write("a.xyz", f"5\na comment\n{lines}")), 5)

    def test_csv(self):
        rows = "".join(f"{x},{y}\n" for x, y in SPREAD)
        self.assertEqual(self.vertices_of(self.write("a.csv", rows)), 5)
        self.assertEqual(self.vertices_of(self.write("b.csv", "x,y\r\n" + rows.replace("\n", "\r\n"))), 5)
        self.assertEqual(self.vertices_of(self.write("c.csv", "name;y;x\n" + "".join(
            f"p;{y};{x}\n" for x, y in SPREAD))), 5)

    def test_off(self):
        rows = "".join(f"{x} {y} 0\n" for x, y in SPREAD)
        self.assertEqual(self.vertices_of(self.write("a.off", f"OFF\n5 0 0\n{rows}"), "--ignore-z"), 5)

    def ply_header(self, form, count):
        return (f"ply\nformat {form} 1.0\ncomment made for a test\nelement vertex {count}\nproperty double x\n"
                "property double y\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n")

    def test_ply(self):
        ascii_rows = "".join(f"{x} {y}\n" for x, y in SPREAD)
        self.assertEqual(self.vertices_of(self.write("a.ply", self.ply_header("ascii", 5) + ascii_rows)), 5)
        for form, order in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
            data = self.ply_header(form, 5).encode() + b"".join(struct.pack(order + "2d", *p) for p in SPREAD)
            self.assertEqual(self.vertices_of(self.write(form + ".ply", data)), 5)

    def test_mesh(self):
        rows = "".join(f"{x} {y} 0\n" for x, y in SPREAD)
        text = f"MeshVersionFormatted 2\nDimension 2\nVertices\n5\n{rows}End\n"
        self.assertEqual(self.vertices_of(self.write("a.mesh", text)), 5)

    def test_all_formats_of_the_same_points_give_the_same_run(self):
        names = [
            self.xyz("a.xyz", SPREAD),
            self.write("a.csv", "".join(f"{x!r},{y!r}\n" for x, y in SPREAD)),
            self.write("a.ply", self.ply_header("binary_little_endian", 5).encode()
                       + b"".join(struct.pack("<2d", *p) for p in SPREAD)),
        ]
        results = set()
        for name in names:
            self.vertices_of(name)
            results.add((self.here / "out" / "final.mesh").read_bytes())
        self.assertEqual(len(results), 1)

    def test_extension_in_capitals(self):
        self.assertEqual(self.vertices_of(self.xyz("A.XYZ", SPREAD)), 5)

    def test_z_is_refused_or_ignored(self):
        name = self.xyz("z.xyz", [(x, y, 7) for x, y in SPREAD])
        line = self.refuse(3, "lloyd", "--input", name, "--output", "out")
        self.assertIn("z.xyz:1:", line)
        self.assertIn("--ignore-z", line)
        self.assertEqual(self.vertices_of(name, "--ignore-z"), 5)

    def test_collinear(self):
        for name, points in (("level.xyz", [(i, 0) for i in range(5)]),
                             ("steep.xyz", [(0, i) for i in range(5)]),
                             ("diagonal.xyz", [(i, i) for i in range(5)])):
            for strategy in STRATEGIES:
                with self.subTest(name=name, strategy=strategy):
                    self.xyz(name, points)
                    self.succeed("lloyd", "--input", name, "--iterations", "3", "--strategy", strategy, "--audit", "1",
                                 "--output", "out")
                    summary = self.summary("out")
                    self.assertEqual(summary["vertices"], 5)
                    self.assertEqual(summary["audit"], {"checked": 3, "failed": 0})

    def test_duplicates_are_merged_and_reported(self):
        name = self.xyz("twice.xyz", SPREAD + SPREAD[:2] + [(-0.0, 0)])
        done = self.succeed("lloyd", "--input", name, "--iterations", "1", "--output", "out")
        self.assertEqual(done.stderr, "annulus: twice.xyz: merged 3 duplicate points\n")
        self.assertEqual(self.summary("out")["vertices"], 5)
        self.assertIn("3 duplicate points", (self.here / "out" / "report.html").read_text(encoding="utf-8"))

    def test_quiet_does_not_speak_of_duplicates(self):
        name = self.xyz("twice.xyz", SPREAD + SPREAD[:2])
        done = self.succeed("lloyd", "--input", name, "--iterations", "1", "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_subnormal_and_large_coordinates(self):
        # Inside the coordinate domain, not inside the lengths that the motion takes: refused in words.
        for name, scale in (("tiny.xyz", 5e-324), ("huge.xyz", 2.0**499)):
            self.xyz(name, [(x * 8 * scale / (8 if scale > 1 else 1), y * 8 * scale / (8 if scale > 1 else 1))
                            for x, y in SPREAD])
            self.assertIn("1e-100 and 1e100", self.refuse(3, "lloyd", "--input", name, "--output", "out"))
        self.assertEqual(self.vertices_of(self.xyz("small.xyz", [(x * 1e-90, y * 1e-90) for x, y in SPREAD])), 5)


class BadInputs(ToolTest):
    def fault(self, name, where, words, *options):
        line = self.refuse(3, "lloyd", "--input", name, "--iterations", "2", "--output", "out", *options)
        self.assertIn(f"{name}:{where}:" if where else f"{name}:", line)
        self.assertRegex(line, words)
        self.assertIn("expected", line)
        self.assertFalse((self.here / "out").exists())

    def test_not_finite(self):
        for text in ("nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e400", "-1e400"):
            with self.subTest(text=text):
                self.fault(self.write("bad.xyz", f"0 0\n1 0\n0 {text}\n"), 3, "y is")
                self.fault(self.write("bad.csv", f"0,0\n{text},1\n0,1\n"), 2, "x is")

    def test_not_finite_in_binary(self):
        header = ("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                  "end_header\n").encode()
        for value in (math.nan, math.inf, -math.inf):
            data = header + struct.pack("<6d", 0, 0, 1, value, 0, 1)
            self.fault(self.write("bad.ply", data), 2, "y is")

    def test_out_of_domain(self):
        self.fault(self.xyz("far.xyz", [(0, 0), (1, 0), (0, 2.0**501)]), 3, r"domain.*2\^500")
        self.fault(self.xyz("far.xyz", [(0, 0), (math.nextafter(2.0**500, math.inf), 0), (0, 1)]), 2, r"domain.*2\^500")

    def test_too_few(self):
        self.fault(self.xyz("one.xyz", TRIANGLE[:1]), 1, "1 distinct point ")
        self.fault(self.xyz("two.xyz", TRIANGLE[:2]), 2, "2 distinct points")
        self.fault(self.xyz("same.xyz", TRIANGLE[:2] * 3), 6, "2 distinct points")

    def test_text(self):
        self.fault(self.write("text.xyz", "these are words\n"), 1, "these")
        self.fault(self.write("text.csv", "0,0\n1,0\nzero,one\n"), 3, "zero")
        self.fault(self.write("text.xyz", "0 0\n1 0\n0 1x\n"), 3, "1x")

    def test_binary_rubbish_cannot_reach_the_terminal(self):
        name = self.write("rubbish.xyz", bytes(range(256)) * 4)
        line = self.refuse(3, "lloyd", "--input", name)
        self.assertTrue(line.isprintable(), repr(line))

    def test_empty(self):
        for name in ("empty.xyz", "empty.csv", "empty.off", "empty.ply", "empty.mesh"):
            self.fault(self.write(name, ""), None, "empty")
        self.fault(self.write("blank.xyz", "\n\n# nothing\n"), None, "no points")

    def test_missing(self):
        self.fault("missing.xyz", None, "does not exist")

    def test_directory(self):
        (self.here / "folder.xyz").mkdir()
        self.fault("folder.xyz", None, "directory")

    def test_unknown_extension(self):
        self.fault(self.write("points.txt", "0 0\n"), None, "txt")
        self.fault(self.write("points", "0 0\n"), None, "no extension")

    def test_columns(self):
        self.fault(self.write("short.xyz", "0 0\n1\n0 1\n"), 2, "1 column")
        self.fault(self.write("single.csv", "0\n1\n2\n"), 1, "1 column")

    def test_truncated(self):
        header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nend_header\n"
        self.fault(self.write("short.ply", header + "0 0\n1 0\n"), 8, "2 of 5")
        self.fault(self.write("header.ply", header[:40]), None, "end_header|ends|header|property|element")
        binary = header.replace("ascii", "binary_little_endian").encode() + struct.pack("<5d", 0, 0, 1, 0, 0)
        self.fault(self.write("binary.ply", binary), None, "2 of 5|ends")
        self.fault(self.write("short.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n"), 4, "2 of 4", "--ignore-z")
        self.fault(self.write("short.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n"), 6,
                   "2 of 4")
        self.fault(self.write("short.xyz", "4\ncomment\n0 0\n1 0\n"), 4, "2 of 4")

    def test_a_count_does_not_decide_the_memory(self):
        header = "ply\nformat ascii 1.0\nelement vertex 400000000\nproperty double x\nproperty double y\nend_header\n"
        self.fault(self.write("vast.ply", header + "0 0\n"), None, "1 of 400000000|room|vertex")

    def test_outside_the_domain(self):
        self.xyz("out.xyz", [(0, 0), (0.5, 0), (0, 0.5), (5, 5)])
        self.fault("out.xyz", 4, "outside", "--domain", "disc")
        self.fault("out.xyz", 4, "outside", "--domain", "square", "--radius", "2")

    def test_compare_and_audit_refuse_the_same_way(self):
        self.write("bad.xyz", "0 0\n1 nan\n0 1\n")
        line = self.refuse(3, "compare", "--output", "out", "--", "lloyd", "--input", "bad.xyz")
        self.assertIn("bad.xyz:2:", line)
        for name, text in (("a.mesh", ""), ("b.mesh", "words\n"),
                           ("c.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 nan 0\n"),
                           ("d.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n"
                                      "Triangles\n1\n1 2 4 0\n")):
            self.write(name, text)
            self.assertIn(name, self.refuse(3, "audit", name))
        self.assertIn("missing.mesh", self.refuse(3, "audit", "missing.mesh"))
        self.assertIn("3", self.refuse(3, "audit", self.write(
            "solid.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                          "Tetrahedra\n1\n1 2 3 4 0\nEnd\n")))


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
        """Sends the signal when the first file of the results has begun to appear."""
        before = self.listing()
        def default_action():  # whoever runs the tests may ignore the signal, as nohup and shells do for their children
            signal.signal(number, signal.SIG_DFL)

        tool = subprocess.Popen([TOOL, "lloyd", "--points", "20000", "--iterations", "1", "--quiet", "--output", directory],
                                cwd=self.here, stdin=subprocess.DEVNULL, preexec_fn=default_action)
        self.addCleanup(tool.kill)  # nothing, once it has been waited for
        out = self.here / directory
        begun = False
        while tool.poll() is None and not begun:
            try:
                # Later than the trial at the beginning, which is gone at once, and the new directory with it.
                begun = any(p.name.startswith(".") and "probe" not in p.name for p in out.iterdir())
            except FileNotFoundError:
                pass
            time.sleep(0.0005)
        tool.send_signal(number)
        status = tool.wait(timeout=60)
        self.assertTrue(begun, "nothing was seen of the files")
        self.assertEqual(status, -number)
        left = {p.name for p in out.iterdir()} if out.is_dir() else set()
        if RUN_FILES <= left:  # all were in place already
            for name in RUN_FILES:
                (out / name).unlink()
            return
        self.assertEqual(self.listing(), before)

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


class Audits(ToolTest):
    HEAD = "MeshVersionFormatted 2\nDimension 2\n"

    def mesh_file(self, points, cells):
        return self.write("test.mesh", self.HEAD + f"Vertices\n{len(points)}\n"
                          + "".join(f"{x!r} {y!r} 0\n" for x, y in points)
                          + f"Triangles\n{len(cells)}\n" + "".join(f"{a} {b} {c} 0\n" for a, b, c in cells) + "End\n")

    def verdict(self, status, points, cells):
        name = self.mesh_file(points, cells)
        done = self.run_tool("audit", name)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn("NOT Delaunay" if status else "Delaunay", done.stdout)
        quiet = self.run_tool("audit", "--quiet", name)
        self.assertEqual((quiet.returncode, quiet.stdout, quiet.stderr), (status, "", ""))

    SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    KITE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.25)]

    def test_right(self):
        self.verdict(0, self.SQUARE, [(1, 2, 3), (1, 3, 4)])
        self.verdict(0, self.SQUARE, [(1, 2, 4), (2, 3, 4)])
        self.verdict(0, self.KITE, [(1, 2, 3), (1, 3, 4)])

    def test_wrong(self):
        self.verdict(1, self.KITE, [(1, 2, 4), (2, 3, 4)])                          # the other diagonal
        self.verdict(1, self.SQUARE, [(1, 3, 2), (1, 3, 4)])                        # a clockwise triangle
        self.verdict(1, self.SQUARE, [(1, 2, 3)])                                   # a vertex in no triangle
        self.verdict(1, self.SQUARE + [(0.5, 0.5)], [(1, 2, 5), (2, 3, 5), (3, 4, 5)])   # not convex
        self.verdict(1, self.SQUARE, [(1, 2, 3), (1, 3, 4), (1, 2, 3)])             # a triangle twice
        self.verdict(1, self.SQUARE[:3] + [(1.0, 1.0)], [(1, 2, 3), (1, 3, 4)])     # two vertices at one place

    def test_one_unit_in_the_last_place(self):
        below, above = math.nextafter(1.0, 0), math.nextafter(1.0, 2)
        for y, good, bad in ((below, [(1, 2, 4), (2, 3, 4)], [(1, 2, 3), (1, 3, 4)]),
                             (above, [(1, 2, 3), (1, 3, 4)], [(1, 2, 4), (2, 3, 4)])):
            points = self.SQUARE[:3] + [(0.0, y)]
            self.verdict(0, points, good)
            self.verdict(1, points, bad)

    def test_a_border_that_winds_twice(self):
        # Positive triangles around one vertex, each locally Delaunay, the border convex at every corner; twice around.
        ring = [(round(math.cos(2 * math.pi * k / 5), 6), round(math.sin(2 * math.pi * k / 5), 6))
                for k in range(0, 10, 2)]
        cells = [(1, 2 + k, 2 + (k + 1) % 5) for k in range(5)]
        self.verdict(1, [(0.0, 0.0)] + ring, cells)

    def test_what_a_run_writes(self):
        for strategy in STRATEGIES:
            self.succeed("lloyd", "--points", "150", "--iterations", "10", "--strategy", strategy, "--output", "out",
                         "--quiet")
            self.succeed("audit", "out/final.mesh")

    def test_a_spoiled_run(self):
        self.succeed("lloyd", "--points", "150", "--iterations", "10", "--output", "out", "--quiet")
        points, cells = self.mesh("out")
        cells = [tuple(i + 1 for i in c) for c in cells]
        self.verdict(0, points, cells)
        self.verdict(1, points, cells[1:])
        self.verdict(1, points, [cells[0][::-1]] + cells[1:])
        moved = list(points)
        inner = cells[len(cells) // 2][0] - 1
        moved[inner] = (moved[inner][0] + 0.9, moved[inner][1] - 0.7)
        self.verdict(1, moved, cells)

    def test_what_a_flat_run_writes(self):
        self.xyz("line.xyz", [(i, 0) for i in range(4)])
        self.succeed("lloyd", "--input", "line.xyz", "--iterations", "2", "--output", "out", "--quiet")
        self.assertEqual(self.mesh("out")[1], [])
        done = self.succeed("audit", "out/final.mesh")
        self.assertIn("4 points, 3 edges: Delaunay", done.stdout)

    def test_points_on_a_line(self):
        def flat(points, edges):
            self.write("test.mesh", self.HEAD + f"Vertices\n{len(points)}\n" + "".join(f"{x!r} {y!r} 0\n" for x, y in points)
                       + f"Edges\n{len(edges)}\n" + "".join(f"{a} {b} 0\n" for a, b in edges) + "Triangles\n0\nEnd\n")
            return self.run_tool("audit", "test.mesh")
        line = [(0.0, 0.0), (2.0, 4.0), (1.0, 2.0)]
        self.assertEqual(flat(line, [(1, 3), (2, 3)]).returncode, 0)
        for points, edges in ((line, [(1, 2), (2, 3)]), (line, [(1, 3)]), (line, [(1, 3), (2, 3), (1, 2)]),
                              (line[:2] + [(1.0, 2.5)], [(1, 3), (2, 3)]), (line[:2] + line[:1], [(1, 2), (2, 3)])):
            done = flat(points, edges)
            self.assertEqual((done.returncode, "NOT Delaunay" in done.stdout), (1, True), (points, edges))
        flat(line, [])
        self.assertIn("Edges where all points are collinear", self.refuse(3, "audit", "test.mesh"))

    def test_a_fault_names_vertices_as_the_file_does(self):
        name = self.mesh_file(self.SQUARE, [(1, 3, 2), (1, 3, 4)])
        self.assertIn("cell not positively oriented: 1 3 2", self.run_tool("audit", name).stdout)
        name = self.mesh_file(self.SQUARE, [(1, 2, 3)])
        self.assertIn("vertex in no cell: 4", self.run_tool("audit", name).stdout)


class Counterexample(ToolTest):
    def numbers(self, *words):
        return json.loads(self.succeed("counterexample", "--json", *words).stdout)

    def test_the_paper_accepts_what_is_not_delaunay(self):
        for delta in (0.01, 0.1, 1e-3, 1e-6, 1e-9):
            r = self.numbers("--delta", delta)
            tolerance = r["tolerance"]
            # Spheres around the origin, radii 1 - delta and 1: half of delta. p, q are rounded, and so is 1 - delta.
            self.assertAlmostEqual(tolerance["exact"] / delta, 0.5, delta=1e-15 / delta)
            self.assertLessEqual(tolerance["certified"], tolerance["exact"])
            self.assertGreaterEqual(tolerance["certified"], 0.996 * tolerance["exact"])
            self.assertGreater(tolerance["paper"], 1.4 * tolerance["exact"])
            self.assertAlmostEqual(r["move"], 0.7 * delta)
            self.assertEqual(r["accepted"], {"paper": True, "certified": False})
            self.assertEqual(r["delaunay"], {"three_cells_before": True, "three_cells_after": False,
                                             "two_cells_after": True})
        self.assertAlmostEqual(self.numbers()["tolerance"]["paper"], 0.00748, places=5)

    def test_text_and_file(self):
        done = self.succeed("counterexample", "--output", "out")
        self.assertIn("paper accepts, certified asks for an evaluation", done.stdout)
        self.assertIn("three cells around ab: NOT Delaunay; two cells at pqr: Delaunay", done.stdout)
        self.assertEqual(json.loads((self.here / "out" / "counterexample.json").read_text(encoding="utf-8")),
                         self.numbers())
        self.assertEqual(self.succeed("counterexample", "--quiet").stdout, "")

    def test_refusals(self):
        for delta in ("0", "-0.1", "0.2", "nan", "x"):
            self.refuse(2, "counterexample", "--delta", delta)
        self.write("file", "")
        self.refuse(3, "counterexample", "--output", "file")


class Domains(ToolTest):
    def run_in(self, *words):
        self.succeed("lloyd", "--points", "80", "--iterations", "5", "--audit", "1", "--output", "out", "--quiet", *words)
        self.assertEqual(self.summary("out")["audit"], {"checked": 5, "failed": 0})
        return self.mesh("out")[0]

    def test_disc(self):
        for radius in (1.0, 0.25, 3e10):
            points = self.run_in("--domain", "disc", "--radius", radius)
            self.assertTrue(all(math.hypot(*p) <= radius * (1 + 1e-12) for p in points))

    def test_square(self):
        for half in (1.0, 7.5):
            points = self.run_in("--domain", "square", "--radius", half)
            self.assertTrue(all(max(map(abs, p)) <= half * (1 + 1e-12) for p in points))

    CORNERS = [(0, 0), (4, 0), (5, 2), (2, 4), (0, 3)]

    def test_polygon_either_way_round(self):
        results = []
        for corners in (self.CORNERS, self.CORNERS[::-1]):
            self.xyz("polygon.xyz", corners)
            points = self.run_in("--domain", "polygon.xyz")
            self.assertEqual(len(points), 80)
            for (ax, ay), (bx, by) in zip(self.CORNERS, self.CORNERS[1:] + self.CORNERS[:1]):
                for x, y in points:
                    self.assertGreaterEqual((bx - ax) * (y - ay) - (by - ay) * (x - ax), -1e-10)
            results.append(points)

    def test_polygon_that_is_none(self):
        for name, corners in (("dent.xyz", [(0, 0), (2, 0), (1, 0.5), (2, 2), (0, 2)]),
                              ("bow.xyz", [(0, 0), (2, 2), (2, 0), (0, 2)]),
                              ("star.xyz", [(math.cos(4 * math.pi * k / 5), math.sin(4 * math.pi * k / 5))
                                            for k in range(5)]),
                              ("line.xyz", [(0, 0), (1, 1), (2, 2)]),
                              ("two.xyz", [(0, 0), (1, 1)])):
            with self.subTest(name=name):
                self.xyz(name, corners)
                line = self.refuse(3, "lloyd", "--points", "50", "--domain", name, "--output", "out")
                self.assertIn(name, line)
        self.refuse(3, "lloyd", "--points", "50", "--domain", "missing.xyz", "--output", "out")

    def test_densities(self):
        meshes = set()
        for density in ("one", "x2+y2", "x2", "sin2"):
            self.run_in("--density", density)
            meshes.add((self.here / "out" / "final.mesh").read_bytes())
        self.assertEqual(len(meshes), 4)

    def test_hull_of_the_input(self):
        self.xyz("grid.xyz", GRID)
        self.succeed("lloyd", "--input", "grid.xyz", "--iterations", "5", "--audit", "1", "--output", "out", "--quiet")
        self.assertTrue(all(-1e-9 <= c <= 5 + 1e-9 for p in self.mesh("out")[0] for c in p))


class Reproducible(ToolTest):
    def final(self, *words):
        self.succeed("lloyd", "--points", "300", "--iterations", "12", "--output", "out", "--quiet", *words)
        return (self.here / "out" / "final.mesh").read_bytes()

    def test_seed(self):
        self.assertEqual(self.final("--seed", "5"), self.final("--seed", "5"))
        self.assertNotEqual(self.final("--seed", "5"), self.final("--seed", "6"))
        self.assertEqual(self.final(), self.final("--seed", "1"))

    def test_threads(self):
        for density in ("one", "sin2"):
            one = self.final("--threads", "1", "--density", density)
            for threads in (2, 3, 8):
                self.assertEqual(one, self.final("--threads", threads, "--density", density))

    def test_every_strategy_reaches_the_same_points(self):
        results = {}
        for strategy in STRATEGIES:
            self.final("--strategy", strategy)
            results[strategy] = sorted(self.mesh("out")[0])
        for strategy in STRATEGIES[1:]:
            with self.subTest(strategy=strategy):
                for p, q in zip(results["rebuild"], results[strategy]):
                    self.assertLess(math.dist(p, q), 1e-9)

    def test_counters(self):
        counts = []
        for _ in range(2):
            self.final()
            summary = self.summary("out")
            counts.append((summary["moves"], summary["arithmetic"]))
        self.assertEqual(counts[0], counts[1])


class Strategies(ToolTest):
    def compare(self, strategies, *inner):
        self.succeed("compare", "--strategies", ",".join(strategies), "--output", "out", "--quiet", "--", "lloyd", *inner)
        result = json.loads((self.here / "out" / "compare.json").read_text(encoding="utf-8"))
        self.assertIs(result["agree"], True)
        self.assertEqual(list(result["strategies"]), strategies)
        for name in strategies:
            self.assertLessEqual(SUMMARY_PLAIN | set(SUMMARY), set(result["strategies"][name]))
            self.assertEqual(result["strategies"][name]["audit"]["failed"], 0)
        self.assertEqual(set(result["ratios"]), {f"{a}/{b}" for a in strategies for b in strategies if a != b})
        for pair, ratio in result["ratios"].items():
            a, b = (result["strategies"][n]["seconds"]["triangulation"] for n in pair.split("/"))
            self.assertAlmostEqual(ratio, a / b, delta=1e-9 * ratio)
        return result

    def test_all_agree(self):
        self.compare(STRATEGIES, "--points", "200", "--iterations", "15", "--audit", "1")

    def test_all_agree_on_a_grid(self):
        self.xyz("grid.xyz", GRID)
        self.compare(STRATEGIES, "--input", "grid.xyz", "--iterations", "6", "--audit", "1")

    def test_all_agree_on_a_line(self):
        self.xyz("line.xyz", [(i, 2 * i) for i in range(6)])
        self.compare(STRATEGIES, "--input", "line.xyz", "--iterations", "3", "--audit", "1")

    def test_three_points(self):
        self.compare(STRATEGIES, "--points", "3", "--iterations", "6", "--audit", "1")

    def test_variants(self):
        result = self.compare(["filter", "filter:unequal", "filter:floating", "filter-each"],
                              "--points", "200", "--iterations", "15")
        self.assertEqual(result["strategies"]["filter:floating"]["tolerance"], "floating")

    def test_default_strategies_and_files(self):
        self.succeed("compare", "--output", "out", "--", "lloyd", "--points", "60", "--iterations", "3")
        self.assertEqual({p.name for p in (self.here / "out").iterdir()},
                         {"compare.json", "report.html", "iterations-rebuild.csv", "iterations-relocate.csv",
                          "iterations-filter.csv"})

    def test_tolerances_pass_more_as_the_motion_dies_down(self):
        self.succeed("lloyd", "--points", "300", "--iterations", "150", "--output", "out", "--quiet")
        with open(self.here / "out" / "iterations.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(int(rows[-1]["within_tolerance"]), int(rows[0]["within_tolerance"]))

    def test_the_arithmetic_is_reported(self):
        # A grid is degenerate everywhere: the exact stage has to decide.
        self.xyz("grid.xyz", GRID)
        self.succeed("lloyd", "--input", "grid.xyz", "--iterations", "0", "--output", "out", "--quiet")
        self.assertGreater(self.summary("out")["arithmetic"]["exact"], 0)


def main():
    global TOOL
    registered = [a.split("=", 1)[1] for a in sys.argv[1:] if a.startswith("--registered=")]
    if registered:
        classes = {name for name, value in globals().items()
                   if isinstance(value, type) and issubclass(value, ToolTest) and value is not ToolTest}
        missing = classes ^ set(registered[0].split(","))
        print(f"not the same in test_tool.py and CMakeLists.txt: {sorted(missing)}" if missing else "complete")
        return 1 if missing else 0
    tools = [a.split("=", 1)[1] for a in sys.argv[1:] if a.startswith("--tool=")]
    if not tools:
        print(__doc__, file=sys.stderr)
        return 2
    TOOL = os.path.abspath(tools[0])
    unittest.main(argv=[sys.argv[0]] + [a for a in sys.argv[1:] if not a.startswith("--tool=")])
    return 0


if __name__ == "__main__":
    sys.exit(main())
