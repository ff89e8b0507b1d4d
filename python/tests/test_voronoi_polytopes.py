# SPDX-License-Identifier: GPL-3.0-or-later
"""Clipped Voronoi cells as polygons and polyhedra: beside the volumes and areas of the clipped diagram."""

import annulus
import numpy as np
import pytest

from support import lattice


@pytest.mark.parametrize("clip", ["box", "half-spaces"])
@pytest.mark.parametrize("d", [2, 3])
def test_polytopes(d, clip):
    """Closed cells with the volumes and areas of the clipped diagram, whose neighbours are beyond their sides."""
    x = np.random.default_rng(d).random((60, d))
    dt = annulus.MovingDelaunay(x)
    dt.remove([7])
    clip = {"box": [[0.1] * d, [0.9] * d],
            "half-spaces": np.vstack([np.eye(d + 1)[:d] - 0.9 * np.eye(d + 1)[d], [-1] * d + [0.4]])}[clip]
    cells, diagram = dt.voronoi_polytopes(clip), dt.voronoi(clip)
    areas = {(i, j): area for (i, j), area in zip(diagram.ridge_points.tolist(), diagram.areas)}
    there = sum(len(cells.faces(i)) > 0 for i in range(60))  # not 7, and not what the clip leaves nothing of
    assert len(cells) == 60 > there and f"<VoronoiPolytopes: {there} cells" in repr(cells) and cells.faces(7) == []
    total = 0.0
    for i in range(60):
        faces = cells.faces(i)
        beyond = cells.side_neighbors[cells.side_indptr[i]:cells.side_indptr[i + 1]].tolist()
        assert len(faces) == len(beyond) and set(beyond) <= set(range(60)) - {7, i} | {-1}
        volume, ends = 0.0, {}
        for face, j in zip(faces, beyond):
            if d == 2:
                area = np.linalg.norm(face[1] - face[0])
                volume += np.linalg.det(face) / 2
                ends[tuple(face[0])] = ends.get(tuple(face[0]), 0) + 1
                ends[tuple(face[1])] = ends.get(tuple(face[1]), 0) - 1
            else:
                normal = sum(np.cross(p - face[0], q - face[0]) for p, q in zip(face[1:], face[2:])) / 2
                area = np.linalg.norm(normal)
                volume += normal @ face.mean(axis=0) / 3 if area > 1e-12 else 0
                for p, q in zip(face, np.roll(face, -1, axis=0)):
                    ends[tuple(p), tuple(q)] = ends.get((tuple(p), tuple(q)), 0) + 1
                    ends[tuple(q), tuple(p)] = ends.get((tuple(q), tuple(p)), 0) - 1
            if j >= 0:
                assert abs(areas.get((min(i, j), max(i, j)), 0) - area) < 1e-12
                # On the bisector.
                assert np.allclose(np.sum((face - x[i]) ** 2, axis=1), np.sum((face - x[j]) ** 2, axis=1), atol=1e-12)
        assert not any(ends.values())  # each edge once in each direction: closed
        assert (volume > 0 or not faces) and abs(volume - (diagram.volumes[i] if i != 7 else 0)) < 1e-12
        total += volume
        if d == 2:
            polygon = cells.polygon(i)
            assert np.array_equal(polygon, np.array([face[0] for face in faces]).reshape(-1, 2))
            assert all(np.array_equal(a[1], b[0]) for a, b in zip(faces, faces[1:] + faces[:1]))
    assert abs(total - np.nansum(diagram.volumes)) < 1e-11
    for i in (-1, 60):
        with pytest.raises(annulus.Error) as caught:
            cells.faces(i)
        assert caught.value.code == "unknown_vertex"
    with pytest.raises(TypeError):
        cells.faces(1.5)
    with pytest.raises(annulus.Error, match="clip must be given"):
        dt.voronoi_polytopes(None)
    if d == 3:
        with pytest.raises(annulus.Error, match="faces"):
            cells.polygon(0)


def test_polytopes_of_few_points_and_of_lattices():
    square = [[0, 0], [1, 1]]
    for points, areas in (([[0.5, 0.5]], [1]), ([[3e40, -2.0]], [1]), ([[0.25, 0.5], [0.75, 0.5]], [0.5, 0.5]),
                          ([[0.5, 0.5], [0.5, 9.0]], [1, 0]), (np.zeros((0, 2)), [])):
        cells = annulus.MovingDelaunay(points).voronoi_polytopes(square)
        polygons = [cells.polygon(i) for i in range(len(points))]
        found = [0.5 * np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]) for p in polygons]
        assert np.allclose(found, areas, atol=1e-15)
    assert cells.corners.shape == (0, 2) and len(cells) == 0
    x, middle = lattice("cubic")
    cells = annulus.MovingDelaunay(x).voronoi_polytopes([[-1] * 3, [5] * 3])
    areas = {}
    beyond = cells.side_neighbors[cells.side_indptr[middle]:cells.side_indptr[middle + 1]]
    for face, j in zip(cells.faces(middle), beyond):
        normal = sum(np.cross(p - face[0], q - face[0]) for p, q in zip(face[1:], face[2:])) / 2
        areas[j] = areas.get(j, 0) + np.linalg.norm(normal)
    assert sorted(np.round(list(areas.values()), 9))[-6:] == [1] * 6 and abs(sum(areas.values()) - 6) < 1e-9
