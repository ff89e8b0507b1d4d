#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The site that tools/docs made, in Chromium: navigation, search without a server, wide and narrow.

usage: tests/pages/test_site.py [--screenshots=DIR] [CLASS[.METHOD] ...]

Needs build/docs/html (tools/docs), chromium and python3-websocket (tools/setup --deep). Ends with 77 where there is no
Chromium.
"""

import json
import re
import sys
import unittest
from pathlib import Path

from browser import BrowserTest, Page

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "build/docs/html"
SCREENSHOTS = None
FOUND = "[...document.querySelectorAll('#find-found a')].map(a => [a.textContent, a.getAttribute('href')])"
MENU = "[...document.querySelectorAll('#main-menu > li > a')].map(a => a.textContent.trim())"
# Words, and an address below the first five that are found.
SEARCHES = {"periodic box": "md_docs_periodic.html", "move_all": "classannulus_1_1Moving__mesh.html",
            "voronoi_vjp": "python_names.html", "annulus_create": "annulus_8h.html", "exit status": "md_docs_tool.html"}


class Site(BrowserTest):
    def opened(self, name, **size):
        page = Page(self.browser, SITE / name, **size)
        self.addCleanup(page.close)
        self.assertEqual(page.complaints(), [])
        self.assertEqual([url for url in page.fetched() if not url.startswith(("file:", "data:"))], [])
        if SCREENSHOTS:
            page.screenshot(SCREENSHOTS / f"{name.removesuffix('.html')}-{size.get('width', 1280)}.png", whole=False)
        return page

    def test_navigation(self):
        for name in ("index.html", "find.html", "md_docs_gallery.html", "python_names.html"):
            with self.subTest(page=name):
                menu = self.opened(name).evaluate(MENU)
                self.assertEqual([re.sub(r"\W+$", "", entry) for entry in menu],
                                 ["annulus", "Search all text", "Guide", "Tutorials", "Gallery", "Reference",
                                  "Background"])
        text = (SITE / "menudata.js").read_text(encoding="utf-8")
        for address in re.findall(r'url:"([^"#]+)', text):
            self.assertTrue((SITE / address).exists(), address)
        # Every page of docs/ can be reached from the menu.
        for page in ROOT.glob("docs/*.md"):
            self.assertIn(f'"md_docs_{page.stem}.html"', text)

    def test_search(self):
        page = self.opened("find.html")
        for words, address in SEARCHES.items():
            with self.subTest(words=words):
                page.evaluate(f"words.value = {json.dumps(words)}; words.dispatchEvent(new Event('input'))")
                found = page.evaluate(FOUND)[:5]
                self.assertTrue(any(to.startswith(address) for _, to in found), found)
        page.evaluate("words.value = 'xyzzy'; words.dispatchEvent(new Event('input'))")
        self.assertEqual(page.evaluate(FOUND), [])

    def test_addresses_of_the_search(self):
        text, anchors = (SITE / "find.html").read_text(encoding="utf-8"), {}
        entries = json.loads(re.search(r"const ENTRIES = (.*);$", text, re.MULTILINE).group(1).replace("<\\/", "</"))
        self.assertGreater(len(entries), 1000)
        for address, *_ in entries:
            name, _, anchor = address.partition("#")
            if name not in anchors:
                anchors[name] = set(re.findall(r'id="([^"]+)"', (SITE / name).read_text(encoding="utf-8")))
            if anchor:
                self.assertIn(anchor, anchors[name], address)

    def test_narrow(self):
        for name in ("index.html", "find.html", "md_docs_gallery.html", "md_docs_when.html"):
            with self.subTest(page=name):
                page = self.opened(name, width=400)
                self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 400)
                left = page.evaluate("document.querySelector('.contents').getBoundingClientRect().left")
                self.assertLess(left, 40)
                width = page.evaluate("document.querySelector('#doc-content').scrollWidth")
                self.assertLessEqual(width, 400)


if __name__ == "__main__":
    for word in [w for w in sys.argv if w.startswith("--screenshots=")]:
        sys.argv.remove(word)
        SCREENSHOTS = Path(word.partition("=")[2])
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    unittest.main()
