# SPDX-License-Identifier: GPL-3.0-or-later
"""`plot` and the picture of notebooks, of triangulations with and without a box. Matplotlib is imported when something
is drawn, and pyplot never."""

from __future__ import annotations

import importlib
import io
import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._error import Error
from ._periodic_cells import cells_in_box, edges_in_box

_MOST_IN_NOTEBOOKS = 20_000
# Few, 5, 6, 7, many neighbours: six, which is usual, is pale.
_NEIGHBOR_COLORS = ("#08306b", "#2f7fc1", "#ece9e2", "#e4572e", "#7a0c1e")
_NEIGHBOR_LABELS = ("4 or fewer", "5", "6", "7", "8 or more")
_NO_NUMBER = "#c8c8c8"  # where a value is not finite
_EDGES = "#1f4e79"


class Plots:
    """Pictures in 2D."""

    _mesh: typing.Any

    def plot(self, color_by: str | ArrayLike | None = "area", ax: typing.Any = None, *, clip: ArrayLike | None = None,
             cmap: typing.Any = None, vmin: float | None = None, vmax: float | None = None,
             colorbar: bool = False) -> typing.Any:
        """Draws the Voronoi cells in 2D, coloured, or the edges of the triangulation. Needs matplotlib.

        Parameters
        ----------
        color_by : {'area', 'neighbors'}, array_like of shape (npoints,), or None, optional
            What the colours of cells mean. ``'area'``: their areas as they are drawn, that is, clipped; with a periodic
            box whole. ``'neighbors'``: `neighbor_counts`, of which 6 is pale, 5 and less blue, 7 and more red; cells
            that are unbounded without a clip have no number. An array: a number for each point. None: no cells, but
            the edges of the triangulation.
        ax : matplotlib.axes.Axes, optional
            Where to draw. By default on a new figure, without axes, that pyplot does not manage: ``ax.figure`` shows it
            in a notebook, ``ax.figure.savefig(path)`` writes it. In both cases scales become equal.
        clip : array_like, optional
            What cells are intersected with, as for `MovingDelaunay.voronoi`; by default the bounding box of the points.
            With a periodic box cells are drawn within this box, whose corner is at the origin, in as many pieces as it
            cuts them into, and no clip may be given.
        cmap : str or matplotlib.colors.Colormap, optional
            The colours; ``'viridis'`` by default. If it, `vmin` or `vmax` is given, numbers of neighbours are coloured
            as other numbers are.
        vmin, vmax : float, optional
            The numbers that have the first and the last colour; by default the least and the greatest of those drawn.
            Areas that differ by less than 1e-9 of the greatest have one colour.
        colorbar : bool, optional
            Whether to draw a scale of the colours beside the picture.

        Returns
        -------
        matplotlib.axes.Axes
            Its last collection is the `PolyCollection` of the cells, with their numbers as its array, or the
            `LineCollection` of the edges. Cells at free indices and outside the clip are not in it. What is not finite
            is grey.

        Raises
        ------
        Error
            With the codes ``usage`` in 3D and for arguments that exclude each other, ``wrong_size`` for an array of
            another shape, and those of a clip.
        ImportError
            If matplotlib is not installed.

        Notes
        -----
        O(n), some tens of microseconds for each cell. Without vertices nothing is drawn.
        """
        if _ndim(self) != 2:
            raise Error("plot draws in 2D, and these points are in 3D", "usage")
        if ax is not None and not hasattr(ax, "add_collection"):
            raise TypeError(f"ax must be an Axes of matplotlib, not {_arguments.described(ax)}")
        colorbar = _arguments.truth("colorbar", colorbar)
        pair = (("vmin", vmin), ("vmax", vmax))
        limits = tuple(None if v is None else _finite(name, v) for name, v in pair)
        scale = (cmap, *limits)
        if clip is not None and _is_periodic(self):
            raise Error("clip cannot be given with a periodic box: cells are drawn within the box", "usage")
        collections = _imported("matplotlib.collections")
        if color_by is None:
            if clip is not None or colorbar or any(part is not None for part in scale):
                raise Error("clip, cmap, vmin, vmax and colorbar are for cells, and color_by=None draws edges", "usage")
            drawn = collections.LineCollection(_edges(self), colors=_EDGES, linewidths=_width(self, 0.8))
        else:
            polygons, cells, values, kind = _cells(self, color_by, clip)
            drawn = collections.PolyCollection(polygons, edgecolors="white", linewidths=_width(self, 0.6))
            masked: typing.Any = np.ma.masked_invalid  # for which NumPy declares no types
            drawn.set_array(masked(values[cells]))
            kind = "number" if any(part is not None for part in scale) and kind == "neighbors" else kind
            _set_scale(drawn, kind, *scale)
        if ax is None:
            ax = _new_axes(7.0, 0.84 if colorbar else 0.96)
        ax.add_collection(drawn)
        ax.autoscale_view()
        ax.set_aspect("equal")
        if colorbar:
            _add_colorbar(ax, drawn, kind)
        return ax

    def _repr_png_(self) -> bytes | None:
        """A small picture for notebooks, as `plot` draws it, PNG. None, so that the text is shown, in 3D, without
        vertices, with more than 20,000 points, and without matplotlib."""
        if "_mesh" not in self.__dict__ or _ndim(self) != 2 or not 0 < self._mesh.vertices <= _MOST_IN_NOTEBOOKS:
            return None
        try:
            ax = self.plot(ax=_new_axes(4.0, 0.96))
        except (ImportError, Error):
            return None
        out = io.BytesIO()
        ax.figure.savefig(out, format="png", dpi=100)
        return out.getvalue()


