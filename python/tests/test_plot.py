# SPDX-License-Identifier: GPL-3.0-or-later
"""`plot` and the picture of notebooks: what is drawn, in which colours; refusals; and what is imported, and when."""

import struct
import subprocess
import sys

import annulus
import annulus._plot
import numpy as np
import pytest

from support import KINDS, points_of

X = np.random.default_rng(3).random((80, 2))
SQUARE = [[0.0, 0.0], [1.0, 1.0]]


@pytest.fixture
def matplotlib():
    return pytest.importorskip("matplotlib", reason="matplotlib is not installed")


def area(polygon):
    x, y = polygon[:, 0], polygon[:, 1]
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def drawn(ax):
    """The polygons and the numbers of the last collection; a closed path repeats its first corner."""
    cells = ax.collections[-1]
    return [path.vertices[:-1] for path in cells.get_paths()], cells.get_array()


def hexagons(rows):
    """A triangular lattice in its box: every cell has six neighbours and the same area."""
    box = np.array([rows, rows * np.sqrt(3) / 2])
    k, m = np.divmod(np.arange(rows * rows), rows)
    return np.column_stack([(m + 0.5 * (k % 2)), k * np.sqrt(3) / 2]), box


def test_cells_are_those_of_the_clip(matplotlib):
    dt = annulus.MovingDelaunay(X)
    dt.remove([5, 7])
    for clip in (SQUARE, [[0.25, 0.25], [0.75, 0.5]], [[0, 0], [1, 0], [0.5, 0.8]], None):
        box = [dt.points[dt.is_vertex].min(axis=0), dt.points[dt.is_vertex].max(axis=0)] if clip is None else clip
        ax = dt.plot(clip=clip)
        polygons, values = drawn(ax)
        cells, areas = dt.voronoi_polytopes(box), dt.voronoi_volumes(box)
        there = [i for i in range(80) if len(cells.polygon(i))]
        assert 5 not in there and 7 not in there and len(polygons) == len(there) == len(values)
        assert all(np.array_equal(p, cells.polygon(i)) for p, i in zip(polygons, there))
        assert np.array_equal(values, areas[there]) and not np.ma.is_masked(values)
        assert np.allclose([area(p) for p in polygons], values, rtol=0, atol=1e-12)
        assert ax.collections[-1].get_clim() == (values.min(), values.max())
        assert ax.get_aspect() in (1, "equal")
    assert np.isclose(sum(map(area, drawn(dt.plot(clip=SQUARE))[0])), 1, rtol=1e-12)


@pytest.mark.parametrize("box", [[1.0, 1.0], [[1.0, 0.0], [0.4, 0.7]], [[0.3, 1.2], [-1.0, 0.2]]])
def test_cells_fill_the_box(matplotlib, box):
    """With points anywhere: pieces that fill the box, and together are as large as the cells."""
    for n in (1, 2, 30):
        dt = annulus.MovingDelaunay(7 * X[:n] - 3, box=box)
        polygons, values = drawn(dt.plot())
        owners = annulus._plot.cells_in_box(dt)[1]
        volumes = dt.voronoi_volumes()
        assert len(polygons) == len(owners) >= n and set(owners.tolist()) == set(range(n))
        areas = np.array([area(p) for p in polygons])
        assert areas.min() > 0 and np.allclose(np.bincount(owners, areas), volumes, rtol=1e-9)
        assert np.array_equal(values, volumes[owners])
        shares = np.concatenate(polygons) @ np.linalg.inv(dt.box)
        assert shares.min() > -1e-12 and shares.max() < 1 + 1e-12
        # The point of a piece is the nearest of all images: its middle has no other nearest one.
        middles = np.array([p.mean(axis=0) for p in polygons])
        images = np.array([(a, b) for a in range(-3, 4) for b in range(-3, 4)]) @ dt.box
        home = dt.points - np.floor(dt.points @ np.linalg.inv(dt.box)) @ dt.box
        ways = middles[:, None, None] - home[None, :, None] - images[None, None]
        distances = np.sum(ways**2, axis=3).min(axis=2)
        assert np.all(distances[np.arange(len(owners)), owners] <= distances.min(axis=1) + 1e-12)


@pytest.mark.parametrize("removed", [[5], [29], [28, 29]])
def test_free_indices_have_no_piece_of_a_box(matplotlib, removed):
    dt = annulus.MovingDelaunay(X[:30], box=[1, 1])
    dt.remove(removed)
    polygons, values = drawn(dt.plot())
    assert set(annulus._plot.cells_in_box(dt)[1].tolist()) == set(range(30)) - set(removed)
    assert np.isclose(sum(map(area, polygons)), 1, rtol=1e-9) and not np.isnan(values).any()


