#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, version and wrong usage. usage: test_usage.py --tool=PATH [CLASS[.METHOD]...]"""

import json
import re

import tool
from tool import STRATEGIES, TRIANGLE, ToolTest


SUBCOMMANDS = {"lloyd", "nodt", "replay", "compare", "audit", "degeneracy", "generate", "sweep", "reproduce",
               "counterexample", "advise"}


class Usage(ToolTest):
    def test_these_are_all_subcommands(self):
        top = self.succeed("--help").stdout
        self.assertEqual(set(re.findall(r"^  ([a-z]+) ", top[top.index("Subcommands"):], re.MULTILINE)), SUBCOMMANDS)

    def test_help(self):
        top = self.succeed("--help").stdout
        for name in SUBCOMMANDS:
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
        for name in SUBCOMMANDS:
            text = self.succeed(name, "--help").stdout
            for option in ("--seed", "--output", "--threads", "--quiet", "--force"):
                self.assertIn(option, text, name)
        common = ["--seed", "3", "--threads", "2", "--quiet", "--output"]
        self.succeed("lloyd", "--points", "20", "--iterations", "1", *common, "lloyd")
        self.succeed("compare", *common, "compare", "--", "lloyd", "--points", "20", "--iterations", "1")
        self.succeed("counterexample", *common, "example")
        self.succeed("reproduce", "--quick", "--iterations", 1, "--only", "fig5", *common, "reproduce")
        self.succeed("nodt", "--sphere", "--vertices", "30", "--iterations", "1", *common, "nodt")
        self.write("motion.csv", "frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n1,1,0,0\n1,2,1,0\n1,3,0,1\n")
        self.succeed("replay", "motion.csv", *common, "replay")
        self.succeed("advise", "motion.csv", *common, "advise")
        self.xyz("three.xyz", TRIANGLE)
        self.succeed("degeneracy", "three.xyz", *common, "degeneracy")
        self.succeed("generate", "grid", "--points", "9", *common, "points.csv")
        self.write("spec.toml", "[[grid]]\npoints = 20\n")
        self.succeed("sweep", "spec.toml", *common, "sweep")
        for name in SUBCOMMANDS - {"audit", "generate", "counterexample"}:
            self.assertTrue((self.here / name).is_dir(), name)
        done = self.succeed("audit", "lloyd/final.mesh", *common, "audit")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        audit = json.loads((self.here / "audit" / "audit.json").read_text(encoding="utf-8"))
        self.assertIs(audit["delaunay"], True)
        self.assertEqual((audit["dimension"], audit["vertices"], audit["first_fault"]), (2, 20, ""))
        self.assertEqual(set(audit["faults"].values()), {0})

    def test_help_says_what_seed_and_threads_do(self):
        """`degeneracy`, for example, examines certificates in all its threads; subcommands with one thread say so."""
        said = {name: " ".join(self.succeed(name, "--help").stdout.split()) for name in SUBCOMMANDS}
        one = {name for name in SUBCOMMANDS if "one thread is used here" in said[name]}
        self.assertEqual(one, {"audit", "generate", "counterexample"})
        self.assertEqual({name for name in SUBCOMMANDS if "nothing is random here" in said[name]},
                         {"audit", "degeneracy", "counterexample", "advise"})
        for name in SUBCOMMANDS - one:
            self.assertRegex(said[name],
                             r"--threads INT:1 to 1024=1 Threads [^.]*; results do not depend on (it|them)\b", name)
        self.assertIn("Threads that look at certificates together", said["degeneracy"])
        self.assertIn("What to write, whatever the extension says", said["generate"])

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
            ["lloyd", "--points", "10", "--density", "photo.gif"],
            ["lloyd", "--points", "10", "--invert"],
            ["lloyd", "--points", "10", "--dots", "cells"],
            ["lloyd", "--points", "10", "--density", "a.pgm", "--domain", "disc"],
            ["lloyd", "--points", "10", "--density", "a.pgm", "--radius", "2"],
            ["lloyd", "--points", "10", "--density", "a.pgm", "--dots", "round"],
            ["lloyd", "--points", "10", "--strategy", "magic"],
            ["lloyd", "--points", "10", "--tolerance", "magic"],
            ["lloyd", "--points", "10", "--threads", "0"],
            ["lloyd", "--points", "010"],
            ["lloyd", "--points", "0x10"],
            ["lloyd", "--points", "10", "--seed", "18446744073709551616"],
            ["lloyd", "--points", "10", "--audit", "18446744073709551616"],
            ["lloyd", "--points", "10", "--density", "sin2", "--radius", "1e6"],
            ["lloyd", "--points", "10", "--radius", "0"],
            ["lloyd", "--points", "10", "--radius", "-1"],
            ["lloyd", "--points", "10", "--iterations", "1.5"],
            ["lloyd", "--points", "10", "surplus"],
            ["lloyd", "--points", "10", "--output", ""],
            ["lloyd", "--points", "10", "--domain", "three.xyz", "--radius", "2"],
            ["lloyd", "--input", "three.xyz", "--radius", "2"],
            ["nodt", "--sphere", "--vertices", "30", "--gradation", "2"],
            ["nodt", "--sphere", "--vertices", "30", "--sizing", "constant", "--gradation", "2"],
            ["nodt", "--sphere", "--vertices", "30", "--allow-crossing"],
            ["replay"],
            ["degeneracy"],
            ["advise"],
            ["audit"],
            ["audit", "x.mesh", "--output", ""],
            ["counterexample", "--output", ""],
            ["compare", "--output", "", "--", "lloyd", "--points", "10"],
            ["compare"],
            ["compare", "--"],
            ["compare", "--", "audit", "x.mesh"],
            ["compare", "--", "lloyd"],
            ["compare", "--", "lloyd", "--points", "10", "--output", "out"],
            ["compare", "--", "lloyd", "--points", "10", "--force"],
            ["compare", "--strategies", "tolerances,magic", "--", "lloyd", "--points", "10"],
            ["compare", "--strategies", "tolerances,tolerances", "--", "lloyd", "--points", "10"],
            ["compare", "--strategies", "tolerances:magic", "--", "lloyd", "--points", "10"],
        ):
            with self.subTest(words=words):
                self.refuse(2, *words)

    def test_empty_values_are_wrong_usage(self):
        self.xyz("three.xyz", TRIANGLE)
        self.write("spec.toml", "[[grid]]\npoints = 20\n")
        lloyd = ("lloyd", "--points", 10, "--iterations", 1)
        for words in ((*lloyd, "--box"), (*lloyd, "--domain"), (*lloyd, "--size"), (*lloyd, "--density"),
                      ("lloyd", "--input"), ("generate", "uniform", "-n", 5, "--box"), ("generate",),
                      ("generate", "uniform", "-n", 5, "--output"), ("replay", "three.xyz", "--box"),
                      ("replay", "three.xyz", "--columns"), ("replay", "three.xyz", "--clip"), ("replay",),
                      ("replay", "three.xyz", "--coincident"), ("degeneracy", "three.xyz", "--box"),
                      ("degeneracy", "three.xyz", "--columns"), ("degeneracy", "three.xyz", "--raw"),
                      ("degeneracy", "three.xyz", "--thresholds"), ("degeneracy", "three.xyz", "--format"),
                      ("advise", "three.xyz", "--columns"), ("nodt", "--sphere", "--vertices", 30, "--domain-as"),
                      ("nodt", "--surface"), ("audit",), ("sweep",), ("sweep", "spec.toml", "--output"),
                      ("reproduce", "--quick", "--only"), ("compare", "--strategies"),
                      ("compare", "--", "replay", "three.xyz", "--columns"),
                      ("compare", "--", *lloyd, "--domain")):
            with self.subTest(words=words):
                said = self.refuse(2, *words, "")
                self.assertRegex(said, "the value is empty|not in {|'' is none of")

    def test_numbers_that_no_double_holds_are_called_that(self):
        self.xyz("three.xyz", TRIANGLE)
        beyond = "1e400' is beyond what a double can hold"
        for words in (("generate", "uniform", "-n", 5, "--box", "1,1e400"), ("lloyd", "--points", 9, "--box", "-1e400"),
                      ("lloyd", "--points", 9, "--domain", "box", "--size", "1e400,1"),
                      ("lloyd", "--points", 9, "--radius", "1e400"),
                      ("replay", "three.xyz", "--clip", "0,0,1e400,1", "--voronoi", "--output", "out"),
                      ("degeneracy", "three.xyz", "--thresholds", "1e400")):
            with self.subTest(words=words):
                self.assertIn(beyond, self.refuse(2, *words))
        self.assertIn("'inf' is not a number", self.refuse(2, "generate", "uniform", "-n", 5, "--box", "1,inf"))

    def test_negative_counts_are_wrong_usage(self):
        for option in ("--iterations", "--audit", "--seed", "--threads"):
            with self.subTest(option=option):
                self.refuse(2, "lloyd", "--points", "10", option, "-1")

    def test_a_radius_that_is_no_number_is_refused(self):
        for radius in ("nan", "inf", "-inf"):
            with self.subTest(radius=radius):
                line = self.refuse(2, "lloyd", "--points", "10", "--iterations", "1", "--radius", radius)
                self.assertLess(len(line), 200)


if __name__ == "__main__":
    tool.main(__doc__)
