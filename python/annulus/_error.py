# SPDX-License-Identifier: GPL-3.0-or-later
"""The exceptions and the warnings that annulus raises."""

from __future__ import annotations

import typing


class Error(ValueError):
    """The exception that annulus raises. After a failed call, the object is as it was before the call (see `BatchError`
    for several objects).

    Attributes
    ----------
    code : str
        The reason as one of these strings; ``str(error)`` is the reason in words:

        ``not_finite``
            a coordinate is NaN or infinite
        ``out_of_domain``
            a coordinate is larger than 2**500 in magnitude; with `lloyd`, a point is outside of the domain
        ``duplicate_point``
            two vertices would share a position
        ``too_few``
            an operation needs more points than there are
        ``wrong_size``
            an array does not have the required shape
        ``unknown_vertex``
            an index is not that of a vertex
        ``environment``
            the floating-point unit is not in the state that the proofs assume: another module has set it to
            flush subnormal numbers, or to another rounding mode
        ``usage``
            options do not exist, or exclude each other
        ``too_large``
            there are more vertices or cells than indices
        ``bad_input``
            a file, a surface or a domain is not valid
    vertices : tuple of int
        All vertices concerned, ascending. For ``duplicate_point`` the vertices that would share a position, two or
        more: rows of the input if a triangulation is constructed; the existing vertices if points are inserted at
        their positions; and none if points to be inserted are equal, where the message has their rows. For
        ``not_finite`` and ``out_of_domain`` every vertex, row or point that is refused; for ``unknown_vertex``
        every index that is. Other errors concern none.

    Notes
    -----
    A value of the wrong type raises `TypeError`; if memory runs out, `MemoryError` is raised.
    """

    code: str
    vertices: tuple[int, ...]

    def __init__(self, message: str, code: str, vertices: tuple[int, ...] = ()) -> None:
        super().__init__(message)
        self.code = code
        self.vertices = tuple(vertices)

    def __reduce__(self) -> tuple[type[Error], tuple[typing.Any, ...]]:
        return type(self), (str(self), self.code, self.vertices)


class BatchError(Error):
    """What `MovingDelaunayBatch` raises if some entries fail: each of these is as it was before the call, the others
    have done what was asked.

    Attributes
    ----------
    code : str
        That of the first entry that failed.
    vertices : tuple of int
        Those of the first entry that failed.
    errors : dict
        The `Error` of each entry that failed, by the number of the entry, ascending.
    """

    errors: dict[int, Error]

    def __init__(self, message: str, code: str, vertices: tuple[int, ...] = (),
                 errors: dict[int, Error] | None = None) -> None:
        super().__init__(message, code, vertices)
        self.errors = dict(errors or {})

    def __reduce__(self) -> tuple[type[BatchError], tuple[typing.Any, ...]]:
        return type(self), (str(self), self.code, self.vertices, self.errors)


def batch_error(errors: dict[int, Error]) -> BatchError:
    """Called by the compiled module with the errors of entries, ascending."""
    entry, first = next(iter(errors.items()))
    more = {1: "", 2: " (and one more entry failed)"}.get(len(errors), f" (and {len(errors) - 1} more entries failed)")
    return BatchError(f"entry {entry}: {first}{more}", first.code, first.vertices, errors)


class OpenBoundariesWarning(UserWarning):
    """The object that points were taken from has a periodic box, and no box was given: boundaries are open."""


class TableWarning(UserWarning):
    """A reader of a table has passed something over, or what it took may have another meaning. The message begins with
    the file and the line."""


class NotAvailableError(Error, NotImplementedError, AttributeError):
    """Something that is not available with a periodic box. Its code is ``usage``. It is an `AttributeError`, too, so
    that `hasattr` is False for what is missing."""

    def __init__(self, what: str, code: str = "usage", vertices: tuple[int, ...] = ()) -> None:
        super().__init__(what, code, vertices)
