# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of other packages that have positions, and those that carry a periodic box: it is ignored with a warning,
never silently."""

import warnings
from types import SimpleNamespace as Thing

import annulus
import numpy as np
import pytest

X = np.random.default_rng(0).random((20, 3))
CELL = np.diag([1.0, 2.0, 3.0])


class Atoms(list):
    """Like ASE's: a sequence of atoms with positions, a cell and flags."""

    def __init__(self, cell, pbc):
        super().__init__([object()] * len(X))
        self.positions, self.cell, self.pbc = X, cell, np.array(pbc)


class Raising:
    positions = X

    @property
    def dimensions(self):
        raise RuntimeError("there is none")


# Whether a warning is due, by a name for what it is like.
OBJECTS = {
    "ASE": (Thing(positions=X, cell=CELL, pbc=np.array([True, True, True])), True),
    "ASE, a slab": (Thing(positions=X, cell=CELL, pbc=np.array([False, False, True])), True),
    "ASE, a cluster in a cell": (Thing(positions=X, cell=CELL, pbc=np.array([False] * 3)), False),
    "MDAnalysis, a group": (Thing(positions=X, dimensions=np.array([1, 2, 3, 90, 90, 90], dtype=np.float32)), True),
    "MDAnalysis, a group without a box": (Thing(positions=X, dimensions=None), False),
    "MDAnalysis, zeros": (Thing(positions=X, dimensions=np.zeros(6, dtype=np.float32)), False),
    "MDAnalysis, a universe": (Thing(atoms=Thing(positions=X), dimensions=np.array([1, 2, 3, 90, 90, 90])), True),
    "OVITO": (Thing(particles=Thing(positions=X), cell=Thing(pbc=(True, False, False))), True),
    "OVITO, open": (Thing(particles=Thing(positions=X), cell=Thing(pbc=(False, False, False))), False),
    "GSD": (Thing(particles=Thing(position=X), configuration=Thing(box=[1, 1, 1, 0, 0, 0])), True),
    "pymatgen": (Thing(cart_coords=X, lattice=Thing(pbc=(True, True, True))), True),
    "a box by name": (Thing(positions=X, box=Thing(periodic=(True, True, True))), True),
    "lengths": (Thing(positions=X, box=[1, 1, 1]), True),
    "names of dimensions": (Thing(positions=X, dimensions=("time", "x")), False),
    "a property that raises": (Raising(), False),
    "no box": (Thing(positions=X), False),
}


@pytest.mark.parametrize("name", OBJECTS)
def test_positions_are_taken_and_the_box_is_not(name):
    thing, carries = OBJECTS[name]
    calls = {"MovingDelaunay": annulus.MovingDelaunay, "move": annulus.MovingDelaunay(X + 1).move,
             "degeneracy": annulus.degeneracy, "insert": annulus.MovingDelaunay(X + 5).insert,
             "find_simplex": annulus.MovingDelaunay(X).find_simplex}
    for call, function in calls.items():
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = function(thing)
        if call == "MovingDelaunay":
            assert np.array_equal(result.points, X)
        assert [w.category for w in caught] == [annulus.OpenBoundariesWarning] * carries, call
        for w in caught:
            assert "box" in str(w.message) and "boundaries are open" in str(w.message) and w.filename == __file__


def test_arrays_and_lists_warn_of_nothing():
    class Sub(np.ndarray):
        pass

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for x in (X, X.tolist(), X.view(Sub), X.astype(np.float32), tuple(map(tuple, X))):
            assert annulus.MovingDelaunay(x).npoints == 20


def test_a_sequence_that_is_no_array():
    """ASE's Atoms are a sequence, too; here even a list."""
    with pytest.raises(TypeError, match="points must be an array of numbers"):
        annulus.MovingDelaunay(Atoms(CELL, [True] * 3))


def test_ase():
    ase = pytest.importorskip("ase")
    atoms = ase.Atoms("Ar20", positions=X, cell=[1, 2, 3], pbc=True)
    with pytest.warns(annulus.OpenBoundariesWarning):
        assert np.array_equal(annulus.MovingDelaunay(atoms).points, X)
    atoms.pbc = False
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        annulus.MovingDelaunay(atoms)


def test_mdanalysis():
    mdanalysis = pytest.importorskip("MDAnalysis")
    universe = mdanalysis.Universe.empty(20, trajectory=True)
    universe.atoms.positions = X
    for box, carries in ((None, False), ([1, 2, 3, 90, 90, 90], True)):
        universe.dimensions = box
        for thing in (universe, universe.atoms, universe.trajectory.ts):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                assert annulus.MovingDelaunay(thing).npoints == 20
            assert len(caught) == carries
