#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are not what they seem, and faults in inputs. usage: test_bad_inputs.py --tool=PATH [CLASS[.METHOD]...]"""

import bz2
import gzip
import lzma
import math
import os
import struct
import subprocess

import tool
from tool import TRIANGLE, ToolTest


class Kinds(ToolTest):
    """Files whose content does not match their names."""

    CSV = "frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n"

    def test_each_is_called_by_its_name(self):
        for content, words in (
            (self.CSV.encode("utf-16"), "is text in UTF-16"), (self.CSV.encode("utf-16-le"), "is text in UTF-16"),
            (self.CSV.encode("utf-16-be"), "is text in UTF-16"), (self.CSV.encode("utf-32"), "is text in UTF-32"),
            (b"\x93NUMPY\x01\0", "is an array of NumPy"),
            (bz2.compress(self.CSV.encode()), "is packed by bzip2"),
            (lzma.compress(self.CSV.encode()), "is packed by xz"),
            (b"PK\x03\x04\x14\0\0\0", "is a zip archive"), (b"\x28\xb5\x2f\xfd\x24\x00\x00", "is packed by zstd"),
        ):
            for name, command in (("a.csv", ["replay"]), ("a.xyz", ["degeneracy"]), ("a.off", ["degeneracy"]),
                                  ("a.mesh", ["audit"]), ("a.stl", ["nodt", "-n", "50", "--surface"]),
                                  ("a.png", ["lloyd", "-n", "50", "--density"]),
                                  ("a.toml", ["sweep", "--output", "out"])):
                if words == "is text in UTF-16" and name in ("a.csv", "a.xyz"):
                    continue  # these are read, see test_tables.py
                self.write(name, content)
                line = self.refuse(3, *command, name)
                self.assertRegex(line, rf"\Aannulus: {name}(:1)?: {words}.*; expected ")

    def test_gzip_and_lines_of_old_programs_are_read(self):
        expected = None
        for content in (self.CSV, gzip.compress(self.CSV.encode()), self.CSV.replace("\n", "\r"),
                        self.CSV.replace("\n", "\r\n")):
            self.write("a.csv", content if isinstance(content, bytes) else content.encode())
            self.succeed("replay", "a.csv", "--output", "out")
            mesh = (self.here / "out" / "final.mesh").read_bytes()
            self.assertEqual(mesh, expected or mesh)
            expected = mesh
        spec = '[[grid]]\rpoints = 10\r'
        self.write("a.toml", spec.encode())
        self.succeed("sweep", "a.toml", "--output", "sums", "--quiet")

    def test_a_file_without_end(self):
        """With a memory limit that reading on would exceed at once."""
        for name, command in (("a.csv", ["replay"]), ("a.xyz", ["degeneracy"]), ("a.off", ["degeneracy"]),
                              ("a.ply", ["degeneracy"]), ("a.mesh", ["audit"]), ("b.mesh", ["nodt", "--mesh"]),
                              ("a.stl", ["nodt", "-n", "50", "--surface"]),
                              ("a.obj", ["nodt", "-n", "50", "--surface"]),
                              ("a.inr", ["nodt", "-n", "50", "--surface"]),
                              ("a.png", ["lloyd", "-n", "50", "--density"]),
                              ("a.jpg", ["lloyd", "-n", "50", "--density"]),
                              ("a.pgm", ["lloyd", "-n", "50", "--density"]),
                              ("a.ppm", ["lloyd", "-n", "50", "--density"]),
                              ("c.xyz", ["lloyd", "-n", "50", "--domain"]), ("a.toml", ["sweep", "--output", "out"])):
            os.symlink("/dev/zero", self.here / name)
            self.assertIn(f"{name}: is a device", self.refuse(3, *command, name))
        os.symlink("/dev/zero", self.here / "points.xyz")
        self.write("b.toml", '[[grid]]\nfile = "points.xyz"\n')
        self.assertIn("b.toml:2: 'file' is", self.refuse(3, "sweep", "b.toml", "--output", "out"))

    def test_standard_input_without_end(self):
        with open("/dev/zero", "rb") as zero:
            done = subprocess.run([tool.OPTIONS["tool"], "sweep", "-", "--output", "out"], cwd=self.here, stdin=zero,
                                  capture_output=True, text=True, timeout=tool.HANGING, check=False)
        self.assertEqual((done.returncode, done.stdout), (3, ""))
        self.assertRegex(done.stderr, r"\Aannulus: standard input: has more than 67108864 bytes; expected fewer\n\Z")


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
        self.fault(self.write("points.pp", "0 0\n"), None, "pp")
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
        self.assertIn("solid.mesh:11: ", self.refuse(3, "audit", self.write(
            "solid.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                          "Tetrahedra\n1\n1 2 3 5 0\nEnd\n")))


if __name__ == "__main__":
    tool.main(__doc__)
