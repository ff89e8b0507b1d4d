# SPDX-License-Identifier: GPL-3.0-or-later
"""The sources of `annulus.analyze`: arrays, iterables and pairs; ASE and MDAnalysis where they are installed, and
everywhere stand-ins with what is used of them; files."""

import importlib
import sys
import types

import annulus
import numpy as np
import pytest

X = np.random.default_rng(0).random((30, 3)) * 9 + 0.1 * np.random.default_rng(1).random((6, 30, 3))
EDGES = [10.0, 11.0, 12.0]
BOXED, OPEN = annulus.analyze(X, box=EDGES), annulus.analyze(X)


def same(a, b, tolerance=0.0):
    return (np.array_equal(a.frames, b.frames) and np.allclose(a.volumes, b.volumes, rtol=tolerance, atol=0)
            and (tolerance > 0 or np.array_equal(a.events, b.events)))


class Slow:
    """An array in a file: it is taken frame by frame."""

    shape = X.shape

    def __len__(self):
        return len(X)

    def __getitem__(self, k):
        assert isinstance(k, int)
        return X[k]


def test_arrays_and_iterables():
    for source in (X, X.tolist(), list(X), iter(X), Slow(), (y for y in X), [y.tolist() for y in X], X.astype(object)):
        if getattr(source, "dtype", None) == object:
            with pytest.raises(TypeError, match="frame 0: "):
                annulus.analyze(source)
        else:
            assert same(annulus.analyze(source), OPEN)
    assert same(annulus.analyze(X[0]), annulus.analyze(X[:1]))


