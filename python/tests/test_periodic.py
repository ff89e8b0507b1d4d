# SPDX-License-Identifier: GPL-3.0-or-later
"""MovingDelaunay with a box: crystals, lists, moves, errors, and what is not there."""

import contextlib
import copy
import pickle
import warnings
from types import SimpleNamespace as Thing

import annulus
import numpy as np
import pytest

FCC = np.array([[0, 0, 0], [.5, .5, 0], [.5, 0, .5], [0, .5, .5]])
BCC = np.array([[0, 0, 0], [.5, .5, .5]])
TILTED = np.array([[2.0, 0, 0], [0.5, 1.5, 0], [-0.25, 0.5, 1.25]])


def points(n, d=3, seed=0):
    return np.random.default_rng(seed).random((n, d))


def test_crystals_have_their_neighbours_and_volumes():
    for basis, count in ((FCC, 12), (BCC, 14)):
        cells = np.stack(np.meshgrid(*[np.arange(2)] * 3), -1).reshape(-1, 1, 3)
        x = (basis + cells).reshape(-1, 3)
        dt = annulus.MovingDelaunay(x, box=[2, 2, 2])
        assert isinstance(dt, annulus.PeriodicDelaunay)
        assert np.all(dt.neighbor_counts() == count)
        assert np.all(dt.neighbor_counts(0.0, strict=False) >= count)
        assert np.allclose(dt.voronoi_volumes(), 1 / len(basis), rtol=1e-9)
        assert dt.audit() and dt.audit().first_fault == ""


@pytest.mark.parametrize("box", [TILTED, TILTED[[1, 0, 2]], -TILTED, np.diag(TILTED)])
def test_the_lists_agree_with_points_and_box(box):
    vectors = np.diag(box) if box.ndim == 1 else box
    x = (5 * points(60) - 2) @ vectors
    dt = annulus.MovingDelaunay(x, box=box, threads=2)
    assert np.allclose(dt.points, x, atol=1e-12) and np.allclose(dt.box, vectors)
    i, j, d, D, S, A = dt.neighbor_list("ijdDSA")
    assert np.array_equal(D, dt.points[j] - dt.points[i] + S @ dt.box) or np.allclose(
        D, dt.points[j] - dt.points[i] + S @ dt.box, atol=1e-12)
    assert np.allclose(d, np.linalg.norm(D, axis=1))
    assert np.array_equal(np.lexsort((S[:, 2], S[:, 1], S[:, 0], j, i)), np.arange(len(i)))
    both = {(*a, *s) for a, s in zip(zip(i, j), S.tolist())}
    assert both == {(b, a, *(-s for s in t)) for a, b, *t in both}
    volumes = dt.voronoi_volumes()
    assert abs(volumes.sum() - abs(np.linalg.det(dt.box))) < 1e-9
    assert np.allclose(np.bincount(i, A * d / 6, 60), volumes)
    assert np.array_equal(dt.neighbor_counts(), np.bincount(i[A > 0], minlength=60))
    assert np.array_equal(dt.neighbor_list("S"), S)
    assert [a.dtype for a in dt.neighbor_list("Sid")] == [np.int32, np.int32, np.float64]


@pytest.mark.parametrize("d", [2, 3])
def test_simplices_with_offsets_are_positive_fill_the_box_and_meet(d):
    dt = annulus.MovingDelaunay(3 * points(30, d), box=np.full(d, 1.0))
    assert dt.simplex_offsets.dtype == np.int8 and dt.simplex_offsets.shape == (dt.nsimplex, d + 1, d)
    corners = dt.points[dt.simplices] + dt.simplex_offsets @ dt.box
    volume = np.linalg.det(corners[:, 1:] - corners[:, :1])
    assert np.all(volume > 0) and np.isclose(volume.sum(), 2 if d == 2 else 6)
    assert np.all(dt.simplex_offsets.min(axis=1) == 0)
    beyond, moved = dt.neighbors, dt.neighbor_offsets
    for c in range(dt.nsimplex):
        for k in range(d + 1):
            m = beyond[c, k]
            other = dt.points[dt.simplices[m]] + (dt.simplex_offsets[m] + moved[c, k]) @ dt.box
            common = [p for p in corners[c] if np.any(np.all(np.isclose(other, p), axis=1))]
            assert len(common) == d
    assert (dt.ndim, dt.npoints, dt.nvertices, dt.strategy) == (d, 30, 30, "auto")


