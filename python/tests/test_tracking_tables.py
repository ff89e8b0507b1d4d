# SPDX-License-Identifier: GPL-3.0-or-later
"""Tracking tables in `annulus.analyze`: the files of tests/data/tables and random ones, as the tool reads them
(ANNULUS_TOOL); ids, absent points, warnings, refusals."""

import csv
import json
import os
import pickle
import subprocess
import threading
import warnings
from pathlib import Path

import annulus
import numpy as np
import pytest
from support import SEED

TOOL = os.environ.get("ANNULUS_TOOL", "")
with_tool = pytest.mark.skipif(not TOOL, reason="the tool was not built")
FILES = Path(os.environ.get("ANNULUS_SOURCE") or Path(__file__).resolve().parents[2]) / "tests" / "data" / "tables"
TABLES = sorted(p.name for p in FILES.iterdir() if p.suffix in (".csv", ".txt"))
READ = [name for name in TABLES if not name.startswith("refused")]
CHOSEN = {"mot.txt": {"frame": 1, "id": 2, "x": 3, "y": 4}}
WALK = "".join(f"{f},{i},{x + 0.1 * f * (i == 1)},{y}\n" for f in range(2) for i, x, y in
               ((1, 0, 0), (2, 1, 0), (3, 0, 1), (4, 1, 1.2)))


def replay(directory, file, *words):
    return subprocess.run([TOOL, "replay", str(file), *words], cwd=directory, check=False, stdin=subprocess.DEVNULL,
                          capture_output=True)


def rows_of(path):
    with open(path, encoding="utf-8", errors="backslashreplace", newline="") as file:
        return list(csv.DictReader(file))


def analysed(path, **arguments):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        result = annulus.analyze(path, **arguments)
    assert all(w.category is annulus.TableWarning and w.filename == __file__ for w in told)
    return result, [str(w.message) for w in told]


def write(path, text, header="frame,id,x,y\n"):
    path.write_text(header + text, encoding="utf-8")
    return path


def cells(a):
    """By frame and id: volume and number of neighbours of the points that are there."""
    ids = a.ids.tolist()
    return {(int(r.frame), str(ids[i])): (r.volumes[i], r.neighbors[i]) for r in a for i in r.present.tolist()}


def require_same(a, directory):
    """The result is what the tool has written."""
    found, rows = cells(a), rows_of(directory / "voronoi.csv")
    size = "area" if a[0].ndim == 2 else "volume"
    assert set(found) == {(int(r["frame"]), r["id"]) for r in rows} and len(found) == len(rows)
    for r in rows:
        volume, neighbors = found[int(r["frame"]), r["id"]]
        assert neighbors == int(r["neighbours"])
        assert volume == pytest.approx(float(r[size] or "inf"), rel=1e-9)


@with_tool
@pytest.mark.parametrize("name", READ)
def test_files_are_read_as_the_tool_reads_them(name, tmp_path):
    columns = CHOSEN.get(name)
    words = [] if columns is None else ["--columns", ",".join(f"{k}={v}" for k, v in columns.items())]
    done = replay(tmp_path, FILES / name, "--voronoi", "--output", "out", *words)
    assert done.returncode == 0
    a, told = analysed(FILES / name, columns=columns)
    require_same(a, tmp_path / "out")
    assert [f"annulus: {text}" for text in told] == done.stderr.decode("utf-8", "backslashreplace").splitlines()
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    taken = {k: v for k, v in a.taken.items() if k != "dimension"}
    assert taken == summary["columns"] and a[0].ndim == summary["dimension"]
    assert len(a) == summary["iterations"] + 1
    if "dimension" in a.taken:
        assert f"dimension      {a.taken['dimension']}\n" in done.stdout.decode("utf-8", "replace")


@with_tool
@pytest.mark.parametrize("name", [name for name in TABLES if name.startswith("refused")])
def test_refused_files_are_refused_for_the_same_reason(name, tmp_path):
    done = replay(tmp_path, FILES / name)
    expected = done.stderr.decode("utf-8", "backslashreplace").strip().removeprefix("annulus: ")
    for tool, python in (("--columns", "columns"), ("--absent-frames skip", "absent_frames='skip'")):
        expected = expected.replace(tool, python)
    with pytest.raises(annulus.Error) as e:
        annulus.analyze(FILES / name)
    assert (str(e.value), e.value.code) == (expected, "bad_input")


