# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of a wrong type or size: every argument of every public function gets one sentence that names it, and
never the binding's list of signatures."""

import decimal
import fractions
import importlib.util
import inspect
import typing

import annulus
import numpy as np
import pytest

X = np.random.default_rng(0).random((30, 2))


class Odd:
    """What is nothing in particular, and has a long name."""


Odd.__name__ = "O" * 500

WRONG = {
    "None": None, "str": "abc", "long str": "x" * 1000, "surrogates": "\udc80", "null character": "a\0b",
    "bytes": b"bytes", "object": object(), "long name": Odd(), "list of str": ["a", "b"], "list of None": [None, 1],
    "ragged": [[1, 2], [3]], "dict": {1: 2}, "empty dict": {}, "set": {1, 2}, "-1": -1, "2.5": 2.5, "nan": float("nan"),
    "inf": float("inf"), "2**100": 2**100, "-2**100": -(2**100), "10**5000": 10**5000, "1j": 1j, "True": True,
    "numpy's True": np.bool_(True), "2.0": 2.0, "numpy's 2.0": np.float64(2), "Decimal": decimal.Decimal(2),
    "Fraction": fractions.Fraction(1, 2), "function": lambda *a: False, "type": int, "generator": (i for i in range(3)),
    "datetime": np.datetime64("2020"), "cube": np.zeros((2, 2, 2)), "(3, 5)": np.arange(15.0).reshape(3, 5),
    "(0,)": np.zeros(0), "()": np.array(2.5), "np.str_": np.str_("abc"), "array of str": np.array(["a", "b"]),
    "complex": X.astype(complex), "objects": X.astype(object), "structured": np.zeros(3, dtype=[("a" * 30, float)] * 1),
    "many fields": np.zeros(3, dtype=[(f"field {k}", float) for k in range(99)]),
    "datetimes": np.zeros((3, 2), dtype="M8[s]"), "masked": np.ma.masked_less(X, 0.5), "truths": X > 0.5,
    "where": np.where(X[:, 0] > 0.5), "30 dimensions": np.zeros((1,) * 30), "long doubles": X.astype(np.longdouble),
    "module": np, "array": X, "pair": (X, np.arange(30).reshape(10, 3)), "pair of str": ("a", "b"), "one": (X,),
}

# A call of each public function that is right, and quick.
RIGHT = {
    "MovingDelaunay": (annulus.MovingDelaunay, {"points": X}),
    "MovingDelaunayBatch": (annulus.MovingDelaunayBatch, {"points": np.stack([X, X + 1])}),
    "PeriodicDelaunay": (annulus.PeriodicDelaunay, {"points": X, "box": [1.0, 1.5]}),
    "move": (lambda **named: annulus.MovingDelaunay(X).move(**named), {"points": X}),
    "move some": (lambda **named: annulus.MovingDelaunay(X).move(**named), {"points": X[:3] + 1, "indices": [1, 2, 3]}),
    "insert": (lambda **named: annulus.MovingDelaunay(X).insert(**named), {"points": X[:3] + 1}),
    "remove": (lambda **named: annulus.MovingDelaunay(X).remove(**named), {"indices": [1, 2]}),
    "find_simplex": (lambda **named: annulus.MovingDelaunay(X).find_simplex(**named), {"xi": X}),
    "recompute_tolerances": (lambda **named: annulus.MovingDelaunay(X).recompute_tolerances(**named), {}),
    "audit": (lambda **named: annulus.MovingDelaunay(X).audit(**named), {}),
    "voronoi_volumes": (lambda **named: annulus.MovingDelaunay(X).voronoi_volumes(**named), {"clip": [[0, 0], [1, 1]]}),
    "voronoi": (lambda **named: annulus.MovingDelaunay(X).voronoi(**named), {"clip": [[0, 0], [1, 1]]}),
    "voronoi_polytopes": (lambda **named: annulus.MovingDelaunay(X).voronoi_polytopes(**named),
                          {"clip": [[0, 0], [1, 1]]}),
    "voronoi_vjp": (lambda **named: annulus.MovingDelaunay(X).voronoi_vjp(**named), {"g": X[:, 0]}),
    "voronoi_jacobian": (lambda **named: annulus.MovingDelaunay(X).voronoi_jacobian(**named), {}),
    "neighbor_list": (lambda **named: annulus.MovingDelaunay(X).neighbor_list(**named),
                      {"quantities": "ijA", "clip": [[0, 0], [1, 1]]}),
    "neighbor_counts": (lambda **named: annulus.MovingDelaunay(X).neighbor_counts(**named),
                        {"min_area": 0.1, "strict": False, "clip": [[0, 0], [1, 1]]}),
    "nearest_vertex": (lambda **named: annulus.MovingDelaunay(X).nearest_vertex(**named), {"xi": X}),
    "interpolate": (lambda **named: annulus.MovingDelaunay(X).interpolate(**named), {"values": X[:, 0], "xi": X}),
    "t1": (annulus.t1, {"report": annulus.MovingDelaunay(X).move(X)}),
    "analyze": (annulus.analyze, {"source": [X, X], "what": "volumes", "clip": [[0, 0], [1, 1]]}),
    "analyze in a box": (annulus.analyze, {"source": [X, X], "box": [1.0, 1.5]}),
    "annulus.audit": (annulus.audit, {"points": X, "simplices": annulus.MovingDelaunay(X).simplices, "max_faults": 3}),
    "degeneracy": (annulus.degeneracy, {"points": X}),
    "counterexample": (annulus.counterexample, {}),
    "lloyd": (annulus.lloyd, {"points": 20, "iterations": 1}),
    "lloyd of points": (annulus.lloyd, {"points": X, "iterations": 1}),
    "nodt": (annulus.nodt, {"surface": "sphere", "vertices": 30, "iterations": 1}),
}
# What these are made of is not looked at: results, and exceptions.
PLAIN = {"Analysis", "AnalysisStream", "AuditResult", "BatchError", "Error", "Fault", "FrameResult", "LloydResult",
         "MoveResult", "MoveStatistics", "NodtResult", "NotAvailableError", "OpenBoundariesWarning", "TableWarning",
         "PeriodicPolytopes", "PeriodicVoronoi", "Voronoi", "VoronoiPolytopes"}
