# SPDX-License-Identifier: GPL-3.0-or-later
"""packaging/bundle-wheel: a wheel of the package in the build, with the libraries that it needs inside, is used."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import annulus
import pytest

SOURCE = Path(os.environ.get("ANNULUS_SOURCE", Path(__file__).resolve().parents[2]))
NAME = "annulus-0-py3-none-linux.whl"
# Prints which libraries of these names the process has loaded, and from where.
USE = """
import annulus, numpy, re
mesh = annulus.MovingDelaunay(numpy.random.default_rng(1).random((100, 3)))
mesh.move(mesh.points + 1e-5)
assert mesh.audit()
print(annulus.__file__)
for path in sorted({line.split()[-1] for line in open("/proc/self/maps") if re.search("libgmp|libmpfr|libtbb", line)}):
    print(path)
"""


@pytest.fixture(scope="module")
def bundled(tmp_path_factory):
    tmp_path = tmp_path_factory.mktemp("wheel")
    if shutil.which("patchelf") is None:
        pytest.skip("patchelf is not installed")
    with zipfile.ZipFile(tmp_path / NAME, "w") as archive:
        for file in Path(annulus.__file__).parent.iterdir():
            if file.is_file():
                archive.write(file, f"annulus/{file.name}")
        archive.writestr("annulus-0.dist-info/RECORD", "")
    done = subprocess.run([SOURCE / "packaging/bundle-wheel", NAME, "bundled"], cwd=tmp_path, capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    with zipfile.ZipFile(tmp_path / "bundled" / NAME) as archive:
        archive.extractall(tmp_path / "used")
    return tmp_path / "used"


def test_libraries_inside_are_the_ones_loaded(bundled):
    environment = {**os.environ, "PYTHONPATH": str(bundled)}
    said = subprocess.run([sys.executable, "-B", "-c", USE], env=environment, cwd=bundled, check=True,
                          capture_output=True, text=True).stdout.splitlines()
    assert Path(said[0]).parent == bundled / "annulus"
    assert len(said) == 4
    assert {Path(path).parent for path in said[1:]} == {bundled / "annulus.libs"}


def test_record_names_every_file(bundled):
    record = (bundled / "annulus-0.dist-info/RECORD").read_text(encoding="utf-8").splitlines()
    files = {path.relative_to(bundled).as_posix() for path in bundled.rglob("*") if path.is_file()}
    assert {line.split(",")[0] for line in record} == files


def test_no_library_of_the_system_is_inside(bundled):
    names = [path.name for path in (bundled / "annulus.libs").iterdir()]
    assert names
    assert not [name for name in names if name.startswith(("libc-", "libm-", "libstdc++", "libgcc_s", "ld-"))]