@with_tool
@pytest.mark.parametrize("words", [False, True])
def test_points_appear_and_disappear(tmp_path, words):
    rng = np.random.default_rng(SEED)
    home, rows = rng.random((60, 2)), []
    for frame in range(3, 33, 3):
        for i in np.flatnonzero(rng.random(60) < 0.8).tolist():
            x, y = (home[i] + 0.02 * rng.standard_normal(2)).tolist()
            rows.append(f"{frame},{'cell ' if words else ''}{i - 5},{x!r},{y!r}\n")
    rng.shuffle(rows)
    write(tmp_path / "a.csv", "".join(rows))
    assert replay(tmp_path, "a.csv", "--voronoi", "--changes", "--output", "out").returncode == 0
    a, told = analysed(tmp_path / "a.csv")
    assert told == [] and a.frames.tolist() == list(range(3, 33, 3)) and np.isnan(a.times).all()
    require_same(a, tmp_path / "out")
    ids = a.ids.tolist()
    found = {(int(e["frame"]), str(ids[e["i"]]), str(ids[e["j"]]), bool(e["made"])) for e in a.events}
    expected = {(int(r["frame"]), *pair, r["change"] == "made") for r in rows_of(tmp_path / "out" / "changes.csv")
                for pair in [(r["first"], r["second"])]}
    turned = {(frame, *sorted(pair), made) for frame, *pair, made in found}
    assert turned == {(frame, *sorted(pair), made) for frame, *pair, made in expected} and len(found) == len(a.events)
    assert all((np.diff(r.present) > 0).all() for r in a) and (a.events["i"] < a.events["j"]).all()
    absent = np.isnan(a.volumes)
    assert np.array_equal(absent, a.neighbors == -1) and absent.any()
    assert np.array_equal(a.npoints, (~absent).sum(axis=1))


def test_rows_of_results(tmp_path):
    """A row is a point: ids in the order in which they appear, those of one frame ascending."""
    text = WALK.replace("1,2,1.0,0\n", "1,9,2,2\n").replace("1,4,1.0,1.2\n", "1,4,,\n")
    write(tmp_path / "a.csv", text)
    a, told = analysed(tmp_path / "a.csv", what=("volumes", "neighbors", "pairs", "events", "moves"))
    assert a.ids.tolist() == [1, 2, 3, 4, 9] and a.ids.dtype == np.int64
    assert a.npoints.tolist() == [4, 3] and a[1].present.tolist() == [0, 2, 4] and a.volumes.shape == (2, 5)
    assert a[0].ids.tolist() == [1, 2, 3, 4] and a[0].volumes.shape == (4,) and a[1].volumes.shape == (5,)
    assert a.neighbors[1].tolist() == [2, -1, 2, -1, 2] and a.neighbors[0, 4] == -1
    assert a[1].pairs[["i", "j"]].tolist() == [(0, 2), (0, 4), (2, 4)]
    assert a.moves["rebuilt"].tolist() == a.moves["asked"].tolist() == [0, 0], "another triangulation was built"
    assert len(told) == 1 and told[0].startswith(f"{tmp_path / 'a.csv'}:") and "has no coordinates" in told[0]
    assert a.taken == {"frame": "column 1 (frame)", "id": "column 2 (id)", "x": "column 3 (x)", "y": "column 4 (y)"}
    b = pickle.loads(pickle.dumps(a))
    assert np.array_equal(a.ids, b.ids) and a.taken == b.taken and np.array_equal(a.events, b.events)
    other = annulus.analyze(np.random.default_rng(0).random((2, 5, 2)))
    assert other.ids.tolist() == other[0].present.tolist() == [0, 1, 2, 3, 4] and other.taken == {}
    steady = annulus.analyze(write(tmp_path / "b.csv", WALK), "moves")
    assert steady.moves["asked"].tolist() == [0, 4], "one triangulation follows points that stay"
    other = annulus.analyze(write(tmp_path / "c.csv", WALK.replace("1,2,1.0,0\n", "1,9,2,2\n")), "moves")
    assert other.npoints.tolist() == [4, 4] and other.moves["asked"].tolist() == [0, 0], "as many, and not the same"


@pytest.mark.parametrize("ids, expected", [
    (["-3", "2", "7", "9"], [2, 7, 9, -3]), (["b", "a", "3", "ä"], ["b", "a", "3", "ä"]),
    (["1.0", "2.0", "3.0", "4.0"], [1, 2, 3, 4]), (["1", "2", "3", str(2**63)], [1, 2, 3, 2**63])])
