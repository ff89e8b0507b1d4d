#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a small `annulus reproduce` and checks its files. usage: test_reproduce.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import html
import json
import re
import signal
import subprocess
from pathlib import Path

import tool

FIGURES = {f"figure-{k}.html" for k in range(5, 13)}


def untimed(run):
    """The parts of a run in reproduction.json that do not depend on a clock."""
    run = dict(run)
    for name in ("load", "motion_seconds", "operations"):
        run.pop(name, None)
    run["strategies"] = {name: {k: v for k, v in s.items() if not k.endswith("seconds")}
                         for name, s in run.get("strategies", {}).items()}
    return run


class Reproduce(tool.ToolTest):
    SMALL = ["reproduce", "--quick", "--iterations", 3]
    LONG = ["reproduce", "--quick", "--iterations", 100000, "--only", "fig5"]

    def result(self, name):
        return json.loads((self.here / name / "reproduction.json").read_text(encoding="utf-8"))

    def test_everything(self):
        """Every figure has a page, every claim a verdict, every link is valid, and every table has numbers."""
        self.succeed(*self.SMALL, "--output", "all")
        files = {p.name for p in (self.here / "all").iterdir()}
        self.assertLessEqual(FIGURES | {"index.html", "claims.csv", "unsound.html", "slivers.html", "locked.html",
                                        "movers.html"}, files)
        self.assertEqual({p.name for p in self.here.iterdir()}, {"all"})  # no parts are left
        for page in (self.here / "all").glob("*.html"):
            text = page.read_text(encoding="utf-8")
            self.assertTrue(text.endswith("</html>\n"), page.name)
            self.assertNotRegex(text, r"\bnan\b|\binf\b", page.name)
            self.assertIn("A quick run:", text, page.name)
            # By what and when it was made stands below what was found, if anything was.
            begin = text.partition("</h1>\n")[2].partition("<h2>")[0]
            self.assertRegex(begin, r'\A(<p class="command">.*</p>\n)?(<p class="finding">.*</p>\n)*(<p[ >].*</p>\n)*'
                             r"<p>(Made by )?annulus \d+\.\d+\.\d+, \d\d? [A-Z][a-z]+ 20\d\d, ", page.name)
            self.assertNotIn('"finding"', re.split(r"annulus \d", begin)[-1], page.name)
            self.assertEqual("Least dihedral angle of a tetrahedron:" in text,
                             page.name in ("figure-8.html", "figure-9.html"), page.name)
            for target in re.findall(r'href="([^"]*)"', text):
                self.assertIn(target, files, page.name)
        for table in (self.here / "all").glob("*.csv"):
            rows = list(csv.reader(table.read_text(encoding="utf-8").splitlines()))
            self.assertGreater(len(rows), 1, table.name)
            self.assertEqual({len(r) for r in rows}, {len(rows[0])}, table.name)
        r = self.result("all")
        self.assertGreaterEqual(len(r["claims"]), 46)
        open_claims = [c["statement"] for c in r["claims"] if not c["paper_algorithm"]]
        self.assertLessEqual(len(open_claims), 9, open_claims)  # those that need surfaces, or more than 100 iterations
        self.assertEqual({c["figure"] + ".html" for c in r["claims"]} & FIGURES, FIGURES)
        for claim in r["claims"]:
            self.assertIn(claim["verdict"], ("agrees", "goes further", "differs", "is wrong", "open"), claim)
            self.assertTrue(claim["paper"], claim)
        sphere = r["runs"]["nodt-sphere"]
        self.assertEqual(sphere["iterations"], 3)
        for attack in sphere["adversary"]:
            self.assertGreater(attack["broken"], 0)
            self.assertEqual(attack["broken"], attack["accepted"])
            self.assertEqual(attack["audited"], attack["refuted"])
        printed = sphere["strategies"]["paper-printed"]
        self.assertEqual(len(printed["failed_in_a_row"]), 7)
        self.assertGreaterEqual(printed["failed_in_a_row"][0], printed["failed_in_a_row"][1])
        self.assertLess(printed["failed"], printed["moves"])
        for name in ("paper-in-place", "paper-printed-hybrid", "relocate-in-place", "relocate-cgal"):
            self.assertIn(name, sphere["strategies"])
        for rounding in sphere["rounding"]:
            self.assertLess(0, rounding["above_exact"])
            self.assertLess(rounding["above_exact"], rounding["bicells"])
        for operation in sphere["operations"]:
            self.assertGreater(operation["removal_seconds"], 0)
        for where in ("plane", "space"):
            some, all_of_them = (r["runs"][f"movers-{where}-{share}"]["strategies"]["paper-printed"]["failed"]
                                 for share in (1, 100))
            self.assertLess(10 * some, all_of_them)
        for run in r["runs"].values():
            for name, strategy in run.get("strategies", {}).items():
                if "paper" not in name:
                    self.assertEqual(strategy["audits_failed"], 0, name)
        index = (self.here / "all" / "index.html").read_text(encoding="utf-8")
        self.assertIn("left out", index)
        self.assertIn(f"<p>annulus {r['version']}, ", index)
        bodies, = (c for c in r["claims"] if "four bodies" in c["statement"])
        self.assertEqual(bodies["verdict"], "open")  # there is the sphere alone
        self.assertIn("man, bunny, liver", bodies["reason"])

    def test_the_committed_result(self):
        """The table, the JSON and the pages of docs/reproduction have the same claims and verdicts, and each page
        begins with what was found."""
        folder = Path(__file__).resolve().parents[2] / "docs/reproduction"
        with open(folder / "claims.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        claims = json.loads((folder / "reproduction.json").read_text(encoding="utf-8"))["claims"]
        names = {"claim": "statement"}
        self.assertEqual(claims, [{names.get(k, k): v for k, v in row.items()} for row in rows])
        index = (folder / "index.html").read_text(encoding="utf-8")
        shown = re.findall(r'<tr><th scope="row">(.*?) <small>.*?<span class="\w*">(.*?)</span>', index)
        self.assertEqual([(html.unescape(a), b) for a, b in shown], [(r["claim"], r["verdict"]) for r in rows])
        words = {"agrees": "agreed with what was measured here", "differs": "differed from it",
                 "is wrong": "proved to be wrong", "open": "stayed open"}
        counts = ", ".join(f"{[r['verdict'] for r in rows].count(v)} {w}" for v, w in words.items())
        self.assertIn(f'<p class="finding">Of {len(rows)} claims of the paper {counts}.</p>', index)
        self.assertIn("Verdicts follow from numbers by one rule.", index)
        styles = {re.search(r"(?s)<style>(.*?)</style>", page.read_text(encoding="utf-8"))[1]
                  for page in folder.glob("*.html")}
        self.assertEqual([style.count("{") - style.count("}") for style in styles], [0])  # one, and whole
        for page in sorted(folder.glob("*.html")):
            with self.subTest(page=page.name):
                text = page.read_text(encoding="utf-8")
                begin = text.partition("</h1>\n")[2]
                self.assertRegex(begin, r'\A(<p class="command">.*</p>\n)?(<p class="finding">.*</p>\n)+')
                # A page is opened alone: each says of which run its numbers are.
                self.assertIn("a run of 25 November 2026 (commit 6b191a48), older than this version of annulus",
                              begin.partition("<h2>")[0])
                here = [(r["claim"], r["verdict"]) for r in rows if r["figure"] == page.stem]
                found = re.findall(r"<li>(.*?) <strong>(.*?)</strong></li>", text)
                self.assertEqual([(html.unescape(a), b) for a, b in found], here)

    def test_only_and_again(self):
        """A second run with another number of threads gives the same results except times; earlier pages are
        replaced."""
        words = [*self.SMALL, "--only", "fig5,fig10"]
        self.succeed(*words, "--output", "a")
        self.succeed(*words, "--threads", 2, "--output", "b")
        a, b = self.result("a"), self.result("b")
        self.assertEqual(set(a["runs"]), {"points-one", "points-x2", "nodt-sphere"})
        self.assertEqual({n: untimed(r) for n, r in a["runs"].items()}, {n: untimed(r) for n, r in b["runs"].items()})
        self.assertIn("Only fig5 and fig10 were requested.",
                      (self.here / "a" / "index.html").read_text(encoding="utf-8"))
        for name in ("figure-10a.csv", "figure-5-one-3.csv"):
            self.assertEqual((self.here / "a" / name).read_bytes(), (self.here / "b" / name).read_bytes())
        self.succeed(*self.SMALL, "--only", "movers", "--output", "a")
        self.assertFalse((self.here / "a" / "figure-10a.csv").exists())
        self.assertTrue((self.here / "a" / "movers-plane.csv").exists())
        self.succeed(*self.SMALL, "--only", "fig5", "--output", "a")
        self.assertFalse((self.here / "a" / "movers-plane.csv").exists())

    def test_interrupted_and_resumed(self):
        words = ["reproduce", "--quick", "--iterations", 40, "--only", "fig5,fig10", "--output", "out"]
        parts = self.here / "out.partial"
        done = self.run_tool(*words, env=tool.at(signal.SIGINT, 1, "rename", "points-x2.json"))
        self.assertEqual(done.returncode, -signal.SIGINT)
        self.assertRegex(done.stderr, r"\Aannulus: interrupted; 2 of 3 parts are in out\.partial[^\n]*\n\Z")
        self.assertFalse((self.here / "out").exists())
        before = (parts / "points-x2.json").read_bytes()
        (parts / "points-one.json").write_text("{")  # as if the machine had lost it
        self.assertIn("another reproduction", self.refuse(2, *words, "--seed", 7))
        self.assertEqual((parts / "points-x2.json").read_bytes(), before)
        self.succeed(*words)
        self.assertFalse(parts.exists())
        self.assertEqual(set(self.result("out")["runs"]), {"points-one", "points-x2", "nodt-sphere"})

    def start(self, *words):
        """Starts a run, and returns when it has stopped in the middle, at one of the calls of the clock, of which every
        step has some and the start has few."""
        run = subprocess.Popen([tool.OPTIONS["tool"], *map(str, words)], cwd=self.here, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, env=tool.at(signal.SIGSTOP, 1000, "clock"))
        self.addCleanup(lambda: (run.kill(), run.wait()))
        tool.until_it_stops(run)
        self.assertNotEqual((self.here / "out.partial" / "reproduction.txt").read_bytes(), b"")
        return run

    def test_two_at_once(self):
        words = [*self.LONG, "--output", "out"]
        run = self.start(*words)
        done = self.run_tool(*words)
        self.assertIsNone(run.poll())
        self.assertEqual((done.returncode, done.stdout), (3, ""))
        self.assertRegex(done.stderr, r"\Aannulus: out\.partial: another reproduction is writing[^\n]*\n\Z")

    def test_other_surfaces_of_the_same_names(self):
        """Figure 5 uses none of them."""
        for place, text in (("one", "a"), ("two", "b")):
            (self.here / place).mkdir()
            for name in ("man.off", "bunny00.off", "liver.inr.gz"):
                (self.here / place / name).write_text(text, encoding="utf-8")
        words = [*self.LONG, "--output", "out", "--surfaces"]
        run = self.start(*words, "one")
        run.kill()
        run.wait()
        self.assertIn("another reproduction", self.refuse(2, *words, "two"))

    def test_wrong_usage(self):
        for words, said in ((["reproduce"], "--output"),
                            (["reproduce", "--output", "x", "--only", "fig4"], "fig4"),
                            (["reproduce", "--output", "x", "--iterations", "0"], "0"),
                            (["reproduce", "--output", "x", "fig5"], "fig5")):
            with self.subTest(words=words):
                self.assertIn(said, self.refuse(2, *words))
        self.assertIn("man.off", self.refuse(3, "reproduce", "--output", "x", "--surfaces", "nowhere"))
        (self.here / "mine").mkdir()
        (self.here / "mine" / "notes.txt").write_text("mine")
        self.refuse(3, *self.SMALL, "--output", "mine")


if __name__ == "__main__":
    tool.main(__doc__)
