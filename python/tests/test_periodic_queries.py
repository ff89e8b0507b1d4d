# SPDX-License-Identifier: GPL-3.0-or-later
"""Nearest vertices, interpolation and location in periodic boxes, beside brute force over images, the images as an open
set, and insertion of the position itself."""

import itertools
import pickle

import annulus
import numpy as np
import pytest

BOXES = {2: [[2, 1.5], [[1.5, 0], [0.5, 1.25]], [1, 0.05], [[1, 0], [3, 1]], [[0, 1], [1, 0]]],
         3: [[1, 1.5, 2], [[2, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]], [1, 0.3, 0.05],
             [[1, 0, 0], [0, 1, 0], [3, 0, 1]]]}
CASES = [(d, k, n) for d in (2, 3) for k in range(len(BOXES[d])) for n in (1, 2, 3, 10, 200)]


def vectors_of(box):
    box = np.asarray(box, dtype=float)
    return np.diag(box) if box.ndim == 1 else box


def shifts_within(reach, d):
    return np.array(list(itertools.product(range(-reach, reach + 1), repeat=d)))


def made(d, k, n, seed=0):
    """Points in any image, in a box, after moves, insertions and removals; and positions in any image."""
    box, rng = vectors_of(BOXES[d][k]), np.random.default_rng(1000 * seed + 100 * k + n)
    dt = annulus.MovingDelaunay((5 * rng.random((n + 1, d)) - 2) @ box, box=box)
    dt.move(dt.points + 0.2 * rng.standard_normal((n + 1, d)) @ box, box=1.25 * box)
    dt.insert((3 * rng.random((2, d)) - 1) @ box)
    dt.remove([n, 0, n + 1])
    assert dt.nvertices == n and dt.npoints == n + 3
    return dt, (7 * rng.random((60, d)) - 3) @ box


def images_near(dt, xi):
    """For each position all images of vertices that may be near: vectors to them, vertices. By all shifts around the
    position in the reduced directions of these boxes."""
    d = dt.ndim
    basis = dt.box.copy()
    if d == 2 and abs(basis[1, 0]) > 2 * basis[0, 0]:
        basis[1] -= 3 * basis[0]
    if d == 3 and abs(basis[2, 0]) > 2 * basis[0, 0]:
        basis[2] -= 3 * basis[0]
    v = np.flatnonzero(dt.is_vertex)
    share = (dt.points[v][None] - xi[:, None]) @ np.linalg.inv(basis)
    share -= np.round(share)
    shifts = shifts_within(3 if d == 2 else 2, d)
    return (share[:, :, None] + shifts) @ basis, v


@pytest.mark.parametrize("d, k, n", CASES)
def test_nearest_vertices_are_those_of_all_images(d, k, n):
    dt, xi = made(d, k, n)
    vertices, shifts = dt.nearest_vertex(xi)
    assert vertices.dtype == shifts.dtype == np.int32 and vertices.shape == (60,) and shifts.shape == (60, d)
    ways, v = images_near(dt, xi)
    distances = np.linalg.norm(ways, axis=3)
    assert np.array_equal(vertices, v[distances.min(axis=2).argmin(axis=1)])
    found = dt.points[vertices] + shifts @ dt.box
    assert np.linalg.norm(found - xi, axis=1) == pytest.approx(distances.min(axis=(1, 2)), abs=1e-12)
    # Points are nearest to themselves; images are moved by what they were moved by.
    there = np.flatnonzero(dt.is_vertex)
    moved = np.random.default_rng(n).integers(-5, 6, (n, d))
    same, by = dt.nearest_vertex(dt.points[there] + moved @ dt.box)
    assert np.array_equal(same, there) and np.array_equal(by, moved)


@pytest.mark.parametrize("d, k, n", CASES)
def test_interpolation_is_by_the_facets_of_the_position_as_a_point(d, k, n):
    dt, xi = made(d, k, n, seed=1)
    rng = np.random.default_rng(n)
    values = rng.standard_normal((dt.npoints, 3))
    values[~dt.is_vertex] = np.nan
    found = dt.interpolate(values, xi)
    assert found.shape == (60, 3) and np.all(np.isfinite(found))
    for q, result in zip(xi[:12], found):
        other = pickle.loads(pickle.dumps(dt))
        new = other.insert([q])[0]
        i, j, distance, area = other.neighbor_list("ijdA")
        mine = (i == new) & (j != new)
        weight = area[mine] / distance[mine]
        assert result == pytest.approx(weight @ values[j[mine]] / weight.sum(), rel=1e-7, abs=1e-9)
    assert dt.interpolate(np.ones(dt.npoints), xi) == pytest.approx(np.ones(60), abs=1e-13)
    there = np.flatnonzero(dt.is_vertex)
    assert np.array_equal(dt.interpolate(values, dt.points[there] - 3 * dt.box[0]), values[there])
    assert found == pytest.approx(dt.interpolate(values, xi + dt.box[0] - 2 * dt.box[d - 1]), abs=1e-6)