def _finite(name: str, value: object) -> float:
    number = _arguments.number(name, value)
    if not np.isfinite(number):
        raise Error(f"{name} must be finite, not {_arguments.described(value)}", "usage")
    return number


def _imported(module: str) -> typing.Any:
    try:
        return importlib.import_module(module)
    except ImportError as e:
        raise ImportError("plot needs the package matplotlib, which cannot be imported") from e


def _new_axes(inches: float, width: float) -> typing.Any:
    """Axes on a figure of their own, with this share of its width, without scales."""
    figure = _imported("matplotlib.figure").Figure(figsize=(inches, inches))
    _imported("matplotlib.backends.backend_agg").FigureCanvasAgg(figure)
    ax = figure.add_axes([0.02, 0.02, width, 0.96])
    ax.set_axis_off()
    ax.margins(0.0)
    return ax


def _is_periodic(dt: typing.Any) -> bool:
    return isinstance(dt._mesh, (_core.Periodic2, _core.Periodic3))


def _ndim(dt: typing.Any) -> int:
    return 2 if isinstance(dt._mesh, (_core.Mesh2, _core.Periodic2)) else 3


def _width(dt: typing.Any, most: float) -> float:
    """The width of lines in points, so that they leave something of the cells."""
    return float(min(most, 20 / np.sqrt(max(dt.npoints, 1))))


def _edges(dt: typing.Any) -> NDArray[np.float64]:
    """The edges, shape (k, 2, 2)."""
    edges: NDArray[np.float64] = edges_in_box(dt) if _is_periodic(dt) else dt.points[dt.edges]
    return edges


def _cells(dt: typing.Any, color_by: str | ArrayLike, clip: ArrayLike | None) -> tuple[
        list[NDArray[np.float64]], NDArray[np.intp], NDArray[np.float64], str]:
    """The polygons to draw, the point of each, numbers by point, and what these are."""
    if isinstance(color_by, str):
        kind = _arguments.choice("color_by", color_by, ("area", "neighbors"))
    else:
        kind, given = "number", _arguments.array_of(color_by, "color_by")
        if given.shape != (dt.npoints,):
            raise Error(f"color_by must have shape ({dt.npoints},), a number for each point, not {given.shape}",
                        "wrong_size")
    periodic = _is_periodic(dt)
    if periodic:
        polygons, cells = cells_in_box(dt)
    else:
        clip = _bounding_box(dt.points) if clip is None else clip
        all_cells = dt.voronoi_polytopes(clip)
        cells = np.flatnonzero(np.diff(all_cells.side_indptr))
        polygons = [all_cells.polygon(int(i)) for i in cells]
    if kind == "area":
        values = dt.voronoi_volumes() if periodic else dt.voronoi_volumes(clip)
    elif kind == "neighbors":
        values = dt.neighbor_counts().astype(np.float64)
        if not periodic:
            values[~np.isfinite(dt.voronoi_volumes())] = np.nan
    else:
        values = given.astype(np.float64)
    return polygons, cells, values, kind


def _bounding_box(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of the vertices; a side without length is made as long as the other, or 1."""
    points = points[~np.isnan(points[:, 0])]
    if not len(points):
        return np.array([[0.0, 0.0], [1.0, 1.0]])
    low, high = points.min(axis=0), points.max(axis=0)
    longest = float(np.max(high - low)) or max(1.0, float(np.max(np.abs(low))))
    half = np.where(high > low, 0.0, longest / 2)
    return np.array([low - half, high + half])


def _colors_of(cmap: object) -> typing.Any:
    """The Colormap that is given or named, or the default."""
    known = _imported("matplotlib").colormaps
    if cmap is None:
        return known["viridis"].with_extremes(bad=_NO_NUMBER)
    if isinstance(cmap, str):
        if cmap not in known:
            raise Error(f"cmap must be the name of a Colormap of matplotlib, not {_arguments.described(cmap)}", "usage")
        return known[cmap]
    if not isinstance(cmap, _imported("matplotlib.colors").Colormap):
        raise TypeError(f"cmap must be a Colormap of matplotlib or the name of one, not {_arguments.described(cmap)}")
    return cmap


def _set_scale(drawn: typing.Any, kind: str, cmap: typing.Any, vmin: float | None, vmax: float | None) -> None:
    colors = _imported("matplotlib.colors")
    if kind == "neighbors":
        drawn.set_cmap(colors.ListedColormap(_NEIGHBOR_COLORS).with_extremes(bad=_NO_NUMBER))
        drawn.set_norm(colors.BoundaryNorm([3.5, 4.5, 5.5, 6.5, 7.5, 8.5], len(_NEIGHBOR_COLORS)))
        return
    drawn.set_cmap(_colors_of(cmap))
    values = drawn.get_array().compressed()
    if kind == "area" and len(values) and np.ptp(values) <= 1e-9 * values.max():
        vmin, vmax = 0.5 * values.min() if vmin is None else vmin, 1.6 * values.max() if vmax is None else vmax
    drawn.set_clim(vmin, vmax)
    drawn.autoscale_None()


def _add_colorbar(ax: typing.Any, drawn: typing.Any, kind: str) -> None:
    if kind == "neighbors":
        bar = ax.figure.colorbar(drawn, ax=ax, ticks=[4, 5, 6, 7, 8])
        bar.set_ticklabels(_NEIGHBOR_LABELS)
        bar.ax.tick_params(length=0)
    else:
        bar = ax.figure.colorbar(drawn, ax=ax)
    bar.set_label({"area": "area", "neighbors": "neighbours"}.get(kind, ""))