if importlib.util.find_spec("matplotlib"):
    RIGHT["plot"] = (lambda **named: annulus.MovingDelaunay(X[:5]).plot(**named), {"color_by": "neighbors"})
else:
    PLAIN |= {"plot"}

# What is right where it stands, and so may be refused for another reason: no indices are all; a class can be called;
# what it says then is its own; a name of a file is said in full.
NO_FAULT = {("move some", "indices"): {"None"}, ("lloyd", "callback"): {"type"},
            ("lloyd of points", "callback"): {"type"}, ("lloyd of points", "density"): {"type"},
            ("nodt", "callback"): {"type"}, ("nodt", "surface"): {"long str"}, ("analyze", "source"): {"long str"},
            ("analyze in a box", "source"): {"long str"}}
# Other names for what an argument is.
ALSO = {"domain": "polygon", "indices": "index", "source": "frame"}


def public_callables():
    for name in annulus.__all__:
        if callable(getattr(annulus, name)):
            yield "annulus." * hasattr(annulus.MovingDelaunay, name) + name, getattr(annulus, name)
    for name in dir(annulus.MovingDelaunay):
        if not name.startswith("_") and callable(getattr(annulus.MovingDelaunay, name)):
            yield name, getattr(annulus.MovingDelaunay, name)


def parameters():
    functions = dict(public_callables())
    for case, (_, right) in RIGHT.items():
        name = case.partition(" ")[0]
        for parameter in inspect.signature(functions[name]).parameters:
            if parameter != "self":
                yield pytest.param(case, parameter, id=f"{case}-{parameter}")


def test_every_public_function_is_here():
    assert {name for name, _ in public_callables()} == {case.partition(" ")[0] for case in RIGHT} | PLAIN
    for call, right in RIGHT.values():
        call(**right)


def complaint(call, arguments):
    """What is said against the arguments; nothing where they are taken."""
    try:
        call(**arguments)
    except (TypeError, ValueError) as e:  # annulus.Error is a ValueError
        return str(e)
    return None


@pytest.mark.parametrize(("case", "parameter"), list(parameters()))
def test_every_wrong_value_gets_a_sentence(case, parameter):
    call, right = RIGHT[case]
    refused = 0
    for name, value in WRONG.items():
        words = complaint(call, {**right, parameter: value})
        if words is None or name in NO_FAULT.get((case, parameter), ()):
            continue
        refused += 1
        assert (parameter in words or parameter.removesuffix("s") in words
                or ALSO.get(parameter, parameter) in words), (name, words)
        assert ("incompatible" not in words and "Invoked" not in words and "\n" not in words
                and len(words) < 300), (name, words)
    assert refused > len(WRONG) / 2


@pytest.mark.parametrize(("case", "arguments", "words"), [
    ("lloyd", {"density": "2"}, "density must be one of one, x2+y2, x2 or sin2; not '2'"),
    ("lloyd", {"density": X}, "a density that is an array or a function needs a polygon as domain, not a disc"),
    ("lloyd", {"iterations": 2.0}, "iterations must be a whole number, not 2.0 (float)"),
    ("lloyd", {"points": 2.5}, "points must be an array, not 2.5 (float)"),
    ("MovingDelaunay", {"threads": None}, "threads must be a whole number, not None"),
    ("MovingDelaunay", {"threads": True}, "threads must be a whole number, not True"),
    ("MovingDelaunay", {"threads": 0}, "threads must be 1 or more, not 0 (int)"),
    ("MovingDelaunay", {"threads": -3}, "threads must be 1 or more, not -3 (int)"),
    ("MovingDelaunay", {"threads": 2**31}, "threads must be at most 2147483647, not 2147483648 (int)"),
    ("MovingDelaunay", {"strategy": None},
     "strategy must be a str, one of auto, tolerances, tolerances-each, in-place, rebuild, relocate, relocate-flips, "
     "paper or paper-hybrid; not None"),
    ("MovingDelaunay", {"strategy": "best"},
     "strategy must be one of auto, tolerances, tolerances-each, in-place, rebuild, relocate, relocate-flips, paper or "
     "paper-hybrid; not 'best'"),
    ("MovingDelaunay", {"seed": -1}, "seed must be 0 or more, not -1 (int)"),
    ("MovingDelaunay", {"merge_duplicates": "no"}, "merge_duplicates must be True or False, not 'no'"),
    ("MovingDelaunay", {"points": None}, "points must be an array of numbers, not None"),
    ("remove", {"indices": np.where(X[:, 0] > 2)},
     "indices must have shape (k,), not (1, 0): of a tuple such as numpy.where gives take the element [0]"),
    ("remove", {"indices": 2.5}, "indices must be whole numbers, not an array of float64"),
    ("nodt", {"surface": None}, "surface must be 'sphere', a file or a pair, points and triangles; not None"),
    ("counterexample", {"delta": "0.01"}, "delta must be a real number, not '0.01'"),
])
def test_what_is_said(case, arguments, words):
    call, right = RIGHT[case]
    assert complaint(call, {**right, **arguments}) == words