def test_moves_change_points_and_box_and_failed_ones_change_nothing():
    x = points(50)
    dt = annulus.MovingDelaunay(x, box=[1, 1, 1])
    result = dt.move(x + 0.7)
    assert isinstance(result, annulus.MoveResult) and (result.asked, result.kept_in_place) == (50, 50)
    shaken = dt.move(x @ np.diag([1, 1, -1]))
    assert (shaken.asked, shaken.rebuilt) == (50, 50)
    result = dt.move(x + 0.7)
    with pytest.raises(annulus.Error, match="with a periodic box") as caught:
        result.changed_simplices
    assert caught.value.code == "usage" and pickle.loads(pickle.dumps(result)).asked == 50
    assert np.allclose(dt.points, x + 0.7)
    dt.move(x @ TILTED, box=TILTED)
    fresh = annulus.MovingDelaunay(x @ TILTED, box=TILTED)
    for ours, theirs in zip(dt.neighbor_list(), fresh.neighbor_list()):
        assert np.array_equal(ours, theirs)
    before = dt.points, dt.box, dt.simplices
    y = x @ TILTED
    y[8] = y[3] + TILTED[0] - 2 * TILTED[2]
    with pytest.raises(annulus.Error) as caught:
        dt.move(y)
    assert (caught.value.code, caught.value.vertices) == ("duplicate_point", (3, 8))
    for bad, box, code in ((x[:7], None, "wrong_size"), (x, [1, 1, 0], "usage"), (x, [1, np.nan, 1], "not_finite"),
                           (x, [1, 1], "wrong_size"), (x[:, :2], None, "wrong_size"),
                           (x, [[1, 0, 0], [1e4, 1, 0], [0, 0, 1]], "usage")):
        with pytest.raises(annulus.Error) as caught:
            dt.move(bad, box)
        assert caught.value.code == code
    for old, new in zip(before, (dt.points, dt.box, dt.simplices)):
        assert np.array_equal(old, new)


def test_an_object_with_a_box_of_its_own_takes_the_one_that_is_given():
    atoms = Thing(positions=FCC, cell=np.eye(3), pbc=np.array([True] * 3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        dt = annulus.MovingDelaunay(atoms, box=atoms.cell)
    assert np.all(dt.neighbor_counts() == 12)
    with pytest.warns(annulus.OpenBoundariesWarning):
        annulus.MovingDelaunay(atoms)


def test_few_points_and_none():
    for n in range(4):
        dt = annulus.MovingDelaunay(points(n), box=[1, 1, 1])
        assert dt.audit() and len(dt.neighbor_list("i")) == (0 if n == 0 else 2 * (dt.nsimplex + n))
    assert repr(annulus.MovingDelaunay(points(1), box=[1, 1, 1])) == "<PeriodicDelaunay: 1 vertex in a box in 3D>"


def arrays_of(dt):
    out = [dt.points, dt.box, dt.simplices, dt.neighbors, *dt.neighbor_list(), dt.voronoi_volumes(),
           *dt._mesh.state()]
    with contextlib.suppress(annulus.Error):  # offsets that do not fit
        out += [dt.simplex_offsets, dt.neighbor_offsets]
    return out


@pytest.mark.parametrize("points, box", [
    (3 * points(20), TILTED),
    (points(20) + 1e6 * np.arange(20)[:, None], [.3, .7, 1.1]),  # far beyond eight boxes
    ([[0.09999999999811848, 0.04999999999999982], [30000.1, 0.05]], [.3, .3]),  # rounded, they are one point
    (points(9) @ (np.eye(3) + 1 / 3), np.eye(3) + 1 / 3),
    (points(0, 2), [.1, .1])])
def test_copies_and_pickles_are_the_same_bit_for_bit(points, box):
    dt = annulus.MovingDelaunay(np.array(points), box=box, threads=2)
    dt.note = "mine"
    for other in (pickle.loads(pickle.dumps(dt)), copy.deepcopy(dt), copy.copy(dt),
                  pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(dt, 2))))):
        assert type(other) is annulus.PeriodicDelaunay and other.note == "mine" and other._threads == 2
        ours, theirs = arrays_of(dt), arrays_of(other)
        assert len(ours) == len(theirs)
        for one, two in zip(ours, theirs):
            assert one.dtype == two.dtype and one.tobytes() == two.tobytes()