def test_edges(matplotlib):
    dt = annulus.MovingDelaunay(X)
    dt.remove([5])
    lines = dt.plot(None).collections[-1].get_segments()
    assert np.array_equal(lines, dt.points[dt.edges])
    for points, box in ((X, [1, 1]), (9 * X, [[1, 0], [0.4, 0.7]]), (X[:1], [1, 1]), (X[:2], [1, 3])):
        dt = annulus.MovingDelaunay(points, box=box)
        pieces = np.array(dt.plot(None).collections[-1].get_segments())
        i, j, d = dt.neighbor_list("ijd")
        total = np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1).sum()
        assert np.isclose(total, d.sum() / 2, rtol=1e-9)
        shares = pieces.reshape(-1, 2) @ np.linalg.inv(dt.box)
        assert shares.min() > -1e-12 and shares.max() < 1 + 1e-12
    line = annulus.MovingDelaunay([[0, 0], [2, 2], [1, 1]]).plot(None)
    assert len(line.collections[-1].get_segments()) == 2


def colors(ax):
    cells = ax.collections[-1]
    return [pytest.importorskip("matplotlib.colors").to_hex(c) for c in cells.to_rgba(cells.get_array())]


def test_neighbors_have_colors_of_their_own(matplotlib):
    dt = annulus.MovingDelaunay(X, box=[1, 1])
    ax = dt.plot("neighbors")
    owners, counts = annulus._plot.cells_in_box(dt)[1], dt.neighbor_counts()
    assert np.array_equal(drawn(ax)[1], counts[owners]) and {4, 5, 6, 7, 8} <= set(counts.tolist())
    names = annulus._plot._NEIGHBOR_COLORS
    assert colors(ax) == [names[min(max(int(k), 4), 8) - 4] for k in counts[owners]]
    # Cells without bounds have no number.
    opened = annulus.MovingDelaunay(X)
    values = drawn(opened.plot("neighbors", clip=[[-1, -1], [2, 2]]))[1]
    unbounded = np.isinf(opened.voronoi_volumes())
    assert np.array_equal(np.ma.getmaskarray(values), unbounded) and 3 < unbounded.sum() < 20
    assert np.array_equal(values.compressed(), opened.neighbor_counts()[~unbounded])
    assert dt.plot("neighbors", vmin=0).collections[-1].get_clim() == (0, counts.max())
    assert dt.plot("neighbors", cmap="magma").collections[-1].cmap.name == "magma"


def test_arrays_and_limits(matplotlib):
    dt = annulus.MovingDelaunay(X)
    dt.remove([5])
    values = np.arange(80.0)
    values[[2, 5, 9]] = [np.nan, np.nan, np.inf]
    ax = dt.plot(values)
    shown = drawn(ax)[1]
    assert np.array_equal(np.flatnonzero(np.ma.getmaskarray(shown)), [2, 8]) and len(shown) == 79  # 5 is not there
    assert ax.collections[-1].get_clim() == (0, 79)
    assert np.flatnonzero([c == annulus._plot._NO_NUMBER for c in colors(ax)]).tolist() == [2, 8]
    first, last = colors(ax)[0], colors(ax)[-1]
    ax = dt.plot(list(range(80)), vmin=-10, vmax=20, cmap="magma", clip=SQUARE)
    assert ax.collections[-1].get_clim() == (-10, 20) and ax.collections[-1].cmap.name == "magma"
    # What differs by rounding alone has one colour, the middle one.
    x, box = hexagons(12)
    ax = annulus.MovingDelaunay(x, box=box).plot()
    assert np.ptp(drawn(ax)[1]) > 0 and len(set(colors(ax))) == 1 and not set(colors(ax)) & {first, last}
    ax = annulus.MovingDelaunay(x, box=box).plot("neighbors")
    assert set(colors(ax)) == {annulus._plot._NEIGHBOR_COLORS[2]}