@pytest.mark.parametrize("d", [2, 3])
def test_queries_agree_with_the_images_as_an_open_set(d):
    rng = np.random.default_rng(d)
    for box in (vectors_of(BOXES[d][0]), vectors_of(BOXES[d][1])):
        x = rng.random((40, d)) @ box
        dt = annulus.MovingDelaunay(x, box=box)
        shifts = shifts_within(2 if d == 2 else 1, d)
        images = annulus.MovingDelaunay((dt.points + (shifts @ dt.box)[:, None]).reshape(-1, d))
        xi = rng.random((200, d)) @ box
        vertices, by = dt.nearest_vertex(xi)
        nearest = images.nearest_vertex(xi)
        assert np.array_equal(nearest % 40, vertices) and np.array_equal(shifts[nearest // 40], by)
        values = rng.standard_normal(40)
        open_values = images.interpolate(np.tile(values, len(shifts)), xi)
        assert dt.interpolate(values, xi) == pytest.approx(open_values, rel=1e-9, abs=1e-9)
        s, by = dt.find_simplex(xi)
        corners = dt.points[dt.simplices[s]] + (dt.simplex_offsets[s] + by[:, None]) @ dt.box
        beside = images.points[images.simplices[images.find_simplex(xi)]]
        assert np.sort(corners.sum(axis=2)) == pytest.approx(np.sort(beside.sum(axis=2)), abs=1e-12)
        # What is linear between a position and its neighbours is reproduced.
        weights = dt.interpolate(np.eye(40), xi)
        assert np.all(weights >= 0) and weights.sum(axis=1) == pytest.approx(np.ones(200), abs=1e-12)
        angle = 2 * np.pi * dt.points @ np.linalg.inv(dt.box)
        at = 2 * np.pi * xi @ np.linalg.inv(dt.box)
        error = np.abs(dt.interpolate(np.cos(angle), xi) - np.cos(at))
        assert error.max() < 1.5 and error.mean() < 0.3


@pytest.mark.parametrize("box", [[1, 1e3], [1e4, 1], [[1, 0], [0.3, 300]], [1, 1, 1e3], [1e3, 1, 1], [1, 1e3, 1e3],
                                 [[1, 0, 0], [0.5, 1, 0], [0.25, 0.25, 400]]])
@pytest.mark.parametrize("n", [1, 2, 5, 40])
def test_thin_boxes(box, n):
    box = vectors_of(box)
    d, rng = len(box), np.random.default_rng(n)
    dt = annulus.MovingDelaunay(rng.random((n, d)) @ box, box=box)
    xi = (3 * rng.random((80, d)) - 1) @ box
    ways, v = images_near(dt, xi)
    distances = np.linalg.norm(ways, axis=3)
    vertices, shifts = dt.nearest_vertex(xi)
    assert np.array_equal(vertices, v[distances.min(axis=2).argmin(axis=1)])
    found = np.linalg.norm(dt.points[vertices] + shifts @ dt.box - xi, axis=1)
    assert found == pytest.approx(distances.min(axis=(1, 2)), rel=1e-9)
    values = rng.standard_normal(n)
    result = dt.interpolate(values, xi[:10])
    for q, value in zip(xi[:10], result):
        other = pickle.loads(pickle.dumps(dt))
        new = other.insert([q])[0]
        i, j, distance, area = other.neighbor_list("ijdA")
        mine = (i == new) & (j != new)
        weight = area[mine] / distance[mine]
        assert value == pytest.approx(weight @ values[j[mine]] / weight.sum(), rel=1e-7, abs=1e-9)


def test_lattices_where_everything_is_cospherical():
    for d in (2, 3):
        x = np.stack(np.meshgrid(*[np.arange(3.0)] * d), -1).reshape(-1, d)
        dt = annulus.MovingDelaunay(x, box=[3] * d)
        quarter = np.array(list(itertools.product([-1.25, 0, 0.25, 0.5, 2.75], repeat=d)))
        vertices, shifts = dt.nearest_vertex(quarter)
        ways = np.abs(dt.points[vertices] + shifts @ dt.box - quarter)
        assert np.array_equal(ways, np.abs(quarter - np.round(quarter)))
        values = np.cos(2 * np.pi * x / 3).sum(axis=1)
        corners = np.array(list(itertools.product([0, 1], repeat=d)))  # around the middle of a cube, of one weight
        mean = np.cos(2 * np.pi * corners / 3).sum(axis=1).mean()
        assert dt.interpolate(values, np.full((1, d), 0.5)) == pytest.approx([mean], rel=1e-12)
        one = annulus.MovingDelaunay(np.zeros((1, d)), box=[1] * d)
        assert one.interpolate([7.0], quarter) == pytest.approx(np.full(len(quarter), 7.0), rel=1e-14)
        assert np.all(one.nearest_vertex(quarter)[0] == 0)


@pytest.mark.parametrize("d", [2, 3])
def test_shapes_outputs_and_errors(d):
    rng = np.random.default_rng(d)
    dt = annulus.MovingDelaunay(rng.random((30, d)), box=np.ones(d))
    xi = rng.random((4, 5, d))
    for query in (dt.nearest_vertex, dt.find_simplex):
        numbers, shifts = query(xi)
        assert numbers.shape == (4, 5) and shifts.shape == (4, 5, d)
        flat, flat_shifts = query(xi.reshape(-1, d))
        assert np.array_equal(flat, numbers.ravel()) and np.array_equal(flat_shifts, shifts.reshape(-1, d))
        number, shift = query(xi[0, 0])
        assert number.shape == () and number == numbers[0, 0] and np.array_equal(shift, shifts[0, 0])
        assert query(np.empty((0, d)))[1].shape == (0, d)
    values = rng.random((30, 2, 3))
    full = dt.interpolate(values, xi)
    assert full.shape == (4, 5, 2, 3) and dt.interpolate(values[:, 0, 0], xi[0, 0]).shape == ()
    out = np.empty((4, 5, 2, 3), dtype=np.float32)
    assert dt.interpolate(values, xi, out=out) is out and np.array_equal(out, full.astype(np.float32))
    assert dt.interpolate(values, xi, dtype="float32").dtype == np.float32
    some = xi[0].copy()
    some[1, 0] = np.nan
    result = dt.interpolate(values[:, 0, 0], some)
    assert np.array_equal(np.isnan(result), [False, True, False, False, False])
    assert np.array_equal(result[[0, 2]], full[0, [0, 2], 0, 0])
    infinite = np.full((2, d), [[0.0], [np.inf]])
    for call, code in ((lambda: dt.nearest_vertex(some), "not_finite"),
                       (lambda: dt.nearest_vertex(infinite), "not_finite"),
                       (lambda: dt.interpolate(values, infinite), "not_finite"),
                       (lambda: dt.nearest_vertex(np.full(d, 1e300)), "out_of_domain"),
                       (lambda: dt.nearest_vertex([0.5]), "wrong_size"),
                       (lambda: dt.interpolate(values[:7], xi), "wrong_size"),
                       (lambda: dt.interpolate(3.0, xi), "wrong_size")):
        with pytest.raises((annulus.Error, TypeError)) as caught:
            call()
        assert caught.type is TypeError or caught.value.code == code
    with pytest.raises(annulus.Error) as caught:
        dt.nearest_vertex(some)
    assert caught.value.vertices == (1,)
    dt.remove(np.arange(30))
    assert np.all(dt.find_simplex(xi)[0] == -1) and np.all(np.isnan(dt.interpolate(values, xi)))
    with pytest.raises(annulus.Error, match="no vertex") as caught:
        dt.nearest_vertex(xi)
    assert caught.value.code == "too_few"


def test_points_and_positions_may_be_given_far_away():
    rng = np.random.default_rng(3)
    x = rng.random((500, 2)) + rng.integers(-10**6, 10**6, (500, 2))
    dt = annulus.MovingDelaunay(x, box=[1, 1])
    near = annulus.MovingDelaunay(x % 1, box=[1, 1])
    xi = rng.random((1000, 2))
    vertices, shifts = dt.nearest_vertex(xi + 10**5)
    same, by = near.nearest_vertex(xi)
    assert np.array_equal(vertices, same)
    assert np.abs(dt.points[vertices] + shifts - 10**5 - (near.points[same] + by)).max() < 1e-9
    values = rng.random(500)
    assert dt.interpolate(values, xi - 10**5) == pytest.approx(near.interpolate(values, xi), rel=1e-4)