def test_pickles_of_versions_before_are_read_and_wrong_states_refused():
    dt = annulus.MovingDelaunay(points(20), box=TILTED)

    class Old:
        def __reduce__(self):
            return annulus.PeriodicDelaunay, (dt.points, dt.box, 1)

    assert np.array_equal(pickle.loads(pickle.dumps(Old())).points, dt.points)
    state = dt.__getstate__()
    new = annulus.PeriodicDelaunay.__new__
    for change in ({"format": 2}, {"places": dt.points + 5}, {"places": dt.points + 1e-17},
                   {"images": np.full((20, 3), 2**30)}, {"images": np.full((20, 3), 2**40)},
                   {"images": np.zeros((19, 3), int)}, {"vectors": np.zeros((3, 3))}):
        with pytest.raises(annulus.Error):
            new(annulus.PeriodicDelaunay).__setstate__(state | change)
    with pytest.raises(annulus.Error, match="state must be"):
        new(annulus.PeriodicDelaunay).__setstate__({"format": 1})
    assert repr(new(annulus.PeriodicDelaunay)) == "<PeriodicDelaunay: not initialised>"


def test_points_that_are_far_away_have_right_lists_and_offsets_that_do_not_fit_are_refused():
    x = points(20)
    far = x + 1000 * np.arange(20)[:, None]
    dt = annulus.MovingDelaunay(far, box=[1, 1, 1])
    i, j, D, S = dt.neighbor_list("ijDS")
    assert np.allclose(D, far[j] - far[i] + S, atol=1e-9)
    assert dt.audit() and dt.simplices.shape == dt.neighbors.shape == (dt.nsimplex, 4)
    for name in ("simplex_offsets", "neighbor_offsets"):
        with pytest.raises(annulus.Error, match="does not fit int8") as caught:
            getattr(dt, name)
        assert caught.value.code == "too_large"
    for apart, fits in ((126, True), (127, False)):
        two = annulus.MovingDelaunay([[.25, .25], [.75 + apart, .5]], box=[1, 1])
        assert hasattr(two, "simplices")
        if fits:
            assert two.simplex_offsets.max() == 127
        else:
            with pytest.raises(annulus.Error, match="128 boxes does not fit"):
                two.simplex_offsets


def test_thin_boxes_off_the_axes_are_right_or_refused():
    thin = [[0.9771616619466469, 0.21249726215099116], [-2.1249726215099115e-09, 9.77161661946647e-09]]
    with pytest.raises(annulus.Error, match="too thin") as caught:
        annulus.MovingDelaunay([[0., 0.]], box=thin)
    assert caught.value.code == "usage"
    thick = np.array([thin[0], 100 * np.array(thin[1])])
    assert annulus.MovingDelaunay([[0., 0.]], box=thick).audit()


def test_flags_of_an_object_have_to_agree_with_the_box():
    for flags in ([True, True, False], [False] * 3, [1, 1, 0]):
        slab = Thing(positions=FCC, cell=np.eye(3), pbc=np.array(flags))
        with pytest.raises(annulus.NotAvailableError, match="give its array of positions"):
            annulus.MovingDelaunay(slab, box=slab.cell)
        dt = annulus.MovingDelaunay(slab.positions, box=slab.cell)
        with pytest.raises(annulus.NotAvailableError, match="all are periodic"):
            dt.move(slab)
    ovito = Thing(particles=Thing(positions=FCC), cell=Thing(pbc=(True, True, False)))
    with pytest.raises(annulus.NotAvailableError):
        annulus.MovingDelaunay(ovito, box=[1, 1, 1])


