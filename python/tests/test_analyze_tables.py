# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of `annulus.analyze` in pandas, HDF5 and Parquet: with these packages where they are installed; everywhere
with stand-ins of what is used of them."""

import sys
import types

import annulus
import annulus._tables
import numpy as np
import pytest

WHAT = ("volumes", "neighbors", "pairs", "events", "moves")
X = np.random.default_rng(0).random((40, 3)) + 0.02 * np.random.default_rng(1).standard_normal((5, 40, 3))
A = annulus.analyze(X, WHAT)
UNEVEN = [X[0][:30], X[1], X[2][:35]]


def rows_of(table, a=A):
    """The columns of a table, written out once more."""
    if table == "points":
        return {"frame": np.repeat(a.frames, 40), "time": np.full(40 * len(a), np.nan),
                "point": np.tile(np.arange(40), len(a)), "volume": a.volumes.ravel(), "neighbors": a.neighbors.ravel()}
    rows = getattr(a, table)
    columns = {name: rows[name] for name in rows.dtype.names if name != "shift"}
    if table == "pairs":
        columns.update({f"shift_{axis}": rows["shift"][:, k] for k, axis in enumerate("xyz")})
    return columns


def same(found, expected):
    return list(found) == list(expected) and all(
        np.array_equal(np.asarray(found[name]), expected[name], equal_nan=name in ("time", "volume"))
        for name in expected)


# ---- Stand-ins -----------------------------------------------------------------------------------------------------

class Dataset:
    def __init__(self, data, maxshape, fillvalue, chunks):
        self.data, self.maxshape, self.fill = np.array(data), maxshape, fillvalue
        assert all(1 <= size for size in chunks) and len(chunks) == len(data.shape)

    shape = property(lambda self: self.data.shape)

    def __len__(self):
        return len(self.data)

    def resize(self, shape):
        assert all(most is None or size <= most for size, most in zip(shape, self.maxshape))
        old = self.data
        self.data = np.zeros(shape, old.dtype) if self.fill is None else np.full(shape, self.fill, old.dtype)
        self.data[tuple(map(slice, old.shape))] = old

    def __setitem__(self, where, rows):
        self.data[where] = rows

    def __getitem__(self, where):
        return self.data[where]


class File(dict):
    kept = {}

    def __init__(self, name, mode="r"):
        self.attrs = {}
        if mode == "w":
            self.kept[name] = self
        else:
            self.update(self.kept[name])
            self.attrs = self.kept[name].attrs

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def create_dataset(self, name, data, **how):
        self[name] = Dataset(data, **how)


class Writer:
    written = {}

    def __init__(self, name, schema):
        self.written[name] = self
        self.schema, self.tables, self.closed = schema, [], False

    def write_table(self, table):
        assert not self.closed and table.schema == self.schema
        self.tables.append(table.columns)

    def close(self):
        self.closed = True


def table_of(columns):
    assert len({len(column) for column in columns.values()}) == 1
    return types.SimpleNamespace(columns=columns, schema=[(name, column.dtype) for name, column in columns.items()])


def module(name, **members):
    out = types.ModuleType(name)
    vars(out).update(members)
    return out


@pytest.fixture(params=["stand-in", "package"])
def h5py(request, monkeypatch):
    if request.param == "package":
        return pytest.importorskip("h5py")
    fake = module("h5py", File=File)
    monkeypatch.setitem(sys.modules, "h5py", fake)
    return fake


@pytest.fixture(params=["stand-in", "package"])
def pandas(request, monkeypatch):
    if request.param == "package":
        return pytest.importorskip("pandas")
    fake = module("pandas", DataFrame=dict)
    monkeypatch.setitem(sys.modules, "pandas", fake)
    return fake


@pytest.fixture
def written(monkeypatch):
    parquet = module("pyarrow.parquet", ParquetWriter=Writer)
    monkeypatch.setitem(sys.modules, "pyarrow", module("pyarrow", table=table_of, parquet=parquet))
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", parquet)
    monkeypatch.setattr(Writer, "written", {})
    return Writer.written


# ---- Tests ---------------------------------------------------------------------------------------------------------

def test_pandas(pandas):
    for table in ("points", "pairs", "events", "moves"):
        frame = A.to_pandas(table)
        assert isinstance(frame, pandas.DataFrame) and same(frame, rows_of(table))
    assert same(A.to_pandas(), rows_of("points"))
    assert same(annulus.analyze(X, ("events", "moves")).to_pandas(), rows_of("events"))
    assert list(annulus.analyze(X, "volumes").to_pandas()) == ["frame", "time", "point", "volume"]
    assert list(annulus.analyze(X[:, :, :2], "pairs").to_pandas())[-2:] == ["shift_x", "shift_y"]
    with pytest.raises(annulus.Error, match="table 'pairs' was not computed: what has events") as e:
        annulus.analyze(X, "events").to_pandas("pairs")
    assert e.value.code == "usage"


@pytest.mark.parametrize("stream", [False, True])
def test_hdf5(h5py, tmp_path, stream):
    file = tmp_path / "a.h5"
    annulus.analyze(X, WHAT, stream=stream).to_hdf5(file)
    annulus.analyze(X, WHAT, stream=stream).to_hdf5(file)  # which overwrites it
    with h5py.File(str(file), "r") as f:
        assert list(f.attrs["what"]) == list(WHAT) and f.attrs["annulus"] == annulus.__version__
        assert set(f) == {"frames", "times", "npoints", "boxes", *WHAT}
        for name in f:
            expected = getattr(A, name)
            found = f[name][:]
            assert found.shape == expected.shape and found.dtype == expected.dtype
            assert np.array_equal(found, expected, equal_nan=name in ("times", "boxes", "volumes"))


def test_hdf5_of_other_sizes(h5py, tmp_path):
    a = annulus.analyze(UNEVEN, ("volumes", "neighbors", "pairs"), box=[3, 3, 3])
    a.to_hdf5(tmp_path / "a.h5")
    with h5py.File(str(tmp_path / "a.h5"), "r") as f:
        for name in ("volumes", "neighbors", "pairs", "boxes", "npoints"):
            assert np.array_equal(f[name][:], getattr(a, name), equal_nan=name == "volumes")
    annulus.analyze(np.zeros((2, 0, 2)), WHAT).to_hdf5(tmp_path / "none.h5")
    with h5py.File(str(tmp_path / "none.h5"), "r") as f:
        assert f["volumes"].shape == (2, 0) and f["events"].shape == (0,)


def test_hdf5_until_an_error(h5py, tmp_path):
    x = X.copy()
    x[3, 5] = np.inf
    with pytest.raises(annulus.Error, match="frame 3"):
        annulus.analyze(x, stream=True).to_hdf5(tmp_path / "a.h5")
    with h5py.File(str(tmp_path / "a.h5"), "r") as f:
        assert f["frames"][:].tolist() == [0, 1, 2] and np.array_equal(f["volumes"][:], A.volumes[:3])


@pytest.mark.parametrize("stream", [False, True])
@pytest.mark.parametrize("rows", [1, 100, 1 << 17])
def test_parquet(written, tmp_path, monkeypatch, stream, rows):
    monkeypatch.setattr(annulus._tables, "_ROWS", rows)
    annulus.analyze(X, WHAT, stream=stream).to_parquet(tmp_path / "out")
    assert set(written) == {str(tmp_path / "out" / f"{t}.parquet") for t in ("points", "pairs", "events", "moves")}
    for name, writer in written.items():
        table = name.rpartition("/")[2].partition(".")[0]
        assert writer.closed and same(annulus._tables._joined(writer.tables), rows_of(table))
        if table == "points":
            assert len(writer.tables) == {1: 5, 100: 2}.get(rows, 1)


def test_parquet_until_an_error(written, tmp_path):
    x = X.copy()
    x[3, 5] = np.inf
    with pytest.raises(annulus.Error, match="frame 3"):
        annulus.analyze(x, "volumes", stream=True).to_parquet(tmp_path)
    writer, = written.values()
    assert writer.closed and writer.tables[0]["frame"].tolist() == np.repeat(np.arange(3), 40).tolist()


def test_parquet_itself(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    A.to_parquet(tmp_path)
    for table in ("points", "pairs", "events", "moves"):
        found = parquet.read_table(tmp_path / f"{table}.parquet")
        assert same({name: found[name].to_numpy() for name in found.column_names}, rows_of(table))


@pytest.mark.parametrize("call, package", [(lambda: A.to_pandas(), "pandas"), (lambda: A.to_hdf5("a.h5"), "h5py"),
                                           (lambda: A.to_parquet("a"), "pyarrow")])
def test_packages_that_are_missing(monkeypatch, tmp_path, call, package):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=f"needs the package {package}, which cannot be imported"):
        call()
    assert not list(tmp_path.iterdir())
