# SPDX-License-Identifier: GPL-3.0-or-later
# What a MovingMesh has. Names and meaning are those of annulus.h.

function one_of(mesh, query, place)
    check(mesh, query(mesh, place))
    return place[]
end

"2 or 3."
dimension(mesh::MovingMesh) = Int(one_of(mesh, C.annulus_dimension, Ref{Cint}()))
"Less than `dimension` if all points are in a plane or on a line; -1 without points."
affine_dimension(mesh::MovingMesh) = Int(one_of(mesh, C.annulus_affine_dimension, Ref{Cint}()))
vertex_count(mesh::MovingMesh) = Int(one_of(mesh, C.annulus_vertex_count, Ref{Csize_t}()))
"The largest index, in use or free: the number of columns of arrays by vertex."
index_bound(mesh::MovingMesh) = Int(one_of(mesh, C.annulus_index_bound, Ref{Csize_t}()))
"The name of the strategy in use."
strategy(mesh::MovingMesh) = unsafe_string(one_of(mesh, C.annulus_strategy, Ref{Ptr{UInt8}}()))

"Whether `index` is a vertex: not free, and not out of range."
function is_vertex(mesh::MovingMesh, index::Integer)
    answer = Ref{Cint}()
    check(mesh, C.annulus_is_vertex(mesh, of_c(index), answer))
    return answer[] != 0
end

# ---- Arrays by vertex index --------------------------------------------------------------------------------------

function by_vertex(mesh, query, rows...)
    array = Array{Float64}(undef, rows..., index_bound(mesh))
    check(mesh, query(mesh, index_bound(mesh), array))
    return array
end

"The positions of all vertices."
points(mesh::MovingMesh) = by_vertex(mesh, C.annulus_points, dimension(mesh))
"The tolerance of each vertex."
tolerances(mesh::MovingMesh) = by_vertex(mesh, C.annulus_tolerances)
"The distance of each vertex from where it was when its tolerance was computed, rounded up."
displacements(mesh::MovingMesh) = by_vertex(mesh, C.annulus_displacements)

"Areas or volumes of the Voronoi cells, infinity on the hull."
voronoi_volumes(mesh::MovingMesh) =
    by_vertex(mesh, (mesh, bound, array) -> C.annulus_voronoi(mesh, bound, array, C_NULL))

"The number of neighbours of each vertex, 0 at free indices."
function neighbour_counts(mesh::MovingMesh)
    counts = zeros(Int32, index_bound(mesh))
    check(mesh, C.annulus_voronoi(mesh, length(counts), C_NULL, counts))
    return counts
end

"""
    voronoi_cells(mesh; lower=nothing, upper=nothing)

`(volumes, centroids)` of the Voronoi cells, which are intersected with the box from `lower` to `upper` if it is given.
"""
function voronoi_cells(mesh::MovingMesh; lower=nothing, upper=nothing)
    corners = map((lower, upper)) do corner
        corner === nothing ? C_NULL : positions(mesh, reshape(collect(corner), :, 1), 1)
    end
    volumes = Vector{Float64}(undef, index_bound(mesh))
    centroids = Matrix{Float64}(undef, dimension(mesh), index_bound(mesh))
    check(mesh, C.annulus_voronoi_cells(mesh, corners[1], corners[2], length(volumes), volumes, centroids))
    return (volumes=volumes, centroids=centroids)
end

"The gradient of `sum(weights .* volumes)` with respect to all coordinates, a column for each vertex."
function voronoi_gradient(mesh::MovingMesh, weights::AbstractVector{<:Real})
    length(weights) == index_bound(mesh) || refuse(C.WRONG_SIZE, "not one weight for each index")
    gradient = Matrix{Float64}(undef, dimension(mesh), index_bound(mesh))
    check(mesh, C.annulus_voronoi_gradient(mesh, length(weights), dense(weights), gradient))
    return gradient
end

# ---- Lists: requested for their length, and then for their contents; the library keeps them in between -----------

function count_of(mesh, query)
    count = Ref{Csize_t}(0)
    status = query(mesh, count)
    status == C.WRONG_SIZE || check(mesh, status)
    return Int(count[])
end

# A list of numbers of vertices or cells, `rows` each.
function numbers(mesh, query, rows...)
    count = count_of(mesh, (mesh, count) -> query(mesh, 0, C_NULL, count))
    list = Array{Int32}(undef, rows..., count)
    check(mesh, query(mesh, count, list, Ref{Csize_t}(0)))
    list .+= Int32(1)
    return list
