#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats that are read, and faults in them. usage: test_inputs.py --tool=PATH [CLASS[.METHOD]...]"""

import gzip
import math
import struct

import tool
from tool import SPREAD, STRATEGIES, TRIANGLE, ToolTest


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
        self.write("A.CSV", "frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n")
        self.succeed("replay", "A.CSV")
        self.write("A.Off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        self.succeed("nodt", "--surface", "A.Off", "--vertices", "30", "--iterations", "1")
        header = "#INRIMAGE-4#{\nXDIM=8\nYDIM=8\nZDIM=8\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\n"
        image = header.ljust(252, "\n").encode() + b"##}\n" + bytes([1]) * 512
        for name in ("A.INR", "B.Inr.GZ"):
            self.write(name, image if name == "A.INR" else gzip.compress(image))
            self.succeed("nodt", "--surface", name, "--vertices", "30", "--iterations", "1")

    def test_packed(self):
        rows = "".join(f"{x} {y}\n" for x, y in SPREAD).encode()
        self.assertEqual(self.vertices_of(self.write("a.xyz.gz", gzip.compress(rows))), 5)
        self.assertEqual(self.vertices_of(self.write("b.csv.gz", gzip.compress(rows.replace(b" ", b",")))), 5)
        self.succeed("lloyd", "--points", "20", "--iterations", "2", "--output", "run", "--quiet")
        mesh = (self.here / "run" / "final.mesh").read_bytes()
        self.succeed("audit", self.write("final.mesh.gz", gzip.compress(mesh)))
        frame = b"frame,id,x,y\n0,1,0,0\n0,2,1,0\n0,3,0,1\n"
        self.succeed("replay", self.write("motion.csv.gz", gzip.compress(frame)))
        self.assertIn("cut off", self.refuse(3, "replay", self.write("cut.csv.gz", gzip.compress(frame)[:-1])))

    def test_extended_xyz(self):
        # id and mass are columns of numbers too: a guess takes them for coordinates.
        rows = "".join(f"{7 * i} 1.5 {x!r} {y!r} 0\n" for i, (x, y) in enumerate(SPREAD))
        self.write("a.xyz", f'5\nLattice="9 0 0 0 9 0 0 0 9" Properties="id:I:1:mass:R:1:pos:R:3"\n{rows}')
        done = self.succeed("lloyd", "--input", "a.xyz", "--ignore-z", "--iterations", "0", "--output", "out")
        self.assertRegex(done.stderr, r"\Aannulus: a.xyz:2: Lattice ignored: [^\n]*not supported[^\n]*\n\Z")
        self.assertEqual(sorted(self.mesh("out")[0]), sorted(SPREAD))
        done = self.succeed("degeneracy", "a.xyz", "--ignore-z", "--output", "out")
        self.assertIn("5 points in dimension 2", done.stdout)
        self.assertIn("Lattice ignored", done.stderr)
        self.succeed("compare", "--strategies", "filter", "--quiet", "--", "lloyd", "--input", "a.xyz", "--ignore-z")
        for name in (("lloyd", "--input"), ("degeneracy",), ("replay",)):
            self.write("b.xyz", "1\nProperties=a:S:18446744073709551615:pos:R:3\nH 0 0 0\n")
            self.assertIn("b.xyz:2: Properties give 'a'", self.refuse(3, *name, "b.xyz"))

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
        self.assertIn("solid.mesh:11: ", self.refuse(3, "audit", self.write(
            "solid.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                          "Tetrahedra\n1\n1 2 3 5 0\nEnd\n")))


if __name__ == "__main__":
    tool.main(__doc__)
