# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arguments. An error message is a sentence with the name of the argument, a short description of what
was given, and what is expected."""

from __future__ import annotations

import numbers
import operator
import os
import typing
import warnings

import numpy as np

from ._error import Error, OpenBoundariesWarning

STRATEGIES = ("auto", "tolerances", "tolerances-each", "in-place", "rebuild", "relocate", "relocate-flips", "paper",
              "paper-hybrid")
TOLERANCES = ("certified", "paper", "floating")
DENSITIES = ("one", "x2+y2", "x2", "sin2")
DOMAINS = ("disc", "square")


def described(value: object) -> str:
    """A short description of a value of any type."""
    kind = type(value).__name__
    kind = kind if len(kind) <= 40 else kind[:37] + "..."
    if isinstance(value, np.ndarray):
        dtype = str(value.dtype)
        return f"an array of {dtype if len(dtype) <= 40 else 'a structured type'}, of shape {value.shape}"
    if value is None or isinstance(value, bool):
        return repr(value)
    if isinstance(value, str):
        return f"{value[:40]!r}{'...' if len(value) > 40 else ''}"
    if isinstance(value, int) and value.bit_length() > 128:
        return f"an int of {value.bit_length()} bits"
    if isinstance(value, (int, float, complex, np.generic)) and len(str(value)) <= 60:
        return f"{value!s} ({kind})"
    if isinstance(value, (list, tuple, dict, set, bytes)):
        return f"a {kind} of length {len(value)}"
    return f"a value of type {kind}"


def one_of(choices: tuple[str, ...]) -> str:
    """What `choice` expects, in words."""
    return f"one of {', '.join(choices[:-1])} or {choices[-1]}" if len(choices) > 1 else choices[0]


def choice(name: str, value: object, choices: tuple[str, ...]) -> str:
    """One of a few strings."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, {one_of(choices)}; not {described(value)}")
    if value not in choices:
        raise Error(f"{name} must be {one_of(choices)}; not {described(value)}", "usage")
    return str(value)


def whole(name: str, value: object, least: int, most: int) -> int:
    """A whole number; bools and floats are refused."""
    if isinstance(value, (bool, np.bool_)) or not hasattr(type(value), "__index__"):
        raise TypeError(f"{name} must be a whole number, not {described(value)}")
    try:
        number = operator.index(typing.cast(typing.SupportsIndex, value))
    except TypeError:  # arrays of more than one number, or not of integers
        raise TypeError(f"{name} must be a whole number, not {described(value)}") from None
    if number < least or number > most:
        raise Error(f"{name} must be {least} or more, not {described(value)}" if number < least else
                    f"{name} must be at most {most}, not {described(value)}", "usage")
    return number


def number(name: str, value: object) -> float:
    """A real number as a float. NaN is accepted; the caller checks the range."""
    one = value[()] if isinstance(value, np.ndarray) and value.ndim == 0 else value
    if isinstance(one, bool) or not isinstance(one, numbers.Real):
        raise TypeError(f"{name} must be a real number, not {described(value)}")
    try:
        return float(one)
    except OverflowError:
        raise Error(f"{name} is too large: {described(value)}", "usage") from None


def length(name: str, value: object) -> float:
    """A finite number above 0."""
    finite = number(name, value)
    if not 0 < finite < float("inf"):
        raise Error(f"{name} must be finite and above 0, not {described(value)}", "bad_input")
    return finite


def truth(name: str, value: object) -> bool:
    """True or False; also 1 and 0."""
    if isinstance(value, (bool, np.bool_)) or isinstance(value, (int, np.integer)) and value in (0, 1):
        return bool(value)
    raise TypeError(f"{name} must be True or False, not {described(value)}")


def function(name: str, value: object) -> typing.Any:
    """A callable, or None."""
    if value is not None and not callable(value):
        raise TypeError(f"{name} must be a function or None, not {described(value)}")
    return value


def options(strategy: object, tolerance: object, merge_duplicates: object, threads: object, report_changes: object,
            seed: object) -> dict[str, typing.Any]:
    """The options of a triangulation, as they are pickled."""
    return {"strategy": choice("strategy", strategy, STRATEGIES),
            "tolerance": choice("tolerance", tolerance, TOLERANCES),
            "merge_duplicates": truth("merge_duplicates", merge_duplicates),
            "threads": whole("threads", threads, 1, 2**31 - 1),
            "report_changes": truth("report_changes", report_changes), "seed": seed_of(seed)}


