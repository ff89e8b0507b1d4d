# SPDX-License-Identifier: GPL-3.0-or-later
"""Voronoi cells that are clipped by boxes, half-spaces and polygons."""

import annulus
import numpy as np
import pytest


@pytest.mark.parametrize("d", [2, 3])
def test_clips(d):
    rng = np.random.default_rng(40 + d)
    x = rng.random((80, d))
    dt = annulus.MovingDelaunay(x)
    box = np.array([[0.1] * d, [0.9] * d])
    v = dt.voronoi(clip=box)
    assert v.volumes.sum() == pytest.approx(0.8**d, rel=1e-12) and np.isfinite(v.areas).all()
    assert np.array_equal(dt.voronoi_volumes(clip=box), v.volumes)
    faces = np.concatenate([np.column_stack([np.eye(d), np.full(d, -0.9)]),
                            np.column_stack([-np.eye(d), np.full(d, 0.1)])])
    assert dt.voronoi_volumes(clip=faces) == pytest.approx(v.volumes, abs=1e-14)
    if d == 2:
        corners = np.array([[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]])
        for polygon in (corners, corners[::-1]):
            assert dt.voronoi_volumes(clip=polygon) == pytest.approx(v.volumes, abs=1e-14)
        with pytest.raises(annulus.Error, match="convex"):
            dt.voronoi(clip=[[0, 0], [1, 0], [0.2, 0.2], [0, 1]])
    # Mirror images of the points at the faces of a box bound its cells by these faces.
    images = [x]
    for axis in range(d):
        for face in (0, 1):
            image = x.copy()
            image[:, axis] = 2 * face - x[:, axis]
            images.append(image)
    mirrored = annulus.MovingDelaunay(np.concatenate(images)).voronoi()
    mine = dt.voronoi(clip=[[0] * d, [1] * d])
    assert mine.volumes == pytest.approx(mirrored.volumes[:80], rel=1e-9)
    assert mine.surfaces == pytest.approx(mirrored.surfaces[:80], rel=1e-9)
    assert mine.centroids == pytest.approx(mirrored.centroids[:80], abs=1e-9)
    i, j, area = dt.neighbor_list("ijA", clip=box)
    assert np.isfinite(area).all() and dt.neighbor_counts(clip=box, min_area=1e-12).sum() == np.sum(area > 1e-12)
    for wrong, code, what in ((box[::-1], "bad_input", "no interior"), (box * np.nan, "not_finite", "not finite"),
                              ([1.0, 2.0], "wrong_size", rf"shape \(2, {d}\)"), (faces[:d], "bad_input", "not bound"),
                              (np.eye(2, 5 - d), *(("bad_input", "in 3D") if d == 2 else ("wrong_size", "a box")))):
        with pytest.raises(annulus.Error, match=what) as e:
            dt.voronoi(clip=wrong)
        assert e.value.code == code


@pytest.mark.parametrize("scale, offset", [(1e-5, 5e6), (1e-6, 1e6), (1e-2, 4e8), (1, 1e10), (1e150, 0), (1e-150, 0)])
def test_polygons_far_away_and_in_any_unit(scale, offset):
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    x = np.random.default_rng(0).random((50, 2)) * scale + offset
    dt = annulus.MovingDelaunay(x, merge_duplicates=True)
    area = np.nansum(dt.voronoi_volumes(clip=square * scale + offset)) / scale / scale
    assert abs(area - 1) < 2e-16 * (1 + offset / scale) * 20 + 1e-12


def test_polygons_have_to_be_convex():
    dt = annulus.MovingDelaunay(np.random.default_rng(0).random((50, 2)))
    star = [(0.5 + 0.4 * np.cos(4 * np.pi * k / 5), 0.5 + 0.4 * np.sin(4 * np.pi * k / 5)) for k in range(5)]
    for wrong in ([[0, 0], [1, 0], [1, 0.5], [0.5, 0.5], [0.5, 0.5], [0.5, 1], [0, 1]], star, [[0, 0], [1, 0], [0, 0]],
                  [[0, 0], [1, 0], [0.5, 0]], [[0, 0]] * 4):
        with pytest.raises(annulus.Error, match="convex polygon"):
            dt.voronoi_volumes(clip=wrong)
    corner = np.array([[0.1, 0.2], [0.9, 0.3], [0.4, 0.93]])
    on_edges = np.concatenate([corner[i] + (corner[(i + 1) % 3] - corner[i]) * k / 10 for i in range(3)
                               for k in range(10)]).reshape(-1, 2)
    for clip in (on_edges, on_edges[::-1]):
        assert abs(np.nansum(dt.voronoi_volumes(clip=clip)) - 0.277) < 1e-12


@pytest.mark.parametrize("power", [-1065, -600, 0, 300, 500])
def test_polygons_of_any_size(power):
    """A triangle with edges 3, 4 and 5, of which subnormal coordinates and normals hold few digits."""
    corners = np.ldexp([[1.0, 1], [4, 1], [1, 5]], power)
    v = annulus.MovingDelaunay(corners[:1]).voronoi(clip=corners)
    assert v.surfaces[0] == pytest.approx(np.ldexp(12.0, power), rel=1e-12)
    normals = np.array([[-1.0, 0], [0, -1], [4, 3]])
    for length in (-1070, 0, 1020):
        if -1070 <= length + power < 1019:
            rows = np.column_stack([np.ldexp(normals, length), -np.ldexp([-1.0, -1, 19], length + power)])
            v = annulus.MovingDelaunay(corners[:1]).voronoi(clip=rows)
            assert v.surfaces[0] == pytest.approx(np.ldexp(12.0, power), rel=1e-12)


def test_clipped_areas_are_as_far_off_as_their_angle_is_small():
    """Two points 1e-11 apart: sides of their cells nearly coincide."""
    v = annulus.MovingDelaunay([[0.3, 0.4], [0.3, 0.4 + 1e-11], [0.8, 0.5]]).voronoi(clip=[[0, 0], [1, 1]])
    (twins,) = np.flatnonzero(np.all(v.ridge_points == [0, 1], axis=1))
    sine = 1e-11 / 0.51 * 0.9
    others = np.arange(3) != twins
    assert v.volumes.sum() == pytest.approx(1, rel=1e-13)
    # From x = 0 to the bisector with the third point, which both cells share.
    assert v.areas[twins] == pytest.approx(0.55 + 0.1 * (0.45 - 0.4) / 0.5, abs=1e-9)
    length = np.hypot(1, 0.2)
    assert abs(v.areas[others].sum() - length) < 2 * 2**-46 * np.sqrt(2) / sine
