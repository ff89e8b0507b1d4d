# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories in files: NumPy's are mapped, tables read here, all others by ASE or MDAnalysis."""

from __future__ import annotations

import importlib
import os
import typing

import numpy as np

from . import _arguments
from ._error import Error
from ._tracking_tables import TableOptions, frames_of_table

# What MDAnalysis reads without a topology. These formats are binary and store no names of atoms.
_MDANALYSIS = (".dcd", ".h5md", ".nc", ".ncdf", ".trr", ".xtc")
_TABLES = (".csv", ".tsv", ".txt", ".dat")
# What ASE calls a format whose files are not recognised by their ends.
_ASE = {".dump": "lammps-dump-text", ".lammpstrj": "lammps-dump-text", ".lammpsdump": "lammps-dump-text"}


def opened(path: str | os.PathLike[str], table: TableOptions) -> typing.Any:
    """The frames of a file, read when they are taken.

    ``.npy`` is an array, mapped into memory; ``.xtc``, ``.trr``, ``.dcd``, ``.nc`` and ``.h5md`` a reader of
    MDAnalysis; a table, which is one by its end or because columns are given, a generator of `TableFrame`; anything
    else one of ASE's Atoms.
    """
    name = os.fsdecode(_arguments.file_of("source", path))
    end = os.path.splitext(name[:-3] if name.lower().endswith(".gz") else name)[1].lower()
    if not os.path.isfile(name):
        raise Error(f"source: {name} is not a file", "bad_input")
    if end in _TABLES or any(table.columns):
        return frames_of_table(name, table)
    if table.given:
        raise Error(f"absent_frames is for tables ({', '.join(_TABLES)}, or any file with columns)", "usage")
    if end == ".npy":
        return _mapped(name)
    return _by_mdanalysis(name) if end in _MDANALYSIS else _by_ase(name, end)


def _mapped(name: str) -> typing.Any:
    try:
        return np.load(name, mmap_mode="r", allow_pickle=False)
    except (OSError, ValueError) as e:
        raise Error(f"source: {name} cannot be read: {e}", "bad_input") from e


def _imported(module: str, package: str, name: str) -> typing.Any:
    try:
        return importlib.import_module(module)
    except ImportError as e:
        raise ImportError(f"{package} is needed to read {name}, and cannot be imported") from e


def _by_mdanalysis(name: str) -> typing.Any:
    core = _imported("MDAnalysis.coordinates.core", "MDAnalysis", name)
    try:
        return core.reader(name)
    except Exception as e:
        raise Error(f"source: {name} cannot be read by MDAnalysis: {e}", "bad_input") from e


def _by_ase(name: str, end: str) -> typing.Any:
    io = _imported("ase.io", "ASE", name)
    try:
        return io.iread(name, index=":", format=_ASE.get(end))
    except Exception as e:
        raise Error(f"source: {name} cannot be read by ASE: {e}", "bad_input") from e