def seed_of(seed: object) -> int:
    return whole("seed", seed, 0, 2**64 - 1)


def iterations_of(iterations: object) -> int:
    return whole("iterations", iterations, 0, 2**63 - 1)


def file_of(name: str, path: str | os.PathLike[str]) -> bytes:
    """The name of a file, encoded for the operating system."""
    file = os.fsencode(path)
    if b"\0" in file:
        raise Error(f"{name} must be the name of a file, and such have no null characters", "usage")
    return file


def array_of(value: object, name: str) -> np.ndarray[typing.Any, typing.Any]:
    """A value as an array; the compiled module calls this, too, and decides there which numbers are allowed."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} must not be a masked array: say what shall stand where values are masked")
    if isinstance(value, np.ndarray):
        return np.asarray(value)
    has_array = hasattr(value, "__array__")
    positions = value if has_array or isinstance(value, (list, tuple)) else _positions(value)
    if not isinstance(value, (list, tuple)) and has_box(value):
        warnings.warn(f"{name}: the periodic box of this {described(value).rpartition(' ')[2]} is ignored; boundaries "
                      "are open, and what "
                      "is computed near them is not what it is in the box", OpenBoundariesWarning, stacklevel=3)
    try:
        array = np.asarray(positions)
    except (TypeError, ValueError, OverflowError) as e:
        if has_array:
            raise  # the message of the object is clearer
        words = str(e).partition(".")[0]
        raise TypeError(f"{name} must be an array of numbers; {described(value)} is none: {words[:120]}") from None
    if array.dtype.kind not in "biuf":
        hint = "" if name != "indices" or array.dtype.kind != "O" else " of 64 bits at most"
        raise TypeError(f"{name} must be an array of numbers{hint}, not {described(value)}")
    if array.ndim == 0 and name != "indices" and not has_array:
        raise TypeError(f"{name} must be an array, not {described(value)}")
    if name == "indices" and isinstance(value, tuple) and array.ndim == 2 and len(value) == 1:
        raise Error(f"indices must have shape (k,), not {array.shape}: of a tuple such as numpy.where gives take the "
                    "element [0]", "wrong_size")
    return array


# ---- Objects of other packages -------------------------------------------------------------------------------------

# The attributes with positions: ASE, MDAnalysis (an AtomGroup, a Timestep; a Universe), OVITO, GSD, pymatgen.
_PLACES = ("positions", "atoms.positions", "particles.positions", "particles.position", "cart_coords")
_BOXES = ("dimensions", "box", "cell", "lattice", "configuration.box")


def _attribute(value: object, path: str) -> typing.Any:
    """The attribute at the end of a dotted path; None if there is none."""
    for name in path.split("."):
        try:
            value = getattr(value, name, None)
        except Exception:  # a property that fails
            return None
    return value


def _positions(value: object) -> object:
    for place in _PLACES:
        positions = _attribute(value, place)
        if positions is not None and not callable(positions):
            return positions
    return value


def periodic_directions(value: object) -> list[bool] | None:
    """The flags of an object, or of its box, that say in which directions it is periodic; None if it has none."""
    for path in ("", *_BOXES):
        box = _attribute(value, path) if path else value
        for flags in ("pbc", "periodic"):
            periodic = _attribute(box, flags)
            if periodic is not None and not callable(periodic):
                return [bool(flag) for flag in np.atleast_1d(np.asarray(periodic)).ravel()]
    return None


def has_box(value: object) -> bool:
    """Whether an object has a periodic box, judged by the attributes that other packages use for one."""
    for path in ("", *_BOXES):
        box = _attribute(value, path) if path else value
        if box is None or isinstance(box, str) or callable(box) and path:
            continue
        for flags in ("pbc", "periodic"):
            periodic = _attribute(box, flags)
            if periodic is not None and not callable(periodic):
                return bool(np.any(np.asarray(periodic)))
        if not path:
            continue
        try:
            lengths = np.asarray(box, dtype=float)
        except Exception:
            continue
        if lengths.size in (2, 3, 4, 6, 9) and np.any(lengths):
            return True
    return False
