#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Input formats, and faults in them. usage: test_inputs.py --tool=PATH [CLASS[.METHOD]...]"""

import bz2
import gzip
import json
import lzma
import math
import os
import struct
import subprocess

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
        for words in (["lloyd", "--input", "a.xyz", "--ignore-z"], ["degeneracy", "a.xyz", "--ignore-z"],
                      ["replay", "a.xyz"], ["degeneracy", "a.xyz", "--frame", "0"],
                      ["degeneracy", "a.xyz", "--every", "1"],
                      ["compare", "--strategies", "tolerances", "--", "lloyd", "--input", "a.xyz", "--ignore-z"],
                      ["compare", "--strategies", "tolerances", "--", "replay", "a.xyz"]):
            self.assertRegex(self.refuse(3, *words),
                             r"\Aannulus: a.xyz:2: Lattice: a periodic box, and these are not supported; expected "
                             r"--open")
        done = self.succeed("lloyd", "--input", "a.xyz", "--ignore-z", "--iterations", "0", "--output", "out", "--open")
        self.assertRegex(done.stderr, r"\Aannulus: a.xyz:2: Lattice ignored: [^\n]*not supported[^\n]*\n\Z")
        self.assertIn("columns        x: column 3 (pos), y: column 4 (pos)\n", done.stdout)
        self.assertEqual(sorted(self.mesh("out")[0]), sorted(SPREAD))
        self.assertEqual(self.summary("out")["columns"], {"x": "column 3 (pos)", "y": "column 4 (pos)"})
        self.assertEqual(self.summary("out")["ignored"], ["box"])
        done = self.succeed("degeneracy", "a.xyz", "--ignore-z", "--output", "counts", "--open")
        self.assertIn("5 points in dimension 2", done.stdout)
        self.assertIn("Lattice ignored", done.stderr)
        self.succeed("degeneracy", "a.xyz", "--every", "1", "--output", "series", "--open")
        for directory in ("counts", "series"):
            content = json.loads((self.here / directory / "degeneracy.json").read_text(encoding="utf-8"))
            self.assertEqual((content["ignored"], content["columns"]["y"]), (["box"], "column 4 (pos)"), directory)
            page = (self.here / directory / "degeneracy.html").read_text(encoding="utf-8")
            self.assertLess(page.index("Lattice ignored"), page.index("<svg" if "<svg" in page else "</main>"))
        self.succeed("compare", "--strategies", "tolerances", "--quiet", "--output", "both", "--", "lloyd", "--input",
                     "a.xyz", "--ignore-z", "--open")
        content = json.loads((self.here / "both" / "compare.json").read_text(encoding="utf-8"))
        self.assertEqual((content["ignored"], content["columns"]["x"]), (["box"], "column 3 (pos)"))
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


