#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of tests/data/tables: each is read as it is meant, or refused for its own reason.
usage: test_table_files.py --tool=PATH [CLASS[.METHOD]...]"""

import csv
import shutil
from pathlib import Path

import tool

FILES = Path(__file__).resolve().parents[1] / "data" / "tables"
NUMBERS = ["1", "2", "3", "4"]
WALK = [(0.1, 0), (1, 0.1), (0, 1), (1, 1.1)]  # the points of frame 1
START = [(0, 0), (1, 0), (0, 1), (1, 1.2)]
THREE = {"last": [(0, 0), (1, 0), (0, 1)], "steps": 0, "ids": NUMBERS[:3]}
UNWRAPPED = {"last": [(10.1, 5, 5), (2, 2, 2), (8, 2, 2), (2, 8, 2), (2, 2, 8.5)], "ids": [*NUMBERS, "5"],
             "words": ["--open"], "notes": "BOX BOUNDS pp pp pp ignored"}


def column(number, name):
    return f"column {number} ({name})"


# By file: columns of frame, id, x and y, and what else is not as for four points 1 to 4 that walk from frame 0 to 1.
READ = {
    "crowdit.csv": ("column 2 (time), times numbered from 0", column(1, "pedID"), column(3, "posX"),
                    column(4, "posY"), {}),
    "excel.csv": (column(1, "frame"), column(2, "id"), "column 3 (x), decimal comma",
                  "column 4 (y), decimal comma", {}),
    "floatframe.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), {}),
    "gz_misnamed.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), {}),
    "imaris.csv": (column(6, "Time"), column(7, "TrackID"), column(1, "Position X"), column(2, "Position Y"),
                   {"ids": [f"100000000{i}" for i in NUMBERS], "first": 1}),
    "ind.csv": ("column 3 (frame), rows sorted by it", column(2, "trackId"), column(5, "xCenter"),
                column(6, "yCenter"), {}),
    "jupedsim.csv": (column(2, "FR"), column(1, "ID"), column(3, "X"), column(4, "Y"), {}),
    "jupedsim_legend.txt": (column(2, "FR"), column(1, "ID"), column(3, "X"), column(4, "Y"), {}),
    "macCR.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), THREE),
    "manual_tracking.csv": ("column 3 (Slice n\ufffd), rows sorted by it", column(2, "Track n\ufffd"),
                            column(4, "X"), column(5, "Y"), {"first": 1}),
    "matlab.txt": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), {}),
    "mosaic.csv": ("column 3 (Frame), rows sorted by it", column(2, "Trajectory"), column(4, "x"), column(5, "y"), {}),
    "mot.txt": ("column 1", "column 2", "column 3", "column 4",
                {"words": ["--columns", "frame=1,id=2,x=3,y=4"], "first": 1}),
    "nanrow.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"),
                   {"steps": 2, "last": [(1, 0), (0, 1)], "ids": ["2", "3"], "notes": ":10: has no coordinates"}),
    "napari.csv": ("column 2 (t), rows sorted by it", column(1, "track_id"), column(4, "x"), column(3, "y"), {}),
    "negid.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"),
                  {"steps": 2, "last": [(3, 3)], "ids": ["-1"]}),
    "ngsim.csv": ("column 2 (Frame_ID), rows sorted by it", column(1, "Vehicle_ID"), column(5, "Local_X"),
                  column(6, "Local_Y"), {}),
    "pathfinder.csv": ("column 1 (t), times numbered from 0", column(2, "id"), column(4, "x"), column(5, "y"),
                       {"notes": ":2: 1 line without numbers below the header"}),
    "petrack.txt": ("column 2 (frame), rows sorted by it", column(1, "id"), column(3, "x/m"), column(4, "y/m"), {}),
    "savetxt.txt": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), {}),
    "semi_decimalcomma.csv": (column(1, "frame"), column(2, "id"), "column 3 (x), decimal comma",
                              "column 4 (y), decimal comma", {}),
    "sortedbyid.csv": ("column 1 (frame), rows sorted by it", column(2, "id"), column(3, "x"), column(4, "y"), {}),
    "spots.csv": (column(2, "FRAME"), column(1, "ID"), column(3, "POSITION_X"), column(4, "POSITION_Y"),
                  {"ids": [f"11{i}" for i in NUMBERS],
                   "notes": r"no id is in two frames in a row: column 1 \(ID\) may not number tracks"}),
    "strid.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"),
                  {"ids": [f"cell_{i}" for i in NUMBERS]}),
    "sumo.csv": ("column 1 (timestep_time), times numbered from 0", column(2, "vehicle_id"), column(3, "vehicle_x"),
                 column(4, "vehicle_y"), {"ids": [], "last": [], "steps": 2, "notes": ":10: has no coordinates"}),
    "trackmate.csv": (column(9, "FRAME"), column(3, "TRACK_ID"), column(5, "POSITION_X"), column(6, "POSITION_Y"),
                      {"notes": ":2: 3 lines without numbers below the header"}),
    "trackpy.csv": (column(9, "frame"), column(10, "particle"), column(2, "x"), column(1, "y"), {}),
    "uneven_times.csv": ("column 1 (time), times numbered from 0", column(2, "id"), column(3, "x"), column(4, "y"),
                         {"steps": 3, "last": [(x + 0.5, y) for x, y in START],
                          "notes": ":14: the times of frames are 0.1 to 0.3 apart, and each is the next frame"}),
    "utf16.csv": (column(1, "frame"), column(2, "id"), column(3, "x"), column(4, "y"), THREE),
    "viswalk.txt": ("column 2 (SIMSEC), times numbered from 0", column(1, "$PEDESTRIAN:NO"), column(3, "COORDCENTX"),
                    column(4, "COORDCENTY"), {}),
    "dexp.xyz": (None, "its place in the frame", "column 2", "column 3",
                 {"steps": 0, "ids": ["0", "1", "2"], "last": [(0, 0, 0), (15, 0, 0), (0, 0.25, 1)]}),
    "both.lammpstrj": (None, column(1, "id"), column(6, "xu"), column(7, "yu"), UNWRAPPED),
    "image.lammpstrj": (None, column(1, "id"), "column 3 (x) and column 6 (ix)", "column 4 (y) and column 7 (iy)",
                        UNWRAPPED),
    "partial.lammpstrj": (None, column(1, "id"), column(4, "xs"), column(5, "ys"),
                          {"steps": 0, "last": [(1, 1, 1), (5, 1, 2), (1, 5, 3), (5, 5, 9)]}),
}
REFUSED = {
    "refused_clock.csv": ":2: the frame is not a number: '00:00:00.5'",
    "refused_no_track.csv": ":5: the id is missing; expected an id in every row that has coordinates",
    "refused_rounded_times.csv": ": the time of this frame is 0.6000000000000001 after 0.6, which differ by rounding",
    "refused_thousands.csv": ":2: x is not a number: '1,234,100'",
    "refused_wide.csv": ":1: the header names no column id; expected frame, id, x, y and perhaps z",
    "refused_words.csv": ":1: the header names no column frame",
    "voro_id_x_y_z.xyz": ":1: has 4 columns; expected a count of points",
    "xyzq.xyz": ":3: has 4 columns and begins with '0.5', which is no element",
}


class TableFiles(tool.ToolTest):
    def test_all_files_are_here(self):
        self.assertEqual({p.name for p in FILES.iterdir()}, {"README.md", *READ, *REFUSED})

    def points(self, directory):
        """The vertices of final.mesh."""
        words = (self.here / directory / "final.mesh").read_text(encoding="utf-8").split()
        begin, d = words.index("Vertices"), int(words[words.index("Dimension") + 1])
        return [tuple(map(float, words[begin + 2 + (d + 1) * k:][:d])) for k in range(int(words[begin + 1]))]

    def test_read(self):
        for name, (frame, point, x, y, other) in READ.items():
            with self.subTest(name=name):
                shutil.copy(FILES / name, self.here / name)
                words = other.get("words", [])
                done = self.succeed("replay", name, *words, "--audit", "1", "--voronoi", "--output", "out")
                summary = self.summary("out")
                taken = {k: v for k, v in summary["columns"].items() if k != "z"}
                frames = {} if frame is None else {"frame": frame}
                self.assertEqual(taken, {**frames, "id": point, "x": x, "y": y})
                self.assertIn(f"x: {x}, y: {y}", done.stdout)
                self.assertRegex(done.stderr, rf"\A(annulus: [^\n]*{other['notes']}[^\n]*\n)\Z" if "notes" in other
                                 else r"\A\Z")
                last = other.get("last", WALK)
                self.assertEqual(summary["iterations"], other.get("steps", 1))
                self.assertEqual(summary["dimension"], 3 if last and len(last[0]) == 3 else 2)
                if len(last) > 2:
                    for got, expected in zip(sorted(self.points("out")), sorted(last), strict=True):
                        for a, b in zip(got, expected, strict=True):
                            self.assertAlmostEqual(a, b, places=12)
                with open(self.here / "out" / "voronoi.csv", encoding="utf-8", newline="") as file:
                    rows = list(csv.DictReader(file))
                number = other.get("first", 0) + summary["iterations"]
                if frame is not None:
                    self.assertEqual([r["id"] for r in rows if int(r["frame"]) == number], other.get("ids", NUMBERS))
                shutil.rmtree(self.here / "out")

    def test_refused(self):
        for name, message in REFUSED.items():
            with self.subTest(name=name):
                shutil.copy(FILES / name, self.here / name)
                line = self.refuse(3, "replay", name)
                self.assertIn(f"annulus: {name}{message.split(':', 2)[0]}:", line)
                self.assertIn(message.lstrip(":"), line)

    def test_times_that_differ_by_rounding(self):
        """They are refused at the line where the second of them is, and are frames of their own on request."""
        name = "refused_rounded_times.csv"
        shutil.copy(FILES / name, self.here / name)
        rows = (self.here / name).read_text(encoding="ascii").splitlines()
        line = 1 + next(k for k, row in enumerate(rows) if row.startswith("0.6000000000000001,"))
        self.assertIn(f"{name}:{line}: the time of this frame", self.refuse(3, "replay", name))
        self.succeed("replay", name, "--absent-frames", "skip", "--output", "out")
        self.assertEqual(self.summary("out")["iterations"], len({row.split(",")[0] for row in rows[1:]}) - 1)

    def test_points_of_a_motion(self):
        """As a set of points a file with several frames is refused, whatever its column of frames is called."""
        for name, frames in (("jupedsim.csv", 2), ("napari.csv", 2), ("trackmate.csv", 9), ("petrack.txt", 2),
                             ("crowdit.csv", 2)):
            shutil.copy(FILES / name, self.here / name)
            line = self.refuse(3, "degeneracy", name)
            self.assertRegex(line, rf"a second frame( after frame 0)?, by column {frames}; expected one frame")
            self.assertRegex(self.succeed("degeneracy", name, "--every", "1").stdout, r"\n +0 +4 [^\n]+\n +1 +4 ")

    def test_names_are_shown_as_text(self):
        self.write("a.csv", b'frame,id,"x [\x1b[31m\xb5m]","y [\xc2\xb5m]"\n0,1,0,0\n0,2,1,0\n0,3,0,1\n')
        done = self.succeed("replay", "a.csv", "--output", "out")
        self.assertIn("x: column 3 (x [\ufffd[31m\ufffdm]), y: column 4 (y [\u00b5m])\n", done.stdout)
        self.assertEqual(self.summary("out")["columns"]["y"], "column 4 (y [\u00b5m])")


if __name__ == "__main__":
    tool.main(__doc__)