ALL = annulus._arguments.STRATEGIES
IN_BOX = {"MovingDelaunay": ("auto", "signs", "tolerances", "rebuild"),
          "PeriodicDelaunay": ("auto", "signs", "tolerances")}


@pytest.mark.parametrize("strategy", [*ALL, "signs", "best", None])
@pytest.mark.parametrize("kind", list(IN_BOX))
def test_strategies_that_there_are_in_a_box(kind, strategy):
    """Those are taken, and the message for any other one names them."""
    def made():
        return getattr(annulus, kind)(X, box=[9] * X.shape[1], strategy=strategy)

    there = IN_BOX[kind]
    if strategy in there:
        assert made().strategy == ("auto" if strategy == "rebuild" else strategy)
        return
    names = f"one of {', '.join(there[:-1])} or {there[-1]}"
    with pytest.raises((annulus.Error, TypeError)) as caught:
        made()
    if strategy is None:
        assert str(caught.value) == f"strategy must be a str, {names}; not None"
    elif strategy in ALL and kind == "MovingDelaunay":
        assert str(caught.value) == (f"strategy='{strategy}' is not available with a periodic box: strategy must be "
                                     f"{names}")
        assert caught.type is annulus.NotAvailableError
    else:
        assert str(caught.value) == f"strategy must be {names}; not '{strategy}'"


@pytest.mark.parametrize(("tolerance", "words"), [
    ("paper", "tolerance='paper' is not available with a periodic box: tolerance must be certified"),
    ("floating", "tolerance='floating' is not available with a periodic box: tolerance must be certified"),
    ("exact", "tolerance must be certified; not 'exact'"),
    (3, "tolerance must be a str, certified; not 3 (int)"),
])
def test_tolerances_in_a_box_are_certified(tolerance, words):
    with pytest.raises((annulus.Error, TypeError)) as caught:
        annulus.MovingDelaunay(X, box=[9] * X.shape[1], tolerance=tolerance)
    assert str(caught.value) == words


def test_numbers_of_numpy_go_on_working():
    for kind in (np.int8, np.uint8, np.int32, np.uint64, np.int64):
        assert annulus.MovingDelaunay(X, threads=kind(2), seed=kind(3)).nvertices == 30
        assert annulus.lloyd(kind(20), kind(1), seed=kind(1)).points.shape == (20, 2)
    assert annulus.lloyd(20, 1, radius=np.float32(2), density=np.str_("x2")).points.shape == (20, 2)
    assert annulus.lloyd(20, 1, radius=2).points.shape == (20, 2)
    assert annulus.nodt("sphere", np.int16(30), np.uint8(0), gradation=np.float64(0.5), lock=np.int64(20),
                        allow_crossing=np.bool_(False)).points.shape[1] == 3
    assert annulus.counterexample(np.float32(0.015625))["delta"] == 0.015625
    assert annulus.MovingDelaunay(np.concatenate([X, X]), merge_duplicates=np.bool_(True)).nvertices == 30
    assert len(annulus.MovingDelaunay(X, report_changes=1).move(X).changed_simplices) == 0


# Their stubs have their types.
COMPILED = (annulus.MoveResult, annulus.MoveStatistics)


def test_hints_can_be_read():
    """Every public class, function, method and property has types, and they are those of names that exist."""
    for name in annulus.__all__:
        thing = getattr(annulus, name)
        if not callable(thing) or thing in COMPILED:
            continue
        hints = typing.get_type_hints(thing)
        if inspect.isfunction(thing):
            assert set(inspect.signature(thing).parameters) | {"return"} == set(hints), name
        if not inspect.isclass(thing):
            continue
        for attribute, member in inspect.getmembers(thing):
            own = getattr(member, "fget", member)
            if inspect.isfunction(own) and own.__module__.startswith("annulus"):
                of = typing.get_type_hints(own)
                assert set(inspect.signature(own).parameters) - {"self", "cls"} | {"return"} == set(of), \
                    (name, attribute)