def test_ids(tmp_path, ids, expected):
    write(tmp_path / "a.csv", "".join(f"{f},{i},{k % 2},{k // 2 + 0.1 * k * f}\n" for f in range(2)
                                      for k, i in enumerate(ids)))
    a = annulus.analyze(tmp_path / "a.csv", "volumes")
    assert a.ids.tolist() == expected and not a.ids.flags.writeable
    assert [r.ids.tolist() for r in annulus.analyze(tmp_path / "a.csv", "volumes", stream=True)] == [expected] * 2


def test_columns(tmp_path):
    path = write(tmp_path / "a.trk", WALK, "when,who,east,north\n")
    a = annulus.analyze(path, columns={"frame": "when", "id": "who", "x": 3, "y": "north"})
    assert a.ids.tolist() == [1, 2, 3, 4] and a.taken["x"] == "column 3 (east)"
    for columns, kind, words in (
            ({"who": "id"}, annulus.Error, "a key of columns must be one of frame, id, x, y or z"),
            ({"x": "east"}, annulus.Error, "x and y together"), ({"id": ""}, annulus.Error, "not ''"),
            ({"id": 0}, annulus.Error, "columns.'id'. must be 1 or more"), ({"id": 1.5}, TypeError, "whole number"),
            ("id=who", TypeError, "columns must be a dict"),
            ({"id": "none"}, annulus.Error, "names no column 'none', which columns gives for id")):
        with pytest.raises(kind, match=words):
            annulus.analyze(path, columns=columns)
    with pytest.raises(annulus.Error, match="columns and absent_frames are for tables") as e:
        annulus.analyze(np.zeros((1, 3, 2)), columns={"id": 1})
    assert e.value.code == "usage"
    np.save(tmp_path / "a.npy", np.zeros((1, 3, 2)))
    with pytest.raises(annulus.Error, match="absent_frames is for tables"):
        annulus.analyze(tmp_path / "a.npy", absent_frames="skip")


def test_frames(tmp_path):
    later = "".join(f"{5 + int(row[0])}{row[1:]}\n" for row in WALK.splitlines())
    path = write(tmp_path / "a.csv", WALK + later)
    with pytest.raises(annulus.Error, match="frame 5 after frame 1.*or absent_frames='empty' or 'skip'"):
        annulus.analyze(path)
    assert annulus.analyze(path, absent_frames="skip").frames.tolist() == [0, 1, 5, 6]
    a = annulus.analyze(path, absent_frames="empty")
    assert a.frames.tolist() == [0, 1, 2, 5, 6] and a.npoints.tolist() == [4, 4, 0, 4, 4]
    assert not a[2].events["made"].any() and a[3].events["made"].all() and len(a[2].events) == len(a[3].events) > 3
    assert annulus.analyze(path, absent_frames="skip", start=1, stop=4, step=2).frames.tolist() == [1, 6]
    with pytest.raises(annulus.Error, match="does not say how many frames"):
        annulus.analyze(path, start=-1)
    with pytest.raises(annulus.Error, match="absent_frames must be one of refuse, empty or skip"):
        annulus.analyze(path, absent_frames="no")
    times = "".join(f"{0.5 * int(row[0])}{row[1:]}\n" for row in WALK.splitlines())
    a = annulus.analyze(write(tmp_path / "b.csv", times, "t,id,x,y\n"))
    assert a.frames.tolist() == [0, 1] and a.times.tolist() == [0, 0.5] and "numbered from 0" in a.taken["frame"]


def test_faults_name_the_file_and_the_line(tmp_path):
    for text, words in ((WALK + "1,2,1.0,0\n", r":10: has the id 2 of line 7, in the same frame"),
                        (WALK.replace("1,2,1.0,0\n", "1,2,0.0,1\n"),
                         r":8: in frame 1 the point of id 3 is where that of id 2 is \(line 7\); expected points that "
                         r"differ$"),
                        (WALK.replace("1,4,1.0", "1,4,1e999"), r":9: x is "),
                        ("", r":1: has no frames")):
        path = write(tmp_path / "a.csv", text)
        with pytest.raises(annulus.Error, match=f"^{path}{words}"):
            annulus.analyze(path)
    stream = annulus.analyze(write(tmp_path / "a.csv", WALK + "2,1,a,b\n"), stream=True)
    assert next(stream).frame == 0 and next(stream).frame == 1
    with pytest.raises(annulus.Error, match=":10: x is not a number"):
        next(stream)
    with pytest.raises(annulus.Error, match="is not a file"):
        annulus.analyze(tmp_path / "none.csv")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(annulus.TableWarning, match="has no coordinates"):
            annulus.analyze(write(tmp_path / "a.csv", WALK.replace("1,4,1.0,1.2", "1,4,,")))


