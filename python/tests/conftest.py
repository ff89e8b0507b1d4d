# SPDX-License-Identifier: GPL-3.0-or-later
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))


def pytest_addoption(parser):
    parser.addoption("--frames", type=int, default=25,
                     help="how many frames of Voronoi volumes are compared with SciPy's, in the plane and in space")
    parser.addoption("--steps", type=int, default=400,
                     help="how many steps LAMMPS makes, of which every tenth is compared with its Voronoi cells")
