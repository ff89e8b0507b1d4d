#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Input formats, and columns that are taken. usage: test_inputs.py --tool=PATH [CLASS[.METHOD]...]"""

import gzip
import json
import struct

import tool
from tool import SPREAD, STRATEGIES, ToolTest


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

    def test_surface_of_strips(self):
        """The faces of a tetrahedron in the order in which a strip has them are the same surface."""
        points = "".join(f"{x} {y} {z}\n" for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)))
        head = "ply\nformat ascii 1.0\nelement vertex 4\n" + "".join(f"property float {c}\n" for c in "xyz")
        lists = " {}\nproperty list uchar int vertex_indices\nend_header\n" + points
        meshes = set()
        for element, records in (("face 4", "3 0 2 1\n3 1 2 3\n3 1 3 0\n3 0 3 2\n"), ("tristrips 1", "6 0 2 1 3 0 2\n"),
                                 ("tristrips 1", "9 0 2 1 3 -1 1 3 0 2\n")):
            self.write("a.ply", head + "element" + lists.format(element) + records)
            self.succeed("nodt", "--surface", "a.ply", "--vertices", "30", "--iterations", "1", "--output", "out")
            meshes.add((self.here / "out" / "domain.mesh").read_bytes())
        self.assertEqual(len(meshes), 1)
        self.write("a.ply", head + "element" + lists.format("tristrips 1") + "5 0 2 1 3 0\n")
        self.assertIn("a.ply", self.refuse(3, "nodt", "--surface", "a.ply", "--vertices", "30"))

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
        for words in (["lloyd", "--input", "a.xyz", "--ignore-z"],
                      ["compare", "--strategies", "tolerances", "--", "lloyd", "--input", "a.xyz", "--ignore-z"]):
            self.assertRegex(self.refuse(3, *words),
                             r"\Aannulus: a.xyz:2: Lattice: a periodic box, and these are not supported here; expected "
                             r"--open")
        done = self.succeed("lloyd", "--input", "a.xyz", "--ignore-z", "--iterations", "0", "--output", "out", "--open")
        self.assertRegex(done.stderr, r"\Aannulus: a.xyz:2: Lattice ignored: [^\n]*open boundaries\n\Z")
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


if __name__ == "__main__":
    tool.main(__doc__)