def test_pairs():
    skewed = np.array([[10.0, 0, 0], [2, 11, 0], [1, -3, 13]])
    assert same(annulus.analyze(((EDGES, y) for y in X)), BOXED)
    assert same(annulus.analyze([(None, y) for y in X]), OPEN)
    assert same(annulus.analyze((EDGES, X[0])), annulus.analyze(X[:1], box=EDGES))
    one = annulus.analyze((skewed, X[0]), "volumes")
    assert one.boxes.shape == (1, 3, 3) and np.allclose(one.volumes.sum(), 1430)
    assert annulus.analyze((X[0][:3], X[1][:3]), "volumes").frames.tolist() == [0, 1], "two frames of three points"
    a = annulus.analyze([(EDGES, X[0]), (skewed, X[1]), (None, X[2])], "volumes")
    assert np.array_equal(a.boxes[1], skewed) and np.isnan(a.boxes[2]).all()
    assert np.allclose(a.volumes[:2].sum(axis=1), [1320, 1430]) and np.array_equal(a.volumes[2], OPEN.volumes[2])
    assert same(annulus.analyze([(EDGES, y) for y in X], box="open"), OPEN)
    triangle = annulus.analyze([((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), ((0.0, 0.0), (1.0, 0.5))], "volumes")
    assert triangle.npoints.tolist() == [3, 2], "a tuple of two points is no pair"


@pytest.mark.parametrize("make", [lambda: X, lambda: iter(X)])
def test_some_frames(make):
    assert annulus.analyze(make(), start=1, stop=5, step=2).frames.tolist() == [1, 3]
    assert annulus.analyze(make(), stop=99, step=4).frames.tolist() == [0, 4]
    assert same(annulus.analyze(make(), start=2, stop=3), annulus.analyze(list(X), start=2, stop=3))
    if make() is X:
        assert annulus.analyze(make(), start=-2).frames.tolist() == [4, 5]
    else:
        with pytest.raises(annulus.Error, match="no frame"):
            annulus.analyze(make(), start=2**62)
        with pytest.raises(annulus.Error, match="does not say how many frames"):
            annulus.analyze(make(), start=-2)


@pytest.mark.parametrize("source, kind, words", [
    (7, TypeError, "not 7"), (None, TypeError, "not None"), (b"name", TypeError, "bytes"), ({}, TypeError, "dict"),
    (np.zeros(3), annulus.Error, "source must have shape"), (np.zeros((1, 1, 2, 3)), annulus.Error, "source must have"),
    ([[0.0, 1.0], [2.0, 3.0]], annulus.Error, "an iterable has a frame for each element"),
    ([], annulus.Error, "no frame"), (np.zeros((2, 5, 4)), annulus.Error, "frame 0: points must have shape")])
def test_what_is_no_source(source, kind, words):
    with pytest.raises(kind, match=words):
        annulus.analyze(source)


def test_readers_that_fail():
    def source():
        yield X[0]
        raise OSError("the disk is gone")

    with pytest.raises(annulus.Error, match="frame 1 cannot be read: OSError: the disk is gone") as e:
        annulus.analyze(source())
    assert e.value.code == "bad_input"
    with pytest.raises(TypeError, match="frame 1: "):
        annulus.analyze(iter([X[0], None, X[2]]))


# ---- Stand-ins -----------------------------------------------------------------------------------------------------

def atoms(positions, pbc=(True,) * 3):
    return types.SimpleNamespace(positions=positions, cell=np.diag(EDGES), pbc=np.array(pbc))


class Trajectory:
    """Of MDAnalysis: one Timestep, which has the positions of one frame at a time."""

    def __init__(self, dimensions):
        self.ts = types.SimpleNamespace(dimensions=dimensions, triclinic_dimensions=np.array(
            [[10, 0, 0], [2, 11, 0], [1, -3, 12.0]]))
        self[0]

    def __len__(self):
        return len(X)

    def __getitem__(self, k):
        self.ts.positions, self.ts.time, self.ts.frame = X[k], 0.5 * k, k
        return self.ts


class Group:
    def __init__(self, universe, rows):
        self.universe, self.rows, self.atoms = universe, rows, self

    @property
    def positions(self):
        return self.universe.trajectory.ts.positions[self.rows]


def universe(dimensions):
    out = types.SimpleNamespace(trajectory=Trajectory(dimensions))
    out.universe, out.atoms = out, Group(out, slice(None))
    return out


def test_atoms():
    assert same(annulus.analyze([atoms(y) for y in X]), BOXED)
    assert same(annulus.analyze(atoms(X[0])), annulus.analyze(X[0], box=EDGES))
    assert same(annulus.analyze(atoms(y, [False] * 3) for y in X), OPEN)
    slab = [atoms(y, [True, True, False]) for y in X]
    with pytest.raises(annulus.NotAvailableError, match="frame 0: pbc is .*box='open'"):
        annulus.analyze(slab)
    assert same(annulus.analyze(slab, box="open"), OPEN) and same(annulus.analyze(slab, box=EDGES), BOXED)


def test_universe():
    lengths = np.array([*EDGES, 90, 90, 90], dtype=np.float32)
    for source in (universe(lengths), universe(lengths).atoms, universe(lengths).trajectory):
        a = annulus.analyze(source)
        assert same(a, BOXED) and np.array_equal(a.times, 0.5 * np.arange(6))
    for none in (None, np.zeros(6), np.array([0, 0, 0, 90, 90, 90])):
        assert same(annulus.analyze(universe(none)), OPEN)
    assert same(annulus.analyze(universe(lengths), box="open"), OPEN)
    skewed = universe(np.array([*EDGES, 80, 90, 90]))
    assert np.array_equal(annulus.analyze(skewed).boxes[3], skewed.trajectory.ts.triclinic_dimensions)
    some = annulus.analyze(Group(universe(lengths), slice(20)), start=2)
    assert some.frames.tolist() == [2, 3, 4, 5] and same(some, annulus.analyze(X[:, :20], box=EDGES, start=2))


# ---- Files ---------------------------------------------------------------------------------------------------------

def test_numpy_file(tmp_path):
    np.save(tmp_path / "x.npy", X)
    assert same(annulus.analyze(tmp_path / "x.npy"), OPEN) and same(annulus.analyze(str(tmp_path / "x.npy")), OPEN)
    np.save(tmp_path / "pickled.npy", np.array([{}], dtype=object))
    (tmp_path / "short.npy").write_bytes((tmp_path / "x.npy").read_bytes()[:500])
    for name in ("pickled.npy", "short.npy"):
        with pytest.raises(annulus.Error, match=f"{name} cannot be read"):
            annulus.analyze(tmp_path / name)


def test_other_files(tmp_path, monkeypatch):
    with pytest.raises(annulus.Error, match="none.xyz is not a file"):
        annulus.analyze(tmp_path / "none.xyz")
    for name, module, package in (("a.xyz", "ase.io", "ASE"), ("a.xtc", "MDAnalysis.coordinates.core", "MDAnalysis")):
        (tmp_path / name).write_bytes(b"")
        monkeypatch.setitem(sys.modules, module.partition(".")[0], None)
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(ImportError, match=f"{package} is needed to read .*{name}"):
            annulus.analyze(tmp_path / name)
        reader = types.ModuleType(module)
        asked = []
        reader.iread = lambda name, index, format: asked.append(format) or (atoms(y) for y in X)
        reader.reader = lambda name: Trajectory(np.array([*EDGES, 90, 90, 90]))
        monkeypatch.setitem(sys.modules, module.partition(".")[0], types.ModuleType("parent"))
        monkeypatch.setitem(sys.modules, module, reader)
        assert same(annulus.analyze(tmp_path / name), BOXED)
        if package == "ASE":
            (tmp_path / "a.dump").write_bytes(b"")
            assert same(annulus.analyze(tmp_path / "a.dump"), BOXED) and asked == [None, "lammps-dump-text"]


# ---- The packages themselves ---------------------------------------------------------------------------------------

def test_ase(tmp_path):
    ase, io = pytest.importorskip("ase"), pytest.importorskip("ase.io")
    frames = [ase.Atoms("Ar30", positions=y, cell=EDGES, pbc=True) for y in X]
    assert same(annulus.analyze(frames), BOXED)
    io.write(tmp_path / "a.traj", frames)
    io.write(tmp_path / "a.extxyz", frames)
    assert same(annulus.analyze(tmp_path / "a.traj"), BOXED)
    assert same(annulus.analyze(io.Trajectory(tmp_path / "a.traj")), BOXED)
    assert same(annulus.analyze(io.iread(tmp_path / "a.traj", index=":")), BOXED)
    assert same(annulus.analyze(tmp_path / "a.extxyz"), BOXED, 1e-5)  # it is written with eight digits
    with open(tmp_path / "a.dump", "w", encoding="ascii") as out:
        for k, y in enumerate(X):
            print("ITEM: TIMESTEP", k, "ITEM: NUMBER OF ATOMS", 30, "ITEM: BOX BOUNDS pp pp pp", sep="\n", file=out)
            print(*(f"0 {e}" for e in EDGES), "ITEM: ATOMS id type x y z", sep="\n", file=out)
            print(*(f"{i + 1} 1 {y[i][0]!r} {y[i][1]!r} {y[i][2]!r}" for i in range(29, -1, -1)), sep="\n", file=out)
    assert same(annulus.analyze(tmp_path / "a.dump"), BOXED), "sorted by id"


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_mdanalysis(tmp_path):
    mda = pytest.importorskip("MDAnalysis")
    system = mda.Universe.empty(30, trajectory=True)
    with mda.Writer(str(tmp_path / "a.dcd"), 30) as out:
        for y in X:
            system.atoms.positions, system.dimensions = y, [*EDGES, 90, 90, 90]
            out.write(system.atoms)
    system = mda.Universe.empty(30)
    system.load_new(str(tmp_path / "a.dcd"))
    for source in (system, system.atoms, system.trajectory, tmp_path / "a.dcd"):
        a = annulus.analyze(source)
        assert same(a, BOXED, 1e-5) and np.allclose(a.boxes, np.diag(EDGES))
    assert np.array_equal(annulus.analyze(system.atoms[:20], step=2).volumes,
                          annulus.analyze(X[::2, :20].astype(np.float32), box=EDGES).volumes)
    system.dimensions = [*EDGES, 80, 85, 95]
    a = annulus.analyze(system.trajectory.ts)
    assert np.isclose(a.volumes.sum(), np.linalg.det(system.trajectory.ts.triclinic_dimensions), rtol=1e-6)
    assert importlib.import_module("annulus.mdanalysis").Voronoi(system).run().results.volumes.shape == (6, 30)
