#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories as tracking programs write them. usage: test_tables.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import random
import struct
import subprocess

import tool

# Four people in two frames, by id.
WALK = [{1: (0, 0), 2: (1, 0), 3: (0, 1), 4: (1, 1.25)}, {1: (0.5, 0), 2: (1, 0.5), 3: (0, 1), 4: (1, 1.5)}]
ROWS = [(f, i, *p) for f, frame in enumerate(WALK) for i, p in frame.items()]
BY_ID = sorted(ROWS, key=lambda row: row[1])


def table(header, layout, rows=None):
    return header + "".join(layout.format(f=f, i=i, x=x, y=y) + "\n" for f, i, x, y in (ROWS if rows is None else rows))


def npy(shape, values, descr="<f8"):
    header = f"{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}"
    header += " " * (63 - (len(header) + 10) % 64) + "\n"
    kind = {"8": "d", "4": "f"}[descr[2]]
    return (b"\x93NUMPY\x01\0" + struct.pack("<H", len(header)) + header.encode()
            + struct.pack(f"{descr[0]}{len(values)}{kind}", *values))


class Tables(tool.ToolTest):
    def follow(self, name, content, *words, rows=None, notes=""):
        """Replays a file in these two frames, and returns its columns and the rows of voronoi.csv."""
        self.write(name, content)
        done = self.succeed("replay", name, *words, "--audit", "1", "--voronoi", "--changes", "--output", "out")
        self.assertRegex(done.stderr, rf"\A{notes}\Z")
        summary = self.summary("out")
        self.assertEqual((summary["dimension"], summary["iterations"], summary["audit"]["failed"]), (2, 1, 0))
        self.assertEqual(sorted(self.mesh("out")[0]), sorted(rows or WALK[-1].values()))
        listed = "columns        " + ", ".join(f"{what}: {words}" for what, words in summary["columns"].items())
        self.assertIn(listed + "\n", done.stdout)
        self.assertIn(f">{summary['columns']['x']}<", (self.here / "out" / "report.html").read_text(encoding="utf-8"))
        with open(self.here / "out" / "voronoi.csv", encoding="utf-8", newline="") as file:
            return summary["columns"], [(int(r["frame"]), r["id"]) for r in csv.DictReader(file)]

    def test_layouts(self):
        both = [(f, str(i)) for f, i, _, _ in ROWS]
        below = r"annulus: a.csv:2: \d lines? without numbers below the header passed over\n"
        for name, content, columns, notes in (
            ("petrack.txt", table("# PeTrack project: a.pet\n# framerate: 25 fps\n# id frame x/m y/m z/m\n",
                                  "{i}\t{f}\t{x}\t{y}\t1.75", BY_ID),
             {"frame": "column 2 (frame), rows sorted by it", "id": "column 1 (id)", "x": "column 3 (x/m)"}, ""),
            ("jupedsim.csv", table("#framerate: 8.00\n#ID\tFR\tX\tY\tZ\n", "{i}\t{f}\t{x}\t{y}\t0"),
             {"frame": "column 2 (FR)", "id": "column 1 (ID)"}, ""),
            ("a.csv", table("LABEL,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_T,FRAME,RADIUS\n"
                            + "Label,Spot ID,Track ID,Quality,X,Y,T,Frame,R\n" * 2
                            + ",,,(quality),(pixel),(pixel),(sec),,(pixel)\n",
                            "ID{f}{i},{f}{i},{i},5.5,{x},{y},0.{f},{f},2"),
             {"frame": "column 8 (FRAME)", "id": "column 3 (TRACK_ID)", "x": "column 5 (POSITION_X)"}, below),
            ("trackpy.csv", table("y,x,mass,size,frame,particle\n", "{y},{x},100,2,{f},{i}"),
             {"frame": "column 5 (frame)", "id": "column 6 (particle)", "x": "column 2 (x)"}, ""),
            ("napari.csv", table("track_id,t,y,x\n", "{i},{f},{y},{x}", BY_ID),
             {"frame": "column 2 (t), rows sorted by it", "id": "column 1 (track_id)"}, ""),
            ("a.csv", table('"t","id","name","x","y"\n"s","","","m","m"\n', '{f}.25,{i},"A {i}",{x},{y}'),
             {"frame": "column 1 (t), times numbered from 0", "id": "column 2 (id)"}, below),
            ("crowd.csv", table("time,pedID,posX,posY\n", "{f}.5,{i},{x},{y}"),
             {"frame": "column 1 (time), times numbered from 0", "id": "column 2 (pedID)", "x": "column 3 (posX)"}, ""),
            ("floats.csv", table("frame,id,x,y\n", "{f}.0,{i}.0,{x},{y}"), {"frame": "column 1 (frame)"}, ""),
            ("savetxt.txt", table("# frame id x y\n", "{f:.18e} {i:.18e} {x:.18e} {y:.18e}"), {}, ""),
            ("sorted.csv", table("frame,id,x,y\n", "{f},{i},{x},{y}", BY_ID), {}, ""),
            ("old.csv", table("frame,id,x,y\n", "{f},{i},{x},{y}").replace("\n", "\r").encode(), {}, ""),
            ("wide.csv", table("frame,id,x,y\n", "{f},{i},{x},{y}").encode("utf-16"), {}, ""),
            ("comma.csv", table("frame;id;x;y\n", "{f};{i};{x};{y}").replace(".", ",").encode(), {}, ""),
            ("fortran.tsv", table("frame\tid\tx\ty\n", "{f}\t{i}\t{x}D+00\t{y}D0"), {}, ""),
            ("end.csv", table("frame,id,x,y\n", "{f},{i},{x},{y},") + "# 2 frames\n", {}, ""),
        ):
            with self.subTest(name=name, columns=columns):
                taken, rows = self.follow(name, content, "--dim", "2", notes=notes)
                self.assertEqual({k: taken[k] for k in columns}, columns)
                self.assertEqual(rows, both)

    def test_any_order_of_rows(self):
        dice = random.Random(tool.SEED)
        frames = [[(f, i, dice.random(), dice.random()) for i in range(30) if dice.random() < 0.9] for f in range(12)]
        rows = [row for frame in frames for row in frame]
        meshes = set()
        for seed in range(3):
            self.write("a.csv", table("frame,id,x,y\n", "{f},{i},{x!r},{y!r}", rows))
            self.succeed("replay", "a.csv", "--audit", "1", "--voronoi", "--output", "out", "--quiet")
            meshes.add((self.here / "out" / "voronoi.csv").read_bytes())
            random.Random(seed).shuffle(rows)
        self.assertEqual(len(meshes), 1)
        text = table("frame,id,x,y\n", "{f},{i},{x},{y}", BY_ID)
        done = subprocess.run([tool.OPTIONS["tool"], "replay", "-", "--format", "csv"], cwd=self.here, input=text,
                              capture_output=True, text=True, timeout=tool.HANGING, check=False)
        self.assertEqual((done.returncode, done.stdout), (3, ""))
        self.assertEqual(done.stderr,
                         "annulus: standard input:4: frame 0 after frame 1; expected frames in order\n")

    def test_columns(self):
        content = table("who,when,east,north,x\n", "{i},{f},{x},{y},9")
        words = ["--columns", "id=who,frame=when,x=east,y=north"]
        taken, _ = self.follow("a.csv", content, *words)
        self.assertEqual(taken, {"frame": "column 2 (when)", "id": "column 1 (who)", "x": "column 3 (east)",
                                 "y": "column 4 (north)"})
        self.follow("mot.txt", table("", "{f},{i},{x},{y},9,9,1,-1,-1,-1"), "--columns", "frame=1,id=2,x=3,y=4")
        self.assertIn("a.csv:1: the header names no column 'who2', which --columns gives for id",
                      self.refuse(3, "replay", "a.csv", "--columns", "id=who2"))
        self.assertIn("a.csv:1: the header names no column frame", self.refuse(3, "replay", "a.csv"))
        for choice in ("who", "id=", "size=who", "id=who,id=who", "x=east"):
            self.refuse(2, "replay", "a.csv", "--columns", choice)
        self.xyz("a.xyz", tool.SPREAD)
        self.assertIn("--columns is for tables", self.refuse(2, "replay", "a.xyz", "--columns", "id=who"))
        for more in (["--frame", "1"], ["--every", "1"]):
            self.assertIn("x: column 3 (east)", self.succeed("degeneracy", "a.csv", *words, *more).stdout)
        self.write("points.csv", "lon,lat,x,y\n0,0,1,2\n1,0,3,4\n0,1,5,6\n")
        self.assertIn("x: column 1 (lon), y: column 2 (lat)",
                      self.succeed("degeneracy", "points.csv", "--columns", "x=lon,y=lat").stdout)
        self.succeed("compare", "--strategies", "auto,rebuild", "--", "replay", "a.csv", *words)

    def test_ids_are_written_as_they_are(self):
        content = table("frame,id,x,y\n", "{f},cell_{i},{x},{y}").replace("cell_3", '"a ""b"", c"')
        _, rows = self.follow("a.csv", content, "--every", "1")
        ids = ["cell_1", "cell_2", 'a "b", c', "cell_4"]
        self.assertEqual(rows, [(f, i) for f in (0, 1) for i in ids])
        self.assertEqual((self.here / "out" / "ids.csv").read_text(encoding="utf-8"),
                         'number,id\n0,cell_1\n1,cell_2\n2,"a ""b"", c"\n3,cell_4\n')
        self.assertEqual(tool.vtu_values(self.here / "out" / "frame-000000.vtu", "id"), (0, 1, 2, 3))
        _, rows = self.follow("a.csv", table("frame,id,x,y\n", "{f},-{i},{x},{y}"), "--every", "1")
        self.assertEqual(rows, [(f, str(-i)) for f in (0, 1) for i in (4, 3, 2, 1)])
        self.assertEqual(tool.vtu_values(self.here / "out" / "frame-000000.vtu", "id"), (-4, -3, -2, -1))
        self.assertFalse((self.here / "out" / "ids.csv").exists())  # that of the run before
        self.write("b.csv", "frame,id,x,y\n0,a,0,0\n0,b,1,0\n0,c,0,1\n0,d,1,1\n"
                            "1,a,0,0\n1,b,1,0\n1,c,0,1\n1,d,0.5,0.25\n")
        self.succeed("replay", "b.csv", "--changes", "--output", "changes", "--quiet")
        changes = (self.here / "changes" / "changes.csv").read_text(encoding="utf-8").splitlines()
        self.assertTrue({"1,a,d,made", "1,b,c,made"} & set(changes), changes)  # one of the diagonals was there
        self.assertIn(": in frame 0 the point of id b is where that of id a is",
                      self.refuse(3, "replay", self.write("c.csv", "frame,id,x,y\n0,a,0,0\n0,b,0,0\n")))

    def test_rows_without_coordinates(self):
        content = table("frame,id,x,y\n", "{f},{i},{x},{y}").replace("1,2,1,0.5", "1,2,nan,nan")
        _, rows = self.follow("a.csv", content, rows=[WALK[1][i] for i in (1, 3, 4)],
                              notes=r"annulus: a.csv:7: has no coordinates: [^\n]*\n")
        self.assertEqual(rows, [(0, "1"), (0, "2"), (0, "3"), (0, "4"), (1, "1"), (1, "3"), (1, "4")])

    def test_arrays(self):
        values = [c for frame in WALK for p in frame.values() for c in p]
        for descr in ("<f8", ">f8", "<f4", ">f4"):
            taken, rows = self.follow("a.npy", npy("(2, 4, 2)", values, descr))
            self.assertEqual(taken, {"id": "its place in the frame", "x": "[:, :, 0]", "y": "[:, :, 1]"})
            self.assertEqual(rows, [(f, str(i)) for f in (0, 1) for i in range(4)])
        self.write("b.npy", npy("(4, 2)", values[:8]))
        self.assertIn("4 points in dimension 2", self.succeed("degeneracy", "b.npy").stdout)
        for content, message in ((npy("(8, 2, 1)", values), "c.npy:1: has the shape"),
                                 (npy("(2, 4, 2)", values)[:-1], "c.npy:8: the file ends before point 3 of frame 1"),
                                 (npy("(2, 4, 2)", [float("inf")] * 16), "c.npy:1: x is infinite"),
                                 (b"PK\x03\x04", "c.npy: is a zip archive")):
            self.write("c.npy", content)
            self.assertIn(message, self.refuse(3, "replay", "c.npy"))
        self.refuse(2, "generate", "walk", "-n", 3, "--format", "npy")

    def test_lammps_motions_are_unwrapped(self):
        def dump(columns, *rows):
            return "".join(f"ITEM: TIMESTEP\n{t}\nITEM: NUMBER OF ATOMS\n4\n"
                           "ITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\n"
                           f"ITEM: ATOMS id {columns}\n{row}2 2 2 0 2 2 0\n3 8 2 0 8 2 0\n4 2 8 0 2 8 0\n"
                           for t, row in enumerate(rows))
        self.write("a.dump", dump("x y ix xu yu iy", "1 9.5 5 0 9.5 5 0\n", "1 0.5 5 1 10.5 5 0\n"))
        self.assertIn("box            BOX BOUNDS", self.succeed("replay", "a.dump").stdout)
        for name, content, x in (
            ("a.dump", None, "column 5 (xu)"),
            ("b.dump", dump("x y ix q r iy", "1 9.5 5 0 9 5 0\n", "1 0.5 5 1 9 5 0\n"),
             "column 2 (x) and column 4 (ix)"),
        ):
            if content:
                self.write(name, content)
            done = self.succeed("replay", name, "--open", "--output", "out")
            self.assertEqual(self.summary("out")["columns"]["x"], x)
            self.assertIn((10.5, 5), self.mesh("out")[0])
            self.assertNotIn("not used", done.stderr)

    def test_tables_that_are_refused_say_why(self):
        for content, message in (
            ("frame,id,x,y\n0,1,0,0\n0,,1,0\n", "a.csv:3: the id is missing"),
            ("frame,id,x,y\n0,1.5,0,0\n", "a.csv:2: the id is not an integer: '1.5'"),
            ("frame,id,x,y\n0,1,0,\n", "a.csv:2: y is missing"),
            ("frame,id,x,y\n0,1,inf,0\n", "a.csv:2: x is infinite"),
            ("frame,id,x,y\nfirst,1,0,0\n", "a.csv:2: the frame is not a number: 'first'"),
            ("frame;id;x;y\n0;1;1,5;0\n0;2;1.5;0\n", "a.csv:3: x is '1.5', and numbers above have a decimal comma"),
            ("0,1,0,0\n", "a.csv:1: has no header"),
            ("particle,t,q\n1,0,0\n", "a.csv:1: the header names no column x"),
            ("frame,id,x,y\n0,1,0,0\n0,2\n", "a.csv:3: has 2 columns; expected 4 as in the header"),
        ):
            self.write("a.csv", content)
            self.assertIn(message, self.refuse(3, "replay", "a.csv"))


if __name__ == "__main__":
    tool.main(__doc__)
