# SPDX-License-Identifier: GPL-3.0-or-later

"""
    MovingMesh(x; strategy, tolerance, threads, merge_duplicates, report_changes, seed)

Triangulates the points that are the columns of `x`, a matrix of 2 or 3 rows. Vertex i is point i, unless duplicates are
merged ([`vertex_of_input`](@ref)). Options are those of `annulus_options`: names are strings, those that are true or
false are `Bool`. O(n log n). `close(mesh)` frees it before the garbage collector does.
"""
mutable struct MovingMesh
    handle::Ptr{Cvoid}

    function MovingMesh(x::AbstractMatrix{<:Real}; strategy::Union{AbstractString,Nothing}=nothing,
                        tolerance::Union{AbstractString,Nothing}=nothing, threads::Integer=1,
                        merge_duplicates::Bool=false, report_changes::Bool=false, seed::Integer=0)
        handle = Ref{Ptr{Cvoid}}(C_NULL)
        array = dense(x)
        names = map(name -> name === nothing ? UInt8[] : UInt8[codeunits(name); 0x00], (strategy, tolerance))
        GC.@preserve names begin
            places = map(name -> isempty(name) ? Ptr{UInt8}(C_NULL) : pointer(name), names)
            options = Ref(C.Options(sizeof(C.Options), places[1], places[2], C_NULL, threads, merge_duplicates,
                                    report_changes, 0, seed))
            status = C.annulus_create(handle, size(array, 1), size(array, 2), array, options)
        end
        check(C_NULL, status)
        return finalizer(close, new(handle[]))
    end
end

function Base.close(mesh::MovingMesh)
    handle = Ref(mesh.handle)
    C.annulus_destroy(handle)
    mesh.handle = handle[]
    return nothing
end

# A mesh as an argument of ccall is not collected during the call.
Base.unsafe_convert(::Type{Ptr{Cvoid}}, mesh::MovingMesh) = mesh.handle

function Base.show(io::IO, mesh::MovingMesh)
    if mesh.handle == C_NULL
        print(io, "MovingMesh, closed")
    else
        print(io, "MovingMesh of ", vertex_count(mesh), " vertices in ", dimension(mesh), "D")
    end
    return nothing
end

# The array that C reads, with a column for each of `columns` points in the dimension of the mesh.
function positions(mesh::MovingMesh, x, columns)
    if size(x, 1) != dimension(mesh) || size(x, 2) != columns
        refuse(C.WRONG_SIZE, "a matrix of size $(size(x)) where $((dimension(mesh), columns)) is expected")
    end
    return dense(x)
end

"""
    move!(mesh, x)
    move!(mesh, indices, x)

Moves every vertex, vertex i to column i of `x`, or vertex `indices[k]` to column k. Returns the report.
"""
function move!(mesh::MovingMesh, x::AbstractMatrix{<:Real})
    array = positions(mesh, x, index_bound(mesh))
    report = Ref(C.zeroed(C.Report))
    check(mesh, C.annulus_move_all(mesh, size(array, 2), array, report))
    return report[]
end

function move!(mesh::MovingMesh, indices::AbstractVector{<:Integer}, x::AbstractMatrix{<:Real})
    array = positions(mesh, x, length(indices))
    report = Ref(C.zeroed(C.Report))
    check(mesh, C.annulus_move(mesh, length(indices), of_c.(indices), array, report))
    return report[]
end

"""
    insert!(mesh, x)

Inserts the columns of `x` one after another. Returns `(indices, report)`: the indices freed last come first, then new
ones. After an error the points before the one refused stay inserted (`indices` of the [`AnnulusError`](@ref)).
"""
function Base.insert!(mesh::MovingMesh, x::AbstractMatrix{<:Real})
    array = positions(mesh, x, size(x, 2))
    indices = zeros(Int32, size(array, 2))
    inserted = Ref{Csize_t}(0)
    report = Ref(C.zeroed(C.Report))
    status = C.annulus_insert(mesh, size(array, 2), array, indices, inserted, report)
    indices .+= Int32(1)
    check(mesh, status, indices[1:inserted[]])
    return (indices=indices, report=report[])
end

"""
    delete!(mesh, indices)

Removes vertices; their indices become free. Returns the report.
"""
function Base.delete!(mesh::MovingMesh, indices::AbstractVector{<:Integer})
    removed = Ref{Csize_t}(0)
    report = Ref(C.zeroed(C.Report))
    status = C.annulus_remove(mesh, length(indices), of_c.(indices), removed, report)
    check(mesh, status, Vector{Int32}(indices[begin:(begin + Int(removed[]) - 1)]))
    return report[]
end

"Computes every tolerance again, measured from the current positions of the vertices. Returns the report."
function recompute_tolerances!(mesh::MovingMesh)
    report = Ref(C.zeroed(C.Report))
    check(mesh, C.annulus_recompute_tolerances(mesh, report))
    return report[]
end