@pytest.mark.parametrize("d", [2, 3])
def test_points_come_and_go(d):
    box = np.eye(d) + 0.25 * np.tri(d, k=-1)
    x = points(30, d) @ box
    dt = annulus.MovingDelaunay(np.empty((0, d)), box=box)
    assert np.array_equal(dt.insert(x[:3]), [0, 1, 2]) and dt.insert(x[3:]).dtype == np.int32
    fresh = annulus.MovingDelaunay(x, box=box)
    for ours, theirs in zip(dt.neighbor_list(), fresh.neighbor_list()):
        assert np.array_equal(ours, theirs)
    dt.remove([4, 20])
    dt.remove(np.array([9]))
    assert (dt.npoints, dt.nvertices) == (30, 27) and "27 vertices" in repr(dt)
    free = [4, 9, 20]
    assert np.array_equal(np.flatnonzero(~dt.is_vertex), free) and dt.is_vertex.dtype == bool
    assert np.all(np.isnan(dt.points[free])) and np.all(np.isnan(dt.voronoi_volumes()[free]))
    assert np.all(dt.neighbor_counts()[free] == 0) and not np.isin(dt.simplices, free).any()
    assert np.isclose(np.nansum(dt.voronoi_volumes()), 1) and dt.audit()
    y = x + 0.01
    y[free] = np.nan  # not read
    assert dt.move(y).asked == 27
    other = pickle.loads(pickle.dumps(dt))
    for one in (dt, other):
        assert np.array_equal(one.insert(x[:4] + 0.3), [9, 20, 4, 30]) and one.audit()
    assert np.array_equal(dt.neighbor_list("i"), other.neighbor_list("i"))
    before = dt.points, dt.neighbor_list("S")
    for bad, code, named in (([x[7] + 0.01 - box[1]], "duplicate_point", (7,)), (x[[8, 8]], "duplicate_point", ()),
                             (x[:, :1], "wrong_size", ()), ([x[0] + 0.5, x[0] * np.nan], "not_finite", (1,)),
                             ([x[0] + 0.5, x[0] + 1e40], "out_of_domain", (1,))):
        with pytest.raises(annulus.Error) as caught:
            dt.insert(bad)
        assert (caught.value.code, caught.value.vertices) == (code, named)
    for bad, named in (([1, 31], (31,)), ([-1], (-1,)), ([2, 5, 2], (2,))):
        with pytest.raises(annulus.Error) as caught:
            dt.remove(bad)
        assert (caught.value.code, caught.value.vertices) == ("unknown_vertex", named)
    assert np.array_equal(before[0], dt.points, equal_nan=True) and np.array_equal(before[1], dt.neighbor_list("S"))
    dt.remove(np.flatnonzero(dt.is_vertex))
    assert (dt.nvertices, dt.nsimplex, dt.npoints) == (0, 0, 31) and dt.audit()


def test_find_simplex_names_the_image_that_contains_the_point():
    dt = annulus.MovingDelaunay(points(80) @ TILTED, box=TILTED)
    xi = (6 * points(200, seed=5) - 3) @ TILTED
    simplices, shifts = dt.find_simplex(xi)
    assert simplices.dtype == shifts.dtype == np.int32 and shifts.shape == (200, 3)
    corners = dt.points[dt.simplices[simplices]] + (dt.simplex_offsets[simplices] + shifts[:, None]) @ dt.box
    weights = np.linalg.solve((corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1), (xi - corners[:, 0])[..., None])
    assert np.all(weights > -1e-9) and np.all(weights.sum(axis=1) < 1 + 1e-9)
    assert dt.find_simplex([[np.nan, 0, 0]])[0][0] == -1 and len(dt.find_simplex(np.empty((0, 3)))[0]) == 0
    with pytest.raises(annulus.Error) as caught:
        dt.find_simplex([[0, 0, 0], [0, np.inf, 0]])
    assert (caught.value.code, caught.value.vertices) == ("not_finite", (1,))


@pytest.mark.parametrize("d", [2, 3])
def test_some_points_move(d):
    rng = np.random.default_rng(24)
    x = rng.random((300, d))
    dt = annulus.MovingDelaunay(x, box=np.ones(d))
    for k in range(20):
        which = rng.choice(300, size=1 if k % 2 else 7, replace=False)
        x = dt.points
        x[which] += rng.standard_normal((len(which), d)) * (0.01 if k < 10 else 2.0)
        result = dt.move(x[which], indices=which)
        assert (result.asked, result.reinserted) == ((1, 1) if k % 2 else (300, 0) if k < 10 else (7, 7))
        assert np.allclose(dt.points, x, atol=1e-12) and dt.audit()
        fresh = annulus.MovingDelaunay(dt.points, box=np.ones(d))
        assert cells_by_name(dt.simplices, dt.simplex_offsets) == cells_by_name(fresh.simplices, fresh.simplex_offsets)
    before = dt.points
    dt.move(before[[1, 0]], indices=[0, 1])  # at the same time
    assert np.allclose(dt.points[[1, 0]], before[:2], atol=1e-12) and dt.audit()
    before = dt.points
    for wrong, code in ((lambda: dt.move(before[:1], indices=[1]), "duplicate_point"),
                        (lambda: dt.move(before[:1] + 3, indices=[1]), "duplicate_point"),
                        (lambda: dt.move(before[:1], indices=[300]), "unknown_vertex"),
                        (lambda: dt.move(before[:2], indices=[0]), "wrong_size"),
                        (lambda: dt.move(before[:1] * np.nan, indices=[4]), "not_finite"),
                        (lambda: dt.move(before[:1], np.ones(d), indices=[0]), "usage")):
        with pytest.raises(annulus.Error) as caught:
            wrong()
        assert caught.value.code == code and np.array_equal(dt.points, before)
    assert dt.move(np.empty((0, d)), indices=[]).asked == 0


