# SPDX-License-Identifier: GPL-3.0-or-later

"The version of the library, and the `ANNULUS_INTERFACE` that it was built with."
library_version() = unsafe_string(C.annulus_version())
library_interface() = Int(C.annulus_interface())

function signs(query, x, dimension, points)
    if size(x, 1) != dimension || size(x, 2) != points
        refuse(C.WRONG_SIZE, "an array of size $(size(x)) where ($dimension, $points, n) is expected")
    end
    list = Vector{C.Sign}(undef, size(x, 3))
    check(C_NULL, query(length(list), dense(x), list))
    return list
end

"""
    orient_2d(x), orient_3d(x), in_circle(x), in_sphere(x)

Exact signs of rows of points and certified tolerances, an `annulus_sign` for each `x[:, :, k]`: arrays of size
(2, 3, n), (3, 4, n), (2, 4, n), (3, 5, n).
"""
orient_2d(x::AbstractArray{<:Real,3}) = signs(C.annulus_orient_2d, x, 2, 3)
orient_3d(x::AbstractArray{<:Real,3}) = signs(C.annulus_orient_3d, x, 3, 4)
in_circle(x::AbstractArray{<:Real,3}) = signs(C.annulus_in_circle, x, 2, 4)
in_sphere(x::AbstractArray{<:Real,3}) = signs(C.annulus_in_sphere, x, 3, 5)

"""
    audit_cells(x, cells; most_faults=100)

An exact verdict on a triangulation made by any program: `(result, faults)`. Columns of `cells` are the corners of a
cell in any order, counted from 1, -1 as padding. In faults 0 is no cell, -1 is no point.
"""
function audit_cells(x::AbstractMatrix{<:Real}, cells::AbstractMatrix{<:Integer}; most_faults::Integer=100)
    size(cells, 1) == size(x, 1) + 1 ||
        refuse(C.WRONG_SIZE, "cells have as many corners as the dimension, and one more")
    result = Ref(C.zeroed(C.AuditResult))
    faults = Vector{C.Fault}(undef, most_faults)
    count = Ref{Csize_t}(0)
    check(C_NULL, C.annulus_audit_cells(size(x, 1), size(x, 2), dense(x), size(cells, 2), corners_of_c(cells), result,
                                        most_faults, faults, count))
    found = map(f -> C.Fault(f.cells .+ 1, f.vertices .+ Int32(1), f.kind), faults[1:count[]])
    return (result=result[], faults=found)
end

corners_of_c(cells) = Matrix{Int32}(map(corner -> clamp(corner, -1, typemax(Int32)) - 1, cells))

"The first fault that an audit found, in words, in which indices count from 0; empty if there is none."
fault_text(result::C.AuditResult) = String(collect(Iterators.takewhile(!=(0x00), result.first_fault)))
