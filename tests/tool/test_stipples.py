#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus lloyd` with a picture for its density. usage: test_stipples.py --tool=PATH [CLASS[.METHOD]...]"""

import math
import struct
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

import tool
from tool import ToolTest

SVG = "{http://www.w3.org/2000/svg}"
WIDTH, HEIGHT = 90, 60
CORPUS = Path(__file__).resolve().parents[2] / "fuzz/corpus/readers"


def tone(i, j):
    """White on the left, darker to the right, and a black bar along the bottom."""
    return 0 if j >= 50 else 255 - 2 * i


class Stipples(ToolTest):
    def setUp(self):
        super().setUp()
        rows = [bytes(tone(i, j) for i in range(WIDTH)) for j in range(HEIGHT)]
        (self.here / "a.pgm").write_bytes(b"P5\n%d %d\n255\n" % (WIDTH, HEIGHT) + b"".join(rows))
        (self.here / "a.ppm").write_bytes(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) +
                                          b"".join(bytes(v for v in row for _ in range(3)) for row in rows))

        def chunk(name, data):
            return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

        (self.here / "a.png").write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b""))

    def stipple(self, *words, name="a.pgm", points=600):
        self.succeed("lloyd", "--density", name, "--points", points, "--iterations", "25", "--output", "out", "--quiet",
                     *words)
        text = (self.here / "out" / "stipples.svg").read_text(encoding="ascii")
        root = ElementTree.fromstring(text)
        self.assertEqual(root.tag, SVG + "svg")
        self.assertEqual(root.get("viewBox"), f"0 0 {WIDTH} {HEIGHT}")
        return text, [tuple(float(c.get(k)) for k in ("cx", "cy", "r")) for c in root.iter(SVG + "circle")]

    def test_dots(self):
        _, dots = self.stipple()
        self.assertEqual(len(dots), 600)
        self.assertEqual(self.summary("out")["audit"], {"checked": 1, "failed": 0})
        ink = sum(255 - tone(i, j) for i in range(WIDTH) for j in range(HEIGHT)) / 255
        radii = {r for _, _, r in dots}
        self.assertEqual(len(radii), 1)
        self.assertLess(abs(600 * math.pi * radii.pop() ** 2 / ink - 1), 0.02)
        # In the file as in the picture: y goes down, and the points of the mesh go up from the lower left corner.
        bar = sum(y > 50 for _, y, _ in dots)
        share = 600 * WIDTH * 10 / ink
        self.assertLess(abs(bar - share), 0.1 * share)
        for (x, y, r), (u, v) in zip(dots, self.mesh("out")[0]):
            self.assertLess(math.hypot(x - u, y - (HEIGHT - v)), 0.08 * r)
        self.assertTrue(all(0 <= x <= WIDTH and 0 <= y <= HEIGHT for x, y, _ in dots))

    def test_format_and_threads_make_no_difference(self):
        text, _ = self.stipple()
        for words in (["--threads", "3"], ["--strategy", "rebuild"]):
            self.assertEqual(self.stipple(*words)[0], text)
        for name in ("a.png", "a.ppm"):
            self.assertEqual(self.stipple(name=name)[0], text)
        self.assertNotEqual(self.stipple("--seed", "2")[0], text)

    def test_jpeg(self):
        """Those of the fuzz targets, without their first letter: 9 by 5 pixels, and 24 by 16 that Exif turns."""
        for name, size in (("jpeg-gray", "9 5"), ("jpeg-turned", "16 24")):
            (self.here / "a.jpg").write_bytes((CORPUS / name).read_bytes()[1:])
            self.succeed("lloyd", "--density", "a.jpg", "--points", "30", "--iterations", "3", "--output", "out",
                         "--quiet")
            root = ElementTree.fromstring((self.here / "out" / "stipples.svg").read_text(encoding="ascii"))
            self.assertEqual(root.get("viewBox"), f"0 0 {size}")
            self.assertEqual(len(list(root.iter(SVG + "circle"))), 30)

    def test_inverted(self):
        text, dots = self.stipple("--invert")
        self.assertLess(sum(y > 50 for _, y, _ in dots), 4)
        self.assertGreater(sum(x < WIDTH / 2 for x, _, _ in dots), 300)
        self.assertIn('fill="#000"/>', text)

    def test_dots_as_large_as_the_ink_of_their_cells(self):
        _, dots = self.stipple("--dots", "cells")
        ink = sum(255 - tone(i, j) for i in range(WIDTH) for j in range(HEIGHT)) / 255
        self.assertLess(abs(sum(math.pi * r * r for _, _, r in dots) / ink - 1), 0.005)
        self.assertGreater(len({r for _, _, r in dots}), 20)

    def test_points_from_a_file(self):
        self.xyz("in.xyz", [(10, 10), (80, 20), (40, 50)])
        self.succeed("lloyd", "--density", "a.pgm", "--input", "in.xyz", "--iterations", "2", "--output", "out",
                     "--quiet")
        self.xyz("beside.xyz", [(10, 10), (80, 20), (40, 61)])
        line = self.refuse(3, "lloyd", "--density", "a.pgm", "--input", "beside.xyz")
        self.assertIn("beside.xyz:3", line)

    def test_compare(self):
        self.succeed("compare", "--strategies", "rebuild,auto", "--quiet", "--output", "both", "--", "lloyd",
                     "--density", "a.png", "--points", "200", "--iterations", "10")

    def test_pictures_that_are_none(self):
        (self.here / "white.pgm").write_bytes(b"P5 2 2 255\n" + b"\xff" * 4)
        (self.here / "short.png").write_bytes((self.here / "a.png").read_bytes()[:80])
        (self.here / "vast.pgm").write_bytes(b"P5 60000 60000 255\n")
        (self.here / "short.ppm").write_bytes((self.here / "a.ppm").read_bytes()[:80])
        (self.here / "short.jpg").write_bytes((CORPUS / "jpeg-gray").read_bytes()[1:-20])
        for name in ("missing.png", "white.pgm", "short.png", "short.ppm", "short.jpg", "vast.pgm"):
            with self.subTest(name=name):
                self.assertIn(name, self.refuse(3, "lloyd", "--points", "50", "--density", name, "--output", "none"))
        for name in ("a.gif", "a.pam"):
            with self.subTest(name=name):
                self.assertIn("no picture (.png, .jpg, .pgm, .ppm)",
                              self.refuse(2, "lloyd", "--points", "50", "--density", name))
        self.assertFalse((self.here / "none").exists())


if __name__ == "__main__":
    tool.main(__doc__)