def cells_by_name(simplices, offsets):
    """Each as its corners, the least vertex at offset 0, of several of these the least form."""
    names = set()
    for v, o in zip(simplices.tolist(), offsets.astype(int)):
        names.add(min(tuple(sorted((w, *p) for w, p in zip(v, (o - o[k]).tolist())))
                      for k in range(len(v)) if v[k] == min(v)))
    assert len(names) == len(simplices)
    return names


@pytest.mark.parametrize("d", [2, 3])
def test_simplices_that_a_call_creates_and_removes(d):
    rng = np.random.default_rng(14)
    x = rng.random((80, d)) * 0.98 + 0.01
    dt = annulus.MovingDelaunay(x, box=np.ones(d), report_changes=True)
    assert [len(a) for a in (*dt.changed_simplices, *dt.removed_simplices)] == [0] * 4
    changed = 0
    for call in [*[lambda: dt.move(np.clip(dt.points + 0.02 * rng.standard_normal(x.shape), 0.001, 0.999))] * 4,
                 lambda: dt.insert(rng.random((3, d))), lambda: dt.remove([2, 81])]:
        before = cells_by_name(dt.simplices, dt.simplex_offsets)
        call()
        after = cells_by_name(dt.simplices, dt.simplex_offsets)
        simplices, offsets = dt.changed_simplices
        assert simplices.dtype == offsets.dtype == np.int32 and offsets.shape == (len(simplices), d + 1, d)
        created, removed = cells_by_name(simplices, offsets), cells_by_name(*dt.removed_simplices)
        turned = created & removed  # over
        assert created - turned == after - before and removed - turned == before - after
        corners = dt.points[simplices] + offsets
        assert np.all(np.linalg.det(corners[:, 1:] - corners[:, :1]) > 0)
        changed += len(created)
    assert changed > 0
    assert len(pickle.loads(pickle.dumps(dt)).changed_simplices[0]) == 0
    for name in ("changed_simplices", "removed_simplices"):
        with pytest.raises(annulus.Error, match="report_changes") as caught:
            getattr(annulus.MovingDelaunay(x, box=np.ones(d)), name)
        assert caught.value.code == "usage"


def test_pairs_that_a_call_makes_and_breaks():
    rng = np.random.default_rng(4)
    x = points(60)
    dt = annulus.MovingDelaunay(x, box=[1, 1, 1], report_changes=True)
    assert [len(a) for a in (*dt.pairs_made, *dt.pairs_broken)] == [0] * 6

    def pairs():  # by vectors of the fixed box, whatever images the points are
        i, j, S = dt.neighbor_list("ijS")
        home = np.where(dt.is_vertex[:, None], np.floor(x[:dt.npoints]), 0).astype(int)
        return {(a, b, *s) for a, b, s in zip(i.tolist(), j.tolist(), (S + home[j] - home[i]).tolist())}

    x = np.vstack((x, rng.random((1, 3))))
    before = pairs()
    turns = np.zeros((61, 3), int)
    for turn in range(3):
        turns = rng.integers(-3, 4, x.shape)
        x = np.mod(x, 1) * 0.98 + 0.01 + turns  # no point crosses a border of the box
        dt.move(x[:60])
        after = pairs()
        i, j, S = dt.pairs_made
        assert S.dtype == np.int32 and S.shape == (len(i), 3) and np.all(i <= j)
        made = {(a, b, *s) for a, b, s in zip(i.tolist(), j.tolist(), (S + turns[j] - turns[i]).tolist())}
        assert made == {p for p in after - before if p[:2] != p[1::-1] and p[0] < p[1]}
        assert len(dt.pairs_broken[0]) == sum(p[0] < p[1] for p in before - after)
        before = after
    dt.insert(x[60:])
    i, j, S = dt.pairs_made
    assert np.all((j == 60)) and len(i) == np.sum(dt.neighbor_list("i") == 60)
    dt.remove([60])
    assert np.array_equal(dt.pairs_broken[0], i) and np.array_equal(dt.pairs_broken[2], S)
    assert pickle.loads(pickle.dumps(dt)).pairs_made[0].shape == (0,)
    with pytest.raises(annulus.Error, match="report_changes") as caught:
        annulus.MovingDelaunay(points(9), box=[1, 1, 1]).pairs_made
    assert caught.value.code == "usage"