def test_axes_and_scale(matplotlib):
    figure = pytest.importorskip("matplotlib.figure").Figure()
    ax = figure.add_subplot()
    dt = annulus.MovingDelaunay(X)
    assert dt.plot(None, ax) is ax and dt.plot("area", ax=ax, clip=SQUARE) is ax and len(ax.collections) == 2
    assert len(figure.axes) == 1
    ax = dt.plot("neighbors", colorbar=True)
    scale = ax.figure.axes[1]
    assert [t.get_text() for t in scale.get_yticklabels()] == list(annulus._plot._NEIGHBOR_LABELS)
    ax.figure.canvas.draw()
    room = ax.figure.bbox
    box = scale.get_tightbbox(ax.figure.canvas.get_renderer())
    assert box.x1 <= room.x1 and box.y1 <= room.y1 + 1
    assert annulus.MovingDelaunay(X, box=[1, 1]).plot(X[:, 0], colorbar=True).figure.axes[1].get_ylabel() == ""


@pytest.mark.parametrize("kind", KINDS)
def test_any_points(matplotlib, kind):
    for n in (0, 1, 3, 40):
        dt = annulus.MovingDelaunay(points_of(kind, n, 2, 1))
        for what in ("area", "neighbors", None):
            assert len(dt.plot(what).collections) == 1
        assert (dt._repr_png_() is None) == (dt.npoints == 0)


def test_no_points(matplotlib):
    dt = annulus.MovingDelaunay(X)
    dt.remove(np.arange(80))
    for none in (dt, annulus.MovingDelaunay(X[:0], box=[1, 1])):
        for what in ("area", "neighbors", None):
            assert len(none.plot(what).collections[0].get_paths()) == 0
        assert none._repr_png_() is None


def test_refusals(matplotlib):
    dt, box = annulus.MovingDelaunay(X), annulus.MovingDelaunay(X, box=[1, 1])
    for call, code in ((lambda: dt.plot("areas"), "usage"), (lambda: dt.plot(np.zeros(79)), "wrong_size"),
                       (lambda: dt.plot(X), "wrong_size"), (lambda: dt.plot(None, vmin=1), "usage"),
                       (lambda: dt.plot(None, clip=SQUARE), "usage"), (lambda: dt.plot(None, colorbar=True), "usage"),
                       (lambda: dt.plot(cmap="no colours"), "usage"), (lambda: dt.plot(vmax=np.inf), "usage"),
                       (lambda: box.plot(clip=SQUARE), "usage"), (lambda: dt.plot(clip=[[0, 0], [0, 1]]), "bad_input"),
                       (lambda: annulus.MovingDelaunay(np.zeros((0, 3))).plot(), "usage"),
                       (lambda: annulus.MovingDelaunay(np.zeros((1, 3)), box=[1, 1, 1]).plot(), "usage")):
        with pytest.raises(annulus.Error) as caught:
            call()
        assert caught.value.code == code
    for call in (lambda: dt.plot(ax=3), lambda: dt.plot(vmin="low"), lambda: dt.plot(["a"] * 80),
                 lambda: dt.plot(colorbar=2), lambda: dt.plot(cmap=3)):
        with pytest.raises(TypeError):
            call()
    assert annulus.MovingDelaunay(np.eye(3))._repr_png_() is None


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", png[16:24])


def test_notebooks(matplotlib, monkeypatch):
    for dt in (annulus.MovingDelaunay(X), annulus.MovingDelaunay(X, box=[1, 1])):
        assert size_of(dt._repr_png_()) == (400, 400)
        monkeypatch.setattr(annulus._plot, "_MOST_IN_NOTEBOOKS", 80)
        assert dt._repr_png_() is not None
        monkeypatch.setattr(annulus._plot, "_MOST_IN_NOTEBOOKS", 79)
        assert dt._repr_png_() is None
        monkeypatch.undo()
    assert annulus._plot._MOST_IN_NOTEBOOKS == 20_000
    assert object.__new__(annulus.MovingDelaunay)._repr_png_() is None


def test_without_matplotlib(monkeypatch):
    for name in ("matplotlib", "matplotlib.collections", "matplotlib.colors", "matplotlib.figure",
                 "matplotlib.backends.backend_agg"):
        monkeypatch.setitem(sys.modules, name, None)
    for dt in (annulus.MovingDelaunay(X), annulus.MovingDelaunay(X, box=[1, 1])):
        with pytest.raises(ImportError, match="plot needs the package matplotlib"):
            dt.plot()
        assert dt._repr_png_() is None


def test_what_is_imported():
    """Importing annulus imports no matplotlib, and drawing no pyplot, which has a state of its own."""
    program = ("import sys, annulus; early = 'matplotlib' in sys.modules\n"
               "try:\n    annulus.MovingDelaunay([[0, 0], [1, 0], [0, 1]]).plot(colorbar=True).figure.canvas.draw()\n"
               "except ImportError: pass\n"
               "print(early, 'matplotlib.pyplot' in sys.modules)")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "False False\n"
