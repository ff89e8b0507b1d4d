# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of annulus, and its one warning."""

from __future__ import annotations


class Error(ValueError):
    """What annulus throws on purpose. The object a failed call was made on is as it was before the call.

    Attributes
    ----------
    code : str
        The reason as a value; ``str(error)`` has it in words:

        ``not_finite``
            a coordinate is NaN or infinite
        ``out_of_domain``
            a coordinate is larger than 2**500 in magnitude; with `lloyd`, a point is outside of the domain
        ``duplicate_point``
            two vertices would share a position
        ``too_few``
            an operation needs more points than there are
        ``wrong_size``
            an array has not the shape that is needed
        ``unknown_vertex``
            an index that names no vertex
        ``environment``
            the floating-point unit is not in the state that the proofs assume: another module has set it to
            flush subnormal numbers, or to another rounding
        ``usage``
            options that do not fit together, or do not exist
        ``too_large``
            more vertices or cells than indices can name
        ``bad_input``
            a file, a surface or a domain that is none
    vertices : tuple of int
        Indices of the vertices concerned, as far as they are known. Of a ``duplicate_point`` both, the smaller one first:
        rows of the input where a triangulation is made, the one vertex that is there already where a point is
        inserted, and none where two points to be inserted are equal: the message has their rows. Else the vertex
        or point whose position or index is refused.

    Notes
    -----
    Values of the wrong type are a `TypeError`, memory that runs out is a `MemoryError`.
    """

    code: str
    vertices: tuple[int, ...]

    def __init__(self, message: str, code: str, vertices: tuple[int, ...] = ()) -> None:
        super().__init__(message)
        self.code = code
        self.vertices = tuple(vertices)

    def __reduce__(self) -> tuple[type[Error], tuple[str, str, tuple[int, ...]]]:
        return type(self), (str(self), self.code, self.vertices)


class OpenBoundariesWarning(UserWarning):
    """The object that points were taken from carries a periodic box, and there are no such boxes here: boundaries are
    open."""