def test_space_and_boxes(tmp_path):
    rng = np.random.default_rng(SEED)
    x = rng.random((3, 20, 3))
    text = "".join(f"{f},{i},{','.join(map(repr, x[f, i].tolist()))}\n" for f in range(3) for i in range(20))
    path = write(tmp_path / "a.csv", text, "frame,id,x,y,z\n")
    what = ("volumes", "neighbors", "pairs", "events")
    for arguments in ({}, {"box": [1, 1, 1]}, {"clip": [[0] * 3, [1] * 3]}):
        a, b = annulus.analyze(path, what, **arguments), annulus.analyze(x, what, **arguments)
        for name in what:
            assert np.array_equal(getattr(a, name), getattr(b, name))
    flat = annulus.analyze(write(tmp_path / "b.csv", text.replace("\n", ",7\n"), "frame,id,x,y,_,z\n"))
    assert flat[0].ndim == 2 and flat.taken["dimension"] == "2: z is the same everywhere: 7" and "z" not in flat.taken
    assert np.array_equal(flat.volumes, annulus.analyze(x[:, :, :2]).volumes)


def test_tables_of_results(tmp_path):
    h5py, pandas = pytest.importorskip("h5py"), pytest.importorskip("pandas")
    path = write(tmp_path / "a.csv", WALK.replace("1,2,1.0,0\n", "1,new,2,2\n"))
    a = annulus.analyze(path, ("volumes", "pairs", "events"))
    table = a.to_pandas()
    assert isinstance(table, pandas.DataFrame)
    assert list(table["id"]) == ["1", "2", "3", "4", "1", "3", "4", "new"] and not table["volume"].isna().any()
    assert list(table["point"]) == [0, 1, 2, 3, 0, 2, 3, 4]
    events = a.to_pandas("events")
    assert {"2", "new"} <= set(events["id_i"]) | set(events["id_j"])
    annulus.analyze(path, "volumes", stream=True).to_hdf5(tmp_path / "a.h5")
    with h5py.File(str(tmp_path / "a.h5"), "r") as file:
        assert [i.decode() for i in file["ids"]] == ["1", "2", "3", "4", "new"]
        assert np.array_equal(file["volumes"][:], a.volumes, equal_nan=True)


def test_the_file_is_closed(tmp_path):
    if not Path("/proc/self/fd").is_dir():
        pytest.skip("no /proc")
    path = write(tmp_path / "a.csv", WALK)

    def is_open():
        return str(path) in {os.readlink(f"/proc/self/fd/{fd}") for fd in os.listdir("/proc/self/fd")
                             if os.path.exists(f"/proc/self/fd/{fd}")}

    a, b = annulus.analyze(path), annulus.analyze(path, stop=1)
    assert not is_open() and a.ids.tolist() == b.ids.tolist() == [1, 2, 3, 4]
    stream = annulus.analyze(path, stream=True)
    first = next(stream)
    assert is_open() and first.taken["id"] == "column 2 (id)"
    del stream
    assert not is_open() and first.ids.tolist() == [1, 2, 3, 4] and first.taken["id"] == "column 2 (id)"


def test_ids_while_frames_are_read(tmp_path):
    text = "".join(f"{f},cell {i},{i % 7 + 0.01 * f},{i // 7}\n" for f in range(40) for i in range(f + 3))
    path = write(tmp_path / "a.csv", text)
    frames, wrong, done = [], [], threading.Event()

    def look():
        while not done.is_set():
            for frame in frames[-1:]:
                if frame.ids.tolist() != [f"cell {i}" for i in range(frame.frame + 3)] or len(frame.taken) != 4:
                    wrong.append(frame.frame)

    threads = [threading.Thread(target=look) for _ in range(2)]
    for thread in threads:
        thread.start()
    try:
        for frame in annulus.analyze(path, "neighbors", stream=True):
            frames.append(frame)
    finally:
        done.set()
        for thread in threads:
            thread.join()
    assert len(frames) == 40 and not wrong
