# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of frames as tables: for pandas, HDF5 and Parquet, each an optional import."""

from __future__ import annotations

import contextlib
import importlib
import os
import typing
from collections.abc import Iterable

import numpy as np

from . import _arguments, _core
from ._error import Error
from ._frame_result import FrameResult

Columns = dict[str, np.ndarray[typing.Any, typing.Any]]
_ROWS = 1 << 17  # of a table, before they are written


def tables_of(what: tuple[str, ...]) -> tuple[str, ...]:
    points = ("points",) if {"volumes", "neighbors"} & set(what) else ()
    return (*points, *(name for name in ("pairs", "events", "moves") if name in what))


def columns_of(result: FrameResult, table: str) -> Columns:
    """The rows of a frame in a table, column by column."""
    if table == "points":
        n, there = result.npoints, result.present
        columns: Columns = {"frame": np.full(n, result.frame), "time": np.full(n, result.time), "point": there}
        if result.taken:
            columns["id"] = result.ids[there]
        if "volumes" in result.what:
            columns["volume"] = result.volumes[there]
        if "neighbors" in result.what:
            columns["neighbors"] = result.neighbors[there]
        return columns
    rows = getattr(result, table)
    columns = {name: rows[name] for name in rows.dtype.names if name != "shift"}
    if result.taken and table != "moves":
        columns["id_i"], columns["id_j"] = result.ids[rows["i"]], result.ids[rows["j"]]
    if "shift" in rows.dtype.names:
        columns.update((f"shift_{axis}", rows["shift"][:, k]) for k, axis in enumerate("xyz"[:result.ndim]))
    return columns


def _joined(parts: list[Columns]) -> Columns:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _imported(module: str, method: str) -> typing.Any:
    try:
        return importlib.import_module(module)
    except ImportError as e:
        package = module.partition(".")[0]
        raise ImportError(f"{method} needs the package {package}, which cannot be imported") from e


def to_pandas(results: Iterable[FrameResult], what: tuple[str, ...], table: str | None) -> typing.Any:
    tables = tables_of(what)
    chosen = tables[0] if table is None else _arguments.choice("table", table, ("points", "pairs", "events", "moves"))
    if chosen not in tables:
        raise Error(f"table {chosen!r} was not computed: what has {', '.join(what)}", "usage")
    pandas = _imported("pandas", "to_pandas")
    return pandas.DataFrame(_joined([columns_of(result, chosen) for result in results]))


def to_parquet(results: Iterable[FrameResult], what: tuple[str, ...], path: str | os.PathLike[str]) -> None:
    pyarrow, parquet = _imported("pyarrow", "to_parquet"), _imported("pyarrow.parquet", "to_parquet")
    folder = os.fsdecode(_arguments.file_of("path", path))
    os.makedirs(folder, exist_ok=True)
    with contextlib.ExitStack() as stack:
        tables = [stack.enter_context(_ParquetTable(pyarrow, parquet, folder, name)) for name in tables_of(what)]
        for result in results:
            for table in tables:
                table.add(result)


class _ParquetTable:
    """A table that is written to a file by and by."""

    def __init__(self, pyarrow: typing.Any, parquet: typing.Any, folder: str, name: str) -> None:
        self._pyarrow, self._parquet, self._name = pyarrow, parquet, name
        self._file = os.path.join(folder, f"{name}.parquet")
        self._writer: typing.Any = None
        self._parts: list[Columns] = []
        self._rows = 0

    def __enter__(self) -> _ParquetTable:
        return self

    def add(self, result: FrameResult) -> None:
        self._parts.append(columns_of(result, self._name))
        self._rows += len(self._parts[-1]["frame"])
        if self._rows >= _ROWS:
            self._write()

    def _write(self) -> None:
        table = self._pyarrow.table(_joined(self._parts))
        if self._writer is None:
            self._writer = self._parquet.ParquetWriter(self._file, table.schema)
        self._writer.write_table(table)
        self._parts, self._rows = [], 0

    def __exit__(self, *of_exception: object) -> None:
        try:
            if self._parts:
                self._write()
        finally:
            if self._writer is not None:
                self._writer.close()


def to_hdf5(results: Iterable[FrameResult], what: tuple[str, ...], path: str | os.PathLike[str]) -> None:
    h5py = _imported("h5py", "to_hdf5")
    with h5py.File(os.fsdecode(_arguments.file_of("path", path)), "w") as file:
        file.attrs["annulus"], file.attrs["what"] = _core.version, list(what)
        ids = 0
        for result in results:
            d = result.ndim
            box = np.full((d, d), np.nan) if result.box is None else result.box
            _append(file, "frames", np.array([result.frame], dtype=np.int64))
            _append(file, "times", np.array([result.time]))
            _append(file, "npoints", np.array([result.npoints], dtype=np.int64))
            _append(file, "boxes", box[None])
            for name in what:
                rows = getattr(result, name)
                _append(file, name, rows[None] if name in ("volumes", "neighbors") else rows)
            if result.taken:
                new = result.ids[ids:]
                _append(file, "ids", new.astype(h5py.string_dtype()) if new.dtype.kind == "U" else new)
                ids += len(new)


def _append(file: typing.Any, name: str, rows: np.ndarray[typing.Any, typing.Any]) -> None:
    """Adds rows to a dataset, which is made, or becomes wider, as they need it; it is filled with NaN or -1."""
    if name not in file:
        fill = {"volumes": np.nan, "neighbors": -1}.get(name)
        wide = (None, *(None if fill is not None else size for size in rows.shape[1:]))
        file.create_dataset(name, data=rows, maxshape=wide, fillvalue=fill, chunks=_chunks(rows))
        return
    dataset = file[name]
    before = len(dataset)
    dataset.resize((before + len(rows), *map(max, dataset.shape[1:], rows.shape[1:])))
    if len(rows):
        dataset[(slice(before, None), *(slice(size) for size in rows.shape[1:]))] = rows


def _chunks(rows: np.ndarray[typing.Any, typing.Any]) -> tuple[int, ...]:
    """A row, or many narrow ones, some 64 KiB together."""
    width = tuple(max(1, min(size, 8192)) for size in rows.shape[1:])
    return (max(1, 65536 // (rows.dtype.itemsize * int(np.prod(width)))), *width)
