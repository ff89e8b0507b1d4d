# SPDX-License-Identifier: GPL-3.0-or-later

"""
    AnnulusError

A call that was refused. After it the mesh is as it was before the call, unless `annulus/annulus.h` says otherwise.

- `code`: an `annulus_status`, such as `Annulus.C.DUPLICATE_POINT`;
- `message`: the reason in words, in which indices count from 0;
- `vertices`: the vertices, points or rows that the error concerns, counted from 1;
- `indices`: of [`insert!`](@ref) the vertices inserted before the point that was refused, of [`delete!`](@ref) the
  indices removed before an error; otherwise empty.
"""
struct AnnulusError <: Exception
    code::Int
    message::String
    vertices::Vector{Int32}
    indices::Vector{Int32}
end

function Base.showerror(io::IO, error::AnnulusError)
    print(io, "AnnulusError: ", unsafe_string(C.annulus_status_name(error.code)), ": ", error.message)
    isempty(error.vertices) || print(io, " (counted from 1: ", join(error.vertices, ", "), ")")
    return nothing
end

# Throws unless `status` is OK. mesh: that of the call, C_NULL without one.
function check(mesh, status, indices=Int32[])
    status == C.OK && return nothing
    length_of = C.annulus_message(mesh, C_NULL, 0)
    buffer = zeros(UInt8, length_of + 1)
    C.annulus_message(mesh, buffer, length(buffer))
    vertices = zeros(Int32, C.annulus_error_vertices(mesh, 0, C_NULL))
    C.annulus_error_vertices(mesh, length(vertices), vertices)
    vertices .+= Int32(1)
    throw(AnnulusError(status, String(buffer[1:length_of]), vertices, indices))
end

refuse(code, message) = throw(AnnulusError(code, message, Int32[], Int32[]))

# The array of doubles that C reads; the same array where it is one.
dense(x::Array{Float64}) = x
dense(x::AbstractArray{<:Real}) = Array{Float64}(x)

# Indices of C. One that is too large for it is no vertex either.
of_c(index::Integer) = Int32(clamp(index, -1, typemax(Int32)) - 1)
