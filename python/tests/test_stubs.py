# SPDX-License-Identifier: GPL-3.0-or-later
"""What is written for readers and type checkers says what there is: stubs, docstrings, examples."""

import ast
import doctest
import inspect
import re
import shutil
import subprocess
import sys
from pathlib import Path

import annulus
import annulus._core
import annulus._moving_delaunay
import pytest

PACKAGE = Path(annulus.__file__).parent


def declared(nodes):
    return {n.name: n for n in nodes if isinstance(n, (ast.FunctionDef, ast.ClassDef))} | {
        n.target.id: n for n in nodes if isinstance(n, ast.AnnAssign)}


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_the_stub_is_the_module():
    tree = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
    stub = declared(tree.body)
    assert set(stub) - {"_Mesh"} == public(annulus._core)
    mesh = set(declared(stub["_Mesh"].body))
    for name in ("Mesh2", "Mesh3"):
        assert mesh == public(getattr(annulus._core, name))
    for name in ("MoveResult", "MoveStatistics"):
        assert set(declared(stub[name].body)) == public(getattr(annulus, name))


def test_everything_is_explained():
    things = [getattr(annulus, name) for name in annulus.__all__ if name != "__version__"]
    things += [getattr(annulus.MovingDelaunay, name) for name in dir(annulus.MovingDelaunay)
               if not name.startswith("_")]
    kinds = (annulus.MoveResult, annulus.MoveStatistics, annulus.Analysis, annulus.AnalysisStream)
    things += [getattr(kind, name) for kind in kinds for name in public(kind)]
    for thing in things:
        assert inspect.getdoc(thing), thing
    for name in ("move", "insert", "find_simplex", "remove", "voronoi_volumes", "voronoi", "neighbor_list",
                 "voronoi_vjp"):
        assert "----" in inspect.getdoc(getattr(annulus.MovingDelaunay, name)), f"{name}: no NumPy style"


HEADINGS = ("Parameters", "Returns", "Raises", "Notes", "Examples", "Attributes")


def test_docstrings_have_sections():
    """A heading of NumPy's style is a line of its own, and underlined by another as long."""
    for file in PACKAGE.glob("*.py"):
        lines = [line.strip() for line in file.read_text(encoding="utf-8").splitlines()]
        for k, line in enumerate(lines):
            assert (not line.startswith("---") or set(line) == {"-"} and line == "-" * len(lines[k - 1])
                    and lines[k - 1] in HEADINGS), (file, k + 1)
            assert line not in HEADINGS or lines[k + 1] == "-" * len(line), (file, k + 1)


def test_examples():
    assert doctest.testmod(annulus._moving_delaunay).failed == 0


STUBTEST = shutil.which("stubtest") or "/usr/bin/stubtest"


@pytest.mark.skipif(not Path(STUBTEST).exists(), reason="mypy's stubtest is not installed")
def test_stubtest():
    """Names, signatures and properties of the stub are those of the module, as mypy's own comparison sees them."""
    done = subprocess.run([STUBTEST, "--concise", "annulus._core"], cwd=PACKAGE.parent, capture_output=True, text=True,
                          check=False)
    # What pybind11 makes has a metaclass of pybind11's, and an `__init__(*args)` that only throws.
    known = ("metaclass differs", "__init__ is inconsistent")
    wrong = [line for line in done.stdout.splitlines() if not any(words in line for words in known)]
    assert not wrong and not done.stderr, (wrong, done.stderr)
    assert "Mesh2" in done.stdout, "it has looked"


# Lines that end with an error's code have this one error. mypy has to see what is wrong, too.
PROGRAM = """
import annulus
import numpy as np

dt = annulus.MovingDelaunay(np.zeros((0, 3), dtype=np.float32), "tolerances", threads=2)
result: annulus.MoveResult = dt.move(dt.points)
n: int = result.statistics.flips + dt.nvertices + annulus.lloyd(10, 1).report.asked
s = annulus.nodt("sphere", 100).simplices
new = dt.insert([[0.0, 0.0, 0.0]])
dt.remove(new)
whole: annulus.Analysis = annulus.analyze(np.zeros((2, 5, 2)), "volumes", box=[1, 1])
stream: annulus.AnalysisStream = annulus.analyze([np.zeros((5, 2))], ("pairs",), stream=True)
for frame in stream:
    n = frame.npoints + len(frame.pairs) + len(whole)

boxed = annulus.MovingDelaunay(dt.points, "signs", box=np.eye(3), merge_duplicates=True)
periodic: annulus.PeriodicDelaunay = boxed
result = boxed.move(boxed.points, [1, 1, 2])
result = boxed.move(boxed.points[:1], indices=[0])
i, j, shifts = boxed.neighbor_list("ijS")
vectors = boxed.box @ boxed.box.T
boxed.move(3, nonsense=4)  # call-arg
opened: annulus.MovingDelaunay = annulus.MovingDelaunay(dt.points, box=None)
opened.box  # attr-defined
periodic = opened  # assignment
annulus.MovingDelaunay(dt.points, 3)  # call-overload
annulus.MovingDelaunay(dt.points, box=[1, 1, 1], nonsense=2)  # call-overload

class Named(annulus.MovingDelaunay):
    def __init__(self, name: str) -> None:
        super().__init__(np.zeros((0, 2)), threads=2)
        self.name = name

class Plain(annulus.MovingDelaunay):
    pass

plain: Plain = Plain(dt.points)
name: str = Named("one").name
"""


@pytest.mark.skipif(shutil.which("mypy") is None and not Path("/usr/bin/mypy").exists(), reason="mypy is not installed")
def test_types(tmp_path):
    """mypy agrees with the package and with a program that uses it."""
    program = tmp_path / "program.py"
    program.write_text(PROGRAM, encoding="utf-8")
    mypy = ([sys.executable, "-m", "mypy"] if subprocess.run([sys.executable, "-m", "mypy", "--version"],
                                                             capture_output=True, check=False).returncode == 0
            else ["/usr/bin/mypy"])
    # NumPy's own stubs use words that Debian's mypy does not have.
    done = subprocess.run([*mypy, "--cache-dir", str(tmp_path / "cache"), "--follow-imports=silent", "--strict", "-p",
                           "annulus"], cwd=PACKAGE.parent, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    done = subprocess.run([*mypy, "--cache-dir", str(tmp_path / "cache"), "--follow-imports=silent", str(program)],
                          cwd=PACKAGE.parent, capture_output=True, text=True, check=False)
    found = re.findall(r":(\d+): error: .*\[([\w-]+)\]$", done.stdout, re.MULTILINE)
    expected = [(str(k), line.rpartition("# ")[2]) for k, line in enumerate(PROGRAM.split("\n"), 1) if "  # " in line]
    assert found == expected and len(expected) == 5, done.stdout + done.stderr