class Columns(ToolTest):
    """The columns that were taken; and columns that cannot be what their position suggests."""

    ATOMS = [(0.5, 0.25, 0.125), (1.5, 0.25, 0.125), (0.5, 1.25, 0.125), (0.5, 0.25, 1.125)]

    def rows(self, row):
        return "".join(row.format(*p, i=i + 1) + "\n" for i, p in enumerate(self.ATOMS))

    def test_rows_that_may_mean_otherwise(self):
        for content, line, words in (
            (self.rows("{i} {0} {1} {2}"), 1, "has 4 columns"),                     # voro++
            (self.rows("{i} {0} {1} {2} 0.5"), 1, "has 5 columns"),
            ("4\nno names\n" + self.rows("{0} {1} {2} -1.5"), 3, "begins with '0.5', which is no element"),
            ("4\nids\n" + self.rows("C {i} {0} {1} {2}"), 3, "where x is to be, holds integers"),
            ("4\nids, types\n" + self.rows("{i} 1 {0} {1} {2}"), 3, "where x is to be, holds integers"),
            ("4\n" + self.rows("{0} {1} {2}"), 2, "reads like a row of points in the place of the comment"),
        ):
            self.write("a.xyz", content)
            for command in (["degeneracy"], ["replay"], ["lloyd", "--ignore-z", "--input"]):
                self.assertRegex(self.refuse(3, *command, "a.xyz"), rf"\Aannulus: a.xyz:{line}: .*{words}.*; expected ")

    def test_where_it_is_said_what_columns_are(self):
        """The same four atoms in different layouts, and the tool's report of the columns that it took."""
        box = "ITEM: BOX BOUNDS ff ff ff\n0 2\n0 2\n0 2\n"
        dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n4\n" + box + "ITEM: ATOMS id "
        half = "".join(f"{i + 1} 9 9 {x / 2} {y / 2} {z / 2}\n" for i, (x, y, z) in enumerate(self.ATOMS))
        for name, content, x in (
            ("a.xyz", "4\n\n" + self.rows("C {0} {1} {2}"), "column 2"),
            ("a.xyz", "4\n\n" + self.rows("8 {0} {1} {2}"), "column 2"),
            ("a.xyz", "4\n\n" + self.rows("{0} {1} {2}"), "column 1"),
            ("a.xyz", "4\nProperties=pos:R:3:charge:R:1\n" + self.rows("{0} {1} {2} -1.5"), "column 1 (pos)"),
            ("a.csv", "frame,z,id,y,x\n" + self.rows("0,{2},{i},{1},{0}"), "column 5 (x)"),
            ("a.lammpstrj", dump + "x y xs ys zs\n" + half, "column 4 (xs)"),      # in full, and not a plane
            ("a.lammpstrj", dump + "xu yu zu\n" + self.rows("{i} {0} {1} {2}"), "column 2 (xu)"),
        ):
            with self.subTest(content=content):
                self.write(name, content)
                done = self.succeed("replay", name, "--output", "out")
                summary = self.summary("out")
                self.assertEqual((summary["dimension"], summary["columns"]["x"]), (3, x))
                self.assertNotIn("ignored", summary)
                self.assertIn("dimension      3\n", done.stdout)
                self.assertIn(f"x: {x}, y: ", done.stdout)
                self.assertIn(f">{x}<", (self.here / "out" / "report.html").read_text(encoding="utf-8"))
                text = (self.here / "out" / "final.mesh").read_text(encoding="utf-8").split()
                at = text.index("Vertices")
                self.assertEqual([tuple(map(float, text[at + 2 + 4 * i:at + 5 + 4 * i])) for i in range(4)], self.ATOMS)
        self.assertEqual(self.run_tool("degeneracy", "a.lammpstrj").stdout.splitlines()[1:3],
                         ["dimension      3", "columns        x: column 2 (xu), y: column 3 (yu), z: column 4 (zu)"])

    def test_more_columns_than_a_table_without_a_header_can_have(self):
        self.write("a.csv", "1,2,3,4\n5,6,7,8\n")
        self.assertIn("a.csv:1: has 4 columns and no header", self.refuse(3, "degeneracy", "a.csv"))


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
                              ("a.pgm", ["lloyd", "-n", "50", "--density"]),
                              ("c.xyz", ["lloyd", "-n", "50", "--domain"]), ("a.toml", ["sweep", "--output", "out"])):
            os.symlink("/dev/zero", self.here / name)
            self.assertIn(f"{name}: is a device", self.refuse(3, *command, name))
        os.symlink("/dev/zero", self.here / "points.xyz")
        self.write("b.toml", '[[grid]]\nfile = "points.xyz"\n')
        self.assertIn("b.toml:2: 'file' is", self.refuse(3, "sweep", "b.toml", "--output", "out"))

    def test_standard_input_without_end(self):
        with open("/dev/zero", "rb") as zero:
            done = subprocess.run([tool.OPTIONS["tool"], "sweep", "-", "--output", "out"], cwd=self.here, stdin=zero,
                                  capture_output=True, text=True, timeout=60, check=False)
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
