# SPDX-License-Identifier: GPL-3.0-or-later
"""`annulus.analyze`: what is found in frames, beside triangulations that are made of each frame alone."""

import doctest
import pickle

import annulus
import annulus._analyze
import numpy as np
import pytest

WHAT = ("volumes", "neighbors", "pairs", "events", "moves")
FCC = np.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])


def walk(d, n=80, frames=5, reach=0.03):
    rng = np.random.default_rng(d)
    return rng.random((n, d)) + reach * np.cumsum(rng.standard_normal((frames, n, d)), axis=0)


def brute_pairs(x, box=None, min_area=0.0):
    """The pairs of a frame by point and shift, each in both directions, with distance and area."""
    dt = annulus.MovingDelaunay(x, box=box)
    i, j, d, shift, area = dt.neighbor_list("ijdSA")
    return {(*row[:2], tuple(row[2])): row[3:] for row in zip(i.tolist(), j.tolist(), shift.tolist(), d, area)
            if row[4] > min_area}


def both(pairs):
    out = {}
    for i, j, d, a, s in pairs[["i", "j", "distance", "area", "shift"]]:
        assert i <= j
        for key in ((i, j, tuple(s.tolist())), (j, i, tuple((-s).tolist()))):
            assert key not in out
            out[key] = (d, a)
    return out


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("min_area", [0.0, 0.05])
@pytest.mark.parametrize("n", [4, 80])
def test_each_frame_is_as_if_alone(d, periodic, min_area, n):
    x = walk(d, n)
    box = [1.0, 1.1, 1.2][:d] if periodic else None
    a = annulus.analyze(x, WHAT[:4], box=box, min_area=min_area)
    assert len(a) == len(x) and a.frames.tolist() == list(range(len(x))) and np.isnan(a.times).all()
    assert a.volumes.shape == a.neighbors.shape == (len(x), n) and a.npoints.tolist() == [n] * len(x)
    before = None
    for k, frame in enumerate(a):
        dt = annulus.MovingDelaunay(x[k], box=box)
        assert np.allclose(a.volumes[k], dt.voronoi_volumes(), rtol=1e-9, atol=0)
        assert np.array_equal(a.neighbors[k], dt.neighbor_counts(min_area=min_area))
        expected, found = brute_pairs(x[k], box, min_area), both(frame.pairs)
        assert found.keys() == expected.keys()
        assert all(np.allclose(found[key], expected[key], rtol=1e-9) for key in found)
        now = {key[:2] for key in expected if key[0] < key[1]}
        made = {(int(e["i"]), int(e["j"])) for e in frame.events if e["made"]}
        broken = {(int(e["i"]), int(e["j"])) for e in frame.events if not e["made"]}
        assert len(made) + len(broken) == len(frame.events) and (frame.events["frame"] == k).all()
        assert (made, broken) == ((now - before, before - now) if before is not None else (set(), set()))
        before = now
        if periodic:
            assert np.array_equal(frame.box, np.diag(box)) and np.array_equal(a.boxes[k], frame.box)
            assert np.isclose(frame.volumes.sum(), np.prod(box))
        else:
            assert frame.box is None and np.isnan(a.boxes[k]).all()
    assert len(a.events) > 0 or n == 4
    assert np.array_equal(a.pairs["frame"], np.repeat(np.arange(len(x)), [len(f.pairs) for f in a]))


def test_moves():
    x = walk(2, 300, 4, 1e-4)
    a = annulus.analyze(x, "moves")
    dt = annulus.MovingDelaunay(x[0])
    expected = [dict.fromkeys(a.moves.dtype.names[1:], 0)] + [dt.move(y).as_dict() for y in x[1:]]
    assert [dict(zip(a.moves.dtype.names, row)) for row in a.moves.tolist()] == [
        {"frame": k, **counts} for k, counts in enumerate(expected)]
    assert a.moves["asked"].tolist() == [0, 300, 300, 300]
    boxed = annulus.analyze(x, "moves", box=[9, 9]).moves
    assert boxed["asked"].tolist() == [0, 300, 300, 300]
    assert (sum(boxed[name] for name in ("within_tolerance", "kept_in_place", "flipped", "rebuilt"))
            == boxed["asked"]).all()


def test_crystals_need_a_threshold():
    cells = np.stack(np.meshgrid(*[np.arange(3)] * 3), -1).reshape(-1, 1, 3)
    still = (FCC + cells).reshape(-1, 3)
    x = still + 1e-3 * np.random.default_rng(5).standard_normal((4, *still.shape))
    assert (annulus.analyze([still], box=[3, 3, 3]).neighbors == 12).all()
    grid = np.indices((5, 5)).reshape(2, -1).T.astype(float)
    square = annulus.analyze([grid], ("neighbors", "pairs"))
    assert square.neighbors[0].max() == 4 and len(square.pairs) == 40, "open: empty facets do not count"
    noisy = annulus.analyze(x, box=[3, 3, 3])
    quiet = annulus.analyze(x, box=[3, 3, 3], min_area=0.01)
    assert len(noisy.events) > 100 and len(quiet.events) == 0 and (quiet.neighbors == 12).all()


