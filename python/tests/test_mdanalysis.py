# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus.mdanalysis`, with a stand-in for MDAnalysis. The package itself is in test_analyze_sources.py."""

import importlib
import sys
import types

import annulus
import numpy as np
import pytest

X = np.random.default_rng(0).random((40, 3)) + 0.02 * np.random.default_rng(1).standard_normal((5, 40, 3))


class AnalysisBase:
    """What annulus.mdanalysis uses of MDAnalysis'."""

    def __init__(self, trajectory, verbose=False):
        self._trajectory, self.verbose, self.results = trajectory, verbose, Results()

    def run(self, start=None, stop=None, step=None):
        self._prepare()
        for frame in range(*slice(start, stop, step).indices(len(self._trajectory))):
            self._ts = self._trajectory[frame]
            self._single_frame()
        self._conclude()
        return self


class Results(dict):
    __getattr__, __setattr__ = dict.__getitem__, dict.__setitem__


class Trajectory(list):
    def __getitem__(self, k):
        self.ts = types.SimpleNamespace(dimensions=[2, 2, 2, 90, 90, 90], time=2.0 * k, frame=k, positions=X[k])
        return self.ts


class Group:
    def __init__(self):
        self.universe, self.atoms = types.SimpleNamespace(trajectory=Trajectory(X)), self

    positions = property(lambda self: self.universe.trajectory.ts.positions)


@pytest.fixture
def stand_in(monkeypatch):
    base = types.ModuleType("MDAnalysis.analysis.base")
    base.AnalysisBase = AnalysisBase
    for name in ("MDAnalysis", "MDAnalysis.analysis"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    monkeypatch.setitem(sys.modules, base.__name__, base)
    monkeypatch.delitem(sys.modules, "annulus.mdanalysis", raising=False)
    yield importlib.import_module("annulus.mdanalysis")
    sys.modules.pop("annulus.mdanalysis", None)


def test_mdanalysis_stand_in(stand_in):
    run = stand_in.Voronoi(Group(), ("volumes", "events"), verbose=True)
    assert run.verbose
    for _ in range(2):  # which forgets the first time
        run.run(start=1, step=2)
        expected = annulus.analyze(X, ("volumes", "events"), box=[2, 2, 2], start=1, step=2)
        assert np.array_equal(run.results.volumes, expected.volumes)
        assert np.array_equal(run.results.events, expected.events)
        assert np.array_equal(run.results.boxes, expected.boxes)
        assert run.results.analysis.frames.tolist() == [1, 3] and run.results.analysis.times.tolist() == [2, 6]
    assert "neighbors" not in run.results
    assert "volumes" not in stand_in.Voronoi(Group()).run(start=9).results
    assert sorted(run.run(start=9).results) == ["analysis"], "nothing of an earlier run is left"
    opened = stand_in.Voronoi(Group(), "volumes", box="open").run()
    assert np.array_equal(opened.results.volumes, annulus.analyze(X).volumes)
    moves = stand_in.Voronoi(Group(), "moves").run().results.moves
    assert moves["asked"].tolist() == [0, 40, 40, 40, 40]
    with pytest.raises(annulus.Error, match="what must be"):
        stand_in.Voronoi(Group(), "areas")


def test_without_mdanalysis(monkeypatch):
    monkeypatch.setitem(sys.modules, "MDAnalysis.analysis.base", None)
    monkeypatch.setitem(sys.modules, "MDAnalysis", None)
    monkeypatch.delitem(sys.modules, "annulus.mdanalysis", raising=False)
    with pytest.raises(ImportError, match="needs MDAnalysis"):
        importlib.import_module("annulus.mdanalysis")
    assert "mdanalysis" not in annulus.__all__