end

"The vertex of every point that was given to `MovingMesh`."
vertex_of_input(mesh::MovingMesh) = numbers(mesh, C.annulus_vertex_of_input)
"The facets of the convex hull, a column each."
convex_hull(mesh::MovingMesh) = numbers(mesh, C.annulus_convex_hull, dimension(mesh))
"The cells that the last call created, a column each, 0 for the vertex at infinity; needs `report_changes=true`."
changed(mesh::MovingMesh) = numbers(mesh, C.annulus_changed, dimension(mesh) + 1)
"The cells that the last call removed, in the same form."
gone(mesh::MovingMesh) = numbers(mesh, C.annulus_gone, dimension(mesh) + 1)
"The pairs of vertices that the last call made neighbours, a column each, ascending; needs `report_changes=true`."
edges_made(mesh::MovingMesh) = numbers(mesh, C.annulus_edges_made, 2)
"The pairs of vertices that are neighbours no longer since the last call, in the same form."
edges_broken(mesh::MovingMesh) = numbers(mesh, C.annulus_edges_broken, 2)
"The T1 transitions of the last call in 2D, a column each: the first two vertices were neighbours, the others are now."
t1(mesh::MovingMesh) = numbers(mesh, C.annulus_t1, 4)
"The vertices that an edge joins to `vertex`, ascending."
neighbours(mesh::MovingMesh, vertex::Integer) =
    numbers(mesh, (mesh, capacity, list, count) -> C.annulus_neighbours(mesh, of_c(vertex), capacity, list, count))

"""
    cells(mesh)

`(vertices, neighbours)`, a column of `dimension + 1` numbers for each cell: `neighbours[i, c]` is the cell opposite to
`vertices[i, c]`, 0 outside the hull.
"""
function cells(mesh::MovingMesh)
    count = count_of(mesh, (mesh, count) -> C.annulus_cells(mesh, 0, C_NULL, C_NULL, count))
    vertices = Matrix{Int32}(undef, dimension(mesh) + 1, count)
    neighbours = similar(vertices)
    check(mesh, C.annulus_cells(mesh, count, vertices, neighbours, Ref{Csize_t}(0)))
    vertices .+= Int32(1)
    neighbours .+= Int32(1)
    return (vertices=vertices, neighbours=neighbours)
end

"""
    neighbour_lists(mesh)

`(starts, vertices)`: the neighbours of vertex v are `vertices[starts[v]:(starts[v + 1] - 1)]`.
"""
function neighbour_lists(mesh::MovingMesh)
    count = count_of(mesh, (mesh, count) -> C.annulus_neighbour_lists(mesh, 0, C_NULL, 0, C_NULL, count))
    starts = Vector{Int32}(undef, index_bound(mesh) + 1)
    vertices = Vector{Int32}(undef, count)
    check(mesh, C.annulus_neighbour_lists(mesh, length(starts), starts, count, vertices, Ref{Csize_t}(0)))
    starts .+= Int32(1)
    vertices .+= Int32(1)
    return (starts=starts, vertices=vertices)
end

"`(measures, centroids)` of the facets between Voronoi cells, in the order of the vertices of `neighbour_lists`."
function voronoi_facets(mesh::MovingMesh)
    count = count_of(mesh, (mesh, count) -> C.annulus_neighbour_lists(mesh, 0, C_NULL, 0, C_NULL, count))
    measures = Vector{Float64}(undef, count)
    centroids = Matrix{Float64}(undef, dimension(mesh), count)
    check(mesh, C.annulus_voronoi_facets(mesh, count, measures, centroids, Ref{Csize_t}(0)))
    return (measures=measures, centroids=centroids)
end

"For each column of `x` the number of a cell that contains it, 0 outside the hull."
function find_cells(mesh::MovingMesh, x::AbstractMatrix{<:Real})
    array = positions(mesh, x, size(x, 2))
    found = Vector{Int32}(undef, size(array, 2))
    check(mesh, C.annulus_find_cells(mesh, length(found), array, found))
    found .+= Int32(1)
    return found
end

"An exact check that relies on none of the rest: `audit(mesh).delaunay == 1`. See [`fault_text`](@ref)."
function audit(mesh::MovingMesh)
    result = Ref(C.zeroed(C.AuditResult))
    check(mesh, C.annulus_audit(mesh, result))
    return result[]
end