def test_clip():
    x = np.clip(walk(2), 0.01, 0.99) + 1e-4 * walk(2, reach=0)
    a = annulus.analyze(x, WHAT, clip=[[0, 0], [1, 1]])
    assert np.allclose(a.volumes.sum(axis=1), 1) and np.isfinite(a.pairs["area"]).all()
    part = annulus.analyze(x[0], ("pairs", "neighbors"), clip=[[0.3, 0.3], [0.6, 0.6]])
    assert 0 < len(part.pairs) < len(a.pairs[a.pairs["frame"] == 0]) and (part.pairs["area"] > 0).all()
    assert part.neighbors.sum() == 2 * len(part.pairs)
    for what in WHAT:  # refused also where it is not used
        with pytest.raises(TypeError, match="frame 0: clip must be an array"):
            annulus.analyze(x, what, clip=3)
    with pytest.raises(annulus.Error, match="frame 0: clip is for open boundaries"):
        annulus.analyze(x, clip=[[0, 0], [1, 1]], box=[1, 1])


def test_numbers_of_points_may_change():
    x = walk(3)
    a = annulus.analyze([x[0], x[1][:50], x[2][:50], x[3]], WHAT[:3])
    assert a.npoints.tolist() == [80, 50, 50, 80] and a.volumes.shape == (4, 80)
    assert np.isnan(a.volumes[1, 50:]).all() and not np.isnan(a.volumes[1, :50]).any()
    assert (a.neighbors[2, 50:] == -1).all() and np.array_equal(a.neighbors[3],
                                                                annulus.analyze(x[3]).neighbors[0])
    with pytest.raises(annulus.Error, match="frame 1: there are 50 points, 80 in the frame before") as e:
        annulus.analyze([x[0], x[1][:50]])
    assert e.value.code == "wrong_size"
    with pytest.raises(annulus.Error, match="frame 1: points have 2 coordinates, those of the frame before 3"):
        annulus.analyze([x[0], x[1][:, :2]])


def test_only_what_was_named():
    a = annulus.analyze(walk(2), "volumes")
    assert a.what == a[0].what == ("volumes",) and hasattr(a, "volumes")
    for thing in (a, a[0]):
        assert not hasattr(thing, "events") and not hasattr(thing, "other")
        with pytest.raises(AttributeError, match="pairs were not computed"):
            thing.pairs
    assert annulus.analyze(walk(2), {"moves", "pairs"}).what == ("pairs", "moves")
    assert "5 frames, volumes" in repr(a) and "frame 3, 80 points in 2D" in repr(a[3])


def test_pickles():
    a = annulus.analyze(walk(2), WHAT)
    b = pickle.loads(pickle.dumps(a))
    assert b.what == a.what and np.array_equal(b.volumes, a.volumes) and np.array_equal(b.pairs, a.pairs)


def test_stream_keeps_nothing():
    x, taken = walk(2), []

    def source():
        for k, y in enumerate(x):
            taken.append(k)
            yield y

    whole = annulus.analyze(x)
    stream = annulus.analyze(source(), stream=True)
    assert isinstance(stream, annulus.AnalysisStream) and taken == [] and "volumes" in repr(stream)
    for k, frame in enumerate(stream):
        assert taken == list(range(k + 1))
        assert frame.frame == k and np.array_equal(frame.volumes, whole.volumes[k])
        assert np.array_equal(frame.events, whole[k].events)
    assert len(taken) == len(x)


def test_errors_name_the_frame():
    x = walk(2)
    x[3, 7] = x[3, 9]
    with pytest.raises(annulus.Error, match="^frame 3: .*7 and 9") as e:
        annulus.analyze(x)
    assert e.value.code == "duplicate_point" and e.value.vertices == (7, 9)
    x[2, 5] = np.nan
    stream = annulus.analyze(x, stream=True, start=1)
    assert next(stream).frame == 1
    with pytest.raises(annulus.Error, match="^frame 2: ") as e:
        next(stream)
    assert e.value.code == "not_finite"
    with pytest.raises(TypeError, match="^frame 1: points must be numbers"):
        annulus.analyze([x[0], x[0].astype(complex)])
    with pytest.raises(annulus.Error, match="^frame 0: the vectors of the box"):
        annulus.analyze(x, box=[1, 0])
    with pytest.raises(TypeError, match="masked"):
        annulus.analyze(np.ma.masked_array(x, False))


@pytest.mark.parametrize("arguments, code, words", [
    ({"what": "areas"}, "usage", "what must be one of"), ({"what": ()}, "usage", "what must name a quantity"),
    ({"min_area": -1}, "usage", "min_area"), ({"min_area": np.nan}, "usage", "min_area"),
    ({"box": "closed"}, "usage", "'open'"), ({"step": 0}, "usage", "step must be 1 or more"),
    ({"threads": 0}, "usage", "threads"), ({"start": 9}, "bad_input", "no frame between")])
def test_arguments(arguments, code, words):
    with pytest.raises(annulus.Error, match=words) as e:
        annulus.analyze(walk(2), **arguments)
    assert e.value.code == code


@pytest.mark.parametrize("arguments", [{"what": 3}, {"what": [3]}, {"stream": 2}, {"start": 1.5}, {"min_area": "1"}])
def test_types_of_arguments(arguments):
    with pytest.raises(TypeError, match=next(iter(arguments))):
        annulus.analyze(walk(2), **arguments)


def test_example():
    done = doctest.testmod(annulus._analyze)
    assert done.attempted > 0 and done.failed == 0
