#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages and figures of the repository, in Chromium: nothing on the console, nothing fetched, all links and images
valid, no NaN, no label of a plot cut or upon another.

usage: tests/pages/test_committed.py [CLASS[.METHOD] ...]

Needs chromium and python3-websocket (tools/setup --deep). Ends with 77 where there is no Chromium.
"""

import unittest

from page_scripts import CLAIMS, CLASHES, DOTS, TABLES
from test_pages import ROOT, BrowserTest, Page

PAGES = sorted(ROOT.glob("docs/**/*.html"))
FIGURES = sorted(ROOT.glob("docs/degeneracy/*.svg"))

# Files that links and images name.
NAMED = """[...document.querySelectorAll('a[href],img[src]')].map(e => e.getAttribute('href') || e.getAttribute('src'))
  .filter(name => !/^([a-z]+:|#)/.test(name))"""
# Text that is drawn or read where a value is not a number.
NO_NUMBERS = """(() => {
  const found = [...document.querySelectorAll('[d],[x],[y],[cx],[cy],[points],[transform],[viewBox]')]
    .filter(e => [...e.attributes].some(a => /\\b(NaN|nan|inf|Infinity|undefined)\\b/.test(a.value)
                                           && a.name !== 'aria-label'))
    .map(e => e.outerHTML.slice(0, 200));
  for (const e of document.querySelectorAll('td,text,tspan'))
    if (/^[+-]?(nan|inf|infinity|undefined)$/i.test(e.textContent.trim())) found.push(e.outerHTML.slice(0, 200));
  return found;
})()"""
BROKEN = "[...document.images].filter(i => !i.complete || i.naturalWidth === 0).map(i => i.src.slice(0, 100))"


class Committed(BrowserTest):
    def look(self, path):
        page = Page(self.browser, path)
        try:
            self.assertEqual(page.complaints(), [])
            self.assertEqual(page.evaluate(NO_NUMBERS), [])
            self.assertEqual(page.evaluate(CLASHES), [])
            if path.suffix == ".svg":
                self.assertGreater(page.evaluate("document.querySelectorAll('path.curve').length"), 0)
                return
            self.assertEqual([url for url in page.fetched() if not url.startswith("file:")], [])
            self.assertEqual(page.evaluate(BROKEN), [])
            for name in page.evaluate(NAMED):
                self.assertTrue((path.parent / name.split("#")[0]).exists(), f"leads nowhere: {name}")
            self.assertEqual(page.evaluate(DOTS), [])
        finally:
            page.close()

    def test_pages(self):
        self.assertGreater(len(PAGES), 0)
        for path in PAGES:
            with self.subTest(page=path.name):
                self.look(path)

    def test_narrow(self):
        for path in PAGES:
            with self.subTest(page=path.name):
                page = Page(self.browser, path, width=400)
                try:
                    self.assertEqual(page.evaluate(TABLES), [])
                    self.assertEqual(page.evaluate(CLAIMS), [])
                finally:
                    page.close()

    def test_figures(self):
        self.assertGreater(len(FIGURES), 0)
        for path in FIGURES:
            with self.subTest(figure=path.name):
                self.look(path)


if __name__ == "__main__":
    unittest.main()
