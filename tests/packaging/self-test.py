#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that packaging/check finds the faults of a recipe. usage: self-test.py CHECK"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(sys.argv.pop(1)).resolve()
ROOT = CHECK.parent.parent
FILES = ("CMakeLists.txt", "CITATION.cff", "LICENSE", "pyproject.toml", "cmake/annulus-tool.cmake",
         "python/CMakeLists.txt", "src/annulus/version.h", "tools/setup")
CONDA, SPACK = "packaging/conda-forge/recipe.yaml", "packaging/spack/packages/annulus/package.py"
VCPKG, NIX, DOCKER = "packaging/vcpkg/annulus/vcpkg.json", "packaging/nix/package.nix", "packaging/Dockerfile"
# A file, what is replaced in it, with what, and a part of the complaint.
PLANTED = [
    (CONDA, 'version: "0.1.0"', 'version: "0.1.1"', "conda-forge: version"),
    (CONDA, "cgal-cpp >=5.5", "cgal-cpp >=5.4", "conda-forge: cgal-cpp from 5.4, not 5.5"),
    (CONDA, "    - mpfr\n", "", "conda-forge: no mpfr"),
    (CONDA, "    - mpfr\n", "    - mpfr\n    - eigen\n", "conda-forge: eigen, which CMake does not look for"),
    (CONDA, "ANNULUS_UNITY", "ANNULUS_UNION", "CMake has no option ANNULUS_UNION"),
    (CONDA, "requirements:", "requirements: :", "conda-forge: "),
    (SPACK, 'license("GPL-3.0-or-later")', 'license("MIT")', "Spack: license"),
    (SPACK, '"cli11@2.1:"', '"cli11"', "Spack: cli11 from None, not 2.1"),
    (SPACK, "def cmake_args(self):", "def cmake_args(self:", "Spack: SyntaxError"),
    (VCPKG, '"license":', '"licence":', "vcpkg: "),
    (VCPKG, '    "gmp",\n', "", "vcpkg: no gmp"),
    (VCPKG, '"version-semver": "0.1.0"', '"version-semver": "0.2.0"', "vcpkg: version"),
    (NIX, "    onetbb\n", "", "package.nix does not use ['onetbb']"),
    (NIX, "gpl3Plus", "gpl2Plus", "Nix: license"),
    (DOCKER, "annulus:0.1.0 .", "annulus:0.0.9 .", "Dockerfile: version"),
    ("CITATION.cff", "annulus: Delaunay", "annulus: Voronoi", "CITATION.cff, version.h: description"),
    ("src/annulus/version.h", '"0.1.0"', '"0.1.2"', "CITATION.cff, version.h: version"),
    ("CMakeLists.txt", "find_package(TBB REQUIRED)", "find_package(TBB REQUIRED)\nfind_package(Eigen3 REQUIRED)",
     "other dependencies than CMake's: ['Eigen3']"),
    ("CMakeLists.txt", "find_package(CGAL 5.5", "find_package(CGAL 6.0", "Spack: cgal from 5.5, not 6.0"),
    ("pyproject.toml", "pybind11>=2.10", "pybind11>=2.9", "pyproject.toml: another version of pybind11"),
    ("pyproject.toml", 'description = "Del', 'description = "A Del', "pyproject.toml: another description"),
    ("tools/setup", '"libpng-dev"', "", "tools/setup: no libpng-dev"),
]


def checked(root):
    done = subprocess.run([CHECK, root], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class SelfTest(unittest.TestCase):
    def copied(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        root = Path(temporary.name)
        for name in FILES:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, root / name)
        shutil.copytree(ROOT / "packaging", root / "packaging")
        return root

    def test_right(self):
        self.assertEqual(checked(self.copied()), (0, "packaging: 0 faults\n"))

    def test_planted(self):
        for name, old, new, complaint in PLANTED:
            with self.subTest(file=name, new=new):
                root = self.copied()
                text = (root / name).read_text(encoding="utf-8")
                self.assertIn(old, text)
                (root / name).write_text(text.replace(old, new, 1), encoding="utf-8")
                status, said = checked(root)
                self.assertEqual(status, 1, said)
                self.assertIn(complaint, said)
                self.assertNotIn("Traceback", said)


if __name__ == "__main__":
    unittest.main()