def test_what_is_not_there_says_so():
    dt = annulus.MovingDelaunay(points(9), box=[1, 1, 1])
    for name in ("convex_hull", "displacements"):
        with pytest.raises(annulus.NotAvailableError, match=name):
            getattr(dt, name)
        with pytest.raises(NotImplementedError):
            getattr(dt, name)
        assert not hasattr(dt, name) and getattr(dt, name, 7) == 7
    for name in dir(annulus.MovingDelaunay):  # all that there is with open boundaries is there, or said to be missing
        if not name.startswith("_") and not hasattr(dt, name):
            with pytest.raises(annulus.NotAvailableError, match=name):
                getattr(dt, name)
    for options in ({"strategy": "in-place"}, {"tolerance": "paper", "strategy": "paper"}):
        with pytest.raises(annulus.NotAvailableError):
            annulus.MovingDelaunay(points(9), box=[1, 1, 1], **options)
    with pytest.raises(AttributeError):
        dt.nonsense
    with pytest.raises(annulus.Error, match="quantities"):
        dt.neighbor_list("ijx")

    class Derived(annulus.MovingDelaunay):
        pass

    with pytest.raises(annulus.NotAvailableError, match="Derived"):
        Derived(points(9), box=[1, 1, 1])
    with pytest.raises(TypeError):
        annulus.MovingDelaunay(points(9), box=[1, 1, 1], colour="red")


@pytest.mark.parametrize("d", [2, 3])
def test_tolerances(d):
    """Those of every strategy are safe; a box that is strained with its points leaves nearly all within theirs."""
    rng = np.random.default_rng(d)
    x, box = points(80, d), np.ones(d)
    for strategy in ("auto", "signs", "tolerances"):
        dt = annulus.MovingDelaunay(x, box=box, strategy=strategy)
        assert dt.strategy == strategy
        for step in range(4):
            scale = 1 + 1e-5 * step
            result = dt.move(scale * x, scale * box)
        assert (result.within_tolerance > 70) == (strategy != "signs")
        assert pickle.loads(pickle.dumps(dt)).strategy == strategy
        tolerances = dt.tolerances
        assert tolerances.shape == (80,) and (tolerances >= 0).all() and np.median(tolerances) > 1e-4
        way = rng.standard_normal(x.shape)
        way *= 0.999 * tolerances[:, None] / np.linalg.norm(way, axis=1)[:, None]
        before = {tuple(sorted(s)) for s in dt.simplices.tolist()}
        assert dt.move(dt.points + way).flipped == 0
        assert {tuple(sorted(s)) for s in dt.simplices.tolist()} == before
        dt.remove(3)
        assert np.isnan(dt.tolerances[3])
    with pytest.raises(annulus.Error, match="strategy"):
        annulus.PeriodicDelaunay(x, box, strategy="rebuild")


@pytest.mark.parametrize("d", [2, 3])
def test_images_of_one_another_are_one_vertex_on_request(d):
    box = np.diag([1.0, 2.0, 4.0][:d])
    x = np.random.default_rng(d).integers(0, 64, (30, d)) / 64 @ box
    x = np.unique(x, axis=0)
    shifts = np.random.default_rng(3).integers(-3, 4, (2 * len(x), d))
    both = np.concatenate([x, x]) + shifts @ box
    with pytest.raises(annulus.Error) as e:
        annulus.MovingDelaunay(both, box=box)
    assert e.value.code == "duplicate_point"
    dt = annulus.MovingDelaunay(both, box=box, merge_duplicates=True)
    assert dt.npoints == len(x) and np.array_equal(dt.points, both[:len(x)])
    assert np.array_equal(dt.vertex_of_input, np.tile(np.arange(len(x)), 2))
    for other in (pickle.loads(pickle.dumps(dt)), copy.copy(dt)):
        assert np.array_equal(other.vertex_of_input, dt.vertex_of_input)
    dt.remove([3])
    assert len(dt.vertex_of_input) == len(both)
    found = annulus.degeneracy(both, True, box=box, values=True)
    assert (found["points"], found["vertices"]) == (len(both), len(x))
    once = annulus.degeneracy(both[:len(x)], box=box, values=True)
    assert np.array_equal(found["values"]["bicells"]["points"], once["values"]["bicells"]["points"])
