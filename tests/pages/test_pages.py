#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of page that the tool writes, in Chromium: nothing on the console, nothing fetched, nothing outside the
window, no label cut or upon another, light and dark, wide and narrow; sliders and sorting work.

usage: tests/pages/test_pages.py [--tool=PATH] [--screenshots=DIR] [CLASS[.METHOD] ...]

Without --tool the preset release is built. Screenshots are for inspection: each kind wide, dark, narrow and printed.
Needs chromium and python3-websocket (tools/setup --deep). Ends with `N passed, N failed`, and with 77 where there is no
Chromium.
"""

import argparse
import itertools
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from browser import BrowserTest, Page
except ImportError as missing:
    print(f"tests/pages: {missing}; install python3-websocket (tools/setup --deep)")
    sys.exit(77)
from page_scripts import BEGINS, CLAIMS, CLASHES, COLOURS, CONTRAST, DOTS, TABLES
from pages import KINDS

ROOT = Path(__file__).resolve().parents[2]
SIZES = {"wide": {}, "dark": {"dark": True}, "narrow": {"width": 360, "height": 700}}


class Pages(BrowserTest):
    tool = screenshots = None

    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        where = Path(cls.directory.name)
        draw = random.Random(1)
        files = {"MOTION": where / "motion.csv", "GRID": where / "grid.xyz", "POINTS": where / "points.xyz",
                 "LINE": where / "line.xyz", "SPEC": where / "spec.toml", "BOXES": where / "boxes.toml",
                 "LATTICE": where / "lattice.csv", "PICTURE": ROOT / "docs/knot.png"}
        people = [[draw.random(), draw.random()] for _ in range(60)]
        rows = ["frame,id,x,y"]
        for frame in range(25):
            rows += [f"{frame},{i},{x},{y}" for i, (x, y) in enumerate(people) if (i + frame) % 40 != 0]
            people = [[x + draw.gauss(0, 0.01), y + 0.02] for x, y in people]
        files["MOTION"].write_text("\n".join(rows) + "\n")
        files["GRID"].write_text("".join(f"{x} {y}\n" for x in range(12) for y in range(12)))
        files["POINTS"].write_text("".join(f"{draw.random()} {draw.random()} {draw.random()}\n" for _ in range(400)))
        files["LATTICE"].write_text("frame,id,x,y\n" + "".join(
            f"{f},{6 * x + y},{x + f},{y + f}\n" for f in range(3) for x in range(6) for y in range(6)))
        files["LINE"].write_text("0 0\n1 1\n2 2\n")
        files["BOXES"].write_text("[[grid]]\npoints = 50\nbox = [\"2,1\", \"1,0.25,0,2\", \"1,1,1\"]\n"
                                  "motion = { kind = \"shear\", steps = [0, 1] }\n[[grid]]\npoints = 50\n",
                                  encoding="utf-8")
        files["SPEC"].write_text("[[grid]]\npoints = 100\ndimension = 3\n"
                                 "[[grid]]\npoints = 300\nkind = [\"uniform\", \"jittered\"]\n"
                                 "rounding = [\"double\", \"decimal:3\"]\nseeds = 3\n")
        cls.pages = {}
        for kind in KINDS:
            words = [str(files.get(w, w)) for w in kind.command.split()]
            at = words.index("--") if "--" in words else len(words)
            words[at:at] = ["--output", str(where / kind.name), "--quiet"]
            done = subprocess.run([cls.tool, *words], capture_output=True, text=True, check=False)
            if done.returncode != kind.status:
                raise AssertionError(f"annulus {' '.join(words)}: exit status {done.returncode}\n{done.stderr}")
            cls.pages[kind.name] = where / kind.name / kind.page
        super().setUpClass()

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        cls.directory.cleanup()

    def open(self, name, **how):
        page = Page(self.browser, self.pages[name], **how)
        self.addCleanup(page.close)
        return page

    def test_every_kind_of_page_is_here(self):
        """Every page in the tool's sources is written by some kind."""
        sources = "".join(p.read_text() for p in ROOT.glob("src/apps/cli/*.cpp"))
        for name in set(itertools.chain(*(line.split('"')[1::2] for line in sources.splitlines()
                                          if "out.write(" in line))):
            if name.endswith(".html"):
                self.assertIn(name, {k.page for k in KINDS})

    def test_nothing_is_said_or_fetched(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                for size, how in SIZES.items():
                    page = self.open(kind.name, **how)
                    if self.screenshots:
                        page.screenshot(self.screenshots / f"{kind.name}-{size}.png")
                    self.assertEqual(page.complaints(), [], size)
                    self.assertEqual(page.fetched(), [], size)
                    for heading in kind.shows:
                        self.assertIn(heading,
                                      page.evaluate("[...document.querySelectorAll('h2')].map(h => h.textContent)"))
                    self.assertEqual(page.evaluate("document.images.length"), 0)
                    self.assertEqual(page.evaluate("document.links.length > 0"), kind.links)

    def test_nothing_is_cut(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                for size, how in SIZES.items():
                    page = self.open(kind.name, **how)
                    self.assertLessEqual(*page.evaluate("[document.documentElement.scrollWidth, innerWidth]"), size)
                    self.assertEqual(page.evaluate(CLASHES), [], size)
                    least, text = page.evaluate(CONTRAST)
                    self.assertGreaterEqual(least, 4.5, f"{size}: '{text}'")

    def test_what_was_found_comes_first(self):
        for kind in KINDS:
            if not kind.says:
                continue
            with self.subTest(kind=kind.name):
                page = self.open(kind.name)
                found = page.evaluate("[...document.querySelectorAll('p.finding')].map(p => p.textContent).join(' ')")
                for part in kind.says:
                    self.assertIn(part, found)
                self.assertTrue(page.evaluate(BEGINS))

    def test_faces_have_the_colours_of_their_legend(self):
        drawn = 0
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                for how in (SIZES["wide"], SIZES["dark"]):
                    page = self.open(kind.name, **how)
                    self.assertEqual(page.evaluate(COLOURS), [])
                    drawn += page.evaluate("document.querySelectorAll('.mesh .face').length")
        self.assertGreater(drawn, 0)

    def test_empty_bins_are_gaps(self):
        page = self.open("sweep")
        pieces = page.evaluate("""[...document.querySelectorAll('svg[aria-label="Cells by width"] path.curve')]
            .map(c => c.getAttribute('d').match(/M/g).length)""")
        self.assertGreater(max(pieces), 1)

    def test_wide_tables_scroll_in_their_box(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                for width in (1280, 700, 400, 320):
                    self.assertEqual(self.open(kind.name, width=width).evaluate(TABLES), [], width)

    def test_a_claim_comes_before_its_reason(self):
        self.assertGreater(self.open("reproduce").evaluate("document.querySelectorAll('.claims tbody tr').length"), 40)
        for width in (400, 700):
            self.assertEqual(self.open("reproduce", width=width).evaluate(CLAIMS), [], width)

    def test_no_plot_has_a_dot_alone(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                self.assertEqual(self.open(kind.name).evaluate(DOTS), [])

    def test_pages_of_runs_say_what_their_words_mean(self):
        for kind in KINDS:
            if kind.page == "report.html":
                with self.subTest(kind=kind.name):
                    last = self.open(kind.name).evaluate("[...document.querySelectorAll('h2')].map(h => h.textContent)"
                                                         ".filter(h => h !== 'Notes').pop()")
                    self.assertEqual(last, "Terms")

    def test_without_scripts(self):
        """Everything except sliders and sorting works, and nothing looks like a button."""
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                page = self.open(kind.name, scripts=False)
                self.assertNotEqual(page.evaluate("document.title"), "")
                self.assertEqual(page.evaluate("document.querySelectorAll('button').length"), 0)
                self.assertEqual(
                    page.evaluate("[...document.querySelectorAll('input')].filter(e => e.checkVisibility()).length"), 0)

    def test_sorting(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                page = self.open(kind.name)
                tables = page.evaluate("document.querySelectorAll('table.sortable').length")
                self.assertEqual(tables, kind.sorted_tables)
                for table in range(tables):
                    self.sort(page, f"document.querySelectorAll('table.sortable')[{table}]", table)
                self.assertEqual(page.complaints(), [])

    def sort(self, page, table, number):
        def rows():
            return page.evaluate(f"[...{table}.tBodies[0].rows].map(r => [...r.cells].map(c => c.textContent))")

        def keys(column):
            return page.evaluate(f"[...{table}.tBodies[0].rows].map(r => r.cells[{column}].dataset.key ?? null)"
                                 ".map(k => k === null ? null : +k)")

        # One cell has no number, for example the ratio to a strategy that took no time.
        page.evaluate(f"delete {table}.tBodies[0].rows[0].cells[2].dataset.key")
        before = rows()
        for column in range(len(before[0])):
            page.evaluate(
                f"{table}.tHead.rows[0].cells[{column}].querySelector('button').id = 'head-{number}-{column}'")
            for direction in ("ascending", "descending"):
                page.click(f"#head-{number}-{column}")
                self.assertEqual(sorted(rows()), sorted(before))  # whole rows
                marks = page.evaluate(f"[...{table}.tHead.rows[0].cells].map(c => c.getAttribute('aria-sort'))")
                self.assertEqual(marks, [direction if c == column else None for c in range(len(marks))])
                if column == 0:
                    names = [r[0] for r in rows()]
                    self.assertEqual(names, sorted(names, reverse=direction == "descending"))
                    continue
                there = [k for k in keys(column) if k is not None]
                self.assertEqual(there, sorted(there, reverse=direction == "descending"))
                self.assertEqual(keys(column)[: len(there)], there)  # cells without a number come last
                name = page.evaluate(f"{table}.tHead.rows[0].cells[{column}].textContent")
                if name != "within tolerance":  # no strategy of the table may have tested any
                    self.assertGreater(len(there), 0, name)
        # The keyboard works like the mouse.
        page.evaluate(f"document.querySelector('#head-{number}-1').focus()")
        page.press("Enter")
        self.assertEqual(keys(1), sorted(keys(1)))

    def test_sliders(self):
        for kind in KINDS:
            with self.subTest(kind=kind.name):
                page = self.open(kind.name)
                sliders = page.evaluate("document.querySelectorAll('input[type=range]').length")
                self.assertEqual(sliders, kind.sliders)
                for slider in range(sliders):
                    self.slide(page, f"document.querySelectorAll('input[type=range]')[{slider}]")
                self.assertEqual(page.complaints(), [])
                self.assertEqual(page.fetched(), [])

    def slide(self, page, slider):
        """Each end, the middle and a step by the keyboard show different pictures, and the same position the same
        one."""
        picture = ("[...document.querySelectorAll('svg,canvas')].filter(e => e.checkVisibility()).map(e => e.toDataURL "
                   "? e.toDataURL() : e.outerHTML).join()")
        low, high = (float(page.evaluate(f"{slider}.{end}")) for end in ("min", "max"))
        self.assertLess(low, high)

        def at(value):
            page.evaluate(f"{slider}.value = {value}; {slider}.dispatchEvent(new Event('input', {{bubbles: true}}))")
            page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
            return page.evaluate(picture)

        first, last = at(low), at(high)
        self.assertNotEqual(first, last)
        self.assertEqual(at(low), first)
        page.evaluate(f"{slider}.focus()")
        page.press("ArrowRight")
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.assertGreater(float(page.evaluate(f"{slider}.value")), low)
        self.assertNotEqual(page.evaluate(picture), first)
        page.press("Home")
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.assertEqual(page.evaluate(picture), first)


def built_tool():
    for command in (["cmake", "--preset", "release"],
                    ["cmake", "--build", "--preset", "release", "--target", "annulus-programs"]):
        built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if built.returncode != 0:
            sys.exit(built.stdout + built.stderr + f"tests/pages: {' '.join(command)} failed")
    return ROOT / "build/release/annulus"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", type=Path)
    parser.add_argument("--screenshots", type=Path)
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    Pages.tool = (arguments.tool or built_tool()).resolve()
    if arguments.screenshots:
        arguments.screenshots.mkdir(parents=True, exist_ok=True)
        Pages.screenshots = arguments.screenshots
    program = unittest.main(argv=[sys.argv[0], *arguments.names], exit=False, verbosity=2)
    failed = len({str(test).split(" (kind")[0] for test, _ in program.result.failures + program.result.errors})
    print(f"{program.result.testsRun - failed} passed, {failed} failed")
    return 0 if program.result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
